"""Tests of servers without an execute callback, whose programs handle accepted goals."""

from __future__ import annotations

import threading
from typing import TYPE_CHECKING, Any

import pytest

import zbot
from tests.conftest import wait_until
from tests.integration.actions.conftest import Goal, Pair, compute, done, status_of
from zbot.action import ActionClient, ActionServer, GoalState
from zbot.errors import WrongTypeError

from example_interfaces.action import Fibonacci

if TYPE_CHECKING:
    from tests.conftest import MakeContext

RESULT = Fibonacci.Result(sequence=[7])


class UnspunServer:
    """Server without an execute callback, and its client, spun by the test's own thread."""

    def __init__(self, context: zbot.Context, accept: Any) -> None:
        self.node = zbot.Node("unspun", context=context)
        self.executor = zbot.SingleThreadedExecutor(context=context)
        self.executor.add_node(self.node)
        ActionServer[Any, Any, Any](
            self.node, Fibonacci, "fibonacci", handle_accepted_callback=accept
        )
        impl = Fibonacci.Impl
        self.sending = self.node.create_client(impl.SendGoalService, "fibonacci/_action/send_goal")

    def send(self) -> zbot.Future[Any]:
        return self.sending.call_async(Fibonacci.Impl.SendGoalService.Request())


def test_the_accepted_callback_runs_before_spinning_for_the_response_ends(
    make_context: MakeContext,
) -> None:
    accepted: list[Goal] = []
    unspun = UnspunServer(make_context(), accepted.append)
    future = unspun.send()
    unspun.executor.spin_until_future_complete(future, 5)
    assert done(future).accepted
    assert [goal.state for goal in accepted] == [GoalState.ACCEPTED]


def test_the_accepted_callback_runs_first_with_several_threads(make_context: MakeContext) -> None:
    accepted: list[Goal] = []

    def accept(goal: Goal) -> None:
        threading.Event().wait(0.1)  # longer than the response needs to the spinning thread
        accepted.append(goal)

    unspun = UnspunServer(make_context(), accept)
    executor = zbot.MultiThreadedExecutor(2, context=unspun.node.context)
    executor.add_node(unspun.node)
    future = unspun.send()
    executor.spin_until_future_complete(future, 5)
    assert done(future).accepted
    assert len(accepted) == 1


def test_an_exception_of_the_accepted_callback_ends_spin(make_context: MakeContext) -> None:
    def accept(_: Goal) -> None:
        raise ValueError("no place for it")

    unspun = UnspunServer(make_context(), accept)
    future = unspun.send()
    with pytest.raises(ValueError, match="no place for it"):
        unspun.executor.spin_until_future_complete(future, 5)
    assert done(future).accepted


@pytest.mark.parametrize("begin", ["executing", "execute"])
def test_a_goal_can_be_executed_without_an_execute_callback(pair: Pair, begin: str) -> None:
    accepted: list[Goal] = []

    async def accept(goal: Goal) -> None:
        getattr(goal, begin)()
        accepted.append(goal)

    pair.begin(None, handle_accepted_callback=accept)
    handle = pair.send()
    assert wait_until(lambda: bool(accepted))
    result = handle.get_result_async()
    assert accepted[0].state is GoalState.EXECUTING
    accepted[0].succeed(RESULT)
    response = done(result)
    assert status_of(response) is GoalState.SUCCEEDED
    assert response.result == RESULT


def test_a_server_without_any_callback_is_refused(make_context: MakeContext) -> None:
    node = zbot.Node("idle", context=make_context())
    with pytest.raises(WrongTypeError, match="execute_callback was given None"):
        ActionServer[Any, Any, Any](node, Fibonacci, "fibonacci")


def test_servers_and_clients_count_their_entities(make_context: MakeContext) -> None:
    node = zbot.Node("counted", context=make_context())
    server = ActionServer[Any, Any, Any](node, Fibonacci, "fibonacci", compute)
    client = ActionClient[Any, Any, Any](node, Fibonacci, "fibonacci")
    both = server.get_num_entities() + client.get_num_entities()
    assert (both.num_subscriptions, both.num_timers) == (2, 1)
    assert (both.num_clients, both.num_services) == (3, 3)
