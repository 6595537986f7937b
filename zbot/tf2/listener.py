"""Listeners, which fill a buffer from `/tf` and `/tf_static`."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from zbot.executor.callback_group import ReentrantCallbackGroup
from zbot.executor.clock import ClockChange, JumpThreshold, TimeJump
from zbot.executor.spin_thread import SpinThread
from zbot.node.argument_check import check_object, check_order, is_node
from zbot.node.node import Node
from zbot.qos import DurabilityPolicy, QoSProfile
from zbot.tf2.broadcaster import TF_STATIC_TOPIC, TF_TOPIC
from zbot.time import Duration

from tf2_msgs.msg import TFMessage

if TYPE_CHECKING:
    from zbot.tf2.buffer import Buffer

_DEPTH = 100


def _is_buffer(value: object) -> bool:
    return hasattr(value, "set_transform") and not isinstance(value, type)


class TransformListener:
    """Subscriber that adds transforms to a buffer.

    Args:
        buffer: The buffer.
        node: The node that subscribes. The default is a new node that a thread spins.
        spin_thread: Whether the listener starts a thread that spins the node.
        qos: Quality of service for `/tf`. The default is depth 100.
        static_qos: Quality of service for `/tf_static`. The default is transient local.
        tf_topic: The topic to use in place of `/tf`.
        tf_static_topic: The topic to use in place of `/tf_static`.
        static_only: Whether to subscribe only to static transforms.
    """

    def __init__(
        self,
        buffer: Buffer,
        node: Node | None = None,
        *,
        spin_thread: bool = False,
        qos: QoSProfile | int | None = None,
        static_qos: QoSProfile | int | None = None,
        tf_topic: str = TF_TOPIC,
        tf_static_topic: str = TF_STATIC_TOPIC,
        static_only: bool = False,
    ) -> None:
        if node is not None:
            check_order("TransformListener", (buffer, _is_buffer), (node, is_node))
            check_object("node", node, "a node", "create_subscription")
        check_object("buffer", buffer, "a buffer", "set_transform")
        self.buffer = buffer
        self._own_node = Node("transform_listener") if node is None else None
        feeder: Any = node or self._own_node
        self.node: Any = feeder
        self.group = ReentrantCallbackGroup()
        self._subscriptions: list[Any] = []
        kept = QoSProfile(depth=_DEPTH, durability=DurabilityPolicy.TRANSIENT_LOCAL)
        if not static_only:
            changing = QoSProfile(depth=_DEPTH) if qos is None else qos
            self.tf_sub = self._subscribe(tf_topic, self.callback, changing)
        self.tf_static_sub = self._subscribe(
            tf_static_topic, self.static_callback, kept if static_qos is None else static_qos
        )
        self.buffer.is_fed = feeder.context.ok
        threshold = JumpThreshold(min_forward=None, min_backward=Duration(nanoseconds=-1))
        self._jumps = feeder.get_clock().create_jump_callback(
            threshold, post_callback=self._on_jump
        )
        self._spinner = SpinThread(feeder, "zbot transforms") if spin_thread or not node else None
        self.executor = None if self._spinner is None else self._spinner.executor
        if self._spinner is not None:
            self.dedicated_listener_thread = self._spinner.thread

    def _subscribe(self, topic: str, callback: Any, qos: QoSProfile | int) -> Any:
        subscription = self.node.create_subscription(
            TFMessage, topic, callback, qos, callback_group=self.group
        )
        self.buffer.subscriptions.append(subscription)
        self._subscriptions.append(subscription)
        return subscription

    def _on_jump(self, jump: TimeJump) -> None:
        is_back = jump.clock_change is ClockChange.ROS_TIME_NO_CHANGE
        what = "jump back in time" if is_back else "time source change"
        self.node.get_logger().warning(f"Detected {what}. Clearing TF buffer.")
        self.buffer.clear()

    def callback(self, data: Any) -> None:
        """Add the transforms of a message."""
        with self.buffer.one_message():
            for transform in data.transforms:
                self.buffer.set_transform(transform, "default_authority")

    def static_callback(self, data: Any) -> None:
        """Add the static transforms of a message."""
        with self.buffer.one_message():
            for transform in data.transforms:
                self.buffer.set_transform_static(transform, "default_authority")

    def unregister(self) -> None:
        """End the listener's subscriptions, thread and own node. A second call is allowed."""
        for subscription in self._subscriptions:
            if subscription in self.buffer.subscriptions:
                self.buffer.subscriptions.remove(subscription)
            self.node.destroy_subscription(subscription)
        self._jumps.unregister()
        if self._spinner is not None:
            self._spinner.stop(0)
        if self._own_node is not None:
            self._own_node.destroy_node()


class StaticTransformListener(TransformListener):
    """Subscriber that adds only static transforms to a buffer.

    Args:
        buffer: The buffer.
        node: The node that subscribes.
        spin_thread: Whether the listener starts a thread that spins the node.
        static_qos: Quality of service. The default is transient local.
        tf_static_topic: The topic to use in place of `/tf_static`.
    """

    def __init__(
        self,
        buffer: Buffer,
        node: Node,
        *,
        spin_thread: bool = False,
        static_qos: QoSProfile | int | None = None,
        tf_static_topic: str = TF_STATIC_TOPIC,
    ) -> None:
        super().__init__(
            buffer,
            node,
            spin_thread=spin_thread,
            static_qos=static_qos,
            tf_static_topic=tf_static_topic,
            static_only=True,
        )
