from __future__ import annotations

import asyncio
import threading
import time
import weakref
from typing import TYPE_CHECKING, Any

import pytest

from tests.conftest import in_threads
from zbot.errors import ExternalShutdownException
from zbot.executor.task import Future, FutureState, Task

if TYPE_CHECKING:
    from collections.abc import Callable


class Queue:
    """Executor that runs its scheduled tasks only when the test calls for it."""

    def __init__(self) -> None:
        self.tasks: list[Task[Any]] = []

    def schedule(self, task: Task[Any]) -> None:
        self.tasks.append(task)

    def create_task(self, callback: Callable[..., Any], *args: Any) -> Task[Any]:
        task: Task[Any] = Task(callback, args, executor=self)
        self.tasks.append(task)
        return task

    def run(self) -> None:
        while self.tasks:
            self.tasks.pop(0)()


def pending() -> Future[Any]:
    return Future()


def finished() -> Future[Any]:
    future: Future[Any] = Future()
    future.set_result(5)
    return future


def failed() -> Future[Any]:
    future: Future[Any] = Future()
    future.set_exception(LookupError("mine"))
    return future


def cancelled() -> Future[Any]:
    future: Future[Any] = Future()
    future.cancel()
    return future


@pytest.mark.parametrize(
    ("make", "done", "was_cancelled", "over", "state"),
    [
        (pending, False, False, False, FutureState.PENDING),
        (finished, True, False, True, FutureState.FINISHED),
        (failed, True, False, True, FutureState.FINISHED),
        (cancelled, False, True, True, FutureState.CANCELLED),
    ],
)
def test_a_future_has_the_state_of_its_end_as_in_rclpy(
    make: Callable[[], Future[Any]], done: bool, was_cancelled: bool, over: bool, state: FutureState
) -> None:
    future = make()
    assert (future.done(), future.cancelled(), future.is_over) == (done, was_cancelled, over)
    assert future._state is state


def test_a_future_holds_a_result_or_an_exception() -> None:
    assert pending().result() is None
    assert finished().result() == 5
    assert finished().exception() is None
    assert cancelled().result() is None
    assert str(failed().exception()) == "mine"
    with pytest.raises(LookupError, match="mine"):
        failed().result()


@pytest.mark.parametrize("make", [finished, cancelled])
def test_a_result_can_be_replaced_as_in_rclpy(make: Callable[[], Future[Any]]) -> None:
    future = make()
    future.set_result(1)
    future.set_result(2)
    future.cancel()
    assert (future.result(), future.done(), future.cancelled()) == (2, True, False)
    future.set_exception(ValueError("new"))
    with pytest.raises(ValueError, match="new"):
        future.result()


def test_an_exception_outlives_a_later_result_as_in_rclpy() -> None:
    future = failed()
    future.set_result(1)
    assert str(future.exception()) == "mine"
    with pytest.raises(LookupError, match="mine"):
        future.result()


def test_a_future_does_not_keep_its_executor_alive() -> None:
    queue = Queue()
    future: Future[int] = Future(executor=queue)
    seen: list[Future[int]] = []
    future.add_done_callback(seen.append)
    forgotten = weakref.ref(queue)
    del queue
    assert forgotten() is None
    future.set_result(1)
    assert seen == [future]


@pytest.mark.parametrize(
    "end",
    [
        lambda future: future.set_result(1),
        lambda future: future.set_exception(ValueError()),
        lambda future: future.cancel(),
    ],
    ids=["result", "exception", "cancel"],
)
def test_done_callbacks_run_once_with_the_future(end: Callable[[Future[Any]], None]) -> None:
    future, calls = pending(), list[Any]()
    future.add_done_callback(calls.append)
    end(future)
    assert calls == [future]
    future.add_done_callback(calls.append)
    assert calls == [future, future]


def test_a_done_callback_can_be_removed() -> None:
    future, calls = pending(), list[Any]()
    future.add_done_callback(calls.append)
    assert future.remove_done_callback(calls.append)
    assert not future.remove_done_callback(calls.append)
    future.set_result(1)
    assert calls == []


def test_many_threads_complete_a_future() -> None:
    future, barrier, calls = pending(), threading.Barrier(8), list[Any]()
    future.add_done_callback(calls.append)

    def complete(number: int) -> None:
        barrier.wait()
        future.set_result(number)

    in_threads(complete, 8)
    assert future.result() in range(8)
    assert calls == [future]


def test_a_task_runs_a_function_with_its_arguments() -> None:
    task: Task[tuple[int, int]] = Task(divmod, (17, 5))
    assert not task.done()
    task()
    assert task.result() == (3, 2)
    assert Task(dict, (), {"a": 1}).done() is False


def test_a_task_keeps_the_exception_of_its_function() -> None:
    task: Task[None] = Task(lambda: 1 / 0)
    task()
    assert isinstance(task.exception(), ZeroDivisionError)


