# Written by python -m zbot.interfaces.stubs; do not edit.
from array import array
from collections.abc import Collection
from typing import Final, TypeAlias

import numpy
from numpy.typing import NDArray

import geometry_msgs.msg
import object_recognition_msgs.msg
import sensor_msgs.msg
import shape_msgs.msg
import std_msgs.msg
from zbot.interfaces import Action, Message, Service

class ObjectInformation(Message):
    """object_recognition_msgs/msg/ObjectInformation

    # What is known about a type of object.

    string name
    shape_msgs/Mesh ground_truth_mesh
    sensor_msgs/PointCloud2 ground_truth_point_cloud
    """
    def __init__(self, *, name: str = ..., ground_truth_mesh: shape_msgs.msg.Mesh = ..., ground_truth_point_cloud: sensor_msgs.msg.PointCloud2 = ..., check_fields: bool = ...) -> None: ...
    name: str
    ground_truth_mesh: shape_msgs.msg.Mesh
    ground_truth_point_cloud: sensor_msgs.msg.PointCloud2

class ObjectType(Message):
    """object_recognition_msgs/msg/ObjectType

    # A type of object in a database.

    string key  # unique in the database
    string db  # how to reach the database, as JSON
    """
    def __init__(self, *, key: str = ..., db: str = ..., check_fields: bool = ...) -> None: ...
    key: str
    db: str

class RecognizedObject(Message):
    """object_recognition_msgs/msg/RecognizedObject

    # An object that was found, and where it is.

    std_msgs/Header header
    object_recognition_msgs/ObjectType type
    float32 confidence  # 0.0 to 1.0
    sensor_msgs/PointCloud2[] point_clouds
    shape_msgs/Mesh bounding_mesh
    geometry_msgs/Point[] bounding_contours
    geometry_msgs/PoseWithCovarianceStamped pose
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., type: object_recognition_msgs.msg.ObjectType = ..., confidence: float = ..., point_clouds: Collection[sensor_msgs.msg.PointCloud2] = ..., bounding_mesh: shape_msgs.msg.Mesh = ..., bounding_contours: Collection[geometry_msgs.msg.Point] = ..., pose: geometry_msgs.msg.PoseWithCovarianceStamped = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    type: object_recognition_msgs.msg.ObjectType
    confidence: float
    @property
    def point_clouds(self) -> list[sensor_msgs.msg.PointCloud2]: ...
    @point_clouds.setter
    def point_clouds(self, value: Collection[sensor_msgs.msg.PointCloud2]) -> None: ...
    bounding_mesh: shape_msgs.msg.Mesh
    @property
    def bounding_contours(self) -> list[geometry_msgs.msg.Point]: ...
    @bounding_contours.setter
    def bounding_contours(self, value: Collection[geometry_msgs.msg.Point]) -> None: ...
    pose: geometry_msgs.msg.PoseWithCovarianceStamped

class RecognizedObjectArray(Message):
    """object_recognition_msgs/msg/RecognizedObjectArray

    # Objects that were found.

    std_msgs/Header header
    object_recognition_msgs/RecognizedObject[] objects
    float32[] cooccurrence  # how well each object fits to each other one
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., objects: Collection[object_recognition_msgs.msg.RecognizedObject] = ..., cooccurrence: Collection[float] = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    @property
    def objects(self) -> list[object_recognition_msgs.msg.RecognizedObject]: ...
    @objects.setter
    def objects(self, value: Collection[object_recognition_msgs.msg.RecognizedObject]) -> None: ...
    @property
    def cooccurrence(self) -> array[float]: ...
    @cooccurrence.setter
    def cooccurrence(self, value: Collection[float]) -> None: ...

class Table(Message):
    """object_recognition_msgs/msg/Table

    # A flat surface that objects can stand on.

    std_msgs/Header header
    geometry_msgs/Pose pose  # the z axis points up from the surface
    geometry_msgs/Point[] convex_hull  # m, in the frame of the pose
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., pose: geometry_msgs.msg.Pose = ..., convex_hull: Collection[geometry_msgs.msg.Point] = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    pose: geometry_msgs.msg.Pose
    @property
    def convex_hull(self) -> list[geometry_msgs.msg.Point]: ...
    @convex_hull.setter
    def convex_hull(self, value: Collection[geometry_msgs.msg.Point]) -> None: ...

class TableArray(Message):
    """object_recognition_msgs/msg/TableArray

    # Flat surfaces that were found.

    std_msgs/Header header
    object_recognition_msgs/Table[] tables
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., tables: Collection[object_recognition_msgs.msg.Table] = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    @property
    def tables(self) -> list[object_recognition_msgs.msg.Table]: ...
    @tables.setter
    def tables(self, value: Collection[object_recognition_msgs.msg.Table]) -> None: ...
