"""Transformation of points, vectors and poses. Programs can register further classes."""

from __future__ import annotations

import copy
import sys
from collections.abc import Callable, Iterable, Sequence
from typing import Any

from zbot.executor.errors import WrongObjectError
from zbot.tf2.errors import TypeException, kind_of
from zbot.tf2.rigid import Quaternion, Rigid, multiply, normalized, rotate

from geometry_msgs.msg import (
    PointStamped,
    PolygonStamped,
    Pose,
    PoseStamped,
    PoseWithCovarianceStamped,
    Vector3Stamped,
    WrenchStamped,
)

#: Function of a stamped object and a `TransformStamped`. The function returns a new object.
Transformation = Callable[[Any, Any], Any]

_EPSILON = sys.float_info.epsilon
_NO_ROTATION: Quaternion = (0.0, 0.0, 0.0, 1.0)

_registered: dict[type[Any], Transformation] = {}


def add(stamped_class: type[Any], transformation: Transformation) -> None:
    """Register the function that buffers use to transform objects of a class."""
    _registered[stamped_class] = transformation


def registered(stamped_class: type[Any]) -> Transformation:
    """Return the function that transforms objects of a class.

    Raises:
        TypeException: No function is registered for the class.
    """
    transformation = _registered.get(stamped_class)
    if transformation is None:
        raise TypeException(
            f"Type {stamped_class.__qualname__} is not loaded or supported: give a PointStamped, "
            "Vector3Stamped or PoseStamped"
        )
    return transformation


def rigid(transform: Any) -> Rigid:
    """Return the motion of a `Transform` or `TransformStamped`."""
    inner = transform.transform if hasattr(transform, "transform") else transform
    t = inner.translation
    return Rigid((t.x, t.y, t.z), _rotation(inner.rotation))


def _rotation(q: Any) -> Quaternion:
    """Return a quaternion message as a rotation. As in ROS 2, length 0 means no rotation."""
    parts = (q.x, q.y, q.z, q.w)
    return normalized(parts) if sum(part * part for part in parts) >= _EPSILON else _NO_ROTATION


def _check(function: Transformation, field: str, value: Any, transform: Any) -> None:
    """Check that a function is given an object that has its field, and a transform.

    Raises:
        WrongObjectError: The object is of another function, or an argument is something else.
    """
    if _FUNCTIONS.get(type(value), function) is not function or not _has(value, field):
        raise _wrong_object_error(function, field, value)
    if _has(transform, "header"):
        return
    if function is not do_transform_pose or not _has(transform, "rotation"):
        raise WrongObjectError(
            f"{function.__name__} needs a TransformStamped, not {kind_of(transform)}: "
            "write the result of lookup_transform()"
        )


def _has(value: object, field: str) -> bool:
    return hasattr(value, field) and not isinstance(value, type)


def _wrong_object_error(function: Transformation, field: str, value: Any) -> WrongObjectError:
    name = function.__name__
    kind = next(each.__name__ for each, known in _FUNCTIONS.items() if known is function)
    right = {**_registered, **_FUNCTIONS}.get(type(value))
    if right is not None:
        advice = f"{getattr(right, '__name__', right)}()"
    elif _has(value, "transform"):
        advice = f"{name}({name.removeprefix('do_transform_')}, transform), in this order"
    else:
        advice = f"{kind}({field}=...)"
    return WrongObjectError(f"{name} needs a {kind}, not {kind_of(value)}: write {advice}")


def do_transform_point(point: Any, transform: Any) -> Any:
    """Return a `PointStamped` in the transform's parent frame."""
    _check(do_transform_point, "point", point, transform)
    moved = PointStamped(header=copy.deepcopy(transform.header))
    place = point.point
    moved.point.x, moved.point.y, moved.point.z = rigid(transform).apply(
        (place.x, place.y, place.z)
    )
    return moved


def do_transform_vector3(vector: Any, transform: Any) -> Any:
    """Return a `Vector3Stamped` that is rotated, but not translated."""
    _check(do_transform_vector3, "vector", vector, transform)
    moved = Vector3Stamped(header=copy.deepcopy(transform.header))
    v = vector.vector
    turned = rotate(rigid(transform).rotation, (v.x, v.y, v.z))
    moved.vector.x, moved.vector.y, moved.vector.z = turned
    return moved


