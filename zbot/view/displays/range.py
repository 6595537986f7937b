"""Display Range: the cone of a distance sensor, e.g. of ultrasound."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from zbot.view.displays.display import Display, Setting
from zbot.view.errors import DisplayError
from zbot.view.points import check_number
from zbot.view.shape import Mesh

if TYPE_CHECKING:
    from zbot.view.shape import Shape

_SIDES = 32
_YELLOW = (240, 200, 30)


class Range(Display):
    """Cone along x, as long as the measured distance."""

    name = "Range"
    types = ("sensor_msgs/msg/Range",)
    settings = (
        Setting("opacity", 0.5, low=0.1, high=1.0, step=0.1),
        Setting("color", _YELLOW),
    )

    def shapes(self, message: Any) -> list[Shape]:
        """Return the cone of a distance."""
        distance = message.range
        if not message.min_range <= distance <= message.max_range:
            self.notice = (
                f"nothing is in range: the distance is {distance:g} m, valid are "
                f"{message.min_range:g} to {message.max_range:g} m"
            )
            return []
        check_number(distance, "range")
        angle = check_number(message.field_of_view, "field_of_view", low=0)
        if angle >= math.pi:
            raise DisplayError(f"field_of_view is {angle:g}, but must be less than pi")
        radius = distance * math.tan(angle / 2)
        turn = np.arange(_SIDES) * (2 * math.pi / _SIDES)
        ring = [np.full(_SIDES, distance), radius * np.cos(turn), radius * np.sin(turn)]
        vertices = np.concatenate([np.zeros((1, 3)), np.stack(ring, axis=1), [[distance, 0, 0]]])
        one, two = np.arange(_SIDES) + 1, np.roll(np.arange(_SIDES) + 1, -1)
        tip, middle = np.zeros(_SIDES, int), np.full(_SIDES, _SIDES + 1)
        faces = np.concatenate(
            [
                np.stack([tip, two, one], axis=1),
                np.stack([middle, one, two], axis=1),
            ]
        ).astype(np.uint32)
        opacity = self.number("opacity")
        return [Mesh(vertices.astype(np.float32), faces, self.color(), opacity)]
