"""Timers and rates."""

from zbot.callback_group import CallbackGroup as CallbackGroup
from zbot.clock import Clock as Clock
from zbot.context import Context as Context
from zbot.context import get_default_context as get_default_context
from zbot.errors import InvalidHandleError as InvalidHandle
from zbot.errors import RateInterruptedError as ROSInterruptException
from zbot.time import ClockType as ClockType
from zbot.time import Time as Time
from zbot.timer import Rate as Rate
from zbot.timer import Timer as Timer
from zbot.timer import TimerInfo as TimerInfo
