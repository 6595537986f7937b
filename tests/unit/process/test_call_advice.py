"""Tests of what is said about a call or an operator that Python refuses."""

from __future__ import annotations

import asyncio
import sys
import time
from typing import TYPE_CHECKING, Any

import pytest

import zbot
from zbot.libraries.message_filter import TimeSynchronizer
from zbot.node.client import Client
from zbot.node.publisher import Publisher
from zbot.parameters.parameter import Parameter
from zbot.process.call_advice import advise_of_call
from zbot.tf2 import Buffer, StaticTransformBroadcaster, TransformBroadcaster
from zbot.time import Duration, Time

from std_msgs.msg import String

if TYPE_CHECKING:
    from collections.abc import Callable


class Robot(zbot.Node):
    def __init__(self, **options: Any) -> None:
        """Create no node, except with options."""
        if options:
            super().__init__(**options)


class NoNode:
    def __init__(self) -> None:
        """Call the base class with a name, as a node does."""
        super().__init__("robot")  # type: ignore[call-arg]

    def tick() -> None: ...  # type: ignore[misc]


robot: Any = Robot()
log: Any = zbot.get_logger("robot").info
broadcaster: Any = TransformBroadcaster.__new__(TransformBroadcaster)
client: Any = Client.__new__(Client)
make: Any = StaticTransformBroadcaster
module: Any = type(zbot)
spin: Any = zbot.spin_until_future_complete
publisher: Any = Publisher.__new__(Publisher)
base: Any = super
executor: Any = zbot.MultiThreadedExecutor
made_executor: Any = executor.__new__(executor)
five, now, parameter = (Duration(seconds=5), Time(), Parameter("speed", value=0.5))


@pytest.mark.parametrize(
    ("call", "advice"),
    [
        # arguments
        (lambda: robot.create_publisher(String, "chatter", queue_size=10), "qos_profile=10"),
        (lambda: robot.create_subscription(String, "a", print, qos=10), "qos_profile=10"),
        (lambda: robot.create_publisher(String, topic_name="a"), "topic='chatter'"),
        (lambda: robot.create_timer(period=0.5, callback=print), "timer_period_sec=0.5"),
        (lambda: Robot(name="robot"), "node_name='my_node'"),
        (lambda: log("speed", 5), "one text, e.g. info(f'speed: {self.speed}')"),
        (lambda: client.call_async(1, 2), "one request, e.g. call_async(AddTwoInts.Request("),
        (lambda: broadcaster.sendTransform((0, 0, 0), "map"), "sendTransform(transform), with one"),
        (make, "the node, e.g. StaticTransformBroadcaster(self)"),
        (lambda: robot.create_publisher(String, "a"), "the depth of the queue, e.g. 10"),
        (lambda: spin(zbot.Future()), "the node and the future: spin_until_future_complete(node, "),
        (lambda: zbot.spin_once(robot, 1.0), "spin_once(node, timeout_sec=1.0)"),  # type: ignore[arg-type,call-arg]
        (zbot.create_node, "the node's name, e.g. create_node('my_node')"),
        (publisher.publish, "the message, e.g. publish(message)"),
        (lambda: module("Robot", (), {}), "the class in the module, e.g. rclpy.node.Node"),
        (module("time"), "the class or function in the module, e.g. "),
        (lambda: base.__init__("robot"), "super().__init__(...), with parentheses after super"),
        (lambda: zbot.Node(robot, "robot"), "only the name, e.g. super().__init__('my_node') wit"),  # type: ignore[call-arg,arg-type]
        (lambda: robot.get_logger("robot"), "get_logger(), without arguments"),
        (lambda: robot.declare_parameters([]), "the namespace first, e.g. declare_parameters('',"),
        (lambda: Buffer.lookup_transform(robot, "map", "odom"), "the time, e.g. lookup_transform("),  # type: ignore[call-arg]
        (lambda: executor.add_node(robot), "executor = SingleThreadedExecutor(), with parentheses"),
        (executor.spin, "executor = SingleThreadedExecutor(), with parentheses, and executor.spin"),
        (lambda: made_executor.add_node(robot, robot), "one add_node(node) for each node"),
        (lambda: print(*robot), "a comma after a single argument, e.g. args=(node,)"),
        (NoNode, "the base class after the name of the class, e.g. class Robot(Node):"),
        (Robot.get_name, "parentheses after the class, e.g. Node(...).get_name()"),
        (lambda: NoNode.__new__(NoNode).tick(), "self as the first parameter: def tick(self):"),  # type: ignore[misc]
        (lambda: Duration(2), "Duration(seconds=1.5)"),  # type: ignore[call-arg]
        (lambda: Time(sec=2), "Time(seconds=1.5)"),  # type: ignore[call-arg]
        (lambda: time.sleep(five), "duration.nanoseconds / 1e9 for the seconds"),  # type: ignore[arg-type]
        (lambda: TimeSynchronizer(1, 2, 10), "the filters in a list: TimeSynchronizer([a, b], 10)"),  # type: ignore[arg-type,call-arg]
        (lambda: TimeSynchronizer([], 10, slop=0.1), "the filters in a list: Time"),  # type: ignore[call-arg]
        (lambda: range(parameter), "get_parameter('name').value"),  # type: ignore[call-overload]
        # operators
        (lambda: now - 5.0, "Duration(seconds=5.0) in place of a number"),  # type: ignore[operator]
        (lambda: five + 5, "Duration(seconds=5.0) in place of a number"),  # type: ignore[operator]
        (lambda: five / 2, "a product, e.g. duration * 0.5"),  # type: ignore[operator]
        (lambda: five / five, "a.nanoseconds / b.nanoseconds"),  # type: ignore[operator]
        (lambda: float(five), "duration.nanoseconds / 1e9 for the seconds"),  # type: ignore[arg-type]
        (lambda: five > 3, "duration.nanoseconds / 1e9 for the seconds"),  # type: ignore[operator]
        (lambda: now > 3, "time.nanoseconds / 1e9 for the seconds"),  # type: ignore[operator]
        (lambda: now - now.to_msg(), "Time.from_msg(message.header.stamp) for the time"),
        (lambda: 2 * parameter, "get_parameter('name').value"),  # type: ignore[operator]
    ],
)
def test_what_python_refuses_says_what_to_write(
    call: Callable[[], Any], advice: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, "rclpy", zbot)  # as in a program that imports rclpy
    assert f": write {advice}" in text_of(call)


