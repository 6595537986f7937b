"""Check of transforms, which the senders and the receivers use."""

from __future__ import annotations

import math
from typing import Any

_TOLERANCE = 1e-2  # largest difference of the squared length of a quaternion from 1, as in tf2


def transform_problem(stamped: Any) -> str:
    """Return why buffers ignore a `TransformStamped`, or the empty text if they use it."""
    parent = stamped.header.frame_id.removeprefix("/")
    child = stamped.child_frame_id.removeprefix("/")
    if not parent or not child:
        return "frame_id and child_frame_id must not be empty"
    if parent == child:
        return f"{child!r} cannot be its own parent; write another name into header.frame_id"
    t, q = stamped.transform.translation, stamped.transform.rotation
    squared = q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w
    if not math.isfinite(t.x + t.y + t.z + squared):
        return f"a value in the transform of {child!r} is infinite or NaN"
    if abs(squared - 1) > _TOLERANCE:
        return (
            f"the rotation of {child!r} is not a quaternion of length 1; "
            "without a rotation, write rotation.w = 1.0"
        )
    return ""
