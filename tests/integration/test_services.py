"""Tests of services between processes and inside them: responses, errors and no deadlock."""

from __future__ import annotations

import gc
import resource
import threading
import weakref
from typing import TYPE_CHECKING, Any

import pytest

import zbot
from tests.conftest import wait_until
from zbot.errors import InvalidHandleError, NotInitializedError
from zbot.interfaces.errors import NotAMessageTypeError
from zbot.node.errors import RequestTypeError, ResponseTypeError, ServiceError
from zbot.wire.codec import codec_for

from example_interfaces.srv import AddTwoInts
from std_srvs.srv import Trigger

if TYPE_CHECKING:
    import zenoh

    from tests.conftest import MakeContext, Spin, Start

Request, Response = AddTwoInts.Request, AddTwoInts.Response

SERVER = """
import os, sys, time, zbot
from example_interfaces.srv import AddTwoInts
zbot.init()
node = zbot.Node("server")
def add(request, response):
    if request.a == -1:
        os._exit(9)
    if request.a == -2:
        print("working", flush=True)
        time.sleep(60)
    response.sum = request.a + request.b
    return response
node.create_service(AddTwoInts, "add", add)
print("ready", flush=True)
zbot.spin(node)
"""
SHORT_CLIENT = """
import zbot
from example_interfaces.srv import AddTwoInts
with zbot.init():
    node = zbot.Node("short")
    client = node.create_client(AddTwoInts, "add")
    client.wait_for_service(5)
    client.call_async(AddTwoInts.Request(a=40, b=2))
"""


def add(request: Any, response: Any) -> Any:
    response.sum = request.a + request.b
    return response


@pytest.fixture
def server(make_context: MakeContext, spin: Spin) -> zbot.Node:
    """Return a node in a session and thread of its own, without services."""
    node = zbot.Node("server", context=make_context())
    spin(node)
    return node


@pytest.fixture
def caller(make_context: MakeContext) -> zbot.Node:
    return zbot.Node("caller", context=make_context())


def client_of(node: zbot.Node, name: str = "add") -> Any:
    client = node.create_client(AddTwoInts, name)
    assert client.wait_for_service(5)
    return client


