"""Tests of the share of a client in the threads of a server."""

from __future__ import annotations

import threading
from concurrent.futures import ThreadPoolExecutor

from tests.conftest import wait_until
from zbot.observer.serving.client_threads import ClientThreads


def test_calls_that_never_end_leave_threads_for_others() -> None:
    end = threading.Event()
    with ThreadPoolExecutor(3) as pool:
        greedy, honest = ClientThreads(pool, 2), ClientThreads(pool, 2)
        for _ in range(100):
            greedy.submit(end.wait)
        done = threading.Event()
        honest.submit(done.set)
        assert done.wait(10)
        greedy.close()
        end.set()


def test_all_work_is_done_and_an_error_does_not_stop_it() -> None:
    found: list[int] = []

    def work(number: int) -> None:
        found.append(number)
        if number == 3:
            raise KeyError(number)

    with ThreadPoolExecutor(4) as pool:
        threads = ClientThreads(pool, 1)
        for number in range(10):
            threads.submit(work, number)
        assert wait_until(lambda: len(found) == 10)
    assert found == list(range(10))
