# Written by python -m zbot.interfaces.stubs; do not edit.
from array import array
from collections.abc import Collection
from typing import Final, TypeAlias

import numpy
from numpy.typing import NDArray

import geometry_msgs.msg
import std_msgs.msg
import vision_msgs.msg
from zbot.interfaces import Action, Message, Service

class BoundingBox2D(Message):
    """vision_msgs/msg/BoundingBox2D

    # A rectangle around something in an image; it may be turned about its middle.

    Pose2D center
    float64 size_x  # pixels
    float64 size_y  # pixels
    """
    def __init__(self, *, center: vision_msgs.msg.Pose2D = ..., size_x: float = ..., size_y: float = ..., check_fields: bool = ...) -> None: ...
    center: vision_msgs.msg.Pose2D
    size_x: float
    size_y: float

class BoundingBox2DArray(Message):
    """vision_msgs/msg/BoundingBox2DArray

    # Rectangles of one image.

    std_msgs/Header header
    BoundingBox2D[] boxes
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., boxes: Collection[vision_msgs.msg.BoundingBox2D] = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    @property
    def boxes(self) -> list[vision_msgs.msg.BoundingBox2D]: ...
    @boxes.setter
    def boxes(self, value: Collection[vision_msgs.msg.BoundingBox2D]) -> None: ...

class BoundingBox3D(Message):
    """vision_msgs/msg/BoundingBox3D

    # A block around something in space; it may be turned about its middle.

    geometry_msgs/Pose center
    geometry_msgs/Vector3 size  # m, along the axes of the block
    """
    def __init__(self, *, center: geometry_msgs.msg.Pose = ..., size: geometry_msgs.msg.Vector3 = ..., check_fields: bool = ...) -> None: ...
    center: geometry_msgs.msg.Pose
    size: geometry_msgs.msg.Vector3

class BoundingBox3DArray(Message):
    """vision_msgs/msg/BoundingBox3DArray

    # Blocks that were found at one moment.

    std_msgs/Header header
    BoundingBox3D[] boxes
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., boxes: Collection[vision_msgs.msg.BoundingBox3D] = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    @property
    def boxes(self) -> list[vision_msgs.msg.BoundingBox3D]: ...
    @boxes.setter
    def boxes(self, value: Collection[vision_msgs.msg.BoundingBox3D]) -> None: ...

class Classification(Message):
    """vision_msgs/msg/Classification

    # What a whole image or cloud could show.

    std_msgs/Header header
    ObjectHypothesis[] results
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., results: Collection[vision_msgs.msg.ObjectHypothesis] = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    @property
    def results(self) -> list[vision_msgs.msg.ObjectHypothesis]: ...
    @results.setter
    def results(self, value: Collection[vision_msgs.msg.ObjectHypothesis]) -> None: ...

class Detection2D(Message):
    """vision_msgs/msg/Detection2D

    # Something that was found in an image.

    std_msgs/Header header
    ObjectHypothesisWithPose[] results
    BoundingBox2D bbox
    string id  # the same in every message about the same thing; empty: not followed
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., results: Collection[vision_msgs.msg.ObjectHypothesisWithPose] = ..., bbox: vision_msgs.msg.BoundingBox2D = ..., id: str = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    @property
    def results(self) -> list[vision_msgs.msg.ObjectHypothesisWithPose]: ...
    @results.setter
    def results(self, value: Collection[vision_msgs.msg.ObjectHypothesisWithPose]) -> None: ...
    bbox: vision_msgs.msg.BoundingBox2D
    id: str

