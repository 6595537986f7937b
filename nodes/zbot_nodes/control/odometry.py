"""Base class of controllers that drive a robot and publish its odometry."""

from __future__ import annotations

import math
from collections import deque
from typing import Any

from zbot.time import Time
from zbot_nodes.control.controller import Controller, ControllerError, State

from control_msgs.srv import SetOdometry
from geometry_msgs.msg import Quaternion, TransformStamped, Twist, TwistStamped
from nav_msgs.msg import Odometry
from tf2_msgs.msg import TFMessage

DEPTH = 10
_MINIMAL_TURN_RAD = 1e-6
_AXES = 6


class DrivingController(Controller):
    """Takes velocities of the robot, and publishes its pose and speed.

    Subclasses command the wheels, and call `integrate` and `publish` in `update`.
    """

    is_chainable = True
    feedback_is_position = True  #: the default of the parameter `position_feedback`
    odometry_topic, frame_topic = "~/odom", "/tf"
    timeout_s: float  #: how long a velocity is valid; 0 means without end

    def read_odometry(self) -> None:
        """Read the parameters about odometry, and create its topics and its service."""
        self.is_open_loop = bool(self.setting("open_loop", False))
        is_position = self.setting("position_feedback", self.feedback_is_position)
        self.feedback = "position" if is_position else "velocity"
        self.has_frame = bool(self.setting("enable_odom_tf", True))
        window = max(1, int(self.number("velocity_rolling_window_size", 10)))
        self.speeds: deque[tuple[float, float]] = deque(maxlen=window)
        self.read_frames()
        self.reset_odometry()
        self.odometry_publisher = self.create_publisher(Odometry, self.odometry_topic, DEPTH)
        self.frame_publisher = self.create_publisher(TFMessage, self.frame_topic, DEPTH)
        self.create_service(SetOdometry, "~/set_odometry", self.set_odometry)

    def create_command_subscription(self, topic: str) -> None:
        """Subscribe to velocities. The parameter `use_stamped_vel` is that of ROS 2 Humble."""
        twist: Any = Twist
        if self.setting("use_stamped_vel", True):
            self.create_subscription(TwistStamped, topic, self.accept, DEPTH)
        else:
            self.create_subscription(twist, f"{topic}_unstamped", self.accept_unstamped, DEPTH)

    def positive(self, name: str) -> float:
        """Return a parameter that must be above 0."""
        value = self.number(name, 0.0)
        if not value > 0:
            raise ControllerError(f"the parameter {name} of {self.get_name()} must be above 0")
        return value

    def read_frames(self) -> None:
        """Read the names of the frames, with their prefix, and the covariances."""
        prefix = self.frame_prefix().strip("/")
        prefix = f"{prefix}/" if prefix else ""
        self.odom_frame = prefix + str(self.setting("odom_frame_id", "odom"))
        self.base_frame = prefix + str(self.setting("base_frame_id", "base_link"))
        self.covariances = [
            self.diagonal(f"{part}_covariance_diagonal") for part in ("pose", "twist")
        ]

    def frame_prefix(self) -> str:
        """Return the text before the names of frames."""
        return str(self.setting("tf_frame_prefix", "")).replace("~", self.get_namespace())

    def diagonal(self, name: str) -> list[float]:
        """Return a covariance matrix. The parameter contains its diagonal."""
        values = self.setting(name, [0.0] * _AXES)
        if len(values) != _AXES:
            raise ControllerError(f"the parameter {name} of {self.get_name()} needs 6 numbers")
        matrix = [0.0] * (_AXES * _AXES)
        matrix[:: _AXES + 1] = [float(value) for value in values]
        return matrix

    def reset_odometry(self, x: float = 0.0, y: float = 0.0, heading: float = 0.0) -> None:
        """Set the pose, in metres and rad, and forget the speeds."""
        self.x, self.y, self.heading = x, y, heading
        self.speeds.clear()

    def accept(self, message: TwistStamped) -> None:
        """Use a velocity, unless its time stamp is too old."""
        now_ns = self.get_clock().now().nanoseconds
        stamp_ns = Time.from_msg(message.header.stamp).nanoseconds or now_ns
        age_s = (now_ns - stamp_ns) / 1e9
        if self.timeout_s and age_s >= self.timeout_s:
            self.get_logger().warn(
                f"Ignoring the received message because it is {age_s:.3f} s old: the allowed "
                f"timeout is {self.timeout_s:.3f} s",
                throttle_duration_sec=1.0,
            )
            return
        # The sender's clock may be ahead. A stamp in the future must not delay the stop of the
        # robot after the last command.
        self.take(message.twist, min(stamp_ns, now_ns))

    def accept_unstamped(self, message: Twist) -> None:
        """Use a velocity without a time stamp."""
        self.take(message, self.get_clock().now().nanoseconds)

    def take(self, twist: Twist, stamp_ns: int) -> None:
        """Store a velocity if the controller is active."""
        if self.state is not State.ACTIVE:
            self.get_logger().warn("Can't accept new commands. subscriber is inactive", once=True)
            return
        command = (twist.linear.x, twist.angular.z)
        if all(math.isfinite(value) for value in command):
            self.command, self.received_ns = command, stamp_ns

    def reference_interfaces(self) -> list[str]:
        """Return the speeds in m/s and rad/s, which another controller may command."""
        return [f"{self.get_name()}/{axis}/velocity" for axis in ("linear", "angular")]

    def wanted(self) -> tuple[float, float]:
        """Return the wanted velocity in m/s and rad/s. It is zero if the last one is too old."""
        if self.is_chained:
            speeds = [
                self.hardware.commands[interface] for interface in self.reference_interfaces()
            ]
            linear, angular = (speed if math.isfinite(speed) else 0.0 for speed in speeds)
            return linear, angular
        age_s = (self.get_clock().now().nanoseconds - self.received_ns) / 1e9
        return (0.0, 0.0) if self.timeout_s and age_s > self.timeout_s else self.command

    def forget_commands(self) -> None:
        """Stand still until the next velocity comes."""
        self.command, self.received_ns = (0.0, 0.0), 0

    def integrate(self, linear: float, angular: float, period_s: float) -> None:
        """Move the pose along an arc."""
        distance, turn = linear * period_s, angular * period_s
        before, self.heading = self.heading, self.heading + turn
        if abs(turn) < _MINIMAL_TURN_RAD:
            self.x += distance * math.cos(before + turn / 2)
            self.y += distance * math.sin(before + turn / 2)
        else:
            radius = distance / turn
            self.x += radius * (math.sin(self.heading) - math.sin(before))
            self.y -= radius * (math.cos(self.heading) - math.cos(before))
        self.speeds.append((linear, angular))

    def publish(self, stamp: Any) -> None:
        """Publish the pose and the mean of the last speeds."""
        turned = Quaternion(z=math.sin(self.heading / 2), w=math.cos(self.heading / 2))
        odometry = Odometry(child_frame_id=self.base_frame)
        odometry.header.stamp, odometry.header.frame_id = stamp, self.odom_frame
        odometry.pose.pose.position.x, odometry.pose.pose.position.y = self.x, self.y
        odometry.pose.pose.orientation = turned
        odometry.pose.covariance, odometry.twist.covariance = self.covariances
        count = len(self.speeds)
        odometry.twist.twist.linear.x = sum(linear for linear, _ in self.speeds) / count
        odometry.twist.twist.angular.z = sum(angular for _, angular in self.speeds) / count
        self.odometry_publisher.publish(odometry)
        if self.has_frame:
            frame = TransformStamped(header=odometry.header, child_frame_id=self.base_frame)
            frame.transform.translation.x, frame.transform.translation.y = self.x, self.y
            frame.transform.rotation = turned
            self.frame_publisher.publish(TFMessage(transforms=[frame]))

    def set_odometry(
        self, request: SetOdometry.Request, response: SetOdometry.Response
    ) -> SetOdometry.Response:
        """Continue from another pose."""
        response.success = self.state is State.ACTIVE
        response.message = "" if response.success else "Controller is not active"
        if response.success:
            self.reset_odometry(request.x, request.y, request.yaw)
        return response
