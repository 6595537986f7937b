# Written by python -m zbot.interfaces.stubs; do not edit.
from array import array
from collections.abc import Collection
from typing import Final, TypeAlias

import numpy
from numpy.typing import NDArray

import std_msgs.msg
from zbot.interfaces import Action, Message, Service

class Constants(Message):
    """bond/msg/Constants

    float32 DEAD_PUBLISH_PERIOD=0.05
    float32 DEFAULT_CONNECT_TIMEOUT=10.0
    float32 DEFAULT_HEARTBEAT_TIMEOUT=4.0
    float32 DEFAULT_DISCONNECT_TIMEOUT=2.0
    float32 DEFAULT_HEARTBEAT_PERIOD=1.0
    string DISABLE_HEARTBEAT_TIMEOUT_PARAM=/bond_disable_heartbeat_timeout
    """
    DEAD_PUBLISH_PERIOD: Final = 0.05
    DEFAULT_CONNECT_TIMEOUT: Final = 10.0
    DEFAULT_HEARTBEAT_TIMEOUT: Final = 4.0
    DEFAULT_DISCONNECT_TIMEOUT: Final = 2.0
    DEFAULT_HEARTBEAT_PERIOD: Final = 1.0
    DISABLE_HEARTBEAT_TIMEOUT_PARAM: Final = '/bond_disable_heartbeat_timeout'
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class Status(Message):
    """bond/msg/Status

    std_msgs/Header header
    string id
    string instance_id
    bool active
    float32 heartbeat_timeout
    float32 heartbeat_period
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., id: str = ..., instance_id: str = ..., active: bool = ..., heartbeat_timeout: float = ..., heartbeat_period: float = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    id: str
    instance_id: str
    active: bool
    heartbeat_timeout: float
    heartbeat_period: float
