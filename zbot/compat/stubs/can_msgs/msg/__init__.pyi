# Written by python -m zbot.interfaces.stubs; do not edit.
from array import array
from collections.abc import Collection
from typing import Final, TypeAlias

import numpy
from numpy.typing import NDArray

import std_msgs.msg
from zbot.interfaces import Action, Message, Service

class Frame(Message):
    """can_msgs/msg/Frame

    std_msgs/Header header
    uint32 id
    bool is_rtr
    bool is_extended
    bool is_error
    uint8 dlc
    uint8[8] data
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., id: int = ..., is_rtr: bool = ..., is_extended: bool = ..., is_error: bool = ..., dlc: int = ..., data: Collection[int] = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    id: int
    is_rtr: bool
    is_extended: bool
    is_error: bool
    dlc: int
    @property
    def data(self) -> NDArray[numpy.uint8]: ...
    @data.setter
    def data(self, value: Collection[int]) -> None: ...
