"""Tests of the ends of goals: succeeded, aborted, canceled, or failed with their server."""

from __future__ import annotations

import signal
import threading
import time
from typing import TYPE_CHECKING, Any

import pytest

import zbot
from tests.conftest import allowed, wait_until
from tests.integration.actions.conftest import (
    Goal,
    Handle,
    Pair,
    accept_cancel,
    compute,
    done,
    goal_id,
    pause,
    status_of,
)
from zbot.action import ActionClient, ActionServer, CancelResponse, GoalState, GoalTransitionError
from zbot.node.errors import ServiceError
from zbot.time import ClockType, Time

from action_msgs.srv import CancelGoal
from example_interfaces.action import Fibonacci
from std_msgs.msg import String

if TYPE_CHECKING:
    from collections.abc import Callable

    from tests.conftest import MakeContext, Program, Spin
    from zbot.log.record import Record

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


def test_a_goal_without_a_final_state_is_aborted(pair: Pair, logged: list[Record]) -> None:
    pair.begin(lambda _: Fibonacci.Result(sequence=[3]))
    response = pair.client.send_goal(Fibonacci.Goal())
    assert status_of(response) is GoalState.ABORTED
    assert list(response.result.sequence) == [3]
    assert any("Goal state not set, assuming aborted" in record.message for record in logged)


def test_a_missing_result_is_logged_and_sent_empty(pair: Pair, logged: list[Record]) -> None:
    pair.begin(lambda goal: goal.succeed())
    response = pair.client.send_goal(Fibonacci.Goal())
    assert status_of(response) is GoalState.SUCCEEDED
    assert any("end the callback with `return result`" in record.message for record in logged)


def test_a_result_of_another_type_aborts(pair: Pair, logged: list[Record]) -> None:
    pair.begin(lambda _: String(data="five"))
    assert status_of(pair.client.send_goal(Fibonacci.Goal())) is GoalState.ABORTED
    expected = "/fibonacci takes a example_interfaces/action/Fibonacci_Result, not std_msgs.msg."
    text = next(record.message for record in logged if expected in record.message)
    assert "; write Fibonacci.Result(sequence=...)" in text


def test_a_final_state_with_a_result_is_sent_at_once(pair: Pair) -> None:
    release = threading.Event()

    def linger(goal: Goal) -> None:
        goal.succeed(Fibonacci.Result(sequence=[5]))
        release.wait(10)

    pair.begin(linger, threads=2)  # the second one serves result requests
    try:
        assert list(done(pair.send().get_result_async()).result.sequence) == [5]
    finally:
        release.set()


def test_an_impossible_transition_raises(pair: Pair) -> None:
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


def test_results_expire_and_free_their_memory(pair: Pair) -> None:
    kept: list[Goal] = []

    def execute(goal: Goal) -> Fibonacci.Result:
        kept.append(goal)
        return compute(goal)

    pair.begin(execute, result_timeout=allowed(0.5))
    handle = pair.send(1)
    assert status_of(handle.get_result()) is GoalState.SUCCEEDED
    assert wait_until(lambda: kept[0].status == GoalState.UNKNOWN)
    assert not kept[0].is_active
    assert status_of(handle.get_result()) is GoalState.UNKNOWN
    kept[0].publish_feedback(Fibonacci.Feedback())  # without a client: no effect
    kept[0].succeed()


@pytest.mark.parametrize(("timeout", "state"), [(-1, "SUCCEEDED"), (0, "UNKNOWN")])
def test_a_result_can_be_kept_for_ever_or_not_at_all(pair: Pair, timeout: int, state: str) -> None:
    pair.begin(compute, result_timeout=timeout)
    handle = pair.send(1)
    kept = GoalState[state]
    assert wait_until(lambda: status_of(handle.get_result()) is kept)


# -- canceling ---------------------------------------------------------------------------------


async def until_canceled(goal: Goal) -> Fibonacci.Result:
    while not goal.is_cancel_requested:
        goal.publish_feedback(Fibonacci.Feedback(sequence=[goal.request.order]))
        await pause(goal)
    goal.canceled()
    return Fibonacci.Result(sequence=[goal.request.order])


def cancel(pair: Pair, **info: Any) -> tuple[int, list[int]]:
    """Ask the cancel service, and return its code with the goals' last bytes."""
    client = pair.client_node.create_client(CancelGoal, "/fibonacci/_action/cancel_goal")
    request = CancelGoal.Request()
    for name, value in info.items():
        setattr(request.goal_info, name, value)
    response = client.call(request, 5)
    return response.return_code, [int(goal.goal_id.uuid[15]) for goal in response.goals_canceling]


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


