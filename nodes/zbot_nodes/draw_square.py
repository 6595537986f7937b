"""Let a turtle draw squares, for ever.

Run:        zbot run turtlesim draw_square
Subscribes: turtle1/pose (turtlesim/msg/Pose)
Publishes:  turtle1/cmd_vel (geometry_msgs/msg/Twist)
Asks:       reset (std_srvs/srv/Empty), once
"""

import math
from enum import Enum

import zbot

from geometry_msgs.msg import Twist
from std_srvs.srv import Empty
from turtlesim.msg import Pose

_SIDE = 2.0  # metres
_STILL = 0.0001


class State(Enum):
    """What the turtle does at present."""

    FORWARD = "forward"
    STOP_FORWARD = "stop forward"
    TURN = "turn"
    STOP_TURN = "stop turn"


class DrawSquare(zbot.Node):
    """Goes ahead, stops, turns left, stops, and again."""

    def __init__(self) -> None:
        super().__init__("draw_square")
        self.twist_pub = self.create_publisher(Twist, "turtle1/cmd_vel", 1)
        self.pose_sub = self.create_subscription(Pose, "turtle1/pose", self.look, 1)
        self.reset_client = self.create_client(Empty, "reset")
        self.state = State.FORWARD
        self.pose: Pose | None = None
        self.goal: tuple[float, float, float] | None = None
        self.poses_to_ignore = math.inf
        self.create_timer(0.016, self.step)
        self.reset_client.wait_for_service()
        self.reset_client.call_async(Empty.Request()).add_done_callback(self.begin)

    def begin(self, _reset: zbot.Future[Empty.Response]) -> None:
        """Look from now on; one pose from before the reset may still be on its way."""
        self.poses_to_ignore = 1

    def look(self, pose: Pose) -> None:
        """Remember where the turtle is."""
        if self.poses_to_ignore:
            self.poses_to_ignore -= 1
        else:
            self.pose = pose

    def step(self) -> None:
        """Do the next thing, 62 times a second."""
        pose = self.pose
        if pose is None:
            return
        if self.goal is None:
            self.aim(pose, ahead=_SIDE)
        elif self.state is State.FORWARD:
            self.go_on(self.has_reached(pose), State.STOP_FORWARD, forward=1.0)
        elif self.state is State.TURN:
            self.go_on(self.has_reached(pose), State.STOP_TURN, turn=0.4)
        elif self.has_stopped(pose):
            self.get_logger().info("Reached goal")
            if self.state is State.STOP_FORWARD:
                self.state = State.TURN
                self.aim(pose, turn=math.pi / 2)
            else:
                self.state = State.FORWARD
                self.aim(pose, ahead=_SIDE)
        else:
            self.command()

    def aim(self, pose: Pose, ahead: float = 0.0, turn: float = 0.0) -> None:
        """Set the next goal."""
        theta = math.remainder(pose.theta + turn, 2 * math.pi)
        x = pose.x + math.cos(pose.theta) * ahead
        y = pose.y + math.sin(pose.theta) * ahead
        self.goal = (x, y, theta)
        self.get_logger().info(f"New goal [{x:f} {y:f}, {theta:f}]")

    def has_reached(self, pose: Pose) -> bool:
        """Return whether the goal is near enough."""
        if self.goal is None:
            return False
        x, y, theta = self.goal
        turned = abs(math.remainder(pose.theta - theta, 2 * math.pi))
        return abs(pose.x - x) < 0.1 and abs(pose.y - y) < 0.1 and turned < 0.01

    @staticmethod
    def has_stopped(pose: Pose) -> bool:
        """Return whether the turtle stands still."""
        return abs(pose.angular_velocity) < _STILL and abs(pose.linear_velocity) < _STILL

    def go_on(
        self, is_there: bool, following: State, forward: float = 0.0, turn: float = 0.0
    ) -> None:
        """Move, or begin to stop."""
        if is_there:
            self.state = following
            self.command()
        else:
            self.command(forward, turn)

    def command(self, forward: float = 0.0, turn: float = 0.0) -> None:
        """Give the turtle a velocity."""
        twist = Twist()
        twist.linear.x = forward
        twist.angular.z = turn
        self.twist_pub.publish(twist)


def main() -> None:
    """Run until Ctrl-C."""
    with zbot.init():
        zbot.spin(DrawSquare())


if __name__ == "__main__":
    main()
