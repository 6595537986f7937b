"""Publish the axes and buttons of a gamepad. Without a gamepad, zbot's web page shows a stick.

Run:        zbot run joy joy_node
Publishes:  joy (sensor_msgs/Joy)
Subscribes: joy/set_feedback (sensor_msgs/JoyFeedback): rumble
Parameters: device_id (0), device_name (""), deadzone (0.05), autorepeat_rate (20.0 Hz),
            sticky_buttons (false), coalesce_interval_ms (1)
Needs:      pip install "zbot[gamepad]" for a gamepad, "zbot[web]" for the page's stick
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any
from urllib.parse import quote

import zbot
from zbot_nodes.driving import gamepad
from zbot_nodes.driving.gamepad import without_deadzone
from zbot_nodes.startup.page import shown
from zbot_nodes.startup.program import ParameterError, run_node

from sensor_msgs.msg import Joy, JoyFeedback

if TYPE_CHECKING:
    from contextlib import AbstractContextManager

    from zbot_nodes.driving.gamepad import Gamepad

_POLL_S = 0.01
_SEARCH_S = 1.0
_RUMBLE_S = 1.0
_MAX_RATE_HZ = 1000.0


class JoyNode(zbot.Node):
    """Reads a gamepad 100 times a second. Publishes each change, and repeats the last message.

    Args:
        options: The options of `zbot.Node`.
    """

    def __init__(self, **options: Any) -> None:
        super().__init__("joy_node", **options)
        self.declare_device()
        self.deadzone = self.limited("deadzone", 0.05, 1.0)
        rate_hz = self.limited("autorepeat_rate", 20.0, _MAX_RATE_HZ)
        self.repeat_ns = round(1e9 / rate_hz) if rate_hz else None
        self.is_sticky = bool(self.declare_parameter("sticky_buttons", False).value)
        self.publisher = self.create_publisher(Joy, "joy", 10)
        self.create_subscription(JoyFeedback, "joy/set_feedback", self.shake, 10)
        self.gamepad: Gamepad | None = None
        self.published: tuple[list[float], list[int]] = ([], [])
        self.pressed: list[int] = []
        self.published_ns = 0
        self.search()
        self.create_timer(_SEARCH_S, self.search)
        self.create_timer(_POLL_S, self.poll)

    def declare_device(self) -> None:
        """Declare the parameters that select the gamepad."""
        self.declare_parameter("device_id", 0)
        self.declare_parameter("device_name", "")
        self.declare_parameter("coalesce_interval_ms", 1)

    def device(self) -> tuple[int, str]:
        """Return the number and the name of the gamepad. The name may be empty."""
        number = self.get_parameter("device_id").value
        return int(number), str(self.get_parameter("device_name").value)

    def limited(self, name: str, default: float, highest: float) -> float:
        """Declare a parameter that must be from 0 to `highest`, and return its value."""
        value = float(self.declare_parameter(name, default).value)
        if not 0 <= value <= highest:
            raise ParameterError(f"the parameter {name} must be between 0.0 and {highest}")
        return value

    def search(self) -> None:
        """Open the gamepad if it is connected, and forget it if it was removed."""
        if self.gamepad is not None and self.gamepad.is_attached:
            return
        if self.gamepad is not None:
            self.get_logger().warn(f"The gamepad {self.gamepad.name} was removed")
        try:
            self.gamepad = gamepad.find_gamepad(*self.device())
        except ModuleNotFoundError:
            self.get_logger().warn(f"{gamepad.missing_text()}; {self.stick_hint()}", once=True)
            return
        if self.gamepad is None:
            self.get_logger().warn(f"No gamepad is connected; {self.stick_hint()}", once=True)
            return
        name = self.gamepad.name
        self.get_logger().info(f"Opened joystick: {name}.  deadzone: {self.deadzone:f}")

    def stick_hint(self) -> str:
        """Return a text that says how to show the stick of the web page."""
        return f"the page has a stick on the screen: zbot web, panel Drive, topic {self.topic()}"

    def topic(self) -> str:
        """Return the full name of the topic."""
        return self.publisher.topic_name

    def poll(self) -> None:
        """Publish if something has changed, or if it is time for a repetition."""
        if self.gamepad is None:
            return
        axes, buttons = self.gamepad.read()
        axes = [without_deadzone(axis, self.deadzone) for axis in axes]
        buttons = self.held(buttons)
        now = self.get_clock().now()
        age_ns = now.nanoseconds - self.published_ns
        is_due = self.repeat_ns is not None and age_ns >= self.repeat_ns
        if is_due or self.published != (axes, buttons):
            self.published, self.published_ns = (axes, buttons), now.nanoseconds
            message = Joy(axes=axes, buttons=buttons)
            message.header.stamp = now.to_msg()
            message.header.frame_id = "joy"
            self.publisher.publish(message)

    def held(self, buttons: list[int]) -> list[int]:
        """Return the buttons for the message. Each press switches a sticky button on or off."""
        before, self.pressed = self.pressed, buttons
        if not self.is_sticky:
            return buttons
        held = list(self.published[1]) or [0] * len(buttons)
        for number, button in enumerate(buttons):
            was_pressed = number < len(before) and before[number]
            if button and not was_pressed:
                held[number] = 1 - held[number]
        return held

    def shake(self, message: JoyFeedback) -> None:
        """Shake the gamepad for a second."""
        is_rumble = message.type == JoyFeedback.TYPE_RUMBLE and message.id == 0
        if self.gamepad is not None and is_rumble and 0 <= message.intensity <= 1:
            self.gamepad.rumble(message.intensity, _RUMBLE_S)


def stick_shown(node: zbot.Node) -> AbstractContextManager[object]:
    """Show the stick of the web page if there is no gamepad."""
    from contextlib import nullcontext  # noqa: PLC0415 - only here

    if not isinstance(node, JoyNode) or node.gamepad is not None:
        return nullcontext()
    query = f"topic={quote(node.topic())}&type=sensor_msgs/msg/Joy"
    return shown(node, f"/drive?{query}", "stick")


def main() -> None:
    """Run until Ctrl-C."""
    run_node(JoyNode, around=stick_shown)


if __name__ == "__main__":
    main()
