"""Drive a robot with wheels that steer, and publish its odometry.

Types:      ackermann_steering_controller/AckermannSteeringController,
            bicycle_steering_controller/BicycleSteeringController,
            tricycle_steering_controller/TricycleSteeringController
Subscribes: ~/reference (geometry_msgs/TwistStamped), or ~/reference_unstamped (geometry_msgs/Twist)
            with use_stamped_vel false, as in ROS 2 Humble
Publishes:  ~/odometry (nav_msgs/Odometry), ~/tf_odometry (tf2_msgs/TFMessage),
            ~/controller_state (control_msgs/SteeringControllerStatus)
Serves:     ~/set_odometry (control_msgs/SetOdometry)
Parameters: see docs/robot-nodes.md
"""

from __future__ import annotations

import math
from typing import Any

from zbot_nodes.control.controller import ControllerError
from zbot_nodes.control.odometry import DEPTH, DrivingController

from control_msgs.msg import SteeringControllerStatus

_STRAIGHT_RAD = 1e-6
# Up to this difference to the wanted angle, the wheels have their full speed.
_FULL_SPEED_RAD = math.pi / 6
_SLOWEST_RAD = 1.5608  # from this difference on, the wheels have their lowest speed


class SteeringController(DrivingController):
    """Base class: angles and speeds of wheels for a velocity of the robot, and back.

    All computations have one wheel in the middle of each axle. `spread` and `gathered` convert
    between it and the wheels of the axle, which are on the right and on the left.
    """

    feedback_is_position = False
    odometry_topic, frame_topic = "~/odometry", "~/tf_odometry"
    counts = (1, 1)  #: number of driven wheels and of steered wheels
    radius_names: tuple[str, ...] = ("traction_wheels_radius",)

    def configure(self) -> None:
        """Read the parameters. Names of ROS 2 Jazzy and older are accepted too."""
        is_front = bool(self.setting("front_steering", True))
        rear, front = ("rear", "front") if is_front else ("front", "rear")
        self.driven = self.wheels("traction_joints", f"{rear}_wheels_names", self.counts[0])
        self.steered = self.wheels("steering_joints", f"{front}_wheels_names", self.counts[1])
        self.wheelbase = self.positive("wheelbase")
        names = (*self.radius_names, f"{rear}_wheels_radius", f"{rear}_wheel_radius")
        self.radius = self.first_positive(*names)
        self.track = self.steering_track = 0.0
        if self.counts[0] > 1:
            self.track = self.first_positive(
                "traction_track_width", f"{rear}_wheel_track", "wheel_track"
            )
            width = self.number("steering_track_width", 0.0)
            self.steering_track = width or self.number(f"{front}_wheel_track", 0.0) or self.track
        self.timeout_s = self.number("reference_timeout", 1.0)
        self.is_reducing = bool(self.setting("reduce_wheel_speed_until_steering_reached", False))
        self.create_command_subscription("~/reference")
        self.read_odometry()
        self.state_publisher = self.create_publisher(
            SteeringControllerStatus, "~/controller_state", DEPTH
        )

    def wheels(self, name: str, older: str, count: int) -> list[str]:
        """Return the joints of an axle.

        Raises:
            ControllerError: There are too few or too many joints.
        """
        found = self.setting(f"{name}_names", []) or self.setting(older, [])
        if len(found) != count:
            raise ControllerError(
                f"the parameter {name}_names of {self.get_name()} must have {count} joints"
                f"{', right and left' if count > 1 else ''}, not {len(found)}"
            )
        return [str(joint) for joint in found]

    def first_positive(self, *names: str) -> float:
        """Return the first of some parameters that is set. It must be above 0."""
        values = [self.number(name, 0.0) for name in names]
        return next((value for value in values if value > 0), 0.0) or self.positive(names[0])

    def command_interfaces(self) -> list[str]:
        """Return the angles of the steered wheels and the speeds of the driven wheels."""
        angles = [f"{joint}/position" for joint in self.steered]
        return [*angles, *(f"{joint}/velocity" for joint in self.driven)]

    def state_interfaces(self) -> list[str]:
        """Return the same, as they are measured."""
        if self.is_open_loop:
            return []
        return [*self.names("traction", self.feedback), *self.names("steering", "position")]

    def names(self, axle: str, kind: str) -> list[str]:
        """Return state interfaces of an axle. Their joints may have names of their own."""
        default = self.driven if axle == "traction" else self.steered
        joints = self.setting(f"{axle}_joints_state_names", []) or default
        return [f"{joint}/{kind}" for joint in joints]

    def activate(self) -> None:
        """Forget old commands, and begin to measure at the present angles of the wheels."""
        self.forget_commands()
        self.before = [] if self.is_open_loop else self.measured()[0]

    def deactivate(self) -> None:
        """Stop the wheels. The steered wheels keep their angles."""
        stopped = (f"{joint}/velocity" for joint in self.driven)
        self.hardware.commands.update(dict.fromkeys(stopped, 0.0))

    def measured(self) -> tuple[list[float], list[float]]:
        """Return angles or speeds of the driven wheels, and angles of the steered wheels."""
        states = self.hardware.states
        kinds = (("traction", self.feedback), ("steering", "position"))
        wheels, angles = ([states[name] for name in self.names(*kind)] for kind in kinds)
        return wheels, angles

    def update(self, period_s: float) -> None:
        """Drive for one period."""
        linear, angular = self.wanted()
        angle = _angle(linear, angular, self.wheelbase)
        steering = angle
        if self.is_open_loop:
            self.integrate(linear, angular, period_s)
        else:
            speed, steering = self.moved(period_s)
            self.integrate(speed, math.tan(steering) * speed / self.wheelbase, period_s)
        wheel = linear / self.radius * self.share(angle - steering)
        speeds = self.spread(wheel, steering)
        angles = self.turned(angle)
        commands = dict(zip(self.command_interfaces(), (*angles, *speeds), strict=True))
        self.hardware.commands.update(commands)
        stamp = self.get_clock().now().to_msg()
        self.publish(stamp)
        self.publish_state(stamp, speeds, angles)

    def share(self, missing: float) -> float:
        """Return the part of the full speed while the steered wheels are still turning."""
        if self.is_open_loop or not self.is_reducing or abs(missing) < _FULL_SPEED_RAD:
            return 1.0
        return math.cos(min(abs(missing), _SLOWEST_RAD)) / math.cos(_FULL_SPEED_RAD)

    def moved(self, period_s: float) -> tuple[float, float]:
        """Return the measured speed in m/s and the measured angle of steering in rad."""
        wheels, angles = self.measured()
        if self.feedback == "position":
            before, self.before = self.before, wheels
            wheels = [(now - then) / period_s for now, then in zip(wheels, before, strict=True)]
        steering = self.gathered_angle(angles)
        factors = self.spread(1.0, steering)
        speeds = [wheel / factor for wheel, factor in zip(wheels, factors, strict=True)]
        return self.radius * sum(speeds) / len(speeds), steering

    def spread(self, speed: float, angle: float) -> list[float]:
        """Return the speeds of the driven wheels. The outer wheel is faster in a curve."""
        if len(self.driven) == 1 or abs(angle) < _STRAIGHT_RAD:
            return [speed] * len(self.driven)
        curvature = math.tan(angle) / self.wheelbase
        half = curvature * self.track / 2
        return [speed * (1 + half), speed * (1 - half)]

    def turned(self, angle: float) -> list[float]:
        """Return the angles of the steered wheels. The inner wheel turns more in a curve."""
        if len(self.steered) == 1 or abs(angle) < _STRAIGHT_RAD:
            return [angle] * len(self.steered)
        across, along = self.wheelbase * math.sin(angle), self.wheelbase * math.cos(angle)
        shift = self.steering_track / 2 * math.sin(angle)
        return [math.atan2(across, along + shift), math.atan2(across, along - shift)]

    def gathered_angle(self, angles: list[float]) -> float:
        """Return the angle of a wheel in the middle of the axle, from the angles of the wheels."""
        if len(angles) == 1:
            return angles[0]
        found = []
        for angle, side in zip(angles, (-1, 1), strict=True):
            tangent = math.tan(angle)
            below = self.wheelbase + side * self.steering_track / 2 * tangent
            found.append(math.atan(self.wheelbase * tangent / below))
        return sum(found) / len(found)

    def publish_state(self, stamp: Any, speeds: list[float], angles: list[float]) -> None:
        """Publish the states and the commands of the wheels."""
        message = SteeringControllerStatus(traction_command=speeds, steering_angle_command=angles)
        message.header.stamp = stamp
        if not self.is_open_loop:
            wheels, message.steer_positions = self.measured()
            setattr(message, f"traction_wheels_{self.feedback}", wheels)
        self.state_publisher.publish(message)


def _angle(linear: float, angular: float, wheelbase: float) -> float:
    """Return the angle of steering for a velocity. A robot cannot turn on the spot."""
    if linear == 0:
        return math.copysign(math.pi / 2, angular) if angular else 0.0
    return math.atan(angular * wheelbase / linear)


class BicycleSteeringController(SteeringController):
    """One driven wheel, and one steered wheel."""

    kind = "bicycle_steering_controller/BicycleSteeringController"
    radius_names = ("traction_wheel_radius",)


class TricycleSteeringController(SteeringController):
    """Two driven wheels, and one steered wheel."""

    kind = "tricycle_steering_controller/TricycleSteeringController"
    counts = (2, 1)


class AckermannSteeringController(SteeringController):
    """Two driven wheels, and two steered wheels, as in a car."""

    kind = "ackermann_steering_controller/AckermannSteeringController"
    counts = (2, 2)
