"""Tests of the bridge to ROS 2 over Zenoh. A node that speaks rmw_zenoh stands for the robot."""

from __future__ import annotations

import socket
from contextlib import contextmanager
from functools import partial
from typing import TYPE_CHECKING, Any

import pytest

import zbot
from tests.integration.bridge.conftest import ONE_SIDE, eventually
from tests.integration.bridge.test_topics import STRING, Inbox
from zbot import Node, Parameter, QoSProfile
from zbot.action import ActionClient, ActionServer
from zbot.interfaces import get_action, get_message, get_service
from zbot.interfaces.parser import parse
from zbot.interfaces.registry import register_spec
from zbot.node.errors import ServiceError
from zbot.qos import DurabilityPolicy
from zbot.time import Time
from zbot.transport.rmw_choice import RMW_ZENOH
from zbot.wire.rmw_zenoh import HUMBLE

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator
    from pathlib import Path

    from tests.conftest import MakeContext, Program, Spin, Start

pytestmark = pytest.mark.own_dialect(ONE_SIDE)

SET_BOOL: Any = get_service("std_srvs/srv/SetBool")
FIBONACCI: Any = get_action("test_msgs/action/Fibonacci")
LATCHED = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
ROS_DOMAIN = 33


@pytest.fixture
def address(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> str:
    """Return the address of the router of ROS 2. Nodes of this process use it too."""
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        found = f"127.0.0.1:{probe.getsockname()[1]}"
    file = tmp_path / "router.json5"
    file.write_text(f'{{listen: {{endpoints: ["tcp/{found}"]}}}}', encoding="utf-8")
    monkeypatch.setenv("ZENOH_ROUTER_CONFIG_URI", str(file))
    monkeypatch.setenv("ZENOH_CONFIG_OVERRIDE", f'connect/endpoints=["tcp/{found}"]')
    return found


@pytest.fixture
def router(start: Start, address: str) -> Program:
    return start_router(start, address)


def start_router(start: Start, address: str) -> Program:
    program = start("zbot", "hub", "--rmw", env={"ZENOH_CONFIG_OVERRIDE": ""})
    program.wait_for(address, 20)
    return program


@pytest.fixture
def robot(router: Program) -> Iterator[Node]:
    """Return a node that speaks rmw_zenoh."""
    assert router
    with speaking_rmw_zenoh() as context:
        yield Node("robot", context=context)


@contextmanager
def speaking_rmw_zenoh() -> Iterator[zbot.Context]:
    context = zbot.Context(rmw=RMW_ZENOH)
    context.init([], domain_id=ROS_DOMAIN)
    try:
        yield context
    finally:
        context.shutdown()


@pytest.fixture
def bridge(start: Start, router: Program, address: str) -> Callable[..., Program]:
    assert router

    def run(*options: str) -> Program:
        words = ("--connect", address, "--ros-domain", str(ROS_DOMAIN), *options)
        program = start("zbot", "bridge", "rmw_zenoh", *words)
        program.wait_for("carrying between", 30)
        return program

    return run


def test_topics_go_both_ways(
    make_context: MakeContext, spin: Spin, robot: Node, bridge: Callable[..., Program]
) -> None:
    node = Node("laptop", context=make_context())
    ours, theirs = Inbox(node, "/pose"), Inbox(robot, "/drive")
    pose = robot.create_publisher(STRING, "/pose", 10)
    drive = node.create_publisher(STRING, "/drive", 10)
    spin(node)
    spin(robot)
    bridge()
    assert eventually(lambda: node.get_publishers_info_by_topic("/pose"))
    assert [publisher.node_name for publisher in node.get_publishers_info_by_topic("/pose")] == [
        "robot"
    ]
    assert eventually(lambda: robot.get_publishers_info_by_topic("/drive"))
    assert [publisher.node_name for publisher in robot.get_publishers_info_by_topic("/drive")] == [
        "laptop"
    ]

    def is_heard() -> bool:
        pose.publish(STRING(data="here"))
        drive.publish(STRING(data="go"))
        return ours.has("here") and theirs.has("go")

    assert eventually(is_heard)
    assert set(ours.texts) == {"here"}
    assert set(theirs.texts) == {"go"}


def test_a_killed_robot_comes_back(
    make_context: MakeContext, spin: Spin, bridge: Callable[..., Program], start: Start
) -> None:
    node = Node("laptop", context=make_context())
    inbox = Inbox(node, "/pose")
    spin(node)
    bridge()
    environment = {"RMW_IMPLEMENTATION": RMW_ZENOH, "ZBOT_DOMAIN_ID": str(ROS_DOMAIN)}
    for text in ("first", "second"):
        words = ("-r", "5", "/pose", "std_msgs/msg/String", f"data: {text}")
        robot = start("zbot", "topic", "pub", *words, env=environment)
        assert eventually(partial(inbox.has, text))
        robot.process.kill()
        assert eventually(lambda: not node.get_publishers_info_by_topic("/pose"))


def test_a_killed_router_comes_back(
    make_context: MakeContext,
    spin: Spin,
    router: Program,
    address: str,
    bridge: Callable[..., Program],
    start: Start,
) -> None:
    node = Node("laptop", context=make_context())
    inbox = Inbox(node, "/pose")
    spin(node)
    bridge()
    router.process.kill()
    router.process.wait(10)
    start_router(start, address)
    environment = {"RMW_IMPLEMENTATION": RMW_ZENOH, "ZBOT_DOMAIN_ID": str(ROS_DOMAIN)}
    start("zbot", "topic", "pub", "-r", "5", "/pose", "std_msgs/msg/String", env=environment)
    assert eventually(lambda: inbox.messages)


def test_a_killed_bridge_is_replaced(
    make_context: MakeContext, spin: Spin, robot: Node, bridge: Callable[..., Program]
) -> None:
    node = Node("laptop", context=make_context())
    inbox = Inbox(node, "/pose")
    spin(node)
    publisher = robot.create_publisher(STRING, "/pose", 10)
    for text in ("first", "second"):
        program = bridge()

        def arrives(text: str = text) -> bool:
            publisher.publish(STRING(data=text))
            return inbox.has(text)

        assert eventually(arrives)
        program.process.kill()
        assert eventually(lambda: not node.get_publishers_info_by_topic("/pose"))
        assert eventually(lambda: not robot.get_subscriptions_info_by_topic("/pose"))


def test_the_clock_of_the_robot_is_followed(
    make_context: MakeContext, spin: Spin, robot: Node, bridge: Callable[..., Program]
) -> None:
    simulated = [Parameter("use_sim_time", value=True)]
    node = Node("laptop", context=make_context(), parameter_overrides=simulated)
    spin(node)
    clock: Any = get_message("rosgraph_msgs/msg/Clock")
    publisher = robot.create_publisher(clock, "/clock", 10)
    bridge()

    def is_followed() -> bool:
        publisher.publish(clock(clock=Time(seconds=1234).to_msg()))
        return node.get_clock().now().nanoseconds == 1234 * 10**9

    assert eventually(is_followed)


def test_a_type_is_carried_when_a_node_comes_that_knows_it(
    make_context: MakeContext, spin: Spin, robot: Node, bridge: Callable[..., Program]
) -> None:
    node = Node("laptop", context=make_context())
    spin(robot)
    register_spec(parse("boat_msgs/msg/Draught", "float64 metres\n"))
    cls: Any = get_message("boat_msgs/msg/Draught")
    with speaking_rmw_zenoh() as context:
        silent = [Parameter("start_type_description_service", value=False)]
        old = Node("old", context=context, parameter_overrides=silent)
        old.create_publisher(cls, "/draught", 10)
        program = bridge()
        program.wait_for("/draught is not carried: ROS 2 has no definition of boat_msgs", 20)
        robot.create_publisher(cls, "/draught", 10)
        assert eventually(lambda: len(node.get_publishers_info_by_topic("/draught")) == 2)


def test_a_robot_of_humble_is_carried(
    make_context: MakeContext,
    spin: Spin,
    bridge: Callable[..., Program],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    node = Node("laptop", context=make_context())
    inbox = Inbox(node, "/pose")
    spin(node)
    monkeypatch.setenv("ROS_DISTRO", "humble")
    with speaking_rmw_zenoh() as context:
        publisher = Node("robot", context=context).create_publisher(STRING, "/pose", 10)
        assert context.dialect is HUMBLE
        monkeypatch.delenv("ROS_DISTRO")
        bridge()

        def arrives() -> bool:
            publisher.publish(STRING(data="here"))
            return inbox.has("here")

        assert eventually(arrives)


def test_a_latched_message_reaches_who_comes_later(
    make_context: MakeContext, spin: Spin, robot: Node, bridge: Callable[..., Program]
) -> None:
    node = Node("laptop", context=make_context())
    robot.create_publisher(STRING, "/map", LATCHED).publish(STRING(data="a map"))
    bridge()
    assert eventually(lambda: node.get_publishers_info_by_topic("/map"))
    inbox = Inbox(node, "/map", STRING, LATCHED)
    spin(node)
    assert eventually(lambda: inbox.texts == ["a map"])


def test_services_go_both_ways(
    make_context: MakeContext, spin: Spin, robot: Node, bridge: Callable[..., Program]
) -> None:
    node = Node("laptop", context=make_context())

    def serve(owner: Node, name: str) -> None:
        def answer(request: Any, response: Any) -> Any:
            response.success, response.message = request.data, owner.get_name()
            return response

        owner.create_service(SET_BOOL, name, answer)

    serve(robot, "/lamp")
    serve(node, "/door")
    spin(node)
    spin(robot)
    bridge()
    for caller, name, server in ((node, "/lamp", "robot"), (robot, "/door", "laptop")):
        client = caller.create_client(SET_BOOL, name)
        assert client.wait_for_service(20)
        response = client.call(SET_BOOL.Request(data=True), timeout_sec=10)
        assert (response.success, response.message) == (True, server)


def test_a_call_fails_when_its_robot_vanishes(
    make_context: MakeContext, robot: Node, bridge: Callable[..., Program]
) -> None:
    node = Node("laptop", context=make_context())
    robot.create_service(SET_BOOL, "/slow", lambda _request, response: response)  # nobody spins it
    bridge()
    client = node.create_client(SET_BOOL, "/slow")
    assert client.wait_for_service(20)
    future = client.call_async(SET_BOOL.Request(data=True))
    robot.context.shutdown()
    assert eventually(future.done)
    assert isinstance(future.exception(), ServiceError)


def test_a_goal_keeps_its_id(
    make_context: MakeContext, spin: Spin, robot: Node, bridge: Callable[..., Program]
) -> None:
    node = Node("laptop", context=make_context())
    identities = []

    def execute(handle: Any) -> Any:
        identities.append(bytes(handle.goal_id.uuid))
        handle.publish_feedback(FIBONACCI.Feedback(sequence=[7]))
        handle.succeed()
        return FIBONACCI.Result(sequence=[handle.request.order])

    ActionServer(robot, FIBONACCI, "/turn", execute)
    client: ActionClient[Any, Any, Any] = ActionClient(node, FIBONACCI, "/turn")
    spin(node)
    spin(robot)
    bridge()
    assert client.wait_for_server(20)
    sent = client.send_goal_async(FIBONACCI.Goal(order=3))
    assert eventually(sent.done)
    handle: Any = sent.result()
    result = handle.get_result_async()
    assert eventually(result.done)
    found: Any = result.result()
    assert list(found.result.sequence) == [3]
    assert identities == [bytes(handle.goal_id.uuid)]
