"""Tests of the thread that exists only while there is work."""

from __future__ import annotations

import contextlib
import threading
from typing import TYPE_CHECKING

import pytest

from zbot.threads.on_demand_thread import OnDemandThread

if TYPE_CHECKING:
    from collections.abc import Callable


class Threads:
    """Starts threads and waits for them."""

    def __init__(self) -> None:
        self.started: list[threading.Thread] = []

    def start(self, run: Callable[[], None]) -> None:
        self.started.append(threading.Thread(target=run))
        self.started[-1].start()

    def join(self) -> None:
        for thread in self.started:
            thread.join(10)
            assert not thread.is_alive()


@pytest.fixture
def threads() -> Threads:
    return Threads()


def test_a_thread_ends_after_its_work_and_starts_again_for_the_next(threads: Threads) -> None:
    turns = list[str]()
    worker = OnDemandThread(threads.start, lambda: turns.append("turn"))
    assert threads.started == []
    for count in (1, 2):
        worker.wake()
        threads.join()
        assert len(turns) == len(threads.started) == count


def test_the_work_is_called_again_after_its_pause(threads: Threads) -> None:
    pauses = [0.01, 0.0, None]
    worker = OnDemandThread(threads.start, lambda: pauses.pop(0))
    worker.wake()
    threads.join()
    assert pauses == []
    assert len(threads.started) == 1


def test_a_wake_ends_a_pause(threads: Threads) -> None:
    begun = threading.Event()
    pauses: list[float | None] = [1e9, None]

    def work() -> float | None:
        begun.set()
        return pauses.pop(0)

    worker = OnDemandThread(threads.start, work)
    worker.wake()
    assert begun.wait(10)
    worker.wake()
    threads.join()


def test_no_wake_is_lost_while_a_thread_ends(threads: Threads) -> None:
    wanted, done = 0, 0

    def work() -> None:
        nonlocal done
        done = wanted

    worker = OnDemandThread(threads.start, work)
    for number in range(1, 500):
        wanted = number
        worker.wake()
        for thread in threads.started[-2:]:
            thread.join(10)
        assert done == number


def test_an_error_of_the_work_does_not_end_it_for_ever() -> None:
    turns = list[str]()

    def work() -> None:
        turns.append("turn")
        if len(turns) == 1:
            raise ValueError

    def start(run: Callable[[], None]) -> None:
        with contextlib.suppress(ValueError):
            run()  # in this thread

    worker = OnDemandThread(start, work)
    worker.wake()
    worker.wake()
    assert len(turns) == 2


def test_after_the_end_no_thread_is_started(threads: Threads) -> None:
    worker = OnDemandThread(threads.start, lambda: None)
    worker.end()
    worker.wake()
    assert threads.started == []


def test_the_end_hurries_a_thread(threads: Threads) -> None:
    begun, is_over = threading.Event(), False

    def work() -> float | None:
        begun.set()
        return None if is_over else 1e9

    worker = OnDemandThread(threads.start, work)
    worker.wake()
    assert begun.wait(10)
    is_over = True
    worker.end()
    threads.join()


def test_a_process_that_can_start_no_thread_goes_on() -> None:
    def start(_: Callable[[], None]) -> None:
        raise RuntimeError("can't start new thread")

    worker = OnDemandThread(start, lambda: None)
    worker.wake()
    worker.wake()
