"""Tests of `zbot action` with a running server."""

from __future__ import annotations

import json
import re
import signal
from typing import TYPE_CHECKING, Any

import pytest

import zbot as library
from tests.cli.command import zbot
from tests.conftest import wait_until
from zbot.action import ActionClient, ActionServer, CancelResponse, GoalResponse, ServerGoalHandle
from zbot.node.service_introspection import ServiceIntrospectionState
from zbot_cli.commands.action.send_goal import SendGoal

from example_interfaces.action import Fibonacci

if TYPE_CHECKING:
    from collections.abc import Callable

    from tests.conftest import MakeContext, Spin, Start

TYPE = "example_interfaces/action/Fibonacci"
RESULT = "Result:\n    sequence:\n- 0\n- 1\n- 1\n\n"


async def execute(goal: ServerGoalHandle[Any, Any, Any]) -> Fibonacci.Result:
    order, numbers = goal.request.order, [0, 1, 1]
    goal.publish_feedback(Fibonacci.Feedback(sequence=numbers))
    if order == 7:
        await stopped
        goal.canceled()
    elif order == 8:
        goal.abort()
    else:
        goal.succeed()
    return Fibonacci.Result(sequence=numbers)


stopped: library.Future[None] = library.Future()


def stop(_: object) -> CancelResponse:
    stopped.set_result(None)
    return CancelResponse.ACCEPT


@pytest.fixture
def server(make_context: MakeContext, spin: Spin) -> library.Node:
    global stopped  # noqa: PLW0603 - one goal a test waits for it
    stopped = library.Future()
    node = library.Node("fib_server", context=make_context())
    node.server = ActionServer(  # type: ignore[attr-defined]
        node,
        Fibonacci,
        "fibonacci",
        execute,
        goal_callback=lambda goal: GoalResponse.ACCEPT if goal.order < 9 else GoalResponse.REJECT,
        cancel_callback=stop,
    )
    spin(node)
    return node


@pytest.mark.usefixtures("server")
def test_lists_print_the_output_of_ros2() -> None:
    assert zbot("action", "list").out == "/fibonacci\n"
    assert zbot("action", "list", "-t").out == f"/fibonacci [{TYPE}]\n"
    assert zbot("action", "list", "-c").out == "1\n"
    assert json.loads(zbot("action", "list", "--json").out) == [
        {"name": "/fibonacci", "types": [TYPE], "server_count": 1, "client_count": 0}
    ]
    assert zbot("action", "info", "/fibonacci").out == (
        "Action: /fibonacci\nAction clients: 0\nAction servers: 1\n    /fib_server\n"
    )
    assert f"    /fib_server [{TYPE}]\n" in zbot("action", "info", "fibonacci", "-t").out
    assert "fib_server" not in zbot("action", "info", "/fibonacci", "-c").out
    assert zbot("action", "type", "/fibonacci").out == f"{TYPE}\n"
    assert zbot("action", "find", TYPE).out == "/fibonacci\n"
    assert zbot("action", "find", TYPE, "-c").out == "1\n"
    assert zbot("action", "find", "std_msgs/action/None").out == ""


@pytest.mark.usefixtures("server")
def test_an_unknown_name_is_refused_with_a_hint() -> None:
    unknown = zbot("action", "type", "/fibonaci")
    assert (unknown.code, unknown.out) == (1, "")
    assert unknown.err == "Unknown action '/fibonaci'\n\nhint: did you mean '/fibonacci'?\n"
    nobody = zbot("action", "info", "/fibonaci")
    assert (nobody.code, nobody.out) == (
        0,
        "Action: /fibonaci\nAction clients: 0\nAction servers: 0\n",
    )
    late = zbot("action", "send_goal", "/fibonaci", TYPE, "--timeout", "0.2")
    assert late.code == 1
    assert "The action server /fibonaci is not available after waiting 0.2 seconds" in late.err


@pytest.mark.usefixtures("server")
def test_a_goal_for_a_wrong_name_names_a_similar_action(start: Start) -> None:
    command = start("zbot", "action", "send_goal", "/fibonaci", TYPE)
    command.wait_for("hint: did you mean '/fibonacci'?")


@pytest.mark.parametrize("words", [(), (TYPE,)])
@pytest.mark.usefixtures("server")
def test_a_wait_for_a_server_that_does_not_come_is_explained(
    start: Start, words: tuple[str, ...]
) -> None:
    command = start("zbot", "action", "send_goal", "/nope", *words)
    command.wait_for("nobody serves /nope; `zbot action list` shows the actions")


@pytest.mark.parametrize("words", [(TYPE, "{order: 2}"), ("order: 2",), ("order=2",)])
@pytest.mark.usefixtures("server")
def test_send_goal_prints_the_output_of_ros2(words: tuple[str, ...]) -> None:
    sent = zbot("action", "send_goal", "/fibonacci", *words)
    assert (sent.code, sent.err) == (0, "")
    assert re.sub(r"[0-9a-f]{32}", "ID", sent.out) == (
        "Waiting for an action server to become available...\n"
        "Sending goal:\n     order: 2\n\n"
        "Goal accepted with ID: ID\n\n"
        f"{RESULT}Goal finished with status: SUCCEEDED\n"
    )


