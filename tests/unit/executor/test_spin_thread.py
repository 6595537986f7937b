from __future__ import annotations

import threading
from types import SimpleNamespace
from typing import TYPE_CHECKING, Any

import pytest

from zbot.errors import ExternalShutdownException
from zbot.executor.ready_queue import ReadyQueue
from zbot.executor.spin_thread import SpinThread

if TYPE_CHECKING:
    from collections.abc import Callable

TIMEOUT_S = 10


class FakeContext:
    """The part of a context that an executor uses."""

    is_inherited = False
    is_interrupted = False

    def __init__(self) -> None:
        self.is_running = True
        self._wakers: dict[Callable[[], object], None] = {}

    def add_waker(self, wake: Callable[[], object]) -> None:
        self._wakers[wake] = None

    def remove_waker(self, wake: Callable[[], object]) -> None:
        self._wakers.pop(wake, None)

    def end(self) -> None:
        self.is_running = False
        for wake in self._wakers:
            wake()


class FakeNode:
    """The part of a node that an executor uses."""

    def __init__(self) -> None:
        self.context = FakeContext()
        self.handle: Any = SimpleNamespace(
            context=self.context, executor=None, ready_queue=ReadyQueue(), waitables=(), services=()
        )

    @property
    def executor(self) -> Any:
        return self.handle.executor

    def get_name(self) -> str:
        return "fake"

    def get_namespace(self) -> str:
        return "/"


def run_in(spinner: SpinThread, function: Callable[[], object]) -> None:
    """Run a function in the executor of a thread. Wait until it has begun."""
    has_begun = threading.Event()

    def work() -> None:
        has_begun.set()
        function()

    spinner.executor.create_task(work)
    assert has_begun.wait(TIMEOUT_S)


def fail() -> None:
    raise ValueError("wrong")


def test_callbacks_run_in_a_daemon_thread_with_a_name() -> None:
    threads: list[threading.Thread] = []
    with SpinThread(FakeNode(), "zbot test") as spinner:
        run_in(spinner, lambda: threads.append(threading.current_thread()))
    assert threads == [spinner.thread]
    assert (spinner.thread.name, spinner.thread.daemon) == ("zbot test", True)


def test_the_end_of_the_block_ends_the_thread_and_frees_the_node() -> None:
    node = FakeNode()
    with SpinThread(node, "zbot test") as spinner:
        assert node.executor is spinner.executor
    assert node.executor is None
    assert not spinner.thread.is_alive()
    spinner.stop()


def test_the_end_of_the_context_ends_the_thread() -> None:
    node = FakeNode()
    spinner = SpinThread(node, "zbot test")
    run_in(spinner, node.context.end)
    spinner.join(TIMEOUT_S)
    assert not spinner.thread.is_alive()


@pytest.mark.parametrize("interruption", [ExternalShutdownException, KeyboardInterrupt])
def test_an_interruption_ends_the_thread_silently(interruption: type[BaseException]) -> None:
    errors: list[Exception] = []
    spinner = SpinThread(FakeNode(), "zbot test", errors.append)

    def interrupt() -> None:
        raise interruption

    run_in(spinner, interrupt)
    spinner.join(TIMEOUT_S)
    assert (spinner.thread.is_alive(), errors) == (False, [])


def test_the_thread_goes_on_after_an_error_that_it_reports() -> None:
    errors: list[Exception] = []
    with SpinThread(FakeNode(), "zbot test", errors.append) as spinner:
        run_in(spinner, fail)
        run_in(spinner, fail)
    assert [str(error) for error in errors] == ["wrong", "wrong"]


def test_an_error_that_nobody_handles_ends_the_thread(monkeypatch: pytest.MonkeyPatch) -> None:
    errors: list[Any] = []
    monkeypatch.setattr(threading, "excepthook", errors.append)
    spinner = SpinThread(FakeNode(), "zbot test")
    run_in(spinner, fail)
    spinner.join(TIMEOUT_S)
    assert [error.exc_type for error in errors] == [ValueError]
    spinner.stop()


def test_a_callback_may_stop_its_own_thread() -> None:
    spinner = SpinThread(FakeNode(), "zbot test")
    run_in(spinner, spinner.stop)
    spinner.join(TIMEOUT_S)
    assert not spinner.thread.is_alive()


def test_stopping_waits_for_a_callback_no_longer_than_asked() -> None:
    may_end = threading.Event()
    spinner = SpinThread(FakeNode(), "zbot test")
    run_in(spinner, lambda: may_end.wait(TIMEOUT_S))
    spinner.stop(0)
    assert spinner.thread.is_alive()
    may_end.set()
    spinner.join(TIMEOUT_S)
    assert not spinner.thread.is_alive()
