"""Tests of service calls that fail."""

from __future__ import annotations

import threading
from typing import TYPE_CHECKING, Any

import pytest

import zbot
from tests.conftest import allowed, wait_until
from tests.integration.services.conftest import Request, Response, add, client_of
from zbot.action import ActionClient
from zbot.errors import InvalidHandleError, NotInitializedError, WrongTypeError
from zbot.interfaces.errors import NotAMessageTypeError
from zbot.node import service_request
from zbot.node.errors import ServiceError

from example_interfaces.action import Fibonacci
from example_interfaces.srv import AddTwoInts
from std_srvs.srv import Trigger

if TYPE_CHECKING:
    from tests.conftest import MakeContext, Spin
    from zbot.log.record import Record


def test_the_message_of_an_exception_reaches_the_caller(
    make_context: MakeContext, spin: Spin, caller: zbot.Node
) -> None:
    def refuse(_request: Any, _response: Any) -> Any:
        raise ValueError("b must not be 0")

    server = zbot.Node("server", context=make_context())
    server.create_service(AddTwoInts, "add", refuse)
    spinner = spin(server)
    with pytest.raises(ServiceError, match="/add: b must not be 0") as caught:
        client_of(caller).call(Request())
    assert caught.value.kind == "ValueError"
    spinner.join()
    assert isinstance(spinner.error, ValueError)


def test_a_missing_response_is_reported_on_both_sides(
    make_context: MakeContext, spin: Spin, caller: zbot.Node
) -> None:
    server = zbot.Node("server", context=make_context())
    server.create_service(AddTwoInts, "add", lambda _request, _response: None)
    spinner = spin(server)
    with pytest.raises(ServiceError, match="return response"):
        client_of(caller).call(Request())
    spinner.join()
    assert isinstance(spinner.error, WrongTypeError)


