# Written by python -m zbot.interfaces.stubs; do not edit.
from array import array
from collections.abc import Collection
from typing import Final, TypeAlias

import numpy
from numpy.typing import NDArray

import pcl_msgs.msg
import sensor_msgs.msg
import std_msgs.msg
from zbot.interfaces import Action, Message, Service

class ModelCoefficients(Message):
    """pcl_msgs/msg/ModelCoefficients

    std_msgs/Header header
    float32[] values
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., values: Collection[float] = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    @property
    def values(self) -> array[float]: ...
    @values.setter
    def values(self, value: Collection[float]) -> None: ...

class PointIndices(Message):
    """pcl_msgs/msg/PointIndices

    std_msgs/Header header
    int32[] indices
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., indices: Collection[int] = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    @property
    def indices(self) -> array[int]: ...
    @indices.setter
    def indices(self, value: Collection[int]) -> None: ...

class PolygonMesh(Message):
    """pcl_msgs/msg/PolygonMesh

    std_msgs/Header header
    sensor_msgs/PointCloud2 cloud
    Vertices[] polygons
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., cloud: sensor_msgs.msg.PointCloud2 = ..., polygons: Collection[pcl_msgs.msg.Vertices] = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    cloud: sensor_msgs.msg.PointCloud2
    @property
    def polygons(self) -> list[pcl_msgs.msg.Vertices]: ...
    @polygons.setter
    def polygons(self, value: Collection[pcl_msgs.msg.Vertices]) -> None: ...

class Vertices(Message):
    """pcl_msgs/msg/Vertices

    uint32[] vertices
    """
    def __init__(self, *, vertices: Collection[int] = ..., check_fields: bool = ...) -> None: ...
    @property
    def vertices(self) -> array[int]: ...
    @vertices.setter
    def vertices(self, value: Collection[int]) -> None: ...