@pytest.mark.usefixtures("server")
def test_feedback_is_printed_before_the_result() -> None:
    sent = zbot("action", "send_goal", "-f", "/fibonacci", TYPE, "{order: 2}")
    assert RESULT.replace("Result", "Feedback") + RESULT in sent.out


@pytest.mark.usefixtures("server")
def test_feedback_that_overtakes_the_acceptance_is_printed_after_it(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    send = ActionClient.send_goal_async

    def overtake(self: Any, goal: Any, tell: Callable[[Any], None]) -> Any:
        tell(Fibonacci.Impl.FeedbackMessage(feedback=Fibonacci.Feedback(sequence=[0])))
        return send(self, goal, tell)

    monkeypatch.setattr(ActionClient, "send_goal_async", overtake)
    command = SendGoal(
        "/fibonacci",
        [TYPE, "{order: 2}"],
        with_feedback=True,
        timeout_s=5,
        stdin=False,
        goal_file=None,
        as_json=False,
    )
    command.run()
    printed = [line.split()[0] for line in capsys.readouterr().out.splitlines() if line]
    assert [word for word in printed if word in {"Goal", "Feedback:", "Result:"}] == [
        "Goal",  # accepted
        "Feedback:",
        "Feedback:",
        "Result:",
        "Goal",  # finished
    ]


@pytest.mark.usefixtures("server")
def test_send_goal_as_json() -> None:
    sent = zbot("action", "send_goal", "--json", "-f", "/fibonacci", "order: 2")
    lines = [json.loads(line) for line in sent.out.splitlines()]
    assert lines[0]["accepted"]
    assert lines[1:] == [
        {"feedback": {"sequence": [0, 1, 1]}},
        {"result": {"sequence": [0, 1, 1]}, "status": "SUCCEEDED"},
    ]


@pytest.mark.parametrize(
    ("values", "out", "err"),
    [
        ("order: 9", "Goal was rejected.\n", ""),
        ("order: 8", "Goal finished with status: ABORTED\n", ""),
        (
            "{ordr: 8}",
            "",
            (
                "Failed to populate message fields: "
                "'Fibonacci_Goal' object has no attribute 'ordr'\n"
            ),
        ),
    ],
)
@pytest.mark.usefixtures("server")
def test_a_goal_that_does_not_succeed_ends_with_1(values: str, out: str, err: str) -> None:
    sent = zbot("action", "send_goal", "/fibonacci", TYPE, values)
    assert sent.code == 1
    assert sent.out.endswith(out)
    assert sent.err.startswith(err)


def test_a_message_type_is_refused_as_an_action_type() -> None:
    refused = zbot("action", "send_goal", "/fibonacci", "std_msgs/msg/String", "{}")
    assert (refused.code, refused.out) == (1, "")
    assert refused.err.startswith("The passed action type is invalid\n")


@pytest.mark.usefixtures("server")
def test_ctrl_c_cancels_the_goal(start: Start) -> None:
    program = start("zbot", "action", "send_goal", "-f", "/fibonacci", "order: 7")
    program.wait_for("Feedback:")
    assert program.stop(signal.SIGINT) == 130
    end = "Canceling goal...\nGoal canceled.\n" + RESULT + "Goal finished with status: CANCELED"
    assert program.output.endswith(end)


@pytest.mark.usefixtures("server")
def test_ctrl_c_right_after_the_acceptance_cancels_the_goal(start: Start) -> None:
    program = start("zbot", "action", "send_goal", "/fibonacci", "order: 7")
    program.wait_for("Goal accepted")
    assert program.stop(signal.SIGINT) == 130
    assert program.output.endswith("Goal finished with status: CANCELED")


def test_echo_shows_feedback_and_status(server: library.Node, start: Start) -> None:
    words = ("-i", "FEEDBACK_TOPIC|STATUS_TOPIC")
    program = start("zbot", "action", "echo", "/fibonacci", *words)
    for topic in ("feedback", "status"):
        name = f"/fibonacci/_action/{topic}"
        assert wait_until(lambda name=name: server.count_subscribers(name) == 1)  # type: ignore[misc]
    zbot("action", "send_goal", "/fibonacci", "order: 2")
    for text in ("interface: FEEDBACK_TOPIC", "goal_id:", "interface: STATUS_TOPIC"):
        program.see(text)
    program.stop(signal.SIGINT)


@pytest.mark.parametrize(
    ("option", "step"),
    [((), "  event_type: REQUEST_RECEIVED"), (("--json",), '"event_type": "REQUEST_RECEIVED"')],
)
def test_echo_prints_the_step_of_each_service_event(
    server: library.Node, start: Start, option: tuple[str, ...], step: str
) -> None:
    server.server.configure_introspection(  # type: ignore[attr-defined]
        server.get_clock(), 10, ServiceIntrospectionState.METADATA
    )
    program = start("zbot", "action", "echo", "/fibonacci", "-i", "GOAL_SERVICE", *option)
    topic = "/fibonacci/_action/send_goal/_service_event"
    assert wait_until(lambda: server.count_subscribers(topic) == 1)
    zbot("action", "send_goal", "/fibonacci", "order: 2")
    program.wait_for(step)


def test_echo_refuses_an_unknown_interface_of_an_action() -> None:
    refused = zbot("action", "echo", "/fibonacci", TYPE, "-i", "GOAL")
    assert refused.code == 1
    assert refused.err.startswith('"GOAL" is incorrect interface name.\n')
