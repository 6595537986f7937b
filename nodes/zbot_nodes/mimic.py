"""Let one turtle repeat the movements of another turtle.

Run:        zbot run turtlesim mimic --ros-args -r input/pose:=turtle1/pose \
                -r output/cmd_vel:=turtle2/cmd_vel
Subscribes: input/pose (turtlesim/msg/Pose)
Publishes:  output/cmd_vel (geometry_msgs/msg/Twist)
"""

import zbot

from geometry_msgs.msg import Twist
from turtlesim.msg import Pose


class MimicNode(zbot.Node):
    """Publishes the velocities of a pose as a command."""

    def __init__(self) -> None:
        super().__init__("turtle_mimic")
        self.twist_pub = self.create_publisher(Twist, "output/cmd_vel", 1)
        self.pose_sub = self.create_subscription(Pose, "input/pose", self.follow, 1)

    def follow(self, pose: Pose) -> None:
        """Repeat one movement."""
        twist = Twist()
        twist.linear.x = pose.linear_velocity
        twist.angular.z = pose.angular_velocity
        self.twist_pub.publish(twist)


def main() -> None:
    """Run until Ctrl-C."""
    with zbot.init():
        zbot.spin(MimicNode())


if __name__ == "__main__":
    main()
