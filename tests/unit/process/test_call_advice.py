"""Tests of what is said about a call or an operator that Python refuses."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import pytest

import zbot
from zbot.node.client import Client
from zbot.node.publisher import Publisher
from zbot.parameters.parameter import Parameter
from zbot.process.call_advice import advise_of_call
from zbot.tf2 import StaticTransformBroadcaster, TransformBroadcaster
from zbot.time import Duration, Time

from std_msgs.msg import String

if TYPE_CHECKING:
    from collections.abc import Callable


class Robot(zbot.Node):
    def __init__(self, **options: Any) -> None:
        """Create no node, except with options."""
        if options:
            super().__init__(**options)


robot: Any = Robot()
log: Any = zbot.get_logger("robot").info
broadcaster: Any = TransformBroadcaster.__new__(TransformBroadcaster)
client: Any = Client.__new__(Client)
make: Any = StaticTransformBroadcaster
module: Any = type(zbot)
spin: Any = zbot.spin_until_future_complete
publisher: Any = Publisher.__new__(Publisher)
base: Any = super
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
        (lambda: base.__init__("robot"), "super().__init__(...), with parentheses after super"),
        # operators
        (lambda: now - 5.0, "Duration(seconds=5.0) in place of a number"),  # type: ignore[operator]
        (lambda: five > 3, "duration.nanoseconds / 1e9 for the seconds"),  # type: ignore[operator]
        (lambda: now > 3, "time.nanoseconds / 1e9 for the seconds"),  # type: ignore[operator]
        (lambda: now - now.to_msg(), "Time.from_msg(message.header.stamp) for the time"),
        (lambda: 2 * parameter, "get_parameter('name').value"),  # type: ignore[operator]
    ],
)
def test_what_python_refuses_says_what_to_write(call: Callable[[], Any], advice: str) -> None:
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


def text_of(call: Callable[[], Any]) -> str:
    with pytest.raises(TypeError) as caught:
        call()
    advise_of_call(caught.value)
    return str(caught.value)
