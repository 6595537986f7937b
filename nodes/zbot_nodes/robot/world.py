"""World of the simulated robot: a room with two boxes in it.

  y
 2.5 +-----------------------------+
     |               +---+         |
     |               |   |         |
     |               +---+         |
   0 |       robot >               |
     |                             |
     |   +----+                    |
     |   +----+                    |
-2.5 +-----------------------------+
    -2        0                    4   x      (metres)
"""

from __future__ import annotations

import math
from typing import NamedTuple


class Box(NamedTuple):
    """Rectangle between two opposite corners, in metres."""

    left: float
    bottom: float
    right: float
    top: float

    def holds(self, x: float, y: float, margin: float = 0.0) -> bool:
        """Return whether a point is in the box, or less than `margin` metres outside."""
        return (
            self.left - margin < x < self.right + margin
            and self.bottom - margin < y < self.top + margin
        )


ROOM = Box(-2.0, -2.5, 4.0, 2.5)
OBSTACLES = (Box(1.7, 1.0, 2.3, 1.6), Box(-1.4, -1.9, -0.6, -1.3))
ROBOT_RADIUS_M = 0.2


def is_free(x: float, y: float) -> bool:
    """Return whether the robot fits with its centre at (x, y)."""
    inside = ROOM.holds(x, y, margin=-ROBOT_RADIUS_M)
    return inside and not any(box.holds(x, y, margin=ROBOT_RADIUS_M) for box in OBSTACLES)


def distance(x: float, y: float, angle: float) -> float:
    """Return the distance from (x, y) to the first wall in a direction.

    Args:
        x: Metres.
        y: Metres.
        angle: Radians, counter-clockwise from the x axis.

    Returns:
        The distance in metres. Outside of the room, the distance is infinity if no wall is in that
            direction.
    """
    cos, sin = math.cos(angle), math.sin(angle)
    nearest = math.inf
    for box in (ROOM, *OBSTACLES):
        if abs(cos) > 1e-9:  # otherwise the ray is parallel to these two walls
            for wall_x in (box.left, box.right):
                t = (wall_x - x) / cos
                if 0 < t < nearest and box.bottom <= y + t * sin <= box.top:
                    nearest = t
        if abs(sin) > 1e-9:
            for wall_y in (box.bottom, box.top):
                t = (wall_y - y) / sin
                if 0 < t < nearest and box.left <= x + t * cos <= box.right:
                    nearest = t
    return nearest
