# Written by python -m zbot.interfaces.stubs; do not edit.
from array import array
from collections.abc import Collection
from typing import Final, TypeAlias

import numpy
from numpy.typing import NDArray

import geographic_msgs.msg
import geometry_msgs.msg
import std_msgs.msg
from zbot.interfaces import Action, Message, Service

class GeoPath(Message):
    """geographic_msgs/msg/GeoPath

    # A way over the earth.

    std_msgs/Header header
    GeoPoseStamped[] poses
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., poses: Collection[geographic_msgs.msg.GeoPoseStamped] = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    @property
    def poses(self) -> list[geographic_msgs.msg.GeoPoseStamped]: ...
    @poses.setter
    def poses(self, value: Collection[geographic_msgs.msg.GeoPoseStamped]) -> None: ...

class GeoPoint(Message):
    """geographic_msgs/msg/GeoPoint

    # A place on the earth, in WGS 84.

    float64 latitude   # degrees, north is positive
    float64 longitude  # degrees, east is positive
    float64 altitude   # m above the ellipsoid; NaN: not known
    """
    def __init__(self, *, latitude: float = ..., longitude: float = ..., altitude: float = ..., check_fields: bool = ...) -> None: ...
    latitude: float
    longitude: float
    altitude: float

class GeoPointStamped(Message):
    """geographic_msgs/msg/GeoPointStamped

    # A place on the earth at a time.

    std_msgs/Header header
    GeoPoint position
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., position: geographic_msgs.msg.GeoPoint = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    position: geographic_msgs.msg.GeoPoint

class GeoPose(Message):
    """geographic_msgs/msg/GeoPose

    # Where something on the earth is and how it is turned.

    GeoPoint position
    geometry_msgs/Quaternion orientation  # from east, north and up
    """
    def __init__(self, *, position: geographic_msgs.msg.GeoPoint = ..., orientation: geometry_msgs.msg.Quaternion = ..., check_fields: bool = ...) -> None: ...
    position: geographic_msgs.msg.GeoPoint
    orientation: geometry_msgs.msg.Quaternion

class GeoPoseStamped(Message):
    """geographic_msgs/msg/GeoPoseStamped

    # Where something on the earth is and how it is turned, at a time.

    std_msgs/Header header
    GeoPose pose
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., pose: geographic_msgs.msg.GeoPose = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    pose: geographic_msgs.msg.GeoPose

class GeoPoseWithCovariance(Message):
    """geographic_msgs/msg/GeoPoseWithCovariance

    # Where something on the earth is and how it is turned, as far as that is known.

    GeoPose pose
    float64[36] covariance  # rows of: latitude, longitude, altitude, about east, north and up
    """
    def __init__(self, *, pose: geographic_msgs.msg.GeoPose = ..., covariance: Collection[float] = ..., check_fields: bool = ...) -> None: ...
    pose: geographic_msgs.msg.GeoPose
    @property
    def covariance(self) -> NDArray[numpy.float64]: ...
    @covariance.setter
    def covariance(self, value: Collection[float]) -> None: ...

class GeoPoseWithCovarianceStamped(Message):
    """geographic_msgs/msg/GeoPoseWithCovarianceStamped

    # Where something on the earth is and how it is turned at a time, as far as that is known.

    std_msgs/Header header
    GeoPoseWithCovariance pose
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., pose: geographic_msgs.msg.GeoPoseWithCovariance = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    pose: geographic_msgs.msg.GeoPoseWithCovariance
