"""Actions between nodes: goals, feedback, results, cancels, and what happens when things fail."""

from __future__ import annotations

import signal
import threading
from functools import partial
from typing import TYPE_CHECKING, Any

import pytest

import zbot
from tests.conftest import wait_until
from zbot.action import (
    ActionClient,
    ActionMessageError,
    ActionServer,
    CancelResponse,
    ClientGoalHandle,
    GoalResponse,
    GoalState,
    GoalTransitionError,
    NotAnActionTypeError,
    ServerGoalHandle,
    get_action_client_names_and_types_by_node,
    get_action_names_and_types,
    get_action_server_names_and_types_by_node,
)
from zbot.errors import InvalidServiceNameError, ServiceError, UnknownNodeError
from zbot.service_introspection import ServiceIntrospectionState

from action_msgs.msg import GoalStatusArray
from action_msgs.srv import CancelGoal
from example_interfaces.action import Fibonacci
from std_msgs.msg import String
from unique_identifier_msgs.msg import UUID

if TYPE_CHECKING:
    from collections.abc import Callable

    from tests.conftest import Program, Spinner
    from zbot.log.record import Record

    MakeContext = Callable[[], zbot.Context]
    Spin = Callable[..., Spinner]

Goal = ServerGoalHandle[Any, Any, Any]
Handle = ClientGoalHandle[Any, Any, Any]


def sequence(order: int) -> list[int]:
    numbers = [0, 1]
    while len(numbers) <= order:
        numbers.append(numbers[-1] + numbers[-2])
    return numbers


def compute(goal: Goal) -> Fibonacci.Result:
    numbers = sequence(goal.request.order)
    for end in range(2, len(numbers)):
        goal.publish_feedback(Fibonacci.Feedback(sequence=numbers[: end + 1]))
    goal.succeed()
    return Fibonacci.Result(sequence=numbers)


def accept_cancel(_: Goal) -> CancelResponse:
    return CancelResponse.ACCEPT


class Pair:
    """A server and a client, each in a context of its own, spinning in threads."""

    def __init__(self, make_context: MakeContext, spin: Spin) -> None:
        self.server_node = zbot.Node("server", context=make_context())
        self.client_node = zbot.Node("client", context=make_context())
        self._spin = spin
        self.server: ActionServer[Any, Any, Any]
        self.client: ActionClient[Any, Any, Any]

    def begin(self, execute: Callable[[Goal], Any], threads: int = 1, **options: Any) -> None:
        context = self.server_node.context
        self.server = ActionServer(self.server_node, Fibonacci, "fibonacci", execute, **options)
        self.client = ActionClient(self.client_node, Fibonacci, "fibonacci")
        executor: zbot.Executor = zbot.SingleThreadedExecutor(context=context)
        if threads > 1:
            executor = zbot.MultiThreadedExecutor(threads, context=context)
        self.serving = self._spin(self.server_node, executor=executor)
        self._spin(self.client_node)
        assert self.client.wait_for_server(5)

    def send(self, order: int = 5, **options: Any) -> Handle:
        future = self.client.send_goal_async(Fibonacci.Goal(order=order), **options)
        handle = done(future)
        assert isinstance(handle, ClientGoalHandle)
        return handle


def done(future: zbot.Future[Any], timeout_s: float = 5.0) -> Any:
    over = threading.Event()
    future.add_waker(over.set)
    assert over.wait(timeout_s), "the future was never completed"
    return future.result()


@pytest.fixture
def pair(make_context: MakeContext, spin: Spin) -> Pair:
    return Pair(make_context, spin)


def status_of(response: Any) -> GoalState:
    return GoalState(response.status)


# -- goals and results -------------------------------------------------------------------------


def test_a_goal_gives_feedback_and_a_result(pair: Pair) -> None:
    pair.begin(compute)
    heard: list[list[int]] = []
    handle = pair.send(5, feedback_callback=lambda told: heard.append(list(told.feedback.sequence)))
    assert handle.accepted
    response = done(handle.get_result_async())
    assert status_of(response) is GoalState.SUCCEEDED
    assert list(response.result.sequence) == sequence(5)
    assert heard == [sequence(end) for end in range(2, 6)]
    assert handle.status == GoalState.SUCCEEDED


