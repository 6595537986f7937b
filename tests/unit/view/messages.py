"""Messages that displays show, one for each type."""

from __future__ import annotations

import struct
from typing import Any

import zbot  # noqa: F401 - makes the messages importable

from geometry_msgs.msg import (
    AccelStamped,
    Point,
    Point32,
    PointStamped,
    PolygonStamped,
    Pose,
    PoseArray,
    PoseStamped,
    PoseWithCovarianceStamped,
    TransformStamped,
    TwistStamped,
    WrenchStamped,
)
from nav_msgs.msg import GridCells, OccupancyGrid, Odometry, Path
from sensor_msgs.msg import (
    Image,
    LaserScan,
    PointCloud2,
    PointField,
    Range,
    Temperature,
)
from std_msgs.msg import ColorRGBA
from visualization_msgs.msg import Marker

RED = ColorRGBA(r=1.0, a=1.0)


def framed(message: Any, frame: str = "map") -> Any:
    message.header.frame_id = frame
    return message


def scan(ranges: list[float], **fields: Any) -> Any:
    return framed(
        LaserScan(
            ranges=ranges,
            **{"angle_increment": 0.5, "range_min": 0.1, "range_max": 10.0, **fields},
        )
    )


def cloud(points: list[tuple[float, float, float, int]], **fields: Any) -> Any:
    """Return points with a colour, which PCL writes as the bytes of a float."""
    data = b"".join(struct.pack("<fffI", *point) for point in points)
    names = [
        PointField(name=name, offset=4 * place, datatype=7, count=1)
        for place, name in enumerate(("x", "y", "z", "rgb"))
    ]
    sizes = {
        "fields": names,
        "height": 1,
        "width": len(points),
        "point_step": 16,
        "row_step": 16 * len(points),
    }
    return framed(PointCloud2(data=data, is_dense=True, **{**sizes, **fields}))


def grid(width: int, height: int, data: list[int], resolution: float = 0.5) -> Any:
    message = framed(OccupancyGrid(data=data))
    message.info.width, message.info.height = width, height
    message.info.resolution = resolution
    return message


def marker(kind: int, **fields: Any) -> Any:
    message = framed(Marker(type=kind, **{"color": RED, **fields}))
    scale = message.scale
    scale.x = scale.y = scale.z = 0.5
    return message


def pose(x: float = 1.0) -> Any:
    return Pose(position=Point(x=x))


def path(*xs: float) -> Any:
    return framed(Path(poses=[PoseStamped(pose=pose(x)) for x in xs]))


def polygon(*corners: tuple[float, float]) -> Any:
    message = framed(PolygonStamped())
    message.polygon.points = [Point32(x=x, y=y) for x, y in corners]
    return message


def link(parent: str, child: str, x: float = 0.0, stamp_s: int = 0) -> Any:
    message = framed(TransformStamped(child_frame_id=child), parent)
    message.header.stamp.sec = stamp_s
    message.transform.translation.x = x
    message.transform.rotation.w = 1.0
    return message


def with_covariance() -> Any:
    message = framed(PoseWithCovarianceStamped())
    covariance = [0.0] * 36
    covariance[0] = covariance[7] = 0.04
    message.pose.covariance = covariance
    return message


def wrench() -> Any:
    message = framed(WrenchStamped())
    message.wrench.force.x = 2.0
    return message


def image() -> Any:
    return framed(Image(width=4, height=2, encoding="rgb8", step=12, data=b"\xff\0\0" * 8))


MESSAGES: dict[str, Any] = {
    "LaserScan": scan([1.0, 2.0]),
    "PointCloud2": cloud([(1, 2, 3, 0xFF0000)]),
    "Map": grid(2, 1, [0, 100]),
    "Image": image(),
    "Odometry": framed(Odometry()),
    "Path": path(0, 1),
    "Pose": framed(PoseStamped(pose=pose())),
    "PoseArray": framed(PoseArray(poses=[pose(), pose(2)])),
    "PoseWithCovariance": with_covariance(),
    "Marker": marker(1),
    "Polygon": polygon((0, 0), (1, 0), (1, 1)),
    "Range": framed(Range(field_of_view=0.5, min_range=0.1, max_range=4.0, range=1.0)),
    "GridCells": framed(GridCells(cell_width=0.1, cell_height=0.1, cells=[Point()])),
    "Wrench": wrench(),
    "Twist": framed(TwistStamped()),
    "Accel": framed(AccelStamped()),
    "PointStamped": framed(PointStamped(point=Point(x=1.0))),
    "Text": Temperature(temperature=21.5),
}
