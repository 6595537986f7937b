"""Tests of message_filters: synchronizers, caches and chains."""

from __future__ import annotations

import itertools
import threading
from typing import TYPE_CHECKING, Any

import pytest

import zbot
from zbot.libraries.message_filter import (
    ApproximateTimeSynchronizer,
    Cache,
    Chain,
    SimpleFilter,
    Subscriber,
    TimeSynchronizer,
)
from zbot.time import Duration, Time

from geometry_msgs.msg import PointStamped
from std_msgs.msg import Bool, Empty, Header, String

if TYPE_CHECKING:
    from tests.conftest import MakeContext
    from zbot.log.record import Record


def at(seconds: float) -> PointStamped:
    return PointStamped(header=Header(stamp=Time(seconds=seconds).to_msg()))


def pair() -> tuple[SimpleFilter, SimpleFilter]:
    return SimpleFilter(), SimpleFilter()


def test_callbacks_get_the_message_and_their_own_arguments() -> None:
    source, seen = SimpleFilter(), list[Any]()
    source.registerCallback(lambda *given: seen.append(given), "a")
    source.registerCallback(lambda *given: seen.append(given), "b", "c")
    source.signalMessage(1, 2)
    assert seen == [(1, 2, "a"), (1, 2, "b", "c")]


@pytest.mark.parametrize("order", list(itertools.permutations(range(3))))
def test_equal_stamps_meet_in_any_order(order: tuple[int, ...]) -> None:
    left, right = pair()
    seen: list[tuple[Any, Any]] = []
    TimeSynchronizer([left, right], 3).registerCallback(lambda *both: seen.append(both))
    lefts, rights = [at(s) for s in range(3)], [at(s) for s in range(3)]
    for index in order:
        left.signalMessage(lefts[index])
    assert seen == []
    for index in reversed(order):
        right.signalMessage(rights[index])
    assert {(id(a), id(b)) for a, b in seen} == {
        (id(a), id(b)) for a, b in zip(lefts, rights, strict=True)
    }


def test_messages_that_wait_too_long_are_dropped() -> None:
    left, right = pair()
    seen: list[Any] = []
    TimeSynchronizer([left, right], 2).registerCallback(lambda *both: seen.append(both))
    for seconds in range(4):
        left.signalMessage(at(seconds))
    for seconds in range(4):
        right.signalMessage(at(seconds))
    assert [both[0].header.stamp.sec for both in seen] == [2, 3]


def test_a_callback_may_feed_the_synchronizer_that_called_it() -> None:
    left, right = pair()
    seen: list[Any] = []
    synchronizer = TimeSynchronizer([left, right], 5)

    def feed(*both: Any) -> None:
        seen.append(both[0])
        if len(seen) == 1:
            left.signalMessage(at(9))
            right.signalMessage(at(9))

    synchronizer.registerCallback(feed)
    left.signalMessage(at(1))
    thread = threading.Thread(target=right.signalMessage, args=[at(1)], daemon=True)
    thread.start()
    thread.join(60)
    assert [each.header.stamp.sec for each in seen] == [1, 9]


@pytest.mark.parametrize(
    ("times", "is_together"),
    [((1.0, 1.05), True), ((1.0, 1.1), False), ((1.0, 1.2), False), ((2.0, 1.95), True)],
)
def test_stamps_within_the_slop_meet(times: tuple[float, float], is_together: bool) -> None:
    left, right = pair()
    seen: list[Any] = []
    ApproximateTimeSynchronizer([left, right], 5, 0.1).registerCallback(
        lambda *both: seen.append(both)
    )
    left.signalMessage(at(times[0]))
    right.signalMessage(at(times[1]))
    assert bool(seen) is is_together


def test_equal_stamps_meet_without_any_slop() -> None:
    left, right = pair()
    seen: list[Any] = []
    ApproximateTimeSynchronizer([left, right], 5, 0.0).registerCallback(
        lambda *both: seen.append(both)
    )
    left.signalMessage(at(1.0))
    right.signalMessage(at(1.0))
    assert len(seen) == 1