def test_send_goal_waits_for_the_end(pair: Pair) -> None:
    pair.begin(compute)
    response = pair.client.send_goal(Fibonacci.Goal(order=3))
    assert list(response.result.sequence) == sequence(3)
    assert status_of(response) is GoalState.SUCCEEDED


def test_a_result_can_be_asked_for_by_many_and_after_the_end(pair: Pair) -> None:
    ended = threading.Event()

    async def wait(goal: Goal) -> Fibonacci.Result:
        await started
        goal.succeed()
        return Fibonacci.Result(sequence=[7])

    started: zbot.Future[None] = zbot.Future()
    pair.begin(wait)
    handle = pair.send()
    futures = [handle.get_result_async() for _ in range(3)]
    futures[0].add_done_callback(lambda _: ended.set())
    started.set_result(None)
    assert [list(done(future).result.sequence) for future in futures] == [[7]] * 3
    assert ended.wait(5)
    assert list(handle.get_result().result.sequence) == [7]


def test_a_goal_has_the_id_that_it_was_given_and_only_one_of_them_is_accepted(pair: Pair) -> None:
    pair.begin(compute)
    mine = UUID(uuid=list(range(16)))
    assert pair.send(goal_uuid=mine).goal_id == mine
    assert not pair.send(goal_uuid=mine).accepted


def test_the_stamp_is_the_time_of_acceptance_by_the_servers_clock(pair: Pair) -> None:
    pair.begin(compute)
    before = pair.server_node.get_clock().now()
    stamp = zbot.Time.from_msg(pair.send().stamp)
    assert before <= stamp <= pair.server_node.get_clock().now()


def test_a_coroutine_can_send_goals_and_await_results_in_the_nodes_own_group(pair: Pair) -> None:
    pair.begin(compute)
    results: list[Any] = []

    async def ask() -> None:
        timer.cancel()
        handle: Any = await pair.client.send_goal_async(Fibonacci.Goal(order=4))
        results.append(await handle.get_result_async())

    timer = pair.client_node.create_timer(0, ask)
    assert wait_until(lambda: bool(results))
    assert list(results[0].result.sequence) == sequence(4)


def test_done_callbacks_run_in_the_executor_and_may_be_coroutines(pair: Pair) -> None:
    pair.begin(compute)
    threads: list[int] = []
    results: list[Any] = []

    async def on_handle(future: zbot.Future[Any]) -> None:
        threads.append(threading.get_ident())
        handle: Any = future.result()
        results.append(await handle.get_result_async())

    pair.client.send_goal_async(Fibonacci.Goal(order=2)).add_done_callback(on_handle)
    assert wait_until(lambda: bool(results))
    assert threads != [threading.get_ident()]


def test_a_server_can_ask_another_action_while_it_executes(pair: Pair) -> None:
    inner = ActionServer(pair.server_node, Fibonacci, "inner", compute)
    asking = ActionClient[Any, Any, Any](pair.server_node, Fibonacci, "inner")

    async def delegate(goal: Goal) -> Fibonacci.Result:
        handle: Any = await asking.send_goal_async(goal.request)
        response: Any = await handle.get_result_async()
        goal.succeed()
        return Fibonacci.Result(sequence=response.result.sequence)

    pair.begin(delegate)
    assert list(done(pair.send(6).get_result_async()).result.sequence) == sequence(6)
    inner.destroy()


# -- decisions ---------------------------------------------------------------------------------


def test_a_goal_callback_decides_and_sees_the_goal(pair: Pair) -> None:
    asked: list[int] = []

    def decide(goal: Fibonacci.Goal) -> GoalResponse:
        asked.append(goal.order)
        return GoalResponse.ACCEPT if goal.order < 10 else GoalResponse.REJECT

    pair.begin(compute, goal_callback=decide)
    assert pair.send(3).accepted
    refused = pair.send(30)
    assert not refused.accepted
    assert asked == [3, 30]
    assert status_of(refused.get_result()) is GoalState.UNKNOWN


