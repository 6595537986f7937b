"""Who runs callbacks, when, and beside what."""

from __future__ import annotations

import threading
import time
from typing import TYPE_CHECKING, Any

import pytest

import zbot
from tests.conftest import wait_until
from zbot.errors import ExecutorBusyError, NotInitializedError, ShutdownError

from std_msgs.msg import Int64

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    from tests.conftest import Spinner

    MakeContext = Callable[[], zbot.Context]
    Spin = Callable[..., Spinner]
    MakeExecutor = Callable[..., zbot.Executor]

BOTH = [zbot.SingleThreadedExecutor, zbot.MultiThreadedExecutor]


@pytest.fixture
def context(make_context: MakeContext) -> zbot.Context:
    return make_context()


@pytest.fixture
def node(context: zbot.Context) -> zbot.Node:
    return zbot.Node("worker", context=context)


@pytest.fixture(params=BOTH)
def executor(request: pytest.FixtureRequest, node: zbot.Node) -> Iterator[zbot.Executor]:
    with request.param(context=node.context) as made:
        made.add_node(node)
        yield made


@pytest.fixture
def single(node: zbot.Node) -> Iterator[zbot.SingleThreadedExecutor]:
    with zbot.SingleThreadedExecutor(context=node.context) as made:
        made.add_node(node)
        yield made


@pytest.fixture
def multi(node: zbot.Node) -> Iterator[zbot.MultiThreadedExecutor]:
    with zbot.MultiThreadedExecutor(4, context=node.context) as made:
        made.add_node(node)
        yield made


def complete(executor: zbot.Executor, future: zbot.Future[Any], timeout_sec: float = 5) -> Any:
    executor.spin_until_future_complete(future, timeout_sec)
    assert future.done()
    return future.result()


def settle(executor: zbot.Executor) -> None:
    """Run what is ready until nothing is."""
    marker: zbot.Future[bool] = zbot.Future()
    executor.create_task(lambda: executor.create_task(marker.set_result, True))
    complete(executor, marker)


class Overlap:
    """Counts how many callbacks are inside at once."""

    def __init__(self, expected: int) -> None:
        self.most = self._inside = self.calls = 0
        self._lock = threading.Lock()
        self._gate = threading.Barrier(expected)

    def visit(self, *, meet: bool) -> None:
        with self._lock:
            self._inside += 1
            self.calls += 1
            self.most = max(self.most, self._inside)
        if meet:
            self._gate.wait(5)
        else:
            threading.Event().wait(0.001)
        with self._lock:
            self._inside -= 1


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
def test_spin_once_returns_when_nothing_comes_in_time(
    executor: zbot.Executor, timeout: float
) -> None:
    begin = time.monotonic()
    executor.spin_once(timeout_sec=timeout)
    assert timeout <= time.monotonic() - begin < timeout + 0.5


def test_spin_once_without_waiting_runs_what_is_ready(
    node: zbot.Node, single: zbot.Executor
) -> None:
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


def test_spinning_until_a_future_gives_up_in_time(executor: zbot.Executor) -> None:
    future: zbot.Future[str] = zbot.Future()
    begin = time.monotonic()
    executor.spin_until_future_complete(future, timeout_sec=0.02)
    assert 0.02 <= time.monotonic() - begin < 0.5
    assert not future.done()


def test_spinning_until_a_future_with_no_time_still_runs_what_is_ready(
    single: zbot.Executor,
) -> None:
    task = single.create_task(lambda: 7)
    single.spin_until_future_complete(task, timeout_sec=0)
    assert task.result() == 7


def test_spinning_until_a_cancelled_future_ends(executor: zbot.Executor) -> None:
    future: zbot.Future[str] = zbot.Future()
    future.cancel()
    executor.spin_until_future_complete(future, timeout_sec=5)
    assert future.cancelled()
    assert not future.done()


def test_an_executor_cannot_spin_inside_its_own_callback(
    node: zbot.Node, single: zbot.Executor
) -> None:
    node.create_guard_condition(single.spin_once).trigger()
    with pytest.raises(ExecutorBusyError, match="already spinning"):
        single.spin_once(timeout_sec=1)
    single.spin_once(timeout_sec=0)


def test_two_threads_cannot_spin_one_executor(node: zbot.Node, spin: Spin) -> None:
    spinner = spin(node)
    assert wait_until(spinner.executor._spinning.locked)
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


def test_work_that_came_while_a_node_had_no_executor_is_kept(
    node: zbot.Node, single: zbot.Executor
) -> None:
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


