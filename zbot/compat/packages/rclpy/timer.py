"""Timers and rates."""

from zbot.context import Context as Context
from zbot.context import get_default_context as get_default_context
from zbot.errors import InvalidHandleError as InvalidHandle
from zbot.executor.callback_group import CallbackGroup as CallbackGroup
from zbot.executor.clock import Clock as Clock
from zbot.executor.errors import RateInterruptedError as ROSInterruptException
from zbot.executor.timer import Rate as Rate
from zbot.executor.timer import Timer as Timer
from zbot.executor.timer import TimerInfo as TimerInfo
from zbot.time import ClockType as ClockType
from zbot.time import Time as Time