def test_callbacks_may_be_coroutines(pair: Pair) -> None:
    async def decide(goal: Fibonacci.Goal) -> GoalResponse:
        await allowed
        return GoalResponse.ACCEPT if goal.order else GoalResponse.REJECT

    async def stop(_: Goal) -> CancelResponse:
        await allowed
        return CancelResponse.ACCEPT

    async def accepted(goal: Goal) -> None:
        await allowed
        goal.execute()

    async def execute(goal: Goal) -> Fibonacci.Result:
        await finished
        goal.canceled()
        return Fibonacci.Result()

    allowed: zbot.Future[None] = zbot.Future()
    finished: zbot.Future[None] = zbot.Future()
    pair.begin(
        execute, goal_callback=decide, cancel_callback=stop, handle_accepted_callback=accepted
    )
    future = pair.client.send_goal_async(Fibonacci.Goal(order=1))
    allowed.set_result(None)
    handle = done(future)
    assert len(done(handle.cancel_goal_async()).goals_canceling) == 1
    finished.set_result(None)
    assert status_of(done(handle.get_result_async())) is GoalState.CANCELED


def test_a_goal_callback_without_an_answer_rejects_and_says_so(
    pair: Pair, logged: list[Record]
) -> None:
    pair.begin(compute, goal_callback=lambda _: None)
    assert not pair.send().accepted
    assert any("returned None, not a GoalResponse" in record.message for record in logged)


def test_an_accepted_goal_may_be_executed_later_and_by_another_callback(pair: Pair) -> None:
    waiting: list[Goal] = []
    pair.begin(compute, handle_accepted_callback=waiting.append)
    handle = pair.send(2)
    assert wait_until(lambda: bool(waiting))
    result = handle.get_result_async()
    assert waiting[0].status == GoalState.ACCEPTED
    assert waiting[0].is_active
    assert not result.done()

    def other(goal: Goal) -> Fibonacci.Result:
        goal.succeed()
        return Fibonacci.Result(sequence=[99])

    waiting[0].execute(other)
    assert list(done(result).result.sequence) == [99]


def test_the_client_hears_of_acceptance_before_the_server_goes_on(pair: Pair) -> None:
    """Its answer is sent before `handle_accepted_callback` runs, which may take its time."""
    release = threading.Event()
    pair.begin(compute, handle_accepted_callback=lambda goal: (release.wait(5), goal.execute()))
    handle = pair.send(1)
    assert handle.accepted
    release.set()
    assert status_of(done(handle.get_result_async())) is GoalState.SUCCEEDED


def test_callbacks_can_be_replaced(pair: Pair) -> None:
    pair.begin(compute)

    def other(goal: Goal) -> Fibonacci.Result:
        goal.abort()
        return Fibonacci.Result(sequence=[1])

    pair.server.register_execute_callback(other)
    assert status_of(pair.client.send_goal(Fibonacci.Goal())) is GoalState.ABORTED
    pair.server.register_goal_callback(lambda _: GoalResponse.REJECT)
    assert not pair.send().accepted
    pair.server.register_goal_callback(None)
    pair.server.register_handle_accepted_callback(None)
    pair.server.register_cancel_callback(None)
    assert pair.send().accepted
    with pytest.raises(TypeError, match="not callable"):
        pair.server.register_execute_callback(None)  # type: ignore[arg-type]


# -- ends --------------------------------------------------------------------------------------


def test_an_exception_aborts_the_goal_and_is_reported_from_the_users_line(
    pair: Pair, logged: list[Record]
) -> None:
    def fail(goal: Goal) -> Fibonacci.Result:
        raise ValueError(f"order {goal.request.order} is too much")

    pair.begin(fail)
    response = pair.client.send_goal(Fibonacci.Goal(order=9))
    assert status_of(response) is GoalState.ABORTED
    assert list(response.result.sequence) == []
    errors = [record.message for record in logged if "execute callback" in record.message]
    assert errors[0].startswith("Error raised in execute callback: order 9 is too much\n")
    assert "in fail" in errors[0]
    assert "zbot/action" not in errors[0]
    pair.server.register_execute_callback(compute)
    assert status_of(pair.client.send_goal(Fibonacci.Goal(order=1))) is GoalState.SUCCEEDED


def test_a_goal_that_is_left_without_an_end_is_aborted(pair: Pair, logged: list[Record]) -> None:
    pair.begin(lambda _: Fibonacci.Result(sequence=[3]))
    response = pair.client.send_goal(Fibonacci.Goal())
    assert status_of(response) is GoalState.ABORTED
    assert list(response.result.sequence) == [3]
    assert any("Goal state not set, assuming aborted" in record.message for record in logged)


