"""Clocks."""

from zbot.compat.annotation import JumpHandlePreCallbackType as JumpHandlePreCallbackType
from zbot.compat.annotation import TimeJumpDictionary as TimeJumpDictionary
from zbot.context import Context as Context
from zbot.context import get_default_context as get_default_context
from zbot.errors import NotInitializedError as NotInitializedException
from zbot.executor.clock import Clock as Clock
from zbot.executor.clock import ClockChange as ClockChange
from zbot.executor.clock import JumpHandle as JumpHandle
from zbot.executor.clock import JumpThreshold as JumpThreshold
from zbot.executor.clock import ROSClock as ROSClock
from zbot.executor.clock import TimeJump as TimeJump
from zbot.time import ClockType as ClockType
from zbot.time import Duration as Duration
from zbot.time import Time as Time
