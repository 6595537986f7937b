from __future__ import annotations

import math
from typing import Any

import pytest

from zbot.libraries.navigation.costmap import (
    LETHAL_OBSTACLE,
    FootprintCollisionChecker,
    LineIterator,
    PyCostmap2D,
    PyOccupancyGrid,
    euler_to_quaternion,
)

from geometry_msgs.msg import Point32, Polygon
from nav2_msgs.msg import Costmap
from nav_msgs.msg import OccupancyGrid


@pytest.fixture
def costmap() -> PyCostmap2D:
    """Return 4 columns and 3 rows of half a metre, with the origin at (-1, -1)."""
    message = Costmap(data=[0] * 12)
    message.metadata.size_x, message.metadata.size_y = 4, 3
    message.metadata.resolution = 0.5
    message.metadata.origin.position.x = message.metadata.origin.position.y = -1.0
    return PyCostmap2D(message)


def test_cells_are_found_by_place_and_by_index(costmap: PyCostmap2D) -> None:
    costmap.setCost(2, 1, 255)
    assert (costmap.getCostXY(2, 1), costmap.getCostIdx(6)) == (255, 255)
    assert costmap.getCostXY(2, 1).dtype == "uint8"
    assert costmap.mapToWorld(2, 1) == (0.25, -0.25)
    assert costmap.worldToMapValidated(0.25, -0.25) == (2, 1)
    assert (costmap.getSizeInMetersX(), costmap.getSizeInMetersY()) == (2.0, 1.5)


@pytest.mark.parametrize("place", [(-1.01, 0.0), (0.0, -1.01), (1.0, 0.0), (0.0, 0.5)])
def test_places_outside_have_no_cell(costmap: PyCostmap2D, place: tuple[float, float]) -> None:
    assert costmap.worldToMapValidated(*place) == (None, None)


def test_a_map_has_unknown_cells() -> None:
    message = OccupancyGrid(data=[-1, 100])
    message.info.width, message.info.height, message.info.resolution = 2, 1, 1.0
    grid = PyOccupancyGrid(message)
    assert (grid.getCostXY(0, 0), grid.getCostXY(1, 0)) == (-1, 100)


@pytest.mark.parametrize(
    ("line", "points"),
    [
        ((0, 0, 2, 4), [(0, 0), (1, 2), (2, 4)]),
        ((2, 0, 0, 1), [(2, 0), (1, 0.5), (0, 1)]),
        ((1, 3, 1, 1), [(1, 3), (1, 2), (1, 1)]),
        ((0, 0, 1.5, 0), [(0, 0), (1, 0), (1.5, 0)]),
        ((0, 0, 3, 1), [(0, 0), (1, 0.33333), (2, 0.66667), (3, 1)]),
    ],
)
def test_a_line_has_points_up_to_its_end(line: Any, points: list[tuple[float, float]]) -> None:
    iterator, found = LineIterator(*line), []
    while iterator.isValid():
        found.append((iterator.getX(), iterator.getY()))
        iterator.advance()
    assert found == points
    assert iterator.get_line_length() == pytest.approx(math.dist(points[0], points[-1]))


@pytest.mark.parametrize(
    ("line", "error"),
    [
        ((0, 0, "2", 1), TypeError),
        ((0, 0, 2, 1, -1), ValueError),
        ((3, 3, 3, 3), ValueError),
    ],
)
def test_a_line_needs_two_points(line: Any, error: type[Exception]) -> None:
    with pytest.raises(error):
        LineIterator(*line)


def square(half: float) -> Polygon:
    corners = ((-half, -half), (half, -half), (half, half), (-half, half))
    return Polygon(points=[Point32(x=x, y=y) for x, y in corners])


def test_the_highest_cost_on_an_outline_counts(costmap: PyCostmap2D) -> None:
    checker = FootprintCollisionChecker()
    with pytest.raises(ValueError, match="setCostmap"):
        checker.footprintCost(square(0.4))
    checker.setCostmap(costmap)
    costmap.setCost(2, 1, 80)
    assert checker.footprintCost(square(0.4)) == 80
    assert checker.footprintCostAtPose(-0.55, -0.55, math.pi / 4, square(0.1)) == 0
    costmap.setCost(1, 1, LETHAL_OBSTACLE)
    assert checker.footprintCost(square(0.4)) == LETHAL_OBSTACLE
    assert checker.footprintCost(square(5.0)) == LETHAL_OBSTACLE


def test_an_outline_smaller_than_a_cell_has_the_cost_of_the_cell(costmap: PyCostmap2D) -> None:
    checker = FootprintCollisionChecker()
    checker.setCostmap(costmap)
    costmap.setCost(2, 1, 7)
    assert checker.footprintCostAtPose(0.25, -0.25, 0.0, square(0.01)) == 7


def test_a_rotation_about_z_is_a_quaternion() -> None:
    turned = euler_to_quaternion(yaw=math.pi)
    assert (turned.x, turned.y, turned.z, turned.w) == pytest.approx((0, 0, 1, 0), abs=1e-9)
