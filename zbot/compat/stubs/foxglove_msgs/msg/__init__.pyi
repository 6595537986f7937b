# Written by python -m zbot.interfaces.stubs; do not edit.
from array import array
from collections.abc import Collection
from typing import Final, TypeAlias

import numpy
from numpy.typing import NDArray

import builtin_interfaces.msg
import foxglove_msgs.msg
import geometry_msgs.msg
from zbot.interfaces import Action, Message, Service

class ArrowPrimitive(Message):
    """foxglove_msgs/msg/ArrowPrimitive

    # An arrow in a scene.

    geometry_msgs/Pose pose
    float64 shaft_length  # m
    float64 shaft_diameter  # m
    float64 head_length  # m
    float64 head_diameter  # m
    foxglove_msgs/Color color
    """
    def __init__(self, *, pose: geometry_msgs.msg.Pose = ..., shaft_length: float = ..., shaft_diameter: float = ..., head_length: float = ..., head_diameter: float = ..., color: foxglove_msgs.msg.Color = ..., check_fields: bool = ...) -> None: ...
    pose: geometry_msgs.msg.Pose
    shaft_length: float
    shaft_diameter: float
    head_length: float
    head_diameter: float
    color: foxglove_msgs.msg.Color

class CameraCalibration(Message):
    """foxglove_msgs/msg/CameraCalibration

    # Calibration of a camera.

    builtin_interfaces/Time timestamp
    string frame_id
    uint32 width  # pixels
    uint32 height  # pixels
    string distortion_model
    float64[] d  # parameters of the distortion
    float64[9] k  # intrinsic matrix, row by row
    float64[9] r  # rectification matrix
    float64[12] p  # projection matrix, 3 rows
    """
    def __init__(self, *, timestamp: builtin_interfaces.msg.Time = ..., frame_id: str = ..., width: int = ..., height: int = ..., distortion_model: str = ..., d: Collection[float] = ..., k: Collection[float] = ..., r: Collection[float] = ..., p: Collection[float] = ..., check_fields: bool = ...) -> None: ...
    timestamp: builtin_interfaces.msg.Time
    frame_id: str
    width: int
    height: int
    distortion_model: str
    @property
    def d(self) -> array[float]: ...
    @d.setter
    def d(self, value: Collection[float]) -> None: ...
    @property
    def k(self) -> NDArray[numpy.float64]: ...
    @k.setter
    def k(self, value: Collection[float]) -> None: ...
    @property
    def r(self) -> NDArray[numpy.float64]: ...
    @r.setter
    def r(self, value: Collection[float]) -> None: ...
    @property
    def p(self) -> NDArray[numpy.float64]: ...
    @p.setter
    def p(self, value: Collection[float]) -> None: ...

class CircleAnnotation(Message):
    """foxglove_msgs/msg/CircleAnnotation

    # A circle on an image.

    builtin_interfaces/Time timestamp
    foxglove_msgs/Point2 position
    float64 diameter  # pixels
    float64 thickness  # pixels
    foxglove_msgs/Color fill_color
    foxglove_msgs/Color outline_color
    foxglove_msgs/KeyValuePair[] metadata
    """
    def __init__(self, *, timestamp: builtin_interfaces.msg.Time = ..., position: foxglove_msgs.msg.Point2 = ..., diameter: float = ..., thickness: float = ..., fill_color: foxglove_msgs.msg.Color = ..., outline_color: foxglove_msgs.msg.Color = ..., metadata: Collection[foxglove_msgs.msg.KeyValuePair] = ..., check_fields: bool = ...) -> None: ...
    timestamp: builtin_interfaces.msg.Time
    position: foxglove_msgs.msg.Point2
    diameter: float
    thickness: float
    fill_color: foxglove_msgs.msg.Color
    outline_color: foxglove_msgs.msg.Color
    @property
    def metadata(self) -> list[foxglove_msgs.msg.KeyValuePair]: ...
    @metadata.setter
    def metadata(self, value: Collection[foxglove_msgs.msg.KeyValuePair]) -> None: ...

class Color(Message):
    """foxglove_msgs/msg/Color

    # A color. Each part is 0.0 to 1.0.

    float64 r
    float64 g
    float64 b
    float64 a
    """
    def __init__(self, *, r: float = ..., g: float = ..., b: float = ..., a: float = ..., check_fields: bool = ...) -> None: ...
    r: float
    g: float
    b: float
    a: float

class CompressedAudio(Message):
    """foxglove_msgs/msg/CompressedAudio

    # Compressed sound.

    builtin_interfaces/Time timestamp
    uint8[] data
    string format  # name of the codec
    """
    def __init__(self, *, timestamp: builtin_interfaces.msg.Time = ..., data: Collection[int] = ..., format: str = ..., check_fields: bool = ...) -> None: ...
    timestamp: builtin_interfaces.msg.Time
    @property
    def data(self) -> array[int]: ...
    @data.setter
    def data(self, value: Collection[int]) -> None: ...
    format: str

class CompressedImage(Message):
    """foxglove_msgs/msg/CompressedImage

    # A compressed image.

    builtin_interfaces/Time timestamp
    string frame_id
    uint8[] data
    string format  # e.g. jpeg, png
    """
    def __init__(self, *, timestamp: builtin_interfaces.msg.Time = ..., frame_id: str = ..., data: Collection[int] = ..., format: str = ..., check_fields: bool = ...) -> None: ...
    timestamp: builtin_interfaces.msg.Time
    frame_id: str
    @property
    def data(self) -> array[int]: ...
    @data.setter
    def data(self, value: Collection[int]) -> None: ...
    format: str

