"""Drive a simulated robot on two wheels, and publish its pose.

With the extra `sim`, the robot has mass, and its wheels push it. Without, it moves as commanded.

Run:        zbot run robot_base
Subscribes: cmd_vel (geometry_msgs/Twist); without a command for a second, the robot stops
Publishes:  odom (nav_msgs/Odometry), joint_states (sensor_msgs/JointState) and
            tf (tf2_msgs/TFMessage), each 50 times a second; tf_static (tf2_msgs/TFMessage), once
Try:        zbot topic pub --rate 5 /cmd_vel geometry_msgs/msg/Twist "{linear: {x: 0.3}}"
"""

import zbot
from zbot.qos import DurabilityPolicy, QoSProfile
from zbot_nodes.robot.motion import new_motion
from zbot_nodes.robot.pose import TRUTH, to_quaternion
from zbot_nodes.robot.state import PERIOD_S, State

from geometry_msgs.msg import Quaternion, TransformStamped, Twist, Vector3
from nav_msgs.msg import Odometry
from sensor_msgs.msg import JointState
from tf2_msgs.msg import TFMessage

COMMAND_LASTS_S = 1.0
MAX_SPEED_M_S = 1.0
MAX_TURN_RAD_S = 2.0
#: Positions of the sensors, in metres ahead of and above the robot's centre.
MOUNTS = {"laser": (0.0, 0.2), "imu_link": (0.0, 0.1), "camera_link": (0.15, 0.3)}
#: Frame of images in the frame of the camera: z is the direction of view, and y is down.
OPTICAL = Quaternion(x=-0.5, y=0.5, z=-0.5, w=0.5)


class Base(zbot.Node):
    """Moves as commanded, except through walls."""

    def __init__(self) -> None:
        super().__init__("base_controller")
        self.motion = new_motion()
        self.speed = 0.0
        self.turn = 0.0
        self.wheels = (0.0, 0.0)
        self.is_blocked = False
        self.last_command = self.get_clock().now()
        self.odom_publisher = self.create_publisher(Odometry, "odom", 10)
        self.truth_publisher = self.create_publisher(Odometry, TRUTH, 10)
        self.joint_publisher = self.create_publisher(JointState, "joint_states", 10)
        self.tf_publisher = self.create_publisher(TFMessage, "/tf", 100)
        latched = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
        self.mount_publisher = self.create_publisher(TFMessage, "/tf_static", latched)
        optical = self.transform("camera_link", "camera_optical_frame", Vector3(), OPTICAL)
        self.mount_publisher.publish(TFMessage(transforms=[*map(self.mount, MOUNTS), optical]))
        self.subscription = self.create_subscription(Twist, "cmd_vel", self.accept, 10)
        self.timer = self.create_timer(PERIOD_S, self.step)
        self.get_logger().info("Base ready: commands on /cmd_vel")

    def accept(self, msg: Twist) -> None:
        """Store the velocity of a command, limited to what the motors can do."""
        self.speed = max(-MAX_SPEED_M_S, min(MAX_SPEED_M_S, msg.linear.x))
        self.turn = max(-MAX_TURN_RAD_S, min(MAX_TURN_RAD_S, msg.angular.z))
        self.last_command = self.get_clock().now()

    def step(self) -> None:
        """Move for one period, and publish."""
        age = self.get_clock().now() - self.last_command
        if age.nanoseconds > COMMAND_LASTS_S * 1e9:
            self.speed = self.turn = 0.0
        state = self.motion.move(self.speed, self.turn)
        self.warn(state)
        self.publish_pose(state)
        self.publish_wheels(state)

    def warn(self, state: State) -> None:
        """Say once that something is in the way."""
        if state.is_blocked and not self.is_blocked:
            x, y, _ = state.pose
            self.get_logger().warn(f"Bump: something is in the way at ({x:.2f}, {y:.2f})")
        self.is_blocked = state.is_blocked

    def publish_pose(self, state: State) -> None:
        """Publish the pose, the speed and the transform."""
        odom = Odometry(child_frame_id="base_link")
        odom.header.stamp = self.get_clock().now().to_msg()
        odom.header.frame_id = "odom"
        odom.pose.pose.position.x, odom.pose.pose.position.y, yaw = state.pose
        odom.pose.pose.orientation = to_quaternion(yaw)
        odom.twist.twist.linear.x = state.speed
        odom.twist.twist.angular.z = state.turn
        self.odom_publisher.publish(odom)
        self.truth_publisher.publish(odom)
        at = Vector3(x=state.pose.x, y=state.pose.y)
        moved = self.transform("odom", "base_link", at, odom.pose.pose.orientation)
        self.tf_publisher.publish(TFMessage(transforms=[moved]))

    def publish_wheels(self, state: State) -> None:
        """Publish the angle and speed of each wheel."""
        msg = JointState(name=["wheel_left_joint", "wheel_right_joint"], position=state.wheels)
        msg.header.stamp = self.get_clock().now().to_msg()
        before, self.wheels = self.wheels, state.wheels
        pairs = zip(before, state.wheels, strict=True)
        msg.velocity = [(after - old) / PERIOD_S for old, after in pairs]
        self.joint_publisher.publish(msg)

    def mount(self, sensor: str) -> TransformStamped:
        """Return the transform of a sensor on the robot."""
        before, above = MOUNTS[sensor]
        return self.transform("base_link", sensor, Vector3(x=before, z=above), Quaternion())

    def transform(
        self, parent: str, child: str, at: Vector3, turned: Quaternion
    ) -> TransformStamped:
        """Return the transform of one frame in another, stamped with the present time."""
        msg = TransformStamped(child_frame_id=child)
        msg.header.stamp = self.get_clock().now().to_msg()
        msg.header.frame_id = parent
        msg.transform.translation = at
        msg.transform.rotation = turned
        return msg


def main() -> None:
    """Run until Ctrl-C."""
    with zbot.init():
        zbot.spin(Base())


if __name__ == "__main__":
    main()
