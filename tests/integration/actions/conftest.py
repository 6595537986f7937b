"""Fixtures with an action server and its client in two contexts."""

from __future__ import annotations

import threading
from typing import TYPE_CHECKING, Any

import pytest

import zbot
from tests.conftest import allowed
from zbot.action import (
    ActionClient,
    ActionServer,
    CancelResponse,
    ClientGoalHandle,
    GoalState,
    ServerGoalHandle,
)

from example_interfaces.action import Fibonacci
from unique_identifier_msgs.msg import UUID

if TYPE_CHECKING:
    from collections.abc import Callable

    from tests.conftest import MakeContext, Spin

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
    """Server and client, each in a context of its own, spinning in threads."""

    def __init__(self, make_context: MakeContext, spin: Spin) -> None:
        self.server_node = zbot.Node("server", context=make_context())
        self.client_node = zbot.Node("client", context=make_context())
        self._spin = spin
        self.server: ActionServer[Any, Any, Any]
        self.client: ActionClient[Any, Any, Any]

    def begin(
        self, execute: Callable[[Goal], Any] | None, threads: int = 1, **options: Any
    ) -> None:
        context = self.server_node.context
        self.server = ActionServer(self.server_node, Fibonacci, "fibonacci", execute, **options)
        self.client = ActionClient(self.client_node, Fibonacci, "fibonacci")
        executor: zbot.Executor = zbot.SingleThreadedExecutor(context=context)
        if threads > 1:
            executor = zbot.MultiThreadedExecutor(threads, context=context)
        self.serving = self._spin(self.server_node, executor=executor)
        self._spin(self.client_node)
        assert self.client.wait_for_server(zbot.Duration(seconds=5))

    def send(self, order: int = 5, **options: Any) -> Handle:
        future = self.client.send_goal_async(Fibonacci.Goal(order=order), **options)
        handle = done(future)
        assert isinstance(handle, ClientGoalHandle)
        return handle


def done(future: zbot.Future[Any], timeout_s: float = 5.0) -> Any:
    over = threading.Event()
    future.add_waker(over.set)
    assert over.wait(allowed(timeout_s)), "the future was never completed"
    return future.result()


@pytest.fixture
def pair(make_context: MakeContext, spin: Spin) -> Pair:
    return Pair(make_context, spin)


def status_of(response: Any) -> GoalState:
    return GoalState(response.status)


async def pause(goal: Goal) -> None:
    """Wait 10 ms while other callbacks run."""
    later: zbot.Future[None] = zbot.Future()
    server: Any = goal._action_server
    node: zbot.Node = server._node
    timer = node.create_timer(0.01, lambda: later.set_result(None))
    await later
    node.destroy_timer(timer)


def goal_id(number: int) -> UUID:
    return UUID(uuid=[1] * 15 + [number])
