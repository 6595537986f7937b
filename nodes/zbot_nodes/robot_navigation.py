"""Drive the simulated robot to goals, or from corner to corner of its room.

Run:        zbot run robot_navigation                (together with robot_base and robot_laser)
            zbot run robot_navigation --ros-args -p patrol:=true
Subscribes: goal_pose (geometry_msgs/PoseStamped), odom (nav_msgs/Odometry),
            scan (sensor_msgs/LaserScan); cmd_vel, to pause when another node drives
Publishes:  cmd_vel (geometry_msgs/Twist) while it drives, plan (nav_msgs/Path)
Try:        zbot topic pub --once /goal_pose "{pose: {position: {x: 2.0, y: -1.0}}}"
"""

import math
from collections import deque

import zbot
from zbot.qos import qos_profile_sensor_data
from zbot_nodes.robot.pose import Pose, pose_of, turn_to

from geometry_msgs.msg import PoseStamped, Twist
from nav_msgs.msg import Odometry, Path
from sensor_msgs.msg import LaserScan

PERIOD_S = 0.1
SPEED_M_S = 0.3
TURN_RAD_S = 1.0
ARRIVED_M = 0.1
TOO_NEAR_M = 0.35
PAUSE_S = 5.0
PATROL = ((3.0, -1.5), (3.0, 0.3), (0.5, 0.3), (0.5, 1.8), (-1.2, 1.2), (-1.2, -0.5), (0.5, -1.0))


class Navigation(zbot.Node):
    """Turns towards its goal, drives straight, and stops before an obstacle."""

    def __init__(self) -> None:
        super().__init__("navigation")
        self.patrol = self.declare_parameter("patrol", False).value
        self.next_stop = 0
        self.pose = Pose()
        self.goal: tuple[float, float] | None = None
        self.room_ahead_m = math.inf
        self.commands: deque[Twist] = deque(maxlen=20)
        self.paused_until = self.get_clock().now()
        self.cmd_publisher = self.create_publisher(Twist, "cmd_vel", 10)
        self.plan_publisher = self.create_publisher(Path, "plan", 10)
        self.create_subscription(PoseStamped, "goal_pose", self.accept, 10)
        self.create_subscription(Odometry, "odom", self.locate, 10)
        self.create_subscription(LaserScan, "scan", self.measure_room, qos_profile_sensor_data)
        self.create_subscription(Twist, "cmd_vel", self.pause, 10)
        self.timer = self.create_timer(PERIOD_S, self.drive)
        self.get_logger().info("Navigation ready: goals on /goal_pose")

    def accept(self, msg: PoseStamped) -> None:
        """Set a new goal."""
        self.goal = msg.pose.position.x, msg.pose.position.y
        self.patrol = False
        self.get_logger().info(f"New goal: ({self.goal[0]:.2f}, {self.goal[1]:.2f})")

    def locate(self, msg: Odometry) -> None:
        """Store the pose of the robot."""
        self.pose = pose_of(msg)

    def measure_room(self, msg: LaserScan) -> None:
        """Store the distance to the nearest obstacle ahead, up to 20 degrees to both sides."""
        self.room_ahead_m = min((*msg.ranges[:20], *msg.ranges[-20:]))

    def pause(self, msg: Twist) -> None:
        """Pause when a command of another node arrives."""
        if msg not in self.commands:
            self.paused_until = self.get_clock().now() + zbot.Duration(seconds=PAUSE_S)
            self.get_logger().info("Another node drives: pausing", throttle_duration_sec=5.0)

    def drive(self) -> None:
        """Drive one step towards the goal."""
        if self.get_clock().now() < self.paused_until:
            return
        if self.goal is None and self.patrol:
            self.goal = PATROL[self.next_stop]
            self.next_stop = (self.next_stop + 1) % len(PATROL)
        if self.goal is None:
            return
        self.publish_plan(self.goal)
        ahead_m = math.dist(self.goal, self.pose[:2])
        to_left = math.atan2(self.goal[1] - self.pose.y, self.goal[0] - self.pose.x)
        to_left = turn_to(to_left - self.pose.yaw)
        if ahead_m < ARRIVED_M:
            self.finish("Arrived")
        elif abs(to_left) > 0.3:
            self.command(0.0, math.copysign(TURN_RAD_S, to_left))
        elif self.room_ahead_m < min(TOO_NEAR_M, ahead_m):
            self.finish("Obstacle ahead: giving up")
        else:
            self.command(min(SPEED_M_S, ahead_m), 2 * to_left)

    def finish(self, text: str) -> None:
        """Stop, and drop the goal."""
        self.get_logger().info(f"{text} at ({self.pose.x:.2f}, {self.pose.y:.2f})")
        self.goal = None
        self.command(0.0, 0.0)

    def command(self, speed: float, turn: float) -> None:
        """Publish a velocity for the base."""
        msg = Twist()
        msg.linear.x, msg.angular.z = speed, turn
        self.commands.append(msg)
        self.cmd_publisher.publish(msg)

    def publish_plan(self, goal: tuple[float, float]) -> None:
        """Publish the path to the goal: a straight line."""
        plan = Path()
        plan.header.stamp = self.get_clock().now().to_msg()
        plan.header.frame_id = "odom"
        for x, y in (self.pose[:2], goal):
            point = PoseStamped(header=plan.header)
            point.pose.position.x, point.pose.position.y = x, y
            plan.poses.append(point)
        self.plan_publisher.publish(plan)


def main() -> None:
    """Run until Ctrl-C."""
    with zbot.init():
        zbot.spin(Navigation())


if __name__ == "__main__":
    main()
