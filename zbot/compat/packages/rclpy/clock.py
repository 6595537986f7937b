"""Clocks."""

from zbot.compat.annotation import JumpHandlePreCallbackType, TimeJumpDictionary
from zbot.context import Context, get_default_context
from zbot.errors import NotInitializedError as NotInitializedException
from zbot.executor.clock import Clock, ClockChange, JumpHandle, JumpThreshold, ROSClock, TimeJump
from zbot.time import ClockType, Duration, Time
