"""Drive a robot with two sides of wheels, and publish its odometry.

Type:       diff_drive_controller/DiffDriveController
Subscribes: ~/cmd_vel (geometry_msgs/TwistStamped), or ~/cmd_vel_unstamped (geometry_msgs/Twist)
            with use_stamped_vel false, as in ROS 2 Humble
Publishes:  ~/odom (nav_msgs/Odometry), /tf (tf2_msgs/TFMessage),
            ~/cmd_vel_out (geometry_msgs/TwistStamped) with publish_limited_velocity
Serves:     ~/set_odometry (control_msgs/SetOdometry)
Parameters: see docs/robot-nodes.md
"""

from __future__ import annotations

import math
from collections import deque
from typing import Any

from zbot.time import Time
from zbot_nodes.control.controller import Controller, ControllerError, State
from zbot_nodes.control.speed_limiter import SpeedLimiter

from control_msgs.srv import SetOdometry
from geometry_msgs.msg import Quaternion, TransformStamped, Twist, TwistStamped
from nav_msgs.msg import Odometry
from tf2_msgs.msg import TFMessage

_DEPTH = 10
_MINIMAL_TURN_RAD = 1e-6
_AXES = 6


class DiffDriveController(Controller):
    """Computes wheel speeds from velocities, and the robot's pose from wheel angles."""

    kind = "diff_drive_controller/DiffDriveController"

    def configure(self) -> None:
        """Read the parameters."""
        self.left, self.right = self.joints("left_wheel_names"), self.joints("right_wheel_names")
        if len(self.left) != len(self.right):
            raise ControllerError(
                f"{self.get_name()} has {len(self.left)} left and {len(self.right)} right wheels"
            )
        self.separation = self.positive("wheel_separation") * self.number(
            "wheel_separation_multiplier", 1.0
        )
        radius = self.positive("wheel_radius")
        self.left_radius = radius * self.number("left_wheel_radius_multiplier", 1.0)
        self.right_radius = radius * self.number("right_wheel_radius_multiplier", 1.0)
        self.is_open_loop = bool(self.setting("open_loop", False))
        self.feedback = "position" if self.setting("position_feedback", True) else "velocity"
        self.has_frame = bool(self.setting("enable_odom_tf", True))
        self.timeout_s = self.number("cmd_vel_timeout", 0.5)
        self.limiters = self.limiter("linear.x"), self.limiter("angular.z")
        window = max(1, int(self.number("velocity_rolling_window_size", 10)))
        self.speeds: deque[tuple[float, float]] = deque(maxlen=window)
        self.read_frames()
        self.reset_odometry()
        self.create_ports()

    def positive(self, name: str) -> float:
        """Return a parameter that must be above 0."""
        value = self.number(name, 0.0)
        if not value > 0:
            raise ControllerError(f"the parameter {name} of {self.get_name()} must be above 0")
        return value

    def limiter(self, axis: str) -> SpeedLimiter:
        """Return the limits of a direction. The older `has_..._limits: false` switches them off."""
        limits = {}
        for name in SpeedLimiter.__dataclass_fields__:
            limits[name] = self.number(f"{axis}.{name}", math.nan)
        lowest = self.number(f"{axis}.min_acceleration", math.nan)  # the name of ROS 2 Humble
        if math.isnan(limits["max_deceleration"]):
            limits["max_deceleration"] = lowest
        for group in ("velocity", "acceleration", "jerk"):
            if not self.setting(f"{axis}.has_{group}_limits", True):
                kinds = (group, "deceleration") if group == "acceleration" else (group,)
                limits = {
                    name: math.nan if any(one in name for one in kinds) else value
                    for name, value in limits.items()
                }
        return SpeedLimiter(**limits)

    def read_frames(self) -> None:
        """Read the names of the frames, with their prefix, and the covariances."""
        prefix = str(self.setting("tf_frame_prefix", "")).replace("~", self.get_namespace())
        if not self.setting("tf_frame_prefix_enable", True):
            prefix = ""
        elif not prefix:
            prefix = self.get_namespace()
        prefix = prefix.strip("/")
        prefix = f"{prefix}/" if prefix else ""
        self.odom_frame = prefix + str(self.setting("odom_frame_id", "odom"))
        self.base_frame = prefix + str(self.setting("base_frame_id", "base_link"))
        self.covariances = [
            self.diagonal(f"{one}_covariance_diagonal") for one in ("pose", "twist")
        ]

    def diagonal(self, name: str) -> list[float]:
        """Return a covariance matrix. The parameter contains its diagonal."""
        values = self.setting(name, [0.0] * _AXES)
        if len(values) != _AXES:
            raise ControllerError(f"the parameter {name} of {self.get_name()} needs 6 numbers")
        matrix = [0.0] * (_AXES * _AXES)
        matrix[:: _AXES + 1] = [float(one) for one in values]
        return matrix

    def create_ports(self) -> None:
        """Create publishers, subscriptions and the service."""
        twist: Any = Twist
        if self.setting("use_stamped_vel", True):
            self.create_subscription(TwistStamped, "~/cmd_vel", self.accept, _DEPTH)
        else:
            self.create_subscription(twist, "~/cmd_vel_unstamped", self.accept_unstamped, _DEPTH)
        self.limited_publisher = None
        if self.setting("publish_limited_velocity", False):
            self.limited_publisher = self.create_publisher(TwistStamped, "~/cmd_vel_out", _DEPTH)
        self.odometry_publisher = self.create_publisher(Odometry, "~/odom", _DEPTH)
        self.frame_publisher = self.create_publisher(TFMessage, "/tf", _DEPTH)
        self.create_service(SetOdometry, "~/set_odometry", self.set_odometry)

    def reset_odometry(self, x: float = 0.0, y: float = 0.0, heading: float = 0.0) -> None:
        """Set the pose, in metres and rad, and forget the speeds."""
        self.x, self.y, self.heading = x, y, heading
        self.speeds.clear()

    def command_interfaces(self) -> list[str]:
        """Return the speeds of all wheels."""
        return [f"{wheel}/velocity" for wheel in (*self.left, *self.right)]

    def state_interfaces(self) -> list[str]:
        """Return the angles or speeds of all wheels."""
        if self.is_open_loop:
            return []
        return [f"{wheel}/{self.feedback}" for wheel in (*self.left, *self.right)]

    def activate(self) -> None:
        """Forget old commands, and begin to measure at the present angles of the wheels."""
        self.command, self.received_ns = (0.0, 0.0), 0
        self.sent = [(0.0, 0.0), (0.0, 0.0)]
        self.angles = None if self.is_open_loop else self.measured()

    def deactivate(self) -> None:
        """Stop the wheels."""
        self.hardware.commands.update(dict.fromkeys(self.command_interfaces(), 0.0))

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
        if all(math.isfinite(one) for one in command):
            self.command, self.received_ns = command, stamp_ns

    def update(self, period_s: float) -> None:
        """Drive for one period."""
        now = self.get_clock().now()
        age_s = (now.nanoseconds - self.received_ns) / 1e9
        wanted = (0.0, 0.0) if self.timeout_s and age_s > self.timeout_s else self.command
        last, earlier = self.sent[-1], self.sent[-2]
        linear, angular = (
            one.limited(wanted[axis], last[axis], earlier[axis], period_s)
            for axis, one in enumerate(self.limiters)
        )
        self.sent = [last, (linear, angular)]
        if period_s > 0:
            self.integrate(*self.driven(linear, angular, period_s), period_s)
            self.publish(now.to_msg(), linear, angular)
        self.turn_wheels(linear, angular)

    def turn_wheels(self, linear: float, angular: float) -> None:
        """Command the speeds of the wheels, in rad/s."""
        half = angular * self.separation / 2
        for wheels, speed, radius in (
            (self.left, linear - half, self.left_radius),
            (self.right, linear + half, self.right_radius),
        ):
            names = (f"{wheel}/velocity" for wheel in wheels)
            self.hardware.commands.update(dict.fromkeys(names, speed / radius))

    def measured(self) -> tuple[float, float]:
        """Return the mean angle or speed of each side."""
        states = self.hardware.states
        sides = ([states[f"{one}/{self.feedback}"] for one in ws] for ws in (self.left, self.right))
        left, right = (sum(side) / len(side) for side in sides)
        return left, right

    def driven(self, linear: float, angular: float, period_s: float) -> tuple[float, float]:
        """Return the measured speed of the robot, or the commanded speed if `open_loop` is true.

        The speeds are in m/s and rad/s.
        """
        if self.angles is None:
            return linear, angular
        left, right = self.measured()
        if self.feedback == "position":
            before, self.angles = self.angles, (left, right)
            left, right = (left - before[0]) / period_s, (right - before[1]) / period_s
        left, right = left * self.left_radius, right * self.right_radius
        return (left + right) / 2, (right - left) / self.separation

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

    def publish(self, stamp: Any, linear: float, angular: float) -> None:
        """Publish the pose and the mean of the last speeds."""
        turned = Quaternion(z=math.sin(self.heading / 2), w=math.cos(self.heading / 2))
        odometry = Odometry(child_frame_id=self.base_frame)
        odometry.header.stamp, odometry.header.frame_id = stamp, self.odom_frame
        odometry.pose.pose.position.x, odometry.pose.pose.position.y = self.x, self.y
        odometry.pose.pose.orientation = turned
        odometry.pose.covariance, odometry.twist.covariance = self.covariances
        count = len(self.speeds)
        odometry.twist.twist.linear.x = sum(one for one, _ in self.speeds) / count
        odometry.twist.twist.angular.z = sum(one for _, one in self.speeds) / count
        self.odometry_publisher.publish(odometry)
        if self.has_frame:
            frame = TransformStamped(header=odometry.header, child_frame_id=self.base_frame)
            frame.transform.translation.x, frame.transform.translation.y = self.x, self.y
            frame.transform.rotation = turned
            self.frame_publisher.publish(TFMessage(transforms=[frame]))
        if self.limited_publisher is not None:
            limited = TwistStamped()
            limited.header.stamp = stamp
            limited.twist.linear.x, limited.twist.angular.z = linear, angular
            self.limited_publisher.publish(limited)

    def set_odometry(
        self, request: SetOdometry.Request, response: SetOdometry.Response
    ) -> SetOdometry.Response:
        """Continue from another pose."""
        response.success = self.state is State.ACTIVE
        response.message = "" if response.success else "Controller is not active"
        if response.success:
            self.reset_odometry(request.x, request.y, request.yaw)
        return response
