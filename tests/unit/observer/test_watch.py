"""Tests of the messages that a page reads."""

from __future__ import annotations

import threading
from typing import Any

from tests.conftest import wait_until
from zbot.observer.watch import Feed


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
