"""Drive a turtle with the keyboard.

Run:        zbot run turtlesim turtle_teleop_key
Publishes:  turtle1/cmd_vel (geometry_msgs/msg/Twist), one message for each arrow key
Asks:       the action turtle1/rotate_absolute, for the letters around F
Parameters: scale_linear, scale_angular (2.0 each)
"""

from typing import Any

import zbot
from zbot.action import ActionClient
from zbot.executor.spin_thread import SpinThread
from zbot.process.keys import pressed_keys

from geometry_msgs.msg import Twist
from turtlesim.action import RotateAbsolute

_HELP = """\
Reading from keyboard
---------------------------
Use arrow keys to move the turtle.
Use G|B|V|C|D|E|R|T keys to rotate to absolute orientations. 'F' to cancel a rotation.
'Q' to quit."""
#: Velocities (forward, turn) of the arrow keys, by the last character that an arrow key sends.
_ARROWS = {"A": (1.0, 0.0), "B": (-1.0, 0.0), "C": (0.0, -1.0), "D": (0.0, 1.0)}
#: Headings in rad. On the keyboard, each key lies in the direction of its heading, seen from F.
_HEADINGS = {
    "g": 0.0,
    "t": 0.7854,
    "r": 1.5708,
    "e": 2.3562,
    "d": 3.1416,
    "c": -2.3562,
    "v": -1.5708,
    "b": -0.7854,
}


class TeleopTurtle(zbot.Node):
    """Sends the turtle a command for each key."""

    def __init__(self) -> None:
        super().__init__("teleop_turtle")
        self.declare_parameter("scale_angular", 2.0)
        self.declare_parameter("scale_linear", 2.0)
        self.twist_pub = self.create_publisher(Twist, "turtle1/cmd_vel", 1)
        self.rotate: ActionClient[Any, Any, Any] = ActionClient(
            self, RotateAbsolute, "turtle1/rotate_absolute"
        )
        self.goal: Any = None

    def press(self, key: str) -> None:
        """Carry out the command of a key. A key without a command is ignored."""
        if key in _ARROWS:
            forward, turn = _ARROWS[key]
            twist = Twist()
            twist.linear.x = forward * self.get_parameter("scale_linear").value
            twist.angular.z = turn * self.get_parameter("scale_angular").value
            self.twist_pub.publish(twist)
        elif key in _HEADINGS:
            self.turn_to(_HEADINGS[key])
        elif key == "f" and self.goal is not None:
            self.goal.cancel_goal_async()

    def turn_to(self, theta: float) -> None:
        """Send a goal to turn the turtle to a heading."""
        if not self.rotate.server_is_ready():
            self.get_logger().warning(
                "turtle1/rotate_absolute has no server: is turtlesim running?"
            )
            return
        accepted = self.rotate.send_goal_async(RotateAbsolute.Goal(theta=theta))
        accepted.add_done_callback(self.store_goal)

    def store_goal(self, accepted: Any) -> None:
        """Store the goal, so that F can cancel it."""
        if accepted.exception() is None:
            self.goal = accepted.result()


def main() -> None:
    """Read keys until Q or Ctrl-C."""
    with zbot.init():
        node = TeleopTurtle()
        print(_HELP, flush=True)
        with SpinThread(node, "responses"):
            for key in pressed_keys(zbot.ok):
                if key == "q":
                    break
                node.press(key)


if __name__ == "__main__":
    main()
