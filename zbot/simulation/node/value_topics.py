"""Topics of sensors that measure single values: sonars, satellite receivers and batteries."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

from zbot.simulation.node.sensor_topics import SensorTopic
from zbot.simulation.sensors.battery import BatteryMeter
from zbot.simulation.sensors.gps import GpsReceiver
from zbot.simulation.sensors.sonar import SonarSensor

from sensor_msgs.msg import BatteryState, NavSatFix, NavSatStatus, Range

if TYPE_CHECKING:
    from zbot.node.node import Node
    from zbot.simulation.node.sensor_topics import Mount
    from zbot.simulation.robots.equipment import Battery, Gps, Sonar
    from zbot.simulation.world import World


class SonarTopic(SensorTopic):
    """`sensor_msgs/Range` of a sonar."""

    def __init__(self, node: Node, sensor: Sonar, mount: Mount) -> None:
        super().__init__(node, sensor, mount)
        self.sonar = SonarSensor(sensor, mount.robot, mount.number)
        self.ranges = self.add(Range, self.topic)

    def publish(self, world: World, stamp: Any) -> None:
        """Publish one distance."""
        spec = self.sonar.spec
        message = self.stamped(Range(radiation_type=Range.ULTRASOUND), stamp)
        message.field_of_view = spec.field_of_view
        message.min_range, message.max_range = spec.nearest, spec.farthest
        message.range = self.sonar.measure(world)
        self.ranges.publish(message)


class GpsTopic(SensorTopic):
    """`sensor_msgs/NavSatFix` of a satellite receiver."""

    def __init__(self, node: Node, sensor: Gps, mount: Mount) -> None:
        super().__init__(node, sensor, mount)
        self.gps = GpsReceiver(sensor, mount.robot, mount.number)
        self.fixes = self.add(NavSatFix, self.topic)

    def publish(self, world: World, stamp: Any) -> None:
        """Publish the place."""
        spec, fix = self.gps.spec, self.gps.measure(world)
        message = self.stamped(NavSatFix(), stamp)
        message.status.status = NavSatStatus.STATUS_FIX
        message.status.service = NavSatStatus.SERVICE_GPS
        message.latitude, message.longitude, message.altitude = fix
        flat, high = spec.noise**2, spec.height_noise**2
        message.position_covariance = [flat, 0.0, 0.0, 0.0, flat, 0.0, 0.0, 0.0, high]
        message.position_covariance_type = NavSatFix.COVARIANCE_TYPE_DIAGONAL_KNOWN
        self.fixes.publish(message)


class BatteryTopic(SensorTopic):
    """`sensor_msgs/BatteryState` of a battery."""

    def __init__(self, node: Node, sensor: Battery, mount: Mount) -> None:
        super().__init__(node, sensor, mount)
        self.meter = BatteryMeter(sensor, mount.robot, mount.number)
        self.states = self.add(BatteryState, self.topic)

    @property
    def is_heard(self) -> bool:
        """Whether to measure. A battery is used up also if nobody listens."""
        return True

    def publish(self, world: World, stamp: Any) -> None:
        """Publish the charge."""
        spec, now = self.meter.spec, self.meter.measure(world)
        message = self.stamped(BatteryState(present=True), stamp)
        message.voltage, message.current, message.charge, message.percentage = now
        message.capacity = message.design_capacity = spec.capacity
        message.temperature = math.nan
        message.power_supply_status = BatteryState.POWER_SUPPLY_STATUS_DISCHARGING
        message.power_supply_health = BatteryState.POWER_SUPPLY_HEALTH_GOOD
        message.power_supply_technology = BatteryState.POWER_SUPPLY_TECHNOLOGY_LION
        self.states.publish(message)
