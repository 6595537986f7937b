# Written by python -m zbot.compat.generator; do not edit.
"""Clocks."""

from zbot.compat.annotation import JumpHandlePreCallbackType, TimeJumpDictionary
from zbot.context import Context, get_default_context
from zbot.errors import NotInitializedError as NotInitializedException
from zbot.executor.clock import Clock, ClockChange, JumpHandle, JumpThreshold, ROSClock, TimeJump
from zbot.time import ClockType, Duration, Time

__all__ = [
    "Clock",
    "ClockChange",
    "ClockType",
    "Context",
    "Duration",
    "JumpHandle",
    "JumpHandlePreCallbackType",
    "JumpThreshold",
    "NotInitializedException",
    "ROSClock",
    "Time",
    "TimeJump",
    "TimeJumpDictionary",
    "get_default_context",
]
