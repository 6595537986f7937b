# Written by python -m zbot.interfaces.stubs; do not edit.
from array import array
from collections.abc import Collection
from typing import Final, TypeAlias

import numpy
from numpy.typing import NDArray

import geographic_msgs.msg
import geometry_msgs.msg
import std_msgs.msg
import unique_identifier_msgs.msg
from zbot.interfaces import Action, Message, Service

class BoundingBox(Message):
    """geographic_msgs/msg/BoundingBox

    GeoPoint min_pt
    GeoPoint max_pt
    """
    def __init__(self, *, min_pt: geographic_msgs.msg.GeoPoint = ..., max_pt: geographic_msgs.msg.GeoPoint = ..., check_fields: bool = ...) -> None: ...
    min_pt: geographic_msgs.msg.GeoPoint
    max_pt: geographic_msgs.msg.GeoPoint

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

class GeographicMap(Message):
    """geographic_msgs/msg/GeographicMap

    std_msgs/Header header
    unique_identifier_msgs/UUID id
    BoundingBox bounds
    WayPoint[] points
    MapFeature[] features
    KeyValue[] props
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., id: unique_identifier_msgs.msg.UUID = ..., bounds: geographic_msgs.msg.BoundingBox = ..., points: Collection[geographic_msgs.msg.WayPoint] = ..., features: Collection[geographic_msgs.msg.MapFeature] = ..., props: Collection[geographic_msgs.msg.KeyValue] = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    id: unique_identifier_msgs.msg.UUID
    bounds: geographic_msgs.msg.BoundingBox
    @property
    def points(self) -> list[geographic_msgs.msg.WayPoint]: ...
    @points.setter
    def points(self, value: Collection[geographic_msgs.msg.WayPoint]) -> None: ...
    @property
    def features(self) -> list[geographic_msgs.msg.MapFeature]: ...
    @features.setter
    def features(self, value: Collection[geographic_msgs.msg.MapFeature]) -> None: ...
    @property
    def props(self) -> list[geographic_msgs.msg.KeyValue]: ...
    @props.setter
    def props(self, value: Collection[geographic_msgs.msg.KeyValue]) -> None: ...

class GeographicMapChanges(Message):
    """geographic_msgs/msg/GeographicMapChanges

    std_msgs/Header header
    GeographicMap diffs
    unique_identifier_msgs/UUID[] deletes
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., diffs: geographic_msgs.msg.GeographicMap = ..., deletes: Collection[unique_identifier_msgs.msg.UUID] = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    diffs: geographic_msgs.msg.GeographicMap
    @property
    def deletes(self) -> list[unique_identifier_msgs.msg.UUID]: ...
    @deletes.setter
    def deletes(self, value: Collection[unique_identifier_msgs.msg.UUID]) -> None: ...

class KeyValue(Message):
    """geographic_msgs/msg/KeyValue

    string key
    string value
    """
    def __init__(self, *, key: str = ..., value: str = ..., check_fields: bool = ...) -> None: ...
    key: str
    value: str

class MapFeature(Message):
    """geographic_msgs/msg/MapFeature

    unique_identifier_msgs/UUID id
    unique_identifier_msgs/UUID[] components
    KeyValue[] props
    """
    def __init__(self, *, id: unique_identifier_msgs.msg.UUID = ..., components: Collection[unique_identifier_msgs.msg.UUID] = ..., props: Collection[geographic_msgs.msg.KeyValue] = ..., check_fields: bool = ...) -> None: ...
    id: unique_identifier_msgs.msg.UUID
    @property
    def components(self) -> list[unique_identifier_msgs.msg.UUID]: ...
    @components.setter
    def components(self, value: Collection[unique_identifier_msgs.msg.UUID]) -> None: ...
    @property
    def props(self) -> list[geographic_msgs.msg.KeyValue]: ...
    @props.setter
    def props(self, value: Collection[geographic_msgs.msg.KeyValue]) -> None: ...

