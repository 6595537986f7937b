"""Subscriptions, whose samples wait in a queue of Zenoh until the executor's thread decodes them.

A thread of the subscription waits for the first sample of a burst. The thread appends the sample to
the subscription's own queue, and posts the subscription to its executor. After that, the executor's
thread takes the samples from Zenoh's queue itself. When Zenoh's queue stays empty for a moment, the
executor's thread lets the subscription's thread wait again. So a burst costs one wake-up, the two
threads never compete, and an idle subscription uses no CPU. With keep-last, Zenoh's queue is a ring
channel, which drops the oldest samples without Python.
"""

from __future__ import annotations

import contextlib
import threading
import time
from collections import deque
from enum import Enum
from itertools import islice
from typing import TYPE_CHECKING, Any, Generic, Literal, TypeVar

import zenoh

from zbot.executor.forgotten_spin import Program
from zbot.handle import Handle
from zbot.interfaces import has_sequences
from zbot.log import get_logger, sinks_disabled
from zbot.names import ROSOUT_TOPIC
from zbot.node.content_filter_options import ContentFilterOptions, NoContentFilterError
from zbot.node.endpoint import TopicEndpoint
from zbot.node.message_info import MessageInfo, PublisherGid, takes_info
from zbot.node.zenoh_declaration import declare_subscriber
from zbot.process import blocked_put, fork
from zbot.process.memory import LARGE_BYTES, keep_freed_memory
from zbot.qos import HistoryPolicy
from zbot.threads.wakeup import LARGE_MESSAGE_WAIT_NS, BusyWait
from zbot.wire.attachment import LAYOUT
from zbot.wire.errors import CodecError

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.context import Context
    from zbot.executor.callback_group import CallbackGroup
    from zbot.executor.ready_queue import ReadyQueue
    from zbot.interfaces.content_filter import ContentFilter
    from zbot.wire.tokens import EndpointToken

MsgT = TypeVar("MsgT")

# Length of a keep-all queue. A full queue blocks its publishers (Zenoh's BLOCK). Such waits add a
# tenth to a small message's latency. So the queue is long. For types with sequences, the queue is
# short, because a single message of such a type can take megabytes of memory.
_KEEP_ALL_QUEUE = 8192
_KEEP_ALL_QUEUE_OF_SEQUENCES = 256
# The largest number of reasons to log. A wrong program may cause a new reason with each message.
_MAX_REFUSALS = 3
# The largest number of publishers whose sequence numbers are kept. Each restart of a publisher adds
# a number. Without a limit, the memory use would grow for ever.
_MAX_SOURCES = 1024


_unpack, _FACTS_LENGTH = LAYOUT.unpack, LAYOUT.size


