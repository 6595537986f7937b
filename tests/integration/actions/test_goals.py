"""Tests of goals, feedback and results, of one goal and of many goals together."""

from __future__ import annotations

import threading
from collections import deque
from functools import partial
from types import SimpleNamespace
from typing import TYPE_CHECKING, Any

import pytest

import zbot
from tests.conftest import allowed, wait_until
from tests.integration.actions.conftest import Goal, Pair, compute, done, pause, sequence, status_of
from zbot.action import ActionClient, ActionServer, CancelResponse, GoalResponse, GoalState

from action_msgs.msg import GoalStatus, GoalStatusArray
from example_interfaces.action import Fibonacci
from unique_identifier_msgs.msg import UUID

if TYPE_CHECKING:
    from tests.conftest import MakeContext
    from zbot.log.record import Record

# -- goals and results -------------------------------------------------------------------------


def test_a_goal_gives_feedback_and_a_result(pair: Pair) -> None:
    pair.begin(compute)
    heard: list[list[int]] = []
    handle = pair.send(
        5, feedback_callback=lambda message: heard.append(list(message.feedback.sequence))
    )
    assert handle.accepted
    response = done(handle.get_result_async())
    assert status_of(response) is GoalState.SUCCEEDED
    assert list(response.result.sequence) == sequence(5)
    assert heard == [sequence(end) for end in range(2, 6)]
    assert handle.status == GoalState.SUCCEEDED


def test_a_node_does_not_list_the_topics_and_services_of_its_actions(pair: Pair) -> None:
    pair.begin(compute)
    node = pair.client._node
    listed = [*node.subscriptions, *node.publishers, *node.clients, *node.services]
    names = [getattr(one, "topic_name", None) or one.service_name for one in listed]
    assert names
    assert not [name for name in names if "/_action/" in name]


def test_send_goal_waits_for_the_end(pair: Pair) -> None:
    pair.begin(compute)
    response = pair.client.send_goal(Fibonacci.Goal(order=3))
    assert list(response.result.sequence) == sequence(3)
    assert status_of(response) is GoalState.SUCCEEDED


def test_a_state_that_comes_after_the_result_is_ignored(pair: Pair) -> None:
    pair.begin(compute)
    handle = pair.send()
    goal = pair.client._goals[handle.key]
    done(handle.get_result_async())
    late = GoalStatus(status=GoalState.EXECUTING.value)
    late.goal_info.goal_id = handle.goal_id
    pair.client._goals[handle.key] = goal  # as if a callback for its feedback still had to run
    pair.client._on_status(GoalStatusArray(status_list=[late]))
    assert handle.status == GoalState.SUCCEEDED


def test_the_states_are_published_while_another_thread_accepts_a_goal(pair: Pair) -> None:
    pair.begin(compute)
    goals: dict[bytes, Any] = pair.server._goal_handles

    class Accepting:
        """A goal during whose look another goal comes."""

        @property
        def status_message(self) -> GoalStatus:
            goals[b"late"] = SimpleNamespace(status_message=GoalStatus())
            return GoalStatus()

    goals[b"early"] = Accepting()
    pair.server.publish_status()
    assert goals.keys() == {b"early", b"late"}
    goals.clear()


def test_new_feedback_is_kept_if_the_executor_takes_the_old_one_meanwhile(
    make_context: MakeContext,
) -> None:
    class Taken(deque[Any]):
        """Queue whose samples are taken just after its length was read."""

        def __len__(self) -> int:
            length = super().__len__()
            self.clear()
            return length

    node = zbot.Node("client", context=make_context())
    client: Any = ActionClient(
        node, Fibonacci, "fibonacci", feedback_sub_qos_profile=zbot.QoSProfile(depth=1)
    )
    feedback: Any = client._feedback
    feedback._queue = Taken(["old"])
    feedback._receive("new")
    assert feedback.take() == "new"


def test_a_result_can_be_requested_several_times_and_after_the_end(pair: Pair) -> None:
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


def test_a_goal_has_its_given_id_and_a_second_one_is_rejected(pair: Pair) -> None:
    pair.begin(compute)
    mine = UUID(uuid=list(range(16)))
    assert pair.send(goal_uuid=mine).goal_id == mine
    assert not pair.send(goal_uuid=mine).accepted


def test_the_stamp_is_the_acceptance_time_of_the_servers_clock(pair: Pair) -> None:
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


def test_a_server_can_send_a_goal_to_another_action(pair: Pair) -> None:
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


