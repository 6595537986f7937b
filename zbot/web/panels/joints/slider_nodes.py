"""Nodes whose parameters are the sliders of a robot's joints, in the graph."""

from __future__ import annotations

from typing import TYPE_CHECKING

from zbot.libraries.robot_description.joint_sliders import CENTER, EMPTY_TYPE, RANDOMIZE
from zbot.names import is_hidden
from zbot.wire.tokens import EntityKind

if TYPE_CHECKING:
    from zbot.graph.snapshot import Snapshot

_STATE_TYPE = "sensor_msgs/msg/JointState"


def slider_nodes(graph: Snapshot) -> list[str]:
    """Return the full names of the nodes with sliders, sorted. Each robot has one."""
    servers = graph.of_kind(EntityKind.SERVICE)
    found = {end.name for end in servers if end.type_name == EMPTY_TYPE}
    centers = (name for name in found if name.endswith(f"/{CENTER}") and not is_hidden(name))
    nodes = (name.removesuffix(f"/{CENTER}") for name in centers)
    return sorted(node for node in nodes if node and f"{node}/{RANDOMIZE}" in found)


def states_topic(graph: Snapshot, node: str) -> str | None:
    """Return the topic on which a node publishes the positions of all joints."""
    topics = graph.names_and_types(EntityKind.PUBLISHER, node=node)
    return next((name for name, types in topics if _STATE_TYPE in types), None)
