"""Tests of the messages that a page reads."""

from __future__ import annotations

import threading
import time
from typing import TYPE_CHECKING, Any

from tests.conftest import wait_until
from zbot.observer.watch import Feed, Watch
from zbot.threads.deadline import Deadline

if TYPE_CHECKING:
    import pytest


def nothing(_feed: Feed) -> None:
    """Do nothing at a change of the watches."""


def feed_of(threads: list[threading.Thread]) -> Feed:
    """Return a feed that notes the thread of each decoding."""

    def decode(payload: bytes) -> int:
        threads.append(threading.current_thread())
        return len(payload)

    feed = Feed("/a", "std_msgs/msg/String", nothing, nothing)
    feed.decode = decode
    return feed


def take(feed: Feed, size: int) -> None:
    info: Any = {"source_timestamp": 1, "received_timestamp": 2}
    feed.take(bytes(size), info)


def test_a_small_message_is_decoded_at_once() -> None:
    threads: list[threading.Thread] = []
    feed = feed_of(threads)
    take(feed, 100)
    assert feed.latest()[1] == 100
    assert threads == [threading.current_thread()]


def test_a_page_does_not_wait_for_a_large_message() -> None:
    threads: list[threading.Thread] = []
    feed = feed_of(threads)
    take(feed, 1_000_000)
    feed.latest()
    assert wait_until(lambda: feed.latest()[1] == 1_000_000)
    assert threads[0] is not threading.current_thread()
    record, _ = feed.latest()
    assert record is not None
    assert len(record.payload) == 1_000_000


def numbers(feed: Feed, after: int, seconds: float) -> list[int]:
    return [record.number for record, _ in feed.read_since(after, Deadline(seconds))]


def keeping(feed: Feed) -> Feed:
    Watch(feed, keep=100, is_active=True, forget=nothing)
    return feed


def test_kept_messages_are_read_until_the_deadline_but_at_least_one() -> None:
    feed = keeping(feed_of([]))
    for _ in range(5):
        take(feed, 100)
    assert numbers(feed, 0, 60) == [1, 2, 3, 4, 5]
    assert numbers(feed, 3, 60) == [4, 5]
    assert numbers(feed, 0, 0) == [1]
    assert numbers(feed, 1, 0) == [2]
    assert numbers(feed, 5, 60) == []


def test_after_a_message_that_takes_long_the_newest_follows_from_a_thread() -> None:
    threads: list[threading.Thread] = []
    feed = keeping(feed_of(threads))
    take(feed, 100)
    assert numbers(feed, 0, 60) == [1]
    feed._seconds_for_byte = 1e-6
    threads.clear()
    for _ in range(3):
        take(feed, 1_000_000)
    assert wait_until(lambda: numbers(feed, 1, 60) == [4])
    assert threads
    assert threading.current_thread() not in threads
    assert numbers(feed, 4, 60) == []


def test_no_message_is_left_out_while_the_time_of_decoding_is_unknown() -> None:
    feed = keeping(feed_of([]))
    for _ in range(3):
        take(feed, 1_000_000)
    assert numbers(feed, 0, 60) == []
    assert wait_until(lambda: numbers(feed, 0, 60) == [1, 2, 3])


def test_a_new_type_forgets_the_messages_of_the_former_one() -> None:
    feed = keeping(feed_of([]))
    decode = feed.decode
    feed.set_type("a/msg/A")
    feed.decode = decode
    take(feed, 100)
    assert feed.latest()[1] == 100
    feed.set_type(None)
    feed.set_type("a/msg/A")
    assert feed.latest()[1] == 100
    feed.set_type("a/msg/B")
    assert feed.latest() == (None, None)
    assert not feed.since(0)
    feed.decode = decode
    take(feed, 200)
    assert feed.latest()[1] == 200


def test_a_small_message_is_not_left_out_after_a_slow_first_one(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    feed = keeping(feed_of([]))
    times = iter([0.0, 5.0, 5.0, 5.0, 5.0, 5.0])
    monkeypatch.setattr(time, "thread_time", lambda: next(times))
    for _ in range(3):
        take(feed, 100)
    assert numbers(feed, 0, 60) == [1, 2, 3]
