# Written by python -m zbot.interfaces.stubs; do not edit.
from array import array
from collections.abc import Collection
from typing import Final, TypeAlias

import numpy
from numpy.typing import NDArray

import ackermann_msgs.msg
import std_msgs.msg
from zbot.interfaces import Action, Message, Service

class AckermannDrive(Message):
    """ackermann_msgs/msg/AckermannDrive

    # How a car-like vehicle is to drive, steered by its front wheels.

    # Of a single wheel in the middle of the front axle, positive to the left.
    float32 steering_angle           # rad
    float32 steering_angle_velocity  # rad/s; 0: as fast as it can

    # Of the middle of the rear axle; the sign of the speed says which way.
    float32 speed         # m/s
    float32 acceleration  # m/s^2, its amount; 0: as strongly as it can
    float32 jerk          # m/s^3, its amount; 0: as hard as it can
    """
    def __init__(self, *, steering_angle: float = ..., steering_angle_velocity: float = ..., speed: float = ..., acceleration: float = ..., jerk: float = ..., check_fields: bool = ...) -> None: ...
    steering_angle: float
    steering_angle_velocity: float
    speed: float
    acceleration: float
    jerk: float

class AckermannDriveStamped(Message):
    """ackermann_msgs/msg/AckermannDriveStamped

    # How a car-like vehicle is to drive, and since when.

    std_msgs/Header header
    AckermannDrive drive
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., drive: ackermann_msgs.msg.AckermannDrive = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    drive: ackermann_msgs.msg.AckermannDrive
