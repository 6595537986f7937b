"""Watches of topics, which provide the newest message, the rates, and older messages.

Messages are kept as bytes. A message is decoded when a page reads it, at most 30 times a second.
"""

from __future__ import annotations

import threading
import time
from collections import deque
from typing import TYPE_CHECKING, Any, NamedTuple

from zbot.observer.rate_meter import RateMeter
from zbot.threads.on_demand_thread import OnDemandThread
from zbot.wire.errors import CodecError

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator, Sequence

    from typing_extensions import Self

    from zbot.node.message_info import MessageInfo
    from zbot.node.node import Node
    from zbot.node.subscription import Subscription
    from zbot.qos import QoSProfile
    from zbot.threads.deadline import Deadline

#: A page is drawn at most 30 times a second. Between two drawings, the last decoded message is used
#: again.
_DECODE_PERIOD_NS = 10**9 // 30
#: A page may wait this long for the decoding of a message. Other messages are decoded in a thread,
#: because a page that waits stops all pages.
_QUICK_S = 0.01
#: Time for each byte of a list of empty messages. It counts until a message was decoded.
_SLOWEST_S = 1e-6
_FORGETTING = 0.9
_MOST_HISTORY_BYTES = 32_000_000
#: Messages that can wait while the executor is busy. Lost messages are counted.
QUEUE_DEPTH = 100


class Record(NamedTuple):
    """Received message before decoding."""

    number: int  #: starts at 1 for each topic
    stamp_ns: int  #: time of publishing, nanoseconds since the epoch; 0 if unknown
    received_ns: int  #: time of arrival, nanoseconds since the epoch
    payload: bytes

    @property
    def time_ns(self) -> int:
        """Time of publishing. For messages of plain Zenoh programs it is the time of arrival."""
        return self.stamp_ns or self.received_ns


