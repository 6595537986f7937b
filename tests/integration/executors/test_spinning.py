"""Tests of spinning and of the nodes of an executor."""

from __future__ import annotations

import gc
import threading
import time
import weakref
from functools import partial
from typing import TYPE_CHECKING

import pytest

import zbot
from tests.conftest import allowed, wait_until
from tests.integration.executors.conftest import complete
from zbot.errors import WrongStateError

from std_msgs.msg import Int64

if TYPE_CHECKING:
    from collections.abc import Callable

    from tests.conftest import Spin


# -- spinning --------------------------------------------------------------------------------------


def test_spin_once_runs_one_callback(node: zbot.Node, single: zbot.Executor) -> None:
    calls: list[int] = []
    guards = [node.create_guard_condition(lambda k=k: calls.append(k)) for k in range(3)]  # type: ignore[misc]
    for guard in guards:
        guard.trigger()
    for done in range(1, 4):
        single.spin_once(timeout_sec=1)
        assert calls == list(range(done))


@pytest.mark.parametrize("timeout", [0, 0.02])
def test_spin_once_returns_at_its_timeout(executor: zbot.Executor, timeout: float) -> None:
    begin = time.monotonic()
    executor.spin_once(timeout_sec=timeout)
    assert timeout <= time.monotonic() - begin < timeout + allowed(0.5)


def test_spin_once_with_timeout_zero_runs_callbacks(node: zbot.Node, single: zbot.Executor) -> None:
    calls: list[int] = []
    node.create_guard_condition(lambda: calls.append(1)).trigger()
    single.spin_once(timeout_sec=0)
    assert calls == [1]


@pytest.mark.parametrize("timeout", [None, -1])
def test_spin_once_without_limit_waits_for_work(
    node: zbot.Node, single: zbot.Executor, timeout: float | None
) -> None:
    calls: list[int] = []
    guard = node.create_guard_condition(lambda: calls.append(1))
    trigger = threading.Timer(0.02, guard.trigger)
    trigger.start()
    single.spin_once(timeout_sec=timeout)
    trigger.join()
    assert calls == [1]


def test_spinning_until_a_future_stops_when_it_is_done(executor: zbot.Executor) -> None:
    assert complete(executor, executor.create_task(lambda: 5)) == 5


def test_spinning_until_a_future_wakes_when_another_thread_completes_it(
    executor: zbot.Executor,
) -> None:
    future: zbot.Future[str] = zbot.Future()
    threading.Timer(0.02, lambda: future.set_result("late")).start()
    assert complete(executor, future) == "late"


def test_spinning_until_a_future_ends_at_the_timeout(executor: zbot.Executor) -> None:
    future: zbot.Future[str] = zbot.Future()
    begin = time.monotonic()
    executor.spin_until_future_complete(future, timeout_sec=0.02)
    assert 0.02 <= time.monotonic() - begin < allowed(0.5)
    assert not future.done()


def test_spinning_until_a_future_with_timeout_zero_runs_callbacks(single: zbot.Executor) -> None:
    task = single.create_task(lambda: 7)
    single.spin_until_future_complete(task, timeout_sec=0)
    assert task.result() == 7


def test_spinning_until_a_cancelled_future_ends(executor: zbot.Executor) -> None:
    future: zbot.Future[str] = zbot.Future()
    future.cancel()
    executor.spin_until_future_complete(future, timeout_sec=5)
    assert future.cancelled()
    assert not future.done()


# -- several threads -------------------------------------------------------------------------------


def in_thread(function: Callable[[], object]) -> threading.Thread:
    thread = threading.Thread(target=function, daemon=True)
    thread.start()
    return thread


def test_spin_once_of_a_second_thread_waits_for_a_callback(
    node: zbot.Node, executor: zbot.Executor, spin: Spin
) -> None:
    spin(executor=executor)
    assert wait_until(lambda: executor.is_spinning)
    calls: list[str] = []
    guard = node.create_guard_condition(lambda: calls.append(threading.current_thread().name))
    once = in_thread(partial(zbot.spin_once, node, timeout_sec=30))
    while once.is_alive():
        guard.trigger()
        once.join(0.01)
    assert calls
    assert once.name not in calls
    assert node.executor is executor
    before = len(calls)
    guard.trigger()
    assert wait_until(lambda: len(calls) > before)


