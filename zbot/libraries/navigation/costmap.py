"""Grids of costs in Python, and the cost of a robot's outline in such a grid.

Grids need numpy (`pip install "zbot[numpy]"`).
"""

from __future__ import annotations

import math
from numbers import Real
from typing import TYPE_CHECKING, Any

from zbot.errors import require_numpy

from geometry_msgs.msg import Point32, Polygon, Quaternion

if TYPE_CHECKING:
    from builtin_interfaces.msg import Time
    from geometry_msgs.msg import Pose
    from nav2_msgs.msg import Costmap
    from nav_msgs.msg import OccupancyGrid
    from std_msgs.msg import Header

NO_INFORMATION = 255
LETHAL_OBSTACLE = 254
INSCRIBED_INFLATED_OBSTACLE = 253
MAX_NON_OBSTACLE = 252
FREE_SPACE = 0
_DIGITS = 5  # a line's points are rounded to this many decimals


class _Grid:
    """Costs of square cells, row by row from the origin.

    Attributes:
        costmap: The costs as a numpy array with one dimension.
    """

    dtype = "uint8"

    def __init__(
        self,
        header: Header,
        size: tuple[int, int],
        resolution: float,
        origin: Pose,
        data: Any,
    ) -> None:
        require_numpy("the costmap")
        import numpy as np  # noqa: PLC0415 - part of an extra

        self.size_x, self.size_y = size
        self.resolution = resolution
        self.origin_x, self.origin_y = origin.position.x, origin.position.y
        self.global_frame_id, self.costmap_timestamp = header.frame_id, header.stamp
        self.costmap = np.array(data, dtype=self.dtype)

    def getSizeInCellsX(self) -> int:
        """Return the number of columns."""
        return self.size_x

    def getSizeInCellsY(self) -> int:
        """Return the number of rows."""
        return self.size_y

    def getSizeInMetersX(self) -> float:
        """Return the width in metres."""
        return self.size_x * self.resolution

    def getSizeInMetersY(self) -> float:
        """Return the height in metres."""
        return self.size_y * self.resolution

    def getOriginX(self) -> float:
        """Return x of the corner of the first cell, in metres."""
        return self.origin_x

    def getOriginY(self) -> float:
        """Return y of the corner of the first cell, in metres."""
        return self.origin_y

    def getResolution(self) -> float:
        """Return the length of a cell's side in metres."""
        return self.resolution

    def getGlobalFrameID(self) -> str:
        """Return the frame of the grid."""
        return self.global_frame_id

    def getCostmapTimestamp(self) -> Time:
        """Return when the grid was valid."""
        return self.costmap_timestamp

    def getIndex(self, mx: int, my: int) -> int:
        """Return the index of a cell in `costmap`."""
        return my * self.size_x + mx

    def getCostXY(self, mx: int, my: int) -> Any:
        """Return the cost of the cell in column `mx` and row `my`."""
        return self.costmap[self.getIndex(mx, my)]

    def getCostIdx(self, index: int) -> Any:
        """Return the cost of a cell by its index in `costmap`."""
        return self.costmap[index]

    def setCost(self, mx: int, my: int, cost: int) -> None:
        """Set the cost of the cell in column `mx` and row `my`."""
        self.costmap[self.getIndex(mx, my)] = cost

    def mapToWorld(self, mx: int, my: int) -> tuple[float, float]:
        """Return the centre of a cell in metres."""
        x, y = (self.resolution * (index + 0.5) for index in (mx, my))
        return self.origin_x + x, self.origin_y + y

    def worldToMapValidated(self, wx: float, wy: float) -> tuple[int, int] | tuple[None, None]:
        """Return column and row of the cell at a place, or twice None outside of the grid."""
        mx = math.floor((wx - self.origin_x) / self.resolution)
        my = math.floor((wy - self.origin_y) / self.resolution)
        is_inside = 0 <= mx < self.size_x and 0 <= my < self.size_y
        return (mx, my) if is_inside else (None, None)


class PyCostmap2D(_Grid):
    """Grid of a message `nav2_msgs/msg/Costmap`, with costs from 0 to 255."""

    def __init__(self, occupancy_map: Costmap) -> None:
        data = occupancy_map.metadata
        size = (data.size_x, data.size_y)
        costs = occupancy_map.data
        super().__init__(occupancy_map.header, size, data.resolution, data.origin, costs)


class PyOccupancyGrid(_Grid):
    """Grid of a message `nav_msgs/msg/OccupancyGrid`, with values from -1 (unknown) to 100."""

    dtype = "int8"

    def __init__(self, occupancy_map: OccupancyGrid) -> None:
        data = occupancy_map.info
        size = (data.width, data.height)
        costs = occupancy_map.data
        super().__init__(occupancy_map.header, size, data.resolution, data.origin, costs)


