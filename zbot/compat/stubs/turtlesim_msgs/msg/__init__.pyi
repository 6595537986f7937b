# Written by python -m zbot.interfaces.stubs; do not edit.
from array import array
from collections.abc import Collection
from typing import Final, TypeAlias

import numpy
from numpy.typing import NDArray

from zbot.interfaces import Action, Message, Service

class Color(Message):
    """turtlesim_msgs/msg/Color

    # The colour under a turtle, as its sensor sees it; each channel from 0 to 255.

    uint8 r
    uint8 g
    uint8 b
    """
    def __init__(self, *, r: int = ..., g: int = ..., b: int = ..., check_fields: bool = ...) -> None: ...
    r: int
    g: int
    b: int

class Pose(Message):
    """turtlesim_msgs/msg/Pose

    # Where a turtle is and how it moves. (0, 0) is the lower left corner of the window.

    float32 x # m to the right
    float32 y # m up
    float32 theta # heading in rad, 0 is right, counterclockwise is positive

    float32 linear_velocity # m/s, never negative
    float32 angular_velocity # rad/s
    """
    def __init__(self, *, x: float = ..., y: float = ..., theta: float = ..., linear_velocity: float = ..., angular_velocity: float = ..., check_fields: bool = ...) -> None: ...
    x: float
    y: float
    theta: float
    linear_velocity: float
    angular_velocity: float