@pytest.mark.parametrize("timeout", [0, 0.05])
def test_spin_once_of_a_second_thread_returns_at_its_timeout(
    node: zbot.Node, executor: zbot.Executor, spin: Spin, timeout: float
) -> None:
    spin(executor=executor)
    assert wait_until(lambda: executor.is_spinning)
    begin = time.monotonic()
    zbot.spin_once(node, timeout_sec=timeout)
    assert timeout <= time.monotonic() - begin < timeout + allowed(0.5)
    assert node.executor is executor


def test_two_threads_take_turns_in_spin_once(node: zbot.Node, executor: zbot.Executor) -> None:
    calls: list[int] = []
    guards = [node.create_guard_condition(lambda k=k: calls.append(k)) for k in range(40)]  # type: ignore[misc]
    for guard in guards:
        guard.trigger()
    errors: list[BaseException] = []

    def work() -> None:
        try:
            while len(calls) < len(guards):
                executor.spin_once(timeout_sec=0.01)
        except BaseException as error:  # noqa: BLE001 - checked by the test
            errors.append(error)

    threads = [in_thread(work) for _ in range(3)]
    for thread in threads:
        thread.join(30)
    assert sorted(calls) == list(range(40))
    assert not errors


def test_a_second_thread_goes_on_spinning_when_the_first_one_stops(
    node: zbot.Node, executor: zbot.Executor
) -> None:
    calls: list[int] = []
    guard = node.create_guard_condition(lambda: calls.append(1))
    first = in_thread(partial(executor.spin_once, 0.05))
    assert wait_until(lambda: executor.is_spinning)
    second = in_thread(partial(executor.spin_once, 30))
    first.join(30)
    guard.trigger()
    second.join(30)
    assert not second.is_alive()
    assert calls == [1]


def test_a_thread_spins_if_the_other_one_stops_before_its_turn_is_known(
    node: zbot.Node, executor: zbot.Executor, monkeypatch: pytest.MonkeyPatch
) -> None:
    tries = iter([False])  # at the first try, the other thread spins
    begin = executor._try_to_spin
    monkeypatch.setattr(executor, "_try_to_spin", lambda: next(tries, True) and begin())
    future: zbot.Future[None] = zbot.Future()
    node.create_guard_condition(lambda: future.set_result(None)).trigger()
    executor.spin_once(timeout_sec=1)
    assert wait_until(future.done)


def test_spin_once_of_a_second_thread_ends_with_the_context(
    context: zbot.Context, node: zbot.Node, single: zbot.Executor, spin: Spin
) -> None:
    spin(executor=single)
    assert wait_until(lambda: single.is_spinning)
    ended: list[BaseException] = []

    def once() -> None:
        try:
            zbot.spin_once(node)
        except zbot.ExternalShutdownException as error:
            ended.append(error)

    second = in_thread(once)
    assert wait_until(lambda: bool(single._turns))
    context.shutdown()
    second.join(30)
    assert len(ended) == 1


def test_a_callback_cannot_spin_its_executor_for_ever(
    node: zbot.Node, single: zbot.Executor
) -> None:
    node.create_guard_condition(single.spin).trigger()
    with pytest.raises(WrongStateError, match="already spinning"):
        single.spin_once(timeout_sec=1)
    single.spin_once(timeout_sec=0)


def test_other_callbacks_run_while_a_callback_spins_its_executor(
    node: zbot.Node, single: zbot.Executor
) -> None:
    calls: list[str] = []
    other = node.create_guard_condition(lambda: calls.append("other"))

    def outer() -> None:
        calls.append("outer")
        again.trigger()
        other.trigger()
        single.spin_once(timeout_sec=1)
        single.spin_once(timeout_sec=0)
        calls.append("end")

    again = node.create_guard_condition(outer)
    again.trigger()
    single.spin_once(timeout_sec=1)
    assert calls == ["outer", "other", "end"]


def test_a_callback_that_spins_its_executor_is_not_entered_again(
    node: zbot.Node, single: zbot.Executor
) -> None:
    depths: list[int] = []
    depth = 0

    def tick() -> None:
        nonlocal depth
        depth += 1
        depths.append(depth)
        single.spin_once(timeout_sec=0.01)
        depth -= 1

    node.create_timer(0.001, tick)
    for _ in range(3):
        single.spin_once(timeout_sec=1)
    assert depths == [1, 1, 1]