def test_a_client_has_the_private_names_of_rclpy(pair: Pair) -> None:
    pair.begin(until_canceled, cancel_callback=accept_cancel)
    handle = pair.send(8)
    client: Any = pair.client
    assert done(client._cancel_goal_async(handle)).return_code == CancelGoal.Response.ERROR_NONE
    assert status_of(done(client._get_result_async(handle))) is GoalState.CANCELED
    assert status_of(client._get_result(handle)) is GoalState.CANCELED
    terminated = CancelGoal.Response.ERROR_GOAL_TERMINATED
    assert client._cancel_goal(handle).return_code == terminated


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


def test_a_goal_may_end_during_the_decision_to_cancel_it(pair: Pair) -> None:
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


def test_a_goal_can_be_canceled_before_its_execution(pair: Pair) -> None:
    waiting: list[Goal] = []
    pair.begin(compute, handle_accepted_callback=waiting.append, cancel_callback=accept_cancel)
    handle = pair.send()
    result = handle.get_result_async()
    assert wait_until(lambda: bool(waiting))
    assert len(handle.cancel_goal().goals_canceling) == 1
    waiting[0].canceled()
    assert status_of(done(result)) is GoalState.CANCELED


def accepted(pair: Pair) -> tuple[Handle, Goal]:
    """Return both sides of a goal that was accepted, and that is not executed yet."""
    waiting: list[Goal] = []
    pair.begin(
        until_canceled, handle_accepted_callback=waiting.append, cancel_callback=accept_cancel
    )
    handle = pair.send(4)
    assert wait_until(lambda: bool(waiting))
    return handle, waiting[0]


def test_a_canceling_goal_is_executed_and_ends_itself(pair: Pair) -> None:
    handle, goal = accepted(pair)
    handle.cancel_goal()
    goal.execute()
    assert list(done(handle.get_result_async()).result.sequence) == [4]


def test_a_goal_may_be_canceled_while_its_execution_begins(pair: Pair) -> None:
    handle, goal = accepted(pair)
    lock, here, cancels = pair.server.lock, threading.get_ident(), [handle.cancel_goal]

    class LateLock:
        def __enter__(self) -> None:
            if threading.get_ident() == here and cancels:
                cancels.pop()()
            lock.acquire()

        def __exit__(self, *_: object) -> None:
            lock.release()

    pair.server.lock = LateLock()  # type: ignore[assignment]
    goal.execute()
    assert status_of(done(handle.get_result_async())) is GoalState.CANCELED


def test_cancel_requests_name_one_goal_a_time_or_all_goals(pair: Pair) -> None:
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


# -- servers that end ---------------------------------------------------------------------------


@pytest.mark.parametrize("how", ["server", "node", "context"])
def test_a_result_fails_when_its_server_is_destroyed(pair: Pair, how: str) -> None:
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


def test_a_server_ends_at_once_beside_a_client_in_its_process(make_context: MakeContext) -> None:
    # Half of these took ten seconds while zbot ran a function in Zenoh's thread for timers.
    nodes = [zbot.Node(name, context=make_context()) for name in ("server", "client")]
    for turn in range(8):
        name = f"fibonacci_{turn}"
        server = ActionServer[Any, Any, Any](nodes[0], Fibonacci, name, compute)
        client = ActionClient[Any, Any, Any](nodes[1], Fibonacci, name)
        assert client.wait_for_server(allowed(5))
        begin = time.monotonic()
        server.destroy()
        assert time.monotonic() - begin < allowed(2)
        client.destroy()


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


def test_a_killed_server_fails_its_goals_and_another_takes_over(
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


def test_a_result_is_kept_for_seconds_of_the_nodes_clock(pair: Pair) -> None:
    pair.server_node.set_parameters([zbot.Parameter("use_sim_time", value=True)])
    clock = pair.server_node.get_clock()
    assert isinstance(clock, zbot.ROSClock)
    goals: list[Goal] = []

    def execute(goal: Goal) -> Fibonacci.Result:
        goals.append(goal)
        return compute(goal)

    pair.begin(execute, result_timeout=10)
    done(pair.send(3).get_result_async())
    assert wait_until(lambda: not pair.server._expiry.is_canceled())
    clock.set_ros_time_override(Time(seconds=9.9, clock_type=ClockType.ROS_TIME))
    assert goals[0].state is GoalState.SUCCEEDED
    clock.set_ros_time_override(Time(seconds=10, clock_type=ClockType.ROS_TIME))
    assert wait_until(lambda: goals[0].state is GoalState.UNKNOWN)
