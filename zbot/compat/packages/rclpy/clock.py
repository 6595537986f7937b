"""Clocks."""

from zbot.clock import Clock as Clock
from zbot.clock import ClockChange as ClockChange
from zbot.clock import JumpHandle as JumpHandle
from zbot.clock import JumpThreshold as JumpThreshold
from zbot.clock import ROSClock as ROSClock
from zbot.clock import TimeJump as TimeJump
from zbot.compat.annotation import JumpHandlePreCallbackType as JumpHandlePreCallbackType
from zbot.compat.annotation import TimeJumpDictionary as TimeJumpDictionary
from zbot.context import Context as Context
from zbot.context import get_default_context as get_default_context
from zbot.errors import NotInitializedError as NotInitializedException
from zbot.time import ClockType as ClockType
from zbot.time import Duration as Duration
from zbot.time import Time as Time