class TestAnswers:
    def test_a_call_returns_the_response(self, server: zbot.Node, caller: zbot.Node) -> None:
        server.create_service(AddTwoInts, "add", add)
        assert client_of(caller).call(Request(a=1, b=2)) == Response(sum=3)

    def test_a_future_is_complete_after_spinning(
        self, server: zbot.Node, caller: zbot.Node
    ) -> None:
        server.create_service(AddTwoInts, "add", add)
        future = client_of(caller).call_async(Request(a=1, b=2))
        zbot.spin_until_future_complete(caller, future, timeout_sec=5)
        assert future.result() == Response(sum=3)

    def test_spin_once_returns_when_a_response_has_come(
        self, server: zbot.Node, caller: zbot.Node
    ) -> None:
        server.create_service(AddTwoInts, "add", add)
        future = client_of(caller).call_async(Request(a=1, b=2))
        while not future.done():
            zbot.spin_once(caller, timeout_sec=30)
        assert future.result().sum == 3

    def test_a_node_that_calls_its_own_service_keeps_no_calls(self, caller: zbot.Node) -> None:
        caller.create_service(AddTwoInts, "add", add)
        client = client_of(caller)

        def call(number: int) -> weakref.ref[Any]:
            future = client.call_async(Request(a=number))
            zbot.spin_until_future_complete(caller, future, timeout_sec=5)
            return weakref.ref(future)

        calls = [call(number) for number in range(20)]
        gc.collect()
        # Zenoh's thread frees a call shortly after its response.
        assert wait_until(lambda: sum(each() is not None for each in calls) <= 1)

    def test_callbacks_of_a_future_run_in_the_executor(
        self, server: zbot.Node, caller: zbot.Node
    ) -> None:
        server.create_service(AddTwoInts, "add", add)
        future = client_of(caller).call_async(Request(a=1, b=2))
        seen: list[Any] = []
        future.add_done_callback(lambda over: seen.append((over, threading.current_thread())))
        assert wait_until(future.done)
        assert not seen
        zbot.spin_once(caller, timeout_sec=5)
        future.add_done_callback(lambda over: seen.append((over, threading.current_thread())))
        zbot.spin_once(caller, timeout_sec=5)
        assert seen == [(future, threading.current_thread())] * 2

    def test_handlers_may_be_coroutine_functions(
        self, make_context: MakeContext, spin: Spin, caller: zbot.Node
    ) -> None:
        # The first server calls the second and returns its response.
        context = make_context()
        front, back = zbot.Node("front", context=context), zbot.Node("back", context=context)
        behind = front.create_client(AddTwoInts, "behind")

        async def ask(request: Any, response: Any) -> Any:
            answer = await behind.call_async(request)
            assert answer is not None
            response.sum = answer.sum * 10
            return response

        back.create_service(AddTwoInts, "behind", add)
        front.create_service(AddTwoInts, "add", ask)
        spin(front, back)
        assert client_of(caller).call(Request(a=1, b=2)).sum == 30

    def test_megabytes_come_back(self, server: zbot.Node, caller: zbot.Node) -> None:
        text = "x" * 20_000_000

        def tell(_request: Any, response: Any) -> Any:
            response.message = text
            return response

        server.create_service(Trigger, "tell", tell)
        client = caller.create_client(Trigger, "tell")
        assert client.wait_for_service(5)
        assert client.call(Trigger.Request()).message == text

    def test_a_request_is_served_once_by_several_servers_of_one_name(
        self, make_context: MakeContext, spin: Spin, caller: zbot.Node
    ) -> None:
        served: list[int] = []

        def note(request: Any, response: Any) -> Any:
            served.append(request.a)
            return add(request, response)

        for number in range(3):
            node = zbot.Node(f"server_{number}", context=make_context())
            node.create_service(AddTwoInts, "add", note)
            spin(node)
        client = client_of(caller)
        assert [client.call(Request(a=a, b=1)).sum for a in range(20)] == list(range(1, 21))
        assert served == list(range(20))

    def test_a_plain_zenoh_server_answers(self, caller: zbot.Node) -> None:
        session = caller.context.session
        key = f"{caller.context.get_domain_id()}/add"
        kept: list[Any] = []

        def reply(query: zenoh.Query) -> None:
            kept.append(query)  # a program that keeps its query must not delay the caller
            query.reply(key, codec_for(Response).encode(Response(sum=7)))

        with session.declare_queryable(key, reply):
            client = caller.create_client(AddTwoInts, "add")
            assert client.wait_for_service(5)
            assert client.call(Request()).sum == 7
            future = client.call_async(Request())
            assert wait_until(future.done)
        kept.clear()

    def test_a_service_counts_its_endpoints(self, server: zbot.Node, caller: zbot.Node) -> None:
        server.create_service(AddTwoInts, "add", add)
        client_of(caller)
        known = ("/add", ["example_interfaces/srv/AddTwoInts"])
        assert wait_until(lambda: known in caller.get_service_names_and_types())
        assert caller.count_services("add") == 1
        assert caller.count_clients("add") == 1


class TestCallsFromCallbacks:
    @pytest.mark.parametrize("kind", [zbot.SingleThreadedExecutor, zbot.MultiThreadedExecutor])
    @pytest.mark.parametrize("is_own", [True, False], ids=["own", "other"])
    def test_a_timer_may_call(
        self,
        kind: type[zbot.Executor],
        is_own: bool,
        caller: zbot.Node,
        server: zbot.Node,
        spin: Spin,
    ) -> None:
        (caller if is_own else server).create_service(AddTwoInts, "add", add)
        client = client_of(caller)
        answers: list[int] = []

        def ask() -> None:
            timer.cancel()
            answers.append(client.call(Request(a=1, b=2), timeout_sec=5).sum)

        timer = caller.create_timer(0.001, ask)
        spin(caller, executor=kind(context=caller.context))
        assert wait_until(lambda: answers == [3])

    def test_a_handler_may_call_its_own_service(self, caller: zbot.Node, spin: Spin) -> None:
        client = caller.create_client(AddTwoInts, "add")

        def count_down(request: Any, response: Any) -> Any:
            if request.a:
                response.sum = 1 + client.call(Request(a=request.a - 1)).sum
            return response

        caller.create_service(AddTwoInts, "add", count_down)
        spin(caller)
        assert client.call(Request(a=5), timeout_sec=5).sum == 5


