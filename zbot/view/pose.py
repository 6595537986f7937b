"""Poses of messages, as rigid transforms."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

from zbot.tf2.rigid import Rigid, heading, normalized
from zbot.view.errors import DisplayError
from zbot.view.points import check_number

if TYPE_CHECKING:
    from zbot.tf2.rigid import Quaternion, Vector

_LENGTH_TOLERANCE = 0.1


def vector_of(point: Any, what: str = "the position") -> Vector:
    """Return a point or vector of a message.

    Raises:
        DisplayError: A number is NaN, infinite or too large.
    """
    x, y, z = (check_number(getattr(point, axis), f"{axis} of {what}") for axis in "xyz")
    return x, y, z


def rotation_of(rotation: Any) -> Quaternion:
    """Return a quaternion of a message with length 1. As in rviz, all zeros mean no rotation.

    Raises:
        DisplayError: The length is not 1, or a number is not finite.
    """
    parts: Quaternion = (rotation.x, rotation.y, rotation.z, rotation.w)
    if not any(parts):
        return (0.0, 0.0, 0.0, 1.0)
    length = math.hypot(*parts)
    if not abs(length - 1) <= _LENGTH_TOLERANCE:
        raise DisplayError(f"the orientation is not a quaternion of length 1, but of {length:.3g}")
    return normalized(parts)


def pose_of(pose: Any) -> Rigid:
    """Return a `geometry_msgs/Pose`.

    Raises:
        DisplayError: A number is not finite, or the length of the quaternion is not 1.
    """
    return Rigid(vector_of(pose.position), rotation_of(pose.orientation))


def yaw_only(pose: Rigid) -> Rigid:
    """Return a pose with only the part of its rotation that is around z."""
    yaw = heading(pose.rotation)
    return Rigid(pose.translation, (0.0, 0.0, math.sin(yaw / 2), math.cos(yaw / 2)))
