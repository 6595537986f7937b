# Written by python -m zbot.interfaces.stubs; do not edit.
from array import array
from collections.abc import Collection
from typing import Final, TypeAlias

import numpy
from numpy.typing import NDArray

import builtin_interfaces.msg
import geometry_msgs.msg
import nav_msgs.msg
import std_msgs.msg
from zbot.interfaces import Action, Message, Service

class Goals(Message):
    """nav_msgs/msg/Goals

    # Places to visit, in this order.

    # When the list was made, and the frame of goals that name none.
    std_msgs/Header header

    # The places. Each has its own time and frame, so a goal may ride on something that moves.
    geometry_msgs/PoseStamped[] goals
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., goals: Collection[geometry_msgs.msg.PoseStamped] = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    @property
    def goals(self) -> list[geometry_msgs.msg.PoseStamped]: ...
    @goals.setter
    def goals(self, value: Collection[geometry_msgs.msg.PoseStamped]) -> None: ...

class GridCells(Message):
    """nav_msgs/msg/GridCells

    # Some cells of a grid, to be drawn or avoided.

    std_msgs/Header header

    # Size along x in m.
    float32 cell_width

    # Size along y in m.
    float32 cell_height

    # Centre of each cell.
    geometry_msgs/Point[] cells
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., cell_width: float = ..., cell_height: float = ..., cells: Collection[geometry_msgs.msg.Point] = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    cell_width: float
    cell_height: float
    @property
    def cells(self) -> list[geometry_msgs.msg.Point]: ...
    @cells.setter
    def cells(self, value: Collection[geometry_msgs.msg.Point]) -> None: ...

class MapMetaData(Message):
    """nav_msgs/msg/MapMetaData

    # Size and place of an OccupancyGrid.

    # When the map was loaded.
    builtin_interfaces/Time map_load_time

    # Edge of a cell in m.
    float32 resolution

    # Cells along x.
    uint32 width

    # Cells along y.
    uint32 height

    # Where in the world the outer corner of cell (0, 0) is, and which way the x axis of the grid points.
    geometry_msgs/Pose origin
    """
    def __init__(self, *, map_load_time: builtin_interfaces.msg.Time = ..., resolution: float = ..., width: int = ..., height: int = ..., origin: geometry_msgs.msg.Pose = ..., check_fields: bool = ...) -> None: ...
    map_load_time: builtin_interfaces.msg.Time
    resolution: float
    width: int
    height: int
    origin: geometry_msgs.msg.Pose

class OccupancyGrid(Message):
    """nav_msgs/msg/OccupancyGrid

    # A map of square cells seen from above: free, occupied or not known.

    std_msgs/Header header

    # Size and place of the grid.
    MapMetaData info

    # Cell (x, y) is data[y * info.width + x]: 0 is surely free, 100 surely occupied, -1 not known.
    int8[] data
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., info: nav_msgs.msg.MapMetaData = ..., data: Collection[int] = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    info: nav_msgs.msg.MapMetaData
    @property
    def data(self) -> array[int]: ...
    @data.setter
    def data(self, value: Collection[int]) -> None: ...

class Odometry(Message):
    """nav_msgs/msg/Odometry

    # Where a robot believes it is and how fast it moves, worked out from its wheels or other sensors.

    # Time of the estimate, and the frame in which the pose is given, usually 'odom'.
    std_msgs/Header header

    # Frame of the robot, usually 'base_link'; the twist is given along its axes.
    string child_frame_id

    # Place of the robot in header.frame_id.
    geometry_msgs/PoseWithCovariance pose

    # Speed of the robot as seen from itself: linear.x is forward.
    geometry_msgs/TwistWithCovariance twist
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., child_frame_id: str = ..., pose: geometry_msgs.msg.PoseWithCovariance = ..., twist: geometry_msgs.msg.TwistWithCovariance = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    child_frame_id: str
    pose: geometry_msgs.msg.PoseWithCovariance
    twist: geometry_msgs.msg.TwistWithCovariance

class Path(Message):
    """nav_msgs/msg/Path

    # A way for a robot to drive, from pose to pose.

    # When it was planned and in which frame.
    std_msgs/Header header

    # The poses along the way.
    geometry_msgs/PoseStamped[] poses
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., poses: Collection[geometry_msgs.msg.PoseStamped] = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    @property
    def poses(self) -> list[geometry_msgs.msg.PoseStamped]: ...
    @poses.setter
    def poses(self, value: Collection[geometry_msgs.msg.PoseStamped]) -> None: ...
