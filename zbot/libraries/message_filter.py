"""Message filters: subscribers, caches, chains and synchronizers.

Names, their spelling and the behaviour are the same as in ROS 2's `message_filters`.
"""

from __future__ import annotations

import itertools
import threading
from bisect import bisect_left, bisect_right
from typing import TYPE_CHECKING, Any, Protocol

from zbot.executor.callback_check import check_callback
from zbot.executor.clock import ROSClock
from zbot.executor.set_by_init import set_by_init
from zbot.libraries.filter_arguments import (
    callback_form,
    check_list,
    check_number,
    check_size,
    connected,
    missing_argument_error,
)
from zbot.log import warn_once
from zbot.node.argument_check import check_object, check_order, is_class, is_name, is_node
from zbot.time import Duration, Time

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Sequence

    from zbot.node.node import Node

    Queue = dict[int, Any]  #: messages by their time in nanoseconds


class Filter(Protocol):
    """Filter that passes messages to registered callbacks."""

    def registerCallback(self, cb: Callable[..., Any], *args: Any) -> int:  # noqa: N802 - ROS 2's
        """Register a function that is called with each output."""
        ...


class SimpleFilter:
    """Filter that calls all registered callbacks with its output."""

    callbacks: dict[int, tuple[Callable[..., Any], tuple[Any, ...]]] = set_by_init()
    _width = 0  #: number of messages in an output, or 0 if it is unknown

    def __init__(self) -> None:
        self.callbacks = {}

    def registerCallback(self, cb: Callable[..., Any], *args: Any) -> int:  # noqa: N802 - ROS 2's
        """Register a function to call with each output and `args`. Return the connection's id.

        Raises:
            WrongTypeError: `cb` is not callable.
            WrongStateError: `cb` does not take the messages of an output and `args`.
        """
        is_ours = type(self).__module__ == __name__  # a class of a program may output more
        forms = [callback_form(self._width, len(args))] if self._width and is_ours else []
        check_callback("registerCallback", cb, *forms, argument="cb")
        connection = max(self.callbacks, default=-1) + 1
        self.callbacks[connection] = (cb, args)
        return connection

    def signalMessage(self, *msg: Any) -> None:  # noqa: N802 - ROS 2's
        """Call all callbacks, in the order in which they were registered."""
        for callback, args in list(self.callbacks.values()):
            callback(*msg, *args)


class Subscriber(SimpleFilter):
    """Subscription as the source of a chain of filters.

    Args:
        node: The node that subscribes.
        msg_type: Class of the messages.
        topic: Name of the topic.
        qos_profile: As in `create_subscription`. The default is 10.
        options: Other arguments of `create_subscription`.

    Raises:
        WrongTypeError: The node, the type or the topic is missing, or their order is wrong.
    """

    _width = 1

    def __init__(
        self,
        node: Node,
        msg_type: type[Any],
        topic: str | None = None,
        qos_profile: Any = 10,
        **options: Any,
    ) -> None:
        super().__init__()
        if topic is None or (is_class(node) and is_name(msg_type)):
            raise missing_argument_error(node, msg_type)
        check_order("Subscriber", (node, is_node), (msg_type, is_class), (topic, is_name))
        check_object("node", node, "a node", "create_subscription")
        self.node = node
        self.topic = topic
        self.sub = node.create_subscription(
            msg_type, topic, self.callback, qos_profile=qos_profile, **options
        )

    def callback(self, msg: Any) -> None:
        """Pass on a message of the subscription."""
        self.signalMessage(msg)

    def getTopic(self) -> str:  # noqa: N802 - ROS 2's
        """Return the name of the topic as passed to the constructor."""
        return self.topic

    def unsubscribe(self) -> None:
        """Destroy the subscription. This method may be called twice."""
        self.node.destroy_subscription(self.sub)

    def __getattr__(self, name: str) -> Any:
        if name == "sub":  # the subscription does not exist yet
            raise AttributeError(name)
        return getattr(self.sub, name)


