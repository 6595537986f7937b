from __future__ import annotations

import threading
from dataclasses import dataclass

import pytest

from zbot.threads import wakeup as module
from zbot.threads.wakeup import LARGE_MESSAGE_WAIT_NS, Activity, BinarySemaphore, BusyWait


def test_a_wait_returns_if_the_semaphore_was_set_before() -> None:
    semaphore = BinarySemaphore()
    semaphore.set()
    semaphore.set()
    assert semaphore.wait(0)
    assert not semaphore.wait(0)


def test_a_wait_ends_when_another_thread_sets() -> None:
    semaphore = BinarySemaphore()
    setter = threading.Timer(0.05, semaphore.set)
    setter.start()
    while not semaphore.wait(10):
        pass  # it waits in slices
    setter.join()


def test_a_busy_wait_ends_when_another_thread_sets() -> None:
    semaphore, answer = BinarySemaphore(), BinarySemaphore()

    def reply() -> None:
        for _ in range(200):
            while not semaphore.wait(10):
                pass
            answer.set()

    replier = threading.Thread(target=reply)
    replier.start()
    for _ in range(200):
        semaphore.set()
        while not answer.wait(10):
            pass
    replier.join()


@dataclass
class Clock:
    now_us: int = 0

    def monotonic_ns(self) -> int:
        return self.now_us * 1000


@pytest.fixture
def clock(monkeypatch: pytest.MonkeyPatch) -> Clock:
    clock = Clock()
    monkeypatch.setattr(module, "time", clock)
    monkeypatch.setattr(module, "activity", Activity())
    return clock


def wait(
    busy_wait: BusyWait,
    clock: Clock,
    *,
    comes_after_us: int,
    came: bool = True,
    has_sent: bool = True,
) -> int:
    """Wait once; return the number of polls."""
    looks, end_us = 0, clock.now_us + comes_after_us
    module.activity.has_sent = has_sent

    def has_come() -> bool:
        nonlocal looks
        looks += 1
        clock.now_us += 10
        return clock.now_us >= end_us

    if not busy_wait.begin(has_come):
        clock.now_us = max(clock.now_us, end_us)
        busy_wait.end(came=came)
    return looks


def test_after_a_short_wait_the_next_ones_poll(clock: Clock) -> None:
    busy_wait = BusyWait()
    assert wait(busy_wait, clock, comes_after_us=100) == 0
    assert wait(busy_wait, clock, comes_after_us=100) == 10
    assert wait(busy_wait, clock, comes_after_us=100) == 10


def test_after_a_long_wait_the_next_one_sleeps(clock: Clock) -> None:
    busy_wait = BusyWait()
    wait(busy_wait, clock, comes_after_us=100)
    assert wait(busy_wait, clock, comes_after_us=1000) == 51  # it gave up after half a millisecond
    assert wait(busy_wait, clock, comes_after_us=100) == 0
    assert wait(busy_wait, clock, comes_after_us=1000) > 0


def test_with_large_messages_longer_waits_are_short(clock: Clock) -> None:
    busy_wait = BusyWait()
    busy_wait.short_wait_ns = LARGE_MESSAGE_WAIT_NS
    wait(busy_wait, clock, comes_after_us=2000)
    assert wait(busy_wait, clock, comes_after_us=2000) == 200


def test_a_wait_that_timed_out_is_not_short(clock: Clock) -> None:
    busy_wait = BusyWait()
    wait(busy_wait, clock, comes_after_us=100, came=False)
    assert wait(busy_wait, clock, comes_after_us=100) == 0


@pytest.mark.parametrize("period_us", [100, 200, 1000])
def test_a_thread_that_sends_nothing_does_not_poll_for_rare_messages(
    clock: Clock, period_us: int
) -> None:
    busy_wait = BusyWait()
    for _ in range(10):
        assert wait(busy_wait, clock, comes_after_us=period_us, has_sent=False) == 0


def test_in_a_flood_a_thread_polls_also_if_it_sends_nothing(clock: Clock) -> None:
    busy_wait = BusyWait()
    wait(busy_wait, clock, comes_after_us=30, has_sent=False)
    assert wait(busy_wait, clock, comes_after_us=30, has_sent=False) == 3


def polled_us(*waits: BusyWait, clock: Clock, period_us: int, seconds: int = 1) -> int:
    """Return for how long threads poll, if each waits for an answer once in a period."""
    polled = 0
    for number in range(seconds * 1_000_000 // period_us):
        polled += 10 * wait(waits[number % len(waits)], clock, comes_after_us=period_us)
    return polled


def test_polling_for_late_answers_costs_at_most_a_tenth_of_a_core(clock: Clock) -> None:
    polled = polled_us(BusyWait(), clock=clock, period_us=400, seconds=3)
    assert 0 < polled <= 3 * 2 * 100_000  # half of it costs nothing


def test_all_threads_share_the_budget(clock: Clock) -> None:
    assert polled_us(BusyWait(), BusyWait(), clock=clock, period_us=400) <= 2 * 100_000


def test_polling_that_costs_no_more_than_sleeping_is_not_limited(clock: Clock) -> None:
    assert polled_us(BusyWait(), clock=clock, period_us=100) >= 900_000


def test_polling_ends_when_another_program_needs_the_core(clock: Clock) -> None:
    busy_wait = BusyWait()
    wait(busy_wait, clock, comes_after_us=100)
    looks = 0

    def is_never() -> bool:
        nonlocal looks
        looks += 1
        clock.now_us += 3000  # the other program's turn
        return False

    module.activity.has_sent = True
    assert not busy_wait.begin(is_never)
    assert looks == 2
    busy_wait.end(came=True)
    for _ in range(2):
        assert wait(busy_wait, clock, comes_after_us=100) == 0
