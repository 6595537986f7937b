# Written by python -m zbot.interfaces.stubs; do not edit.
from array import array
from collections.abc import Collection
from typing import Final, TypeAlias

import numpy
from numpy.typing import NDArray

import std_msgs.msg
from zbot.interfaces import Action, Message, Service

class SensorState(Message):
    """turtlebot3_msgs/msg/SensorState

    # State of the sensors of a TurtleBot3.

    uint8 BUMPER_FORWARD=1
    uint8 BUMPER_BACKWARD=2
    uint8 CLIFF=1
    uint8 SONAR=1
    uint8 ILLUMINATION=1
    uint8 BUTTON0=1
    uint8 BUTTON1=2
    uint8 ERROR_LEFT_MOTOR=1
    uint8 ERROR_RIGHT_MOTOR=2
    uint8 TORQUE_ON=1
    uint8 TORQUE_OFF=2
    std_msgs/Header header
    uint8 bumper  # BUMPER_...
    float32 cliff  # CLIFF
    float32 sonar  # SONAR
    float32 illumination  # ILLUMINATION
    uint8 led
    uint8 button  # BUTTON...
    bool torque  # the motors are on
    int32 left_encoder  # counts
    int32 right_encoder  # counts
    float32 battery  # V
    """
    BUMPER_FORWARD: Final = 1
    BUMPER_BACKWARD: Final = 2
    CLIFF: Final = 1
    SONAR: Final = 1
    ILLUMINATION: Final = 1
    BUTTON0: Final = 1
    BUTTON1: Final = 2
    ERROR_LEFT_MOTOR: Final = 1
    ERROR_RIGHT_MOTOR: Final = 2
    TORQUE_ON: Final = 1
    TORQUE_OFF: Final = 2
    def __init__(self, *, header: std_msgs.msg.Header = ..., bumper: int = ..., cliff: float = ..., sonar: float = ..., illumination: float = ..., led: int = ..., button: int = ..., torque: bool = ..., left_encoder: int = ..., right_encoder: int = ..., battery: float = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    bumper: int
    cliff: float
    sonar: float
    illumination: float
    led: int
    button: int
    torque: bool
    left_encoder: int
    right_encoder: int
    battery: float

class Sound(Message):
    """turtlebot3_msgs/msg/Sound

    # A sound of a TurtleBot3.

    uint8 OFF=0
    uint8 ON=1
    uint8 LOW_BATTERY=2
    uint8 ERROR=3
    uint8 BUTTON1=4
    uint8 BUTTON2=5
    uint8 value
    """
    OFF: Final = 0
    ON: Final = 1
    LOW_BATTERY: Final = 2
    ERROR: Final = 3
    BUTTON1: Final = 4
    BUTTON2: Final = 5
    def __init__(self, *, value: int = ..., check_fields: bool = ...) -> None: ...
    value: int

class VersionInfo(Message):
    """turtlebot3_msgs/msg/VersionInfo

    # Versions of a TurtleBot3.

    string hardware
    string firmware
    string software
    """
    def __init__(self, *, hardware: str = ..., firmware: str = ..., software: str = ..., check_fields: bool = ...) -> None: ...
    hardware: str
    firmware: str
    software: str
