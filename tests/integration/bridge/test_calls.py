"""Tests of services, actions and parameters that the bridge carries, with a genuine ROS 2."""

from __future__ import annotations

import os
import signal
from typing import TYPE_CHECKING, Any

import pytest

from tests.conftest import wait_until
from tests.integration.bridge.conftest import eventually, needs_ros2
from zbot import Node
from zbot.action import ActionClient, ActionServer
from zbot.interfaces import get_action, get_service
from zbot.node.errors import ServiceError

if TYPE_CHECKING:
    from tests.conftest import MakeContext, Spin, Start
    from tests.integration.bridge.conftest import Bridges, Peers

pytestmark = needs_ros2()

SET_BOOL: Any = get_service("std_srvs/srv/SetBool")
FIBONACCI: Any = get_action("test_msgs/action/Fibonacci")
CANCELED, SUCCEEDED = 5, 4


def test_a_service_of_the_robot_is_called(
    make_context: MakeContext, peer: Peers, bridge: Bridges
) -> None:
    peer().serve_bool(name="/lamp")
    node = Node("laptop", context=make_context())
    bridge()
    client = node.create_client(SET_BOOL, "/lamp")
    assert client.wait_for_service(20)
    response = client.call(SET_BOOL.Request(data=True), timeout_sec=10)
    assert (response.success, response.message) == (True, "got True")


def test_the_robot_calls_a_service_of_zbot(
    make_context: MakeContext, spin: Spin, peer: Peers, bridge: Bridges
) -> None:
    robot, node = peer(), Node("laptop", context=make_context())

    def answer(request: Any, response: Any) -> Any:
        response.success, response.message = True, f"zbot got {request.data}"
        return response

    node.create_service(SET_BOOL, "/door", answer)
    spin(node)
    bridge()
    assert robot.call_bool(name="/door", data=False) == [True, "zbot got False"]


def test_a_call_fails_when_its_robot_vanishes(
    make_context: MakeContext, peer: Peers, bridge: Bridges
) -> None:
    robot, node = peer(), Node("laptop", context=make_context())
    robot.serve_bool(name="/slow", silent=True)
    bridge()
    client = node.create_client(SET_BOOL, "/slow")
    assert client.wait_for_service(20)
    future = client.call_async(SET_BOOL.Request(data=True))
    assert not wait_until(future.done, 0.5)
    os.kill(robot.process.pid, signal.SIGKILL)
    # DDS notes after 20 s that a process is gone.
    assert eventually(future.done, 40)
    assert isinstance(future.exception(), ServiceError)


def test_a_call_fails_when_its_bridge_vanishes(
    make_context: MakeContext, peer: Peers, bridge: Bridges
) -> None:
    robot, node = peer(), Node("laptop", context=make_context())
    robot.serve_bool(name="/slow", silent=True)
    program = bridge()
    client = node.create_client(SET_BOOL, "/slow")
    assert client.wait_for_service(20)
    future = client.call_async(SET_BOOL.Request(data=True))
    assert not wait_until(future.done, 0.5)
    program.process.kill()
    assert eventually(future.done)
    assert isinstance(future.exception(), ServiceError)


def test_a_goal_of_zbot_keeps_its_id(
    make_context: MakeContext, spin: Spin, peer: Peers, bridge: Bridges
) -> None:
    robot, node = peer(), Node("laptop", context=make_context())
    robot.serve_fibonacci(name="/count")
    client: ActionClient[Any, Any, Any] = ActionClient(node, FIBONACCI, "/count")
    spin(node)
    bridge()
    assert client.wait_for_server(20)
    feedback: list[Any] = []
    sent = client.send_goal_async(FIBONACCI.Goal(order=3), feedback_callback=feedback.append)
    assert eventually(sent.done)
    handle: Any = sent.result()
    result = handle.get_result_async()
    assert eventually(result.done)
    found: Any = result.result()
    assert (found.status, list(found.result.sequence)) == (SUCCEEDED, [0, 1, 1, 2])
    assert robot.goal_ids() == [bytes(handle.goal_id.uuid).hex()]
    assert eventually(lambda: [list(message.feedback.sequence) for message in feedback] == [[0, 1]])


def test_a_goal_of_zbot_is_canceled(
    make_context: MakeContext, spin: Spin, peer: Peers, bridge: Bridges
) -> None:
    robot, node = peer(), Node("laptop", context=make_context())
    robot.serve_fibonacci(name="/count", until_canceled=True)
    client: ActionClient[Any, Any, Any] = ActionClient(node, FIBONACCI, "/count")
    spin(node)
    bridge()
    assert client.wait_for_server(20)
    sent = client.send_goal_async(FIBONACCI.Goal(order=3))
    assert eventually(sent.done)
    handle: Any = sent.result()
    result = handle.get_result_async()
    canceled = handle.cancel_goal_async()
    assert eventually(canceled.done)
    cancel_response: Any = canceled.result()
    identities = [bytes(goal.goal_id.uuid) for goal in cancel_response.goals_canceling]
    assert identities == [bytes(handle.goal_id.uuid)]
    assert eventually(result.done)
    assert result.result().status == CANCELED


def test_the_robot_sends_a_goal_to_zbot(
    make_context: MakeContext, spin: Spin, peer: Peers, bridge: Bridges
) -> None:
    robot, node = peer(), Node("laptop", context=make_context())
    identities = []

    def execute(handle: Any) -> Any:
        identities.append(bytes(handle.goal_id.uuid).hex())
        handle.publish_feedback(FIBONACCI.Feedback(sequence=[7]))
        handle.succeed()
        return FIBONACCI.Result(sequence=[handle.request.order])

    ActionServer(node, FIBONACCI, "/turn", execute)
    spin(node)
    bridge()
    identity, sequence, feedback, status = robot.send_fibonacci(name="/turn", order=5)
    assert (identities, sequence, status) == ([identity], [5], SUCCEEDED)
    assert feedback in ([[7]], [])  # DDS may discover the topic later than the service


def test_a_parameter_of_the_robot_is_set(peer: Peers, bridge: Bridges, start: Start) -> None:
    robot = peer("turtle")
    robot.declare(name="speed", value=1.5)
    bridge("--parameters")
    assert eventually(lambda: start("zbot", "param", "get", "/turtle", "speed").wait(20) == 0)
    start("zbot", "param", "list", "/turtle").wait_for("speed", 20)
    program = start("zbot", "param", "set", "/turtle", "speed", "2.5")
    program.wait_for("Set parameter successful", 20)
    assert robot.parameter(name="speed") == pytest.approx(2.5)


def test_without_an_option_no_parameters_are_carried(
    make_context: MakeContext, peer: Peers, bridge: Bridges
) -> None:
    peer("turtle").serve_bool(name="/lamp")
    node = Node("laptop", context=make_context())
    bridge()

    def services() -> list[str]:
        found = node.get_service_names_and_types_by_node("turtle", "/")
        return [name for name, _ in found]

    assert eventually(lambda: ("turtle", "/") in node.get_node_names_and_namespaces())
    assert eventually(lambda: services() == ["/lamp"])
