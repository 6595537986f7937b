# Written by python -m zbot.interfaces.stubs; do not edit.
from array import array
from collections.abc import Collection
from typing import Final, TypeAlias

import numpy
from numpy.typing import NDArray

from zbot.interfaces import Action, Message, Service

class Duration(Message):
    """builtin_interfaces/msg/Duration

    # A span of time between two moments; may be negative.

    # Whole seconds, rounded down: -0.5 s is sec -1 with nanosec 500000000.
    int32 sec

    # Rest of the second in ns, from 0 to 999999999; always counts forward from sec.
    uint32 nanosec
    """
    def __init__(self, *, sec: int = ..., nanosec: int = ..., check_fields: bool = ...) -> None: ...
    sec: int
    nanosec: int

class Time(Message):
    """builtin_interfaces/msg/Time

    # A moment on the node's clock: wall time since 1970-01-01 00:00 UTC, or simulated time.

    # Whole seconds; negative before the epoch.
    int32 sec

    # Rest of the second in ns, from 0 to 999999999; always counts forward from sec.
    uint32 nanosec
    """
    def __init__(self, *, sec: int = ..., nanosec: int = ..., check_fields: bool = ...) -> None: ...
    sec: int
    nanosec: int