class Detection2DArray(Message):
    """vision_msgs/msg/Detection2DArray

    # Everything that was found in an image.

    std_msgs/Header header
    Detection2D[] detections
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., detections: Collection[vision_msgs.msg.Detection2D] = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    @property
    def detections(self) -> list[vision_msgs.msg.Detection2D]: ...
    @detections.setter
    def detections(self, value: Collection[vision_msgs.msg.Detection2D]) -> None: ...

class Detection3D(Message):
    """vision_msgs/msg/Detection3D

    # Something that was found in space.

    std_msgs/Header header
    ObjectHypothesisWithPose[] results
    BoundingBox3D bbox
    string id  # the same in every message about the same thing; empty: not followed
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., results: Collection[vision_msgs.msg.ObjectHypothesisWithPose] = ..., bbox: vision_msgs.msg.BoundingBox3D = ..., id: str = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    @property
    def results(self) -> list[vision_msgs.msg.ObjectHypothesisWithPose]: ...
    @results.setter
    def results(self, value: Collection[vision_msgs.msg.ObjectHypothesisWithPose]) -> None: ...
    bbox: vision_msgs.msg.BoundingBox3D
    id: str

class Detection3DArray(Message):
    """vision_msgs/msg/Detection3DArray

    # Everything that was found in space at one moment.

    std_msgs/Header header
    Detection3D[] detections
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., detections: Collection[vision_msgs.msg.Detection3D] = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    @property
    def detections(self) -> list[vision_msgs.msg.Detection3D]: ...
    @detections.setter
    def detections(self, value: Collection[vision_msgs.msg.Detection3D]) -> None: ...

class LabelInfo(Message):
    """vision_msgs/msg/LabelInfo

    # What the numbers in an image of labels mean.

    std_msgs/Header header
    VisionClass[] class_map
    float32 threshold  # from which score a pixel has a label
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., class_map: Collection[vision_msgs.msg.VisionClass] = ..., threshold: float = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    @property
    def class_map(self) -> list[vision_msgs.msg.VisionClass]: ...
    @class_map.setter
    def class_map(self, value: Collection[vision_msgs.msg.VisionClass]) -> None: ...
    threshold: float

class ObjectHypothesis(Message):
    """vision_msgs/msg/ObjectHypothesis

    # What something could be.

    string class_id
    float64 score  # how sure it is; 0 to 1 by habit
    """
    def __init__(self, *, class_id: str = ..., score: float = ..., check_fields: bool = ...) -> None: ...
    class_id: str
    score: float

class ObjectHypothesisWithPose(Message):
    """vision_msgs/msg/ObjectHypothesisWithPose

    # What something could be, and where.

    ObjectHypothesis hypothesis
    geometry_msgs/PoseWithCovariance pose
    """
    def __init__(self, *, hypothesis: vision_msgs.msg.ObjectHypothesis = ..., pose: geometry_msgs.msg.PoseWithCovariance = ..., check_fields: bool = ...) -> None: ...
    hypothesis: vision_msgs.msg.ObjectHypothesis
    pose: geometry_msgs.msg.PoseWithCovariance

class Point2D(Message):
    """vision_msgs/msg/Point2D

    # A place in an image, in pixels from its upper left corner; fractions are allowed.

    float64 x
    float64 y
    """
    def __init__(self, *, x: float = ..., y: float = ..., check_fields: bool = ...) -> None: ...
    x: float
    y: float

class Pose2D(Message):
    """vision_msgs/msg/Pose2D

    # A place in an image, and how far something there is turned.

    Point2D position
    float64 theta  # rad
    """
    def __init__(self, *, position: vision_msgs.msg.Point2D = ..., theta: float = ..., check_fields: bool = ...) -> None: ...
    position: vision_msgs.msg.Point2D
    theta: float

class VisionClass(Message):
    """vision_msgs/msg/VisionClass

    # The name of a number that an image of labels is made of.

    uint16 class_id
    string class_name
    """
    def __init__(self, *, class_id: int = ..., class_name: str = ..., check_fields: bool = ...) -> None: ...
    class_id: int
    class_name: str

class VisionInfo(Message):
    """vision_msgs/msg/VisionInfo

    # What finds things in images, and where the names of what it finds are kept.

    std_msgs/Header header
    string method
    string database_location
    int32 database_version  # counts up when the database changes
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., method: str = ..., database_location: str = ..., database_version: int = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    method: str
    database_location: str
    database_version: int
