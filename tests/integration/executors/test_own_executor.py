"""Tests of executors that a program derives, as rclpy's example with priorities does."""

from __future__ import annotations

import contextlib
import threading
from concurrent.futures import ThreadPoolExecutor
from typing import Any
from unittest.mock import Mock

import pytest

import zbot
from zbot.errors import ExternalShutdownException
from zbot.executor.errors import ConditionReachedException, ShutdownError
from zbot.executor.executor import Executor
from zbot.executor.task import await_or_execute
from zbot.time import TimeoutObject


class PriorityExecutor(Executor):
    """Executor that runs the callbacks of some nodes in threads of their own."""

    def __init__(self, context: zbot.Context) -> None:
        super().__init__(context=context)
        self.urgent: set[zbot.Node] = set()
        self.fast = ThreadPoolExecutor(2, thread_name_prefix="urgent")
        self.slow = ThreadPoolExecutor(1, thread_name_prefix="patient")

    def spin_once(self, timeout_sec: float | None = None) -> None:
        try:
            handler, _, node = self.wait_for_ready_callbacks(timeout_sec=timeout_sec)
        except TimeoutError:
            return
        (self.fast if node in self.urgent else self.slow).submit(handler)

    def shutdown(self, timeout_sec: float | None = None) -> bool:
        self.fast.shutdown()
        self.slow.shutdown()
        return super().shutdown(timeout_sec)


def test_each_node_runs_in_the_thread_that_its_executor_selects(context: zbot.Context) -> None:
    threads: dict[str, list[str]] = {"hurried": [], "idler": []}
    executor = PriorityExecutor(context)
    for name, seen in threads.items():
        node = zbot.Node(name, context=context)
        node.create_timer(0.01, lambda seen=seen: seen.append(threading.current_thread().name))
        executor.add_node(node)
        if name == "hurried":
            executor.urgent.add(node)
    with executor:
        while min(map(len, threads.values())) < 5:
            executor.spin_once(timeout_sec=1.0)
    assert {name.split("_")[0] for name in threads["hurried"]} == {"urgent"}
    assert {name.split("_")[0] for name in threads["idler"]} == {"patient"}


def test_a_callback_runs_only_when_its_task_is_called(
    context: zbot.Context, node: zbot.Node
) -> None:
    runs: list[int] = []
    with Executor(context=context) as executor:
        executor.add_node(node)
        guard = node.create_guard_condition(lambda: runs.append(1))
        assert executor.can_execute(guard)
        guard.trigger()
        task, entity, owner = executor.wait_for_ready_callbacks(TimeoutObject(1.0))
        assert (entity, owner, runs) == (guard, node, [])
        assert not executor.can_execute(guard)
        task()
        assert runs == [1]
        assert task.done()


def test_an_exception_of_a_callback_is_in_its_task(context: zbot.Context, node: zbot.Node) -> None:
    def fail() -> None:
        raise LookupError("mine")

    with Executor(context=context) as executor:
        executor.add_node(node)
        node.create_guard_condition(fail).trigger()
        task, _, _ = executor.wait_for_ready_callbacks(1.0)
        task()
        assert isinstance(task.exception(), LookupError)


def test_each_end_of_the_wait_raises_its_own_exception(context: zbot.Context) -> None:
    with Executor(context=context) as executor:
        with pytest.raises(TimeoutError):
            executor.wait_for_ready_callbacks(timeout_sec=0.0)
        with pytest.raises(ConditionReachedException):
            executor.wait_for_ready_callbacks(condition=lambda: True)
        context.shutdown()
        with pytest.raises(ExternalShutdownException):
            executor.wait_for_ready_callbacks()
    with pytest.raises(ShutdownError):
        executor.wait_for_ready_callbacks()


def test_await_or_execute_accepts_functions_and_coroutines(context: zbot.Context) -> None:
    async def later(value: int) -> int:
        return value + 1

    results: list[Any] = []

    async def both() -> None:
        results.append(await await_or_execute(later, 1))
        results.append(await await_or_execute(abs, -5))

    executor = zbot.SingleThreadedExecutor(context=context)
    executor.spin_until_future_complete(executor.create_task(both), timeout_sec=5)
    assert results == [2, 5]


def test_a_foreign_executor_is_not_called_when_its_node_is_destroyed(context: zbot.Context) -> None:
    stranger = Mock(**{"add_node.return_value": True})
    node = zbot.Node("guest", context=context)
    node.executor = stranger
    node.destroy_node()
    stranger.add_node.assert_called_once_with(node)
    stranger.remove_node.assert_not_called()


def test_ready_callbacks_are_yielded_one_by_one(context: zbot.Context) -> None:
    calls: list[int] = []
    node = zbot.Node("counter", context=context)
    with Executor(context=context) as executor:
        executor.add_node(node)
        guard = node.create_guard_condition(lambda: calls.append(len(calls)))
        ready = executor._wait_for_ready_callbacks(timeout_sec=1.0)
        for _ in range(2):
            guard.trigger()
            handler, entity, owner = next(ready)
            handler()
            assert (entity, owner) == (guard, node)
        assert calls == [0, 1]
        executor.shutdown()
        with pytest.raises(ShutdownError):
            next(ready)


class OneByOne(Executor):
    """Executor with only the method that rclpy asks for."""

    def spin_once(self, timeout_sec: float | None = None) -> None:
        with contextlib.suppress(TimeoutError):
            self.wait_for_ready_callbacks(timeout_sec)[0]()


class OneByOneUntil(OneByOne):
    def spin_once_until_future_complete(
        self, future: zbot.Future[Any], timeout_sec: float | None = None
    ) -> None:
        future.add_done_callback(lambda _: self.wake())
        with contextlib.suppress(TimeoutError, ConditionReachedException):
            self.wait_for_ready_callbacks(timeout_sec, condition=future.done)[0]()


@pytest.mark.parametrize("kind", [OneByOne, OneByOneUntil])
@pytest.mark.parametrize("by_thread", [False, True])
def test_an_own_spin_once_completes_a_future(
    kind: type[Executor], context: zbot.Context, *, by_thread: bool
) -> None:
    future: zbot.Future[int] = zbot.Future()
    node = zbot.Node("counter", context=context)
    if by_thread:
        threading.Timer(0.05, future.set_result, (1,)).start()
    else:
        node.create_timer(0.05, lambda: None if future.done() else future.set_result(1))
    with kind(context=context) as executor:
        executor.add_node(node)
        executor.spin_until_future_complete(future, timeout_sec=20)
    assert future.done()


@pytest.mark.parametrize("kind", [zbot.SingleThreadedExecutor, zbot.MultiThreadedExecutor])
def test_spin_calls_the_spin_once_of_a_derived_class(
    kind: type[Executor], context: zbot.Context
) -> None:
    class Counting(kind):  # type: ignore[valid-type, misc]
        turns = 0

        def spin_once(self, timeout_sec: float | None = None) -> None:
            self.turns += 1
            super().spin_once(timeout_sec)

    executor = Counting(context=context)
    node = zbot.Node("counter", context=context)
    executor.add_node(node)

    def tick() -> None:
        if executor.turns >= 3:
            executor.shutdown(0)

    node.create_timer(0.01, tick)
    executor.spin()
    assert executor.turns >= 3
