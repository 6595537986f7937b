"""Tests of commands on the buttons and axes of a gamepad."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import pytest

import zbot
from tests.conftest import wait_until
from zbot_nodes.driving.joy_teleop import JoyTeleop, JoyTeleopError

from geometry_msgs.msg import TwistStamped
from sensor_msgs.msg import Joy
from std_msgs.msg import String, UInt8MultiArray
from std_srvs.srv import SetBool

if TYPE_CHECKING:
    from tests.conftest import MakeContext
    from tests.nodes.conftest import Bench

DRIVE = {
    "drive.type": "topic",
    "drive.interface_type": "geometry_msgs/msg/TwistStamped",
    "drive.topic_name": "cmd_vel",
    "drive.deadman_buttons": [1],
    "drive.axis_mappings.twist-linear-x.axis": 0,
    "drive.axis_mappings.twist-linear-x.scale": 0.5,
    "drive.axis_mappings.twist-linear-x.offset": 0.25,
    "drive.axis_mappings.twist-angular-z.button": 0,
    "drive.axis_mappings.header-frame_id.value": "base",
}
HELLO = {
    "hello.type": "topic",
    "hello.interface_type": "std_msgs/msg/String",
    "hello.topic_name": "chatter",
    "hello.deadman_axes": [1],
    "hello.message_value.data.value": "hi",
}


def test_axes_become_fields_while_a_button_is_held(bench: Bench) -> None:
    bench.run(JoyTeleop, DRIVE)
    twists = bench.watch(TwistStamped, "/cmd_vel")
    joy = bench.publisher(Joy, "/joy")
    for held in (0, 1, 1):
        joy.publish(Joy(axes=[1.0, 0.0], buttons=[1, held]))
    assert wait_until(lambda: len(twists) == 2)
    twist = twists[0]
    assert (twist.twist.linear.x, twist.twist.angular.z) == (0.75, 1.0)
    assert (twist.header.frame_id, twist.header.stamp.sec > 0) == ("base", True)


def test_a_fixed_message_is_sent_once_for_each_press(bench: Bench) -> None:
    bench.run(JoyTeleop, HELLO)
    texts = bench.watch(String, "/chatter")
    joy = bench.publisher(Joy, "/joy")
    for axis in (1.0, 1.0, 0.5, -1.0, 1.0):
        joy.publish(Joy(axes=[0.0, axis]))
    assert wait_until(lambda: [text.data for text in texts] == ["hi", "hi"])


def test_several_values_fill_an_array(bench: Bench) -> None:
    mappings: dict[str, Any] = {
        f"bytes.axis_mappings.{field}.{key}": value
        for field, index in (("data", 0), ("data-", 2))
        for key, value in (("index", index), ("axis", 0), ("scale", 100), ("offset", 5))
    }
    start: dict[str, Any] = {
        key.replace("hello", "bytes"): value for key, value in HELLO.items() if "value" not in key
    }
    start |= {"bytes.interface_type": "std_msgs/msg/UInt8MultiArray", **mappings}
    bench.run(JoyTeleop, start)
    arrays = bench.watch(UInt8MultiArray, "/chatter")
    bench.publisher(Joy, "/joy").publish(Joy(axes=[0.5, 1.0]))
    assert wait_until(lambda: bool(arrays))
    assert list(arrays[0].data) == [55, 0, 55]


def test_a_press_calls_a_service_once(bench: Bench) -> None:
    calls: list[Any] = []

    def answer(request: SetBool.Request, response: SetBool.Response) -> SetBool.Response:
        calls.append(request.data)
        return response

    service = bench.watcher.create_service(SetBool, "/lamp", answer)
    settings = {
        "lamp.type": "service",
        "lamp.interface_type": "std_srvs/srv/SetBool",
        "lamp.service_name": "/lamp",
        "lamp.service_request.data": True,
        "lamp.buttons": [0, 9],  # the gamepad of this test has no button 9
    }
    node: Any = bench.run(JoyTeleop, settings)
    assert wait_until(node.commands[0].is_ready)
    joy = bench.publisher(Joy, "/joy")
    for pressed in (1, 1, 0):
        joy.publish(Joy(buttons=[pressed]))
    assert wait_until(lambda: calls == [True])
    assert service is not None


@pytest.mark.parametrize(
    ("change", "reason"),
    [
        ({"type": "x"}, "unknown type 'x' for command 'drive': use topic, service or action"),
        ({"deadman_buttons": None}, "No buttons, axes or negative_axes configured for command"),
        ({"deadman_buttons": 1}, r"drive.deadman_buttons must be a list, such as \[1\]"),
        ({"topic_name": None}, "the command 'drive' needs the parameter drive.topic_name"),
        ({"interface_type": "std_srvs/srv/Empty"}, "must look like PACKAGE/msg/NAME"),
        ({"message_value.header-frame_id.value": "x"}, "Only one of 'message_value' or"),
        (
            {"axis_mappings.twist-linear-x.scale": None},
            "Axis mapping for 'drive' must have a scale",
        ),
    ],
)
def test_a_command_that_cannot_be_used_is_named(
    make_context: MakeContext, change: dict[str, Any], reason: str
) -> None:
    settings = DRIVE | {f"drive.{name}": value for name, value in change.items()}
    overrides = [
        zbot.Parameter(name, value=value) for name, value in settings.items() if value is not None
    ]
    with pytest.raises(JoyTeleopError, match=reason):
        JoyTeleop(context=make_context(), parameter_overrides=overrides)


@pytest.mark.parametrize(
    ("field", "value", "reason"),
    [
        ("twist-turn-x", 1.0, "geometry_msgs/msg/TwistStamped has no field 'twist-turn-x'"),
        ("twist-linear-x", "fast", "the command 'drive': "),
    ],
)
def test_a_command_with_a_wrong_field_is_left_out(
    make_context: MakeContext, logged: list[Any], field: str, value: Any, reason: str
) -> None:
    settings = {**DRIVE, **HELLO, f"drive.axis_mappings.{field}.value": value}
    for name in ("axis", "scale", "offset"):
        del settings[f"drive.axis_mappings.twist-linear-x.{name}"]
    overrides = [zbot.Parameter(name, value=value) for name, value in settings.items()]
    node = JoyTeleop(context=make_context(), parameter_overrides=overrides)
    assert [command.name for command in node.commands] == ["hello"]
    assert any(reason in record.message and "left out" in record.message for record in logged)
