from __future__ import annotations

import threading

import pytest

from zbot.threads import deadline as module
from zbot.threads.deadline import Deadline, poll


class Clock:
    """Stands for the module `time`. Only `sleep` lets time pass."""

    def __init__(self) -> None:
        self.now_s = 100.0
        self.pauses: list[float] = []

    def monotonic(self) -> float:
        return self.now_s

    def sleep(self, seconds: float) -> None:
        self.pauses.append(seconds)
        self.now_s += seconds


@pytest.fixture
def clock(monkeypatch: pytest.MonkeyPatch) -> Clock:
    clock = Clock()
    monkeypatch.setattr(module, "time", clock)
    return clock


def test_a_deadline_counts_down_to_zero(clock: Clock) -> None:
    deadline = Deadline(3)
    assert (deadline.left_s, deadline.is_over) == (3, False)
    clock.sleep(2)
    assert (deadline.left_s, deadline.is_over) == (1, False)
    clock.sleep(2)
    assert (deadline.left_s, deadline.is_over) == (0, True)


@pytest.mark.parametrize("timeout_s", [0, -1])
def test_a_timeout_that_is_not_positive_is_over_at_once(clock: Clock, timeout_s: float) -> None:
    assert clock.now_s == 100
    deadline = Deadline(timeout_s)
    assert (deadline.left_s, deadline.is_over) == (0, True)


def test_without_a_limit_a_lock_can_wait_for_the_time_that_is_left() -> None:
    deadline, lock = Deadline(None), threading.Lock()
    assert not deadline.is_over
    assert lock.acquire(timeout=deadline.left_s)


def test_polling_ends_with_the_first_true_result(clock: Clock) -> None:
    results = iter(["", "", "found", "never read"])
    assert poll(lambda: next(results), 10, 0.5) == "found"
    assert clock.pauses == [0.5, 0.5]


def test_polling_looks_once_more_at_the_end_of_the_time(clock: Clock) -> None:
    looks: list[float] = []

    def look() -> bool:
        looks.append(clock.now_s)
        return False

    assert not poll(look, 1.25, 0.5)
    assert looks == [100, 100.5, 101, 101.25]


def test_polling_without_time_looks_once(clock: Clock) -> None:
    assert poll(lambda: 0, 0, 0.5) == 0
    assert clock.pauses == []
