"""Display PointCloud2: a cloud of points with colours."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from zbot.libraries.point_cloud import PointCloudError, read_points
from zbot.view.colors import rainbow, same
from zbot.view.displays.decay import DECAY_SETTING, Decaying
from zbot.view.displays.display import Setting
from zbot.view.errors import DisplayError
from zbot.view.points import thinned, usable
from zbot.view.shape import POINT_SHAPES, Points

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from zbot.view.shape import Shape

_WHITE = (200, 200, 200)
_AXES = ("z", "x", "y")


class PointCloud2(Decaying):
    """Points of a cloud. Points that are NaN are left out, and large clouds are thinned."""

    name = "PointCloud2"
    types = ("sensor_msgs/msg/PointCloud2",)
    settings = (
        Setting("size", 0.03, low=0.002, high=0.3, step=0.002),
        Setting("color by", "auto", ("auto", "rgb", "intensity", *_AXES, "flat")),
        Setting("color", _WHITE),
        Setting("shape", "square", POINT_SHAPES),
        Setting("points at most", 30_000, low=1000, high=200_000, step=1000),
        DECAY_SETTING,
    )

    def shapes(self, message: Any) -> list[Shape]:
        """Return the points of a cloud."""
        try:
            points = read_points(message)
        except (PointCloudError, ValueError) as error:
            raise DisplayError(f"the cloud cannot be read: {error}") from error
        names = points.dtype.names or ()
        missing = [name for name in "xyz" if name not in names]
        if missing:
            raise DisplayError(f"the cloud has no field {missing[0]!r}; it has {', '.join(names)}")
        sent = len(points)
        points = points[thinned(sent, self.number("points at most"))]
        positions = np.stack([points[name].astype(np.float64) for name in "xyz"], axis=1)
        good = usable(positions)
        positions, points = positions[good], points[good]
        if not sent:
            self.notice = "the cloud is empty"
        elif not len(points):
            self.notice = "all points of the cloud are NaN or too far away"
        elif len(good) < sent:
            self.notice = f"{len(good)} of {sent} points are shown"
        colors = self._colors(points, positions)
        shape = str(self.values["shape"])
        return [Points(positions.astype(np.float32), colors, self.number("size"), shape)]

    def _colors(self, points: NDArray[Any], positions: NDArray[Any]) -> NDArray[np.uint8]:
        names = points.dtype.names or ()
        way = str(self.values["color by"])
        if way == "auto":
            way = next((name for name in ("rgb", "rgba", "intensity") if name in names), "z")
        if way in {"rgb", "rgba"}:
            packed = next((points[name] for name in ("rgb", "rgba") if name in names), None)
            if packed is not None and packed.dtype.itemsize == 4:
                return _unpacked(packed)
            self.notice = self.notice or "the cloud has no field rgb"
        elif way == "intensity":
            if "intensity" in names:
                return rainbow(points["intensity"])
            self.notice = self.notice or "the cloud has no field intensity"
        elif way in _AXES:
            return rainbow(positions[:, "xyz".index(way)])
        return same(self.color(), len(points))


def _unpacked(packed: NDArray[Any]) -> NDArray[np.uint8]:
    """Return the colours of PCL's `rgb` field: the bytes of a number, which are 0xAARRGGBB."""
    numbers = np.ascontiguousarray(packed).view(np.uint32)
    return np.stack([(numbers >> shift) & 255 for shift in (16, 8, 0)], axis=1).astype(np.uint8)
