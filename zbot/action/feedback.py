"""Subscription of an action client to feedback."""

from __future__ import annotations

import contextlib
from collections import deque
from typing import TYPE_CHECKING, Any, cast

import zenoh

from zbot.log import get_logger
from zbot.node.endpoint import TopicEndpoint
from zbot.threads.foreign_call import called_by_zenoh
from zbot.wire.errors import CodecError
from zbot.wire.tokens import EntityKind

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.executor.callback_group import CallbackGroup
    from zbot.node.node import Node
    from zbot.qos import QoSProfile


class FeedbackSubscription(TopicEndpoint):
    """Queues the feedback of all goals of a client.

    In contrast to other subscriptions, Zenoh's own thread queues the messages. Zenoh delivers
    results in the same thread, so the feedback of a goal is queued before the goal's result comes.

    Args:
        node: The node that subscribes.
        msg_type: The action's feedback message.
        topic: The topic's full name.
        callback: Takes each message. It may be a coroutine function.
        qos_profile: Its depth is the number of messages that the queue holds for each open goal.
        callback_group: Decides which callbacks may run at the same time.
        goal_count: Returns the number of open goals.
    """

    due_ns: int | None = None

    def __init__(
        self,
        node: Node,
        msg_type: type[Any],
        topic: str,
        callback: Callable[[Any], Any],
        *,
        qos_profile: QoSProfile,
        callback_group: CallbackGroup,
        goal_count: Callable[[], int],
    ) -> None:
        handle, context = node.handle, node.context
        self.msg_type = msg_type
        self.callback = callback
        self.callback_group = callback_group
        self.ready_queue = handle.ready_queue
        self._context = context
        self._goal_count = goal_count
        self._logger_name = handle.logger_name
        self._queue: deque[zenoh.Sample] = deque()
        self._running: deque[None] = deque()  # one item for each callback that runs
        self._is_destroyed = False
        name = node.resolve_topic_name(topic)
        self._token = handle.endpoint(EntityKind.SUBSCRIPTION, name, msg_type, qos_profile)
        self._decode = context.dialect.codec_for(msg_type).decode
        receive: Any = zenoh.handlers.Callback(self._receive, indirect=False)
        key = context.dialect.data_key(self.token)
        with context.until_shutdown(f"the node {handle.full_name}"):
            self._subscriber: Any = context.session.declare_subscriber(key, receive)
            self._announcement = context.graph.announce(self.token)
        handle.subscriptions.append(cast("Any", self))  # it has all attributes that a node uses
        handle.diagnostics.add(self.token, handle.logger_name)
        handle.add(self)

    @property
    def is_destroyed(self) -> bool:
        """Whether the subscription was destroyed."""
        return self._is_destroyed

    @called_by_zenoh
    def _receive(self, sample: zenoh.Sample) -> None:
        if len(self._queue) >= max(1, self.token.qos.depth) * max(1, self._goal_count()):
            with contextlib.suppress(IndexError):  # the executor may have just taken the sample
                self._queue.popleft()
        self._queue.append(sample)
        self.ready_queue.post(self)

    @property
    def is_empty(self) -> bool:
        """Whether the callback has run for all messages."""
        return not (self._queue or self._running)

    def take(self) -> zenoh.Sample | None:
        """Return the oldest sample, if any."""
        self._running.append(None)
        try:
            return self._queue.popleft()
        except IndexError:
            self._running.pop()
            return None

    def execute(self, sample: zenoh.Sample) -> Any:
        """Decode a sample and call the callback."""
        try:
            return self._call_callback(sample)
        finally:
            self._running.pop()

    def _call_callback(self, sample: zenoh.Sample) -> Any:
        try:
            message = self._decode(sample.payload.to_bytes())
        except CodecError as error:
            get_logger(self._logger_name).error(
                f"{self.topic_name}: cannot read feedback: {error}",
                throttle_duration_sec=10,
            )
            return None
        return None if self._is_destroyed else self.callback(message)

    def destroy(self) -> None:
        """Unsubscribe. A second call does nothing."""
        if self._is_destroyed:
            return
        self._is_destroyed = True
        self._queue.clear()
        self._context.undeclare(self._announcement, self._subscriber)