class Cache(SimpleFilter):
    """Cache of the most recent messages, with lookups by time.

    Args:
        f: The filter whose messages are kept. The cache also outputs these messages.
        cache_size: Number of messages to keep.
        allow_headerless: Use the present time for a message without a stamp.

    Raises:
        WrongObjectError: `f` is not a filter.
        ArgumentTypeError: `cache_size` is not a number.
    """

    _width = 1

    def __init__(
        self, f: Filter | None = None, cache_size: int = 1, allow_headerless: bool = False
    ) -> None:
        super().__init__()
        check_size("cache_size", cache_size)
        self.cache_size = cache_size
        self.allow_headerless = allow_headerless
        self.cache_msgs: list[Any] = []
        self.cache_times: list[Time] = []
        if f is not None:
            self.connectInput(f)

    def connectInput(self, f: Filter) -> None:  # noqa: N802 - ROS 2's
        """Connect the cache to the filter whose messages are kept."""
        self.incoming_connection = connected("Cache", f, self.add)

    def add(self, msg: Any) -> None:
        """Add a message by its time, and drop the oldest message if there are too many."""
        stamp = stamp_of(msg, self.allow_headerless)
        if stamp is None:
            return
        place = bisect_right([each.nanoseconds for each in self.cache_times], stamp.nanoseconds)
        self.cache_times.insert(place, stamp)
        self.cache_msgs.insert(place, msg)
        if len(self.cache_msgs) > self.cache_size:
            del self.cache_msgs[0], self.cache_times[0]
        self.signalMessage(msg)

    def getInterval(self, from_stamp: Time, to_stamp: Time) -> list[Any]:  # noqa: N802 - ROS 2's
        """Return the messages between two times, including messages at exactly these times."""
        first, last = self._before(from_stamp), self._until(to_stamp)
        return self.cache_msgs[first:last]

    def getElemAfterTime(self, stamp: Time) -> Any:  # noqa: N802 - ROS 2's
        """Return the oldest message at or after a time, or None if there is no such message."""
        return next(iter(self.cache_msgs[self._before(stamp) :]), None)

    def getElemBeforeTime(self, stamp: Time) -> Any:  # noqa: N802 - ROS 2's
        """Return the newest message at or before a time, or None if there is no such message."""
        older = self.cache_msgs[: self._until(stamp)]
        return older[-1] if older else None

    def getLatestTime(self) -> Time | None:  # noqa: N802 - ROS 2's
        """Return the time of the newest message, or None if there is no message."""
        return self.cache_times[-1] if self.cache_times else None

    getLastestTime = getLatestTime  # noqa: N815 - ROS 2's spelling

    def getOldestTime(self) -> Time | None:  # noqa: N802 - ROS 2's
        """Return the time of the oldest message, or None if there is no message."""
        return self.cache_times[0] if self.cache_times else None

    def getLast(self) -> Any:  # noqa: N802 - ROS 2's
        """Return the newest message, or None if there is no message."""
        return self.cache_msgs[-1] if self.cache_msgs else None

    def _before(self, stamp: Time) -> int:
        return bisect_left([each.nanoseconds for each in self.cache_times], stamp.nanoseconds)

    def _until(self, stamp: Time) -> int:
        return bisect_right([each.nanoseconds for each in self.cache_times], stamp.nanoseconds)


class Chain(SimpleFilter):
    """Chain of filters. The output of the last filter is the output of the chain.

    Args:
        message_filter: The filter whose messages are the input.
    """

    def __init__(self, message_filter: Filter | None = None) -> None:
        super().__init__()
        self.incoming_connection: int | None = None
        self._filters: list[Any] = []
        self._last_connection = 0
        if message_filter is not None:
            self.connectInput(message_filter)

    def connectInput(self, message_filter: Filter) -> None:  # noqa: N802 - ROS 2's
        """Connect the chain to the filter whose messages are the input.

        Raises:
            RuntimeError: The chain already has an input.
        """
        if self.incoming_connection is not None:
            raise RuntimeError("Already connected")
        self.incoming_connection = connected("Chain", message_filter, self.add)

    def add(self, message: Any) -> None:
        """Pass a message to the first filter."""
        if self._filters:
            self._filters[0].add(message)
        else:
            self.signalMessage(message)

    def addFilter(self, message_filter: Any) -> None:  # noqa: N802 - ROS 2's
        """Append a filter.

        Raises:
            WrongObjectError: The object is not a filter.
        """
        connection = connected("Chain", message_filter, self.signalMessage)
        if self._filters:
            last = self._filters[-1]
            del last.callbacks[self._last_connection]
            last.registerCallback(message_filter.add)
        self._filters.append(message_filter)
        self._last_connection = connection

    def getFilter(self, index: int) -> Any:  # noqa: N802 - ROS 2's
        """Return a filter by its index.

        Raises:
            KeyError: The index is out of range.
        """
        if not 0 <= index < len(self._filters):
            raise KeyError(index)
        return self._filters[index]