class CompressedPointCloud(Message):
    """foxglove_msgs/msg/CompressedPointCloud

    # Compressed points.

    builtin_interfaces/Time timestamp
    string frame_id
    geometry_msgs/Pose pose
    uint8[] data
    string format  # name of the codec
    """
    def __init__(self, *, timestamp: builtin_interfaces.msg.Time = ..., frame_id: str = ..., pose: geometry_msgs.msg.Pose = ..., data: Collection[int] = ..., format: str = ..., check_fields: bool = ...) -> None: ...
    timestamp: builtin_interfaces.msg.Time
    frame_id: str
    pose: geometry_msgs.msg.Pose
    @property
    def data(self) -> array[int]: ...
    @data.setter
    def data(self, value: Collection[int]) -> None: ...
    format: str

class CompressedVideo(Message):
    """foxglove_msgs/msg/CompressedVideo

    # One frame of a video.

    builtin_interfaces/Time timestamp
    string frame_id
    uint8[] data
    string format  # e.g. h264
    """
    def __init__(self, *, timestamp: builtin_interfaces.msg.Time = ..., frame_id: str = ..., data: Collection[int] = ..., format: str = ..., check_fields: bool = ...) -> None: ...
    timestamp: builtin_interfaces.msg.Time
    frame_id: str
    @property
    def data(self) -> array[int]: ...
    @data.setter
    def data(self, value: Collection[int]) -> None: ...
    format: str

class CubePrimitive(Message):
    """foxglove_msgs/msg/CubePrimitive

    # A box in a scene.

    geometry_msgs/Pose pose
    geometry_msgs/Vector3 size  # m
    foxglove_msgs/Color color
    """
    def __init__(self, *, pose: geometry_msgs.msg.Pose = ..., size: geometry_msgs.msg.Vector3 = ..., color: foxglove_msgs.msg.Color = ..., check_fields: bool = ...) -> None: ...
    pose: geometry_msgs.msg.Pose
    size: geometry_msgs.msg.Vector3
    color: foxglove_msgs.msg.Color

class CylinderPrimitive(Message):
    """foxglove_msgs/msg/CylinderPrimitive

    # A cylinder or a cone in a scene.

    geometry_msgs/Pose pose
    geometry_msgs/Vector3 size  # m
    float64 bottom_scale  # 0.0 to 1.0
    float64 top_scale  # 0.0 to 1.0
    foxglove_msgs/Color color
    """
    def __init__(self, *, pose: geometry_msgs.msg.Pose = ..., size: geometry_msgs.msg.Vector3 = ..., bottom_scale: float = ..., top_scale: float = ..., color: foxglove_msgs.msg.Color = ..., check_fields: bool = ...) -> None: ...
    pose: geometry_msgs.msg.Pose
    size: geometry_msgs.msg.Vector3
    bottom_scale: float
    top_scale: float
    color: foxglove_msgs.msg.Color

class Event(Message):
    """foxglove_msgs/msg/Event

    # Something that happened.

    builtin_interfaces/Time start_time
    builtin_interfaces/Time end_time
    foxglove_msgs/KeyValuePair[] metadata
    """
    def __init__(self, *, start_time: builtin_interfaces.msg.Time = ..., end_time: builtin_interfaces.msg.Time = ..., metadata: Collection[foxglove_msgs.msg.KeyValuePair] = ..., check_fields: bool = ...) -> None: ...
    start_time: builtin_interfaces.msg.Time
    end_time: builtin_interfaces.msg.Time
    @property
    def metadata(self) -> list[foxglove_msgs.msg.KeyValuePair]: ...
    @metadata.setter
    def metadata(self, value: Collection[foxglove_msgs.msg.KeyValuePair]) -> None: ...

class FrameTransform(Message):
    """foxglove_msgs/msg/FrameTransform

    # The pose of a frame in another frame.

    builtin_interfaces/Time timestamp
    string parent_frame_id
    string child_frame_id
    geometry_msgs/Vector3 translation  # m
    geometry_msgs/Quaternion rotation
    """
    def __init__(self, *, timestamp: builtin_interfaces.msg.Time = ..., parent_frame_id: str = ..., child_frame_id: str = ..., translation: geometry_msgs.msg.Vector3 = ..., rotation: geometry_msgs.msg.Quaternion = ..., check_fields: bool = ...) -> None: ...
    timestamp: builtin_interfaces.msg.Time
    parent_frame_id: str
    child_frame_id: str
    translation: geometry_msgs.msg.Vector3
    rotation: geometry_msgs.msg.Quaternion

class FrameTransforms(Message):
    """foxglove_msgs/msg/FrameTransforms

    # Poses of frames in other frames.

    foxglove_msgs/FrameTransform[] transforms
    """
    def __init__(self, *, transforms: Collection[foxglove_msgs.msg.FrameTransform] = ..., check_fields: bool = ...) -> None: ...
    @property
    def transforms(self) -> list[foxglove_msgs.msg.FrameTransform]: ...
    @transforms.setter
    def transforms(self, value: Collection[foxglove_msgs.msg.FrameTransform]) -> None: ...

class GeoJSON(Message):
    """foxglove_msgs/msg/GeoJSON

    # Shapes on the earth.

    string geojson  # JSON
    """
    def __init__(self, *, geojson: str = ..., check_fields: bool = ...) -> None: ...
    geojson: str

