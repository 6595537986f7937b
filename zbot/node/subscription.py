"""Subscriptions: samples wait in Zenoh's own queue and are decoded where their callback runs.

A thread of ours waits for the first sample of a burst, hands it over and posts the subscription to
its executor; the executor then drains Zenoh's queue itself, and re-arms the thread when nothing is
left and nothing comes in a moment. So a burst costs one wake-up, the two threads never compete, and
an idle subscription uses no CPU. A keep-last queue is Zenoh's ring channel: what does not fit is
dropped there and never touched by Python.
"""

from __future__ import annotations

import contextlib
import inspect
import threading
import time
from collections import deque
from enum import Enum
from itertools import islice
from typing import TYPE_CHECKING, Any, Generic, Literal, NamedTuple, TypedDict, TypeVar

import zenoh

from zbot.errors import ZbotError
from zbot.executor.errors import CallbackSignatureError
from zbot.interfaces import has_sequences
from zbot.log import away_from_sinks, get_logger
from zbot.names import ROSOUT_TOPIC
from zbot.node.endpoint import RMW_IDENTIFIER, TopicEndpoint
from zbot.process import blocked_put
from zbot.process.memory import LARGE_BYTES, keep_freed_memory
from zbot.qos import DurabilityPolicy, HistoryPolicy
from zbot.transport.handle import Handle
from zbot.transport.wakeup import LARGE_MOMENT_NS, BusyWait
from zbot.wire.attachment import LAYOUT
from zbot.wire.codec import CodecError
from zbot.wire.dialect import other_type
from zbot.wire.serialization import raw_decoder

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.context import Context
    from zbot.executor.callback_group import CallbackGroup
    from zbot.executor.ready_queue import ReadyQueue
    from zbot.interfaces.content_filter import ContentFilter
    from zbot.wire.tokens import EndpointToken

MsgT = TypeVar("MsgT")

# A keep-all queue that is full holds up its publishers (Zenoh's BLOCK): long enough that they wait
# seldom, which is a tenth of a small message's way, and short where one message may take megabytes.
_KEEP_ALL_QUEUE = 8192
_KEEP_ALL_QUEUE_OF_SEQUENCES = 256
# Publishers that restart for days leave their numbers behind: forget all after this many.
_MOST_SOURCES = 1024


_unpack, _FACTS_LENGTH = LAYOUT.unpack, LAYOUT.size


class PublisherGid(TypedDict):
    """Which publisher sent a message."""

    implementation_identifier: str
    data: bytes


class MessageInfo(TypedDict):
    """What a two-argument callback learns about its message; times in ns since the epoch."""

    source_timestamp: int
    received_timestamp: int
    publication_sequence_number: int
    reception_sequence_number: int
    publisher_gid: PublisherGid | None  #: `None` where the publisher is no node's


class ContentFilterOptions(NamedTuple):
    """Messages that a subscription wants: `create_subscription` takes it.

    The expressions are those of `zbot.interfaces.content_filter`.
    """

    filter_expression: str  #: an empty one lets every message through
    expression_parameters: list[str]  #: what `%0`, `%1` ... stand for, written as in an expression


class NoContentFilterError(ZbotError, LookupError):
    """A subscription was asked for a filter that it does not have."""

    def __init__(self, topic: str) -> None:
        self.topic = topic
        super().__init__(f"the subscription of {topic} has no content filter")


class _Source:
    """One publisher, as this subscription sees it."""

    __slots__ = ("is_special", "lifespan_ns", "next_sequence", "refusal")

    def __init__(self, next_sequence: int, *, refusal: str, lifespan_ns: int) -> None:
        self.next_sequence = next_sequence
        self.refusal = refusal  #: why its messages cannot be read; empty if they can
        self.lifespan_ns = lifespan_ns
        self.is_special = bool(lifespan_ns or refusal)


