"""Reader of the `<sensor>` tags of Gazebo, of both generations."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import TYPE_CHECKING, Any, NamedTuple

from zbot.simulation.gazebo.tags import is_classic, number, word
from zbot.simulation.robots.equipment import Bumper, Camera, CloudLidar, Imu, Lidar, Sensor
from zbot.simulation.robots.value_sensors import VALUE_SENSORS, with_rows
from zbot.simulation.sdf.values import pose_of
from zbot.tf2.rigid import Rigid

if TYPE_CHECKING:
    from collections.abc import Callable
    from xml.etree.ElementTree import Element

    from zbot.simulation.gazebo.names import Names

_MAX_RATE_HZ = 200.0
_MAX_RAYS, _MAX_PIXELS, _MAX_SIDE = 20_000, 400_000, 100_000
#: Robots for Gazebo often have cameras that would need a graphics card.
_MAX_GAZEBO_PIXELS, _MAX_GAZEBO_RATE_HZ = 320 * 240, 10.0


class Mounted(NamedTuple):
    """Sensor element on a link."""

    link: str
    element: Element

    @property
    def name(self) -> str:
        """The name of the sensor."""
        return self.element.get("name", "")

    @property
    def pose(self) -> Rigid:
        """The pose of the sensor in its link."""
        return pose_of(self.element)

    @property
    def mount(self) -> str:
        """The frame in which the sensor measures: its link, or a frame of its own."""
        return self.link if self.pose == Rigid() else f"{self.link}/{self.name}"


def read_sensor(mounted: Mounted, names: Names) -> list[Sensor] | str:
    """Return a sensor, or why it is left out.

    Raises:
        DescriptionError: A value is not valid.
    """
    kind = mounted.element.get("type", "")
    value_kind = VALUE_SENSORS.get(kind)
    if value_kind is not None:
        common = _common(mounted, names, value_kind.topic, value_kind.rate_hz)
        return [value_kind.read(mounted.element, common)]
    if kind in _LIDARS:
        return _lidars(mounted, names)
    read = _SENSORS.get(kind)
    return f"a sensor of the type '{kind[:40]}'" if read is None else [read(mounted, names)]


def _lidars(mounted: Mounted, names: Names) -> list[Sensor]:
    """Return a lidar, or what a plugin of Gazebo makes of it: points, or one distance."""
    element, lidar = mounted.element, _lidar(mounted, names)
    if not names.model:
        return [with_rows(lidar, element)]
    if not is_classic(element):
        return [lidar, _cloud(replace(lidar, topic=f"{lidar.topic}/points"), element)]
    output = word(element, "sensor_msgs/PointCloud2", "output_type")
    if output.endswith("PointCloud2"):
        return [_cloud(lidar, element)]
    if output.endswith("Range"):
        common = _common(mounted, names, "sonar", lidar.rate_hz)
        return [VALUE_SENSORS["sonar"].read(element, common)]
    return [lidar]


def _cloud(lidar: Lidar, element: Element) -> Sensor:
    found = with_rows(lidar, element)
    if isinstance(found, CloudLidar):
        return found
    return CloudLidar(**vars(lidar), rows=1, lowest_angle=0.0, highest_angle=0.0)


def _lidar(mounted: Mounted, names: Names) -> Lidar:
    element = mounted.element
    scan = next((tag for tag in element if tag.tag in {"ray", "lidar"}), None)
    horizontal = None if scan is None else scan.find("scan/horizontal")
    reach = None if scan is None else scan.find("range")
    rays = int(number(horizontal, 360, "samples") * number(horizontal, 1, "resolution"))
    return Lidar(
        **_common(mounted, names, "scan", 10.0),
        rays=min(max(rays, 1), _MAX_RAYS),
        first_angle=number(horizontal, 0.0, "min_angle"),
        last_angle=number(horizontal, 2 * math.pi * 359 / 360, "max_angle"),
        nearest=number(reach, 0.1, "min"),
        farthest=number(reach, 12.0, "max"),
    )


def _imu(mounted: Mounted, names: Names) -> Sensor:
    element = mounted.element
    spread = element.find("imu/angular_velocity/z/noise")
    found = _common(mounted, names, "imu", 100.0)
    found["noise"] = number(element.find("imu/linear_acceleration/x/noise"), 0.0, "stddev")
    return Imu(**found, turn_noise=number(spread, 0.0, "stddev"))


def _camera(mounted: Mounted, names: Names) -> Sensor:
    element, kind = mounted.element, mounted.element.get("type", "")
    camera = element.find("camera")
    image = None if camera is None else camera.find("image")
    clip = None if camera is None else camera.find("clip")
    width, height = (
        int(min(max(number(image, 160, side), 1), _MAX_SIDE)) for side in ("width", "height")
    )
    # The picture is made without a graphics card: a large one would take too long.
    most = _MAX_GAZEBO_PIXELS if names.model else _MAX_PIXELS
    shrink = max(1, math.ceil(math.sqrt(width * height / most)))
    found = _common(mounted, names, "camera", 10.0)
    found["rate_hz"] = min(found["rate_hz"], _MAX_GAZEBO_RATE_HZ if names.model else _MAX_RATE_HZ)
    has_color = "depth" not in kind or "rgbd" in kind or bool(names.model and is_classic(element))
    found |= _camera_topics(mounted, names, has_color) if names.model else {}
    return Camera(
        **found,
        width=max(width // shrink, 1),
        height=max(height // shrink, 1),
        field_of_view=min(max(number(camera, 1.0472, "horizontal_fov"), 0.01), 3.1),
        nearest=number(clip, 0.05, "near"),
        farthest=min(number(clip, 12.0, "far"), 100.0),
        has_color=has_color,
        has_depth="depth" in kind or "rgbd" in kind,
    )


def _camera_topics(mounted: Mounted, names: Names, has_color: bool) -> dict[str, Any]:
    element, kind = mounted.element, mounted.element.get("type", "")
    if is_classic(element):
        start = word(element, mounted.name, "camera_name", "cameraName")
        topics = [
            names.topic(element, f"{start}/{last}", "")
            for last in ("image_raw", "depth/image_raw", "camera_info", "depth/camera_info")
        ]
        has_depth = "depth" in kind
        return {
            "color_topic": topics[0],
            "depth_topic": topics[1],
            "info_topics": tuple(topics[2:] if has_depth else topics[2:3]),
            "points_topic": names.topic(element, f"{start}/points", "") if has_depth else "",
            "has_optical_points": True,
        }
    is_rgbd = "rgbd" in kind
    last = "" if is_rgbd else "image" if has_color else "depth_image"
    usual = names.of_sensor(mounted.link, mounted.name, last).rstrip("/")
    topic = names.topic(element, "", usual, "topic")
    start = topic if is_rgbd else topic.rpartition("/")[0]
    info = names.topic(element, "", f"{start.partition(':')[2]}/camera_info", "camera_info_topic")
    # A topic of the sensor is no topic of the information.
    color, depth = (f"{topic}/image", f"{topic}/depth_image") if is_rgbd else (topic, topic)
    points = f"{topic}/points" if is_rgbd or "depth" in kind else ""
    return {
        "color_topic": color,
        "depth_topic": depth,
        "info_topics": (info,),
        "points_topic": points,
    }


def _bumper(mounted: Mounted, names: Names) -> Sensor:
    found = _common(mounted, names, "bumper", 20.0)
    if names.model:
        usual = names.of_sensor(mounted.link, mounted.name, "contact")
        found["topic"] = names.topic(mounted.element, "bumper_states", usual, "topic")
    return Bumper(**found, is_classic=is_classic(mounted.element) and bool(names.model))


_LIDARS = frozenset({"ray", "gpu_ray", "lidar", "gpu_lidar"})
#: The other sensors by the value of `type`.
_SENSORS: dict[str, Callable[[Mounted, Names], Sensor]] = {
    "imu": _imu,
    **dict.fromkeys(("camera", "depth", "depth_camera", "rgbd_camera", "rgbd"), _camera),
    **dict.fromkeys(("wideanglecamera", "wide_angle_camera"), _camera),
    "contact": _bumper,
}


def _common(mounted: Mounted, names: Names, kind: str, rate_hz: float) -> dict[str, Any]:
    """Return the values that all sensors have."""
    element, link = mounted.element, mounted.link
    given = number(element, rate_hz, "update_rate") or rate_hz
    frame = names.frame(element, link)
    usual = names.of_sensor(link, mounted.name, kind)
    return {
        "link": mounted.mount,
        "topic": names.topic(element, "~/out", usual, "topic"),
        "rate_hz": min(max(given, 0.1), _MAX_RATE_HZ),
        "noise": number(next(element.iter("noise"), None), 0.0, "stddev"),
        "frame": frame or (link if mounted.mount != link else ""),
    }
