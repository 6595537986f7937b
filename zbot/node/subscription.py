"""Subscriptions, whose samples wait in a queue until the executor's thread decodes them.

With keep-last, Zenoh's queue is a ring channel, which drops the oldest samples without Python.
"""

from __future__ import annotations

import time
from enum import Enum
from functools import partial
from typing import TYPE_CHECKING, Any, Generic, Literal, TypeVar

import zenoh

from zbot.executor.forgotten_spin import Program
from zbot.interfaces import has_sequences
from zbot.memory import LARGE_BYTES, keep_freed_memory
from zbot.node.endpoint import TopicEndpoint
from zbot.node.message_decoder import MessageDecoder
from zbot.node.message_info import MessageInfo, PublisherGid, takes_info
from zbot.node.message_sources import LostMessages, MessageSources
from zbot.node.refusals import Refusals
from zbot.node.sample_queue import LatchedChannel, SampleQueue
from zbot.node.zenoh_declaration import subscriber_declaration
from zbot.process import blocked_put, fork
from zbot.qos import DurabilityPolicy, HistoryPolicy
from zbot.threads.handle import Handle
from zbot.wire.attachment import LAYOUT
from zbot.wire.errors import CodecError

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.context import Context
    from zbot.executor.callback_group import CallbackGroup
    from zbot.executor.ready_queue import ReadyQueue
    from zbot.node.message_decoder import ContentFilterOptions
    from zbot.wire.tokens import EndpointToken

MsgT = TypeVar("MsgT")

# Length of a keep-all queue. A full queue blocks its publishers (Zenoh's BLOCK). Such waits add a
# tenth to a small message's latency. So the queue is long. For types with sequences, the queue is
# short, because a single message of such a type can take megabytes of memory.
_KEEP_ALL_QUEUE = 8192
_KEEP_ALL_QUEUE_OF_SEQUENCES = 256
# A batch of a keep-last queue should empty Zenoh's queue, but it must end.
_LEAST_BATCH = 8192

_unpack, _FACTS_LENGTH = LAYOUT.unpack, LAYOUT.size


def _keep_all_size(msg_type: type[Any]) -> int:
    return _KEEP_ALL_QUEUE_OF_SEQUENCES if has_sequences(msg_type) else _KEEP_ALL_QUEUE


