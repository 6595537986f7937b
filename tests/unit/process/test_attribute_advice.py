"""Tests of what is said about a name that rclpy does not have."""

from __future__ import annotations

import importlib
import sys
import traceback
from typing import TYPE_CHECKING, Any

import pytest

import zbot
from zbot.process.attribute_advice import (
    advise_of_attribute,
    advise_of_import,
    suggest_public_name,
)
from zbot.runtime import InitContextManager
from zbot.time import Duration, Time

from example_interfaces.action import Fibonacci
from geometry_msgs.msg import Pose

if TYPE_CHECKING:
    from collections.abc import Callable


class Robot(zbot.Node):
    speed: Any

    def __init__(self) -> None:
        """Create no node."""

    def turn(self) -> None: ...


class ServerGoalHandle:
    request = Fibonacci.Goal()

    def publish_feedback(self, feedback: Any) -> None: ...


class NoNode:
    timer: Any


robot: Any = Robot()
result: Any = zbot.Future()
result.set_result(Time())
library: Any = importlib.import_module("rclpy")


def text_of(call: Callable[[], Any]) -> str:
    with pytest.raises(AttributeError) as caught:
        call()
    advise_of_attribute(caught.value)
    return str(caught.value)


@pytest.mark.parametrize(
    ("call", "advice"),
    [
        (lambda: library.Publisher, "write self.create_publisher(String, 'chatter', 10) in a node"),
        (lambda: library.init_node("x"), "write rclpy.init(), and then rclpy.create_node('name')"),
        (lambda: library.loginfo("x"), "write self.get_logger().info('text') in a node"),
        (lambda: robot.get_logger.info("x"), "write get_logger().info, with parentheses"),
        (lambda: robot.subscribe, "write create_subscription"),
        (lambda: robot.create_subscriber, "write create_subscription"),
        (lambda: robot.destroy, "write destroy_node"),
        (lambda: robot.publish("hi"), "write self.publisher.publish(message), with the result"),
        (lambda: zbot.Node.__new__(zbot.Node).clock, "write get_clock()"),  # type: ignore[attr-defined]
        (lambda: zbot.Parameter("speed", value=2.0).get_value(), "write value"),  # type: ignore[attr-defined]
        (lambda: setattr(Pose.position, "x", 1.0), "write parentheses after the class, e.g. messa"),
        (lambda: zbot.Future[Any]().success, "write result().success, after rclpy.spin_until_"),  # type: ignore[attr-defined]
        (
            lambda: zbot.Future[Any]().result().success,  # type: ignore[union-attr]
            "write rclpy.spin_until_future_complete(node,",
        ),
        (lambda: Time().nanosec, "write to_msg().nanosec"),  # type: ignore[attr-defined]
        (lambda: setattr(robot, "context", 5), "nodes use this name themselves; choose another"),
        (lambda: setattr(robot, "waitables", []), "nodes use this name themselves; choose another"),
        (lambda: NoNode().create_timer(1.0, print), "write class NoNode(Node):"),  # type: ignore[attr-defined]
        (
            lambda: InitContextManager(zbot.Context()).create_timer(1.0, print),  # type: ignore[attr-defined]
            "write node = Node('my_node') for a node, because init() returns none",
        ),
        (lambda: zbot.init_node("x"), "write zbot.init(), and then zbot.create_node('name')"),
        (lambda: ServerGoalHandle().order, "write goal_handle.request.order"),  # type: ignore[attr-defined]
    ],
)
def test_a_typical_wrong_name_says_what_to_write(call: Callable[[], Any], advice: str) -> None:
    assert f": {advice}" in text_of(call)


@pytest.mark.skipif(sys.version_info < (3, 11), reason="Python 3.10 does not name the class")
@pytest.mark.parametrize(
    ("owner", "name", "advice"),
    [
        (Duration(), "nanoseconds", "write a new one, e.g. Duration(seconds=1.5)"),
        (zbot.Parameter("a", value=2.0), "value", "write node.set_parameters([Parameter('speed', "),
    ],
)
def test_an_attribute_that_is_set_says_what_to_write(owner: Any, name: str, advice: str) -> None:
    assert f": {advice}" in text_of(lambda: setattr(owner, name, 5))


@pytest.mark.parametrize(
    "call",
    [
        lambda: library.nonsense,
        lambda: robot.nonsense,
        lambda: robot.turn.count,
        lambda: pytest.sleep,  # type: ignore[attr-defined]
        lambda: [].subscribe,  # type: ignore[attr-defined]
        lambda: [].get_logger,  # type: ignore[attr-defined]
        lambda: NoNode().nonsense,  # type: ignore[attr-defined]
    ],
)
def test_other_names_keep_the_text_of_python(call: Callable[[], Any]) -> None:
    assert "write" not in text_of(call)


def test_a_result_that_is_done_gets_no_advice_to_wait_for_it() -> None:
    with pytest.raises(AttributeError) as caught:
        result.result().nonsense  # noqa: B018
    caught.value.obj = None  # as after the advice of `spin()` for messages
    advise_of_attribute(caught.value)
    assert "write" not in str(caught.value)


def test_no_private_name_is_suggested() -> None:
    with pytest.raises(AttributeError) as caught:
        zbot.Parameter("speed", value=2.0).valeu  # type: ignore[attr-defined]  # noqa: B018
    suggest_public_name(caught.value)
    assert str(caught.value) == "'Parameter' object has no attribute 'valeu'; did you mean 'value'?"
    assert "_value" not in "".join(traceback.format_exception(caught.value))


@pytest.mark.parametrize(("name", "suggested"), [("node", "Node"), ("Nod", "Node")])
def test_a_wrong_import_suggests_a_name_of_this_module(name: str, suggested: str) -> None:
    with pytest.raises(ImportError) as caught:
        exec(f"from rclpy.node import {name}", {})
    advise_of_import(caught.value)
    shown = "".join(traceback.format_exception(caught.value))
    assert shown.endswith(f"; did you mean '{suggested}'?\n")


def test_a_wrong_import_from_another_package_is_left_alone() -> None:
    with pytest.raises(ImportError) as caught:
        exec("from json import dump_s", {})
    advise_of_import(caught.value)
    assert "did you mean" not in str(caught.value)


def test_other_errors_are_left_alone() -> None:
    error = ValueError("x")
    advise_of_attribute(error)
    assert error.args == ("x",)
