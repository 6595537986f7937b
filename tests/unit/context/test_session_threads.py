"""Tests of the threads that a shutdown waits for."""

from __future__ import annotations

import threading
from typing import Any

from tests.conftest import wait_until
from zbot.context.session_threads import SessionThreads


def test_a_thread_is_woken_and_waited_for() -> None:
    threads, happened, woken = SessionThreads(), list[str](), threading.Event()

    def run() -> None:
        assert woken.wait(10)
        happened.append("ended")

    threads.start("zbot test", run, woken.set)
    assert wait_until(lambda: "zbot test" in [thread.name for thread in threading.enumerate()])
    threads.join()
    assert happened == ["ended"]
    assert "zbot test" not in [thread.name for thread in threading.enumerate()]


def test_a_thread_that_has_ended_is_forgotten() -> None:
    threads, woken = SessionThreads(), list[str]()
    ended = threading.Event()
    threads.start("zbot test", ended.set, lambda: woken.append("woken"))
    assert ended.wait(10)
    while any(thread.name == "zbot test" for thread in threading.enumerate()):
        pass
    threads.join()
    assert woken == []


def test_a_thread_may_wait_for_the_others() -> None:
    threads, joined = SessionThreads(), threading.Event()

    def run() -> None:
        threads.join()
        joined.set()

    threads.start("zbot test", run)
    assert joined.wait(10)


def test_the_end_waits_until_zenoh_has_dropped_a_receiver() -> None:
    threads, happened = SessionThreads(), list[Any]()
    receiver = threads.receiver(happened.append)
    receiver.callback("event")

    def drop() -> None:
        happened.append("dropped")
        receiver.drop()

    zenohs = threading.Timer(0.05, drop)
    zenohs.start()
    threads.join()
    assert happened == ["event", "dropped"]
    zenohs.join()
