"""Tests of service events: what servers and clients publish about their calls."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import pytest

import zbot
from tests.conftest import wait_until
from zbot.action import ActionClient, ActionServer
from zbot.node.service_introspection import ServiceIntrospectionState, Step

from example_interfaces.action import Fibonacci
from example_interfaces.srv import AddTwoInts

if TYPE_CHECKING:
    from tests.conftest import MakeContext, Spin

TOPIC = "/add/_service_event"
OFF, METADATA, CONTENTS = ServiceIntrospectionState


def add(request: Any, response: Any) -> Any:
    if request.a < 0:
        raise ValueError("only what is there can be added")
    response.sum = request.a + request.b
    return response


async def add_later(request: Any, response: Any) -> Any:
    return add(request, response)


class Pair:
    """Server and client in sessions of their own, and the list of their service events."""

    def __init__(self, make_context: MakeContext, spin: Spin, callback: Any = add) -> None:
        self.node = zbot.Node("server", context=make_context())
        self.server = self.node.create_service(AddTwoInts, "add", callback)
        self.asking = zbot.Node("client", context=make_context())
        self.client = self.asking.create_client(AddTwoInts, "add")
        self.events: list[Any] = []
        watcher = zbot.Node("watcher", context=make_context())
        watcher.create_subscription(AddTwoInts.Event, TOPIC, self.events.append, 100)
        for node in (self.node, self.asking, watcher):
            spin(node)
        assert self.client.wait_for_service(5)

    def configure(self, state: ServiceIntrospectionState) -> None:
        for end, node in ((self.server, self.node), (self.client, self.asking)):
            end.configure_introspection(node.get_clock(), zbot.QoSProfile(depth=10), state)

    def steps(self, count: int) -> list[Step]:
        """Return `count` events in the order of the call; two sessions may not keep that order."""
        assert wait_until(lambda: len(self.events) >= count), self.events
        return sorted(Step(event.info.event_type) for event in self.events)


@pytest.fixture
def pair(make_context: MakeContext, spin: Spin) -> Pair:
    return Pair(make_context, spin)


@pytest.mark.parametrize("way", ["call", "call_async"])
@pytest.mark.parametrize("callback", [add, add_later])
def test_each_event_has_its_contents(
    make_context: MakeContext, spin: Spin, way: str, callback: Any
) -> None:
    pair = Pair(make_context, spin, callback)
    pair.configure(CONTENTS)
    getattr(pair.client, way)(AddTwoInts.Request(a=2, b=3))
    assert pair.steps(4) == list(Step)
    for event in pair.events:
        is_request = event.info.event_type in {Step.REQUEST_SENT, Step.REQUEST_RECEIVED}
        assert event.request == ([AddTwoInts.Request(a=2, b=3)] if is_request else [])
        assert event.response == ([] if is_request else [AddTwoInts.Response(sum=5)])
        assert event.info.sequence_number == 1
        assert bytes(event.info.client_gid) == pair.client.token.gid
        assert event.info.stamp.sec > 0


def test_metadata_leaves_the_contents_out(pair: Pair) -> None:
    pair.configure(METADATA)
    pair.client.call(AddTwoInts.Request(a=2, b=3))
    assert pair.steps(4) == list(Step)
    assert all(not event.request and not event.response for event in pair.events)


def test_introspection_can_be_switched_off(pair: Pair) -> None:
    pair.configure(CONTENTS)
    pair.client.call(AddTwoInts.Request())
    assert pair.steps(4)
    pair.configure(OFF)
    pair.client.call(AddTwoInts.Request())
    assert wait_until(lambda: not pair.asking.context.graph.snapshot().publishers(TOPIC))
    assert len(pair.events) == 4


def test_server_and_client_can_publish_events_independently(pair: Pair) -> None:
    pair.server.configure_introspection(pair.node.get_clock(), 10, METADATA)
    pair.client.call(AddTwoInts.Request())
    assert pair.steps(2) == [Step.REQUEST_RECEIVED, Step.RESPONSE_SENT]


def test_a_request_that_fails_has_no_response(make_context: MakeContext, spin: Spin) -> None:
    pair = Pair(make_context, spin)
    pair.configure(CONTENTS)
    with pytest.raises(zbot.ZbotError, match="only what is there"):
        pair.client.call(AddTwoInts.Request(a=-1))
    assert pair.steps(2) == [Step.REQUEST_SENT, Step.REQUEST_RECEIVED]


def test_the_topic_of_events_ends_with_its_endpoint(pair: Pair) -> None:
    pair.configure(METADATA)
    graph = pair.node.context.graph
    assert graph.wait_for(lambda seen: len(seen.publishers(TOPIC)) == 2, 5)
    pair.node.destroy_service(pair.server)
    assert graph.wait_for(lambda seen: len(seen.publishers(TOPIC)) == 1, 5)
    pair.asking.destroy_node()
    assert graph.wait_for(lambda seen: not seen.publishers(TOPIC), 5)


def test_services_of_every_node_can_be_introspected(pair: Pair) -> None:
    name = "/server/list_parameters"
    (server,) = (service for service in pair.node.services if service.service_name == name)
    server.configure_introspection(pair.node.get_clock(), 10, METADATA)
    (publisher,) = pair.node.context.graph.snapshot().publishers(f"{name}/_service_event")
    assert publisher.type_name == "rcl_interfaces/srv/ListParameters_Event"


def test_an_action_publishes_events_of_its_services(make_context: MakeContext, spin: Spin) -> None:
    node, asking = (zbot.Node(name, context=make_context()) for name in ("server", "client"))

    def reach(goal_handle: Any) -> Any:
        goal_handle.succeed()
        return Fibonacci.Result(sequence=[0, 1])

    server: Any = ActionServer(node, Fibonacci, "fibonacci", reach)
    client: Any = ActionClient(asking, Fibonacci, "fibonacci")
    events: list[Any] = []
    for part, kind in (
        ("send_goal", Fibonacci.Impl.SendGoalService),
        ("get_result", Fibonacci.Impl.GetResultService),
    ):
        topic = f"/fibonacci/_action/{part}/_service_event"
        asking.create_subscription(kind.Event, topic, events.append, 10)
    server.configure_introspection(node.get_clock(), 10, CONTENTS)
    client.configure_introspection(asking.get_clock(), 10, METADATA)
    spin(node)
    spin(asking)
    assert client.wait_for_server(5)
    assert client.send_goal(Fibonacci.Goal(order=1)).result.sequence.tolist() == [0, 1]
    assert wait_until(lambda: len(events) == 8), events
    assert {len(event.request) + len(event.response) for event in events} == {0, 1}
    client.destroy()
    server.destroy()
