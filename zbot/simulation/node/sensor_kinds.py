"""Table of the topics of each kind of sensor."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from zbot.simulation.node.pose_topic import TruePoseTopic
from zbot.simulation.node.sensor_topics import (
    BumperTopic,
    CameraTopic,
    CloudTopic,
    ImuTopic,
    LidarTopic,
)
from zbot.simulation.node.value_topics import BatteryTopic, GpsTopic, SonarTopic
from zbot.simulation.robots.equipment import (
    Battery,
    Bumper,
    Camera,
    CloudLidar,
    Gps,
    Imu,
    Lidar,
    Sonar,
    TruePose,
)

if TYPE_CHECKING:
    from zbot.simulation.robots.equipment import Sensor

#: The topics of each kind of sensor.
KINDS: dict[type[Sensor], type[Any]] = {
    Lidar: LidarTopic,
    CloudLidar: CloudTopic,
    Imu: ImuTopic,
    Bumper: BumperTopic,
    Camera: CameraTopic,
    Sonar: SonarTopic,
    Gps: GpsTopic,
    Battery: BatteryTopic,
    TruePose: TruePoseTopic,
}