class Grid(Message):
    """foxglove_msgs/msg/Grid

    # A grid in two dimensions with values in each cell.

    builtin_interfaces/Time timestamp
    string frame_id
    geometry_msgs/Pose pose  # of the corner
    uint32 column_count
    foxglove_msgs/Vector2 cell_size  # m
    uint32 row_stride  # bytes from a row to the next
    uint32 cell_stride  # bytes from a cell to the next
    foxglove_msgs/PackedElementField[] fields  # values in each cell
    uint8[] data
    """
    def __init__(self, *, timestamp: builtin_interfaces.msg.Time = ..., frame_id: str = ..., pose: geometry_msgs.msg.Pose = ..., column_count: int = ..., cell_size: foxglove_msgs.msg.Vector2 = ..., row_stride: int = ..., cell_stride: int = ..., fields: Collection[foxglove_msgs.msg.PackedElementField] = ..., data: Collection[int] = ..., check_fields: bool = ...) -> None: ...
    timestamp: builtin_interfaces.msg.Time
    frame_id: str
    pose: geometry_msgs.msg.Pose
    column_count: int
    cell_size: foxglove_msgs.msg.Vector2
    row_stride: int
    cell_stride: int
    @property
    def fields(self) -> list[foxglove_msgs.msg.PackedElementField]: ...
    @fields.setter
    def fields(self, value: Collection[foxglove_msgs.msg.PackedElementField]) -> None: ...
    @property
    def data(self) -> array[int]: ...
    @data.setter
    def data(self, value: Collection[int]) -> None: ...

class ImageAnnotations(Message):
    """foxglove_msgs/msg/ImageAnnotations

    # Drawings on an image.

    builtin_interfaces/Time timestamp
    foxglove_msgs/CircleAnnotation[] circles
    foxglove_msgs/PointsAnnotation[] points
    foxglove_msgs/TextAnnotation[] texts
    foxglove_msgs/KeyValuePair[] metadata
    """
    def __init__(self, *, timestamp: builtin_interfaces.msg.Time = ..., circles: Collection[foxglove_msgs.msg.CircleAnnotation] = ..., points: Collection[foxglove_msgs.msg.PointsAnnotation] = ..., texts: Collection[foxglove_msgs.msg.TextAnnotation] = ..., metadata: Collection[foxglove_msgs.msg.KeyValuePair] = ..., check_fields: bool = ...) -> None: ...
    timestamp: builtin_interfaces.msg.Time
    @property
    def circles(self) -> list[foxglove_msgs.msg.CircleAnnotation]: ...
    @circles.setter
    def circles(self, value: Collection[foxglove_msgs.msg.CircleAnnotation]) -> None: ...
    @property
    def points(self) -> list[foxglove_msgs.msg.PointsAnnotation]: ...
    @points.setter
    def points(self, value: Collection[foxglove_msgs.msg.PointsAnnotation]) -> None: ...
    @property
    def texts(self) -> list[foxglove_msgs.msg.TextAnnotation]: ...
    @texts.setter
    def texts(self, value: Collection[foxglove_msgs.msg.TextAnnotation]) -> None: ...
    @property
    def metadata(self) -> list[foxglove_msgs.msg.KeyValuePair]: ...
    @metadata.setter
    def metadata(self, value: Collection[foxglove_msgs.msg.KeyValuePair]) -> None: ...

class JointState(Message):
    """foxglove_msgs/msg/JointState

    # State of one joint.

    string name
    float64 position  # rad or m
    float64 velocity  # rad/s or m/s
    float64 acceleration  # rad/s^2 or m/s^2
    float64 effort  # N m or N
    """
    def __init__(self, *, name: str = ..., position: float = ..., velocity: float = ..., acceleration: float = ..., effort: float = ..., check_fields: bool = ...) -> None: ...
    name: str
    position: float
    velocity: float
    acceleration: float
    effort: float

class JointStates(Message):
    """foxglove_msgs/msg/JointStates

    # States of joints.

    builtin_interfaces/Time timestamp
    foxglove_msgs/JointState[] joints
    """
    def __init__(self, *, timestamp: builtin_interfaces.msg.Time = ..., joints: Collection[foxglove_msgs.msg.JointState] = ..., check_fields: bool = ...) -> None: ...
    timestamp: builtin_interfaces.msg.Time
    @property
    def joints(self) -> list[foxglove_msgs.msg.JointState]: ...
    @joints.setter
    def joints(self, value: Collection[foxglove_msgs.msg.JointState]) -> None: ...

class KeyValuePair(Message):
    """foxglove_msgs/msg/KeyValuePair

    # A name with a text.

    string key
    string value
    """
    def __init__(self, *, key: str = ..., value: str = ..., check_fields: bool = ...) -> None: ...
    key: str
    value: str

class LaserScan(Message):
    """foxglove_msgs/msg/LaserScan

    # One scan of a laser.

    builtin_interfaces/Time timestamp
    string frame_id
    geometry_msgs/Pose pose
    float64 start_angle  # rad
    float64 end_angle  # rad
    float64[] ranges  # m
    float64[] intensities
    """
    def __init__(self, *, timestamp: builtin_interfaces.msg.Time = ..., frame_id: str = ..., pose: geometry_msgs.msg.Pose = ..., start_angle: float = ..., end_angle: float = ..., ranges: Collection[float] = ..., intensities: Collection[float] = ..., check_fields: bool = ...) -> None: ...
    timestamp: builtin_interfaces.msg.Time
    frame_id: str
    pose: geometry_msgs.msg.Pose
    start_angle: float
    end_angle: float
    @property
    def ranges(self) -> array[float]: ...
    @ranges.setter
    def ranges(self, value: Collection[float]) -> None: ...
    @property
    def intensities(self) -> array[float]: ...
    @intensities.setter
    def intensities(self, value: Collection[float]) -> None: ...