def test_a_long_wait_for_a_server_is_told_once(
    caller: zbot.Node, logged: list[Record], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("zbot.node.client._QUIET_S", 0.05)
    assert not caller.create_client(AddTwoInts, "add").wait_for_service(1.0)
    assert not ActionClient(caller, Fibonacci, "count").wait_for_server(1.0)
    texts = [record.message for record in logged if "waiting" in record.message]
    assert texts == [
        "waiting for /add: no server is running",
        "waiting for /count: no server is running",
    ]


def test_a_blocking_call_without_a_server_fails_at_once(caller: zbot.Node) -> None:
    client = caller.create_client(AddTwoInts, "add")
    with pytest.raises(ServiceError, match="no server is running"):
        client.call(Request())
    failed = client.call_server_async(Request())
    assert isinstance(failed.exception(), ServiceError)
    assert not client.wait_for_service(0.05)
    assert not client.wait_for_service(-1)


def test_a_wait_for_a_server_ends_when_the_client_is_destroyed(caller: zbot.Node) -> None:
    client = caller.create_client(AddTwoInts, "add")
    found: list[bool] = []
    wait = threading.Thread(target=lambda: found.append(client.wait_for_service()), daemon=True)
    wait.start()
    assert wait_until(lambda: client._listener is not None)
    caller.destroy_client(client)
    wait.join(allowed(10))
    assert found == [False]


def test_another_thread_may_use_a_client_that_is_destroyed(caller: zbot.Node) -> None:
    def ask(client: zbot.Client[Any, Any], begun: threading.Event) -> None:
        while not client.is_destroyed:
            assert not client.service_is_ready()
            begun.set()

    for _ in range(20):
        client, begun = caller.create_client(AddTwoInts, "add"), threading.Event()
        asking = threading.Thread(target=ask, args=(client, begun))
        asking.start()
        assert begun.wait(allowed(10))
        caller.destroy_client(client)
        asking.join(allowed(10))
        assert not asking.is_alive()


def test_a_future_of_a_call_without_a_server_is_never_done(
    make_context: MakeContext, caller: zbot.Node, spin: Spin, logged: list[Record]
) -> None:
    client = caller.create_client(AddTwoInts, "add")
    lost = [client.call_async(Request(a=1, b=2)) for _ in range(2)]
    assert not any(future.done() for future in lost)
    warnings = [record.message for record in logged if "no server is running" in record.message]
    assert len(warnings) == 1
    server = zbot.Node("server", context=make_context())
    server.create_service(AddTwoInts, "add", add)
    spin(server, caller)
    assert client.wait_for_service(10)
    retry = client.call_async(Request(a=3, b=4))
    assert wait_until(retry.done)
    answer = retry.result()
    assert answer is not None
    assert answer.sum == 7
    assert not any(future.done() for future in lost)
    client.remove_pending_request(lost[0])


def test_a_timeout_can_be_a_duration(server: zbot.Node, caller: zbot.Node) -> None:
    client = caller.create_client(AddTwoInts, "add")
    assert not client.wait_for_service(zbot.Duration(seconds=0.05))
    with pytest.raises(TypeError, match="timeout_sec must be a number of seconds, not str"):
        client.wait_for_service("5")  # type: ignore[arg-type]
    server.create_service(AddTwoInts, "add", add)
    assert client.wait_for_service(zbot.Duration(seconds=5))


def test_a_destroyed_server_fails_waiting_calls(
    make_context: MakeContext, caller: zbot.Node
) -> None:
    server = zbot.Node("server", context=make_context())  # never spins
    service = server.create_service(AddTwoInts, "add", add)
    future = client_of(caller).call_async(Request())
    assert wait_until(lambda: bool(service._queries))
    server.destroy_service(service)
    assert wait_until(future.done)
    assert isinstance(future.exception(), ServiceError)


def test_a_call_raises_at_timeout(make_context: MakeContext, caller: zbot.Node) -> None:
    server = zbot.Node("server", context=make_context())  # never spins
    server.create_service(AddTwoInts, "add", add)
    client = client_of(caller)
    with pytest.raises(TimeoutError, match="no response in time"):
        client.call(Request(), timeout_sec=0.05)


@pytest.mark.own_dialect("it sends a request in zbot's own form")
def test_a_request_that_cannot_be_read_is_refused(server: zbot.Node, caller: zbot.Node) -> None:
    server.create_service(AddTwoInts, "add", add)
    client_of(caller)
    session = caller.context.session
    key = f"{caller.context.get_domain_id()}/add"
    replies = list(session.get(key, payload=b"\xc1"))
    assert [reply.ok for reply in replies] == [None]
    assert client_of(caller).call(Request(a=1)).sum == 1


@pytest.mark.own_dialect("in ROS 2 a client finds no server of another type")
def test_a_request_of_another_type_is_refused(server: zbot.Node, caller: zbot.Node) -> None:
    server.create_service(AddTwoInts, "add", add)
    mistaken: Any = caller.create_client(Trigger, "add")
    assert mistaken.wait_for_service(10)
    with pytest.raises(ServiceError, match="it is std_srvs/srv/Trigger_Request, not example"):
        mistaken.call(Trigger.Request())


@pytest.mark.parametrize("wrong", [Response(), None, 5, AddTwoInts])
def test_an_object_of_another_type_is_refused(wrong: Any, caller: zbot.Node) -> None:
    client = caller.create_client(AddTwoInts, "add")
    with pytest.raises(WrongTypeError, match="AddTwoInts_Request"):
        client.call_async(wrong)


def test_a_message_type_is_refused_as_a_service_type(caller: zbot.Node) -> None:
    with pytest.raises(NotAMessageTypeError):
        caller.create_service(Request, "add", add)
    with pytest.raises(NotAMessageTypeError):
        caller.create_client(Request, "add")


def test_a_destroyed_client_refuses(caller: zbot.Node) -> None:
    client = caller.create_client(AddTwoInts, "add")
    assert caller.destroy_client(client)
    assert not caller.destroy_client(client)
    with pytest.raises(InvalidHandleError):
        client.call_async(Request())
    with pytest.raises(InvalidHandleError):
        client.wait_for_service(0)


def test_a_client_that_is_destroyed_during_a_call_says_so(
    make_context: MakeContext, caller: zbot.Node, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(service_request, "_FIRST_TIMEOUT_S", 0.2)  # then the request is repeated
    server = zbot.Node("server", context=make_context())  # never spins
    server.create_service(AddTwoInts, "add", add)
    client = client_of(caller)
    threading.Timer(0.05, client.destroy).start()
    with pytest.raises(InvalidHandleError, match="client of /add"):
        client.call(Request(), timeout_sec=30)


def test_shutdown_ends_a_call(make_context: MakeContext, caller: zbot.Node) -> None:
    server = zbot.Node("server", context=make_context())  # never spins
    server.create_service(AddTwoInts, "add", add)
    client = client_of(caller)
    threading.Timer(0.05, caller.context.shutdown).start()
    with pytest.raises((NotInitializedError, ServiceError)):
        client.call(Request(), timeout_sec=30)


def test_a_removed_request_never_completes(server: zbot.Node, caller: zbot.Node) -> None:
    client = caller.create_client(AddTwoInts, "add")
    gate = threading.Event()

    def wait(request: Any, response: Any) -> Any:
        gate.wait(5)
        return add(request, response)

    server.create_service(AddTwoInts, "add", wait)
    assert client.wait_for_service(5)
    future = client.call_async(Request())
    assert client.get_pending_request(1) is future
    client.remove_pending_request(future)
    gate.set()
    client.call(Request())
    assert not future.done()
    with pytest.raises(KeyError):
        client.get_pending_request(1)
