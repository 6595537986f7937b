# Written by python -m zbot.interfaces.stubs; do not edit.
from array import array
from collections.abc import Collection
from typing import Final, TypeAlias

import numpy
from numpy.typing import NDArray

import builtin_interfaces.msg
import std_msgs.msg
import velodyne_msgs.msg
from zbot.interfaces import Action, Message, Service

class VelodynePacket(Message):
    """velodyne_msgs/msg/VelodynePacket

    builtin_interfaces/Time stamp
    uint8[1206] data
    """
    def __init__(self, *, stamp: builtin_interfaces.msg.Time = ..., data: Collection[int] = ..., check_fields: bool = ...) -> None: ...
    stamp: builtin_interfaces.msg.Time
    @property
    def data(self) -> NDArray[numpy.uint8]: ...
    @data.setter
    def data(self, value: Collection[int]) -> None: ...

class VelodyneScan(Message):
    """velodyne_msgs/msg/VelodyneScan

    std_msgs/Header header
    VelodynePacket[] packets
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., packets: Collection[velodyne_msgs.msg.VelodynePacket] = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    @property
    def packets(self) -> list[velodyne_msgs.msg.VelodynePacket]: ...
    @packets.setter
    def packets(self, value: Collection[velodyne_msgs.msg.VelodynePacket]) -> None: ...
