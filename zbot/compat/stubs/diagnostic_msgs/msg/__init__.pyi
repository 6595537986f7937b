# Written by python -m zbot.interfaces.stubs; do not edit.
from array import array
from collections.abc import Collection
from typing import Final, TypeAlias

import numpy
from numpy.typing import NDArray

import diagnostic_msgs.msg
import std_msgs.msg
from zbot.interfaces import Action, Message, Service

class DiagnosticArray(Message):
    """diagnostic_msgs/msg/DiagnosticArray

    # Health reports of parts of a robot, as sent on /diagnostics.

    std_msgs/Header header # when
    DiagnosticStatus[] status # one report per part
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., status: Collection[diagnostic_msgs.msg.DiagnosticStatus] = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    @property
    def status(self) -> list[diagnostic_msgs.msg.DiagnosticStatus]: ...
    @status.setter
    def status(self, value: Collection[diagnostic_msgs.msg.DiagnosticStatus]) -> None: ...

class DiagnosticStatus(Message):
    """diagnostic_msgs/msg/DiagnosticStatus

    # Health report of one part of a robot.

    # How well it does; STALE: not heard of for too long.
    byte OK=0
    byte WARN=1
    byte ERROR=2
    byte STALE=3

    # One of the levels above.
    byte level
    # Which part or test reports.
    string name
    # The report in a few words.
    string message
    # Identity of the hardware, such as a serial number.
    string hardware_id
    # Further details.
    KeyValue[] values
    """
    OK: Final = b'\x00'
    WARN: Final = b'\x01'
    ERROR: Final = b'\x02'
    STALE: Final = b'\x03'
    def __init__(self, *, level: bytes = ..., name: str = ..., message: str = ..., hardware_id: str = ..., values: Collection[diagnostic_msgs.msg.KeyValue] = ..., check_fields: bool = ...) -> None: ...
    level: bytes
    name: str
    message: str
    hardware_id: str
    @property
    def values(self) -> list[diagnostic_msgs.msg.KeyValue]: ...
    @values.setter
    def values(self, value: Collection[diagnostic_msgs.msg.KeyValue]) -> None: ...

class KeyValue(Message):
    """diagnostic_msgs/msg/KeyValue

    # A named detail of a health report.

    # Its name.
    string key
    # Its value, as text.
    string value
    """
    def __init__(self, *, key: str = ..., value: str = ..., check_fields: bool = ...) -> None: ...
    key: str
    value: str