class TimeSynchronizer(SimpleFilter):
    """Synchronizer that outputs one message of each filter if all have the same stamp.

    Args:
        fs: The filters.
        queue_size: Largest number of waiting messages per filter. Older messages are dropped.

    Raises:
        WrongObjectError: `fs` is not a list, or one of its objects is not a filter.
        ArgumentTypeError: `queue_size` is not a number.
    """

    def __init__(self, fs: Sequence[Filter], queue_size: int) -> None:
        super().__init__()
        check_list(type(self).__name__, fs)
        check_size("queue_size", queue_size)
        self.queue_size = queue_size
        # The lock excludes other threads. It is reentrant, because a callback may add a message.
        self.lock = threading.RLock()
        self.connectInput(fs)

    def connectInput(self, fs: Sequence[Filter]) -> None:  # noqa: N802 - ROS 2's
        """Replace the filters whose messages are synchronized.

        Raises:
            WrongObjectError: An object is not a filter.
        """
        self.queues: list[Queue] = [{} for _ in fs]
        self._width = len(self.queues)
        call = type(self).__name__
        self.input_connections = [
            connected(call, each, self.add, queue, index)
            for index, (each, queue) in enumerate(zip(fs, self.queues, strict=True))
        ]

    def add(self, msg: Any, my_queue: Queue, my_queue_index: int | None = None) -> None:  # noqa: ARG002 - used by the subclass
        """Add a message to the queue of its filter, and look for a match."""
        stamp = stamp_of(msg, allow_headerless=False)
        if stamp is None:
            return
        with self.lock:
            self._keep(my_queue, stamp, msg)
            for shared in sorted(set(my_queue).intersection(*self.queues)):
                self.signalMessage(*[queue.pop(shared) for queue in self.queues])

    def _keep(self, queue: Queue, stamp: Time, msg: Any) -> None:
        queue[stamp.nanoseconds] = msg
        while len(queue) > self.queue_size:
            del queue[min(queue)]


class ApproximateTimeSynchronizer(TimeSynchronizer):
    """Synchronizer that outputs one message of each filter if their stamps are close together.

    Args:
        fs: The filters.
        queue_size: Largest number of waiting messages per filter. Older messages are dropped.
        slop: Seconds. The difference of the stamps is smaller. Equal stamps always fit.
        allow_headerless: Use the present time for a message without a stamp.
        sync_arrival_time: Use the times at which messages arrive instead of their stamps.

    Raises:
        WrongObjectError: `fs` is not a list, or one of its objects is not a filter.
        ArgumentTypeError: `queue_size` or `slop` is not a number.
    """

    def __init__(
        self,
        fs: Sequence[Filter],
        queue_size: int,
        slop: float,
        allow_headerless: bool = False,
        sync_arrival_time: bool = False,
    ) -> None:
        check_number("slop", slop, "seconds, e.g. 0.1")
        self.slop = Duration(seconds=slop)
        self.allow_headerless = allow_headerless
        self.sync_arrival_time = sync_arrival_time
        super().__init__(fs, queue_size)

    def add(self, msg: Any, my_queue: Queue, my_queue_index: int | None = None) -> None:
        """Add a message to the queue of its filter, and look for a match."""
        arrived = ROSClock().now() if self.sync_arrival_time else None
        stamp = arrived or stamp_of(msg, self.allow_headerless)
        if stamp is None:
            return
        with self.lock:
            self._keep(my_queue, stamp, msg)
            if stamp.nanoseconds in my_queue:  # otherwise it was dropped as the oldest
                self._match(stamp.nanoseconds, my_queue if my_queue_index is not None else None)

    def _match(self, stamp_ns: int, own: Queue | None) -> None:
        slop_ns = self.slop.nanoseconds
        candidates = [
            [stamp_ns] if queue is own else _within_slop(queue, stamp_ns, slop_ns)
            for queue in self.queues
        ]
        for stamps in itertools.product(*candidates):
            if _is_within(max(stamps) - min(stamps), slop_ns):
                pairs = zip(self.queues, stamps, strict=True)
                self.signalMessage(*[queue.pop(each) for queue, each in pairs])
                return


def _is_within(difference_ns: int, slop_ns: int) -> bool:
    """Return whether stamps are together. As in ROS 2, a difference of exactly the slop is not."""
    return difference_ns < slop_ns or difference_ns == 0


def _within_slop(queue: Iterable[int], stamp_ns: int, slop_ns: int) -> list[int]:
    """Return the stamps that are within the slop. The closest stamp comes first."""
    near = (each for each in queue if _is_within(abs(each - stamp_ns), slop_ns))
    return sorted(near, key=lambda each: abs(each - stamp_ns))


def stamp_of(msg: Any, allow_headerless: bool) -> Time | None:
    """Return a message's stamp, or the present time if allowed, or None after a warning."""
    stamp = getattr(getattr(msg, "header", None), "stamp", None)
    if stamp is not None:
        return stamp if hasattr(stamp, "nanoseconds") else Time.from_msg(stamp)
    if allow_headerless:
        return ROSClock().now()
    warn_once(
        f"messages of the type {type(msg).__name__} have no header.stamp and are dropped: filters "
        "compare the times of messages. Send a type with a header. For the time of arrival, write "
        "allow_headerless=True for a Cache or an ApproximateTimeSynchronizer."
    )
    return None
