"""Actions that a web program uses and serves."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import zbot
from tests.conftest import wait_until
from zbot.action import ActionClient, ActionServer, CancelResponse
from zbot.web.rosbridge import action_operations

from example_interfaces.action import Fibonacci

if TYPE_CHECKING:
    from collections.abc import Callable

    import pytest

    from tests.conftest import Spinner
    from tests.integration.rosbridge.web_program import WebProgram


def test_send_a_goal(web: WebProgram, node: zbot.Node, spin: Callable[..., Spinner]) -> None:
    async def count(goal: Any) -> Any:
        goal.publish_feedback(Fibonacci.Feedback(sequence=[0, 1]))
        if goal.request.order > 100:
            ended: zbot.Future[None] = zbot.Future()  # it waits until it is cancelled
            waiting.append((goal, ended))
            await ended
            goal.canceled()
        else:
            goal.succeed()
        return Fibonacci.Result(sequence=[0, 1, 1])

    waiting: list[Any] = []

    def cancel(_goal: Any) -> CancelResponse:
        node.executor.create_task(lambda: waiting[0][1].set_result(None))  # type: ignore[union-attr]
        return CancelResponse.ACCEPT

    ActionServer(node, Fibonacci, "count", count, cancel_callback=cancel)
    spin(node)
    goal = {"action": "/count", "action_type": "example_interfaces/Fibonacci", "feedback": True}
    web.send("send_action_goal", id="g", args={"order": 5}, **goal)
    feedback = web.wait_for("action_feedback", id="g", action="/count")
    assert feedback["values"] == {"sequence": [0, 1]}
    result = web.wait_for("action_result", id="g")
    assert (result["status"], result["result"]) == (4, True)
    assert result["values"] == {"sequence": [0, 1, 1]}
    web.send("send_action_goal", id="long", args={"order": 500}, **goal)
    assert wait_until(lambda: bool(waiting), 10)
    web.send("cancel_action_goal", id="long", action="/count")
    assert web.wait_for("action_result", id="long")["status"] == 5
    web.send("send_action_goal", id="bad", args={"order": "x"}, **goal)
    result = web.wait_for("action_result", id="bad")
    assert (result["status"], result["result"]) == (0, False)
    assert "order must be an int" in result["values"]


def test_a_goal_has_one_answer(
    web: WebProgram, node: zbot.Node, spin: Callable[..., Spinner]
) -> None:
    def execute(goal_handle: Any) -> Any:
        goal_handle.succeed()
        return Fibonacci.Result()

    ActionServer(node, Fibonacci, "count", execute)
    web.send(
        "send_action_goal", id="g", action="/count", action_type="example_interfaces/Fibonacci"
    )
    goal = web.dispatcher._actions._goals["g"]
    spin(node)
    web.wait_for("action_result", id="g")
    goal.fail("too late")
    assert not [answer for answer in web.read() if answer["op"] == "action_result"]


def test_a_goal_without_an_answer_fails(
    web: WebProgram, node: zbot.Node, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(action_operations, "ACCEPT_TIMEOUT_S", 0.2)
    ActionServer(node, Fibonacci, "busy", lambda _goal: Fibonacci.Result())  # nobody spins
    graph = web.session.bridge.graph
    assert wait_until(lambda: bool(dict(graph().actions()).get("/busy")), 10)
    web.send("send_action_goal", action="/busy", action_type="example_interfaces/Fibonacci")
    answer = web.wait_for("action_result", action="/busy")
    assert (answer["result"], answer["values"]) == (False, "/busy did not answer within 0.2 s")
    assert not web.dispatcher._actions._goals


def test_a_goal_without_a_server_fails(web: WebProgram, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("zbot.action.client._SERVER_TIMEOUT_S", 0.1)
    web.send("send_action_goal", action="/a", action_type="example_interfaces/Fibonacci", id="g")
    answer = web.wait_for("action_result", id="g")
    text = "/a: no server is running; start it, and send the goal again"
    assert (answer["result"], answer["values"]) == (False, text)
    assert not web.dispatcher._actions._goals


def test_serve_an_action(web: WebProgram, node: zbot.Node, spin: Callable[..., Spinner]) -> None:
    web.send("advertise_action", action="/fold", type="example_interfaces/Fibonacci")
    client: ActionClient[Any, Any, Any] = ActionClient(node, Fibonacci, "fold")
    spin(node)
    assert client.wait_for_server(10)
    feedback: list[Any] = []

    def send(order: int) -> tuple[Any, str]:
        goal = Fibonacci.Goal(order=order)
        future = client.send_goal_async(
            goal, lambda message: feedback.append(message.feedback.sequence)
        )
        request = web.wait_for("send_action_goal", action="/fold")
        assert request["args"] == {"order": order}
        assert wait_until(future.done, 10)
        return future.result(), request["id"]

    def outcome(handle: Any) -> tuple[int, list[int]]:
        future = handle.get_result_async()
        assert wait_until(future.done, 10)
        return future.result().status, list(future.result().result.sequence)

    handle, id_ = send(3)
    web.send("action_feedback", action="/fold", id=id_, values={"sequence": [7]})
    assert wait_until(lambda: [list(sequence) for sequence in feedback] == [[7]], 10)
    values = {"sequence": [1, 2]}
    web.send("action_result", action="/fold", id=id_, values=values, status=4, result=True)
    assert outcome(handle) == (4, [1, 2])
    handle, id_ = send(4)
    web.send("action_result", action="/fold", id=id_, status=6, result=False)
    assert outcome(handle) == (6, [])
    handle, id_ = send(5)
    handle.cancel_goal_async()
    assert web.wait_for("cancel_action_goal")["id"] == id_
    web.send("action_result", action="/fold", id=id_, values=values, status=5, result=True)
    assert outcome(handle) == (5, [1, 2])