class LinePrimitive(Message):
    """foxglove_msgs/msg/LinePrimitive

    # Lines in a scene.

    uint8 LINE_STRIP=0
    uint8 LINE_LOOP=1
    uint8 LINE_LIST=2
    uint8 type
    geometry_msgs/Pose pose
    float64 thickness  # m, or pixels if scale_invariant
    bool scale_invariant
    geometry_msgs/Point[] points
    foxglove_msgs/Color color
    foxglove_msgs/Color[] colors  # one for each point, or empty
    uint32[] indices  # order of the points, or empty
    """
    LINE_STRIP: Final = 0
    LINE_LOOP: Final = 1
    LINE_LIST: Final = 2
    def __init__(self, *, type: int = ..., pose: geometry_msgs.msg.Pose = ..., thickness: float = ..., scale_invariant: bool = ..., points: Collection[geometry_msgs.msg.Point] = ..., color: foxglove_msgs.msg.Color = ..., colors: Collection[foxglove_msgs.msg.Color] = ..., indices: Collection[int] = ..., check_fields: bool = ...) -> None: ...
    type: int
    pose: geometry_msgs.msg.Pose
    thickness: float
    scale_invariant: bool
    @property
    def points(self) -> list[geometry_msgs.msg.Point]: ...
    @points.setter
    def points(self, value: Collection[geometry_msgs.msg.Point]) -> None: ...
    color: foxglove_msgs.msg.Color
    @property
    def colors(self) -> list[foxglove_msgs.msg.Color]: ...
    @colors.setter
    def colors(self, value: Collection[foxglove_msgs.msg.Color]) -> None: ...
    @property
    def indices(self) -> array[int]: ...
    @indices.setter
    def indices(self, value: Collection[int]) -> None: ...

class LocationFix(Message):
    """foxglove_msgs/msg/LocationFix

    # A place of the earth.

    builtin_interfaces/Time timestamp
    string frame_id
    float64 latitude  # degrees
    float64 longitude  # degrees
    float64 altitude  # m
    float64[9] position_covariance  # m^2: east, north, up
    uint8 UNKNOWN=0
    uint8 APPROXIMATED=1
    uint8 DIAGONAL_KNOWN=2
    uint8 KNOWN=3
    uint8 position_covariance_type
    float64 heading
    geometry_msgs/Vector3 velocity
    foxglove_msgs/Color color
    foxglove_msgs/KeyValuePair[] metadata
    """
    UNKNOWN: Final = 0
    APPROXIMATED: Final = 1
    DIAGONAL_KNOWN: Final = 2
    KNOWN: Final = 3
    def __init__(self, *, timestamp: builtin_interfaces.msg.Time = ..., frame_id: str = ..., latitude: float = ..., longitude: float = ..., altitude: float = ..., position_covariance: Collection[float] = ..., position_covariance_type: int = ..., heading: float = ..., velocity: geometry_msgs.msg.Vector3 = ..., color: foxglove_msgs.msg.Color = ..., metadata: Collection[foxglove_msgs.msg.KeyValuePair] = ..., check_fields: bool = ...) -> None: ...
    timestamp: builtin_interfaces.msg.Time
    frame_id: str
    latitude: float
    longitude: float
    altitude: float
    @property
    def position_covariance(self) -> NDArray[numpy.float64]: ...
    @position_covariance.setter
    def position_covariance(self, value: Collection[float]) -> None: ...
    position_covariance_type: int
    heading: float
    velocity: geometry_msgs.msg.Vector3
    color: foxglove_msgs.msg.Color
    @property
    def metadata(self) -> list[foxglove_msgs.msg.KeyValuePair]: ...
    @metadata.setter
    def metadata(self, value: Collection[foxglove_msgs.msg.KeyValuePair]) -> None: ...

class LocationFixes(Message):
    """foxglove_msgs/msg/LocationFixes

    # Places of the earth.

    foxglove_msgs/LocationFix[] fixes
    """
    def __init__(self, *, fixes: Collection[foxglove_msgs.msg.LocationFix] = ..., check_fields: bool = ...) -> None: ...
    @property
    def fixes(self) -> list[foxglove_msgs.msg.LocationFix]: ...
    @fixes.setter
    def fixes(self, value: Collection[foxglove_msgs.msg.LocationFix]) -> None: ...

class Log(Message):
    """foxglove_msgs/msg/Log

    # A log line.

    builtin_interfaces/Time timestamp
    uint8 UNKNOWN=0
    uint8 DEBUG=1
    uint8 INFO=2
    uint8 WARNING=3
    uint8 ERROR=4
    uint8 FATAL=5
    uint8 level
    string message
    string name
    string file
    uint32 line
    """
    UNKNOWN: Final = 0
    DEBUG: Final = 1
    INFO: Final = 2
    WARNING: Final = 3
    ERROR: Final = 4
    FATAL: Final = 5
    def __init__(self, *, timestamp: builtin_interfaces.msg.Time = ..., level: int = ..., message: str = ..., name: str = ..., file: str = ..., line: int = ..., check_fields: bool = ...) -> None: ...
    timestamp: builtin_interfaces.msg.Time
    level: int
    message: str
    name: str
    file: str
    line: int

