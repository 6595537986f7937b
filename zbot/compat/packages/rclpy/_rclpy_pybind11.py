"""Names of rclpy's C extension that programs use and zbot can offer."""

from zbot.action.goal_state import GoalEvent
from zbot.compat.raw_entities import Client, GuardCondition, Service, Subscription, Timer
from zbot.errors import InvalidHandleError as InvalidHandle
from zbot.errors import ZbotError as RCLError
from zbot.errors import ZbotError as RMWError
from zbot.executor.clock import ClockChange
from zbot.executor.errors import TimerCancelledError
from zbot.executor.single_threaded_executor import SingleThreadedExecutor as EventsExecutor
from zbot.executor.wait_set import WaitSet
from zbot.lifecycle import TransitionCallbackReturn as TransitionCallbackReturnType
from zbot.log import get_logger_effective_level as rclpy_logging_get_logger_effective_level
from zbot.log import get_logger_level as rclpy_logging_get_logger_level
from zbot.log import get_logging_directory as rclpy_logging_get_logging_directory
from zbot.log import set_logger_level as rclpy_logging_set_logger_level
from zbot.names import expand_topic_name as rclpy_expand_topic_name
from zbot.node.errors import UnknownNodeError as NodeNameNonExistentError
from zbot.node.errors import UnsupportedEventTypeError
from zbot.node.event_handlers import EventHandle
from zbot.node.qos_events import QoSPublisherEventType as rcl_publisher_event_type_t  # noqa: N813 - rclpy
from zbot.node.qos_events import QoSSubscriptionEventType as rcl_subscription_event_type_t  # noqa: N813
from zbot.parameters.errors import ArgumentsError as RCLInvalidROSArgsError
from zbot.parameters.errors import ArgumentsError as UnknownROSArgsError
from zbot.process.signals import SignalHandlerOptions
from zbot.process.signals import install as install_signal_handlers
from zbot.process.signals import installed as get_current_signal_handlers_options
from zbot.process.signals import uninstall as uninstall_signal_handlers
from zbot.qos import PlainQoSProfile as rmw_qos_profile_t  # noqa: N813 - rclpy's name
from zbot.qos import QoSCompatibility
from zbot.qos import qos_check_compatible as rclpy_qos_check_compatible
from zbot.runtime import (
    get_rmw_implementation_identifier as rclpy_get_rmw_implementation_identifier,
)
from zbot.time import ClockType
from zbot.wire.serialization import deserialize_message as rclpy_deserialize
from zbot.wire.serialization import serialize_message as rclpy_serialize
