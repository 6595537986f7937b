"""Displays of the 3D view, one module for each. They have the names that they have in rviz."""

from __future__ import annotations

from typing import TYPE_CHECKING

from zbot.view.displays.grid import Axes, Grid
from zbot.view.displays.grid_cells import GridCells
from zbot.view.displays.image import Image
from zbot.view.displays.interactive_markers import InteractiveMarkers
from zbot.view.displays.laser_scan import LaserScan
from zbot.view.displays.map import Map
from zbot.view.displays.marker import Marker, MarkerArray
from zbot.view.displays.path import Path
from zbot.view.displays.point_cloud import PointCloud2
from zbot.view.displays.polygon import Polygon
from zbot.view.displays.pose import (
    Odometry,
    ParticleCloud,
    Pose,
    PoseArray,
    PoseWithCovariance,
)
from zbot.view.displays.range import Range
from zbot.view.displays.robot_model import RobotModel
from zbot.view.displays.text import Text
from zbot.view.displays.tf import TF
from zbot.view.displays.vectors import Accel, PointStamped, Twist, Wrench

if TYPE_CHECKING:
    from zbot.view.displays.display import Display

#: All displays, in the order of the list beside the scene.
DISPLAYS: tuple[type[Display], ...] = (
    TF,
    RobotModel,
    LaserScan,
    PointCloud2,
    Map,
    Image,
    Odometry,
    Path,
    Pose,
    PoseArray,
    ParticleCloud,
    PoseWithCovariance,
    Marker,
    MarkerArray,
    InteractiveMarkers,
    Polygon,
    Range,
    GridCells,
    Wrench,
    Twist,
    Accel,
    PointStamped,
    Text,
    Grid,
    Axes,
)
_BY_TYPE = {type_name: display for display in DISPLAYS for type_name in display.types}
_DESCRIPTION = "robot_description"


def display_for(topic: str, type_name: str) -> type[Display] | None:
    """Return the display of a topic, or None if its messages cannot be drawn."""
    found = _BY_TYPE.get(type_name)
    if found is RobotModel and topic.rpartition("/")[2] != _DESCRIPTION:
        return None  # any other text
    return found