class ModelPrimitive(Message):
    """foxglove_msgs/msg/ModelPrimitive

    # A 3D model in a scene, from an address or from data.

    geometry_msgs/Pose pose
    geometry_msgs/Vector3 scale
    foxglove_msgs/Color color
    bool override_color  # use color in place of the colors of the model
    string url
    string media_type
    uint8[] data
    """
    def __init__(self, *, pose: geometry_msgs.msg.Pose = ..., scale: geometry_msgs.msg.Vector3 = ..., color: foxglove_msgs.msg.Color = ..., override_color: bool = ..., url: str = ..., media_type: str = ..., data: Collection[int] = ..., check_fields: bool = ...) -> None: ...
    pose: geometry_msgs.msg.Pose
    scale: geometry_msgs.msg.Vector3
    color: foxglove_msgs.msg.Color
    override_color: bool
    url: str
    media_type: str
    @property
    def data(self) -> array[int]: ...
    @data.setter
    def data(self, value: Collection[int]) -> None: ...

class Odometry(Message):
    """foxglove_msgs/msg/Odometry

    # Pose and speed of a body.

    builtin_interfaces/Time timestamp
    string frame_id
    string body_frame_id
    geometry_msgs/Pose pose
    geometry_msgs/Vector3 linear_velocity  # m/s
    geometry_msgs/Vector3 angular_velocity  # rad/s
    float64[36] pose_covariance  # row by row
    float64[36] velocity_covariance
    foxglove_msgs/KeyValuePair[] metadata
    """
    def __init__(self, *, timestamp: builtin_interfaces.msg.Time = ..., frame_id: str = ..., body_frame_id: str = ..., pose: geometry_msgs.msg.Pose = ..., linear_velocity: geometry_msgs.msg.Vector3 = ..., angular_velocity: geometry_msgs.msg.Vector3 = ..., pose_covariance: Collection[float] = ..., velocity_covariance: Collection[float] = ..., metadata: Collection[foxglove_msgs.msg.KeyValuePair] = ..., check_fields: bool = ...) -> None: ...
    timestamp: builtin_interfaces.msg.Time
    frame_id: str
    body_frame_id: str
    pose: geometry_msgs.msg.Pose
    linear_velocity: geometry_msgs.msg.Vector3
    angular_velocity: geometry_msgs.msg.Vector3
    @property
    def pose_covariance(self) -> NDArray[numpy.float64]: ...
    @pose_covariance.setter
    def pose_covariance(self, value: Collection[float]) -> None: ...
    @property
    def velocity_covariance(self) -> NDArray[numpy.float64]: ...
    @velocity_covariance.setter
    def velocity_covariance(self, value: Collection[float]) -> None: ...
    @property
    def metadata(self) -> list[foxglove_msgs.msg.KeyValuePair]: ...
    @metadata.setter
    def metadata(self, value: Collection[foxglove_msgs.msg.KeyValuePair]) -> None: ...

class PackedElementField(Message):
    """foxglove_msgs/msg/PackedElementField

    # A value inside the bytes of an element.

    string name
    uint32 offset  # bytes
    uint8 UNKNOWN=0
    uint8 UINT8=1
    uint8 INT8=2
    uint8 UINT16=3
    uint8 INT16=4
    uint8 UINT32=5
    uint8 INT32=6
    uint8 FLOAT32=7
    uint8 FLOAT64=8
    uint8 type
    """
    UNKNOWN: Final = 0
    UINT8: Final = 1
    INT8: Final = 2
    UINT16: Final = 3
    INT16: Final = 4
    UINT32: Final = 5
    INT32: Final = 6
    FLOAT32: Final = 7
    FLOAT64: Final = 8
    def __init__(self, *, name: str = ..., offset: int = ..., type: int = ..., check_fields: bool = ...) -> None: ...
    name: str
    offset: int
    type: int

class Point2(Message):
    """foxglove_msgs/msg/Point2

    # A point in two dimensions.

    float64 x
    float64 y
    """
    def __init__(self, *, x: float = ..., y: float = ..., check_fields: bool = ...) -> None: ...
    x: float
    y: float

class PointCloud(Message):
    """foxglove_msgs/msg/PointCloud

    # Points with values.

    builtin_interfaces/Time timestamp
    string frame_id
    geometry_msgs/Pose pose
    uint32 point_stride  # bytes from a point to the next
    foxglove_msgs/PackedElementField[] fields  # values of each point
    uint8[] data
    """
    def __init__(self, *, timestamp: builtin_interfaces.msg.Time = ..., frame_id: str = ..., pose: geometry_msgs.msg.Pose = ..., point_stride: int = ..., fields: Collection[foxglove_msgs.msg.PackedElementField] = ..., data: Collection[int] = ..., check_fields: bool = ...) -> None: ...
    timestamp: builtin_interfaces.msg.Time
    frame_id: str
    pose: geometry_msgs.msg.Pose
    point_stride: int
    @property
    def fields(self) -> list[foxglove_msgs.msg.PackedElementField]: ...
    @fields.setter
    def fields(self, value: Collection[foxglove_msgs.msg.PackedElementField]) -> None: ...
    @property
    def data(self) -> array[int]: ...
    @data.setter
    def data(self, value: Collection[int]) -> None: ...