class TestErrors:
    def test_the_message_of_an_exception_reaches_the_caller(
        self, make_context: MakeContext, spin: Spin, caller: zbot.Node
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
        self, make_context: MakeContext, spin: Spin, caller: zbot.Node
    ) -> None:
        server = zbot.Node("server", context=make_context())
        server.create_service(AddTwoInts, "add", lambda _request, _response: None)
        spinner = spin(server)
        with pytest.raises(ServiceError, match="return response"):
            client_of(caller).call(Request())
        spinner.join()
        assert isinstance(spinner.error, ResponseTypeError)

    def test_a_call_without_a_server_fails_at_once(self, caller: zbot.Node) -> None:
        client = caller.create_client(AddTwoInts, "add")
        with pytest.raises(ServiceError, match="no server is running"):
            client.call(Request())
        future = client.call_async(Request())
        assert isinstance(future.exception(), ServiceError)
        assert not client.wait_for_service(0.05)

    def test_a_destroyed_server_fails_waiting_calls(
        self, make_context: MakeContext, caller: zbot.Node
    ) -> None:
        server = zbot.Node("server", context=make_context())  # never spins
        service = server.create_service(AddTwoInts, "add", add)
        future = client_of(caller).call_async(Request())
        assert wait_until(lambda: bool(service._queries))
        server.destroy_service(service)
        assert wait_until(future.done)
        assert isinstance(future.exception(), ServiceError)

    def test_a_call_raises_at_timeout(self, make_context: MakeContext, caller: zbot.Node) -> None:
        server = zbot.Node("server", context=make_context())  # never spins
        server.create_service(AddTwoInts, "add", add)
        client = client_of(caller)
        with pytest.raises(TimeoutError, match="no response in time"):
            client.call(Request(), timeout_sec=0.05)

    def test_a_request_that_cannot_be_read_is_refused(
        self, server: zbot.Node, caller: zbot.Node
    ) -> None:
        server.create_service(AddTwoInts, "add", add)
        client_of(caller)
        session = caller.context.session
        key = f"{caller.context.get_domain_id()}/add"
        replies = list(session.get(key, payload=b"\xc1"))
        assert [reply.ok for reply in replies] == [None]
        assert client_of(caller).call(Request(a=1)).sum == 1

    def test_a_request_of_another_type_is_refused(
        self, server: zbot.Node, caller: zbot.Node
    ) -> None:
        server.create_service(AddTwoInts, "add", add)
        mistaken: Any = caller.create_client(Trigger, "add")
        assert mistaken.wait_for_service(10)
        with pytest.raises(ServiceError, match="it is std_srvs/srv/Trigger_Request, not example"):
            mistaken.call(Trigger.Request())

    @pytest.mark.parametrize("wrong", [Response(), None, 5, AddTwoInts])
    def test_an_object_of_another_type_is_refused(self, wrong: Any, caller: zbot.Node) -> None:
        client = caller.create_client(AddTwoInts, "add")
        with pytest.raises(RequestTypeError, match="AddTwoInts_Request"):
            client.call_async(wrong)

    def test_a_message_type_is_refused_as_a_service_type(self, caller: zbot.Node) -> None:
        with pytest.raises(NotAMessageTypeError):
            caller.create_service(Request, "add", add)
        with pytest.raises(NotAMessageTypeError):
            caller.create_client(Request, "add")

    def test_a_destroyed_client_refuses(self, caller: zbot.Node) -> None:
        client = caller.create_client(AddTwoInts, "add")
        assert caller.destroy_client(client)
        assert not caller.destroy_client(client)
        with pytest.raises(InvalidHandleError):
            client.call_async(Request())
        with pytest.raises(InvalidHandleError):
            client.wait_for_service(0)

    def test_shutdown_ends_a_call(self, make_context: MakeContext, caller: zbot.Node) -> None:
        server = zbot.Node("server", context=make_context())  # never spins
        server.create_service(AddTwoInts, "add", add)
        client = client_of(caller)
        threading.Timer(0.05, caller.context.shutdown).start()
        with pytest.raises((NotInitializedError, ServiceError)):
            client.call(Request(), timeout_sec=30)

    def test_a_removed_request_never_completes(self, server: zbot.Node, caller: zbot.Node) -> None:
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