class Subscription(TopicEndpoint, Generic[MsgT]):
    """Calls a function for every message of a topic. Made by `Node.create_subscription`.

    Args:
        context: The session to listen through.
        msg_type: Message class.
        callback: Takes the message, or the message and its `MessageInfo`; may be a coroutine
            function.
        token: Who and where this subscription is.
        ready_queue: The node's way to its executor.
        callback_group: Decides beside what the callback may run.
        raw: Hand each message to the callback as the bytes of ROS 2's CDR; with `"payload"`, as
            the bytes that were sent, undecoded.
        logger_name: The node's logger.
        content_filter: Which messages are wanted; all if left out.

    Raises:
        ContentFilterError: The filter does not fit the type.
    """

    class CallbackType(Enum):
        """How many arguments the callback takes."""

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
    ) -> None:
        self.msg_type = msg_type
        self._filter: ContentFilter | None = None
        if content_filter is not None:
            self.set_content_filter(*content_filter)
        self.callback_group = callback_group
        self.callback = callback
        self.raw = raw
        self.event_handlers: list[Any] = []
        self.lost_count = 0  #: messages that were published and never came out of the queue
        self.refused_count = 0  #: messages that could not be read, or had another type
        self._loss_listeners: list[Callable[[int], None]] = []
        self._context = context
        self._token = token
        self.ready_queue = ready_queue
        self._logger_name = logger_name
        decode = context.dialect.codec_for(msg_type).decode
        self._decode: Callable[[Any], Any] = decode
        self._read = decode  # a filter looks at messages where the callback wants bytes
        if raw:
            self._decode = bytes if raw == "payload" else raw_decoder(decode)
        self._sources: dict[bytes, _Source] = {}
        self.received_count = 0  #: messages that the callback got
        self._keep_all = token.qos.history is HistoryPolicy.KEEP_ALL
        # Drained at once: all of a channel, but no more than that of a publisher that never pauses.
        self._most = _KEEP_ALL_QUEUE
        if self._keep_all and has_sequences(msg_type):
            self._most = _KEEP_ALL_QUEUE_OF_SEQUENCES
        self._queue: deque[zenoh.Sample] = deque(
            maxlen=None if self._keep_all else max(token.qos.depth, 1)
        )
        self._subscriber: Any = _declare(context, token, self._most)
        self._channel = self._subscriber.handler
        self.next_sample = self._channel.try_recv  #: takes it out of Zenoh's queue
        if self._keep_all:
            blocked_put.own_queues.add(self)
        self._armed = threading.Lock()
        self._is_waiting = False
        self._busy_wait = BusyWait()
        self._is_destroyed = False
        self._liveliness = context.graph.announce(token)

    def start(self) -> None:
        """Begin to listen; the executor learns of messages through the ready_queue."""
        self._armed.acquire()
        self._context.start_thread(f"zbot {self.topic_name}", self._listen, self._rearm)

    @property
    def callback(self) -> Callable[..., Any]:
        """The function that gets the messages."""
        return self._callback

    @callback.setter
    def callback(self, callback: Callable[..., Any]) -> None:
        self._with_info = _wants_info(callback)
        self._callback = callback

    @property
    def is_destroyed(self) -> bool:
        """Whether it listens no more."""
        return self._is_destroyed

    @property
    def _callback_type(self) -> CallbackType:
        return (
            self.CallbackType.WithMessageInfo if self._with_info else self.CallbackType.MessageOnly
        )

    @property
    def handle(self) -> SubscriptionHandle:
        """What a `WaitSet` takes, and what messages can be taken from without an executor."""
        return SubscriptionHandle(self)

    def get_publisher_count(self) -> int:
        """Return how many publishers the topic has in the whole domain."""
        return len(self._context.graph.snapshot().publishers(self.topic_name))

    # -- content filter ------------------------------------------------------------------------

    @property
    def is_cft_enabled(self) -> bool:
        """Whether a content filter keeps messages back."""
        return self._filter is not None

    def set_content_filter(self, filter_expression: str, expression_parameters: list[str]) -> None:
        """Take only the messages of which an expression is true, from the next message on.

        All messages travel, and are filtered where they arrive: it spares the callback, not the
        network.

        Args:
            filter_expression: See `zbot.interfaces.content_filter`; an empty one removes it.
            expression_parameters: What `%0`, `%1` ... stand for.

        Raises:
            ContentFilterError: The filter does not fit the type; the former one stays.
        """
        from zbot.interfaces.content_filter import ContentFilter  # noqa: PLC0415 - few have one

        new = None
        if filter_expression.strip():
            new = ContentFilter(filter_expression, expression_parameters, self.msg_type)
        self._filter = new
        self._filter_options = ContentFilterOptions(filter_expression, list(expression_parameters))

    def get_content_filter(self) -> ContentFilterOptions:
        """Return the present filter.

        Raises:
            NoContentFilterError: There is none.
        """
        if self._filter is None:
            raise NoContentFilterError(self.topic_name)
        return self._filter_options

    # -- receiving -----------------------------------------------------------------------------

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
            armed.acquire()

    def take(self) -> zenoh.Sample | None:
        """Return the oldest sample that the profile's history still keeps, if any."""
        queue = self._queue
        # A keep-last queue always takes all that came, so that the oldest drop out. A keep-all
        # queue is emptied before it takes more: refilling a channel that is full costs its writer
        # a wake-up.
        if self._is_waiting and not (queue and self._keep_all):
            try:
                # The loop is C's.
                queue.extend(islice(iter(self.next_sample, None), self._most))
                if not (queue or self._busy_wait.begin(self._fetch)):
                    self._rearm()
            except zenoh.ZError:
                return None  # another thread undeclared it or closed the session just now
        try:
            return queue.popleft()
        except IndexError:
            return None

    @property
    def has_work(self) -> bool:
        """Whether there is a message to take; for the thread that takes them."""
        if not self._queue and self._is_waiting:
            sample = self.take()  # more may have come while nobody looked
            if sample is not None:
                self._queue.appendleft(sample)
        return bool(self._queue)

    def take_message(self, *, raw: bool = False) -> tuple[Any, MessageInfo] | None:
        """Take the oldest message with its info past the callback; `None` if there is none.

        Args:
            raw: Return ROS 2's CDR bytes in place of a message.

        Raises:
            CodecError: It cannot be read.
        """
        while (sample := self.take()) is not None:
            payload = sample.payload.to_bytes()
            if not self._is_wanted(payload):
                continue
            attachment = sample.attachment
            facts = None if attachment is None else attachment.to_bytes()
            known = facts if facts is not None and len(facts) == _FACTS_LENGTH else None
            self.received_count += 1
            decode = raw_decoder(self._decode) if raw and not self.raw else self._decode
            return decode(payload), self._info(known)
        return None

    def _fetch(self) -> bool:
        sample = self.next_sample()
        if sample is None:
            return False
        self._queue.append(sample)
        return True

    def _rearm(self) -> None:
        self._is_waiting = False
        with contextlib.suppress(RuntimeError):  # `take` and `destroy` met in two threads
            self._armed.release()

    def execute(self, sample: zenoh.Sample) -> Any:
        """Decode a sample and call the callback; one that cannot be read is counted and told."""
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
        elif refusal := self._refusal(sample):
            self._refuse(refusal)
            return None
        else:
            facts = None
        payload = sample.payload.to_bytes()
        if len(payload) >= LARGE_BYTES:
            keep_freed_memory()
            self._busy_wait.moment_ns = LARGE_MOMENT_NS
        try:
            message = self._decode(payload)
        except CodecError as exc:
            self._refuse(str(exc))
            return None
        if self._is_destroyed:
            return None
        if self._filter is not None and not self._is_wanted(payload, None if self.raw else message):
            return None
        self.received_count += 1
        if self._with_info:
            return self._callback(message, self._info(facts))
        return self._callback(message)

    def _is_wanted(self, payload: bytes, message: Any = None) -> bool:
        """Return whether the content filter, if any, lets a message through.

        Args:
            payload: The message as it came.
            message: The same, if somebody has read it already.
        """
        if self._filter is None:
            return True
        try:
            return self._filter.admits(self._read(payload) if message is None else message)
        except CodecError as exc:
            self._refuse(str(exc))  # the callback wants bytes, so nobody has looked before
            return False

    def _admits(self, sample: zenoh.Sample, sequence: int, stamp_ns: int, gid: bytes) -> bool:
        """Note a message of a new publisher, behind a gap, or of a publisher that needs a look."""
        source = self._sources.get(gid) or self._greet(sample, sequence, gid)
        if sequence != source.next_sequence:
            self._lose(sequence - source.next_sequence)
        source.next_sequence = max(source.next_sequence, sequence + 1)  # a late one is no loss
        if source.refusal:
            self._refuse(source.refusal)
            return False
        return not source.lifespan_ns or time.time_ns() - stamp_ns <= source.lifespan_ns

    def _refusal(self, sample: zenoh.Sample) -> str:
        """Return why a sample's encoding rules it out; one that names no type does not."""
        if self.raw:
            return ""
        return other_type(self._context.dialect, sample.encoding, self._token.type_name)

    def _greet(self, sample: zenoh.Sample, sequence: int, gid: bytes) -> _Source:
        if len(self._sources) >= _MOST_SOURCES:
            self._sources.clear()
        publisher = self._context.graph.find(gid)
        lifespan = 0 if publisher is None else publisher.qos.lifespan.nanoseconds
        own = self._token.qos.lifespan.nanoseconds
        limits = [limit for limit in (lifespan, own) if 0 < limit < 2**63 - 1]
        refusal = self._refusal(sample)
        source = _Source(sequence, refusal=refusal, lifespan_ns=min(limits, default=0))
        self._sources[gid] = source
        return source

    def _lose(self, missing: int) -> None:
        if missing < 0:
            return  # the publisher's threads overtook each other, or it sent a cached message again
        first = self.lost_count == 0
        self.lost_count += missing
        for listener in self._loss_listeners:
            listener(missing)
        if first and not self._loss_listeners:
            self._warn_of_loss(missing)

    def _warn_of_loss(self, missing: int) -> None:
        # On /rosout the warning would itself push out a line that waits.
        own_cause = self.topic_name == ROSOUT_TOPIC
        with away_from_sinks() if own_cause else contextlib.nullcontext():
            get_logger(self._logger_name).warning(
                f"{self.topic_name}: {missing} messages lost: they come faster than the callback "
                f"takes them (queue depth {self._token.qos.depth}; further losses are only counted)"
            )

    def _refuse(self, reason: str) -> None:
        self.refused_count += 1
        if self.refused_count == 1:
            get_logger(self._logger_name).error(
                f"{self.topic_name}: cannot read a message: {reason} "
                "(further ones are only counted)"
            )

    def _info(self, facts: bytes | None) -> MessageInfo:
        sequence, stamp_ns, _, gid = (0, 0, 0, b"") if facts is None else _unpack(facts)
        return MessageInfo(
            source_timestamp=stamp_ns,
            received_timestamp=time.time_ns(),
            publication_sequence_number=sequence,
            reception_sequence_number=self.received_count,
            publisher_gid=PublisherGid(implementation_identifier=RMW_IDENTIFIER, data=gid)
            if gid
            else None,
        )

    def report_losses_to(self, listener: Callable[[int], None]) -> None:
        """Call `listener(missing)` in the executor's thread when messages were lost."""
        self._loss_listeners.append(listener)

    def destroy(self) -> None:
        """Stop listening; may be called twice, also in the callback."""
        if self._is_destroyed:
            return
        self._is_destroyed = True
        for handler in self.event_handlers:
            handler.destroy()
        if not self._context.is_closed:
            self._liveliness.undeclare()
        self._subscriber = None  # as in `Publisher.destroy`
        if self._is_waiting:
            self._rearm()


