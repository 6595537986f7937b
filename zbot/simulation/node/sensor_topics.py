"""Topics of sensors: messages from measurements."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from gazebo_msgs.msg import ContactsState, ContactState
from ros_gz_interfaces.msg import Contact, Contacts, Entity

from zbot.qos import qos_profile_sensor_data
from zbot.simulation.node.frames import WORLD_FRAME
from zbot.simulation.sensors.bumper import BumperSensor
from zbot.simulation.sensors.camera import CameraSensor
from zbot.simulation.sensors.cloud import CloudScanner
from zbot.simulation.sensors.imu import InertialSensor
from zbot.simulation.sensors.lidar import LidarScanner

from geometry_msgs.msg import Vector3
from sensor_msgs.msg import CameraInfo, Image, LaserScan, PointCloud2, PointField
from sensor_msgs.msg import Imu as ImuMessage

if TYPE_CHECKING:
    from zbot.node.node import Node
    from zbot.simulation.robots.equipment import (
        Bumper,
        Camera,
        CloudLidar,
        Imu,
        Lidar,
        Sensor,
    )
    from zbot.simulation.robots.robot import Robot
    from zbot.simulation.sensors.camera import Picture
    from zbot.simulation.world import World


class Mount(NamedTuple):
    """Robot that carries a sensor."""

    robot: Robot
    start: str  #: text before the names of its topics, e.g. `/robot1/`
    prefix: str  #: text before the names of its frames, e.g. `robot1/`
    number: int  #: number of the sensor


class SensorTopic:
    """Topics of one sensor. It measures only if somebody listens.

    Args:
        node: The node that publishes.
        sensor: What the robot's description says about the sensor.
        mount: The robot that carries it.
    """

    def __init__(self, node: Node, sensor: Sensor, mount: Mount) -> None:
        self.node = node
        self.frame = mount.prefix + (sensor.frame or sensor.link)
        self.topic = mount.start + sensor.topic.lstrip("/")
        self.publishers: list[Any] = []

    def add(self, type_: type[Any], topic: str) -> Any:
        """Create a publisher."""
        publisher = self.node.create_publisher(type_, topic, qos_profile_sensor_data)
        self.publishers.append(publisher)
        return publisher

    @property
    def is_heard(self) -> bool:
        """Whether one of the topics has a subscription."""
        return any(publisher.is_heard for publisher in self.publishers)

    def publish(self, world: World, stamp: Any) -> None:
        """Measure and publish."""
        raise NotImplementedError

    def release(self) -> None:
        """Destroy the publishers."""
        for publisher in self.publishers:
            self.node.destroy_publisher(publisher)

    def stamped(self, message: Any, stamp: Any) -> Any:
        """Return a message with the time and the frame in its header."""
        message.header.stamp, message.header.frame_id = stamp, self.frame
        return message


class LidarTopic(SensorTopic):
    """`sensor_msgs/LaserScan` of a lidar."""

    def __init__(self, node: Node, sensor: Lidar, mount: Mount) -> None:
        super().__init__(node, sensor, mount)
        self.lidar = LidarScanner(sensor, mount.robot, mount.number)
        self.scans = self.add(LaserScan, self.topic)

    def publish(self, world: World, stamp: Any) -> None:
        """Publish one turn."""
        spec = self.lidar.spec
        message = self.stamped(LaserScan(), stamp)
        message.angle_min, message.angle_max = spec.first_angle, spec.last_angle
        message.angle_increment = self.lidar.increment
        message.scan_time = 1 / spec.rate_hz
        message.range_min, message.range_max = spec.nearest, spec.farthest
        message.ranges = self.lidar.measure(world)
        self.scans.publish(message)


class CloudTopic(SensorTopic):
    """`sensor_msgs/PointCloud2` of a lidar with several rows of rays."""

    def __init__(self, node: Node, sensor: CloudLidar, mount: Mount) -> None:
        super().__init__(node, sensor, mount)
        self.lidar = CloudScanner(sensor, mount.robot, mount.number)
        self.clouds = self.add(PointCloud2, self.topic)

    def publish(self, world: World, stamp: Any) -> None:
        """Publish the points of one turn."""
        spec, points = self.lidar.spec, self.lidar.measure(world)
        message = self.stamped(PointCloud2(height=spec.rows, width=spec.rays), stamp)
        message.fields = _float_fields("x", "y", "z")
        message.point_step, message.row_step = 12, 12 * spec.rays
        message.is_dense = not np.isnan(points).any()
        message.data = points.tobytes()
        self.clouds.publish(message)


class ImuTopic(SensorTopic):
    """`sensor_msgs/Imu` of an inertial sensor."""

    def __init__(self, node: Node, sensor: Imu, mount: Mount) -> None:
        super().__init__(node, sensor, mount)
        self.imu = InertialSensor(sensor, mount.robot, mount.number)
        self.readings = self.add(ImuMessage, self.topic)

    def publish(self, world: World, stamp: Any) -> None:
        """Publish one measurement."""
        reading, spec = self.imu.measure(world), self.imu.spec
        message = self.stamped(ImuMessage(), stamp)
        turned = message.orientation
        turned.x, turned.y, turned.z, turned.w = reading.orientation
        for vector, values in (
            (message.angular_velocity, reading.turn),
            (message.linear_acceleration, reading.acceleration),
        ):
            vector.x, vector.y, vector.z = values.tolist()
        message.angular_velocity_covariance = _diagonal(spec.turn_noise**2)
        message.linear_acceleration_covariance = _diagonal(spec.noise**2)
        self.readings.publish(message)


class BumperTopic(SensorTopic):
    """`ros_gz_interfaces/Contacts` of a bumper."""

    def __init__(self, node: Node, sensor: Bumper, mount: Mount) -> None:
        super().__init__(node, sensor, mount)
        self.bumper, self.robot = BumperSensor(sensor, mount.robot), mount.robot
        self.touches = self.add(ContactsState if sensor.is_classic else Contacts, self.topic)

    def publish(self, world: World, stamp: Any) -> None:
        """Publish the present contacts, whose list may be empty."""
        if self.bumper.spec.is_classic:
            self.touches.publish(self._states(world, stamp))
            return
        message = self.stamped(Contacts(), stamp)
        message.header.frame_id = WORLD_FRAME
        own = self.robot.prefix + self.bumper.spec.link
        for touch in self.bumper.measure(world):
            contact = Contact(
                collision1=Entity(name=own, type=Entity.COLLISION),
                collision2=Entity(name=touch.other, type=Entity.COLLISION),
                positions=[_vector(touch.point)],
                normals=[_vector(touch.normal)],
                depths=[touch.depth],
            )
            message.contacts.append(contact)
        self.touches.publish(message)

    def _states(self, world: World, stamp: Any) -> Any:
        """Return the contacts in the message of Gazebo Classic."""
        message = self.stamped(ContactsState(), stamp)
        own = f"{self.robot.name}::{self.bumper.spec.link}"
        for touch in self.bumper.measure(world):
            state = ContactState(collision1_name=own, collision2_name=touch.other)
            state.contact_positions = [_vector(touch.point)]
            state.contact_normals = [_vector(touch.normal)]
            state.depths = [touch.depth]
            message.states.append(state)
        return message


class CameraTopic(SensorTopic):
    """`sensor_msgs/Image` and `sensor_msgs/CameraInfo` of a camera."""

    def __init__(self, node: Node, sensor: Camera, mount: Mount) -> None:
        super().__init__(node, sensor, mount)
        self.camera = CameraSensor(sensor, mount.robot, mount.number)
        name = self.topic
        color = sensor.color_topic or f"{name}/image_raw"
        depth = sensor.depth_topic or f"{name}/depth/image_raw"
        self.colors = self.add(Image, color) if sensor.has_color else None
        self.depths = self.add(Image, depth) if sensor.has_depth else None
        starts = [name] * sensor.has_color + [f"{name}/depth"] * sensor.has_depth
        infos = sensor.info_topics or [f"{start}/camera_info" for start in starts]
        self.infos = [self.add(CameraInfo, topic) for topic in infos]
        points = sensor.points_topic
        self.clouds = self.add(PointCloud2, points) if points else None

    def publish(self, world: World, stamp: Any) -> None:
        """Take a picture, and publish it."""
        picture = self.camera.measure(world)
        for publisher, encoding, pixels in (
            (self.colors, "rgb8", picture.color),
            (self.depths, "32FC1", picture.depth),
        ):
            if publisher is None or not publisher.is_heard:
                continue
            message = self.stamped(Image(encoding=encoding), stamp)
            message.height, message.width = pixels.shape[:2]
            message.step = pixels.strides[0]
            message.data = pixels.tobytes()
            publisher.publish(message)
        if self.clouds is not None and self.clouds.is_heard:
            self.clouds.publish(self.stamped(self.cloud(picture), stamp))
        info = self.stamped(self.info(), stamp)
        for publisher in self.infos:
            publisher.publish(info)

    def cloud(self, picture: Picture) -> Any:
        """Return the points of a picture. Each has a colour, as PCL packs it into a float."""
        height, width = picture.depth.shape
        red, green, blue = (picture.color[..., part].astype(np.uint32) for part in range(3))
        packed = (red << 16 | green << 8 | blue).view(np.float32)[..., None]
        message = PointCloud2(height=height, width=width)
        message.fields = _float_fields("x", "y", "z", "rgb")
        message.point_step, message.row_step = 16, 16 * width
        message.data = np.concatenate([self.camera.points(picture), packed], axis=2).tobytes()
        return message

    def info(self) -> Any:
        """Return the calibration of the camera, which has no distortion."""
        spec, focal = self.camera.spec, self.camera.focal_length
        middle_x, middle_y = (spec.width - 1) / 2, (spec.height - 1) / 2
        return CameraInfo(
            width=spec.width,
            height=spec.height,
            distortion_model="plumb_bob",
            d=[0.0] * 5,
            k=[focal, 0.0, middle_x, 0.0, focal, middle_y, 0.0, 0.0, 1.0],
            r=[1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0],
            p=[focal, 0.0, middle_x, 0.0, 0.0, focal, middle_y, 0.0, 0.0, 0.0, 1.0, 0.0],
        )


def _float_fields(*names: str) -> list[Any]:
    return [
        PointField(name=name, offset=4 * place, datatype=PointField.FLOAT32, count=1)
        for place, name in enumerate(names)
    ]


def _diagonal(variance: float) -> list[float]:
    return [variance, 0.0, 0.0, 0.0, variance, 0.0, 0.0, 0.0, variance]


def _vector(values: Any) -> Any:
    x, y, z = values
    return Vector3(x=x, y=y, z=z)
