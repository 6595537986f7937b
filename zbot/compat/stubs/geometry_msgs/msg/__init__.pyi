# Written by python -m zbot.interfaces.stubs; do not edit.
from array import array
from collections.abc import Collection
from typing import Final, TypeAlias

import numpy
from numpy.typing import NDArray

import geometry_msgs.msg
import std_msgs.msg
from zbot.interfaces import Action, Message, Service

class Accel(Message):
    """geometry_msgs/msg/Accel

    # Acceleration in free space: linear in m/s^2, angular in rad/s^2 about each axis.

    Vector3  linear
    Vector3  angular
    """
    def __init__(self, *, linear: geometry_msgs.msg.Vector3 = ..., angular: geometry_msgs.msg.Vector3 = ..., check_fields: bool = ...) -> None: ...
    linear: geometry_msgs.msg.Vector3
    angular: geometry_msgs.msg.Vector3

class AccelStamped(Message):
    """geometry_msgs/msg/AccelStamped

    # An acceleration with its moment and coordinate frame.

    std_msgs/Header header
    Accel accel
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., accel: geometry_msgs.msg.Accel = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    accel: geometry_msgs.msg.Accel

class AccelWithCovariance(Message):
    """geometry_msgs/msg/AccelWithCovariance

    # An acceleration together with how far it can be trusted.

    Accel accel

    # 6x6 covariance, row by row. Rows and columns: linear x, y, z, then angular about x, y, z.
    float64[36] covariance
    """
    def __init__(self, *, accel: geometry_msgs.msg.Accel = ..., covariance: Collection[float] = ..., check_fields: bool = ...) -> None: ...
    accel: geometry_msgs.msg.Accel
    @property
    def covariance(self) -> NDArray[numpy.float64]: ...
    @covariance.setter
    def covariance(self, value: Collection[float]) -> None: ...

class AccelWithCovarianceStamped(Message):
    """geometry_msgs/msg/AccelWithCovarianceStamped

    # An estimated acceleration with its uncertainty, moment and coordinate frame.

    std_msgs/Header header
    AccelWithCovariance accel
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., accel: geometry_msgs.msg.AccelWithCovariance = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    accel: geometry_msgs.msg.AccelWithCovariance

class Inertia(Message):
    """geometry_msgs/msg/Inertia

    # How heavy a body is and how its mass is spread out.

    # Mass in kg.
    float64 m

    # Centre of mass in m.
    geometry_msgs/Vector3 com

    # Moments of inertia in kg*m^2. The tensor is symmetric, so six numbers describe it:
    #   ixx ixy ixz
    #   ixy iyy iyz
    #   ixz iyz izz
    float64 ixx
    float64 ixy
    float64 ixz
    float64 iyy
    float64 iyz
    float64 izz
    """
    def __init__(self, *, m: float = ..., com: geometry_msgs.msg.Vector3 = ..., ixx: float = ..., ixy: float = ..., ixz: float = ..., iyy: float = ..., iyz: float = ..., izz: float = ..., check_fields: bool = ...) -> None: ...
    m: float
    com: geometry_msgs.msg.Vector3
    ixx: float
    ixy: float
    ixz: float
    iyy: float
    iyz: float
    izz: float

class InertiaStamped(Message):
    """geometry_msgs/msg/InertiaStamped

    # The inertia of a body with its moment and coordinate frame.

    std_msgs/Header header
    Inertia inertia
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., inertia: geometry_msgs.msg.Inertia = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    inertia: geometry_msgs.msg.Inertia

class Point(Message):
    """geometry_msgs/msg/Point

    # A place in space, in m along each axis.

    float64 x
    float64 y
    float64 z
    """
    def __init__(self, *, x: float = ..., y: float = ..., z: float = ..., check_fields: bool = ...) -> None: ...
    x: float
    y: float
    z: float

class Point32(Message):
    """geometry_msgs/msg/Point32

    # A place in space, in m, at half the size of Point. Meant for long lists; prefer Point elsewhere.

    float32 x
    float32 y
    float32 z
    """
    def __init__(self, *, x: float = ..., y: float = ..., z: float = ..., check_fields: bool = ...) -> None: ...
    x: float
    y: float
    z: float

class PointStamped(Message):
    """geometry_msgs/msg/PointStamped

    # A place with its moment and coordinate frame.

    std_msgs/Header header
    Point point
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., point: geometry_msgs.msg.Point = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    point: geometry_msgs.msg.Point

class Polygon(Message):
    """geometry_msgs/msg/Polygon

    # An outline made of corners; the last corner is joined to the first.

    Point32[] points
    """
    def __init__(self, *, points: Collection[geometry_msgs.msg.Point32] = ..., check_fields: bool = ...) -> None: ...
    @property
    def points(self) -> list[geometry_msgs.msg.Point32]: ...
    @points.setter
    def points(self, value: Collection[geometry_msgs.msg.Point32]) -> None: ...

