"""Reader of the `<sensor>` tags of sonars, satellite receivers, batteries and lidars with rows."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any, NamedTuple

from zbot.libraries.robot_description.xml_text import numbers
from zbot.simulation.robots.equipment import EARTH, Battery, CloudLidar, Gps, Lidar, Sensor, Sonar

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping
    from xml.etree.ElementTree import Element

_MOST_RAYS = 20_000


class Kind(NamedTuple):
    """Kind of sensor: its usual topic and rate, and the function that reads it."""

    topic: str
    rate_hz: float
    read: Callable[[Element, Mapping[str, Any]], Sensor]


def _sonar(element: Element, common: Mapping[str, Any]) -> Sensor:
    radius = _number(element, math.nan, "sonar/radius")
    farthest = min(max(_number(element, 4.0, "sonar/max", "ray/range/max"), 0.1), 100.0)
    width = 2 * math.atan(radius / farthest) if radius > 0 else 0.5
    nearest = max(_number(element, 0.02, "sonar/min", "ray/range/min"), 0.0)
    return Sonar(
        **common, field_of_view=min(max(width, 0.01), 3.0), nearest=nearest, farthest=farthest
    )


def _gps(element: Element, common: Mapping[str, Any]) -> Sensor:
    start = "position_sensing/{}/noise/stddev"
    names = (("origin/latitude", 90.0), ("origin/longitude", 180.0), ("origin/altitude", 1e5))
    latitude, longitude, altitude = (
        min(max(_number(element, usual, name), -most), most)
        for (name, most), usual in zip(names, EARTH, strict=True)
    )
    flat = _noise(element, start.format("horizontal"), common["noise"])
    high = _noise(element, start.format("vertical"), 2 * flat)
    given = element.find("origin") is not None
    origin = (latitude, longitude, altitude) if given else None
    return Gps(**{**common, "noise": flat}, height_noise=high, origin=origin)


def _battery(element: Element, common: Mapping[str, Any]) -> Sensor:
    usual = Battery("", "", 1.0)
    return Battery(
        **common,
        voltage=min(max(_number(element, usual.voltage, "battery/voltage"), 0.1), 1000.0),
        capacity=min(max(_number(element, usual.capacity, "battery/capacity"), 1e-3), 1e4),
        idle_current=_current(element, usual.idle_current, "idle_current"),
        motion_current=_current(element, usual.motion_current, "motion_current"),
    )


def _current(element: Element, usual: float, name: str) -> float:
    return min(max(_number(element, usual, f"battery/{name}"), 0.0), 1e4)


#: The sensors by the value of `type`.
VALUE_SENSORS: dict[str, Kind] = {
    "sonar": Kind("sonar", 20.0, _sonar),
    **dict.fromkeys(("gps", "navsat"), Kind("gps/fix", 5.0, _gps)),
    "battery": Kind("battery_state", 1.0, _battery),
}


def with_rows(lidar: Lidar, element: Element) -> Lidar:
    """Return a lidar with the rows of rays that its tag names. With one row, it is the same."""
    rows = int(_number(element, 1, "ray/scan/vertical/samples", "lidar/scan/vertical/samples"))
    rows = min(max(rows, 1), max(_MOST_RAYS // lidar.rays, 1))
    if rows == 1:
        return lidar
    low, high = (
        min(max(_number(element, usual, f"ray{end}", f"lidar{end}"), -1.57), 1.57)
        for usual, end in (
            (-0.26, "/scan/vertical/min_angle"),
            (0.26, "/scan/vertical/max_angle"),
        )
    )
    topic = "points" if lidar.topic == "scan" else lidar.topic
    values: dict[str, Any] = {**vars(lidar), "topic": topic}
    return CloudLidar(**values, rows=rows, lowest_angle=low, highest_angle=high)


def _noise(element: Element, path: str, usual: float) -> float:
    return min(max(_number(element, usual, path), 0.0), 1000.0)


def _number(element: Element, usual: float, *paths: str) -> float:
    """Return the number at the first of these paths at any depth that exists."""
    for path in paths:
        found = element.find(f".//{path}")
        if found is not None:
            return numbers((found.text or "").strip(), 1, f"<{found.tag}> in <gazebo>")[0]
    return usual
