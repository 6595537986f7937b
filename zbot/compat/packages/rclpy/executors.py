"""Executors, and what ends them."""

from zbot.compat.annotation import YieldedCallback as YieldedCallback
from zbot.context import Context as Context
from zbot.context import get_default_context as get_default_context
from zbot.errors import ExternalShutdownException as ExternalShutdownException
from zbot.errors import InvalidHandleError as InvalidHandle
from zbot.executor.clock import Clock as Clock
from zbot.executor.errors import ConditionReachedException as ConditionReachedException
from zbot.executor.errors import ShutdownError as ShutdownException
from zbot.executor.errors import TimerCancelledError as TimerCancelledError
from zbot.executor.executor import Executor as Executor
from zbot.executor.guard_condition import GuardCondition as GuardCondition
from zbot.executor.multi_threaded_executor import MultiThreadedExecutor as MultiThreadedExecutor
from zbot.executor.signal_guard_condition import (
    SignalHandlerGuardCondition as SignalHandlerGuardCondition,
)
from zbot.executor.single_threaded_executor import SingleThreadedExecutor as SingleThreadedExecutor
from zbot.executor.task import Future as Future
from zbot.executor.task import Task as Task
from zbot.executor.task import await_or_execute as await_or_execute
from zbot.executor.timer import Timer as Timer
from zbot.executor.timer import TimerInfo as TimerInfo
from zbot.executor.waitable import NumberOfEntities as NumberOfEntities
from zbot.executor.waitable import Waitable as Waitable
from zbot.interfaces.message import Message as Msg
from zbot.node.client import Client as Client
from zbot.node.message_info import MessageInfo as MessageInfo
from zbot.node.service import Service as Service
from zbot.node.subscription import Subscription as Subscription
from zbot.time import ClockType as ClockType
from zbot.time import TimeoutObject as TimeoutObject
from zbot.time import timeout_sec_to_nsec as timeout_sec_to_nsec

TimeoutException = TimeoutError
