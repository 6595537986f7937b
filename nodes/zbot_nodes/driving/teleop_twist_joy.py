"""Turn the axes of a gamepad into velocities, while an enable button is held.

Run:        zbot run teleop_twist_joy teleop_node
Subscribes: joy (sensor_msgs/Joy)
Publishes:  cmd_vel (geometry_msgs/Twist, or TwistStamped with publish_stamped_twist)
Parameters: require_enable_button (true), enable_button (5), enable_turbo_button (-1: none),
            axis_linear.x .y .z (5, -1, -1), axis_angular.yaw .pitch .roll (2, -1, -1),
            scale_linear.x .y .z (0.5, 0, 0), scale_linear_turbo.x .y .z (1, 0, 0),
            scale_angular.yaw .pitch .roll (0.5, 0, 0), scale_angular_turbo (1, 0, 0),
            inverted_reverse (false), publish_stamped_twist (false), frame ("teleop_twist_joy")
"""

from __future__ import annotations

from typing import Any

import zbot
from zbot_nodes.startup.program import run_node

from geometry_msgs.msg import Twist, TwistStamped
from sensor_msgs.msg import Joy

_LINEAR = {"x": "x", "y": "y", "z": "z"}
_ANGULAR = {"yaw": "z", "pitch": "y", "roll": "x"}
#: For each group of parameters: the names, and their default values.
_DEFAULTS: dict[str, tuple[tuple[str, ...], tuple[Any, ...]]] = {
    "axis_linear": (tuple(_LINEAR), (5, -1, -1)),
    "axis_angular": (tuple(_ANGULAR), (2, -1, -1)),
    "scale_linear": (tuple(_LINEAR), (0.5, 0.0, 0.0)),
    "scale_linear_turbo": (tuple(_LINEAR), (1.0, 0.0, 0.0)),
    "scale_angular": (tuple(_ANGULAR), (0.5, 0.0, 0.0)),
    "scale_angular_turbo": (tuple(_ANGULAR), (1.0, 0.0, 0.0)),
}


class TeleopTwistJoy(zbot.Node):
    """Publishes a velocity for each message of the gamepad while a button allows it.

    Args:
        options: The options of `zbot.Node`.
    """

    def __init__(self, **options: Any) -> None:
        super().__init__("teleop_twist_joy_node", **options)
        self.declare_parameter("require_enable_button", True)
        self.declare_parameter("enable_button", 5)
        self.declare_parameter("enable_turbo_button", -1)
        for group, (names, values) in _DEFAULTS.items():
            for name, value in zip(names, values, strict=True):
                self.declare_parameter(f"{group}.{name}", value)
        self.declare_parameter("inverted_reverse", False)
        self.declare_parameter("frame", "teleop_twist_joy")
        self.is_stamped = bool(self.declare_parameter("publish_stamped_twist", False).value)
        self.has_stopped = False
        kind: Any = TwistStamped if self.is_stamped else Twist
        self.publisher = self.create_publisher(kind, "cmd_vel", 10)
        self.create_subscription(Joy, "joy", self.accept, 10)
        self.tell_buttons()

    def setting(self, name: str) -> Any:
        """Return the present value of a parameter."""
        return self.get_parameter(name).value

    def tell_buttons(self) -> None:
        """Log which buttons and axes drive."""
        if self.setting("require_enable_button"):
            self.get_logger().info(f"Teleop enable button {self.setting('enable_button')}.")
        if self.setting("enable_turbo_button") >= 0:
            self.get_logger().info(f"Turbo on button {self.setting('enable_turbo_button')}.")
        for kind, names in (("linear", _LINEAR), ("angular", _ANGULAR)):
            for name in names:
                axis, scale = self.setting(f"axis_{kind}.{name}"), f"scale_{kind}.{name}"
                if axis != -1:
                    text = f"{kind.capitalize()} axis {name} on {axis} at scale"
                    self.get_logger().info(f"{text} {self.setting(scale):f}.")

    def accept(self, joy: Joy) -> None:
        """Publish the velocity of a message, or one zero velocity after a button is released."""
        if self.is_held(joy, "enable_turbo_button"):
            self.publish(self.velocity(joy, "_turbo"))
            self.has_stopped = False
        elif not self.setting("require_enable_button") or self.is_held(joy, "enable_button"):
            self.publish(self.velocity(joy, ""))
            self.has_stopped = False
        elif not self.has_stopped:
            self.publish(Twist())
            self.has_stopped = True

    def is_held(self, joy: Joy, parameter: str) -> bool:
        """Return whether the button of a parameter is pressed."""
        number = int(self.setting(parameter))
        return 0 <= number < len(joy.buttons) and bool(joy.buttons[number])

    def velocity(self, joy: Joy, speed: str) -> Twist:
        """Return the velocity, in m/s and rad/s, for `speed` "" or "_turbo"."""
        twist = Twist()
        for name, field in _LINEAR.items():
            setattr(twist.linear, field, self.scaled(joy, f"linear.{name}", speed))
        for name, field in _ANGULAR.items():
            setattr(twist.angular, field, self.scaled(joy, f"angular.{name}", speed))
        if self.setting("inverted_reverse") and twist.linear.x < 0:
            twist.angular.z = -twist.angular.z
        return twist

    def scaled(self, joy: Joy, name: str, speed: str) -> float:
        """Return an axis times its scale. A missing axis is 0."""
        axis = int(self.setting(f"axis_{name}"))
        if not 0 <= axis < len(joy.axes):
            return 0.0
        kind, _, part = name.partition(".")
        return float(joy.axes[axis]) * float(self.setting(f"scale_{kind}{speed}.{part}"))

    def publish(self, twist: Twist) -> None:
        """Publish a velocity, with time and frame if `publish_stamped_twist` is true."""
        if not self.is_stamped:
            self.publisher.publish(twist)
            return
        message = TwistStamped(twist=twist)
        message.header.stamp = self.get_clock().now().to_msg()
        message.header.frame_id = self.setting("frame")
        self.publisher.publish(message)


def main() -> None:
    """Run until Ctrl-C."""
    run_node(TeleopTwistJoy)


if __name__ == "__main__":
    main()