def test_removing_a_node_never_loses_the_posts_of_others(
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


def test_spin_once_of_the_module_leaves_nothing_behind(
    context: zbot.Context, node: zbot.Node
) -> None:
    node.create_timer(100.0, lambda: None)
    for _ in range(100):
        zbot.spin_once(node, timeout_sec=0)
    assert node.executor is None
    executor = zbot.get_global_executor(context)
    assert len(executor._ready) == 0
    assert executor._agenda.earliest_ns() is None


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


# -- callback groups -------------------------------------------------------------------------------


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
    with zbot.MultiThreadedExecutor(1, context=node.context) as executor:
        spin(node, executor=executor)
        assert wait_until(lambda: overlap.calls > 20)
        assert overlap.most == 1


def test_blocked_threads_do_not_hold_up_spin_once(
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
        assert time.monotonic() - begin < 1
    finally:
        gate.set()


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
    settle(executor)
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


def test_a_task_returns_what_its_coroutine_does(executor: zbot.Executor) -> None:
    async def inner(number: int) -> int:
        return number + 1

    async def outer(number: int, *, factor: int) -> int:
        task = executor.create_task(inner, number)
        assert await inner(1) == 2
        return factor * (await task or 0)

    assert complete(executor, executor.create_task(outer, 4, factor=10)) == 50
    assert complete(executor, executor.create_task(inner(1))) == 2


def test_done_callbacks_run_in_the_executor(single: zbot.Executor) -> None:
    future = single.create_future()
    threads: list[threading.Thread] = []
    future.add_done_callback(lambda _: threads.append(threading.current_thread()))
    other = threading.Thread(target=future.set_result, args=(1,))
    other.start()
    other.join()
    assert threads == []
    settle(single)
    future.add_done_callback(lambda _: threads.append(threading.current_thread()))
    settle(single)
    assert threads == [threading.current_thread()] * 2


def test_a_task_that_raises_ends_spinning_as_in_rclpy(executor: zbot.Executor) -> None:
    def fail() -> None:
        raise LookupError("in a task")

    task = executor.create_task(fail)
    with pytest.raises(LookupError, match="in a task"):
        executor.spin_until_future_complete(zbot.Future(), timeout_sec=5)
    assert isinstance(task.exception(), LookupError)


def test_an_await_raises_what_the_future_holds(executor: zbot.Executor) -> None:
    future: zbot.Future[None] = zbot.Future()

    async def ask() -> str:
        try:
            await future
        except LookupError as exc:
            return str(exc)
        return "nothing"

    task = executor.create_task(ask)
    settle(executor)
    future.set_exception(LookupError("remote"))
    assert complete(executor, task) == "remote"


def test_a_cancelled_task_goes_no_further(executor: zbot.Executor) -> None:
    future: zbot.Future[None] = zbot.Future()
    steps: list[str] = []

    async def work() -> None:
        steps.append("begin")
        await future
        steps.append("end")

    task = executor.create_task(work)
    settle(executor)
    assert wait_until(lambda: steps == ["begin"] and not task.executing())
    task.cancel()
    future.set_result(None)
    settle(executor)
    assert steps == ["begin"]
    assert task.cancelled()


# -- guard conditions ------------------------------------------------------------------------------


def test_a_guard_runs_once_for_many_triggers(node: zbot.Node, executor: zbot.Executor) -> None:
    calls: list[int] = []
    guard = node.create_guard_condition(lambda: calls.append(1))
    for _ in range(10):
        guard.trigger()
    settle(executor)
    assert wait_until(lambda: calls == [1])
    guard.trigger()
    settle(executor)
    assert wait_until(lambda: calls == [1, 1])


def test_a_destroyed_guard_is_silent(node: zbot.Node, executor: zbot.Executor) -> None:
    calls: list[int] = []
    guard = node.create_guard_condition(lambda: calls.append(1))
    guard.trigger()
    assert node.destroy_guard_condition(guard)
    guard.trigger()
    settle(executor)
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


# -- exceptions ------------------------------------------------------------------------------------


@pytest.mark.parametrize("is_async", [False, True])
def test_an_exception_of_a_callback_leaves_spin_and_the_next_spin_works(
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
    # The group must be free again, for another executor too.
    with zbot.SingleThreadedExecutor(context=node.context) as second:
        second.add_node(node)
        node.create_guard_condition(lambda: calls.append(1)).trigger()
        second.spin_once(timeout_sec=1)
    assert calls == [1]


def test_an_exception_after_an_await_leaves_spin(node: zbot.Node, executor: zbot.Executor) -> None:
    future: zbot.Future[None] = zbot.Future()

    async def fail() -> None:
        await future
        raise LookupError("after an await")

    node.create_guard_condition(fail).trigger()
    settle(executor)
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
    with pytest.raises(NotInitializedError, match=r"zbot\.init\(\)"):
        zbot.Node("early")