def test_the_nearest_message_is_used_once() -> None:
    left, right = pair()
    seen: list[tuple[Any, Any]] = []
    ApproximateTimeSynchronizer([left, right], 5, 0.5).registerCallback(
        lambda *both: seen.append(both)
    )
    near, far = at(1.1), at(0.7)
    left.signalMessage(far)
    left.signalMessage(near)
    right.signalMessage(at(1.0))
    assert seen[0][0] is near
    right.signalMessage(at(1.05))
    assert seen[1][0] is far


def test_all_of_three_are_within_the_slop_of_each_other() -> None:
    filters = [SimpleFilter() for _ in range(3)]
    seen: list[Any] = []
    ApproximateTimeSynchronizer(filters, 5, 0.1).registerCallback(lambda *all_: seen.append(all_))
    for source, seconds in zip(filters, (1.0, 1.16, 1.08), strict=True):
        source.signalMessage(at(seconds))
    assert seen == []  # the outer two are too far apart, though both are near the third
    filters[1].signalMessage(at(1.05))
    assert len(seen) == 1


def test_messages_without_header_need_the_option() -> None:
    for allowed in (True, False):
        left, right = pair()
        seen: list[Any] = []
        synchronizer = ApproximateTimeSynchronizer([left, right], 5, 60, allow_headerless=allowed)
        synchronizer.registerCallback(lambda *both, seen=seen: seen.append(both))
        left.signalMessage(String(data="a"))
        right.signalMessage(String(data="b"))
        assert bool(seen) is allowed


def test_a_cache_keeps_the_newest_sorted_by_time() -> None:
    source = SimpleFilter()
    cache = Cache(source, 3)
    passed: list[Any] = []
    cache.registerCallback(passed.append)
    for seconds in (4, 1, 3, 2):
        source.signalMessage(at(seconds))
    assert [m.header.stamp.sec for m in passed] == [4, 1, 3, 2]
    assert [m.header.stamp.sec for m in cache.cache_msgs] == [2, 3, 4]

    def second(message: Any) -> Any:
        return message and message.header.stamp.sec

    assert second(cache.getElemAfterTime(Time(seconds=2.5))) == 3
    assert second(cache.getElemBeforeTime(Time(seconds=2.5))) == 2
    assert cache.getElemAfterTime(Time(seconds=5)) is cache.getElemBeforeTime(Time()) is None
    assert list(map(second, cache.getInterval(Time(seconds=2), Time(seconds=3)))) == [2, 3]
    assert second(cache.getLast()) == 4
    assert cache.getOldestTime() is not None
    assert cache.getLatestTime() == cache.getLastestTime()


def test_an_empty_cache_returns_none() -> None:
    cache = Cache()
    assert cache.getLast() is cache.getOldestTime() is cache.getLatestTime() is None


def test_a_chain_passes_messages_through_its_filters() -> None:
    source, out = SimpleFilter(), list[Any]()
    chain = Chain(source)
    chain.registerCallback(out.append)
    source.signalMessage(at(0))
    first, second = Cache(cache_size=9), Cache(cache_size=9)
    chain.addFilter(first)
    source.signalMessage(at(1))
    chain.addFilter(second)
    source.signalMessage(at(2))
    assert [m.header.stamp.sec for m in out] == [0, 1, 2]
    assert (len(first.cache_msgs), len(second.cache_msgs)) == (2, 1)
    assert chain.getFilter(1) is second
    with pytest.raises(KeyError):
        chain.getFilter(2)
    with pytest.raises(RuntimeError, match="connected"):
        chain.connectInput(source)


def test_messages_without_header_are_told_once_for_each_type(logged: list[Record]) -> None:
    left, right = pair()
    synchronizers = [TimeSynchronizer([left, right], 5), Cache(left)]
    for message in (Empty(), Empty(), Bool(), Empty()):
        left.signalMessage(message)
    assert [line.message.partition(" have")[0] for line in logged] == [
        "messages of the type Empty",
        "messages of the type Bool",
    ]
    assert len(synchronizers) == 2


