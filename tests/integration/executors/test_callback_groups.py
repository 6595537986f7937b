"""Tests of callbacks that may or may not run at the same time."""

from __future__ import annotations

import threading
import time
from typing import TYPE_CHECKING

import pytest

import zbot
from tests.conftest import allowed, wait_until
from tests.integration.executors.conftest import Overlap, run_ready_callbacks

from std_msgs.msg import Int64

if TYPE_CHECKING:
    from tests.conftest import Spin


def test_callbacks_of_an_exclusive_group_never_overlap(
    node: zbot.Node, multi: zbot.MultiThreadedExecutor, spin: Spin
) -> None:
    overlap = Overlap(1)
    group = zbot.MutuallyExclusiveCallbackGroup()
    for _ in range(4):
        node.create_timer(0.0, lambda: overlap.visit(meet=False), callback_group=group)
    spin(node, executor=multi)
    assert wait_until(lambda: overlap.calls > 50)
    assert overlap.most == 1


def test_a_nodes_callbacks_are_exclusive_by_default(
    node: zbot.Node, multi: zbot.MultiThreadedExecutor, spin: Spin
) -> None:
    overlap = Overlap(1)
    for _ in range(3):
        node.create_timer(0.0, lambda: overlap.visit(meet=False))
    spin(node, executor=multi)
    assert wait_until(lambda: overlap.calls > 50)
    assert overlap.most == 1


class HeldGroup:
    """Callback group that a coroutine holds while guard conditions of two nodes wait in order."""

    def __init__(self, node: zbot.Node, group: zbot.CallbackGroup, executor: zbot.Executor) -> None:
        self.node, self.group, self.executor = node, group, executor
        self.free: zbot.Future[None] = zbot.Future()
        self.ran: list[str] = []
        self.other = zbot.Node("other", context=node.context)

        async def hold() -> None:
            await self.free

        node.create_guard_condition(hold, group).trigger()
        run_ready_callbacks(executor)

    def wait_as(self, name: str, node: zbot.Node) -> None:
        node.create_guard_condition(lambda: self.ran.append(name), self.group).trigger()


def test_a_removed_entity_lets_the_next_one_in_the_queue_run(
    node: zbot.Node, executor: zbot.Executor
) -> None:
    held = HeldGroup(node, zbot.MutuallyExclusiveCallbackGroup(), executor)
    executor.add_node(held.other)
    held.wait_as("removed", held.other)
    held.wait_as("the next", node)
    run_ready_callbacks(executor)
    held.free.set_result(None)
    executor.spin_once(0)  # the coroutine ends and wakes the first in the held
    executor.remove_node(held.other)

    def has_run() -> bool:
        executor.spin_once(0.01)  # a thread of the pool may end the coroutine late
        return "the next" in held.ran

    assert wait_until(has_run)


def test_an_entity_of_an_idle_executor_lets_the_next_one_in_the_queue_run(
    node: zbot.Node, executor: zbot.Executor
) -> None:
    held = HeldGroup(node, zbot.MutuallyExclusiveCallbackGroup(), executor)
    with zbot.SingleThreadedExecutor(context=node.context) as idle:
        idle.add_node(held.other)
        held.wait_as("idle", held.other)
        idle.spin_once(0)
        held.wait_as("the next", node)
        run_ready_callbacks(executor)
        held.free.set_result(None)

        def has_run() -> bool:
            executor.spin_once(0.01)  # a thread of the pool may end the coroutine late
            return held.ran == ["the next"]

        assert wait_until(has_run)
        idle.spin_once(1)
        assert held.ran == ["the next", "idle"]


def test_callbacks_of_two_groups_overlap(
    node: zbot.Node, multi: zbot.MultiThreadedExecutor, spin: Spin
) -> None:
    overlap = Overlap(2)
    for _ in range(2):
        group = zbot.MutuallyExclusiveCallbackGroup()
        node.create_guard_condition(lambda: overlap.visit(meet=True), group).trigger()
    spin(node, executor=multi)
    assert wait_until(lambda: overlap.most == 2)


