"""Topic that drives a robot, and the search for such topics in the graph."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

from zbot.names import is_hidden
from zbot.wire.tokens import EntityKind

if TYPE_CHECKING:
    from zbot.graph.snapshot import Snapshot

TWIST = "geometry_msgs/msg/Twist"
TWIST_STAMPED = "geometry_msgs/msg/TwistStamped"
JOY = "sensor_msgs/msg/Joy"
#: The types that the panel can publish. A robot's own velocity comes before a gamepad's axes.
TYPES = (TWIST, TWIST_STAMPED, JOY)
_USUAL_NAME = "cmd_vel"


class DriveTarget(NamedTuple):
    """Topic and type of the messages that drive a robot."""

    topic: str
    type_name: str  #: one of `TYPES`

    @property
    def label(self) -> str:
        """The topic with the short name of its type, e.g. `/cmd_vel (Twist)`."""
        return f"{self.topic} ({self.type_name.rpartition('/')[2]})"

    @property
    def is_gamepad(self) -> bool:
        """Whether the topic takes the axes and buttons of a gamepad."""
        return self.type_name == JOY


def drive_targets(graph: Snapshot) -> list[DriveTarget]:
    """Return the topics to which a node subscribes with one of `TYPES`, `/cmd_vel` first.

    Hidden topics, and the subscriptions of hidden nodes such as `zbot topic echo`, are left out.
    """
    found = {
        DriveTarget(end.name, end.type_name)
        for end in graph.of_kind(EntityKind.SUBSCRIPTION)
        if end.type_name in TYPES and not is_hidden(end.name) and not is_hidden(end.node)
    }
    return sorted(found, key=_order)


def _order(target: DriveTarget) -> tuple[object, ...]:
    name = target.topic.rpartition("/")[2]
    is_usual = target.topic == f"/{_USUAL_NAME}"
    return target.is_gamepad, not is_usual, name != _USUAL_NAME, target
