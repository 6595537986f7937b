"""Tests of callbacks that raise and of executors that are shut down."""

from __future__ import annotations

import threading
import time
from typing import TYPE_CHECKING

import pytest

import zbot
from tests.conftest import wait_until
from tests.integration.executors.conftest import run_ready_callbacks
from zbot.errors import NotInitializedError
from zbot.executor.errors import ShutdownError

from std_msgs.msg import Int64

if TYPE_CHECKING:
    from tests.conftest import Spin


# -- exceptions ------------------------------------------------------------------------------------


@pytest.mark.parametrize("is_async", [False, True])
def test_an_exception_of_a_callback_ends_spin_and_the_next_spin_works(
    node: zbot.Node, executor: zbot.Executor, is_async: bool
) -> None:
    def fail() -> None:
        raise LookupError("in a callback")

    async def fail_async() -> None:
        fail()

    calls: list[int] = []
    node.create_guard_condition(fail_async if is_async else fail).trigger()
    with pytest.raises(LookupError, match="in a callback"):
        executor.spin()
    # The group must be free again, also for another executor.
    with zbot.SingleThreadedExecutor(context=node.context) as second:
        second.add_node(node)
        node.create_guard_condition(lambda: calls.append(1)).trigger()
        second.spin_once(timeout_sec=1)
    assert calls == [1]


def test_an_exception_after_an_await_ends_spin(node: zbot.Node, executor: zbot.Executor) -> None:
    future: zbot.Future[None] = zbot.Future()

    async def fail() -> None:
        await future
        raise LookupError("after an await")

    node.create_guard_condition(fail).trigger()
    run_ready_callbacks(executor)
    future.set_result(None)
    with pytest.raises(LookupError, match="after an await"):
        executor.spin()


def test_an_exception_of_one_message_loses_no_other(node: zbot.Node, single: zbot.Executor) -> None:
    numbers: list[int] = []

    def on_message(message: Int64) -> None:
        numbers.append(message.data)
        if message.data == 1:
            raise LookupError

    node.create_subscription(Int64, "count", on_message, 10)
    publisher = node.create_publisher(Int64, "count", 10)
    for number in range(4):
        publisher.publish(Int64(data=number))
    with pytest.raises(LookupError):
        single.spin()
    deadline = time.monotonic() + 5
    while len(numbers) < 4 and time.monotonic() < deadline:
        single.spin_once(timeout_sec=0.1)
    assert numbers == [0, 1, 2, 3]


# -- the end ---------------------------------------------------------------------------------------


def test_shutdown_in_a_callback_ends_spin_quietly(node: zbot.Node, executor: zbot.Executor) -> None:
    node.create_guard_condition(node.context.shutdown).trigger()
    executor.spin()
    assert not node.context.ok()


def test_shutting_an_executor_down_in_its_callback_ends_spin(
    node: zbot.Node, executor: zbot.Executor
) -> None:
    node.create_guard_condition(executor.shutdown).trigger()
    executor.spin()
    assert node.context.ok()
    with pytest.raises(ShutdownError):
        executor.add_node(node)


def test_shutdown_in_another_thread_ends_a_single_threaded_spin_with_an_exception(
    node: zbot.Node, single: zbot.Executor
) -> None:
    threading.Timer(0.02, node.context.shutdown).start()
    with pytest.raises(zbot.ExternalShutdownException):
        single.spin()
    with pytest.raises(zbot.ExternalShutdownException):
        single.spin_once(timeout_sec=1)


def test_shutdown_in_another_thread_lets_a_multi_threaded_spin_return(
    node: zbot.Node, multi: zbot.Executor
) -> None:
    threading.Timer(0.02, node.context.shutdown).start()
    multi.spin()
    multi.spin_once(timeout_sec=1)


def test_shutdown_in_another_thread_ends_the_modules_spin(node: zbot.Node) -> None:
    threading.Timer(0.02, node.context.shutdown).start()
    with pytest.raises(zbot.ExternalShutdownException):
        zbot.spin(node)
    assert node.executor is None


@pytest.mark.parametrize("spin_for_ever", [True, False])
def test_shutdown_of_the_module_lets_its_spin_return_in_another_thread(
    node: zbot.Node, spin_for_ever: bool
) -> None:
    ended: list[str] = []

    def run() -> None:
        try:
            while node.context.ok():
                zbot.spin(node) if spin_for_ever else zbot.spin_once(node)
        except zbot.ExternalShutdownException:
            ended.append("by an exception")
        else:
            ended.append("quietly")

    thread = threading.Thread(target=run)
    thread.start()
    assert wait_until(lambda: node.executor is not None)
    zbot.shutdown(context=node.context)
    thread.join(5)
    assert ended == ["quietly"]


def test_executor_shutdown_waits_for_a_running_callback(
    node: zbot.Node, executor: zbot.Executor, spin: Spin
) -> None:
    entered, gate = threading.Event(), threading.Event()
    ended: list[int] = []

    def block() -> None:
        entered.set()
        gate.wait(5)
        ended.append(1)

    node.create_guard_condition(block).trigger()
    spin(node, executor=executor)
    assert entered.wait(5)
    assert not executor.shutdown(timeout_sec=0.01)
    gate.set()
    assert executor.shutdown(timeout_sec=5)
    assert ended == [1]


def test_shutting_an_executor_down_twice_is_harmless(executor: zbot.Executor) -> None:
    assert executor.shutdown()
    assert executor.shutdown(timeout_sec=0)
    executor.spin()
    executor.spin_once(timeout_sec=0)


def test_destroying_a_node_while_another_thread_spins_it_is_clean(
    context: zbot.Context, node: zbot.Node, executor: zbot.Executor, spin: Spin
) -> None:
    spinner = spin(node, executor=executor)
    for turn in range(20):
        guest = zbot.Node(f"guest_{turn}", context=context)
        ran = threading.Event()
        guest.create_timer(0.0, ran.set)
        executor.add_node(guest)
        assert ran.wait(5)
        guest.destroy_node()
    assert spinner.error is None
    assert executor.get_nodes() == [node]


def test_module_functions_need_init() -> None:
    with pytest.raises(NotInitializedError, match=r"(zbot|rclpy)\.init\(\)"):
        zbot.Node("early")
