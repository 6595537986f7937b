"""Tests of the queue between Zenoh's queue of samples and the executor's thread."""

from __future__ import annotations

import threading
from dataclasses import dataclass, field
from itertools import islice
from types import SimpleNamespace
from typing import Any

import pytest
import zenoh

from tests.unit.node.fakes import Channel
from zbot.node import sample_queue as module
from zbot.node.sample_queue import LatchedChannel, SampleQueue


@dataclass
class Notifier:
    """Zenoh subscriber that calls a function for each sample."""

    handler: Any
    is_declared: bool = True

    def undeclare(self) -> None:
        self.is_declared = False


@dataclass
class Topic:
    """A queue of samples, Zenoh's queue and notifiers, and the posts to the executor."""

    depth: int | None = None
    batch: int = 100
    channel: Channel = field(default_factory=Channel)
    notifiers: list[Notifier] = field(default_factory=list)
    posts: int = 0
    missed: list[Any] = field(default_factory=list)  # samples that come during a declaration

    def __post_init__(self) -> None:
        self.queue = SampleQueue(
            *(self.channel,),
            depth=self.depth,
            batch=self.batch,
            post=self.post,
            declare=self.declare,
        )
        self.queue.start()
        self.posts = 0

    def post(self) -> None:
        self.posts += 1

    def declare(self, handler: Any) -> Notifier:
        self.channel.samples.extend(self.missed)
        self.missed.clear()
        self.notifiers.append(Notifier(handler))
        return self.notifiers[-1]

    @property
    def is_notified(self) -> bool:
        return [each.is_declared for each in self.notifiers].count(True) == 1

    def come(self, *samples: Any) -> None:
        """Let samples come as from Zenoh's network thread."""
        for sample in samples:
            self.channel.samples.append(sample)
            self.tell()

    def tell(self) -> None:
        for notifier in self.notifiers:
            if notifier.is_declared:
                notifier.handler.callback("sample")

    def taken(self, count: int | None = None) -> list[Any]:
        return list(islice(iter(self.queue.take, None), count))


def test_keep_last_drops_the_oldest_samples() -> None:
    topic = Topic(depth=3)
    topic.come(*range(8))
    assert topic.taken() == [5, 6, 7]


def test_keep_all_keeps_every_sample_in_order() -> None:
    topic = Topic(batch=7)
    topic.come(*range(300))
    assert topic.taken() == list(range(300))


def test_a_keep_all_queue_leaves_samples_in_zenohs_queue_while_it_has_some() -> None:
    topic = Topic(batch=3)
    topic.come(*range(8))
    left = []
    for expected in (0, 1, 2):
        assert topic.taken(1) == [expected]
        left.append(len(topic.channel.samples))
    assert left == [5, 5, 5]
    assert topic.taken(1) == [3]
    assert len(topic.channel.samples) == 2


def test_a_queue_is_true_if_there_is_a_sample_and_keeps_it() -> None:
    topic = Topic()
    topic.come("a", "b")
    assert topic.taken(1) == ["a"]
    assert bool(topic.queue)
    assert bool(topic.queue)
    assert topic.taken() == ["b"]
    assert not topic.queue


def test_each_rare_sample_is_told_once() -> None:
    topic = Topic()
    for number in range(5):
        topic.come(number)
        assert topic.posts == number + 1
        assert topic.taken() == [number]
    assert topic.is_notified
    assert len(topic.notifiers) == 1


def test_a_burst_costs_two_posts_and_no_more_calls_from_zenoh() -> None:
    topic = Topic()
    topic.come(*range(5))
    assert topic.posts == 2
    assert topic.queue.is_watched
    assert not topic.is_notified
    assert topic.taken() == list(range(5))
    assert topic.is_notified
    topic.come("next")
    assert topic.posts == 3


def test_a_sample_that_comes_before_the_notifier_is_not_lost() -> None:
    topic = Topic()
    topic.come("a", "b")
    topic.missed.append("c")
    assert topic.taken() == ["a", "b", "c"]
    assert topic.is_notified


