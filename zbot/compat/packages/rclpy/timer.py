# Written by python -m zbot.compat.generator; do not edit.
"""Timers and rates."""

from zbot.context import Context, get_default_context
from zbot.errors import InvalidHandleError as InvalidHandle
from zbot.executor.callback_group import CallbackGroup
from zbot.executor.clock import Clock
from zbot.executor.errors import RateInterruptedError as ROSInterruptException
from zbot.executor.timer import Rate, Timer, TimerInfo
from zbot.time import ClockType, Time

__all__ = [
    "CallbackGroup",
    "Clock",
    "ClockType",
    "Context",
    "InvalidHandle",
    "ROSInterruptException",
    "Rate",
    "Time",
    "Timer",
    "TimerInfo",
    "get_default_context",
]