class Feed:
    """Messages of one topic, which all its watches share.

    Args:
        topic: Full name.
        type_name: Full name of its type. None means the type in the graph.
        subscribe: Called with the feed at each change of a watch if at least one watch is active.
        unsubscribe: Called with the feed at each change of a watch if no watch is active.
    """

    def __init__(
        self,
        topic: str,
        type_name: str | None,
        subscribe: Callable[[Feed], None],
        unsubscribe: Callable[[Feed], None],
    ) -> None:
        self.topic = topic
        self.asked_type = type_name
        self.type_name = type_name
        self.problem = ""  #: a sentence about why there are no messages
        self.learned_type: str | None = None  #: the type whose definition a thread asks for now
        self.subscription: Any = None
        self.decode: Callable[[bytes], Any] | None = None
        self._last_type: str | None = None
        self.meter = RateMeter()
        self.newest: Record | None = None
        self.count = 0
        self._lost_before = 0
        self._subscribe, self._unsubscribe = subscribe, unsubscribe
        self._watches: set[Watch] = set()
        self._lock = threading.Lock()
        self._decode_lock = threading.Lock()
        self._decoded: tuple[Record | None, Any] = (None, None)
        self._decoded_ns = 0
        self._seconds_for_byte = _SLOWEST_S
        self._is_measured = False  # whether a message was decoded
        self._decoder = OnDemandThread(_start, self._decode_newest)
        self._history: deque[Record] = deque(maxlen=0)
        self._history_bytes = 0

    @property
    def is_wanted(self) -> bool:
        """Whether a watch is active."""
        # `tuple` makes an atomic copy. It is needed, because other threads change the set.
        return any(watch.is_active for watch in tuple(self._watches))

    @property
    def is_abandoned(self) -> bool:
        """Whether the feed has no watches."""
        return not self._watches

    def update(self, watch: Watch, *, is_held: bool) -> None:
        """Add, change or remove a watch. Subscribe or unsubscribe if necessary."""
        with self._lock:
            (self._watches.add if is_held else self._watches.discard)(watch)
            keep = max((held.keep for held in self._watches), default=0)
            if keep != self._history.maxlen:
                self._history = deque(self._history, maxlen=keep)
                self._history_bytes = sum(len(message.payload) for message in self._history)
            wanted = self.is_wanted
        (self._subscribe if wanted else self._unsubscribe)(self)

    def take(self, payload: bytes, info: MessageInfo) -> None:
        """Keep a message. This method is the callback of the subscription."""
        received_ns = info["received_timestamp"]
        self.count += 1
        record = Record(self.count, info["source_timestamp"], received_ns, payload)
        self.newest = record
        # The clock of `received_ns` may jump, e.g. when the laptop sets its time.
        self.meter.add(time.monotonic_ns(), len(payload))
        if self._history.maxlen:
            self._remember(record)

    def _remember(self, record: Record) -> None:
        with self._lock:
            history = self._history
            if history and len(history) == history.maxlen:
                self._history_bytes -= len(history[0].payload)
            history.append(record)
            self._history_bytes += len(record.payload)
            while self._history_bytes > _MOST_HISTORY_BYTES and len(history) > 1:
                self._history_bytes -= len(history.popleft().payload)

    @property
    def lost(self) -> int:
        """The number of messages that were lost because they came too fast."""
        subscription = self.subscription
        return self._lost_before + (subscription.lost_count if subscription is not None else 0)

    def forget_subscription(self) -> Any:
        """Forget the subscription and return it. The caller must destroy it."""
        self._lost_before = self.lost
        subscription, self.subscription = self.subscription, None
        return subscription

    def set_type(self, type_name: str | None) -> None:
        """Note the topic's type. Forget the messages of a former type. None means no node."""
        self.type_name = type_name
        with self._lock:
            if type_name not in {None, self._last_type}:
                self._last_type = type_name
                self.newest = self.decode = None
                self._decoded = None, None
                self._history.clear()
                self._history_bytes = 0

    def latest(self) -> tuple[Record | None, Any]:
        """Return the newest decoded message with its record. See `Watch.latest_record`."""
        newest = self.newest
        if newest is None:
            return None, None
        with self._decode_lock:
            now_ns = time.monotonic_ns()
            is_due = now_ns - self._decoded_ns >= _DECODE_PERIOD_NS
            if self._decoded[0] is not newest and (is_due or self._decoded[1] is None):
                self._decoded_ns = now_ns
                if self._is_slow(newest):
                    self._decoder.wake()
                else:
                    self._decode(newest)
            return self._decoded

    def _is_slow(self, record: Record) -> bool:
        return len(record.payload) * self._seconds_for_byte > _QUICK_S

    def _decode(self, record: Record) -> None:
        decode = self.decode
        message = self._measured(record)
        if decode is self.decode:  # otherwise the message may have another type than the topic
            self._decoded = (record, message)

    def _measured(self, record: Record) -> Any:
        """Decode and return a message, and note the time that this takes."""
        began_s = time.thread_time()
        message = self.read(record)
        measured_s = (time.thread_time() - began_s) / max(len(record.payload), 1)
        known_s = self._seconds_for_byte * _FORGETTING if self._is_measured else 0.0
        # The first message of a type takes longer, because its decoder is made.
        seconds = min(max(measured_s, known_s), _SLOWEST_S)
        self._seconds_for_byte, self._is_measured = seconds, True
        return message

    def _decode_newest(self) -> None:
        newest = self.newest
        if newest is not None and self._decoded[0] is not newest:
            self._decode(newest)

    def read(self, record: Record) -> Any:
        """Decode and return a kept message. If decoding fails, set `problem` and return None."""
        if self.decode is None:
            return None
        try:
            return self.decode(record.payload)
        except CodecError as error:
            self.problem = f"a message cannot be decoded: {error}"
            return None

    def read_since(self, number: int, deadline: Deadline) -> Iterator[tuple[Record, Any]]:
        """Yield kept messages after a number, decoded. See `Watch.read_since`."""
        for record in self.since(number):
            if self._is_slow(record):
                is_measured = self._is_measured
                newest, message = self.latest()
                if is_measured and newest is not None and newest.number > number:
                    yield newest, message
                return
            yield record, self._measured(record)
            number = record.number
            if deadline.is_over:
                return

    def since(self, number: int) -> Sequence[Record]:
        """Return the kept messages after a number. The oldest message is the first."""
        with self._lock:
            return [record for record in self._history if record.number > number]