def do_transform_pose(pose: Any, transform: Any) -> Any:
    """Return a `Pose` in the transform's parent frame."""
    _check(do_transform_pose, "position", pose, transform)
    moved = copy.deepcopy(pose)
    motion, p, q = rigid(transform), pose.position, pose.orientation
    moved.position.x, moved.position.y, moved.position.z = motion.apply((p.x, p.y, p.z))
    x, y, z, w = multiply(motion.rotation, _rotation(q))
    # q and -q are the same rotation. As in ROS 2, the result is the one with w >= 0.
    turned = (-x, -y, -z, -w) if w < 0 else (x, y, z, w)
    orientation = moved.orientation
    orientation.x, orientation.y, orientation.z, orientation.w = turned
    return moved


def do_transform_pose_stamped(pose: Any, transform: Any) -> Any:
    """Return a `PoseStamped` in the transform's parent frame."""
    _check(do_transform_pose_stamped, "pose", pose, transform)
    return PoseStamped(
        header=copy.deepcopy(transform.header), pose=do_transform_pose(pose.pose, transform)
    )


def do_transform_pose_with_covariance_stamped(pose: Any, transform: Any) -> Any:
    """Return a `PoseWithCovarianceStamped` in the transform's parent frame, covariance included."""
    _check(do_transform_pose_with_covariance_stamped, "pose", pose, transform)
    moved = copy.deepcopy(pose)
    moved.header = copy.deepcopy(transform.header)
    moved.pose.pose = do_transform_pose(pose.pose.pose, transform)
    moved.pose.covariance = transform_covariance(pose.pose.covariance, transform)
    return moved


def transform_covariance(covariance: Sequence[float], transform: Any) -> list[float]:
    """Return the covariance of a pose, 6x6 row by row, in the transform's parent frame."""
    rotation = rigid(transform).rotation

    def turned(rows: Iterable[tuple[float, ...]]) -> list[tuple[float, ...]]:
        # Each row consists of two vectors: one for the position and one for the angles.
        return [
            (*rotate(rotation, (a, b, c)), *rotate(rotation, (d, e, f)))
            for a, b, c, d, e, f in rows
        ]

    rows = [tuple(map(float, covariance[start : start + 6])) for start in range(0, 36, 6)]
    columns = zip(*turned(rows), strict=True)
    # The columns are rotated too, as the rows of the transposed matrix.
    return [value for row in zip(*turned(columns), strict=True) for value in row]


def do_transform_wrench(wrench: Any, transform: Any) -> Any:
    """Return a `WrenchStamped` with force and torque rotated into the parent frame."""
    _check(do_transform_wrench, "wrench", wrench, transform)
    moved = WrenchStamped(header=copy.deepcopy(transform.header))
    rotation = rigid(transform).rotation
    for name in ("force", "torque"):
        v, target = getattr(wrench.wrench, name), getattr(moved.wrench, name)
        target.x, target.y, target.z = rotate(rotation, (v.x, v.y, v.z))
    return moved


def do_transform_polygon_stamped(polygon: Any, transform: Any) -> Any:
    """Return a `PolygonStamped` in the transform's parent frame."""
    _check(do_transform_polygon_stamped, "polygon", polygon, transform)
    moved, motion = copy.deepcopy(polygon), rigid(transform)
    moved.header = copy.deepcopy(transform.header)
    for point in moved.polygon.points:
        point.x, point.y, point.z = motion.apply((point.x, point.y, point.z))
    return moved


#: Functions of `tf2_geometry_msgs` by the class of their first argument.
_FUNCTIONS: dict[type[Any], Transformation] = {
    PointStamped: do_transform_point,
    Vector3Stamped: do_transform_vector3,
    PolygonStamped: do_transform_polygon_stamped,
    Pose: do_transform_pose,
    PoseStamped: do_transform_pose_stamped,
    PoseWithCovarianceStamped: do_transform_pose_with_covariance_stamped,
    WrenchStamped: do_transform_wrench,
}
_registered.update((kind, each) for kind, each in _FUNCTIONS.items() if kind is not Pose)
