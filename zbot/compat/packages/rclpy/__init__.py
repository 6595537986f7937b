"""ROS 2's `rclpy`: every name is zbot's."""

from zbot.compat.submodules import submodules
from zbot.context import Context as Context
from zbot.context import get_default_context as get_default_context
from zbot.executor.task import Future as Future
from zbot.parameters.parameter import Parameter as Parameter
from zbot.process.signals import SignalHandlerOptions as SignalHandlerOptions
from zbot.process.signals import install as install_signal_handlers
from zbot.process.signals import uninstall as uninstall_signal_handlers
from zbot.qos import QoSProfile as QoSProfile
from zbot.qos import qos_profile_rosout_default as qos_profile_rosout_default
from zbot.runtime import InitContextManager as InitContextManager
from zbot.runtime import create_node as create_node
from zbot.runtime import get_global_executor as get_global_executor
from zbot.runtime import get_rmw_implementation_identifier as get_rmw_implementation_identifier
from zbot.runtime import init as init
from zbot.runtime import ok as ok
from zbot.runtime import shutdown as shutdown
from zbot.runtime import spin as spin
from zbot.runtime import spin_once as spin_once
from zbot.runtime import spin_until_future_complete as spin_until_future_complete
from zbot.runtime import try_shutdown as try_shutdown

__getattr__ = submodules(
    __name__,
    "action",
    "callback_groups",
    "client",
    "clock",
    "clock_type",
    "constants",
    "context",
    "duration",
    "event_handler",
    "exceptions",
    "executors",
    "expand_topic_name",
    "experimental",
    "guard_condition",
    "impl",
    "lifecycle",
    "logging",
    "logging_service",
    "node",
    "parameter",
    "parameter_client",
    "parameter_event_handler",
    "parameter_service",
    "publisher",
    "qos",
    "qos_event",
    "qos_overriding_options",
    "serialization",
    "service",
    "service_introspection",
    "signals",
    "subscription",
    "subscription_content_filter_options",
    "task",
    "time",
    "time_source",
    "timer",
    "topic_endpoint_info",
    "topic_or_service_is_hidden",
    "type_description_service",
    "type_hash",
    "type_support",
    "utilities",
    "validate_full_topic_name",
    "validate_namespace",
    "validate_node_name",
    "validate_parameter_name",
    "validate_topic_name",
    "wait_for_message",
    "waitable",
)
