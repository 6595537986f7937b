from __future__ import annotations

import threading

import pytest

from zbot.threads.background_thread import background_thread


def test_the_thread_works_during_the_block_and_ends_with_it() -> None:
    begun, threads = threading.Event(), []

    def work(is_over: threading.Event) -> None:
        threads.append(threading.current_thread())
        begun.set()
        is_over.wait()

    with background_thread("worker", work):
        assert begun.wait(10)
        assert threads[0].is_alive()
    assert (threads[0].name, threads[0].daemon, threads[0].is_alive()) == ("worker", True, False)


def test_the_thread_ends_after_an_error_in_the_block() -> None:
    events: list[threading.Event] = []

    def work(is_over: threading.Event) -> None:
        events.append(is_over)
        is_over.wait()

    with pytest.raises(ValueError, match="wrong"), background_thread("worker", work):
        raise ValueError("wrong")
    assert events[0].is_set()
    assert "worker" not in {thread.name for thread in threading.enumerate()}