def test_a_missing_result_is_told_and_an_empty_one_sent(pair: Pair, logged: list[Record]) -> None:
    pair.begin(lambda goal: goal.succeed())
    response = pair.client.send_goal(Fibonacci.Goal())
    assert status_of(response) is GoalState.SUCCEEDED
    assert any("does it end with `return result`?" in record.message for record in logged)


def test_a_result_of_another_type_aborts(pair: Pair, logged: list[Record]) -> None:
    pair.begin(lambda _: String(data="five"))
    assert status_of(pair.client.send_goal(Fibonacci.Goal())) is GoalState.ABORTED
    expected = "/fibonacci takes a example_interfaces/action/Fibonacci_Result, not std_msgs.msg."
    assert any(expected in record.message for record in logged)


def test_an_end_with_a_result_is_told_at_once(pair: Pair) -> None:
    release = threading.Event()

    def linger(goal: Goal) -> None:
        goal.succeed(Fibonacci.Result(sequence=[5]))
        release.wait(5)

    pair.begin(linger)
    try:
        assert list(done(pair.send().get_result_async()).result.sequence) == [5]
    finally:
        release.set()


def test_what_a_state_does_not_allow_raises(pair: Pair) -> None:
    refused: list[str] = []

    def execute(goal: Goal) -> Fibonacci.Result:
        for step in (goal.canceled, goal.execute, goal.succeed, goal.succeed, goal.abort):
            try:
                step()
            except GoalTransitionError as error:
                refused.append(f"{error.event.name} in {error.state.name}")
        return Fibonacci.Result()

    pair.begin(execute)
    pair.client.send_goal(Fibonacci.Goal())
    assert refused == [
        "CANCELED in EXECUTING",
        "EXECUTE in EXECUTING",
        "SUCCEED in SUCCEEDED",
        "ABORT in SUCCEEDED",
    ]


def test_results_expire_and_leave_nothing_behind(pair: Pair) -> None:
    kept: list[Goal] = []

    def execute(goal: Goal) -> Fibonacci.Result:
        kept.append(goal)
        return compute(goal)

    pair.begin(execute, result_timeout=0.05)
    handle = pair.send(1)
    assert status_of(handle.get_result()) is GoalState.SUCCEEDED
    assert wait_until(lambda: kept[0].status == GoalState.UNKNOWN)
    assert not kept[0].is_active
    assert status_of(handle.get_result()) is GoalState.UNKNOWN
    kept[0].publish_feedback(Fibonacci.Feedback())  # nobody is there; nothing happens
    kept[0].succeed()


@pytest.mark.parametrize(("timeout", "state"), [(-1, "SUCCEEDED"), (0, "UNKNOWN")])
def test_a_result_is_kept_for_ever_or_not_at_all(pair: Pair, timeout: int, state: str) -> None:
    pair.begin(compute, result_timeout=timeout)
    handle = pair.send(1)
    kept = GoalState[state]
    assert wait_until(lambda: status_of(handle.get_result()) is kept)


# -- canceling ---------------------------------------------------------------------------------


async def until_canceled(goal: Goal) -> Fibonacci.Result:
    while not goal.is_cancel_requested:
        goal.publish_feedback(Fibonacci.Feedback(sequence=[goal.request.order]))
        await _turn(goal)
    goal.canceled()
    return Fibonacci.Result(sequence=[goal.request.order])


async def _turn(goal: Goal) -> None:
    """Let others run, and go on a little later."""
    later: zbot.Future[None] = zbot.Future()
    node = goal._action_server._node
    timer = node.create_timer(0.01, lambda: later.set_result(None))
    await later
    node.destroy_timer(timer)


def cancel(pair: Pair, **info: Any) -> tuple[int, list[int]]:
    """Ask the cancel service, and return its code with the goals' last bytes."""
    client = pair.client_node.create_client(CancelGoal, "/fibonacci/_action/cancel_goal")
    request = CancelGoal.Request()
    for name, value in info.items():
        setattr(request.goal_info, name, value)
    response = client.call(request, 5)
    return response.return_code, [int(goal.goal_id.uuid[15]) for goal in response.goals_canceling]


def goal_id(number: int) -> UUID:
    return UUID(uuid=[1] * 15 + [number])