class PolygonInstance(Message):
    """geometry_msgs/msg/PolygonInstance

    # A polygon with a number that tells it from others of the same shape.

    geometry_msgs/Polygon polygon
    int64 id
    """
    def __init__(self, *, polygon: geometry_msgs.msg.Polygon = ..., id: int = ..., check_fields: bool = ...) -> None: ...
    polygon: geometry_msgs.msg.Polygon
    id: int

class PolygonInstanceStamped(Message):
    """geometry_msgs/msg/PolygonInstanceStamped

    # A numbered polygon with its moment and coordinate frame.

    std_msgs/Header header
    geometry_msgs/PolygonInstance polygon
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., polygon: geometry_msgs.msg.PolygonInstance = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    polygon: geometry_msgs.msg.PolygonInstance

class PolygonStamped(Message):
    """geometry_msgs/msg/PolygonStamped

    # A polygon with its moment and coordinate frame.

    std_msgs/Header header
    Polygon polygon
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., polygon: geometry_msgs.msg.Polygon = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    polygon: geometry_msgs.msg.Polygon

class Pose(Message):
    """geometry_msgs/msg/Pose

    # Where something is and which way it faces.

    Point position
    Quaternion orientation
    """
    def __init__(self, *, position: geometry_msgs.msg.Point = ..., orientation: geometry_msgs.msg.Quaternion = ..., check_fields: bool = ...) -> None: ...
    position: geometry_msgs.msg.Point
    orientation: geometry_msgs.msg.Quaternion

class Pose2D(Message):
    """geometry_msgs/msg/Pose2D

    # Position and heading in the plane. Deprecated in ROS 2: new code uses Pose, whose z simply stays 0.

    float64 x # m
    float64 y # m
    float64 theta # heading in rad, counterclockwise from the x axis
    """
    def __init__(self, *, x: float = ..., y: float = ..., theta: float = ..., check_fields: bool = ...) -> None: ...
    x: float
    y: float
    theta: float

class PoseArray(Message):
    """geometry_msgs/msg/PoseArray

    # Several poses that share one moment and coordinate frame.

    std_msgs/Header header

    Pose[] poses
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., poses: Collection[geometry_msgs.msg.Pose] = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    @property
    def poses(self) -> list[geometry_msgs.msg.Pose]: ...
    @poses.setter
    def poses(self, value: Collection[geometry_msgs.msg.Pose]) -> None: ...

class PoseStamped(Message):
    """geometry_msgs/msg/PoseStamped

    # A pose with its moment and coordinate frame; often a goal to drive to.

    std_msgs/Header header
    Pose pose
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., pose: geometry_msgs.msg.Pose = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    pose: geometry_msgs.msg.Pose

class PoseWithCovariance(Message):
    """geometry_msgs/msg/PoseWithCovariance

    # A pose together with how far it can be trusted.

    Pose pose

    # 6x6 covariance, row by row. Rows and columns: position x, y, z, then rotation about x, y, z.
    float64[36] covariance
    """
    def __init__(self, *, pose: geometry_msgs.msg.Pose = ..., covariance: Collection[float] = ..., check_fields: bool = ...) -> None: ...
    pose: geometry_msgs.msg.Pose
    @property
    def covariance(self) -> NDArray[numpy.float64]: ...
    @covariance.setter
    def covariance(self, value: Collection[float]) -> None: ...

class PoseWithCovarianceStamped(Message):
    """geometry_msgs/msg/PoseWithCovarianceStamped

    # An estimated pose with its uncertainty, moment and coordinate frame.

    std_msgs/Header header
    PoseWithCovariance pose
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., pose: geometry_msgs.msg.PoseWithCovariance = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    pose: geometry_msgs.msg.PoseWithCovariance

class Quaternion(Message):
    """geometry_msgs/msg/Quaternion

    # A rotation as a unit quaternion; the default is "not rotated".

    float64 x 0
    float64 y 0
    float64 z 0
    float64 w 1
    """
    def __init__(self, *, x: float = ..., y: float = ..., z: float = ..., w: float = ..., check_fields: bool = ...) -> None: ...
    x: float
    y: float
    z: float
    w: float

class QuaternionStamped(Message):
    """geometry_msgs/msg/QuaternionStamped

    # A rotation with its moment and coordinate frame.

    std_msgs/Header header
    Quaternion quaternion
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., quaternion: geometry_msgs.msg.Quaternion = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    quaternion: geometry_msgs.msg.Quaternion

