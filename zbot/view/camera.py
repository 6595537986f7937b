"""Camera of a view: what it looks at, from where, and the frame that it follows."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from zbot.tf2.rigid import Vector

#: Vertical angle of view in rad, as in rviz.
ANGLE = math.pi / 4
#: The camera never looks exactly along z, because its upper side would be unknown.
_STEEPEST = math.pi / 2 - 0.001


@dataclass(frozen=True)
class Camera:
    """Camera that turns around a point.

    Attributes:
        focus: The point that it looks at, in metres from the origin of the target frame.
        distance: Distance from this point in metres.
        yaw: Angle of the camera around z, from the x axis, in rad. 0 means that it looks along -x.
        pitch: Angle of the camera above the plane of x and y, in rad.
        target: The frame that it follows. An empty name means the fixed frame.
        turns: Whether it also turns with the frame, around z.
    """

    focus: Vector = (0.0, 0.0, 0.0)
    distance: float = 4.0
    yaw: float = -3 * math.pi / 4
    pitch: float = 0.6
    target: str = ""
    turns: bool = False

    @property
    def position(self) -> Vector:
        """The place of the camera, from the origin of the target frame."""
        pitch = min(max(self.pitch, -_STEEPEST), _STEEPEST)
        flat = self.distance * math.cos(pitch)
        x, y, z = self.focus
        return (
            x + flat * math.cos(self.yaw),
            y + flat * math.sin(self.yaw),
            z + self.distance * math.sin(pitch),
        )


#: Views of the panel: yaw and pitch. From above, x is to the right.
VIEWS = {
    "above": (-math.pi / 2, math.pi / 2),
    "side": (-math.pi / 2, 0.05),
    "front": (0.0, 0.05),
    "behind": (math.pi, 0.35),
}


def camera_at(position: Vector, focus: Vector) -> Camera:
    """Return the camera at a position that looks at a point, in the fixed frame."""
    x, y, z = (here - there for here, there in zip(position, focus, strict=True))
    distance = max(math.sqrt(x * x + y * y + z * z), 0.01)
    pitch = math.asin(min(max(z / distance, -1.0), 1.0))
    return Camera(focus, distance, math.atan2(y, x), pitch)
