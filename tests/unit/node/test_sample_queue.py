"""Tests of the queue between Zenoh's queue of samples and the executor's thread."""

from __future__ import annotations

import queue
import threading
from itertools import islice
from typing import Any

import pytest
import zenoh

from tests.unit.node.fakes import Channel
from zbot.node.sample_queue import SampleQueue


def queue_of(*samples: Any, depth: int | None, batch: int = 100) -> SampleQueue:
    """Return a queue after the first sample of a burst has come."""
    channel = Channel()
    made = SampleQueue(channel, depth=depth, batch=batch, post=bool)
    made.end()  # so that `listen` returns after the first sample
    channel.samples.extend(samples)
    made.listen()
    return made


def all_of(samples: SampleQueue, count: int | None = None) -> list[Any]:
    """Take all samples, or some of them."""
    return list(islice(iter(samples.take, None), count))


def test_keep_last_drops_the_oldest_samples() -> None:
    assert all_of(queue_of(*range(8), depth=3)) == [5, 6, 7]


def test_keep_all_keeps_every_sample_in_order() -> None:
    assert all_of(queue_of(*range(300), depth=None, batch=7)) == list(range(300))


def test_a_keep_all_queue_leaves_samples_in_zenohs_queue_while_it_has_some() -> None:
    channel = Channel()
    samples = SampleQueue(channel, depth=None, batch=3, post=bool)
    samples.end()
    channel.samples.extend(range(8))
    samples.listen()
    left = []
    for expected in (0, 1, 2):
        assert all_of(samples, 1) == [expected]
        left.append(len(channel.samples))
    assert left == [7, 4, 4]


def test_a_queue_is_true_if_there_is_a_sample_and_keeps_it() -> None:
    samples = queue_of("a", "b", depth=None)
    assert all_of(samples, 1) == ["a"]
    assert bool(samples)
    assert bool(samples)
    assert all_of(samples) == ["b"]
    assert not samples


def test_nothing_is_taken_from_zenohs_queue_before_a_burst_begins() -> None:
    channel = Channel()
    channel.samples.append("first")
    samples = SampleQueue(channel, depth=1, batch=1, post=bool)
    assert samples.take() is None
    assert list(channel.samples) == ["first"]


class Waiting(queue.Queue[Any]):
    """Channel whose `recv` waits. `None` closes it."""

    def recv(self) -> Any:
        sample = self.get(timeout=10)
        if sample is None:
            raise zenoh.ZError("the channel is closed")
        return sample

    def try_recv(self) -> Any:
        return None if self.empty() else self.get_nowait()


@pytest.fixture
def waiting() -> Waiting:
    return Waiting()


def listening(samples: SampleQueue) -> threading.Thread:
    thread = threading.Thread(target=samples.listen)
    thread.start()
    return thread


def test_a_burst_costs_one_post(waiting: Waiting) -> None:
    posts: queue.SimpleQueue[str] = queue.SimpleQueue()
    samples = SampleQueue(waiting, depth=None, batch=10, post=lambda: posts.put("post"))
    thread = listening(samples)
    for burst in range(3):
        for number in range(5):
            waiting.put(f"{burst}.{number}")
        posts.get(timeout=10)
        taken = list[Any]()
        while len(taken) < 5:
            taken += filter(None, [samples.take()])
        assert taken == [f"{burst}.{number}" for number in range(5)]
        while samples.is_watched:  # until the thread waits again
            assert samples.take() is None
        assert posts.empty()
    waiting.put(None)
    thread.join(10)
    assert not thread.is_alive()


def test_the_end_wakes_a_thread_that_waits_for_the_executor(waiting: Waiting) -> None:
    posted = threading.Event()
    samples = SampleQueue(waiting, depth=1, batch=1, post=posted.set)
    thread = listening(samples)
    waiting.put("sample")
    assert posted.wait(10)
    samples.end()
    samples.end()
    thread.join(10)
    assert not thread.is_alive()


def test_a_channel_that_was_closed_has_no_more_samples() -> None:
    class Closed(Channel):
        def try_recv(self) -> Any:
            raise zenoh.ZError("the channel is closed")

    channel = Closed()
    samples = SampleQueue(channel, depth=1, batch=1, post=bool)
    samples.is_watched = True
    assert samples.take() is None