class TestLongRequests:
    """A request that outlasts the limit of Zenoh's queries is sent again and served once."""

    @pytest.fixture(autouse=True)
    def short_time(self, monkeypatch: pytest.MonkeyPatch) -> None:
        monkeypatch.setattr("zbot.node.service_request._FIRST_TIMEOUT_S", 0.1)
        monkeypatch.setattr("zbot.node.deduplication._LATE_S", 0.02)

    @pytest.mark.parametrize("kind", ["call", "call_async"])
    @pytest.mark.parametrize("is_coroutine", [False, True])
    def test_a_slow_handler_is_called_once(
        self, kind: str, is_coroutine: bool, server: zbot.Node, caller: zbot.Node
    ) -> None:
        served: list[int] = []
        gate: zbot.Future[None] = zbot.Future()
        opened = threading.Event()

        def open_gate() -> None:
            gate.set_result(None)
            opened.set()

        threading.Timer(0.5, open_gate).start()

        def slow(request: Any, response: Any) -> Any:
            served.append(request.a)
            assert opened.wait(5)
            return add(request, response)

        async def slow_coroutine(request: Any, response: Any) -> Any:
            served.append(request.a)
            await gate
            return add(request, response)

        server.create_service(AddTwoInts, "add", slow_coroutine if is_coroutine else slow)
        client = client_of(caller)
        if kind == "call":
            assert client.call(Request(a=1, b=2), timeout_sec=10).sum == 3
        else:
            future = client.call_async(Request(a=1, b=2))
            assert wait_until(future.done, 10)
            assert future.result().sum == 3
        assert served == [1]

    def test_a_late_error_is_received(self, make_context: MakeContext, caller: zbot.Node) -> None:
        opened = threading.Event()
        threading.Timer(0.3, opened.set).start()

        async def refuse(_request: Any, _response: Any) -> Any:
            assert opened.wait(5)
            raise ValueError("too late")

        server = zbot.Node("server", context=make_context())
        server.create_service(AddTwoInts, "add", refuse)
        executor = zbot.MultiThreadedExecutor(2, context=server.context)
        executor.add_node(server)

        def serve() -> None:
            while server.context.ok():
                try:
                    executor.spin()
                except ValueError:
                    continue
                except zbot.ExternalShutdownException:
                    return

        thread = threading.Thread(target=serve)
        thread.start()
        try:
            with pytest.raises(ServiceError, match="too late"):
                client_of(caller).call(Request(), timeout_sec=10)
        finally:
            executor.shutdown()
            server.context.shutdown()
            thread.join(5)


class TestProcesses:
    def test_a_server_that_is_killed_fails_the_call_at_once(
        self, caller: zbot.Node, start: Start
    ) -> None:
        process = start(source=SERVER)
        process.wait_for("ready")
        client = client_of(caller)
        future = client.call_async(Request(a=-2))
        process.wait_for("working")
        process.process.kill()
        assert wait_until(future.done, 1)
        assert isinstance(future.exception(), ServiceError)

    def test_a_call_finds_the_replacing_server(self, caller: zbot.Node, start: Start) -> None:
        client = caller.create_client(AddTwoInts, "add")
        for turn in range(3):
            start(source=SERVER).wait_for("ready")
            assert client.wait_for_service(5)
            assert client.call(Request(a=turn)).sum == turn
            with pytest.raises(ServiceError, match="ended before it answered"):
                client.call(Request(a=-1))

    def test_a_client_that_ends_after_sending_is_served(
        self, make_context: MakeContext, spin: Spin, start: Start
    ) -> None:
        served: list[int] = []

        def note(request: Any, response: Any) -> Any:
            served.append(request.a)
            return add(request, response)

        server = zbot.Node("server", context=make_context())
        server.create_service(AddTwoInts, "add", note)
        spin(server)
        for turn in range(1, 6):
            assert start(source=SHORT_CLIENT).wait() == 0
            assert wait_until(lambda turn=turn: len(served) == turn)  # type: ignore[misc]


class TestManyCalls:
    def test_ten_thousand_calls_leak_no_memory(self, server: zbot.Node, caller: zbot.Node) -> None:
        server.create_service(AddTwoInts, "add", add)
        client = client_of(caller)
        sizes = []
        for turn in range(10_000):
            assert client.call(Request(a=turn, b=1)).sum == turn + 1
            if turn % 1000 == 999:
                gc.collect()
                sizes.append(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss)
        # Zenoh keeps 0.8 kB per query for 2 s: memory grows to a plateau and then stays.
        assert sizes[-1] - sizes[0] < 0.8 * 9_000  # KiB
        assert not client._pending
        assert not client._completed

    def test_a_hundred_parallel_calls_of_four_clients_get_their_own_responses(
        self, server: zbot.Node, make_context: MakeContext
    ) -> None:
        server.create_service(AddTwoInts, "add", add)
        clients = [
            client_of(zbot.Node(f"caller_{number}", context=make_context())) for number in range(4)
        ]
        futures = {
            (number, turn): client.call_async(Request(a=number * 1000, b=turn))
            for turn in range(100)
            for number, client in enumerate(clients)
        }
        assert wait_until(lambda: all(future.done() for future in futures.values()), 20)
        for (number, turn), future in futures.items():
            assert future.result().sum == number * 1000 + turn