def test_a_goal_is_canceled_when_the_server_agrees(pair: Pair) -> None:
    pair.begin(until_canceled, cancel_callback=accept_cancel)
    handle = pair.send(8)
    answer = handle.cancel_goal()
    assert answer.return_code == CancelGoal.Response.ERROR_NONE
    assert [info.goal_id for info in answer.goals_canceling] == [handle.goal_id]
    response = done(handle.get_result_async())
    assert status_of(response) is GoalState.CANCELED
    assert list(response.result.sequence) == [8]
    assert handle.cancel_goal().return_code == CancelGoal.Response.ERROR_GOAL_TERMINATED


def test_no_goal_is_canceled_unless_the_server_has_a_callback(pair: Pair) -> None:
    waiting: list[Goal] = []
    pair.begin(compute, handle_accepted_callback=waiting.append)
    handle = pair.send(3)
    answer = done(handle.cancel_goal_async())
    assert answer.return_code == CancelGoal.Response.ERROR_REJECTED
    assert list(answer.goals_canceling) == []
    assert wait_until(lambda: bool(waiting))
    waiting[0].execute()
    assert status_of(done(handle.get_result_async())) is GoalState.SUCCEEDED


def test_a_goal_may_end_while_the_server_decides_about_canceling_it(pair: Pair) -> None:
    waiting: list[Goal] = []

    def decide(goal: Goal) -> CancelResponse:
        goal.succeed()
        return CancelResponse.ACCEPT

    async def execute(goal: Goal) -> Fibonacci.Result:
        waiting.append(goal)
        await zbot.Future()
        return Fibonacci.Result()

    pair.begin(execute, cancel_callback=decide)
    handle = pair.send()
    assert wait_until(lambda: bool(waiting))
    assert list(handle.cancel_goal().goals_canceling) == []


def test_a_goal_that_was_never_executed_can_be_canceled(pair: Pair) -> None:
    waiting: list[Goal] = []
    pair.begin(compute, handle_accepted_callback=waiting.append, cancel_callback=accept_cancel)
    handle = pair.send()
    result = handle.get_result_async()
    assert wait_until(lambda: bool(waiting))
    assert len(handle.cancel_goal().goals_canceling) == 1
    waiting[0].canceled()
    assert status_of(done(result)) is GoalState.CANCELED


def test_a_goal_that_is_to_be_canceled_is_executed_so_that_it_can_end_itself(pair: Pair) -> None:
    waiting: list[Goal] = []
    pair.begin(
        until_canceled, handle_accepted_callback=waiting.append, cancel_callback=accept_cancel
    )
    handle = pair.send(4)
    assert wait_until(lambda: bool(waiting))
    handle.cancel_goal()
    waiting[0].execute()
    assert list(done(handle.get_result_async()).result.sequence) == [4]


def test_goals_are_canceled_all_or_until_a_time_or_one(pair: Pair) -> None:
    pair.begin(until_canceled, cancel_callback=accept_cancel)
    handles = [pair.send(number, goal_uuid=goal_id(number)) for number in range(6)]
    assert cancel(pair, goal_id=goal_id(9)) == (2, [])
    assert cancel(pair, goal_id=goal_id(3)) == (0, [3])
    assert cancel(pair, stamp=handles[1].stamp) == (0, [0, 1])
    assert cancel(pair, goal_id=goal_id(5), stamp=handles[2].stamp) == (0, [2, 5])
    assert cancel(pair) == (0, [4])
    assert cancel(pair) == (0, [])
    for handle in handles:
        assert status_of(done(handle.get_result_async())) is GoalState.CANCELED


# -- several goals -----------------------------------------------------------------------------


def test_a_new_goal_can_preempt_the_one_before(pair: Pair) -> None:
    lock = threading.Lock()
    present: list[Goal] = []

    def accepted(goal: Goal) -> None:
        with lock:
            if present and present[-1].is_active:
                present[-1].abort()
            present.append(goal)
        goal.execute()

    async def execute(goal: Goal) -> Fibonacci.Result:
        while goal.is_active and goal.request.order:
            await _turn(goal)
        if goal.is_active:
            goal.succeed()
        return Fibonacci.Result(sequence=[goal.request.order])

    pair.begin(execute, handle_accepted_callback=accepted)
    first, second, last = pair.send(1), pair.send(2), pair.send(0)
    states = [status_of(done(one.get_result_async())).name for one in (first, second, last)]
    assert states == ["ABORTED", "ABORTED", "SUCCEEDED"]


