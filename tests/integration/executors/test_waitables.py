"""Tests of waitables of a program and of wait sets without an executor."""

from __future__ import annotations

import threading
from typing import TYPE_CHECKING
from unittest.mock import Mock

import pytest

import zbot
from tests.integration.executors.conftest import complete, run_ready_callbacks
from zbot.errors import InvalidHandleError
from zbot.executor.guard_condition import GuardCondition
from zbot.executor.wait_set import WaitSet
from zbot.executor.waitable import NumberOfEntities, Waitable

from std_msgs.msg import String

if TYPE_CHECKING:
    from tests.conftest import MakeContext


class TriggeredWaitable(Waitable[str]):
    """Waitable that runs after a trigger of its guard condition or a call of the test."""

    def __init__(self, group: zbot.CallbackGroup | None = None) -> None:
        super().__init__(group or zbot.ReentrantCallbackGroup())
        self.guard = GuardCondition()
        self.is_due = False
        self.result: zbot.Future[str] = zbot.Future()
        self._index = -1

    def add_to_wait_set(self, wait_set: WaitSet) -> None:
        self._index = wait_set.add_guard_condition(self.guard.handle)

    def is_ready(self, wait_set: WaitSet) -> bool:
        self.is_due = self.is_due or wait_set.is_ready("guard_condition", self._index)
        return self.is_due

    def take_data(self) -> str:
        self.is_due = False
        return "executed"

    async def execute(self, taken_data: str) -> None:
        self.result.set_result(taken_data)

    def get_num_entities(self) -> NumberOfEntities:
        return NumberOfEntities(num_guard_conditions=1)


def test_a_trigger_in_its_wait_set_wakes_a_waitable(
    node: zbot.Node, executor: zbot.Executor
) -> None:
    bell = TriggeredWaitable()
    node.add_waitable(bell)
    run_ready_callbacks(executor)
    bell.guard.trigger()
    assert complete(executor, bell.result) == "executed"


def test_a_woken_executor_checks_its_waitables(node: zbot.Node, executor: zbot.Executor) -> None:
    bell = TriggeredWaitable()
    node.add_waitable(bell)
    run_ready_callbacks(executor)
    bell.is_due = True
    executor.wake()
    assert complete(executor, bell.result) == "executed"


def test_a_waitable_runs_again_and_again(
    node: zbot.Node, single: zbot.SingleThreadedExecutor
) -> None:
    bell = TriggeredWaitable()
    node.add_waitable(bell)
    for _ in range(3):
        bell.result = zbot.Future()
        bell.guard.trigger()
        assert complete(single, bell.result) == "executed"


def test_a_removed_waitable_never_runs(
    node: zbot.Node, single: zbot.SingleThreadedExecutor
) -> None:
    bell = TriggeredWaitable()
    node.add_waitable(bell)
    assert list(node.waitables) == [bell]
    node.remove_waitable(bell)
    bell.guard.trigger()
    single.wake()
    run_ready_callbacks(single)
    assert not bell.result.done()
    assert list(node.waitables) == []


def test_a_failed_waitable_does_not_keep_its_group(
    node: zbot.Node, single: zbot.SingleThreadedExecutor
) -> None:
    class Broken(TriggeredWaitable):
        def take_data(self) -> str:
            super().take_data()
            raise LookupError("no data")

    bell, ran = Broken(node.default_callback_group), zbot.Future[str]()
    node.add_waitable(bell)
    bell.guard.trigger()
    with pytest.raises(LookupError, match="no data"):
        complete(single, ran)
    node.create_guard_condition(lambda: ran.set_result("executed")).trigger()
    assert complete(single, ran) == "executed"


def test_a_waitable_waits_for_its_group(
    node: zbot.Node, single: zbot.SingleThreadedExecutor
) -> None:
    group = zbot.MutuallyExclusiveCallbackGroup()
    gate: zbot.Future[None] = zbot.Future(executor=single)

    async def hold() -> None:
        await gate

    node.create_guard_condition(hold, group).trigger()
    run_ready_callbacks(single)
    bell = TriggeredWaitable(group)
    node.add_waitable(bell)
    bell.guard.trigger()
    run_ready_callbacks(single)
    assert not bell.result.done()
    gate.set_result(None)
    assert complete(single, bell.result) == "executed"


def test_numbers_of_entities_add_up() -> None:
    total = NumberOfEntities(1, 2, 3, 4, 5, 6)
    total += NumberOfEntities(num_events=1)
    assert total == NumberOfEntities(1, 2, 3, 4, 5, 7)
    assert repr(total) == "<NumberOfEntities(1, 2, 3, 4, 5, 7)>"


def test_a_wait_set_waits_for_a_message(node: zbot.Node) -> None:
    subscription = node.create_subscription(String, "news", lambda _: None, 1)
    publisher = node.create_publisher(String, "news", 1)
    wait_set = WaitSet()
    index = wait_set.add_subscription(subscription.handle)
    wait_set.wait(0)
    assert not wait_set.is_ready("subscription", index)
    threading.Timer(0.05, publisher.publish, (String(data="hi"),)).start()
    wait_set.wait(5_000_000_000)
    assert wait_set.get_ready_entities("subscription") == [subscription.handle.pointer]
    with subscription.handle:
        taken = subscription.handle.take_message(String, False)
    assert taken is not None
    message, info = taken
    assert message.data == "hi"
    assert info["source_timestamp"] > 0
    assert subscription.handle.take_message() is None


def test_a_wait_set_ends_at_its_timeout(node: zbot.Node) -> None:
    guard = node.create_guard_condition(lambda: None)
    wait_set = WaitSet()
    wait_set.add_guard_condition(guard.handle)
    wait_set.wait(1_000_000)
    assert wait_set.get_ready_entities("guard_condition") == []


def test_a_wait_set_wakes_for_a_timer(node: zbot.Node) -> None:
    timer = node.create_timer(0.02, lambda: None)
    wait_set = WaitSet()
    index = wait_set.add_timer(timer.handle)
    wait_set.wait(-1)
    assert wait_set.is_ready("timer", index)


def test_a_trigger_ends_one_wait_only(node: zbot.Node) -> None:
    guard = node.create_guard_condition(lambda: None)
    wait_set = WaitSet()
    index = wait_set.add_guard_condition(guard.handle)
    guard.trigger()
    wait_set.wait(0)
    assert wait_set.is_ready("guard_condition", index)
    wait_set.wait(0)
    assert not wait_set.is_ready("guard_condition", index)


def test_the_handle_of_a_destroyed_node_is_invalid(make_context: MakeContext) -> None:
    node = zbot.Node("gone", context=make_context())
    with node.handle, node.context.handle:
        pass
    node.destroy_node()
    with pytest.raises(InvalidHandleError), node.handle:
        pass


def test_a_foreign_executor_can_be_set(node: zbot.Node) -> None:
    other = Mock()
    node.executor = other
    assert node.executor is other
    other.add_node.assert_called_once_with(node)
    node.executor = None
    assert node.executor is None
    other.remove_node.assert_called_once_with(node)
