# Written by python -m zbot.interfaces.stubs; do not edit.
from array import array
from collections.abc import Collection
from typing import Final, TypeAlias

import numpy
from numpy.typing import NDArray

import apriltag_msgs.msg
import std_msgs.msg
from zbot.interfaces import Action, Message, Service

class AprilTagDetection(Message):
    """apriltag_msgs/msg/AprilTagDetection

    # A tag that was found in an image.

    string family  # e.g. tag36h11
    int32 id
    int32 hamming  # bits that were corrected
    float32 goodness
    float32 decision_margin  # large: sure
    Point centre  # pixels
    Point[4] corners  # pixels
    float64[9] homography  # from the tag to the image
    """
    def __init__(self, *, family: str = ..., id: int = ..., hamming: int = ..., goodness: float = ..., decision_margin: float = ..., centre: apriltag_msgs.msg.Point = ..., corners: Collection[apriltag_msgs.msg.Point] = ..., homography: Collection[float] = ..., check_fields: bool = ...) -> None: ...
    family: str
    id: int
    hamming: int
    goodness: float
    decision_margin: float
    centre: apriltag_msgs.msg.Point
    @property
    def corners(self) -> list[apriltag_msgs.msg.Point]: ...
    @corners.setter
    def corners(self, value: Collection[apriltag_msgs.msg.Point]) -> None: ...
    @property
    def homography(self) -> NDArray[numpy.float64]: ...
    @homography.setter
    def homography(self, value: Collection[float]) -> None: ...

class AprilTagDetectionArray(Message):
    """apriltag_msgs/msg/AprilTagDetectionArray

    # Tags that were found in an image.

    std_msgs/Header header
    AprilTagDetection[] detections
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., detections: Collection[apriltag_msgs.msg.AprilTagDetection] = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    @property
    def detections(self) -> list[apriltag_msgs.msg.AprilTagDetection]: ...
    @detections.setter
    def detections(self, value: Collection[apriltag_msgs.msg.AprilTagDetection]) -> None: ...

class Point(Message):
    """apriltag_msgs/msg/Point

    # A point in an image.

    float64 x  # pixels
    float64 y  # pixels
    """
    def __init__(self, *, x: float = ..., y: float = ..., check_fields: bool = ...) -> None: ...
    x: float
    y: float