@pytest.mark.parametrize("comes_at", [0, 1, 2])
def test_a_sample_that_comes_after_its_notification_is_looked_for(
    comes_at: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    now = 0
    monkeypatch.setattr(module, "time", SimpleNamespace(monotonic_ns=lambda: now))
    topic = Topic()
    topic.tell()
    assert topic.taken() == []
    for _ in range(comes_at):
        assert topic.queue.due_ns is not None
        now = topic.queue.due_ns
        assert topic.taken() == []
    assert topic.queue.due_ns is not None
    topic.channel.samples.append("late")
    assert topic.taken() == ["late"]


@pytest.mark.parametrize("is_changing", [False, True], ids=["", "while the notifier changes"])
def test_a_late_sample_behind_another_is_looked_for(
    monkeypatch: pytest.MonkeyPatch, is_changing: bool
) -> None:
    now = 0
    monkeypatch.setattr(module, "time", SimpleNamespace(monotonic_ns=lambda: now))
    topic = Topic()
    topic.come("a")
    if is_changing:
        monkeypatch.setattr(topic.queue, "_switching", Switching(is_free=False))
    topic.tell()
    monkeypatch.setattr(topic.queue, "_switching", threading.Lock())
    assert topic.taken() == ["a"]
    assert topic.queue.due_ns is not None
    topic.channel.samples.append("b")
    now = topic.queue.due_ns
    assert topic.taken() == ["b"]


class Switching:
    """Lock of a queue, before which something else happens."""

    def __init__(self, *, is_free: bool, before: Any = bool) -> None:
        self.is_free, self.before = is_free, before

    def acquire(self, *, blocking: bool) -> bool:
        assert not blocking
        self.before()
        return self.is_free

    def release(self) -> None:
        assert self.is_free


def test_an_executor_that_fell_asleep_before_the_notifier_ended_is_woken(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    topic = Topic()
    topic.come("a")
    taken: list[Any] = []
    lock = Switching(is_free=True, before=lambda: taken.extend(topic.taken()))
    monkeypatch.setattr(topic.queue, "_switching", lock)
    topic.posts = 0
    topic.tell()
    assert taken == ["a"]
    assert topic.queue.is_watched
    assert topic.posts == 1


def test_a_sample_that_was_under_way_when_the_notifier_began_is_looked_for() -> None:
    topic = Topic()
    topic.come("a", "b")
    assert topic.taken() == ["a", "b"]
    assert topic.is_notified
    assert topic.queue.due_ns is not None


def test_an_empty_queue_is_not_looked_at_for_ever() -> None:
    topic = Topic()
    topic.tell()
    for _ in range(10):
        assert topic.taken() == []
    assert topic.queue.due_ns is None


def test_samples_before_the_start_are_told_of() -> None:
    posts = list[str]()
    samples = SampleQueue(
        Channel(), depth=1, batch=1, post=lambda: posts.append("post"), declare=Notifier
    )
    assert posts == []
    samples.start()
    assert posts == ["post"]


def test_the_end_ends_the_notifier_and_tells_nobody() -> None:
    topic = Topic()
    notifier = topic.notifiers[0]
    topic.queue.end()
    topic.queue.end()
    assert not notifier.is_declared
    notifier.handler.callback("under way")
    assert topic.posts == 0
    assert topic.taken() == []
    assert len(topic.notifiers) == 1


def test_a_queue_of_a_closed_session_is_not_looked_at_again(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    def closed() -> Any:
        raise zenoh.ZError("the channel is closed")

    topic = Topic()
    topic.tell()
    assert topic.taken() == []
    assert topic.queue.due_ns is not None
    monkeypatch.setattr(topic.queue, "next_sample", closed)
    assert topic.taken() == []
    assert topic.queue.due_ns is None


def test_the_end_waits_for_a_declaration_of_the_notifier() -> None:
    topic = Topic()
    topic.come("a", "b")  # ends the notifier
    ending = threading.Thread(target=topic.queue.end)
    is_waiting: list[bool] = []

    def declare(handler: Any) -> Notifier:
        ending.start()
        ending.join(0.1)
        is_waiting.append(ending.is_alive())
        topic.notifiers.append(Notifier(handler))
        return topic.notifiers[-1]

    topic.queue._declare = declare
    assert topic.taken() == ["a", "b"]
    ending.join()
    assert is_waiting == [True]
    assert [notifier.is_declared for notifier in topic.notifiers] == [False, False]


# -- channels that tell of past samples ------------------------------------------------------------


def test_a_latched_channel_tells_of_each_sample_and_drops_the_oldest() -> None:
    posts = list[str]()
    channel: Any = LatchedChannel(2, blocks=False)
    channel.post = lambda: posts.append("post")
    samples = SampleQueue(channel, depth=2, batch=10, post=bool)
    samples.start()
    for number in range(5):
        channel.receive(number)
    assert len(posts) == 5
    kept: list[Any] = list(iter(samples.take, None))
    assert kept == [3, 4]


def test_a_full_latched_channel_blocks_until_a_sample_is_taken() -> None:
    channel: Any = LatchedChannel(2, blocks=True)
    receiving = threading.Thread(target=lambda: list(map(channel.receive, range(3))))
    receiving.start()
    taken = list[Any]()
    while len(taken) < 3:
        taken += [each for each in [channel.try_recv()] if each is not None]
    receiving.join(10)
    assert taken == [0, 1, 2]


class EndingChannel(LatchedChannel):
    """Latched channel that another thread ends just after each look at its room."""

    _kept: Any

    @property
    def _room(self) -> Any:
        room, self._kept = self._kept, None
        return room

    @_room.setter
    def _room(self, room: Any) -> None:
        self._kept = room


@pytest.mark.parametrize("first", ["receive", "try_recv"])
def test_the_end_of_a_latched_channel_may_come_during_a_call(first: str) -> None:
    channel: Any = EndingChannel(1, blocks=True)
    channel._samples.append("old")
    if first == "receive":
        channel.receive("new")
    assert channel.try_recv() == "old"


def test_the_end_of_a_latched_channel_lets_zenohs_thread_go_on() -> None:
    channel: Any = LatchedChannel(1, blocks=True)
    channel.receive("a")
    receiving = threading.Thread(target=lambda: list(map(channel.receive, range(3))))
    receiving.start()
    channel.end()
    receiving.join(10)
    assert not receiving.is_alive()
