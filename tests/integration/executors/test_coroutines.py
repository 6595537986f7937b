"""Tests of coroutines, tasks, futures and guard conditions."""

from __future__ import annotations

import threading
import time
from typing import TYPE_CHECKING

import pytest

import zbot
from tests.conftest import wait_until
from tests.integration.executors.conftest import complete, run_ready_callbacks

from std_msgs.msg import Int64

if TYPE_CHECKING:
    from collections.abc import Callable

    from tests.conftest import Spin


# -- coroutines, tasks and futures -----------------------------------------------------------------


def test_an_async_callback_waits_for_a_future(node: zbot.Node, executor: zbot.Executor) -> None:
    answer: zbot.Future[int] = zbot.Future()
    done: zbot.Future[int | None] = zbot.Future()

    async def ask() -> None:
        done.set_result(await answer)

    node.create_guard_condition(ask).trigger()
    group = zbot.MutuallyExclusiveCallbackGroup()
    node.create_guard_condition(lambda: answer.set_result(42), group).trigger()
    assert complete(executor, done) == 42


def test_an_async_callback_keeps_its_group_until_it_ends(
    node: zbot.Node, executor: zbot.Executor
) -> None:
    answer: zbot.Future[None] = zbot.Future()
    order: list[str] = []

    async def ask() -> None:
        order.append("begin")
        await answer
        order.append("end")

    node.create_guard_condition(ask).trigger()
    node.create_guard_condition(lambda: order.append("other")).trigger()
    run_ready_callbacks(executor)
    assert wait_until(lambda: order == ["begin"])
    answer.set_result(None)
    finished: zbot.Future[bool] = zbot.Future()
    node.create_guard_condition(lambda: finished.set_result(True)).trigger()
    complete(executor, finished)
    assert order == ["begin", "end", "other"]


def test_async_callbacks_of_a_reentrant_group_interleave(
    node: zbot.Node, executor: zbot.Executor
) -> None:
    answers: list[zbot.Future[None]] = []
    ended: list[int] = []

    async def on_message(message: Int64) -> None:
        answers.append(zbot.Future())
        await answers[-1]
        ended.append(message.data)

    group = zbot.ReentrantCallbackGroup()
    node.create_subscription(Int64, "count", on_message, 10, callback_group=group)
    publisher = node.create_publisher(Int64, "count", 10)
    for number in range(3):
        publisher.publish(Int64(data=number))
    deadline = time.monotonic() + 5
    while len(answers) < 3 and time.monotonic() < deadline:
        executor.spin_once(timeout_sec=0.05)
    assert len(answers) == 3
    for answer in answers:
        answer.set_result(None)
    while len(ended) < 3 and time.monotonic() < deadline:
        executor.spin_once(timeout_sec=0.05)
    assert sorted(ended) == [0, 1, 2]


def test_a_task_has_the_result_of_its_coroutine(executor: zbot.Executor) -> None:
    async def inner(number: int) -> int:
        return number + 1

    async def outer(number: int, *, factor: int) -> int:
        task = executor.create_task(inner, number)
        assert await inner(1) == 2
        return factor * (await task or 0)

    assert complete(executor, executor.create_task(outer, 4, factor=10)) == 50
    assert complete(executor, executor.create_task(inner(1))) == 2


def test_a_waiting_coroutine_is_not_resumed_before_its_future_is_done(
    node: zbot.Node, executor: zbot.Executor
) -> None:
    class Answer(zbot.Future[None]):
        looks = 0

        def add_waker(self, waker: Callable[[], object]) -> None:
            self.looks += 1
            super().add_waker(waker)

    answers = [Answer(), Answer()]

    async def ask() -> None:
        for answer in answers:
            timer = node.create_timer(0.02, lambda: answer.set_result(None))  # noqa: B023
            await answer
            node.destroy_timer(timer)

    complete(executor, executor.create_task(ask))
    # None if a timer of another thread completes the future before the coroutine looks at it.
    assert max(answer.looks for answer in answers) <= 1


def test_done_callbacks_run_in_the_executor(single: zbot.Executor) -> None:
    future = single.create_future()
    threads: list[threading.Thread] = []
    future.add_done_callback(lambda _: threads.append(threading.current_thread()))
    other = threading.Thread(target=future.set_result, args=(1,))
    other.start()
    other.join()
    assert threads == []
    run_ready_callbacks(single)
    future.add_done_callback(lambda _: threads.append(threading.current_thread()))
    run_ready_callbacks(single)
    assert threads == [threading.current_thread()] * 2


def test_a_task_that_raises_ends_spinning_as_in_rclpy(executor: zbot.Executor) -> None:
    def fail() -> None:
        raise LookupError("in a task")

    task = executor.create_task(fail)
    with pytest.raises(LookupError, match="in a task"):
        executor.spin_until_future_complete(zbot.Future(), timeout_sec=5)
    assert isinstance(task.exception(), LookupError)


def test_an_await_raises_the_exception_of_its_future(executor: zbot.Executor) -> None:
    future: zbot.Future[None] = zbot.Future()

    async def ask() -> str:
        try:
            await future
        except LookupError as exc:
            return str(exc)
        return "nothing"

    task = executor.create_task(ask)
    run_ready_callbacks(executor)
    future.set_exception(LookupError("remote"))
    assert complete(executor, task) == "remote"


def test_a_cancelled_task_stops(executor: zbot.Executor) -> None:
    future: zbot.Future[None] = zbot.Future()
    steps: list[str] = []

    async def work() -> None:
        steps.append("begin")
        await future
        steps.append("end")

    task = executor.create_task(work)
    run_ready_callbacks(executor)
    assert wait_until(lambda: steps == ["begin"] and not task.executing())
    task.cancel()
    future.set_result(None)
    run_ready_callbacks(executor)
    assert steps == ["begin"]
    assert task.cancelled()


# -- guard conditions ------------------------------------------------------------------------------


def test_a_guard_runs_once_for_many_triggers(node: zbot.Node, executor: zbot.Executor) -> None:
    calls: list[int] = []
    guard = node.create_guard_condition(lambda: calls.append(1))
    for _ in range(10):
        guard.trigger()
    run_ready_callbacks(executor)
    assert wait_until(lambda: calls == [1])
    guard.trigger()
    run_ready_callbacks(executor)
    assert wait_until(lambda: calls == [1, 1])


def test_a_destroyed_guard_runs_no_callback(node: zbot.Node, executor: zbot.Executor) -> None:
    calls: list[int] = []
    guard = node.create_guard_condition(lambda: calls.append(1))
    guard.trigger()
    assert node.destroy_guard_condition(guard)
    guard.trigger()
    run_ready_callbacks(executor)
    assert calls == []


def test_triggers_of_many_threads_wake_the_executor(
    node: zbot.Node, executor: zbot.Executor, spin: Spin
) -> None:
    seen: set[int] = set()
    wanted: set[int] = set()
    guard = node.create_guard_condition(lambda: seen.update(wanted))
    spin(node, executor=executor)

    def trigger(number: int) -> None:
        wanted.add(number)
        guard.trigger()

    threads = [threading.Thread(target=trigger, args=(k,)) for k in range(50)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert wait_until(lambda: len(seen) == 50)
