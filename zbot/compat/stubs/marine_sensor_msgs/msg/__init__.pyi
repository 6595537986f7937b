# Written by python -m zbot.interfaces.stubs; do not edit.
from array import array
from collections.abc import Collection
from typing import Final, TypeAlias

import numpy
from numpy.typing import NDArray

import builtin_interfaces.msg
import marine_sensor_msgs.msg
import std_msgs.msg
from zbot.interfaces import Action, Message, Service

class RadarEcho(Message):
    """marine_sensor_msgs/msg/RadarEcho

    float32[] echoes
    """
    def __init__(self, *, echoes: Collection[float] = ..., check_fields: bool = ...) -> None: ...
    @property
    def echoes(self) -> array[float]: ...
    @echoes.setter
    def echoes(self, value: Collection[float]) -> None: ...

class RadarSector(Message):
    """marine_sensor_msgs/msg/RadarSector

    std_msgs/Header header
    float32 angle_start
    float32 angle_increment
    builtin_interfaces/Duration time_increment
    builtin_interfaces/Duration scan_time
    float32 range_min
    float32 range_max
    RadarEcho[] intensities
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., angle_start: float = ..., angle_increment: float = ..., time_increment: builtin_interfaces.msg.Duration = ..., scan_time: builtin_interfaces.msg.Duration = ..., range_min: float = ..., range_max: float = ..., intensities: Collection[marine_sensor_msgs.msg.RadarEcho] = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    angle_start: float
    angle_increment: float
    time_increment: builtin_interfaces.msg.Duration
    scan_time: builtin_interfaces.msg.Duration
    range_min: float
    range_max: float
    @property
    def intensities(self) -> list[marine_sensor_msgs.msg.RadarEcho]: ...
    @intensities.setter
    def intensities(self, value: Collection[marine_sensor_msgs.msg.RadarEcho]) -> None: ...

class TurbidityNTU(Message):
    """marine_sensor_msgs/msg/TurbidityNTU

    std_msgs/Header header
    float32 ntu
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., ntu: float = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    ntu: float
