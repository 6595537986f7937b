# Written by python -m zbot.interfaces.stubs; do not edit.
from array import array
from collections.abc import Collection
from typing import Final, TypeAlias

import numpy
from numpy.typing import NDArray

import turtlesim.msg
from zbot.interfaces import Action, Message, Service

class SceneTurtle(Message):
    """zbot_msgs/msg/SceneTurtle

    # A turtle as a page shows it.

    string name
    float32 x # metres from the left edge
    float32 y # metres from the lower edge
    float32 theta # heading in radians, counter-clockwise from the right
    turtlesim/Color pen
    uint8 pen_width # in pixels
    bool is_pen_down
    """
    def __init__(self, *, name: str = ..., x: float = ..., y: float = ..., theta: float = ..., pen: turtlesim.msg.Color = ..., pen_width: int = ..., is_pen_down: bool = ..., check_fields: bool = ...) -> None: ...
    name: str
    x: float
    y: float
    theta: float
    pen: turtlesim.msg.Color
    pen_width: int
    is_pen_down: bool
