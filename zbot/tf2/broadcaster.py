"""Broadcasters, which publish transforms on `/tf` and `/tf_static`."""

from __future__ import annotations

import copy
from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

from zbot.node.argument_check import check_object
from zbot.qos import DurabilityPolicy, QoSProfile

from tf2_msgs.msg import TFMessage

if TYPE_CHECKING:
    from zbot.node.node import Node

    from geometry_msgs.msg import TransformStamped

TF_TOPIC, TF_STATIC_TOPIC = "/tf", "/tf_static"
_DEPTH = 100


def _listed(transform: TransformStamped | Iterable[TransformStamped]) -> list[TransformStamped]:
    return list(transform) if isinstance(transform, Iterable) else [transform]


class TransformBroadcaster:
    """Publisher of changing transforms on `/tf`.

    Args:
        node: The node that publishes.
        qos: Quality of service. The default is depth 100.
    """

    def __init__(self, node: Node, qos: QoSProfile | int | None = None) -> None:
        check_object("node", node, "a node", "create_publisher")
        profile = QoSProfile(depth=_DEPTH) if qos is None else qos
        self.pub_tf: Any = node.create_publisher(TFMessage, TF_TOPIC, profile)

    def sendTransform(  # noqa: N802 - tf2_ros' name
        self, transform: TransformStamped | Iterable[TransformStamped]
    ) -> None:
        """Publish one transform or several."""
        self.pub_tf.publish(TFMessage(transforms=_listed(transform)))


class StaticTransformBroadcaster:
    """Publisher of static transforms on `/tf_static`. Late subscribers receive the transforms too.

    Args:
        node: The node that publishes.
        qos: Quality of service. The default is transient local with depth 1.
    """

    def __init__(self, node: Node, qos: QoSProfile | int | None = None) -> None:
        check_object("node", node, "a node", "create_publisher")
        kept = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
        profile = kept if qos is None else qos
        self.pub_tf: Any = node.create_publisher(TFMessage, TF_STATIC_TOPIC, profile)
        self.net_message = TFMessage()

    def sendTransform(  # noqa: N802 - tf2_ros' name
        self, transform: TransformStamped | Iterable[TransformStamped]
    ) -> None:
        """Publish transforms together with the latest transform of every other child frame."""
        sent = {known.child_frame_id: known for known in self.net_message.transforms}
        # Keep copies, because programs may change and send the same message object again.
        sent.update((latest.child_frame_id, copy.deepcopy(latest)) for latest in _listed(transform))
        self.net_message.transforms = list(sent.values())
        self.pub_tf.publish(self.net_message)
