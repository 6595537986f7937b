"""ROS 2's `rclpy`, with classes and functions of zbot."""

from zbot.compat.submodules import submodules
from zbot.context import Context, get_default_context
from zbot.executor.task import Future
from zbot.parameters.parameter import Parameter
from zbot.process.signals import SignalHandlerOptions
from zbot.process.signals import install as install_signal_handlers
from zbot.process.signals import uninstall as uninstall_signal_handlers
from zbot.qos import QoSProfile, qos_profile_rosout_default
from zbot.runtime import (
    InitContextManager,
    create_node,
    get_global_executor,
    get_rmw_implementation_identifier,
    init,
    ok,
    shutdown,
    spin,
    spin_once,
    spin_until_future_complete,
    try_shutdown,
)

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
