"""Tests of the end of a process: all contexts are closed."""

from __future__ import annotations

import threading
from typing import TYPE_CHECKING, Any

import pytest

from zbot.process import at_exit
from zbot.threads.weak_set import WeakSet

if TYPE_CHECKING:
    from collections.abc import Callable


class Executor:
    def __init__(self) -> None:
        self.timeouts_s: list[float] = []

    def wait_idle(self, timeout_s: float) -> bool:
        self.timeouts_s.append(timeout_s)
        return True


class Context:
    """Open context that leaves the set when it is closed."""

    def __init__(self, shutdown: Callable[[], object] = bool) -> None:
        self.executors = {Executor()}
        self.is_closed = False
        self._shutdown = shutdown
        at_exit.open_contexts.add(self)  # type: ignore[arg-type]

    def shutdown(self) -> None:
        self._shutdown()
        self.close()

    def close(self) -> None:
        self.is_closed = True
        at_exit.open_contexts.discard(self)  # type: ignore[arg-type]


@pytest.fixture(autouse=True)
def other_process(monkeypatch: pytest.MonkeyPatch) -> None:
    """Give each test a process without contexts that does not end."""
    monkeypatch.setattr(at_exit, "open_contexts", WeakSet[Any]())
    monkeypatch.setattr(at_exit._Process, "is_ending", False)
    monkeypatch.setattr(at_exit._Process, "main_thread_has_ended", False)


def test_all_contexts_are_closed_and_their_callbacks_may_end() -> None:
    contexts = [Context(), Context()]
    assert not at_exit.is_ending()
    at_exit._close_contexts()
    assert at_exit.is_ending()
    for context in contexts:
        assert context.is_closed
        (executor,) = context.executors
        assert len(executor.timeouts_s) == 1


def test_a_context_whose_shutdown_was_interrupted_is_closed() -> None:
    context = Context()
    context.shutdown = bool  # type: ignore[assignment] # it does nothing a second time
    at_exit._close_contexts()
    assert context.is_closed


def test_a_context_that_fails_does_not_keep_the_others_open(
    capsys: pytest.CaptureFixture[str],
) -> None:
    def fail() -> None:
        raise ValueError("mine")

    contexts = [Context(fail), Context(), Context(fail), Context()]
    at_exit._close_contexts()
    assert [context.is_closed for context in contexts] == [False, True, False, True]
    assert capsys.readouterr().err.count("ValueError: mine") == 2


def test_a_forked_child_forgets_the_contexts_of_its_parent() -> None:
    context: Any = Context()
    at_exit._Process.is_ending = True
    assert at_exit.leave_to_parent() == [context]
    assert not at_exit.is_ending()
    at_exit._close_contexts()
    assert not context.is_closed


def test_the_wait_for_the_main_thread_has_a_limit() -> None:
    assert not at_exit.wait_for_end(0.01)
    at_exit._Process.main_thread_has_ended = True
    assert at_exit.wait_for_end(0)


def test_the_end_waits_for_the_threads_of_the_program_only() -> None:
    go_on = threading.Event()
    own = threading.Thread(target=lambda: go_on.wait(10))
    daemon = threading.Thread(target=lambda: go_on.wait(10), daemon=True)
    for thread in (own, daemon):
        thread.start()
    assert own in at_exit._program_threads()
    assert daemon not in at_exit._program_threads()
    go_on.set()
    own.join(10)
    assert own not in at_exit._program_threads()