class SubscriptionHandle(Handle[Subscription[Any]]):
    """A subscription's handle."""

    def take_message(
        self,
        msg_type: object = None,  # noqa: ARG002 - rclpy's signature
        raw: bool = False,
    ) -> tuple[Any, MessageInfo] | None:
        """Take the oldest message with its info past the callback; `None` if there is none."""
        return self.entity.take_message(raw=raw)

    def get_topic_name(self) -> str:
        """Return the topic's full name."""
        return self.entity.topic_name

    def get_publisher_count(self) -> int:
        """Return how many publishers the topic has."""
        return self.entity.get_publisher_count()


def _wants_info(callback: Callable[..., Any]) -> bool:
    """Return whether a callback takes the message's info too.

    Raises:
        CallbackSignatureError: It takes neither one nor two arguments.
    """
    expected = "(message) or (message, info)"
    if not callable(callback):
        raise CallbackSignatureError("a subscription's callback", expected)
    try:
        signature = inspect.signature(callback)
    except (TypeError, ValueError):
        return False  # some builtins have no signature; list.append is a popular callback
    for arguments in ((None,), (None, None)):
        try:
            signature.bind(*arguments)
        except TypeError:
            continue
        return len(arguments) == 2
    raise CallbackSignatureError("a subscription's callback", expected)


def _declare(context: Context, token: EndpointToken, most: int) -> Any:
    qos = token.qos
    depth = max(qos.depth, 1)
    channel: Any = zenoh.handlers.RingChannel(depth)
    if qos.history is HistoryPolicy.KEEP_ALL:
        channel, depth = zenoh.handlers.FifoChannel(most), most
    key = context.dialect.topic_key(context.get_domain_id(), token.name)
    if qos.durability is not DurabilityPolicy.TRANSIENT_LOCAL:
        return context.session.declare_subscriber(key, channel)
    import zenoh.ext as advanced  # noqa: PLC0415 - only latched topics need it

    return advanced.declare_advanced_subscriber(
        context.session,
        key,
        channel,
        history=advanced.HistoryConfig(detect_late_publishers=True, max_samples=depth),
        recovery=advanced.RecoveryConfig(periodic_queries=None, heartbeat=True),
        subscriber_detection=True,
    )
