"""Tests of the functions of ros2cli's Python packages, called as programs call them."""

from __future__ import annotations

import argparse
import importlib
import os
import threading
from typing import TYPE_CHECKING, Any

import pytest

import zbot
from tests.conftest import wait_until
from zbot.action import ActionServer
from zbot.compat.command_node import CommandNode, add_arguments
from zbot.compat.graph_listing import (
    TopicInfo,
    get_absolute_node_name,
    get_action_names,
    get_action_server_info,
    get_msg_class,
    get_node_names,
    get_publisher_info,
    get_service_class,
    get_service_names,
    get_service_server_info,
    get_subscriber_info,
    get_topic_names,
    parse_node_name,
)
from zbot.compat.parameter_calls import (
    call_describe_parameters,
    call_get_parameters,
    call_list_parameters,
    call_set_parameters,
    get_parameter_type_string,
    get_parameter_value,
    get_value,
)
from zbot.errors import WrongStateError

from example_interfaces.action import Fibonacci
from std_msgs.msg import Int32, String
from std_srvs.srv import Trigger

if TYPE_CHECKING:
    from tests.conftest import MakeContext, Spin


@pytest.fixture
def robot(make_context: MakeContext) -> zbot.Node:
    node = zbot.Node("base", namespace="robot", context=make_context())
    node.create_publisher(String, "state", 10)
    node.create_publisher(String, "_inner/state", 10)
    node.create_subscription(Int32, "speed", lambda _: None, 10)
    node.create_service(Trigger, "stop", lambda _, response: response)
    node.declare_parameter("limit", 1.5)
    ActionServer[Any, Any, Any](node, Fibonacci, "count", lambda _: Fibonacci.Result())
    return node


@pytest.fixture
def asking(make_context: MakeContext, robot: zbot.Node) -> zbot.Node:  # noqa: ARG001 - after it
    return zbot.Node("asking", context=make_context())


def test_names_of_nodes_have_their_parts(asking: zbot.Node) -> None:
    names = get_node_names(node=asking)
    assert [name.full_name for name in names] == ["/asking", "/robot/base"]
    assert parse_node_name("robot/base") == names[1] == ("base", "/robot", "/robot/base")
    assert parse_node_name("/asking") == ("asking", "/", "/asking")
    assert get_absolute_node_name("robot/base") == "/robot/base"
    assert get_absolute_node_name("") is None


def test_lists_of_a_node_leave_hidden_entities_out(asking: zbot.Node) -> None:
    of_robot: dict[str, Any] = {"node": asking, "remote_node_name": "/robot/base"}
    topics = [topic.name for topic in get_publisher_info(**of_robot)]
    assert "/robot/state" in topics
    assert "/robot/_inner/state" not in topics
    assert "/robot/_inner/state" in [
        topic.name for topic in get_publisher_info(**of_robot, include_hidden=True)
    ]
    assert get_subscriber_info(**of_robot) == [TopicInfo("/robot/speed", ["std_msgs/msg/Int32"])]
    assert ("/robot/stop", ["std_srvs/srv/Trigger"]) in get_service_server_info(**of_robot)
    assert [action.name for action in get_action_server_info(**of_robot)] == ["/robot/count"]
    assert get_action_names(node=asking) == ["/robot/count"]


def test_lists_leave_hidden_names_out(asking: zbot.Node) -> None:
    assert "/robot/_inner/state" not in get_topic_names(node=asking)
    assert "/robot/_inner/state" in get_topic_names(node=asking, include_hidden_topics=True)
    assert "/robot/stop" in get_service_names(node=asking)


def test_a_class_is_found_by_name(asking: zbot.Node, capsys: pytest.CaptureFixture[str]) -> None:
    assert get_msg_class(asking, "robot/state") is String
    assert get_service_class(asking, "/robot/stop") is Trigger
    assert get_msg_class(asking, "/robot/_inner/state") is None
    assert get_msg_class(asking, "/robot/_inner/state", include_hidden_topics=True) is String
    assert capsys.readouterr().err == ""
    assert get_msg_class(asking, "nowhere") is None
    assert "topic [nowhere] does not appear to be published yet" in capsys.readouterr().err


def test_the_class_of_a_topic_can_be_waited_for(robot: zbot.Node, asking: zbot.Node) -> None:
    later = threading.Timer(0.1, robot.create_publisher, (Int32, "later", 10))
    later.start()
    assert get_msg_class(asking, "/robot/later", blocking=True) is Int32
    later.join()


def test_several_types_are_refused(robot: zbot.Node, asking: zbot.Node) -> None:
    robot.create_publisher(Int32, "state", 10)
    assert wait_until(lambda: len(dict(asking.get_topic_names_and_types())["/robot/state"]) == 2)
    with pytest.raises(WrongStateError, match=r"/robot/state.*std_msgs/msg/Int32"):
        get_msg_class(asking, "/robot/state")


def test_parameters_of_another_node_take_one_call(
    robot: zbot.Node, asking: zbot.Node, spin: Spin
) -> None:
    spin(robot)
    of_robot: dict[str, Any] = {"node": asking, "node_name": "/robot/base"}
    assert "limit" in call_list_parameters(**of_robot)
    change = zbot.Parameter("limit", value=2.5).to_parameter_msg()
    (result,) = call_set_parameters(**of_robot, parameters=[change]).results
    assert result.successful
    (value,) = call_get_parameters(**of_robot, parameter_names=["limit"]).values
    assert get_value(parameter_value=value) == 2.5
    (described,) = call_describe_parameters(**of_robot, parameter_names=["limit"]).descriptors
    assert get_parameter_type_string(described.type) == "double"
    assert get_value(parameter_value=get_parameter_value(string_value="[1, 2]")) == [1, 2]
    assert list(asking.clients) == []


def test_parameters_of_an_unknown_node_are_an_error(
    asking: zbot.Node, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("zbot.compat.parameter_calls.ANSWER_TIMEOUT_S", 0.01)
    with pytest.raises(WrongStateError, match="/nobody offered no parameter services"):
        call_get_parameters(node=asking, node_name="/nobody", parameter_names=["limit"])


@pytest.mark.usefixtures("domain")
def test_a_program_without_a_context_gets_a_temporary_node() -> None:
    parser = argparse.ArgumentParser()
    add_arguments(parser)
    with CommandNode(parser.parse_args(["--no-daemon"]), node_name="look") as node:
        assert get_node_names(node=node.node) == []
        names = get_node_names(node=node.direct_node.node, include_hidden_nodes=True)
        assert [name.full_name for name in names] == ["/_ros2cli_look"]
        assert node.get_name() == "_ros2cli_look"
    assert not zbot.ok()


@pytest.mark.usefixtures("domain")
def test_a_temporary_node_leaves_the_programs_context_alone() -> None:
    with zbot.init(args=[]):
        with CommandNode() as node:
            assert node.get_name() == f"_ros2cli_{os.getpid()}"
        assert zbot.ok()


@pytest.mark.parametrize(
    ("module", "name", "found"),
    [
        ("ros2topic.api", "get_msg_class", get_msg_class),
        ("ros2node.api", "get_node_names", get_node_names),
        ("ros2service.api", "get_service_names", get_service_names),
        ("ros2action.api", "get_action_names", get_action_names),
        ("ros2param.api", "call_get_parameters", call_get_parameters),
        ("ros2cli.node.strategy", "NodeStrategy", CommandNode),
        ("ros2cli.node.direct", "DirectNode", CommandNode),
    ],
)
def test_ros2s_names_are_these_functions(module: str, name: str, found: object) -> None:
    assert getattr(importlib.import_module(module), name) is found