class PointsAnnotation(Message):
    """foxglove_msgs/msg/PointsAnnotation

    # Points or lines on an image.

    builtin_interfaces/Time timestamp
    uint8 UNKNOWN=0
    uint8 POINTS=1
    uint8 LINE_LOOP=2
    uint8 LINE_STRIP=3
    uint8 LINE_LIST=4
    uint8 type
    foxglove_msgs/Point2[] points
    foxglove_msgs/Color outline_color
    foxglove_msgs/Color[] outline_colors
    foxglove_msgs/Color fill_color
    float64 thickness  # pixels
    foxglove_msgs/KeyValuePair[] metadata
    """
    UNKNOWN: Final = 0
    POINTS: Final = 1
    LINE_LOOP: Final = 2
    LINE_STRIP: Final = 3
    LINE_LIST: Final = 4
    def __init__(self, *, timestamp: builtin_interfaces.msg.Time = ..., type: int = ..., points: Collection[foxglove_msgs.msg.Point2] = ..., outline_color: foxglove_msgs.msg.Color = ..., outline_colors: Collection[foxglove_msgs.msg.Color] = ..., fill_color: foxglove_msgs.msg.Color = ..., thickness: float = ..., metadata: Collection[foxglove_msgs.msg.KeyValuePair] = ..., check_fields: bool = ...) -> None: ...
    timestamp: builtin_interfaces.msg.Time
    type: int
    @property
    def points(self) -> list[foxglove_msgs.msg.Point2]: ...
    @points.setter
    def points(self, value: Collection[foxglove_msgs.msg.Point2]) -> None: ...
    outline_color: foxglove_msgs.msg.Color
    @property
    def outline_colors(self) -> list[foxglove_msgs.msg.Color]: ...
    @outline_colors.setter
    def outline_colors(self, value: Collection[foxglove_msgs.msg.Color]) -> None: ...
    fill_color: foxglove_msgs.msg.Color
    thickness: float
    @property
    def metadata(self) -> list[foxglove_msgs.msg.KeyValuePair]: ...
    @metadata.setter
    def metadata(self, value: Collection[foxglove_msgs.msg.KeyValuePair]) -> None: ...

class PoseInFrame(Message):
    """foxglove_msgs/msg/PoseInFrame

    # A pose with a time and a frame.

    builtin_interfaces/Time timestamp
    string frame_id
    geometry_msgs/Pose pose
    """
    def __init__(self, *, timestamp: builtin_interfaces.msg.Time = ..., frame_id: str = ..., pose: geometry_msgs.msg.Pose = ..., check_fields: bool = ...) -> None: ...
    timestamp: builtin_interfaces.msg.Time
    frame_id: str
    pose: geometry_msgs.msg.Pose

class PosesInFrame(Message):
    """foxglove_msgs/msg/PosesInFrame

    # Poses with a time and a frame.

    builtin_interfaces/Time timestamp
    string frame_id
    geometry_msgs/Pose[] poses
    """
    def __init__(self, *, timestamp: builtin_interfaces.msg.Time = ..., frame_id: str = ..., poses: Collection[geometry_msgs.msg.Pose] = ..., check_fields: bool = ...) -> None: ...
    timestamp: builtin_interfaces.msg.Time
    frame_id: str
    @property
    def poses(self) -> list[geometry_msgs.msg.Pose]: ...
    @poses.setter
    def poses(self, value: Collection[geometry_msgs.msg.Pose]) -> None: ...

class RawAudio(Message):
    """foxglove_msgs/msg/RawAudio

    # Sound.

    builtin_interfaces/Time timestamp
    uint8[] data
    string format  # e.g. pcm-s16
    uint32 sample_rate  # Hz
    uint32 number_of_channels
    """
    def __init__(self, *, timestamp: builtin_interfaces.msg.Time = ..., data: Collection[int] = ..., format: str = ..., sample_rate: int = ..., number_of_channels: int = ..., check_fields: bool = ...) -> None: ...
    timestamp: builtin_interfaces.msg.Time
    @property
    def data(self) -> array[int]: ...
    @data.setter
    def data(self, value: Collection[int]) -> None: ...
    format: str
    sample_rate: int
    number_of_channels: int

class RawImage(Message):
    """foxglove_msgs/msg/RawImage

    # An image.

    builtin_interfaces/Time timestamp
    string frame_id
    uint32 width  # pixels
    uint32 height  # pixels
    string encoding  # e.g. rgb8
    uint32 step  # bytes from a row to the next
    uint8[] data
    """
    def __init__(self, *, timestamp: builtin_interfaces.msg.Time = ..., frame_id: str = ..., width: int = ..., height: int = ..., encoding: str = ..., step: int = ..., data: Collection[int] = ..., check_fields: bool = ...) -> None: ...
    timestamp: builtin_interfaces.msg.Time
    frame_id: str
    width: int
    height: int
    encoding: str
    step: int
    @property
    def data(self) -> array[int]: ...
    @data.setter
    def data(self, value: Collection[int]) -> None: ...