def test_blocking_callbacks_run_beside_each_other_in_threads(pair: Pair) -> None:
    barrier = threading.Barrier(3)

    def meet(goal: Goal) -> Fibonacci.Result:
        barrier.wait(5)
        goal.succeed()
        return Fibonacci.Result(sequence=[goal.request.order])

    group = zbot.ReentrantCallbackGroup()
    pair.begin(meet, threads=4, callback_group=group)
    results = [pair.send(order).get_result_async() for order in range(3)]
    assert [list(done(one).result.sequence) for one in results] == [[0], [1], [2]]


def test_feedback_reaches_the_goal_that_it_is_about(pair: Pair) -> None:
    pair.begin(compute)
    heard: dict[int, list[int]] = {order: [] for order in (3, 5, 7)}
    handles = [
        pair.send(
            order,
            feedback_callback=lambda told, order=order: heard[order].append(
                len(told.feedback.sequence)
            ),
        )
        for order in heard
    ]
    for handle in handles:
        done(handle.get_result_async())
    assert heard == {order: list(range(3, order + 2)) for order in heard}


def test_two_clients_hear_only_of_their_own_goals(pair: Pair) -> None:
    pair.begin(compute)
    other = ActionClient[Any, Any, Any](pair.client_node, Fibonacci, "fibonacci")
    heard: list[str] = []
    one = pair.send(2, feedback_callback=lambda _: heard.append("one"))
    two = done(other.send_goal_async(Fibonacci.Goal(order=2), lambda _: heard.append("two")))
    done(one.get_result_async())
    done(two.get_result_async())
    assert sorted(heard) == ["one", "two"]


def _note(heard: set[int], told: Any) -> None:
    heard.add(told.feedback.sequence[0])


def test_fifty_goals_with_cancels_each_get_their_own_answer(pair: Pair) -> None:
    stops: dict[bytes, zbot.Future[None]] = {}

    def stop(goal: Goal) -> CancelResponse:
        stops[goal.key].set_result(None)
        return CancelResponse.ACCEPT

    async def execute(goal: Goal) -> Fibonacci.Result:
        goal.publish_feedback(Fibonacci.Feedback(sequence=[goal.request.order]))
        if goal.request.order % 2:
            await stops[goal.key]
            goal.canceled()
        else:
            goal.succeed()
        return Fibonacci.Result(sequence=[goal.request.order])

    def accepted(goal: Goal) -> None:
        stops[goal.key] = zbot.Future()
        goal.execute()

    pair.begin(execute, handle_accepted_callback=accepted, cancel_callback=stop, result_timeout=2)
    for turn in range(2):
        heard: set[int] = set()
        futures = [
            pair.client.send_goal_async(
                Fibonacci.Goal(order=order),
                partial(_note, heard),
            )
            for order in range(50)
        ]
        handles = [done(future, 10) for future in futures]
        results = [handle.get_result_async() for handle in handles]
        canceled = [handle.cancel_goal_async() for handle in handles[1::2]]
        assert all(len(done(one, 10).goals_canceling) == 1 for one in canceled), turn
        for order, result in enumerate(results):
            response = done(result, 10)
            assert list(response.result.sequence) == [order]
            expected = GoalState.CANCELED if order % 2 else GoalState.SUCCEEDED
            assert status_of(response) is expected
        assert heard == set(range(50))
        # Nothing is left of them, neither here nor, once results have expired, there.
        assert wait_until(lambda: not pair.client._goals)
        assert wait_until(lambda: not pair.server._goals)
    assert not pair.server._ended
    assert not pair.server._services[1]._waiting


# -- status ------------------------------------------------------------------------------------


