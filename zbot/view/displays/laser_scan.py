"""Display LaserScan: the points that a planar laser hit."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from zbot.view.colors import rainbow, same
from zbot.view.displays.decay import DECAY_SETTING, Decaying
from zbot.view.displays.display import Setting
from zbot.view.errors import DisplayError
from zbot.view.points import thinned, usable
from zbot.view.shape import POINT_SHAPES, Points

if TYPE_CHECKING:
    from zbot.view.shape import Shape

_RED = (230, 40, 40)


class LaserScan(Decaying):
    """Points of a scan. Rays without a valid range are left out."""

    name = "LaserScan"
    types = ("sensor_msgs/msg/LaserScan",)
    settings = (
        Setting("size", 0.05, low=0.005, high=0.3, step=0.005),
        Setting("color by", "flat", ("flat", "distance", "intensity", "x", "y")),
        Setting("color", _RED),
        Setting("shape", "square", POINT_SHAPES),
        Setting("points at most", 20_000, low=100, high=100_000, step=100),
        DECAY_SETTING,
    )

    def shapes(self, message: Any) -> list[Shape]:
        """Return the points of a scan."""
        ranges = np.asarray(message.ranges, np.float64)
        if not len(ranges):
            raise DisplayError("the scan is empty: it has no ranges")
        with np.errstate(invalid="ignore"):
            (rays,) = np.nonzero((ranges >= message.range_min) & (ranges <= message.range_max))
        rays = rays[thinned(len(rays), self.number("points at most"))]
        if not len(rays):
            self.notice = "no ray of the scan has a range between range_min and range_max"
        angles = message.angle_min + rays * message.angle_increment
        x, y = ranges[rays] * np.cos(angles), ranges[rays] * np.sin(angles)
        positions = np.stack([x, y, np.zeros(len(rays))], axis=1)
        good = usable(positions)
        if not good.all():
            raise DisplayError("angle_min, angle_increment or a range of the scan is not finite")
        colors = self._colors(message, ranges, rays)
        if self.values["color by"] in {"x", "y"}:
            colors = rainbow(positions[:, "xy".index(str(self.values["color by"]))])
        shape = str(self.values["shape"])
        return [Points(positions.astype(np.float32), colors, self.number("size"), shape)]

    def _colors(self, message: Any, ranges: Any, rays: Any) -> Any:
        way = self.values["color by"]
        if way == "distance":
            return rainbow(ranges[rays])
        if way == "intensity":
            if len(message.intensities) == len(ranges):
                return rainbow(np.asarray(message.intensities, np.float64)[rays])
            self.notice = "the scan has no intensities"
        return same(self.color(), len(rays))
