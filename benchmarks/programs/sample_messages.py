"""Messages of twelve common types, with the sizes that they have on a small robot."""

from __future__ import annotations

import array
from typing import TYPE_CHECKING, Any

import zbot  # noqa: F401 - makes the message packages importable

from geometry_msgs.msg import PoseStamped, TransformStamped, Twist
from nav_msgs.msg import Odometry, Path
from sensor_msgs.msg import Image, Imu, JointState, LaserScan
from std_msgs.msg import Float32, String, UInt8MultiArray
from tf2_msgs.msg import TFMessage

if TYPE_CHECKING:
    from collections.abc import Callable

_JOINTS = 6
_RAYS = 360
_TRANSFORMS = 5
_POSES = 50
_WIDTH, _HEIGHT = 640, 480


def array_message(size: int) -> UInt8MultiArray:
    return UInt8MultiArray(data=array.array("B", bytes(size)))


def _stamped(msg: Any, frame: str) -> Any:
    msg.header.stamp.sec, msg.header.stamp.nanosec = 1_790_000_000, 123_456_789
    msg.header.frame_id = frame
    return msg


def _twist() -> Twist:
    msg = Twist()
    msg.linear.x, msg.angular.z = 0.25, -0.5
    return msg


def _imu() -> Imu:
    msg = _stamped(Imu(), "imu_link")
    msg.linear_acceleration.z, msg.angular_velocity.z = 9.81, 0.02
    return msg  # type: ignore[no-any-return]


def _joint_state() -> JointState:
    numbers = [0.1 * joint for joint in range(_JOINTS)]
    names = [f"joint_{joint}" for joint in range(_JOINTS)]
    msg = JointState(name=names, position=numbers, velocity=numbers, effort=numbers)
    return _stamped(msg, "base_link")  # type: ignore[no-any-return]


def _laser_scan() -> LaserScan:
    ranges = [1.0 + 0.01 * ray for ray in range(_RAYS)]
    msg = LaserScan(ranges=ranges, angle_min=-3.14, angle_max=3.14, range_max=12.0)
    return _stamped(msg, "laser")  # type: ignore[no-any-return]


def _transforms() -> TFMessage:
    found = [_stamped(TransformStamped(), f"link_{link}") for link in range(_TRANSFORMS)]
    for link, transform in enumerate(found):
        transform.child_frame_id = f"link_{link + 1}"
        transform.transform.translation.x = 0.1 * link
    return TFMessage(transforms=found)


def _odometry() -> Odometry:
    msg = _stamped(Odometry(child_frame_id="base_link"), "odom")
    msg.pose.pose.position.x, msg.twist.twist.linear.x = 1.5, 0.25
    return msg  # type: ignore[no-any-return]


def _pose() -> PoseStamped:
    msg = _stamped(PoseStamped(), "map")
    msg.pose.position.x, msg.pose.orientation.w = 1.5, 1.0
    return msg  # type: ignore[no-any-return]


def _path() -> Path:
    return _stamped(Path(poses=[_pose() for _ in range(_POSES)]), "map")  # type: ignore[no-any-return]


def _image() -> Image:
    pixels = array.array("B", bytes(range(256)) * (_WIDTH * _HEIGHT * 3 // 256))
    msg = Image(width=_WIDTH, height=_HEIGHT, encoding="rgb8", step=_WIDTH * 3, data=pixels)
    return _stamped(msg, "camera")  # type: ignore[no-any-return]


TYPES: dict[str, Callable[[], Any]] = {
    "Float32": lambda: Float32(data=0.5),
    "String, 20 letters": lambda: String(data="x" * 20),
    "Twist": _twist,
    "Imu": _imu,
    "JointState, 6 joints": _joint_state,
    "LaserScan, 360 rays": _laser_scan,
    "TFMessage, 5 transforms": _transforms,
    "Odometry": _odometry,
    "PoseStamped": _pose,
    "UInt8MultiArray, 64 B": lambda: array_message(64),
    "Path, 50 poses": _path,
    "Image, 640x480 rgb8": _image,
}


def message(kind: str | int) -> Any:
    """Return a message of a type in `TYPES`, or a `UInt8MultiArray` of a number of bytes."""
    return array_message(kind) if isinstance(kind, int) else TYPES[kind]()