class SceneEntity(Message):
    """foxglove_msgs/msg/SceneEntity

    # A thing in a scene, made of shapes.

    builtin_interfaces/Time timestamp
    string frame_id
    string id  # a new thing with the same id replaces the old one
    builtin_interfaces/Duration lifetime  # zero: for ever
    bool frame_locked  # it moves with its frame
    foxglove_msgs/KeyValuePair[] metadata
    foxglove_msgs/ArrowPrimitive[] arrows
    foxglove_msgs/CubePrimitive[] cubes
    foxglove_msgs/SpherePrimitive[] spheres
    foxglove_msgs/CylinderPrimitive[] cylinders
    foxglove_msgs/LinePrimitive[] lines
    foxglove_msgs/TriangleListPrimitive[] triangles
    foxglove_msgs/TextPrimitive[] texts
    foxglove_msgs/ModelPrimitive[] models
    """
    def __init__(self, *, timestamp: builtin_interfaces.msg.Time = ..., frame_id: str = ..., id: str = ..., lifetime: builtin_interfaces.msg.Duration = ..., frame_locked: bool = ..., metadata: Collection[foxglove_msgs.msg.KeyValuePair] = ..., arrows: Collection[foxglove_msgs.msg.ArrowPrimitive] = ..., cubes: Collection[foxglove_msgs.msg.CubePrimitive] = ..., spheres: Collection[foxglove_msgs.msg.SpherePrimitive] = ..., cylinders: Collection[foxglove_msgs.msg.CylinderPrimitive] = ..., lines: Collection[foxglove_msgs.msg.LinePrimitive] = ..., triangles: Collection[foxglove_msgs.msg.TriangleListPrimitive] = ..., texts: Collection[foxglove_msgs.msg.TextPrimitive] = ..., models: Collection[foxglove_msgs.msg.ModelPrimitive] = ..., check_fields: bool = ...) -> None: ...
    timestamp: builtin_interfaces.msg.Time
    frame_id: str
    id: str
    lifetime: builtin_interfaces.msg.Duration
    frame_locked: bool
    @property
    def metadata(self) -> list[foxglove_msgs.msg.KeyValuePair]: ...
    @metadata.setter
    def metadata(self, value: Collection[foxglove_msgs.msg.KeyValuePair]) -> None: ...
    @property
    def arrows(self) -> list[foxglove_msgs.msg.ArrowPrimitive]: ...
    @arrows.setter
    def arrows(self, value: Collection[foxglove_msgs.msg.ArrowPrimitive]) -> None: ...
    @property
    def cubes(self) -> list[foxglove_msgs.msg.CubePrimitive]: ...
    @cubes.setter
    def cubes(self, value: Collection[foxglove_msgs.msg.CubePrimitive]) -> None: ...
    @property
    def spheres(self) -> list[foxglove_msgs.msg.SpherePrimitive]: ...
    @spheres.setter
    def spheres(self, value: Collection[foxglove_msgs.msg.SpherePrimitive]) -> None: ...
    @property
    def cylinders(self) -> list[foxglove_msgs.msg.CylinderPrimitive]: ...
    @cylinders.setter
    def cylinders(self, value: Collection[foxglove_msgs.msg.CylinderPrimitive]) -> None: ...
    @property
    def lines(self) -> list[foxglove_msgs.msg.LinePrimitive]: ...
    @lines.setter
    def lines(self, value: Collection[foxglove_msgs.msg.LinePrimitive]) -> None: ...
    @property
    def triangles(self) -> list[foxglove_msgs.msg.TriangleListPrimitive]: ...
    @triangles.setter
    def triangles(self, value: Collection[foxglove_msgs.msg.TriangleListPrimitive]) -> None: ...
    @property
    def texts(self) -> list[foxglove_msgs.msg.TextPrimitive]: ...
    @texts.setter
    def texts(self, value: Collection[foxglove_msgs.msg.TextPrimitive]) -> None: ...
    @property
    def models(self) -> list[foxglove_msgs.msg.ModelPrimitive]: ...
    @models.setter
    def models(self, value: Collection[foxglove_msgs.msg.ModelPrimitive]) -> None: ...

class SceneEntityDeletion(Message):
    """foxglove_msgs/msg/SceneEntityDeletion

    # Removes things from a scene.

    builtin_interfaces/Time timestamp
    uint8 MATCHING_ID=0
    uint8 ALL=1
    uint8 type
    string id
    """
    MATCHING_ID: Final = 0
    ALL: Final = 1
    def __init__(self, *, timestamp: builtin_interfaces.msg.Time = ..., type: int = ..., id: str = ..., check_fields: bool = ...) -> None: ...
    timestamp: builtin_interfaces.msg.Time
    type: int
    id: str

class SceneUpdate(Message):
    """foxglove_msgs/msg/SceneUpdate

    # Things to remove from a scene and to add to it.

    foxglove_msgs/SceneEntityDeletion[] deletions
    foxglove_msgs/SceneEntity[] entities
    """
    def __init__(self, *, deletions: Collection[foxglove_msgs.msg.SceneEntityDeletion] = ..., entities: Collection[foxglove_msgs.msg.SceneEntity] = ..., check_fields: bool = ...) -> None: ...
    @property
    def deletions(self) -> list[foxglove_msgs.msg.SceneEntityDeletion]: ...
    @deletions.setter
    def deletions(self, value: Collection[foxglove_msgs.msg.SceneEntityDeletion]) -> None: ...
    @property
    def entities(self) -> list[foxglove_msgs.msg.SceneEntity]: ...
    @entities.setter
    def entities(self, value: Collection[foxglove_msgs.msg.SceneEntity]) -> None: ...

class SpherePrimitive(Message):
    """foxglove_msgs/msg/SpherePrimitive

    # A ball or an ellipsoid in a scene.

    geometry_msgs/Pose pose
    geometry_msgs/Vector3 size  # m, diameters
    foxglove_msgs/Color color
    """
    def __init__(self, *, pose: geometry_msgs.msg.Pose = ..., size: geometry_msgs.msg.Vector3 = ..., color: foxglove_msgs.msg.Color = ..., check_fields: bool = ...) -> None: ...
    pose: geometry_msgs.msg.Pose
    size: geometry_msgs.msg.Vector3
    color: foxglove_msgs.msg.Color