class Watch:
    """Watch of a topic for one page or curve. Any thread may call any method.

    Args:
        feed: The topic's messages, which all its watches share.
        keep: The number of messages that `since` can return.
        is_active: Whether the watch receives messages at first, without a call of `resume`.
        forget: Called with the feed after the release of the watch.
    """

    def __init__(
        self, feed: Feed, *, keep: int, is_active: bool, forget: Callable[[Feed], None]
    ) -> None:
        self.keep = keep
        self.is_active = is_active
        self._feed = feed
        self._forget = forget
        self._is_held = True
        feed.update(self, is_held=True)

    @property
    def feed(self) -> Feed:
        """The messages of the topic, which all its watches share."""
        return self._feed

    @property
    def topic(self) -> str:
        """The topic's full name."""
        return self._feed.topic

    @property
    def type_name(self) -> str | None:
        """The type's full name. It is None until a node uses the topic."""
        return self._feed.type_name

    @property
    def problem(self) -> str:
        """A sentence if messages do not come or cannot be decoded. Otherwise it is empty."""
        return self._feed.problem

    @property
    def latest(self) -> Any:
        """The newest message, or None. Messages are decoded at most 30 times a second.

        Large messages are decoded in a thread, so they come some milliseconds later.
        """
        return self._feed.latest()[1]

    @property
    def latest_record(self) -> tuple[Record | None, Any]:
        """The newest message as in `latest`, after its record."""
        return self._feed.latest()

    @property
    def newest(self) -> Record | None:
        """The newest message before decoding."""
        return self._feed.newest

    @property
    def count(self) -> int:
        """The number of messages since the topic's first watch."""
        return self._feed.count

    @property
    def lost(self) -> int:
        """The number of messages that were lost because they came too fast."""
        return self._feed.lost

    @property
    def rate_hz(self) -> float:
        """Messages a second, over the last 5 s."""
        return self._feed.meter.rates(time.monotonic_ns())[0]

    @property
    def bytes_per_second(self) -> float:
        """Bytes of payload a second, over the last 5 s."""
        return self._feed.meter.rates(time.monotonic_ns())[1]

    def since(self, number: int) -> Sequence[Record]:
        """Return the kept messages after a number (0: all). The oldest message is the first."""
        return self._feed.since(number)

    def read(self, record: Record) -> Any:
        """Decode and return a kept message. If decoding fails, set `problem` and return None."""
        return self._feed.read(record)

    def read_since(self, number: int, deadline: Deadline) -> Iterator[tuple[Record, Any]]:
        """Yield kept messages after a number, decoded: the first one, and more until a deadline.

        The rest comes with the next call, so that other pages do not wait. If the decoding of a
        message takes long, the newest message follows, which is decoded in a thread as for
        `latest`. The messages between them are left out.
        """
        return self._feed.read_since(number, deadline)

    def pause(self) -> None:
        """Receive no messages until `resume`. Kept messages stay."""
        self._set(is_active=False)

    def resume(self) -> None:
        """Receive messages again."""
        self._set(is_active=True)

    def _set(self, *, is_active: bool) -> None:
        if self._is_held and is_active != self.is_active:
            self.is_active = is_active
            self._feed.update(self, is_held=True)

    def release(self) -> None:
        """End the watch. A second call does nothing."""
        if self._is_held:
            self._is_held = self.is_active = False
            self._feed.update(self, is_held=False)
            self._forget(self._feed)

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.release()


def subscribe_to_payloads(
    node: Node,
    message_type: Any,
    topic: str,
    take: Callable[[bytes, MessageInfo], object],
    profile: QoSProfile,
) -> Subscription[Any]:
    """Return a subscription whose callback receives undecoded payloads.

    The subscription counts lost messages.

    The decoder for the payloads is `context.dialect.codec_for(message_type).decode`.
    """
    subscription = node.create_subscription(message_type, topic, take, profile, raw="payload")
    subscription.report_losses_to(_ignore)
    return subscription


def _start(run: Callable[[], None]) -> None:
    threading.Thread(target=run, name="zbot watch", daemon=True).start()


def _ignore(_missing: int) -> None:
    """Do nothing. With this listener, the subscription does not log a warning of lost messages."""