class Subscription(TopicEndpoint, Generic[MsgT]):
    """Calls a function for every message of a topic.

    `Node.create_subscription` creates subscriptions.

    Args:
        context: The context whose session receives the messages.
        msg_type: Message class.
        callback: Takes the message, or the message and its `MessageInfo`. The callback may be a
            coroutine function.
        token: The subscription's liveliness token: its node, topic, type and profile.
        ready_queue: The queue that the node's executor takes ready entities from.
        callback_group: Decides which other callbacks may run at the same time.
        raw: Whether the callback takes each message as bytes in ROS 2's CDR. With `"payload"`, the
            callback takes the bytes that were sent.
        logger_name: Name of the node's logger.
        content_filter: Selects the messages for the callback. `None` selects all messages.
        is_announced: Whether the graph shows the subscription.

    Raises:
        ContentFilterError: The filter does not fit the message type.
    """

    class CallbackType(Enum):
        """Arguments that the callback takes, as in rclpy."""

        MessageOnly = 0
        WithMessageInfo = 1

    def __init__(
        self,
        context: Context,
        msg_type: type[MsgT],
        callback: Callable[..., Any],
        token: EndpointToken,
        *,
        ready_queue: ReadyQueue,
        callback_group: CallbackGroup,
        raw: bool | Literal["payload"],
        logger_name: str,
        content_filter: ContentFilterOptions | None = None,
        is_announced: bool = True,
    ) -> None:
        self.msg_type = msg_type
        self.callback_group = callback_group
        self.callback = callback
        self.raw = raw
        self.event_handlers: list[Any] = []
        self.received_count = 0  #: messages that the callback got or `take_message` took
        self.ready_queue = ready_queue
        self._context = context
        self._token = token
        self._logger_name = logger_name
        dialect = context.dialect
        self._refusals = Refusals(dialect, token, logger_name)
        self._losses = LostMessages(token, logger_name)
        self._sources = MessageSources(token, context.graph.find, self._refusals, self._losses)
        self._source_of = self._sources.by_gid.get
        self._decoder = MessageDecoder(
            *(dialect, msg_type, token.name),
            raw=raw,
            refusals=self._refusals,
            logger_name=logger_name,
        )
        if content_filter is not None:
            self.set_content_filter(*content_filter)
        self._is_destroyed = False
        self._declare()
        self._announcement = context.graph.announce(token, is_visible=is_announced)

    def _declare(self) -> None:
        qos = self._token.qos
        keeps_all = qos.history is HistoryPolicy.KEEP_ALL
        size = _keep_all_size(self.msg_type) if keeps_all else max(qos.depth, 1)
        declare = subscriber_declaration(self._context, self._token, size)
        self._latched: LatchedChannel | None = None
        handler: Any
        if qos.durability is DurabilityPolicy.TRANSIENT_LOCAL:
            self._latched = LatchedChannel(size, blocks=keeps_all)
            # A pair, because Zenoh never undeclares the inner subscribers of a mere callback.
            handler = (
                self._context.receiver(self._latched.receive, may_wait=True),
                self._latched,
            )
        elif keeps_all:
            handler = zenoh.handlers.FifoChannel(size)
        else:
            handler = zenoh.handlers.RingChannel(size)
        self._subscriber: Any = declare(handler)
        self._samples = SampleQueue(
            self._subscriber.handler,
            depth=None if keeps_all else size,
            batch=max(size, _LEAST_BATCH),
            post=partial(self.ready_queue.post, self),
            declare=None if self._latched else declare,
        )
        #: Removes and returns the oldest sample that the profile's history keeps, if any.
        self.take: Callable[[], zenoh.Sample | None] = self._samples.take
        if keeps_all:
            blocked_put.local_queues.add(self._samples)

    def start(self) -> None:
        """Start to receive. The ready queue tells the executor about messages."""
        if self._latched is not None:
            self._latched.post = partial(self.ready_queue.post, self)
        self._samples.start()

    @property
    def due_ns(self) -> int | None:
        """When to look for a message without a post (monotonic clock, nanoseconds)."""
        return self._samples.due_ns

    @property
    def callback(self) -> Callable[..., Any]:
        """The function that is called with each message."""
        return self._callback

    @callback.setter
    def callback(self, callback: Callable[..., Any]) -> None:
        self._with_info = takes_info(callback)
        self._callback = callback

    @property
    def is_destroyed(self) -> bool:
        """Whether the subscription was destroyed."""
        return self._is_destroyed

    @property
    def _callback_type(self) -> CallbackType:
        return (
            self.CallbackType.WithMessageInfo if self._with_info else self.CallbackType.MessageOnly
        )

    @property
    def handle(self) -> SubscriptionHandle:
        """A handle for a `WaitSet`. A program can also take messages from the handle."""
        return SubscriptionHandle(self)

    def get_publisher_count(self) -> int:
        """Return how many publishers of the same type the topic has in the whole domain."""
        publishers = self._context.graph.snapshot().publishers(self.topic_name)
        return sum(token.type_name == self._token.type_name for token in publishers)

    @property
    def is_cft_enabled(self) -> bool:
        """Whether there is a content filter."""
        return self._decoder.filter is not None

    def set_content_filter(self, filter_expression: str, expression_parameters: list[str]) -> None:
        """From the next message on, accept only messages for which an expression is true.

        The subscription filters the messages after it has received them. So a filter saves callback
        calls, but no network traffic.

        Args:
            filter_expression: As in `zbot.interfaces.content_filter`, or empty for no filter.
            expression_parameters: The values of `%0`, `%1` ...

        Raises:
            ContentFilterError: The filter does not fit the message type. The old filter stays.
        """
        self._decoder.set_filter(filter_expression, expression_parameters)

    def get_content_filter(self) -> ContentFilterOptions:
        """Return the current filter.

        Raises:
            WrongStateError: The subscription has no filter.
        """
        return self._decoder.filter_options

    @property
    def lost_count(self) -> int:
        """How many messages were published but not received."""
        return self._losses.count

    @property
    def refused_count(self) -> int:
        """How many messages could not be decoded, or had another type."""
        return self._refusals.count

    @property
    def has_work(self) -> bool:
        """Whether there is a message to take. Only the thread that calls `take` may read this."""
        return bool(self._samples)

    def take_message(self, *, raw: bool = False) -> tuple[Any, MessageInfo] | None:
        """Remove and return the oldest message and its info, or return `None`.

        The callback is not called.

        Args:
            raw: Whether to return the message as bytes in ROS 2's CDR.

        Raises:
            CodecError: The message cannot be decoded.
        """
        Program.takes_itself = True
        while (sample := self.take()) is not None:
            payload = sample.payload.to_bytes()
            if not self._decoder.accepts(payload):
                continue
            attachment = sample.attachment
            facts = None if attachment is None else attachment.to_bytes()
            known = facts if facts is not None and len(facts) == _FACTS_LENGTH else None
            if known is None and (reason := self._refusals.reason_of_sample(sample, facts)):
                self._refusals.add(reason)
                continue
            self.received_count += 1
            decode = self._decoder.decode
            if raw and not self.raw:
                decode = self._context.dialect.raw_decoder(self.msg_type)
            try:
                message = decode(payload)
            except CodecError as exc:
                message = self._decoder.replaced(payload, exc)
                if message is None:
                    raise
            return message, self._info(known)
        return None

    def execute(self, sample: zenoh.Sample) -> Any:
        """Decode a sample and call the callback. Count and log a sample that cannot be decoded."""
        attachment = sample.attachment
        facts = None if attachment is None else attachment.to_bytes()
        if facts is not None and len(facts) == _FACTS_LENGTH:
            sequence, stamp_ns, _, gid = _unpack(facts)
            source = self._source_of(gid)
            if source is None or source.next_sequence != sequence or source.is_special:
                if not self._sources.admits(sample, sequence, stamp_ns, gid):
                    return None
            else:
                source.next_sequence = sequence + 1
        elif reason := self._refusals.reason_of_sample(sample, facts):
            self._refusals.add(reason)
            return None
        else:
            facts = None
        payload = sample.payload.to_bytes()
        if len(payload) >= LARGE_BYTES:
            keep_freed_memory()
            self._samples.expect_large()
        decoder = self._decoder
        try:
            message = decoder.decode(payload)
        except CodecError as exc:
            message = decoder.replaced_or_refused(payload, exc)
        if message is None or self._is_destroyed:
            return None
        if decoder.filter is not None and not decoder.accepts(payload, message):
            return None
        self.received_count += 1
        if self._with_info:
            return self._callback(message, self._info(facts))
        return self._callback(message)

    def _info(self, facts: bytes | None) -> MessageInfo:
        sequence, stamp_ns, _, gid = (0, 0, 0, b"") if facts is None else _unpack(facts)
        return MessageInfo(
            source_timestamp=stamp_ns,
            received_timestamp=time.time_ns(),
            publication_sequence_number=sequence,
            reception_sequence_number=self.received_count,
            publisher_gid=PublisherGid(
                implementation_identifier=self._context.dialect.identifier, data=gid
            )
            if gid
            else None,
        )

    def report_losses_to(self, listener: Callable[[int], None]) -> None:
        """Call `listener(count)` in the executor's thread when messages were lost."""
        self._losses.listeners.append(listener)

    def destroy(self) -> None:
        """Leave the topic. The callback may call this method. A second call does nothing."""
        if self._is_destroyed:
            return
        self._is_destroyed = True
        for handler in self.event_handlers:
            handler.destroy()
        self._context.undeclare(self._announcement)
        if self._latched is not None:
            self._latched.end()
            self._context.undeclare(self._subscriber)
        if self._context.is_inherited:
            fork.keep(self._subscriber, self._samples)
        else:
            self._samples.end()
        self._subscriber = None  # so Zenoh undeclares it, as in `Publisher.destroy`


class SubscriptionHandle(Handle[Subscription[Any]]):
    """A subscription's handle."""

    def take_message(
        self,
        msg_type: object = None,  # noqa: ARG002 - rclpy's signature
        raw: bool = False,
    ) -> tuple[Any, MessageInfo] | None:
        """Remove and return the oldest message and its info, or return `None`. No callback runs."""
        return self.entity.take_message(raw=raw)

    def get_topic_name(self) -> str:
        """Return the topic's full name."""
        return self.entity.topic_name

    def get_publisher_count(self) -> int:
        """Return how many publishers the topic has."""
        return self.entity.get_publisher_count()