class Transform(Message):
    """geometry_msgs/msg/Transform

    # How to get from one coordinate frame to another: shift by translation (m), turn by rotation.

    Vector3 translation
    Quaternion rotation
    """
    def __init__(self, *, translation: geometry_msgs.msg.Vector3 = ..., rotation: geometry_msgs.msg.Quaternion = ..., check_fields: bool = ...) -> None: ...
    translation: geometry_msgs.msg.Vector3
    rotation: geometry_msgs.msg.Quaternion

class TransformStamped(Message):
    """geometry_msgs/msg/TransformStamped

    # Where the frame child_frame_id sits inside the frame header.frame_id at the time header.stamp.
    # These messages, sent on /tf and /tf_static, make up the tree of frames that tf2 searches.

    # The parent frame and the time.
    std_msgs/Header header

    # The frame that is being placed.
    string child_frame_id

    # Position and orientation of the child, measured in the parent.
    Transform transform
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., child_frame_id: str = ..., transform: geometry_msgs.msg.Transform = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    child_frame_id: str
    transform: geometry_msgs.msg.Transform

class Twist(Message):
    """geometry_msgs/msg/Twist

    # Velocity in free space: linear in m/s along x, y, z and angular in rad/s about x, y, z.

    Vector3  linear
    Vector3  angular
    """
    def __init__(self, *, linear: geometry_msgs.msg.Vector3 = ..., angular: geometry_msgs.msg.Vector3 = ..., check_fields: bool = ...) -> None: ...
    linear: geometry_msgs.msg.Vector3
    angular: geometry_msgs.msg.Vector3

class TwistStamped(Message):
    """geometry_msgs/msg/TwistStamped

    # A velocity with its moment and coordinate frame.

    std_msgs/Header header
    Twist twist
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., twist: geometry_msgs.msg.Twist = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    twist: geometry_msgs.msg.Twist

class TwistWithCovariance(Message):
    """geometry_msgs/msg/TwistWithCovariance

    # A velocity together with how far it can be trusted.

    Twist twist

    # 6x6 covariance, row by row. Rows and columns: linear x, y, z, then angular about x, y, z.
    float64[36] covariance
    """
    def __init__(self, *, twist: geometry_msgs.msg.Twist = ..., covariance: Collection[float] = ..., check_fields: bool = ...) -> None: ...
    twist: geometry_msgs.msg.Twist
    @property
    def covariance(self) -> NDArray[numpy.float64]: ...
    @covariance.setter
    def covariance(self, value: Collection[float]) -> None: ...

class TwistWithCovarianceStamped(Message):
    """geometry_msgs/msg/TwistWithCovarianceStamped

    # An estimated velocity with its uncertainty, moment and coordinate frame.

    std_msgs/Header header
    TwistWithCovariance twist
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., twist: geometry_msgs.msg.TwistWithCovariance = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    twist: geometry_msgs.msg.TwistWithCovariance

class Vector3(Message):
    """geometry_msgs/msg/Vector3

    # A direction with a length. Unlike a Point it has no place:
    # expressing it in another frame turns it, never shifts it.

    float64 x
    float64 y
    float64 z
    """
    def __init__(self, *, x: float = ..., y: float = ..., z: float = ..., check_fields: bool = ...) -> None: ...
    x: float
    y: float
    z: float

class Vector3Stamped(Message):
    """geometry_msgs/msg/Vector3Stamped

    # A vector with its moment and coordinate frame.

    std_msgs/Header header
    Vector3 vector
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., vector: geometry_msgs.msg.Vector3 = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    vector: geometry_msgs.msg.Vector3

class VelocityStamped(Message):
    """geometry_msgs/msg/VelocityStamped

    # How one frame moves relative to another, written down in the axes of header.frame_id.
    # With body_frame_id equal to header.frame_id it is what the robot itself feels: its body twist.

    std_msgs/Header header
    string body_frame_id # the frame that moves
    string reference_frame_id # the frame it moves in
    Twist velocity # m/s and rad/s
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., body_frame_id: str = ..., reference_frame_id: str = ..., velocity: geometry_msgs.msg.Twist = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    body_frame_id: str
    reference_frame_id: str
    velocity: geometry_msgs.msg.Twist

class Wrench(Message):
    """geometry_msgs/msg/Wrench

    # A push and a twist on a body: force in N, torque in N*m about each axis.

    Vector3  force
    Vector3  torque
    """
    def __init__(self, *, force: geometry_msgs.msg.Vector3 = ..., torque: geometry_msgs.msg.Vector3 = ..., check_fields: bool = ...) -> None: ...
    force: geometry_msgs.msg.Vector3
    torque: geometry_msgs.msg.Vector3

class WrenchStamped(Message):
    """geometry_msgs/msg/WrenchStamped

    # A force and torque with their moment and coordinate frame.

    std_msgs/Header header
    Wrench wrench
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., wrench: geometry_msgs.msg.Wrench = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    wrench: geometry_msgs.msg.Wrench
