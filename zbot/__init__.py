"""ROS 2's concepts, words and commands in pure Python, over Eclipse Zenoh.

    import zbot
    from std_msgs.msg import String

    with zbot.init():
        node = zbot.Node("talker")
        publisher = node.create_publisher(String, "chatter", 10)
        node.create_timer(1.0, lambda: publisher.publish(String(data="hello")))
        zbot.spin(node)

The names, arguments and meanings are those of ROS 2's rclpy.

PYTEST_DONT_REWRITE tells pytest not to warn if zbot is imported before pytest's plugins. In a
sourced workspace, this is the case.
"""

from typing import TYPE_CHECKING

from zbot.interfaces.finder import install_importer
from zbot.lazy_imports import lazy_names
from zbot.version import __version__ as __version__

if TYPE_CHECKING:
    from zbot.context import Context as Context
    from zbot.context import get_default_context as get_default_context
    from zbot.errors import ExternalShutdownException as ExternalShutdownException
    from zbot.errors import ZbotError as ZbotError
    from zbot.executor.callback_group import CallbackGroup as CallbackGroup
    from zbot.executor.callback_group import (
        MutuallyExclusiveCallbackGroup as MutuallyExclusiveCallbackGroup,
    )
    from zbot.executor.callback_group import ReentrantCallbackGroup as ReentrantCallbackGroup
    from zbot.executor.clock import Clock as Clock
    from zbot.executor.clock import ROSClock as ROSClock
    from zbot.executor.executor import Executor as Executor
    from zbot.executor.multi_threaded_executor import MultiThreadedExecutor as MultiThreadedExecutor
    from zbot.executor.single_threaded_executor import (
        SingleThreadedExecutor as SingleThreadedExecutor,
    )
    from zbot.executor.task import Future as Future
    from zbot.executor.task import Task as Task
    from zbot.executor.timer import Rate as Rate
    from zbot.executor.timer import Timer as Timer
    from zbot.log import LoggingSeverity as LoggingSeverity
    from zbot.log import get_logger as get_logger
    from zbot.node.message_info import MessageInfo as MessageInfo
    from zbot.node.node import Node as Node
    from zbot.node.publisher import Publisher as Publisher
    from zbot.node.subscription import Subscription as Subscription
    from zbot.parameters.parameter import Parameter as Parameter
    from zbot.process.signals import SignalHandlerOptions as SignalHandlerOptions
    from zbot.qos import DurabilityPolicy as DurabilityPolicy
    from zbot.qos import HistoryPolicy as HistoryPolicy
    from zbot.qos import LivelinessPolicy as LivelinessPolicy
    from zbot.qos import QoSPresetProfiles as QoSPresetProfiles
    from zbot.qos import QoSProfile as QoSProfile
    from zbot.qos import ReliabilityPolicy as ReliabilityPolicy
    from zbot.runtime import create_node as create_node
    from zbot.runtime import get_global_executor as get_global_executor
    from zbot.runtime import init as init
    from zbot.runtime import ok as ok
    from zbot.runtime import shutdown as shutdown
    from zbot.runtime import spin as spin
    from zbot.runtime import spin_once as spin_once
    from zbot.runtime import spin_until_future_complete as spin_until_future_complete
    from zbot.runtime import try_shutdown as try_shutdown
    from zbot.time import ClockType as ClockType
    from zbot.time import Duration as Duration
    from zbot.time import Time as Time

# The public names of each module. A name is imported at its first use: a command that lists topics
# must not wait for the import of executors.
_MODULES = {
    "zbot.context": "Context get_default_context",
    "zbot.errors": "ZbotError ExternalShutdownException",
    "zbot.executor.callback_group": (
        "CallbackGroup MutuallyExclusiveCallbackGroup ReentrantCallbackGroup"
    ),
    "zbot.executor.clock": "Clock ROSClock",
    "zbot.executor.executor": "Executor",
    "zbot.executor.multi_threaded_executor": "MultiThreadedExecutor",
    "zbot.executor.single_threaded_executor": "SingleThreadedExecutor",
    "zbot.executor.task": "Future Task",
    "zbot.executor.timer": "Rate Timer",
    "zbot.log": "LoggingSeverity get_logger",
    "zbot.node.message_info": "MessageInfo",
    "zbot.node.node": "Node",
    "zbot.node.publisher": "Publisher",
    "zbot.node.subscription": "Subscription",
    "zbot.parameters.parameter": "Parameter",
    "zbot.process.signals": "SignalHandlerOptions",
    "zbot.qos": (
        "DurabilityPolicy HistoryPolicy LivelinessPolicy QoSPresetProfiles QoSProfile "
        "ReliabilityPolicy"
    ),
    "zbot.runtime": (
        "create_node get_global_executor init ok shutdown spin spin_once "
        "spin_until_future_complete try_shutdown"
    ),
    "zbot.time": "ClockType Duration Time",
}

__getattr__, __dir__ = lazy_names(__name__, _MODULES, "__version__")

# This lets `from std_msgs.msg import String` work where a real ROS 2 does not provide it.
install_importer()
