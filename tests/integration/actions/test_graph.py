"""Tests of an action in the graph, and of mistakes that raise at once."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import pytest

import zbot
from tests.conftest import wait_until
from tests.integration.actions.conftest import Goal, Pair, compute, done, goal_id, status_of
from zbot.action import (
    ActionClient,
    ActionMessageError,
    ActionServer,
    GoalResponse,
    GoalState,
    NotAnActionTypeError,
    get_action_client_names_and_types_by_node,
    get_action_names_and_types,
    get_action_server_names_and_types_by_node,
)
from zbot.errors import InvalidServiceNameError
from zbot.node.errors import ServiceError, UnknownNodeError
from zbot.node.service_introspection import ServiceIntrospectionState

from action_msgs.msg import GoalStatusArray
from example_interfaces.action import Fibonacci
from std_msgs.msg import String

if TYPE_CHECKING:
    from tests.conftest import MakeContext, Spin
    from zbot.log.record import Record

# -- status ------------------------------------------------------------------------------------


def test_the_status_topic_gives_late_subscribers_the_state_of_each_goal(pair: Pair) -> None:
    waiting: list[Goal] = []
    pair.begin(compute, handle_accepted_callback=waiting.append)
    handle = pair.send(2, goal_uuid=goal_id(7))
    assert wait_until(lambda: handle.status == GoalState.ACCEPTED)
    seen: list[list[tuple[int, int]]] = []
    pair.client_node.create_subscription(
        GoalStatusArray,
        "/fibonacci/_action/status",
        lambda status: seen.append(
            [
                (int(goal_status.goal_info.goal_id.uuid[15]), goal_status.status)
                for goal_status in status.status_list
            ]
        ),
        zbot.QoSProfile(depth=1, durability=zbot.DurabilityPolicy.TRANSIENT_LOCAL),
    )
    assert wait_until(lambda: seen == [[(7, GoalState.ACCEPTED.value)]])
    waiting[0].execute()
    assert wait_until(lambda: bool(seen) and seen[-1] == [(7, GoalState.SUCCEEDED.value)])
    assert wait_until(lambda: handle.status == GoalState.SUCCEEDED)


def test_a_client_forgets_goals_without_a_handle(pair: Pair) -> None:
    pair.begin(compute, result_timeout=0.05)
    pair.send(1)
    assert pair.client._goals
    assert wait_until(lambda: not pair.server._goal_handles)
    pair.send(1)  # its status proves that the previous goal was forgotten
    assert wait_until(lambda: len(pair.client._goals) <= 1)


def test_services_of_an_action_can_be_introspected(pair: Pair) -> None:
    pair.begin(compute)
    seen: list[int] = []
    pair.client_node.create_subscription(
        Fibonacci.Impl.SendGoalService.Event,
        "/fibonacci/_action/send_goal/_service_event",
        lambda event: seen.append(event.info.event_type),
        10,
    )
    clock = pair.server_node.get_clock()
    for side in (pair.server, pair.client):
        side.configure_introspection(clock, 10, ServiceIntrospectionState.CONTENTS)
    assert pair.send(1).accepted
    assert wait_until(lambda: sorted(seen) == [0, 1, 2, 3])


# -- mistakes ----------------------------------------------------------------------------------


def test_types_are_checked_in_the_callers_line(pair: Pair) -> None:
    pair.begin(compute)
    with pytest.raises(ActionMessageError, match="takes a example_interfaces/action/Fibonacci_G"):
        pair.client.send_goal_async(Fibonacci.Result())
    with pytest.raises(TypeError):
        pair.client.send_goal(5)
    for kind in (ActionServer, ActionClient):
        with pytest.raises(NotAnActionTypeError, match="String is not an action type"):
            kind(pair.client_node, String, "x", *([compute] if kind is ActionServer else []))
    with pytest.raises(InvalidServiceNameError):
        ActionClient(pair.client_node, Fibonacci, "no name")


def test_feedback_of_another_type_aborts(pair: Pair, logged: list[Record]) -> None:
    pair.begin(lambda goal: goal.publish_feedback(Fibonacci.Result()))
    assert status_of(pair.client.send_goal(Fibonacci.Goal())) is GoalState.ABORTED
    assert any(
        "takes a example_interfaces/action/Fibonacci_Feedback" in record.message
        for record in logged
    )


def test_an_exception_of_a_goal_callback_reaches_the_client_and_ends_spin(pair: Pair) -> None:
    def decide(_: Fibonacci.Goal) -> GoalResponse:
        raise ValueError("no such order")

    pair.begin(compute, goal_callback=decide)
    with pytest.raises(ServiceError, match="no such order"):
        pair.send()
    assert wait_until(lambda: isinstance(pair.serving.error, ValueError))


def client_without_server(make_context: MakeContext, spin: Spin) -> ActionClient[Any, Any, Any]:
    node = zbot.Node("client_without_server", context=make_context())
    spin(node)
    return ActionClient[Any, Any, Any](node, Fibonacci, "fibonacci")


def test_a_goal_waits_for_a_starting_server(make_context: MakeContext, spin: Spin) -> None:
    client = client_without_server(make_context, spin)
    sent = client.send_goal_async(Fibonacci.Goal(order=3))
    assert wait_until(lambda: bool(client._timers))
    late = zbot.Node("late", context=make_context())
    spin(late)
    ActionServer[Any, Any, Any](late, Fibonacci, "fibonacci", compute)
    assert done(sent).accepted


def test_a_waiting_goal_ends_with_its_client(make_context: MakeContext, spin: Spin) -> None:
    client = client_without_server(make_context, spin)
    client.send_goal_async(Fibonacci.Goal())
    assert wait_until(lambda: bool(client._timers))
    client.destroy()
    assert not client._timers
    assert not client._goals


def test_a_goal_without_a_server_is_lost(
    make_context: MakeContext,
    spin: Spin,
    monkeypatch: pytest.MonkeyPatch,
    logged: list[Record],
) -> None:
    monkeypatch.setattr("zbot.action.client._SERVER_TIMEOUT_S", 0.1)
    client = client_without_server(make_context, spin)
    assert not client.server_is_ready()
    assert not client.wait_for_server(0.05)
    assert not client.wait_for_server(-1)
    sent = client.send_goal_async(Fibonacci.Goal())
    assert wait_until(lambda: any("no server is running" in record.message for record in logged))
    assert not sent.done()
    with pytest.raises(ServiceError, match="no server is running"):
        client.send_goal(Fibonacci.Goal())
    assert not client._goals


def test_a_goal_that_needs_a_server_fails_without_one(
    make_context: MakeContext, spin: Spin, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("zbot.action.client._SERVER_TIMEOUT_S", 0.1)
    client = client_without_server(make_context, spin)
    sent = client.send_goal_to_server_async(Fibonacci.Goal())
    with pytest.raises(ServiceError, match="/fibonacci: no server is running; start it"):
        done(sent)
    assert not client._goals


# -- names and the graph -----------------------------------------------------------------------


@pytest.mark.parametrize(
    ("name", "words", "full"),
    [
        ("fibonacci", (), "/robot1/fibonacci"),
        ("~/count", (), "/robot1/maths/count"),
        ("/count", (), "/count"),
        ("fibonacci", ("-r", "fibonacci:=numbers"), "/robot1/numbers"),
    ],
)
def test_names_are_resolved_as_those_of_topics(
    make_context: MakeContext, name: str, words: tuple[str, ...], full: str
) -> None:
    arguments = ["--ros-args", *words] if words else None
    node = zbot.Node("maths", context=make_context(), namespace="robot1", cli_args=arguments)
    server = ActionServer(node, Fibonacci, name, compute)
    assert server.action_name == full
    assert get_action_names_and_types(node) == [(full, ["example_interfaces/action/Fibonacci"])]
    services = dict(node.get_service_names_and_types())
    assert services[f"{full}/_action/get_result"] == [
        "example_interfaces/action/Fibonacci_GetResult"
    ]
    assert services[f"{full}/_action/cancel_goal"] == ["action_msgs/srv/CancelGoal"]
    topics = dict(node.get_topic_names_and_types())
    assert topics[f"{full}/_action/status"] == ["action_msgs/msg/GoalStatusArray"]
    assert topics[f"{full}/_action/feedback"] == [
        "example_interfaces/action/Fibonacci_FeedbackMessage"
    ]


def test_the_graph_knows_servers_and_clients(pair: Pair) -> None:
    pair.begin(compute)
    node = pair.client_node
    expected = [("/fibonacci", ["example_interfaces/action/Fibonacci"])]
    assert wait_until(
        lambda: get_action_server_names_and_types_by_node(node, "server", "/") == expected
    )
    assert get_action_names_and_types(node) == expected
    assert get_action_client_names_and_types_by_node(node, "server", "/") == []
    assert get_action_client_names_and_types_by_node(node, "client", "/") == expected
    with pytest.raises(UnknownNodeError):
        get_action_server_names_and_types_by_node(node, "nobody", "/")


def test_destroyed_servers_and_clients_leave_the_graph(pair: Pair) -> None:
    pair.begin(compute)
    pair.server.destroy()
    pair.client.destroy()
    pair.server.destroy()
    pair.client.destroy()
    assert wait_until(lambda: get_action_names_and_types(pair.client_node) == [])
    assert list(pair.server_node.services) == [
        service for service in pair.server_node.services if "_action" not in service.srv_name
    ]
