"""Tests of threads that are started by threads which must not wait."""

from __future__ import annotations

import threading
import time

import pytest

from zbot.threads.unawaited_thread import UnawaitedThread


def test_the_start_does_not_wait_for_the_thread(monkeypatch: pytest.MonkeyPatch) -> None:
    can_begin, happened = threading.Event(), list[str]()
    start = threading.Thread.start

    def slow_start(thread: threading.Thread) -> None:
        assert can_begin.wait(10)
        start(thread)

    monkeypatch.setattr(threading.Thread, "start", slow_start)
    thread = UnawaitedThread(lambda: happened.append("ran"), "zbot test")
    thread.start()
    thread.join(0.01)
    assert happened == []
    can_begin.set()
    thread.join(10)
    assert happened == ["ran"]
    assert not thread.is_alive()


def test_a_thread_that_never_started_is_not_waited_for() -> None:
    UnawaitedThread(list, "zbot test").join()


def test_no_thread_starts_while_the_process_ends(monkeypatch: pytest.MonkeyPatch) -> None:
    def refuse(_: threading.Thread) -> None:
        raise RuntimeError("can't create new thread at interpreter shutdown")

    monkeypatch.setattr(threading.Thread, "start", refuse)
    thread = UnawaitedThread(list, "zbot test")
    thread.start()
    thread.join(10)
    assert not thread.is_alive()


def test_a_thread_that_could_not_start_is_not_waited_for(monkeypatch: pytest.MonkeyPatch) -> None:
    def refuse(*_: object) -> None:
        raise RuntimeError("can't create new thread at interpreter shutdown")

    monkeypatch.setattr("zbot.threads.unawaited_thread.start_new_thread", refuse)
    thread = UnawaitedThread(list, "zbot test")
    with pytest.raises(RuntimeError):
        thread.start()
    begun_s = time.monotonic()
    thread.join(10)
    assert time.monotonic() - begun_s < 5