class TextAnnotation(Message):
    """foxglove_msgs/msg/TextAnnotation

    # A text on an image.

    builtin_interfaces/Time timestamp
    foxglove_msgs/Point2 position
    string text
    float64 font_size  # pixels
    foxglove_msgs/Color text_color
    foxglove_msgs/Color background_color
    foxglove_msgs/KeyValuePair[] metadata
    """
    def __init__(self, *, timestamp: builtin_interfaces.msg.Time = ..., position: foxglove_msgs.msg.Point2 = ..., text: str = ..., font_size: float = ..., text_color: foxglove_msgs.msg.Color = ..., background_color: foxglove_msgs.msg.Color = ..., metadata: Collection[foxglove_msgs.msg.KeyValuePair] = ..., check_fields: bool = ...) -> None: ...
    timestamp: builtin_interfaces.msg.Time
    position: foxglove_msgs.msg.Point2
    text: str
    font_size: float
    text_color: foxglove_msgs.msg.Color
    background_color: foxglove_msgs.msg.Color
    @property
    def metadata(self) -> list[foxglove_msgs.msg.KeyValuePair]: ...
    @metadata.setter
    def metadata(self, value: Collection[foxglove_msgs.msg.KeyValuePair]) -> None: ...

class TextPrimitive(Message):
    """foxglove_msgs/msg/TextPrimitive

    # A text in a scene.

    geometry_msgs/Pose pose
    bool billboard  # it always faces the viewer
    float64 font_size  # m, or pixels if scale_invariant
    bool scale_invariant
    foxglove_msgs/Color color
    string text
    """
    def __init__(self, *, pose: geometry_msgs.msg.Pose = ..., billboard: bool = ..., font_size: float = ..., scale_invariant: bool = ..., color: foxglove_msgs.msg.Color = ..., text: str = ..., check_fields: bool = ...) -> None: ...
    pose: geometry_msgs.msg.Pose
    billboard: bool
    font_size: float
    scale_invariant: bool
    color: foxglove_msgs.msg.Color
    text: str

class TriangleListPrimitive(Message):
    """foxglove_msgs/msg/TriangleListPrimitive

    # Triangles in a scene.

    geometry_msgs/Pose pose
    geometry_msgs/Point[] points  # m, three for each triangle
    foxglove_msgs/Color color
    foxglove_msgs/Color[] colors  # one for each point, or empty
    uint32[] indices  # order of the points, or empty
    """
    def __init__(self, *, pose: geometry_msgs.msg.Pose = ..., points: Collection[geometry_msgs.msg.Point] = ..., color: foxglove_msgs.msg.Color = ..., colors: Collection[foxglove_msgs.msg.Color] = ..., indices: Collection[int] = ..., check_fields: bool = ...) -> None: ...
    pose: geometry_msgs.msg.Pose
    @property
    def points(self) -> list[geometry_msgs.msg.Point]: ...
    @points.setter
    def points(self, value: Collection[geometry_msgs.msg.Point]) -> None: ...
    color: foxglove_msgs.msg.Color
    @property
    def colors(self) -> list[foxglove_msgs.msg.Color]: ...
    @colors.setter
    def colors(self, value: Collection[foxglove_msgs.msg.Color]) -> None: ...
    @property
    def indices(self) -> array[int]: ...
    @indices.setter
    def indices(self, value: Collection[int]) -> None: ...

class Vector2(Message):
    """foxglove_msgs/msg/Vector2

    # A vector in two dimensions.

    float64 x
    float64 y
    """
    def __init__(self, *, x: float = ..., y: float = ..., check_fields: bool = ...) -> None: ...
    x: float
    y: float

class VoxelGrid(Message):
    """foxglove_msgs/msg/VoxelGrid

    # A grid in three dimensions with values in each cell.

    builtin_interfaces/Time timestamp
    string frame_id
    geometry_msgs/Pose pose
    uint32 row_count
    uint32 column_count
    geometry_msgs/Vector3 cell_size  # m
    uint32 slice_stride  # bytes from a layer to the next
    uint32 row_stride  # bytes from a row to the next
    uint32 cell_stride  # bytes from a cell to the next
    foxglove_msgs/PackedElementField[] fields
    uint8[] data
    """
    def __init__(self, *, timestamp: builtin_interfaces.msg.Time = ..., frame_id: str = ..., pose: geometry_msgs.msg.Pose = ..., row_count: int = ..., column_count: int = ..., cell_size: geometry_msgs.msg.Vector3 = ..., slice_stride: int = ..., row_stride: int = ..., cell_stride: int = ..., fields: Collection[foxglove_msgs.msg.PackedElementField] = ..., data: Collection[int] = ..., check_fields: bool = ...) -> None: ...
    timestamp: builtin_interfaces.msg.Time
    frame_id: str
    pose: geometry_msgs.msg.Pose
    row_count: int
    column_count: int
    cell_size: geometry_msgs.msg.Vector3
    slice_stride: int
    row_stride: int
    cell_stride: int
    @property
    def fields(self) -> list[foxglove_msgs.msg.PackedElementField]: ...
    @fields.setter
    def fields(self, value: Collection[foxglove_msgs.msg.PackedElementField]) -> None: ...
    @property
    def data(self) -> array[int]: ...
    @data.setter
    def data(self, value: Collection[int]) -> None: ...