def test_an_interrupt_passes_through_a_task() -> None:
    def interrupt() -> None:
        raise KeyboardInterrupt

    task: Task[None] = Task(interrupt)
    with pytest.raises(KeyboardInterrupt):
        task()
    assert task.done()


def test_a_coroutine_continues_when_the_awaited_future_is_done() -> None:
    queue, future, steps = Queue(), pending(), list[Any]()

    async def work() -> str:
        steps.append("begin")
        steps.append(await future)
        return "end"

    task = queue.create_task(work)
    queue.run()
    assert steps == ["begin"]
    assert not task.done()
    future.set_result("answer")
    queue.run()
    assert steps == ["begin", "answer"]
    assert task.result() == "end"


def test_awaiting_a_done_future_does_not_pause() -> None:
    queue = Queue()

    async def work() -> list[Any]:
        return [await finished(), await finished()]

    task = queue.create_task(work)
    queue.tasks.pop()()
    assert task.result() == [5, 5]


def test_a_finished_task_does_not_run_again() -> None:
    calls: list[int] = []
    task: Task[None] = Task(calls.append, (1,))
    task()
    task()
    assert calls == [1]


def test_cancelling_closes_a_coroutine_that_waits() -> None:
    queue, future, steps = Queue(), pending(), list[str]()

    async def work() -> None:
        try:
            await future
        finally:
            steps.append("closed")

    task = queue.create_task(work)
    queue.run()
    task.cancel()
    assert steps == ["closed"]
    future.set_result(1)
    queue.run()
    assert task.cancelled()


def test_no_step_begins_while_a_task_is_cancelled() -> None:
    queue, future, kept_out = Queue(), pending(), list[bool]()

    async def work() -> None:
        try:
            await future
        finally:
            kept_out.append(task.executing())

    task = queue.create_task(work)
    queue.run()
    task.add_waker(lambda: kept_out.append(task.executing()))
    task.cancel()
    assert kept_out == [True, True]
    assert not task.executing()


def test_a_task_is_cancelled_while_its_step_runs() -> None:
    queue, seen = Queue(), list[bool]()

    async def work() -> None:
        task.cancel()
        seen.append(task.cancelled())

    task = queue.create_task(work)
    queue.run()
    assert seen == [True]
    assert task.cancelled()
    assert not task.executing()


async def waits_for(future: Future[Any]) -> Any:
    return await future


async def completed_meanwhile(queue: Queue) -> Any:
    future = pending()
    waiting = asyncio.ensure_future(waits_for(future))
    task = queue.create_task(waits_for, future)
    await asyncio.sleep(0)
    queue.run()
    assert queue.tasks == []  # the task waits for its future: it is not asked again and again
    future.set_result(7)
    queue.run()
    return await waiting, task.result()


def test_asyncio_and_a_task_inside_its_loop_await_the_same_future() -> None:
    assert asyncio.run(completed_meanwhile(Queue())) == (7, 7)


def test_a_step_may_run_an_asyncio_loop() -> None:
    queue = Queue()
    task = queue.create_task(lambda: asyncio.run(completed_meanwhile(Queue())))
    queue.run()
    assert task.result() == (7, 7)


def test_a_loop_of_asyncio_waits_without_computing() -> None:
    future: Future[int] = Future()
    completing = threading.Timer(0.2, future.set_result, (7,))
    begun_s = time.thread_time()
    completing.start()
    assert asyncio.run(waits_for(future)) == 7
    assert time.thread_time() - begun_s < 0.1


def test_a_timeout_of_asyncio_ends_the_wait_and_not_the_future() -> None:
    future: Future[int] = Future()

    async def times_out() -> None:
        with pytest.raises(asyncio.TimeoutError):
            await asyncio.wait_for(waits_for(future), 0.01)

    asyncio.run(times_out())
    future.set_result(7)
    assert future.result() == 7


def test_an_error_of_a_done_callback_does_not_reach_the_completing_thread() -> None:
    future: Future[int] = Future()
    later: list[int] = []
    future.add_done_callback(lambda _: 1 / 0)
    future.add_done_callback(lambda done: later.append(done.result() or 0))
    with pytest.warns(UserWarning, match="Unhandled exception in done callback: division by zero"):
        future.set_result(3)
    assert later == [3]


def test_an_error_of_a_late_done_callback_reaches_the_caller() -> None:
    with pytest.raises(ZeroDivisionError):
        finished().add_done_callback(lambda _: 1 / 0)


def test_a_signal_in_a_done_callback_reaches_the_completing_thread() -> None:
    def interrupted(_: object) -> None:
        raise ExternalShutdownException

    future: Future[int] = Future()
    future.add_done_callback(interrupted)
    with pytest.raises(ExternalShutdownException):
        future.set_result(3)


def test_a_removed_waker_is_not_called() -> None:
    future, woken = pending(), []
    for waker in (kept := lambda: woken.append("kept"), removed := lambda: woken.append("removed")):
        future.add_waker(waker)
    future.remove_waker(removed)
    future.set_result(None)
    future.remove_waker(kept)
    assert woken == ["kept"]
