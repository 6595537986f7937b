# Written by python -m zbot.compat.generator; do not edit.
"""Executors, and the exceptions that end them."""

from zbot.compat.annotation import YieldedCallback
from zbot.context import Context, get_default_context
from zbot.errors import ExternalShutdownException, InvalidHandleError as InvalidHandle
from zbot.executor.clock import Clock
from zbot.executor.errors import (
    ConditionReachedException,
    ShutdownError as ShutdownException,
    TimerCancelledError,
)
from zbot.executor.executor import Executor
from zbot.executor.guard_condition import GuardCondition, SignalHandlerGuardCondition
from zbot.executor.multi_threaded_executor import MultiThreadedExecutor
from zbot.executor.single_threaded_executor import SingleThreadedExecutor
from zbot.executor.task import Future, Task, await_or_execute
from zbot.executor.timer import Timer, TimerInfo
from zbot.executor.waitable import NumberOfEntities, Waitable
from zbot.interfaces.message import Message as Msg
from zbot.node.client import Client
from zbot.node.message_info import MessageInfo
from zbot.node.service import Service
from zbot.node.subscription import Subscription
from zbot.time import ClockType, TimeoutObject, timeout_sec_to_nsec
from builtins import TimeoutError as TimeoutException

__all__ = [
    "Client",
    "Clock",
    "ClockType",
    "ConditionReachedException",
    "Context",
    "Executor",
    "ExternalShutdownException",
    "Future",
    "GuardCondition",
    "InvalidHandle",
    "MessageInfo",
    "Msg",
    "MultiThreadedExecutor",
    "NumberOfEntities",
    "Service",
    "ShutdownException",
    "SignalHandlerGuardCondition",
    "SingleThreadedExecutor",
    "Subscription",
    "Task",
    "TimeoutException",
    "TimeoutObject",
    "Timer",
    "TimerCancelledError",
    "TimerInfo",
    "Waitable",
    "YieldedCallback",
    "await_or_execute",
    "get_default_context",
    "timeout_sec_to_nsec",
]