class RouteNetwork(Message):
    """geographic_msgs/msg/RouteNetwork

    std_msgs/Header header
    unique_identifier_msgs/UUID id
    BoundingBox bounds
    WayPoint[] points
    RouteSegment[] segments
    KeyValue[] props
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., id: unique_identifier_msgs.msg.UUID = ..., bounds: geographic_msgs.msg.BoundingBox = ..., points: Collection[geographic_msgs.msg.WayPoint] = ..., segments: Collection[geographic_msgs.msg.RouteSegment] = ..., props: Collection[geographic_msgs.msg.KeyValue] = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    id: unique_identifier_msgs.msg.UUID
    bounds: geographic_msgs.msg.BoundingBox
    @property
    def points(self) -> list[geographic_msgs.msg.WayPoint]: ...
    @points.setter
    def points(self, value: Collection[geographic_msgs.msg.WayPoint]) -> None: ...
    @property
    def segments(self) -> list[geographic_msgs.msg.RouteSegment]: ...
    @segments.setter
    def segments(self, value: Collection[geographic_msgs.msg.RouteSegment]) -> None: ...
    @property
    def props(self) -> list[geographic_msgs.msg.KeyValue]: ...
    @props.setter
    def props(self, value: Collection[geographic_msgs.msg.KeyValue]) -> None: ...

class RoutePath(Message):
    """geographic_msgs/msg/RoutePath

    std_msgs/Header header
    unique_identifier_msgs/UUID network
    unique_identifier_msgs/UUID[] segments
    KeyValue[] props
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., network: unique_identifier_msgs.msg.UUID = ..., segments: Collection[unique_identifier_msgs.msg.UUID] = ..., props: Collection[geographic_msgs.msg.KeyValue] = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    network: unique_identifier_msgs.msg.UUID
    @property
    def segments(self) -> list[unique_identifier_msgs.msg.UUID]: ...
    @segments.setter
    def segments(self, value: Collection[unique_identifier_msgs.msg.UUID]) -> None: ...
    @property
    def props(self) -> list[geographic_msgs.msg.KeyValue]: ...
    @props.setter
    def props(self, value: Collection[geographic_msgs.msg.KeyValue]) -> None: ...

class RouteSegment(Message):
    """geographic_msgs/msg/RouteSegment

    unique_identifier_msgs/UUID id
    unique_identifier_msgs/UUID start
    unique_identifier_msgs/UUID end
    KeyValue[] props
    """
    def __init__(self, *, id: unique_identifier_msgs.msg.UUID = ..., start: unique_identifier_msgs.msg.UUID = ..., end: unique_identifier_msgs.msg.UUID = ..., props: Collection[geographic_msgs.msg.KeyValue] = ..., check_fields: bool = ...) -> None: ...
    id: unique_identifier_msgs.msg.UUID
    start: unique_identifier_msgs.msg.UUID
    end: unique_identifier_msgs.msg.UUID
    @property
    def props(self) -> list[geographic_msgs.msg.KeyValue]: ...
    @props.setter
    def props(self, value: Collection[geographic_msgs.msg.KeyValue]) -> None: ...

class WayPoint(Message):
    """geographic_msgs/msg/WayPoint

    unique_identifier_msgs/UUID id
    GeoPoint position
    KeyValue[] props
    """
    def __init__(self, *, id: unique_identifier_msgs.msg.UUID = ..., position: geographic_msgs.msg.GeoPoint = ..., props: Collection[geographic_msgs.msg.KeyValue] = ..., check_fields: bool = ...) -> None: ...
    id: unique_identifier_msgs.msg.UUID
    position: geographic_msgs.msg.GeoPoint
    @property
    def props(self) -> list[geographic_msgs.msg.KeyValue]: ...
    @props.setter
    def props(self, value: Collection[geographic_msgs.msg.KeyValue]) -> None: ...
