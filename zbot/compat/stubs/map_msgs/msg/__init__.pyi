# Written by python -m zbot.interfaces.stubs; do not edit.
from array import array
from collections.abc import Collection
from typing import Final, TypeAlias

import numpy
from numpy.typing import NDArray

import nav_msgs.msg
import sensor_msgs.msg
import std_msgs.msg
from zbot.interfaces import Action, Message, Service

class OccupancyGridUpdate(Message):
    """map_msgs/msg/OccupancyGridUpdate

    # New values for a rectangle of a map.

    std_msgs/Header header
    int32 x  # cells, of the first column
    int32 y  # cells, of the first row
    uint32 width  # cells
    uint32 height  # cells
    int8[] data  # row by row
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., x: int = ..., y: int = ..., width: int = ..., height: int = ..., data: Collection[int] = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    x: int
    y: int
    width: int
    height: int
    @property
    def data(self) -> array[int]: ...
    @data.setter
    def data(self, value: Collection[int]) -> None: ...

class PointCloud2Update(Message):
    """map_msgs/msg/PointCloud2Update

    # Points to add to a cloud, or to remove from it.

    uint32 ADD=0
    uint32 DELETE=1
    std_msgs/Header header
    uint32 type  # ADD or DELETE
    sensor_msgs/PointCloud2 points
    """
    ADD: Final = 0
    DELETE: Final = 1
    def __init__(self, *, header: std_msgs.msg.Header = ..., type: int = ..., points: sensor_msgs.msg.PointCloud2 = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    type: int
    points: sensor_msgs.msg.PointCloud2

class ProjectedMap(Message):
    """map_msgs/msg/ProjectedMap

    # A flat map of everything between two heights.

    nav_msgs/OccupancyGrid map
    float64 min_z  # m
    float64 max_z  # m
    """
    def __init__(self, *, map: nav_msgs.msg.OccupancyGrid = ..., min_z: float = ..., max_z: float = ..., check_fields: bool = ...) -> None: ...
    map: nav_msgs.msg.OccupancyGrid
    min_z: float
    max_z: float

class ProjectedMapInfo(Message):
    """map_msgs/msg/ProjectedMapInfo

    # A rectangle of the floor and two heights.

    string frame_id
    float64 x  # m, of the corner
    float64 y  # m
    float64 width  # m
    float64 height  # m
    float64 min_z  # m
    float64 max_z  # m
    """
    def __init__(self, *, frame_id: str = ..., x: float = ..., y: float = ..., width: float = ..., height: float = ..., min_z: float = ..., max_z: float = ..., check_fields: bool = ...) -> None: ...
    frame_id: str
    x: float
    y: float
    width: float
    height: float
    min_z: float
    max_z: float
