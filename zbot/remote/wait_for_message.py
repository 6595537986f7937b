"""Function that waits for a single message of a topic."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Literal, TypeVar

from zbot.executor.callback_group import ReentrantCallbackGroup
from zbot.executor.ready_queue import ReadyQueue
from zbot.node.argument_check import check_order, is_class, is_name, is_node
from zbot.node.subscription import Subscription
from zbot.process import signals
from zbot.qos import as_profile
from zbot.threads.deadline import Deadline
from zbot.threads.wakeup import BinarySemaphore
from zbot.wire.tokens import EntityKind

if TYPE_CHECKING:
    from zbot.node.node import Node
    from zbot.qos import QoSProfile

MsgT = TypeVar("MsgT")


def wait_for_message(
    msg_type: type[MsgT],
    node: Node,
    topic: str,
    *,
    qos_profile: QoSProfile | int = 1,
    time_to_wait: float = -1,
) -> tuple[Literal[True], MsgT] | tuple[Literal[False], None]:
    """Wait for the next message of a topic, without running other callbacks of the node.

    Args:
        msg_type: Message class.
        node: The node that subscribes during the wait. The node may also be in an executor.
        topic: Relative, `~/private` or absolute name.
        qos_profile: A profile, or a depth for the default profile.
        time_to_wait: Seconds to wait. With a negative number, only the context's shutdown limits
            the wait.

    Returns:
        True and the message, or False and `None` if no message came in time.

    Raises:
        InvalidTopicNameError: The name breaks ROS 2's grammar.
        ExternalShutdownException: The main thread waits again after SIGTERM, without a call of
            `ok()`.
    """
    check_order("wait_for_message", (msg_type, is_class), (node, is_node), (topic, is_name))
    if not node.context.is_running:
        signals.note_vain_wait()
    arrived: list[MsgT] = []
    signal, ready_queue = BinarySemaphore(), ReadyQueue()
    ready_queue.attach(None, lambda _: signal.set())
    handle, context = node.handle, node.context
    name = node.resolve_topic_name(topic)
    token = handle.endpoint(EntityKind.SUBSCRIPTION, name, msg_type, as_profile(qos_profile))
    subscription: Subscription[Any] = Subscription(
        context,
        msg_type,
        arrived.append,
        token,
        ready_queue=ready_queue,
        callback_group=ReentrantCallbackGroup(),
        raw=False,
        logger_name=handle.logger_name,
    )
    deadline = Deadline(None if time_to_wait < 0 else time_to_wait)
    with subscription:
        subscription.start()
        while not arrived and context.is_running:
            sample = subscription.take()
            if sample is not None:
                subscription.execute(sample)
                continue
            if deadline.is_over:
                break
            signal.wait(deadline.left_s)
    return (True, arrived[0]) if arrived else (False, None)
