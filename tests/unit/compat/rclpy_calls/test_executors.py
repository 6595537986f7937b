"""Tests that use each member of contexts and executors."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest
from rclpy.callback_groups import (
    CallbackGroup,
    MutuallyExclusiveCallbackGroup,
    ReentrantCallbackGroup,
)
from rclpy.context import Context
from rclpy.executors import MultiThreadedExecutor, SingleThreadedExecutor
from rclpy.task import Future, Task

from tests.unit.compat.rclpy_calls.conftest import InUse, ignore

if TYPE_CHECKING:
    from rclpy.node import Node


@pytest.mark.parametrize(
    ("path", "kind"),
    [
        ("rclpy.callback_groups.CallbackGroup", MutuallyExclusiveCallbackGroup),
        ("rclpy.callback_groups.MutuallyExclusiveCallbackGroup", MutuallyExclusiveCallbackGroup),
        ("rclpy.callback_groups.ReentrantCallbackGroup", ReentrantCallbackGroup),
    ],
)
def test_callback_groups(path: str, kind: type[CallbackGroup], node: Node) -> None:
    group = InUse(path, kind())
    timer = node.create_timer(100.0, ignore)
    group.add_entity(timer)
    assert group.has_entity(timer)
    group.can_execute(timer)
    group.beginning_execution(timer)
    group.ending_execution(timer)


def test_contexts(domain: int) -> None:
    context = InUse("rclpy.context.Context", Context())
    ended: list[int] = []
    context.init([])
    context.on_shutdown(lambda: ended.append(1))
    assert (context.ok(), context.get_domain_id()) == (True, domain)
    with context.handle:
        pass
    context.shutdown()
    context.try_shutdown()
    context.destroy()
    assert ended == [1]


@pytest.mark.parametrize(
    ("path", "kind"),
    [
        ("rclpy.executors.Executor", SingleThreadedExecutor),
        ("rclpy.executors.SingleThreadedExecutor", SingleThreadedExecutor),
        ("rclpy.executors.MultiThreadedExecutor", MultiThreadedExecutor),
    ],
)
def test_executors(path: str, kind: type[SingleThreadedExecutor], node: Node) -> None:
    executor = InUse(path, kind(context=node.context))
    ran: list[int] = []
    node.create_timer(0.001, lambda: ran.append(1))
    assert executor.add_node(node)
    assert executor.get_nodes() == [node]
    assert executor.can_execute(next(iter(node.timers)))
    executor.spin_once(timeout_sec=60)
    done: Future[int] = executor.create_future()
    done.set_result(1)
    executor.spin_once_until_future_complete(done, timeout_sec=60)
    task = executor.create_task(lambda: 7)
    executor.spin_until_future_complete(task, timeout_sec=60)
    assert task.result() == 7
    assert len(executor.wait_for_ready_callbacks(timeout_sec=60)) == 3
    executor.wake()
    executor.create_task(executor.shutdown)
    executor.spin()
    assert executor.context is node.context
    executor.remove_node(node)
    assert ran


def test_futures_and_tasks() -> None:
    future = InUse("rclpy.task.Future", Future())
    seen: list[object] = []
    future.add_done_callback(seen.append)
    future.add_done_callback(ignore)
    future.remove_done_callback(ignore)
    assert not future.done()
    future.set_result(5)
    assert (future.result(), future.exception(), future.cancelled()) == (5, None, False)
    failed: Future[int] = Future()
    InUse("rclpy.task.Future", failed).set_exception(ValueError())
    future.cancel()
    assert seen
    task = InUse("rclpy.task.Task", Task(lambda: 1))
    assert not task.executing()
    task.cancel()
