from __future__ import annotations

from typing import TYPE_CHECKING

import pytest

from zbot.web.rosbridge import outbox as outbox_module
from zbot.web.rosbridge.outbox import DEFAULT_QUEUE_LENGTH, MAX_REPLIES, Outbox, TopicQueue

if TYPE_CHECKING:
    from zbot.web.rosbridge.frame import Frame


def encode(payload: bytes) -> list[Frame]:
    return [payload.decode()]


class Clock:
    def __init__(self) -> None:
        self.now = 100.0

    def __call__(self) -> float:
        return self.now


@pytest.fixture
def clock() -> Clock:
    return Clock()


@pytest.fixture
def outbox(clock: Clock) -> Outbox:
    return Outbox(lambda: None, clock)


def filled(outbox: Outbox, queue: TopicQueue, count: int) -> TopicQueue:
    outbox.add(queue)
    for number in range(count):
        outbox.put(queue, str(number).encode())
    return queue


def test_responses_come_first_and_topics_in_turn(outbox: Outbox) -> None:
    filled(outbox, TopicQueue(lambda payload: [f"a{payload.decode()}"]), 2)
    filled(outbox, TopicQueue(lambda payload: [f"b{payload.decode()}"]), 2)
    outbox.reply(["response"])
    batch = outbox.take()
    assert batch.frames == ["response", "a0", "b0", "a1", "b1"]
    assert batch.delay_s is None


def test_a_slow_client_keeps_the_newest_messages(outbox: Outbox) -> None:
    queue = filled(outbox, TopicQueue(encode, queue_length=3), 10)
    assert queue.dropped == 7
    assert outbox.take().frames == ["7", "8", "9"]


def test_without_queue_length_the_queue_has_a_limit_too(outbox: Outbox) -> None:
    queue = filled(outbox, TopicQueue(encode), DEFAULT_QUEUE_LENGTH + 5)
    assert queue.dropped == 5
    assert len(queue.payloads) == DEFAULT_QUEUE_LENGTH


def test_without_a_queue_messages_that_come_too_early_are_dropped(
    outbox: Outbox, clock: Clock
) -> None:
    queue = filled(outbox, TopicQueue(encode, period_s=1.0), 3)
    assert outbox.take().frames == ["0"]
    clock.now += 1.0
    outbox.put(queue, b"later")
    assert outbox.take().frames == ["later"]


def test_with_a_queue_messages_wait_for_their_time(outbox: Outbox, clock: Clock) -> None:
    filled(outbox, TopicQueue(encode, period_s=1.0, queue_length=5), 2)
    batch = outbox.take()
    assert (batch.frames, batch.delay_s) == (["0"], 1.0)
    clock.now += 0.75
    batch = outbox.take()
    assert (batch.frames, batch.delay_s) == ([], 0.25)
    clock.now += 0.25
    assert outbox.take().frames == ["1"]


def test_all_topics_together_have_a_limit(outbox: Outbox, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(outbox_module, "MAX_TOPIC_BYTES", 10)
    first, second = TopicQueue(encode), TopicQueue(encode)
    outbox.add(first)
    outbox.add(second)
    for _ in range(3):
        outbox.put(first, b"1234")
    assert (len(first.payloads), first.dropped) == (2, 1)
    outbox.put(second, b"1234")
    assert (len(second.payloads), second.dropped) == (0, 1)
    outbox.take()
    outbox.put(second, b"x" * 50)
    assert outbox.take().frames == ["x" * 50]


def test_a_removed_topic_sends_nothing(outbox: Outbox) -> None:
    queue = filled(outbox, TopicQueue(encode), 2)
    outbox.remove(queue)
    outbox.remove(queue)
    outbox.put(queue, b"late")
    assert outbox.take().frames == []


def test_too_many_responses_end_the_client(outbox: Outbox) -> None:
    for _ in range(MAX_REPLIES):
        outbox.reply(["x"])
    assert not outbox.is_overrun
    outbox.reply(["x"])
    assert outbox.is_overrun


def test_a_large_response_is_sent_if_nothing_else_waits(
    outbox: Outbox, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(outbox_module, "MAX_REPLY_BYTES", 10)
    outbox.reply(["x" * 50])
    assert not outbox.is_overrun
    assert outbox.take().frames == ["x" * 50]
