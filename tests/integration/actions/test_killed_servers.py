"""Tests of action clients whose server is killed at each stage of a goal."""

from __future__ import annotations

import signal
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest

import zbot
from tests.cli.command import zbot as zbot_command
from tests.conftest import wait_until
from tests.integration.actions.conftest import done
from zbot.action import ActionClient, ClientGoalHandle, GoalState
from zbot.node.errors import ServiceError

from example_interfaces.action import Fibonacci

if TYPE_CHECKING:
    from collections.abc import Callable

    from tests.conftest import MakeContext, Program, Spin

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="POSIX signals")

SERVER = Path(__file__).parents[2] / "programs" / "remote" / "dying_server.py"
STAGES = ("deciding", "accepted", "executing", "feedback", "succeeded", "requested")
CANCEL_STAGES = ("canceling", "canceled")


def serve(start: Callable[..., Program], stage: str = "never") -> Program:
    program = start(sys.executable, "-u", str(SERVER), stage)
    program.wait_for("ready")
    return program


class Outcome:
    """What a future completed with."""

    def __init__(self, future: zbot.Future[Any]) -> None:
        self.value, self.error = None, None
        try:
            self.value = done(future, 10)
        except ServiceError as error:
            self.error = error


@pytest.mark.parametrize("stage", [*STAGES, *CANCEL_STAGES])
def test_a_client_gets_an_error_at_each_stage_and_goes_on(
    make_context: MakeContext, spin: Spin, start: Callable[..., Program], stage: str
) -> None:
    node = zbot.Node("client", context=make_context())
    client = ActionClient[Any, Any, Any](node, Fibonacci, "fibonacci")
    spinner = spin(node)
    server = serve(start, stage)
    assert client.wait_for_server(10)
    goal = Fibonacci.Goal(order=0 if stage in CANCEL_STAGES else 3)
    heard: list[Any] = []
    accepted = Outcome(client.send_goal_async(goal, heard.append))
    if stage == "deciding":
        assert accepted.error is not None
    if isinstance(accepted.value, ClientGoalHandle):  # the answer may have died with its server
        handle = accepted.value
        result = handle.get_result_async()
        if stage in CANCEL_STAGES:
            assert wait_until(lambda: bool(heard))
            assert stage == "canceled" or Outcome(handle.cancel_goal_async()).error is not None
            if stage == "canceled":
                Outcome(handle.cancel_goal_async())
        assert Outcome(result).error is not None
    assert server.wait() == -signal.SIGKILL
    assert wait_until(lambda: not client._goals)
    assert wait_until(lambda: not client.server_is_ready())
    serve(start)
    assert client.wait_for_server(10)
    assert list(client.send_goal(Fibonacci.Goal(order=4)).result.sequence) == [4]
    assert spinner.error is None


def test_a_result_of_a_server_that_is_gone_is_an_error(
    make_context: MakeContext, spin: Spin, start: Callable[..., Program]
) -> None:
    node = zbot.Node("client", context=make_context())
    client = ActionClient[Any, Any, Any](node, Fibonacci, "fibonacci")
    spin(node)
    server = serve(start)
    assert client.wait_for_server(10)
    handle = done(client.send_goal_async(Fibonacci.Goal(order=4)))
    assert wait_until(lambda: handle.status == GoalState.SUCCEEDED)
    server.stop(signal.SIGKILL)
    assert wait_until(lambda: not client.server_is_ready())
    error = Outcome(handle.get_result_async()).error
    assert error is not None
    assert "no server is running" in str(error)


def test_a_goal_whose_result_nobody_gets_is_forgotten_when_another_server_comes(
    make_context: MakeContext, spin: Spin, start: Callable[..., Program]
) -> None:
    node = zbot.Node("client", context=make_context())
    client = ActionClient[Any, Any, Any](node, Fibonacci, "fibonacci")
    spin(node)
    for _turn in range(2):
        server = serve(start)
        assert client.wait_for_server(10)
        heard: list[Any] = []
        handle = done(client.send_goal_async(Fibonacci.Goal(order=0), heard.append))
        assert wait_until(lambda: bool(heard))  # noqa: B023 - used in this turn only
        assert wait_until(lambda: set(client._goals) == {handle.key})  # noqa: B023 - as above
        assert wait_until(lambda: handle.status == GoalState.EXECUTING)  # noqa: B023 - as above
        server.stop(signal.SIGKILL)
        assert wait_until(lambda: not client.server_is_ready())
    assert len(client._goals) == 1


def test_a_goal_without_a_server_is_forgotten_when_its_result_is_asked_for(
    make_context: MakeContext, spin: Spin, start: Callable[..., Program]
) -> None:
    node = zbot.Node("client", context=make_context())
    client = ActionClient[Any, Any, Any](node, Fibonacci, "fibonacci")
    spin(node)
    server = serve(start)
    assert client.wait_for_server(10)
    handle = done(client.send_goal_async(Fibonacci.Goal(order=0)))
    server.stop(signal.SIGKILL)
    assert wait_until(lambda: not client.server_is_ready())
    with pytest.raises(ServiceError):
        handle.get_result()
    assert wait_until(lambda: not client._goals)


@pytest.mark.parametrize("stage", STAGES)
def test_the_command_says_that_the_server_ended(start: Callable[..., Program], stage: str) -> None:
    serve(start, stage)
    name, kind = "/fibonacci", "example_interfaces/action/Fibonacci"
    ended = zbot_command("action", "send_goal", name, kind, "{order: 3}", "--feedback")
    assert ended.code == 1
    assert "Traceback" not in ended.err
    # The command may learn that the server ended before it asks for the result, or after that.
    reasons = ("the server ended before it answered", "no server is running")
    assert any(reason in ended.err for reason in reasons)
