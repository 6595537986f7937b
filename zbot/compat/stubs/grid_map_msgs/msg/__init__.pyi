# Written by python -m zbot.interfaces.stubs; do not edit.
from array import array
from collections.abc import Collection
from typing import Final, TypeAlias

import numpy
from numpy.typing import NDArray

import geometry_msgs.msg
import grid_map_msgs.msg
import std_msgs.msg
from zbot.interfaces import Action, Message, Service

class GridMap(Message):
    """grid_map_msgs/msg/GridMap

    std_msgs/Header header
    GridMapInfo info
    string[] layers
    string[] basic_layers
    std_msgs/Float32MultiArray[] data
    uint16 outer_start_index
    uint16 inner_start_index
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., info: grid_map_msgs.msg.GridMapInfo = ..., layers: Collection[str] = ..., basic_layers: Collection[str] = ..., data: Collection[std_msgs.msg.Float32MultiArray] = ..., outer_start_index: int = ..., inner_start_index: int = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    info: grid_map_msgs.msg.GridMapInfo
    @property
    def layers(self) -> list[str]: ...
    @layers.setter
    def layers(self, value: Collection[str]) -> None: ...
    @property
    def basic_layers(self) -> list[str]: ...
    @basic_layers.setter
    def basic_layers(self, value: Collection[str]) -> None: ...
    @property
    def data(self) -> list[std_msgs.msg.Float32MultiArray]: ...
    @data.setter
    def data(self, value: Collection[std_msgs.msg.Float32MultiArray]) -> None: ...
    outer_start_index: int
    inner_start_index: int

class GridMapInfo(Message):
    """grid_map_msgs/msg/GridMapInfo

    float64 resolution
    float64 length_x
    float64 length_y
    geometry_msgs/Pose pose
    """
    def __init__(self, *, resolution: float = ..., length_x: float = ..., length_y: float = ..., pose: geometry_msgs.msg.Pose = ..., check_fields: bool = ...) -> None: ...
    resolution: float
    length_x: float
    length_y: float
    pose: geometry_msgs.msg.Pose