def test_a_callback_waits_for_a_future_by_spinning_its_own_node(
    node: zbot.Node, executor: zbot.Executor
) -> None:
    future: zbot.Future[str] = zbot.Future()
    answers: list[str | None] = []

    def ask() -> None:
        threading.Timer(0.01, future.set_result, ["42"]).start()
        zbot.spin_until_future_complete(node, future, timeout_sec=5)
        answers.append(future.result())

    node.create_guard_condition(ask).trigger()
    done: zbot.Future[None] = zbot.Future()
    watch = node.create_timer(
        0.005,
        lambda: done.set_result(None) if answers else None,
        callback_group=zbot.ReentrantCallbackGroup(),
    )
    executor.spin_until_future_complete(done, timeout_sec=5)
    watch.cancel()
    assert answers == ["42"]
    assert node.executor is executor


def test_a_future_can_be_waited_for_beside_a_spinning_thread(node: zbot.Node, spin: Spin) -> None:
    spinner = spin(node)
    assert wait_until(lambda: spinner.executor.is_spinning)
    done: zbot.Future[int] = zbot.Future()
    node.create_timer(0.01, lambda: done.set_result(1))
    zbot.spin_until_future_complete(node, done, timeout_sec=5)
    assert done.result() == 1
    zbot.spin_until_future_complete(node, zbot.Future(), timeout_sec=0.01)
    assert node.executor is spinner.executor


def test_spin_once_returns_a_node_to_its_executor(node: zbot.Node, executor: zbot.Executor) -> None:
    zbot.spin_once(node, timeout_sec=0)
    assert node.executor is executor


def test_two_threads_cannot_spin_one_executor(node: zbot.Node, spin: Spin) -> None:
    spinner = spin(node)
    assert wait_until(lambda: spinner.executor.is_spinning)
    with pytest.raises(RuntimeError, match="already spinning"):
        spinner.executor.spin()


def test_another_executor_may_spin_inside_a_callback(
    context: zbot.Context, node: zbot.Node, single: zbot.Executor
) -> None:
    other = zbot.Node("inner", context=context)
    calls: list[str] = []
    inner = zbot.SingleThreadedExecutor(context=context)
    inner.add_node(other)
    other.create_guard_condition(lambda: calls.append("inner")).trigger()
    node.create_guard_condition(lambda: inner.spin_once(timeout_sec=1)).trigger()
    single.spin_once(timeout_sec=1)
    assert calls == ["inner"]


def test_a_derived_executor_selects_the_thread(context: zbot.Context, node: zbot.Node) -> None:
    class Deferring(zbot.Executor):
        def spin_once(self, timeout_sec: float | None = None) -> None:
            handler, entity, owner = self.wait_for_ready_callbacks(timeout_sec=timeout_sec)
            threading.Thread(target=handler).start()
            taken.append((entity, owner))

    taken: list[tuple[object, object]] = []
    threads: list[int] = []
    with Deferring(context=context) as mine:
        mine.add_node(node)
        guard = node.create_guard_condition(lambda: threads.append(threading.get_ident()))
        guard.trigger()
        mine.spin_once(timeout_sec=1)
        assert wait_until(lambda: len(threads) == 1)
        assert taken == [(guard, node)]
        assert threads != [threading.get_ident()]
        with pytest.raises(TimeoutError, match="no callback was ready"):
            mine.wait_for_ready_callbacks(timeout_sec=0)
        mine.shutdown()
        with pytest.raises(RuntimeError, match="was shut down"):
            mine.wait_for_ready_callbacks()


# -- nodes -----------------------------------------------------------------------------------------


def test_a_node_is_added_once(node: zbot.Node, executor: zbot.Executor) -> None:
    assert not executor.add_node(node)
    assert executor.get_nodes() == [node]
    assert node.executor is executor


def test_a_node_belongs_to_the_executor_that_took_it_last(
    context: zbot.Context, node: zbot.Node, single: zbot.Executor
) -> None:
    second = zbot.SingleThreadedExecutor(context=context)
    assert second.add_node(node)
    assert (single.get_nodes(), second.get_nodes()) == ([], [node])
    calls: list[int] = []
    node.create_guard_condition(lambda: calls.append(1)).trigger()
    single.spin_once(timeout_sec=0)
    assert calls == []
    second.spin_once(timeout_sec=1)
    assert calls == [1]


def test_setting_a_nodes_executor_moves_it(
    context: zbot.Context, node: zbot.Node, single: zbot.Executor
) -> None:
    second = zbot.SingleThreadedExecutor(context=context)
    node.executor = second
    assert (single.get_nodes(), second.get_nodes()) == ([], [node])
    node.executor = None
    assert second.get_nodes() == []
    assert node.executor is None