def test_the_status_topic_tells_latecomers_where_each_goal_stands(pair: Pair) -> None:
    waiting: list[Goal] = []
    pair.begin(compute, handle_accepted_callback=waiting.append)
    handle = pair.send(2, goal_uuid=goal_id(7))
    assert wait_until(lambda: handle.status == GoalState.ACCEPTED)
    seen: list[list[tuple[int, int]]] = []
    pair.client_node.create_subscription(
        GoalStatusArray,
        "/fibonacci/_action/status",
        lambda told: seen.append(
            [(int(one.goal_info.goal_id.uuid[15]), one.status) for one in told.status_list]
        ),
        zbot.QoSProfile(depth=1, durability=zbot.DurabilityPolicy.TRANSIENT_LOCAL),
    )
    assert wait_until(lambda: seen == [[(7, GoalState.ACCEPTED.value)]])
    waiting[0].execute()
    assert wait_until(lambda: seen[-1] == [(7, GoalState.SUCCEEDED.value)])
    assert wait_until(lambda: handle.status == GoalState.SUCCEEDED)


def test_a_client_forgets_goals_whose_handle_nobody_keeps(pair: Pair) -> None:
    pair.begin(compute, result_timeout=0.05)
    pair.send(1)
    assert pair.client._goals
    assert wait_until(lambda: not pair.server._goals)
    pair.send(1)  # whose status tells that the one before is forgotten
    assert wait_until(lambda: len(pair.client._goals) <= 1)


def test_services_of_an_action_can_be_watched(pair: Pair) -> None:
    pair.begin(compute)
    seen: list[int] = []
    pair.client_node.create_subscription(
        Fibonacci.Impl.SendGoalService.Event,
        "/fibonacci/_action/send_goal/_service_event",
        lambda event: seen.append(event.info.event_type),
        10,
    )
    clock = pair.server_node.get_clock()
    for side in (pair.server, pair.client):
        side.configure_introspection(clock, 10, ServiceIntrospectionState.CONTENTS)
    assert pair.send(1).accepted
    assert wait_until(lambda: sorted(seen) == [0, 1, 2, 3])


# -- mistakes ----------------------------------------------------------------------------------


def test_types_are_checked_where_the_mistake_is_made(pair: Pair) -> None:
    pair.begin(compute)
    with pytest.raises(ActionMessageError, match="takes a example_interfaces/action/Fibonacci_G"):
        pair.client.send_goal_async(Fibonacci.Result())
    with pytest.raises(TypeError):
        pair.client.send_goal(5)
    for kind in (ActionServer, ActionClient):
        with pytest.raises(NotAnActionTypeError, match="String is no action type"):
            kind(pair.client_node, String, "x", *([compute] if kind is ActionServer else []))
    with pytest.raises(InvalidServiceNameError):
        ActionClient(pair.client_node, Fibonacci, "no name")


def test_feedback_of_another_type_aborts(pair: Pair, logged: list[Record]) -> None:
    pair.begin(lambda goal: goal.publish_feedback(Fibonacci.Result()))
    assert status_of(pair.client.send_goal(Fibonacci.Goal())) is GoalState.ABORTED
    assert any(
        "takes a example_interfaces/action/Fibonacci_Feedback" in one.message for one in logged
    )


def test_what_a_decision_raises_reaches_the_client_and_ends_spin(pair: Pair) -> None:
    def decide(_: Fibonacci.Goal) -> GoalResponse:
        raise ValueError("no such order")

    pair.begin(compute, goal_callback=decide)
    with pytest.raises(ServiceError, match="no such order"):
        pair.send()
    assert wait_until(lambda: isinstance(pair.serving.error, ValueError))


def test_without_a_server_a_goal_fails_at_once(make_context: MakeContext, spin: Spin) -> None:
    node = zbot.Node("lonely", context=make_context())
    client = ActionClient[Any, Any, Any](node, Fibonacci, "fibonacci")
    spin(node)
    assert not client.server_is_ready()
    assert not client.wait_for_server(0.05)
    with pytest.raises(ServiceError, match="no server is running"):
        done(client.send_goal_async(Fibonacci.Goal()))
    with pytest.raises(ServiceError, match="no server is running"):
        client.send_goal(Fibonacci.Goal())
    assert not client._goals


# -- names and the graph -----------------------------------------------------------------------


