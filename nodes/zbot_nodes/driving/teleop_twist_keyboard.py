"""Drive a robot with the keyboard.

Run:        zbot run teleop_twist_keyboard teleop_twist_keyboard
Publishes:  cmd_vel (geometry_msgs/Twist, or TwistStamped if `stamped` is true), for each key
Parameters: stamped (false), frame_id (""; of TwistStamped)
"""

from __future__ import annotations

import contextlib
from typing import Any

import zbot
from zbot.executor.spin_thread import SpinThread
from zbot.process.keys import pressed_keys
from zbot.process.signals import SignalHandlerOptions

from geometry_msgs.msg import Twist, TwistStamped

_HELP = """\
Keys that move the robot. With Shift, it moves sideways in place of turning:

    u  i  o        t  up
    j  k  l        b  down
    m  ,  .

q and z  change both speeds by 10 %
w and x  change only the speed
e and c  change only the turn

Each other key stops the robot. Ctrl-C stops it, and ends the program."""
#: Directions (forward, left, up, turn) by key. The second row of keys needs Shift.
_WAYS = {
    "i": (1, 0, 0, 0), ",": (-1, 0, 0, 0), "j": (0, 0, 0, 1), "l": (0, 0, 0, -1),
    "u": (1, 0, 0, 1), "o": (1, 0, 0, -1), "m": (-1, 0, 0, -1), ".": (-1, 0, 0, 1),
    "I": (1, 0, 0, 0), "<": (-1, 0, 0, 0), "J": (0, 1, 0, 0), "L": (0, -1, 0, 0),
    "U": (1, 1, 0, 0), "O": (1, -1, 0, 0), "M": (-1, 1, 0, 0), ">": (-1, -1, 0, 0),
    "t": (0, 0, 1, 0), "b": (0, 0, -1, 0),
}  # fmt: skip
_STOP = (0, 0, 0, 0)
#: Factors of the speed and of the turn, by key.
_FACTORS = {
    "q": (1.1, 1.1), "z": (0.9, 0.9), "w": (1.1, 1.0),
    "x": (0.9, 1.0), "e": (1.0, 1.1), "c": (1.0, 0.9),
}  # fmt: skip


class TeleopTwistKeyboard(zbot.Node):
    """Sends the robot a velocity for each key.

    Args:
        options: The options of `zbot.Node`.

    Attributes:
        speed: The velocity of a straight way in m/s.
        turn: The velocity of a turn in rad/s.
    """

    def __init__(self, **options: Any) -> None:
        super().__init__("teleop_twist_keyboard", **options)
        self.is_stamped = bool(self.declare_parameter("stamped", False).value)
        self.frame_id = str(self.declare_parameter("frame_id", "").value)
        kind = TwistStamped if self.is_stamped else Twist
        self.publisher = self.create_publisher(kind, "cmd_vel", 10)
        self.speed, self.turn, self.way = 0.5, 1.0, _STOP

    def read_keys(self) -> None:
        """Read keys until Ctrl-C, or the end of the input. Then stop the robot."""
        with contextlib.suppress(KeyboardInterrupt):
            for key in pressed_keys(self.context.ok):
                self.press(key)
        self.press("")

    def press(self, key: str) -> None:
        """Carry out the command of a key. A key without a command stops the robot."""
        if key in _FACTORS:
            speed, turn = _FACTORS[key]
            self.speed, self.turn = self.speed * speed, self.turn * turn
            print(self.speeds(), flush=True)
        else:
            self.way = _WAYS.get(key, _STOP)
        self.publish()

    def speeds(self) -> str:
        """Return the speeds as a line for the user."""
        return f"speed {self.speed:.3g} m/s, turn {self.turn:.3g} rad/s"

    def publish(self) -> None:
        """Send the velocity of the last direction."""
        forward, left, up, turn = self.way
        twist = Twist()
        twist.linear.x, twist.linear.y = forward * self.speed, left * self.speed
        twist.linear.z, twist.angular.z = up * self.speed, turn * self.turn
        if not self.is_stamped:
            self.publisher.publish(twist)
            return
        message = TwistStamped(twist=twist)
        message.header.stamp = self.get_clock().now().to_msg()
        message.header.frame_id = self.frame_id
        self.publisher.publish(message)


def main() -> None:
    """Drive the robot until Ctrl-C."""
    # zbot's handler of Ctrl-C would end the context before the robot is told to stop.
    with zbot.init(signal_handler_options=SignalHandlerOptions.NO):
        node = TeleopTwistKeyboard()
        print(f"{_HELP}\n\n{node.speeds()}", flush=True)
        with SpinThread(node, "parameters"):
            node.read_keys()


if __name__ == "__main__":
    main()
