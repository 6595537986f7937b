"""Services that a web program calls and serves."""

from __future__ import annotations

import threading
from typing import TYPE_CHECKING, Any

from tests.conftest import wait_until
from zbot.node.errors import ServiceError
from zbot.web.rosbridge import service_operations

from example_interfaces.srv import AddTwoInts

if TYPE_CHECKING:
    from collections.abc import Callable

    import pytest

    import zbot
    from tests.conftest import Spinner
    from tests.integration.rosbridge.web_program import WebProgram


def test_call_service(web: WebProgram, node: zbot.Node, spin: Callable[..., Spinner]) -> None:
    def add(request: Any, response: Any) -> Any:
        if request.a < 0:
            raise ValueError("a is negative")
        response.sum = request.a + request.b
        return response

    node.create_service(AddTwoInts, "add", add)
    spin(node)
    assert wait_until(lambda: bool(dict(web.session.bridge.graph().services()).get("/add")), 10)
    assert web.call("/add", a=1, b=2**53 + 1) == {"sum": 2**53 + 2}
    web.send("call_service", service="/add", args=[4, 5])
    assert web.wait_for("service_response")["values"] == {"sum": 9}
    for service, args, reason in (
        ("/nothing", {}, "no service /nothing"),
        ("/add", {"a": "1"}, "a must be an int"),
        ("/add", {"a": -1}, "a is negative"),
    ):
        web.send("call_service", service=service, args=args, id=3)
        answer = web.wait_for("service_response", id=3)
        assert answer["result"] is False
        assert reason in answer["values"]


def test_a_call_has_a_timeout(web: WebProgram, node: zbot.Node) -> None:
    node.create_service(AddTwoInts, "busy", lambda _request, response: response)  # nobody spins
    assert wait_until(lambda: bool(dict(web.session.bridge.graph().services()).get("/busy")), 10)
    web.send("call_service", service="/busy", timeout=0.2, id="slow")
    answer = web.wait_for("service_response", id="slow")
    assert (answer["result"], answer["values"]) == (False, "/busy did not answer within 0.2 s")


def test_a_call_that_has_ended_has_no_timeout(
    web: WebProgram, node: zbot.Node, monkeypatch: pytest.MonkeyPatch
) -> None:
    timeouts: list[str] = []

    def call_later(_delay_s: float, _function: Callable[[], None]) -> Callable[[], None]:
        timeouts.append("runs")
        return timeouts.clear

    monkeypatch.setattr(web.session, "call_later", call_later)
    node.create_service(AddTwoInts, "busy", lambda _request, response: response)  # nobody spins
    assert wait_until(lambda: bool(dict(web.session.bridge.graph().services()).get("/busy")), 10)
    web.send("call_service", service="/busy", timeout=3600)
    assert timeouts
    web.dispatcher.close()
    assert not timeouts


def test_a_call_beyond_the_most_gets_an_answer(
    web: WebProgram, node: zbot.Node, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(service_operations, "MAX_CALLS", 1)
    node.create_service(AddTwoInts, "busy", lambda _request, response: response)  # nobody spins
    assert wait_until(lambda: bool(dict(web.session.bridge.graph().services()).get("/busy")), 10)
    for id_ in ("first", "second"):
        web.send("call_service", service="/busy", timeout=0, id=id_)
    answer = web.wait_for("service_response", id="second")
    assert (answer["result"], answer["values"]) == (False, "you wait for 1 responses already")


def test_a_defect_at_the_start_does_not_take_a_place_for_ever(
    web: WebProgram, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
) -> None:
    def defect() -> None:
        raise KeyError("defect")

    fields: dict[str, Any] = {"action": "/a", "action_type": "example_interfaces/Fibonacci"}
    with monkeypatch.context() as defective:
        defective.setattr(web.session.bridge, "graph", defect)
        defective.setattr(web.session, "require_writable", lambda _what: defect())
        web.send("call_service", service="/rosapi/nodes", id=1)
        web.send("send_action_goal", **fields, id=2)
    for op, id_ in (("service_response", 1), ("action_result", 2)):
        answer = web.wait_for(op, id=id_)
        values = "the server failed: KeyError('defect')"
        assert (answer["result"], answer["values"]) == (False, values)
    assert "Traceback" in capfd.readouterr().err
    assert not web.dispatcher._services._calls
    assert not web.dispatcher._actions._goals


def test_serve_a_service(web: WebProgram, node: zbot.Node) -> None:
    web.send("advertise_service", service="add", type="example_interfaces/AddTwoInts")
    client = node.create_client(AddTwoInts, "/add")
    assert client.wait_for_service(10)
    answers: list[Any] = []

    def call(a: int) -> None:
        try:
            answers.append(client.call(AddTwoInts.Request(a=a, b=1), 10).sum)
        except ServiceError as error:
            answers.append(str(error))

    def answer(a: int, **fields: Any) -> Any:
        thread = threading.Thread(target=call, args=(a,))
        thread.start()
        request = web.wait_for("call_service", service="add")
        assert request["args"] == {"a": a, "b": 1}
        web.send("service_response", service="add", id=request["id"], **fields)
        thread.join(10)
        return answers.pop()

    assert answer(1, values={"sum": 2}, result=True) == 2
    assert "no cable" in answer(2, values="no cable", result=False)
    assert "sum must be an int" in answer(3, values={"sum": "x"}, result=True)
    assert "sum must be an int" in web.wait_for("status")["msg"]
    thread = threading.Thread(target=call, args=(4,))
    thread.start()
    web.wait_for("call_service")
    web.send("unadvertise_service", service="add")
    thread.join(10)
    assert "has ended" in answers.pop()
