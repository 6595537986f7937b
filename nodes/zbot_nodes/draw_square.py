"""Let a turtle draw squares until Ctrl-C.

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
    """Present movement of the turtle."""

    FORWARD = "forward"
    STOP_FORWARD = "stop forward"
    TURN = "turn"
    STOP_TURN = "stop turn"


class DrawSquare(zbot.Node):
    """Drives ahead, stops, turns left, stops, and starts again."""

    def __init__(self) -> None:
        super().__init__("draw_square")
        self.twist_pub = self.create_publisher(Twist, "turtle1/cmd_vel", 1)
        self.pose_sub = self.create_subscription(Pose, "turtle1/pose", self.locate, 1)
        self.reset_client = self.create_client(Empty, "reset")
        self.state = State.FORWARD
        self.pose: Pose | None = None
        self.goal: tuple[float, float, float] | None = None
        self.poses_to_ignore = math.inf
        self.create_timer(0.016, self.step)
        self.reset_client.wait_for_service()
        self.reset_client.call_async(Empty.Request()).add_done_callback(self.accept_poses)

    def accept_poses(self, _reset: zbot.Future[Empty.Response]) -> None:
        """Use poses after the reset. One pose from before the reset may still arrive."""
        self.poses_to_ignore = 1

    def locate(self, pose: Pose) -> None:
        """Store the pose of the turtle."""
        if self.poses_to_ignore:
            self.poses_to_ignore -= 1
        else:
            self.pose = pose

    def step(self) -> None:
        """Check the goal and send the next command, 62 times a second."""
        pose = self.pose
        if pose is None:
            return
        if self.goal is None:
            self.set_goal(pose, ahead=_SIDE)
        elif self.state is State.FORWARD:
            self.move_or_stop(self.has_reached(pose), State.STOP_FORWARD, forward=1.0)
        elif self.state is State.TURN:
            self.move_or_stop(self.has_reached(pose), State.STOP_TURN, turn=0.4)
        elif self.has_stopped(pose):
            self.get_logger().info("Reached goal")
            if self.state is State.STOP_FORWARD:
                self.state = State.TURN
                self.set_goal(pose, turn=math.pi / 2)
            else:
                self.state = State.FORWARD
                self.set_goal(pose, ahead=_SIDE)
        else:
            self.command()

    def set_goal(self, pose: Pose, ahead: float = 0.0, turn: float = 0.0) -> None:
        """Set the next goal."""
        theta = math.remainder(pose.theta + turn, 2 * math.pi)
        x = pose.x + math.cos(pose.theta) * ahead
        y = pose.y + math.sin(pose.theta) * ahead
        self.goal = (x, y, theta)
        self.get_logger().info(f"New goal [{x:f} {y:f}, {theta:f}]")

    def has_reached(self, pose: Pose) -> bool:
        """Return whether the turtle is near enough to the goal."""
        if self.goal is None:
            return False
        x, y, theta = self.goal
        turned = abs(math.remainder(pose.theta - theta, 2 * math.pi))
        return abs(pose.x - x) < 0.1 and abs(pose.y - y) < 0.1 and turned < 0.01

    @staticmethod
    def has_stopped(pose: Pose) -> bool:
        """Return whether the turtle stands still."""
        return abs(pose.angular_velocity) < _STILL and abs(pose.linear_velocity) < _STILL

    def move_or_stop(
        self, is_there: bool, following: State, forward: float = 0.0, turn: float = 0.0
    ) -> None:
        """Keep moving, or begin to stop."""
        if is_there:
            self.state = following
            self.command()
        else:
            self.command(forward, turn)

    def command(self, forward: float = 0.0, turn: float = 0.0) -> None:
        """Publish a velocity for the turtle."""
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