def test_a_subscriber_without_an_argument_says_which_one_is_missing() -> None:
    for arguments, sentence in (
        ((String, "a"), r"not given its node: write Subscriber\(self, String, 'a'\)"),
        ((String, "a", 10), r"not given its node: write Subscriber\(self, String, 'a'\)"),
        (("node", "a"), r"class of the messages: write Subscriber\(self, Image, 'node'\)"),
        ((object(), String), r"its topic: write Subscriber\(self, String, 'camera'\)"),
    ):
        given: Any = arguments
        with pytest.raises(TypeError, match=sentence):
            Subscriber(*given)


def test_what_is_not_a_filter_is_refused_as_an_input() -> None:
    for connect in (Cache, Chain, Chain().addFilter, lambda f: TimeSynchronizer([f], 10)):
        make: Any = connect
        with pytest.raises(AttributeError, match="needs a filter, not str: 'camera': write"):
            make("camera")
        with pytest.raises(TypeError, match="needs a filter, not the class SimpleFilter"):
            make(SimpleFilter)


def test_a_plain_subscription_is_refused_with_the_subscriber_to_write(
    make_context: MakeContext,
) -> None:
    node = zbot.Node("camera", context=make_context())
    plain: Any = node.create_subscription(String, "image", print, 10)
    with pytest.raises(AttributeError, match=r"Subscriber\(self, String, '/image'\)"):
        TimeSynchronizer([SimpleFilter(), plain], 10)
    node.destroy_node()


def test_filters_that_are_not_in_a_list_are_refused() -> None:
    exact: Any = TimeSynchronizer
    close: Any = ApproximateTimeSynchronizer
    for make, arguments in (
        (exact, (SimpleFilter(), 10)),
        (close, (*pair(), 10, 0.1)),
    ):
        with pytest.raises(TypeError, match=r"TimeSynchronizer\(\[a, b\], \.\.\.\)"):
            make(*arguments)


def test_a_callback_must_take_one_message_of_each_filter() -> None:
    synchronizer = ApproximateTimeSynchronizer(pair(), 10, 0.1)
    with pytest.raises(RuntimeError, match=r"takes \(message1, message2\), but the lambda"):
        synchronizer.registerCallback(lambda _: None)
    with pytest.raises(RuntimeError, match=r"takes \(message, argument\), but"):
        Cache().registerCallback(lambda _: None, "name")
    assert synchronizer.registerCallback(lambda *_: None) == 0


def test_a_filter_of_a_program_may_output_what_it_likes() -> None:
    class Counter(Cache):
        def add(self, msg: Any) -> None:
            self.signalMessage(msg, len(self.callbacks))

    counter, seen = Counter(), list[Any]()
    counter.registerCallback(lambda message, count: seen.append((message, count)))
    counter.add("a")
    assert seen == [("a", 1)]


def test_numbers_of_filters_are_checked_by_their_names(logged: list[Record]) -> None:
    wrong: Any = "0.1"
    with pytest.raises(TypeError, match="slop must be a number of seconds"):
        ApproximateTimeSynchronizer(pair(), 10, wrong)
    with pytest.raises(TypeError, match="slop must be a number of seconds"):
        ApproximateTimeSynchronizer(pair(), 10, Duration(seconds=1))  # type: ignore[arg-type]
    with pytest.raises(TypeError, match="queue_size must be a number of messages"):
        TimeSynchronizer(pair(), wrong)
    with pytest.raises(TypeError, match="cache_size must be a number of messages"):
        Cache(cache_size=wrong)
    swapped: Any = 0.1
    ApproximateTimeSynchronizer(pair(), swapped, 10)
    assert "queue_size is 0.1, so a filter keeps no message" in logged[0].message