@pytest.mark.parametrize(
    "call",
    [
        lambda: robot.create_publisher(String, "chatter", nonsense=10),
        lambda: now * 5,  # type: ignore[operator]
        lambda: Robot("robot", 5),  # type: ignore[call-arg]
        lambda: len(5),  # type: ignore[arg-type]
    ],
)
def test_other_texts_stay_as_they_are(call: Callable[[], Any]) -> None:
    assert ": write " not in text_of(call)


@pytest.mark.parametrize("name", ["_init_", "__int__", "__inti__", "__init"])
def test_a_misspelt_init_is_named(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    misspelt: Any = type("Misspelt", (zbot.Node,), {name: lambda _: None})
    monkeypatch.setitem(globals(), "Misspelt", misspelt)
    assert f"the class Misspelt has `{name}`: write `__init__`" in text_of(lambda: misspelt())  # noqa: PLW0108 - as a program


def test_asyncio_in_a_callback_is_told_of_timers() -> None:
    with pytest.raises(RuntimeError) as caught:
        asyncio.sleep(1).send(None)
    advise_of_call(caught.value)
    assert "write self.create_timer(1.0, self.tick) in place of asyncio" in str(caught.value)


def test_the_advice_names_the_library_that_the_program_uses(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.delitem(sys.modules, "rclpy", raising=False)
    assert text_of(lambda: zbot.spin()).endswith("e.g. zbot.spin(node)")  # type: ignore[call-arg]  # noqa: PLW0108 - as a program
    assert text_of(module("zbot.node")).endswith("e.g. zbot.Node")


def text_of(call: Callable[[], Any]) -> str:
    with pytest.raises(TypeError) as caught:
        call()
    advise_of_call(caught.value)
    return str(caught.value)