class LineIterator:
    """Walk along a line in steps in x, or in y if the line has only one x.

    Args:
        x0: x of the first point.
        y0: y of the first point.
        x1: x of the last point.
        y1: y of the last point.
        step_size: Distance in x between two points. The last step may be shorter.

    Raises:
        TypeError: An argument is not a number.
        ValueError: The step is not positive, or both points are the same.
    """

    def __init__(self, x0: float, y0: float, x1: float, y1: float, step_size: float = 1.0) -> None:
        given = {"x0": x0, "y0": y0, "x1": x1, "y1": y1, "step_size": step_size}
        for name, value in given.items():
            if not isinstance(value, Real) or isinstance(value, bool):
                raise TypeError(f"{name} must be a number (int or float)")
        if step_size <= 0:
            raise ValueError("step_size must be a positive number")
        if (x0, y0) == (x1, y1):
            raise ValueError("Line has zero length (All 4 points have same coordinates)")
        self._start, self._end = (x0, y0), (x1, y1)
        self._point = self._start
        self._step_size = step_size
        self._is_valid = True

    def isValid(self) -> bool:
        """Return whether the last step was on the line."""
        return self._is_valid

    def advance(self) -> None:
        """Go to the next point. After the last point, the iterator is not valid any more."""
        if self._point == self._end:
            self._is_valid = False
            return
        (x0, y0), (x1, y1) = self._start, self._end
        axis = 0 if x0 != x1 else 1
        length = abs(self._end[axis] - self._start[axis])
        walked = abs(self._point[axis] - self._start[axis]) + self._step_size
        if walked >= length:
            self._point = self._end
            return
        share = walked / length
        x, y = x0 + (x1 - x0) * share, y0 + (y1 - y0) * share
        self._point = round(x, _DIGITS), round(y, _DIGITS)

    def getX(self) -> float:
        """Return x of the present point."""
        return self._point[0]

    def getY(self) -> float:
        """Return y of the present point."""
        return self._point[1]

    def getX0(self) -> float:
        """Return x of the first point."""
        return self._start[0]

    def getY0(self) -> float:
        """Return y of the first point."""
        return self._start[1]

    def getX1(self) -> float:
        """Return x of the last point."""
        return self._end[0]

    def getY1(self) -> float:
        """Return y of the last point."""
        return self._end[1]

    def get_line_length(self) -> float:
        """Return the distance between the first and the last point."""
        return math.dist(self._start, self._end)

    @staticmethod
    def clamp(n: float, min_n: float, max_n: float) -> float:
        """Return the nearest number to `n` between two limits."""
        return max(min_n, min(max_n, n))


class FootprintCollisionChecker:
    """Cost of a robot's outline in a costmap. `setCostmap` must be called first.

    The methods raise ValueError if there is no costmap.
    """

    def __init__(self) -> None:
        self.costmap_: _Grid | None = None

    def setCostmap(self, costmap: _Grid) -> None:
        """Use a costmap from now on."""
        self.costmap_ = costmap

    def _costmap(self) -> _Grid:
        if self.costmap_ is None:
            raise ValueError("Costmap not specified, use setCostmap to specify the costmap first")
        return self.costmap_

    def worldToMapValidated(self, wx: float, wy: float) -> tuple[int, int] | tuple[None, None]:
        """Return column and row of the cell at a place, or twice None outside of the costmap."""
        return self._costmap().worldToMapValidated(wx, wy)

    def pointCost(self, x: int, y: int) -> Any:
        """Return the cost of a cell."""
        return self._costmap().getCostXY(x, y)

    def lineCost(self, x0: int, x1: int, y0: int, y1: int, step_size: float = 0.5) -> float:
        """Return the highest cost between two cells. Note the order of the arguments."""
        if (x0, y0) == (x1, y1):
            return float(self.pointCost(x0, y0))
        line, cost = LineIterator(x0, y0, x1, y1, step_size), 0.0
        while line.isValid() and cost != LETHAL_OBSTACLE:
            here = float(self.pointCost(int(line.getX()), int(line.getY())))
            cost = here if here == LETHAL_OBSTACLE else max(cost, here)
            line.advance()
        return cost

    def footprintCost(self, footprint: Polygon) -> float:
        """Return the highest cost on an outline in metres.

        Return `LETHAL_OBSTACLE` if a corner is outside of the costmap.
        """
        cells = [self.worldToMapValidated(point.x, point.y) for point in footprint.points]
        cost = 0.0
        for (x0, y0), (x1, y1) in zip(cells, cells[1:] + cells[:1], strict=True):
            if x0 is None or y0 is None or x1 is None or y1 is None:
                return float(LETHAL_OBSTACLE)
            here = self.lineCost(x0, x1, y0, y1)
            if here == LETHAL_OBSTACLE:
                return here
            cost = max(cost, here)
        return cost

    def footprintCostAtPose(self, x: float, y: float, theta: float, footprint: Polygon) -> float:
        """Return the highest cost on an outline that is turned by `theta` and moved to a place."""
        cos, sin = math.cos(theta), math.sin(theta)
        moved = [
            Point32(x=x + point.x * cos - point.y * sin, y=y + point.x * sin + point.y * cos)
            for point in footprint.points
        ]
        return self.footprintCost(Polygon(points=moved))


def euler_to_quaternion(roll: float = 0.0, pitch: float = 0.0, yaw: float = 0.0) -> Quaternion:
    """Return a rotation about fixed axes, first about x, then y, then z, in radians."""
    (cr, sr), (cp, sp), (cy, sy) = (
        (math.cos(angle / 2), math.sin(angle / 2)) for angle in (roll, pitch, yaw)
    )
    return Quaternion(
        x=sr * cp * cy - cr * sp * sy,
        y=cr * sp * cy + sr * cp * sy,
        z=cr * cp * sy - sr * sp * cy,
        w=cr * cp * cy + sr * sp * sy,
    )