def test_a_reentrant_callback_overlaps_with_itself(
    node: zbot.Node, multi: zbot.MultiThreadedExecutor, spin: Spin
) -> None:
    overlap = Overlap(3)
    group = zbot.ReentrantCallbackGroup()
    node.create_subscription(
        Int64, "count", lambda _: overlap.visit(meet=True), 10, callback_group=group
    )
    publisher = node.create_publisher(Int64, "count", 10)
    spin(node, executor=multi)
    for _ in range(3):
        publisher.publish(Int64())
    assert wait_until(lambda: overlap.most == 3)


def test_a_reentrant_callback_runs_once_for_each_message(
    node: zbot.Node, multi: zbot.MultiThreadedExecutor, spin: Spin
) -> None:
    numbers: list[int] = []
    node.create_subscription(
        Int64,
        "count",
        lambda message: numbers.append(message.data),
        1000,
        callback_group=zbot.ReentrantCallbackGroup(),
    )
    publisher = node.create_publisher(Int64, "count", 1000)
    spin(node, executor=multi)
    for number in range(1000):
        publisher.publish(Int64(data=number))
    assert wait_until(lambda: len(numbers) == 1000)
    assert sorted(numbers) == list(range(1000))
    assert wait_until(lambda: len(multi._ready) == 0)


def test_one_thread_runs_one_callback_at_a_time(node: zbot.Node, spin: Spin) -> None:
    overlap = Overlap(1)
    group = zbot.ReentrantCallbackGroup()
    for _ in range(3):
        node.create_timer(0.0, lambda: overlap.visit(meet=False), callback_group=group)
    with pytest.warns(UserWarning, match="one thread"):
        executor = zbot.MultiThreadedExecutor(1, context=node.context)
    with executor:
        spin(node, executor=executor)
        assert wait_until(lambda: overlap.calls > 20)
        assert overlap.most == 1


def test_blocked_threads_do_not_delay_spin_once(
    node: zbot.Node, multi: zbot.MultiThreadedExecutor
) -> None:
    gate = threading.Event()
    group = zbot.ReentrantCallbackGroup()
    for _ in range(6):
        node.create_guard_condition(lambda: gate.wait(5), group).trigger()
    try:
        begin = time.monotonic()
        for _ in range(6):
            multi.spin_once(timeout_sec=0.02)
        assert time.monotonic() - begin < allowed(1)
    finally:
        gate.set()


class Gate(zbot.CallbackGroup):
    """Callback group of a program, which does not return the waiting entities."""

    is_open = False

    def can_execute(self, entity: object) -> bool:  # noqa: ARG002 - rclpy's signature
        return self.is_open

    def beginning_execution(self, entity: object) -> bool:  # noqa: ARG002 - rclpy's signature
        return self.is_open

    def ending_execution(self, entity: object) -> None:
        self.is_open = entity is None


def test_a_programs_own_group_is_asked_again_after_other_callbacks(
    node: zbot.Node, executor: zbot.Executor, spin: Spin
) -> None:
    gate, ticks = Gate(), list[float]()
    node.create_timer(0.001, lambda: ticks.append(time.monotonic()), callback_group=gate)
    seen: list[int] = []

    def open_gate() -> None:
        seen.append(len(ticks))
        gate.is_open = True

    node.create_timer(0.02, open_gate)
    spin(node, executor=executor)
    assert wait_until(lambda: len(ticks) >= 3)
    assert seen[0] == 0


def test_a_programs_own_group_is_asked_again_when_the_executor_is_woken(
    node: zbot.Node, executor: zbot.Executor, spin: Spin
) -> None:
    gate, calls = Gate(), list[str]()
    node.create_guard_condition(lambda: calls.append("guarded"), gate).trigger()
    other = node.create_guard_condition(lambda: calls.append("other"))
    spin(node, executor=executor)
    other.trigger()
    assert wait_until(lambda: calls == ["other"])
    gate.is_open = True
    executor.wake()
    assert wait_until(lambda: calls == ["other", "guarded"])