@pytest.mark.parametrize(
    ("name", "words", "full"),
    [
        ("fibonacci", (), "/robot1/fibonacci"),
        ("~/count", (), "/robot1/maths/count"),
        ("/count", (), "/count"),
        ("fibonacci", ("-r", "fibonacci:=numbers"), "/robot1/numbers"),
    ],
)
def test_names_are_resolved_as_those_of_topics(
    make_context: MakeContext, name: str, words: tuple[str, ...], full: str
) -> None:
    arguments = ["--ros-args", *words] if words else None
    node = zbot.Node("maths", context=make_context(), namespace="robot1", cli_args=arguments)
    server = ActionServer(node, Fibonacci, name, compute)
    assert server.action_name == full
    assert get_action_names_and_types(node) == [(full, ["example_interfaces/action/Fibonacci"])]
    services = dict(node.get_service_names_and_types())
    assert services[f"{full}/_action/get_result"] == [
        "example_interfaces/action/Fibonacci_GetResult"
    ]
    assert services[f"{full}/_action/cancel_goal"] == ["action_msgs/srv/CancelGoal"]
    topics = dict(node.get_topic_names_and_types())
    assert topics[f"{full}/_action/status"] == ["action_msgs/msg/GoalStatusArray"]
    assert topics[f"{full}/_action/feedback"] == [
        "example_interfaces/action/Fibonacci_FeedbackMessage"
    ]


def test_the_graph_knows_servers_and_clients(pair: Pair) -> None:
    pair.begin(compute)
    node = pair.client_node
    expected = [("/fibonacci", ["example_interfaces/action/Fibonacci"])]
    assert wait_until(
        lambda: get_action_server_names_and_types_by_node(node, "server", "/") == expected
    )
    assert get_action_names_and_types(node) == expected
    assert get_action_client_names_and_types_by_node(node, "server", "/") == []
    assert get_action_client_names_and_types_by_node(node, "client", "/") == expected
    with pytest.raises(UnknownNodeError):
        get_action_server_names_and_types_by_node(node, "nobody", "/")


def test_what_is_destroyed_leaves_the_graph(pair: Pair) -> None:
    pair.begin(compute)
    pair.server.destroy()
    pair.client.destroy()
    pair.server.destroy()
    pair.client.destroy()
    assert wait_until(lambda: get_action_names_and_types(pair.client_node) == [])
    assert list(pair.server_node.services) == [
        one for one in pair.server_node.services if "_action" not in one.srv_name
    ]


# -- servers that go ---------------------------------------------------------------------------


@pytest.mark.parametrize("how", ["server", "node", "context"])
def test_a_server_that_goes_while_it_executes_fails_the_result(pair: Pair, how: str) -> None:
    async def wait(_: Goal) -> None:
        await zbot.Future()

    pair.begin(wait)
    handle = pair.send(1)
    result = handle.get_result_async()
    assert wait_until(lambda: handle.status == GoalState.EXECUTING)
    if how == "server":
        pair.server.destroy()
    elif how == "node":
        pair.server_node.destroy_node()
    else:
        pair.server_node.context.shutdown()
    with pytest.raises(ServiceError, match="the server ended before it answered"):
        done(result)
    pair.serving.executor.shutdown(5)


SERVER = """
import sys
import zbot
from example_interfaces.action import Fibonacci
from zbot.action import ActionServer

async def execute(goal):
    if goal.request.order == 0:
        await zbot.Future()
    goal.succeed()
    return Fibonacci.Result(sequence=[goal.request.order])

with zbot.init():
    node = zbot.Node("server")
    server = ActionServer(node, Fibonacci, "fibonacci", execute)
    print("ready")
    zbot.spin(node)
"""


def test_a_server_that_is_killed_fails_its_goals_and_the_next_one_takes_over(
    make_context: MakeContext, spin: Spin, start: Callable[..., Program]
) -> None:
    node = zbot.Node("client", context=make_context())
    client = ActionClient[Any, Any, Any](node, Fibonacci, "fibonacci")
    spin(node)
    for turn in range(2):
        server = start(source=SERVER)
        server.wait_for("ready")
        assert client.wait_for_server(5)
        handles = [done(client.send_goal_async(Fibonacci.Goal(order=0))) for _ in range(5)]
        results = [handle.get_result_async() for handle in handles]
        assert list(client.send_goal(Fibonacci.Goal(order=4)).result.sequence) == [4], turn
        server.stop(signal.SIGKILL)
        for result in results:
            with pytest.raises(ServiceError, match="the server ended before it answered"):
                done(result)
        assert wait_until(lambda: not client._goals)
        assert wait_until(lambda: not client.server_is_ready())