def test_work_of_a_node_without_an_executor_is_kept(node: zbot.Node, single: zbot.Executor) -> None:
    calls: list[int] = []
    guard = node.create_guard_condition(lambda: calls.append(1))
    single.remove_node(node)
    guard.trigger()
    single.spin_once(timeout_sec=0)
    assert calls == []
    single.add_node(node)
    single.spin_once(timeout_sec=1)
    assert calls == [1]


def test_a_node_removed_in_its_own_timer_runs_no_more(
    node: zbot.Node, single: zbot.Executor
) -> None:
    calls: list[int] = []

    def leave() -> None:
        calls.append(1)
        single.remove_node(node)

    node.create_timer(0.0, leave)
    single.spin_once(timeout_sec=1)
    single.spin_once(timeout_sec=0.01)
    assert calls == [1]


def test_removing_a_node_loses_no_work_of_other_nodes(
    context: zbot.Context, node: zbot.Node, single: zbot.Executor, spin: Spin
) -> None:
    calls: list[int] = []
    guard = node.create_guard_condition(lambda: calls.append(1))
    visitor = zbot.Node("visitor", context=context)
    for _ in range(20):
        visitor.create_guard_condition(lambda: None)
    spinner = spin(node, executor=single)
    for turn in range(300):
        single.add_node(visitor)
        guard.trigger()
        single.remove_node(visitor)
        assert wait_until(lambda turn=turn: len(calls) == turn + 1)  # type: ignore[misc]
    assert spinner.error is None


def test_spin_once_of_the_module_leaves_no_executor_and_no_work(
    context: zbot.Context, node: zbot.Node
) -> None:
    node.create_timer(100.0, lambda: None)
    for _ in range(100):
        zbot.spin_once(node, timeout_sec=0)
    assert node.executor is None
    zbot.spin_once(zbot.Node("visitor", context=context), timeout_sec=0)
    executor = zbot.get_global_executor(context)
    assert len(executor._ready) == 0
    assert executor._timers.earliest_ns() is None


def test_spin_once_runs_no_callback_of_a_node_that_was_spun_before(
    context: zbot.Context, node: zbot.Node
) -> None:
    calls: list[str] = []
    visitor = zbot.Node("visitor", context=context)
    zbot.spin_once(node, timeout_sec=0)
    for owner in (node, visitor):
        owner.create_guard_condition(partial(calls.append, owner.get_name())).trigger()
    for wanted in (visitor, node):
        for _ in range(20):
            zbot.spin_once(wanted, timeout_sec=0)
        assert calls == [wanted.get_name()]
        calls.clear()


def test_nodes_share_an_executor_fairly(context: zbot.Context, single: zbot.Executor) -> None:
    order: list[str] = []
    for name in ("busy", "calm"):
        node = zbot.Node(name, context=context)
        node.create_timer(0.0, lambda name=name: order.append(name))
        single.add_node(node)
    for _ in range(20):
        single.spin_once(timeout_sec=1)
    assert order.count("calm") == order.count("busy") == 10


def test_a_busy_topic_leaves_room_for_timers(node: zbot.Node, spin: Spin) -> None:
    publisher = node.create_publisher(Int64, "echo", 10)
    ticks: list[int] = []
    node.create_subscription(Int64, "echo", publisher.publish, 10)
    node.create_timer(0.001, lambda: ticks.append(1))
    spin(node)
    publisher.publish(Int64())
    assert wait_until(lambda: len(ticks) > 20)


class CountingFuture(zbot.Future[None]):
    """Future that counts the functions that wait for it."""

    wakers = 0

    def add_waker(self, waker: Callable[[], object]) -> None:
        self.wakers += 1
        super().add_waker(waker)

    def remove_waker(self, waker: Callable[[], object]) -> None:
        self.wakers -= 1
        super().remove_waker(waker)


def test_a_future_forgets_the_spins_that_are_over(executor: zbot.Executor) -> None:
    future = CountingFuture()
    for _ in range(3):
        executor.spin_until_future_complete(future, 0.0)
        executor.spin_once_until_future_complete(future, 0.0)
    assert future.wakers == 0


def test_the_context_does_not_keep_a_dropped_executor(context: zbot.Context) -> None:
    dropped = weakref.ref(zbot.SingleThreadedExecutor(context=context))
    gc.collect()
    assert dropped() is None
