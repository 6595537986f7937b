# Written by python -m zbot.compat.generator; do not edit.
"""Names of rclpy's C extension that programs use and zbot can offer."""

from zbot.action.goal_state import GoalEvent
from zbot.compat.raw_entities import Client, GuardCondition, Service, Subscription, Timer
from zbot.errors import (
    InvalidHandleError as InvalidHandle,
    ZbotError as RCLError,
    ZbotError as RMWError,
)
from zbot.executor.clock import ClockChange
from zbot.executor.errors import TimerCancelledError
from zbot.executor.single_threaded_executor import SingleThreadedExecutor as EventsExecutor
from zbot.executor.wait_set import WaitSet
from zbot.lifecycle import TransitionCallbackReturn as TransitionCallbackReturnType
from zbot.log import (
    get_logger_effective_level as rclpy_logging_get_logger_effective_level,
    get_logger_level as rclpy_logging_get_logger_level,
    get_logging_directory as rclpy_logging_get_logging_directory,
    set_logger_level as rclpy_logging_set_logger_level,
)
from zbot.names import expand_topic_name as rclpy_expand_topic_name
from zbot.node.errors import UnknownNodeError as NodeNameNonExistentError, UnsupportedEventTypeError
from zbot.node.event_handlers import EventHandle
from zbot.node.qos_events import (
    QoSPublisherEventType as rcl_publisher_event_type_t,
    QoSSubscriptionEventType as rcl_subscription_event_type_t,
)
from zbot.parameters.errors import (
    ArgumentsError as RCLInvalidROSArgsError,
    ArgumentsError as UnknownROSArgsError,
)
from zbot.process.signals import (
    SignalHandlerOptions,
    install as install_signal_handlers,
    installed as get_current_signal_handlers_options,
    uninstall as uninstall_signal_handlers,
)
from zbot.qos import (
    PlainQoSProfile as rmw_qos_profile_t,
    QoSCompatibility,
    qos_check_compatible as rclpy_qos_check_compatible,
)
from zbot.runtime import (
    get_rmw_implementation_identifier as rclpy_get_rmw_implementation_identifier,
)
from zbot.time import ClockType
from zbot.wire.serialization import (
    deserialize_message as rclpy_deserialize,
    serialize_message as rclpy_serialize,
)

__all__ = [
    "Client",
    "ClockChange",
    "ClockType",
    "EventHandle",
    "EventsExecutor",
    "GoalEvent",
    "GuardCondition",
    "InvalidHandle",
    "NodeNameNonExistentError",
    "QoSCompatibility",
    "RCLError",
    "RCLInvalidROSArgsError",
    "RMWError",
    "Service",
    "SignalHandlerOptions",
    "Subscription",
    "Timer",
    "TimerCancelledError",
    "TransitionCallbackReturnType",
    "UnknownROSArgsError",
    "UnsupportedEventTypeError",
    "WaitSet",
    "get_current_signal_handlers_options",
    "install_signal_handlers",
    "rcl_publisher_event_type_t",
    "rcl_subscription_event_type_t",
    "rclpy_deserialize",
    "rclpy_expand_topic_name",
    "rclpy_get_rmw_implementation_identifier",
    "rclpy_logging_get_logger_effective_level",
    "rclpy_logging_get_logger_level",
    "rclpy_logging_get_logging_directory",
    "rclpy_logging_set_logger_level",
    "rclpy_qos_check_compatible",
    "rclpy_serialize",
    "rmw_qos_profile_t",
    "uninstall_signal_handlers",
]
