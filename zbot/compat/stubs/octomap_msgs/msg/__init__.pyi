# Written by python -m zbot.interfaces.stubs; do not edit.
from array import array
from collections.abc import Collection
from typing import Final, TypeAlias

import numpy
from numpy.typing import NDArray

import geometry_msgs.msg
import octomap_msgs.msg
import std_msgs.msg
from zbot.interfaces import Action, Message, Service

class Octomap(Message):
    """octomap_msgs/msg/Octomap

    # A map in three dimensions, as OctoMap writes it.

    std_msgs/Header header
    bool binary  # each cell is free or occupied, without a probability
    string id  # class of the map, e.g. OcTree
    float64 resolution  # m, length of the smallest cells
    int8[] data
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., binary: bool = ..., id: str = ..., resolution: float = ..., data: Collection[int] = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    binary: bool
    id: str
    resolution: float
    @property
    def data(self) -> array[int]: ...
    @data.setter
    def data(self, value: Collection[int]) -> None: ...

class OctomapWithPose(Message):
    """octomap_msgs/msg/OctomapWithPose

    # A map in three dimensions, and where its origin is.

    std_msgs/Header header
    geometry_msgs/Pose origin
    octomap_msgs/Octomap octomap
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., origin: geometry_msgs.msg.Pose = ..., octomap: octomap_msgs.msg.Octomap = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    origin: geometry_msgs.msg.Pose
    octomap: octomap_msgs.msg.Octomap
