"""Conversion of laser scans to point clouds: ROS 2's package `laser_geometry`.

This module needs numpy (`pip install "zbot[numpy]"`).
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from zbot.errors import require_numpy
from zbot.libraries.point_cloud import create_cloud, dtype_from_fields

from sensor_msgs.msg import PointField

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from sensor_msgs.msg import LaserScan, PointCloud2

_FLOAT, _INTEGER = PointField.FLOAT32, PointField.INT32


class LaserProjection:
    """Turns scans of a planar laser into points in the frame of the laser, in metres."""

    LASER_SCAN_INVALID = -1.0
    LASER_SCAN_MIN_RANGE = -2.0
    LASER_SCAN_MAX_RANGE = -3.0

    class ChannelOption:
        """Fields of each point besides x, y and z. The values may be joined by `|`."""

        NONE = 0x00
        INTENSITY = 0x01  #: `intensity`, if the scan has intensities
        INDEX = 0x02  #: `index` of the ray
        DISTANCE = 0x04  #: `distances` in metres
        TIMESTAMP = 0x08  #: `stamps` in seconds after the first ray
        VIEWPOINT = 0x10  #: `vp_x`, `vp_y`, `vp_z`: the place of the laser, which is always 0
        DEFAULT = INTENSITY | INDEX

    def projectLaser(
        self,
        scan_in: LaserScan,
        range_cutoff: float = -1.0,
        channel_options: int = ChannelOption.DEFAULT,
    ) -> PointCloud2:
        """Return the points of a scan. Rays without a valid range are left out.

        Args:
            scan_in: The scan.
            range_cutoff: Ranges from this distance in metres on are left out too. A negative number
                means the `range_max` of the scan.
            channel_options: Values of `ChannelOption`, joined by `|`.
        """
        require_numpy("laser_geometry")
        import numpy as np  # noqa: PLC0415 - part of an extra

        ranges: NDArray[Any] = np.array(scan_in.ranges, np.float64)
        limit = scan_in.range_max if range_cutoff < 0 else min(range_cutoff, scan_in.range_max)
        (rays,) = np.nonzero((ranges >= scan_in.range_min) & (ranges < limit))
        angles, ranges = scan_in.angle_min + rays * scan_in.angle_increment, ranges[rays]
        none = np.zeros(len(rays))
        x, y = ranges * np.cos(angles), ranges * np.sin(angles)
        columns: dict[str, NDArray[Any]] = {"x": x, "y": y, "z": none}
        option = self.ChannelOption
        if channel_options & option.INTENSITY and len(scan_in.intensities):
            columns["intensity"] = np.array(scan_in.intensities)[rays]
        if channel_options & option.INDEX:
            columns["index"] = rays
        if channel_options & option.DISTANCE:
            columns["distances"] = ranges
        if channel_options & option.TIMESTAMP:
            columns["stamps"] = rays * scan_in.time_increment
        if channel_options & option.VIEWPOINT:
            columns |= dict.fromkeys(("vp_x", "vp_y", "vp_z"), none)
        return _cloud(scan_in, columns)


def _cloud(scan: LaserScan, columns: dict[str, NDArray[Any]]) -> PointCloud2:
    import numpy as np  # noqa: PLC0415 - part of an extra

    fields = [
        PointField(
            name=name,
            offset=4 * place,
            datatype=_INTEGER if name == "index" else _FLOAT,
            count=1,
        )
        for place, name in enumerate(columns)
    ]
    points = np.zeros(len(columns["x"]), dtype_from_fields(fields))
    for name, values in columns.items():
        points[name] = values
    return create_cloud(scan.header, fields, points)