class _Source:
    """Publisher of received messages, with its next sequence number, lifespan and type mismatch."""

    __slots__ = ("is_special", "lifespan_ns", "next_sequence", "refusal")

    def __init__(self, next_sequence: int, *, refusal: str, lifespan_ns: int) -> None:
        self.next_sequence = next_sequence
        self.refusal = refusal  #: why its messages cannot be decoded, or an empty string
        self.lifespan_ns = lifespan_ns
        self.is_special = bool(lifespan_ns or refusal)


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

    due_ns: int | None = None

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
        self._filter: ContentFilter | None = None
        if content_filter is not None:
            self.set_content_filter(*content_filter)
        self.callback_group = callback_group
        self.callback = callback
        self.raw = raw
        self.event_handlers: list[Any] = []
        self.lost_count = 0  #: messages that were published but not received
        self._refusals: set[str] = set()  # reasons that were logged
        self._has_replacements = False  # whether a value that is not valid was logged
        self.refused_count = 0  #: messages that could not be decoded, or had another type
        self._loss_listeners: list[Callable[[int], None]] = []
        self._context = context
        self._token = token
        self.ready_queue = ready_queue
        self._logger_name = logger_name
        codec = context.dialect.codec_for(msg_type)
        self._decode: Callable[[Any], Any] = codec.decode_strictly
        self._read = codec.decode  # for values that are not valid, and for the filter
        if raw:
            self._decode = bytes if raw == "payload" else context.dialect.raw_decoder(msg_type)
        self._checks_keys = context.dialect.refuses_keys(token)
        self._sources: dict[bytes, _Source] = {}
        self.received_count = 0  #: messages that the callback got or `take_message` took
        self._keep_all = token.qos.history is HistoryPolicy.KEEP_ALL
        # The largest number of samples to take in one call, and the size of a keep-all channel.
        # Without a limit, the loop in `take` would never end if a publisher never pauses.
        self._channel_size = _KEEP_ALL_QUEUE
        if self._keep_all and has_sequences(msg_type):
            self._channel_size = _KEEP_ALL_QUEUE_OF_SEQUENCES
        self._queue: deque[zenoh.Sample] = deque(
            maxlen=None if self._keep_all else max(token.qos.depth, 1)
        )
        self._subscriber: Any = declare_subscriber(context, token, self._channel_size)
        self._channel = self._subscriber.handler
        self.next_sample = self._channel.try_recv  #: takes a sample from Zenoh's queue
        if self._keep_all:
            blocked_put.local_queues.add(self)
        self._armed = threading.Lock()
        self._is_waiting = False
        self._busy_wait = BusyWait()
        self._is_destroyed = False
        self._is_over = False  #: whether the session was closed
        self._announcement = context.graph.announce(token, is_visible=is_announced)

    def start(self) -> None:
        """Start to receive. The ready queue tells the executor about messages."""
        self._armed.acquire()
        self._context.start_thread(f"zbot {self.topic_name}", self._listen, self._end)

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
        """Return how many publishers the topic has in the whole domain."""
        return len(self._context.graph.snapshot().publishers(self.topic_name))

    @property
    def is_cft_enabled(self) -> bool:
        """Whether there is a content filter."""
        return self._filter is not None

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
        from zbot.interfaces.content_filter import ContentFilter  # noqa: PLC0415 - rarely needed

        new = None
        if filter_expression.strip():
            new = ContentFilter(filter_expression, expression_parameters, self.msg_type)
        self._filter = new
        self._filter_options = ContentFilterOptions(filter_expression, list(expression_parameters))

    def get_content_filter(self) -> ContentFilterOptions:
        """Return the current filter.

        Raises:
            NoContentFilterError: The subscription has no filter.
        """
        if self._filter is None:
            raise NoContentFilterError(self.topic_name)
        return self._filter_options

    def _listen(self) -> None:
        receive, queue, armed = self._channel.recv, self._queue, self._armed
        while True:
            try:
                sample = receive()
            except zenoh.ZError:
                return  # undeclared, or the session was closed
            self._busy_wait.end(came=True)
            queue.append(sample)
            self._is_waiting = True
            self.ready_queue.post(self)
            if not self._is_destroyed:
                armed.acquire()
            if self._is_destroyed or self._is_over:
                return  # `take` can still get the samples that are in Zenoh's queue

    def take(self) -> zenoh.Sample | None:
        """Remove and return the oldest sample that the profile's history keeps, if any."""
        queue = self._queue
        # With keep-last, each call moves all new samples from Zenoh's queue to this queue, so that
        # this queue drops the oldest samples. With keep-all, samples are moved only when this queue
        # is empty. A blocked publisher wakes up each time that Zenoh's full queue gets room. So
        # there are few wake-ups if many samples are moved in one call.
        if self._is_waiting and not (queue and self._keep_all):
            try:
                # This loop runs in C.
                queue.extend(islice(iter(self.next_sample, None), self._channel_size))
                if not (queue or self._busy_wait.begin(self._fetch)):
                    self._rearm()
            except zenoh.ZError:
                return None  # another thread destroyed the subscription or closed the session
        try:
            return queue.popleft()
        except IndexError:
            return None

    @property
    def has_work(self) -> bool:
        """Whether there is a message to take. Only the thread that calls `take` may read this."""
        if not self._queue and self._is_waiting:
            sample = self.take()  # from Zenoh's queue, which `_listen` does not watch now
            if sample is not None:
                self._queue.appendleft(sample)
        return bool(self._queue)

    def take_message(self, *, raw: bool = False) -> tuple[Any, MessageInfo] | None:
        """Remove and return the oldest message and its info, or return `None`.

        The callback is not called.

        Args:
            raw: Whether to return the message as bytes in ROS 2's CDR.

        Raises:
            CodecError: The message cannot be decoded.
        """
        Program.has_spun = True  # this program needs no executor
        while (sample := self.take()) is not None:
            payload = sample.payload.to_bytes()
            if not self._is_wanted(payload):
                continue
            attachment = sample.attachment
            facts = None if attachment is None else attachment.to_bytes()
            known = facts if facts is not None and len(facts) == _FACTS_LENGTH else None
            if known is None and (refusal := self._refusal(sample, facts)):
                self._refuse(refusal)
                continue
            self.received_count += 1
            decode = self._decode
            if raw and not self.raw:
                decode = self._context.dialect.raw_decoder(self.msg_type)
            try:
                message = decode(payload)
            except CodecError as exc:
                message = self._with_replacements(payload, exc)
                if message is None:
                    raise
            return message, self._info(known)
        return None

    def _fetch(self) -> bool:
        sample = self.next_sample()
        if sample is None:
            return False
        self._queue.append(sample)
        return True

    def _rearm(self) -> None:
        self._is_waiting = False
        with contextlib.suppress(RuntimeError):  # another thread released it first
            self._armed.release()

    def _end(self) -> None:
        """End the thread that listens, because the session was closed."""
        self._is_over = True
        self._rearm()

    def execute(self, sample: zenoh.Sample) -> Any:
        """Decode a sample and call the callback. Count and log a sample that cannot be decoded."""
        attachment = sample.attachment
        facts = None if attachment is None else attachment.to_bytes()
        if facts is not None and len(facts) == _FACTS_LENGTH:
            sequence, stamp_ns, _, gid = _unpack(facts)
            source = self._sources.get(gid)
            if source is None or source.next_sequence != sequence or source.is_special:
                if not self._admits(sample, sequence, stamp_ns, gid):
                    return None
            else:
                source.next_sequence = sequence + 1
        elif refusal := self._refusal(sample, facts):
            self._refuse(refusal)
            return None
        else:
            facts = None
        payload = sample.payload.to_bytes()
        if len(payload) >= LARGE_BYTES:
            keep_freed_memory()
            self._busy_wait.short_wait_ns = LARGE_MESSAGE_WAIT_NS
        try:
            message = self._decode(payload)
        except CodecError as exc:
            message = self._replaced_or_refused(payload, exc)
        if message is None or self._is_destroyed:
            return None
        if self._filter is not None and not self._is_wanted(payload, None if self.raw else message):
            return None
        self.received_count += 1
        if self._with_info:
            return self._callback(message, self._info(facts))
        return self._callback(message)

    def _is_wanted(self, payload: bytes, message: Any = None) -> bool:
        """Return whether the content filter selects a message. Without a filter, return true.

        Args:
            payload: The message's payload.
            message: The decoded message. If it is left out, the payload is decoded here.
        """
        if self._filter is None:
            return True
        try:
            return self._filter.matches(self._read(payload) if message is None else message)
        except CodecError as exc:
            self._refuse(str(exc))  # a raw message is decoded here for the first time
            return False

    def _admits(self, sample: zenoh.Sample, sequence: int, stamp_ns: int, gid: bytes) -> bool:
        """Return whether to decode a message. Count a gap in its publisher's sequence numbers.

        This is called for a publisher's first message, for a message after a gap, and for every
        message of a publisher with a lifespan or a wrong type.
        """
        source = self._sources.get(gid) or self._add_source(sample, sequence, gid)
        if sequence != source.next_sequence:
            self._count_loss(sequence - source.next_sequence)
        # A late message must not lower the number, or the next message would count as a loss.
        source.next_sequence = max(source.next_sequence, sequence + 1)
        if self._checks_keys and self._type_refusal(sample):
            return False
        if source.refusal:
            self._refuse(source.refusal)
            return False
        return not source.lifespan_ns or time.time_ns() - stamp_ns <= source.lifespan_ns

    def _refusal(self, sample: zenoh.Sample, facts: bytes | None) -> str:
        """Return why to refuse a sample that has no valid attachment, or an empty string."""
        length = None if facts is None else len(facts)
        return self._context.dialect.attachment_refusal(length) or self._type_refusal(sample)

    def _type_refusal(self, sample: zenoh.Sample) -> str:
        """Return why a sample's type is wrong, or an empty string if it is right or unknown."""
        if self.raw:
            return ""
        dialect = self._context.dialect
        return dialect.refusal(sample.key_expr, sample.encoding, self._token.type_name)

    def _add_source(self, sample: zenoh.Sample, sequence: int, gid: bytes) -> _Source:
        if len(self._sources) >= _MAX_SOURCES:
            self._sources.clear()
        publisher = self._context.graph.find(gid)
        lifespan = 0 if publisher is None else publisher.qos.lifespan.nanoseconds
        own = self._token.qos.lifespan.nanoseconds
        limits = [limit for limit in (lifespan, own) if 0 < limit < 2**63 - 1]
        refusal = "" if self._checks_keys else self._type_refusal(sample)
        source = _Source(sequence, refusal=refusal, lifespan_ns=min(limits, default=0))
        source.is_special |= self._checks_keys
        self._sources[gid] = source
        return source

    def _count_loss(self, missing: int) -> None:
        if missing < 0:
            return  # the publisher's threads overtook each other, or a cached message came again
        first = self.lost_count == 0
        self.lost_count += missing
        for listener in self._loss_listeners:
            listener(missing)
        if first and not self._loss_listeners:
            self._warn_of_loss(missing)

    def _warn_of_loss(self, missing: int) -> None:
        # A warning about lost lines of /rosout must not be published on /rosout, because it would
        # push another line out of the full queue.
        own_cause = self.topic_name == ROSOUT_TOPIC
        with sinks_disabled() if own_cause else contextlib.nullcontext():
            get_logger(self._logger_name).warning(
                f"{self.topic_name}: {missing} messages lost: they come faster than the callback "
                f"takes them (queue depth {self._token.qos.depth}; further losses are only counted)"
            )

    def _refuse(self, reason: str) -> None:
        self.refused_count += 1
        if reason not in self._refusals and len(self._refusals) < _MAX_REFUSALS:
            self._refusals.add(reason)
            get_logger(self._logger_name).error(
                f"{self.topic_name}: cannot read a message: {reason} "
                "(more of this kind are only counted)"
            )

    def _replaced_or_refused(self, payload: bytes, error: CodecError) -> Any:
        message = self._with_replacements(payload, error)
        if message is None:
            self._refuse(str(error))
        return message

    def _with_replacements(self, payload: bytes, error: CodecError) -> Any:
        """Return a message in which values are not valid, e.g. a text that is not UTF-8.

        Return None if the message cannot be decoded at all, or if the callback takes bytes.
        """
        if self.raw:
            return None
        try:
            message = self._read(payload)
        except CodecError:
            return None
        if not self._has_replacements:
            self._has_replacements = True
            get_logger(self._logger_name).warning(
                f"{self.topic_name}: {error.replacement()} (this is logged only once)"
            )
        return message

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
        self._loss_listeners.append(listener)

    def destroy(self) -> None:
        """Leave the topic. The callback may call this method. A second call does nothing."""
        if self._is_destroyed:
            return
        self._is_destroyed = True
        for handler in self.event_handlers:
            handler.destroy()
        self._context.undeclare(self._announcement)
        if self._context.is_inherited:
            fork.keep(self._subscriber)
        self._subscriber = None  # so Zenoh undeclares it, as in `Publisher.destroy`
        if self._is_waiting:
            self._rearm()


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
