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
from dataclasses import dataclass
from typing import Any

from zbot_nodes.control.controller import ControllerError
from zbot_nodes.control.odometry import DEPTH, DrivingController

from geometry_msgs.msg import TwistStamped


@dataclass(frozen=True)
class SpeedLimiter:
    """Limits in m/s, m/s² and m/s³, or in rad/s, rad/s² and rad/s³. NaN means no limit."""

    min_velocity: float = math.nan
    max_velocity: float = math.nan
    max_acceleration: float = math.nan
    max_deceleration: float = math.nan  #: negative
    max_acceleration_reverse: float = math.nan  #: negative
    max_deceleration_reverse: float = math.nan
    max_jerk: float = math.nan
    min_jerk: float = math.nan  #: negative

    def limited(self, speed: float, before: float, earlier: float, period_s: float) -> float:
        """Return the allowed speed.

        Args:
            speed: The wanted speed.
            before: The speed of the last period.
            earlier: The speed of the period before the last period.
            period_s: Length of a period.
        """
        change = before - earlier
        jerk_s2 = period_s * period_s
        low_jerk = self.min_jerk if not math.isnan(self.min_jerk) else -self.max_jerk
        wanted = _clamp(speed - before - change, low_jerk * jerk_s2, self.max_jerk * jerk_s2)
        low, high = self._accelerations(before)
        step = _clamp(wanted + change, low * period_s, high * period_s)
        slowest = self.min_velocity if not math.isnan(self.min_velocity) else -self.max_velocity
        return _clamp(before + step, slowest, self.max_velocity)

    def _accelerations(self, before: float) -> tuple[float, float]:
        """Return the lowest and the highest acceleration. Braking and driving differ."""
        forward = self.max_acceleration
        reverse = _or(self.max_acceleration_reverse, -forward)
        if before > 0:
            return _or(self.max_deceleration, -forward), forward
        if before < 0:
            return reverse, _or(self.max_deceleration_reverse, -_or(self.max_deceleration, reverse))
        return reverse, forward


def _or(value: float, otherwise: float) -> float:
    return otherwise if math.isnan(value) else value


def _clamp(value: float, low: float, high: float) -> float:
    value = value if math.isnan(high) else min(value, high)
    return value if math.isnan(low) else max(value, low)


class DiffDriveController(DrivingController):
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
        self.timeout_s = self.number("cmd_vel_timeout", 0.5)
        self.limiters = self.limiter("linear.x"), self.limiter("angular.z")
        self.create_command_subscription("~/cmd_vel")
        self.limited_publisher = None
        if self.setting("publish_limited_velocity", False):
            self.limited_publisher = self.create_publisher(TwistStamped, "~/cmd_vel_out", DEPTH)
        self.read_odometry()

    def frame_prefix(self) -> str:
        """Return the text before the names of frames. The default is the namespace."""
        prefix = super().frame_prefix()
        if not self.setting("tf_frame_prefix_enable", True):
            return ""
        return prefix or self.get_namespace()

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
                    name: math.nan if any(kind in name for kind in kinds) else value
                    for name, value in limits.items()
                }
        return SpeedLimiter(**limits)

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
        self.forget_commands()
        self.sent = [(0.0, 0.0), (0.0, 0.0)]
        self.angles = None if self.is_open_loop else self.measured()

    def deactivate(self) -> None:
        """Stop the wheels."""
        self.hardware.commands.update(dict.fromkeys(self.command_interfaces(), 0.0))

    def update(self, period_s: float) -> None:
        """Drive for one period."""
        wanted = self.wanted()
        last, earlier = self.sent[-1], self.sent[-2]
        linear, angular = (
            limiter.limited(wanted[axis], last[axis], earlier[axis], period_s)
            for axis, limiter in enumerate(self.limiters)
        )
        self.sent = [last, (linear, angular)]
        if period_s > 0:
            self.integrate(*self.driven(linear, angular, period_s), period_s)
            stamp = self.get_clock().now().to_msg()
            self.publish(stamp)
            self.publish_limited(stamp, linear, angular)
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
        sides = (
            [states[f"{wheel}/{self.feedback}"] for wheel in ws] for ws in (self.left, self.right)
        )
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

    def publish_limited(self, stamp: Any, linear: float, angular: float) -> None:
        """Publish the speeds after the limits, if `publish_limited_velocity` is true."""
        if self.limited_publisher is not None:
            limited = TwistStamped()
            limited.header.stamp = stamp
            limited.twist.linear.x, limited.twist.angular.z = linear, angular
            self.limited_publisher.publish(limited)