def test_a_goal_callback_without_a_result_rejects_and_logs(
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


def test_the_client_receives_the_acceptance_before_the_callback_runs(pair: Pair) -> None:
    """The response is sent before `handle_accepted_callback` runs, which may be slow."""
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
    with pytest.raises(TypeError, match="which is not a function"):
        pair.server.register_execute_callback(None)  # type: ignore[arg-type]


# -- several goals -----------------------------------------------------------------------------


def test_a_new_goal_can_preempt_the_previous_one(pair: Pair) -> None:
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
            await pause(goal)
        if goal.is_active:
            goal.succeed()
        return Fibonacci.Result(sequence=[goal.request.order])

    pair.begin(execute, handle_accepted_callback=accepted)
    first, second, last = pair.send(1), pair.send(2), pair.send(0)
    states = [status_of(done(handle.get_result_async())).name for handle in (first, second, last)]
    assert states == ["ABORTED", "ABORTED", "SUCCEEDED"]


def test_blocking_callbacks_run_in_parallel_threads(pair: Pair) -> None:
    barrier = threading.Barrier(3)

    def meet(goal: Goal) -> Fibonacci.Result:
        barrier.wait(5)
        goal.succeed()
        return Fibonacci.Result(sequence=[goal.request.order])

    group = zbot.ReentrantCallbackGroup()
    pair.begin(meet, threads=4, callback_group=group)
    results = [pair.send(order).get_result_async() for order in range(3)]
    assert [list(done(result).result.sequence) for result in results] == [[0], [1], [2]]


def test_feedback_arrives_at_a_client_with_depth_0(pair: Pair) -> None:
    pair.begin(compute)
    with pytest.warns(UserWarning, match="depth"):
        profile = zbot.QoSProfile(depth=0)
    pair.client = ActionClient(
        pair.client_node, Fibonacci, "fibonacci", feedback_sub_qos_profile=profile
    )
    heard: list[int] = []
    handle = pair.send(9, feedback_callback=lambda got: heard.append(len(got.feedback.sequence)))
    done(handle.get_result_async())
    assert heard[-1] == 10


def test_feedback_reaches_its_own_goal(pair: Pair) -> None:
    pair.begin(compute)
    heard: dict[int, list[int]] = {order: [] for order in (3, 5, 7)}
    handles = [
        pair.send(
            order,
            feedback_callback=lambda message, order=order: heard[order].append(
                len(message.feedback.sequence)
            ),
        )
        for order in heard
    ]
    for handle in handles:
        done(handle.get_result_async())
    assert heard == {order: list(range(3, order + 2)) for order in heard}


def test_two_clients_receive_only_their_own_goals_events(pair: Pair) -> None:
    pair.begin(compute)
    other = ActionClient[Any, Any, Any](pair.client_node, Fibonacci, "fibonacci")
    heard: list[str] = []
    one = pair.send(2, feedback_callback=lambda _: heard.append("one"))
    two = done(other.send_goal_async(Fibonacci.Goal(order=2), lambda _: heard.append("two")))
    done(one.get_result_async())
    done(two.get_result_async())
    assert sorted(heard) == ["one", "two"]


def _note(heard: set[int], message: Any) -> None:
    heard.add(message.feedback.sequence[0])


def test_fifty_goals_with_cancels_each_get_their_own_result(pair: Pair) -> None:
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

    # A result must not expire before a busy machine has asked for it.
    timeout_s = allowed(2)
    pair.begin(
        execute,
        handle_accepted_callback=accepted,
        cancel_callback=stop,
        result_timeout=timeout_s,
    )
    heard: set[int] = set()
    futures = [
        pair.client.send_goal_async(Fibonacci.Goal(order=order), partial(_note, heard))
        for order in range(50)
    ]
    handles = [done(future, 10) for future in futures]
    results = [handle.get_result_async() for handle in handles]
    canceled = [handle.cancel_goal_async() for handle in handles[1::2]]
    assert all(len(done(future, 10).goals_canceling) == 1 for future in canceled)
    for order, result in enumerate(results):
        response = done(result, 10)
        assert list(response.result.sequence) == [order]
        expected = GoalState.CANCELED if order % 2 else GoalState.SUCCEEDED
        assert status_of(response) is expected
    assert heard == set(range(50))
    # The client keeps nothing of them, and the server nothing after their results expired.
    assert wait_until(lambda: not pair.client._goals)
    assert wait_until(lambda: not pair.server._goal_handles, timeout_s + 5)
    assert not pair.server._ended
    assert not pair.server._services[1]._waiting
