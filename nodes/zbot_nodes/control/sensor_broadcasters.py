"""Publish the states of sensors of the hardware.

Types:      force_torque_sensor_broadcaster/ForceTorqueSensorBroadcaster: ~/wrench
            (geometry_msgs/WrenchStamped),
            imu_sensor_broadcaster/IMUSensorBroadcaster: ~/imu (sensor_msgs/Imu),
            range_sensor_broadcaster/RangeSensorBroadcaster: ~/range (sensor_msgs/Range)
Parameters: see docs/robot-nodes.md
"""

from __future__ import annotations

from typing import Any

from zbot_nodes.control.controller import Controller, ControllerError

from geometry_msgs.msg import WrenchStamped
from sensor_msgs.msg import Imu, Range

_DEPTH = 10
_COVARIANCE = 9


class SensorBroadcaster(Controller):
    """Base class: reads the parameters `sensor_name` and `frame_id`.

    Subclasses set `message` and `topic`, return their interfaces, and fill in a message.
    """

    message: Any
    topic = ""

    def configure(self) -> None:
        """Read the parameters, and create the topic."""
        self.frame = self.text("frame_id")
        self.read_settings()
        self.publisher = self.create_publisher(self.message, self.topic, _DEPTH)

    def text(self, name: str) -> str:
        """Return a parameter that must not be empty."""
        value = str(self.setting(name, ""))
        if not value:
            raise ControllerError(f"the parameter {name} of {self.get_name()} is empty")
        return value

    def read_settings(self) -> None:
        """Read the other parameters."""
        self.sensor = self.text("sensor_name")

    def value(self, name: str) -> float:
        """Return the state of an interface of the sensor."""
        return self.hardware.states[f"{self.sensor}/{name}"]

    def update(self, period_s: float) -> None:
        """Publish the present state."""
        del period_s
        message = self.message()
        message.header.stamp, message.header.frame_id = self.get_clock().now().to_msg(), self.frame
        self.fill(message)
        self.publisher.publish(message)

    def fill(self, message: Any) -> None:
        """Fill in a message."""
        raise NotImplementedError


class ForceTorqueSensorBroadcaster(SensorBroadcaster):
    """Publishes forces and torques."""

    kind = "force_torque_sensor_broadcaster/ForceTorqueSensorBroadcaster"
    message, topic = WrenchStamped, "~/wrench"

    def read_settings(self) -> None:
        """Read the interfaces, by `sensor_name` or each by its name, and their corrections."""
        sensor = str(self.setting("sensor_name", ""))
        self.axes: dict[tuple[str, str], tuple[str, float, float]] = {}
        for part in ("force", "torque"):
            for axis in "xyz":
                name = str(self.setting(f"interface_names.{part}.{axis}", ""))
                if sensor and name:
                    raise ControllerError(
                        f"{self.get_name()} needs either sensor_name or interface_names, not both"
                    )
                name = f"{sensor}/{part}.{axis}" if sensor else name
                if name:
                    factor = self.number(f"multiplier.{part}.{axis}", 1.0)
                    offset = self.number(f"offset.{part}.{axis}", 0.0)
                    self.axes[part, axis] = name, factor, offset
        if not self.axes:
            raise ControllerError(
                f"{self.get_name()} needs the parameter sensor_name or interface_names"
            )

    def state_interfaces(self) -> list[str]:
        """Return the forces and torques."""
        return [name for name, _, _ in self.axes.values()]

    def fill(self, message: WrenchStamped) -> None:
        """Fill in forces and torques. An axis that is not measured is NaN."""
        for part in ("force", "torque"):
            for axis in "xyz":
                name, factor, offset = self.axes.get((part, axis), ("", 1.0, 0.0))
                value = self.hardware.states.get(name, float("nan"))
                setattr(getattr(message.wrench, part), axis, (value + offset) * factor)


class IMUSensorBroadcaster(SensorBroadcaster):
    """Publishes orientation, angular velocity and acceleration."""

    kind = "imu_sensor_broadcaster/IMUSensorBroadcaster"
    message, topic = Imu, "~/imu"
    parts = (("orientation", "xyzw"), ("angular_velocity", "xyz"), ("linear_acceleration", "xyz"))

    def read_settings(self) -> None:
        """Read the name of the sensor, and the covariances."""
        super().read_settings()
        self.covariances = {part: self.covariance(part) for part, _ in self.parts}

    def covariance(self, part: str) -> list[float]:
        """Return a covariance matrix."""
        name = f"static_covariance_{part}"
        values = [float(number) for number in self.setting(name, [0.0] * _COVARIANCE)]
        if len(values) != _COVARIANCE:
            raise ControllerError(f"the parameter {name} of {self.get_name()} needs 9 numbers")
        return values

    def state_interfaces(self) -> list[str]:
        """Return the interfaces of the sensor."""
        return [f"{self.sensor}/{part}.{axis}" for part, axes in self.parts for axis in axes]

    def fill(self, message: Imu) -> None:
        """Fill in all values."""
        for part, axes in self.parts:
            for axis in axes:
                setattr(getattr(message, part), axis, self.value(f"{part}.{axis}"))
            setattr(message, f"{part}_covariance", self.covariances[part])


class RangeSensorBroadcaster(SensorBroadcaster):
    """Publishes a distance."""

    kind = "range_sensor_broadcaster/RangeSensorBroadcaster"
    message, topic = Range, "~/range"

    def read_settings(self) -> None:
        """Read the facts about the sensor."""
        super().read_settings()
        self.facts = {
            "field_of_view": self.number("field_of_view", 0.52),
            "min_range": self.number("min_range", 0.52),
            "max_range": self.number("max_range", 4.0),
            "variance": self.number("variance", 0.0),
        }
        self.radiation = int(self.number("radiation_type", 0))

    def state_interfaces(self) -> list[str]:
        """Return the distance."""
        return [f"{self.sensor}/range"]

    def fill(self, message: Range) -> None:
        """Fill in the distance and the facts."""
        message.range, message.radiation_type = self.value("range"), self.radiation
        for name, value in self.facts.items():
            setattr(message, name, value)
