"""Tests of service calls and their responses."""

from __future__ import annotations

import gc
import resource
import threading
import weakref
from typing import TYPE_CHECKING, Any

import pytest

import zbot
from tests.conftest import wait_until
from tests.integration.services.conftest import Request, Response, add, client_of
from zbot.remote.service_calls import ServiceCalls
from zbot.wire.messagepack.codec import messagepack_codec_for

from example_interfaces.srv import AddTwoInts
from std_srvs.srv import Trigger

if TYPE_CHECKING:
    import zenoh

    from tests.conftest import MakeContext, Spin
    from zbot.graph.snapshot import Snapshot


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

    @pytest.mark.own_dialect("in ROS 2 all servers of a name get each request")
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

    @pytest.mark.own_dialect("it sends a response in zbot's own form")
    def test_a_plain_zenoh_server_answers(self, caller: zbot.Node) -> None:
        session = caller.context.session
        key = f"{caller.context.get_domain_id()}/add"
        kept: list[Any] = []

        def reply(query: zenoh.Query) -> None:
            kept.append(query)  # a program that keeps its query must not delay the caller
            query.reply(key, messagepack_codec_for(Response).encode(Response(sum=7)))

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


class TestCallsOfSeveralServices:
    def test_a_command_asks_for_the_graph_once(
        self, server: zbot.Node, caller: zbot.Node, spin: Spin, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        names = [f"/add_{number}" for number in range(4)]
        for name in names:
            server.create_service(AddTwoInts, name, add)
        spin(server)
        asked: list[object] = []
        graph = caller.context.graph
        snapshot = graph.snapshot

        def count() -> Snapshot:
            asked.append(graph)
            return snapshot()

        monkeypatch.setattr(graph, "snapshot", count)
        requests = {name: Request(a=1, b=2) for name in [*names, "/missing"]}
        answers = ServiceCalls(caller).call_all(AddTwoInts, requests)
        assert answers.found == dict.fromkeys(names, Response(sum=3))
        assert list(answers.errors) == ["/missing"]
        assert len(asked) == 1


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
        assert not client._calls._numbers
        assert not client._calls

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
