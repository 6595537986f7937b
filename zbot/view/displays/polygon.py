"""Display Polygon: the outline of a polygon, e.g. the footprint of a robot."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from zbot.view.colors import same
from zbot.view.displays.display import Display, Setting
from zbot.view.points import positions_of, strip, thinned
from zbot.view.shape import Lines

if TYPE_CHECKING:
    from zbot.view.shape import Shape

_GREEN = (25, 190, 60)
_MOST_CORNERS = 10_000


class Polygon(Display):
    """Closed line through the corners of a polygon."""

    name = "Polygon"
    types = ("geometry_msgs/msg/PolygonStamped",)
    settings = (
        Setting("width", 3.0, low=1.0, high=10.0, step=0.5),
        Setting("color", _GREEN),
    )

    def shapes(self, message: Any) -> list[Shape]:
        """Return the outline of a polygon."""
        points = message.polygon.points
        corners = positions_of(points[thinned(len(points), _MOST_CORNERS)], "the polygon")
        if len(corners) < 2:
            self.notice = f"the polygon has {len(corners)} corners: a line needs two"
            return []
        ends = strip(np.concatenate([corners, corners[:1]]))
        return [Lines(ends, same(self.color(), len(ends), 2), self.number("width"))]
