"""Broadcasters, which publish transforms on `/tf` and `/tf_static`."""

from __future__ import annotations

import copy
from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

from zbot.node.argument_check import check_object
from zbot.qos import DurabilityPolicy, QoSProfile
from zbot.tf2.transform_check import transform_problem

from tf2_msgs.msg import TFMessage

if TYPE_CHECKING:
    from zbot.node.node import Node

    from geometry_msgs.msg import TransformStamped

TF_TOPIC, TF_STATIC_TOPIC = "/tf", "/tf_static"
_DEPTH = 100


def _listed(transform: TransformStamped | Iterable[TransformStamped]) -> list[TransformStamped]:
    return list(transform) if isinstance(transform, Iterable) else [transform]


class _Broadcaster:
    """Publisher of transforms. It warns once of each transform that listeners ignore."""

    def __init__(self, node: Node, topic: str, qos: QoSProfile | int) -> None:
        check_object("node", node, "a node", "create_publisher")
        self.pub_tf: Any = node.create_publisher(TFMessage, topic, qos)
        self._logger = node.get_logger()
        self._told: set[str] = set()

    def _warn(self, sent: list[TransformStamped]) -> None:
        for problem in map(transform_problem, sent):
            if problem and problem not in self._told:
                self._told.add(problem)
                self._logger.warning(f"listeners ignore a transform of this node: {problem}")


class TransformBroadcaster(_Broadcaster):
    """Publisher of changing transforms on `/tf`.

    Args:
        node: The node that publishes.
        qos: Quality of service. The default is depth 100.
    """

    def __init__(self, node: Node, qos: QoSProfile | int | None = None) -> None:
        super().__init__(node, TF_TOPIC, QoSProfile(depth=_DEPTH) if qos is None else qos)

    def sendTransform(  # noqa: N802 - tf2_ros' name
        self, transform: TransformStamped | Iterable[TransformStamped]
    ) -> None:
        """Publish one transform or several. A warning tells of one that listeners ignore."""
        message = TFMessage(transforms=_listed(transform))
        self.pub_tf.publish(message)
        self._warn(message.transforms)


class StaticTransformBroadcaster(_Broadcaster):
    """Publisher of static transforms on `/tf_static`. Late subscribers receive the transforms too.

    Args:
        node: The node that publishes.
        qos: Quality of service. The default is transient local with depth 1.
    """

    def __init__(self, node: Node, qos: QoSProfile | int | None = None) -> None:
        kept = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
        super().__init__(node, TF_STATIC_TOPIC, kept if qos is None else qos)
        self.net_message = TFMessage()

    def sendTransform(  # noqa: N802 - tf2_ros' name
        self, transform: TransformStamped | Iterable[TransformStamped]
    ) -> None:
        """Publish transforms together with the latest transform of every other child frame.

        A warning tells of a transform that listeners ignore.
        """
        latest = TFMessage(transforms=_listed(transform)).transforms
        sent = {known.child_frame_id: known for known in self.net_message.transforms}
        # Keep copies, because programs may change and send the same message object again.
        sent.update((each.child_frame_id, copy.deepcopy(each)) for each in latest)
        self.net_message.transforms = list(sent.values())
        self.pub_tf.publish(self.net_message)
        self._warn(latest)
