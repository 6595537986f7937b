# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's `rclpy`, with classes and functions of zbot."""

from typing import TYPE_CHECKING

from zbot.lazy_imports import lazy_names
from zbot.context import Context, get_default_context
from zbot.executor.task import Future
from zbot.parameters.parameter import Parameter
from zbot.process.signals import (
    SignalHandlerOptions,
    install as install_signal_handlers,
    uninstall as uninstall_signal_handlers,
)
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

__all__ = [
    "Context",
    "Future",
    "InitContextManager",
    "Parameter",
    "QoSProfile",
    "SignalHandlerOptions",
    "create_node",
    "get_default_context",
    "get_global_executor",
    "get_rmw_implementation_identifier",
    "init",
    "install_signal_handlers",
    "ok",
    "qos_profile_rosout_default",
    "shutdown",
    "spin",
    "spin_once",
    "spin_until_future_complete",
    "try_shutdown",
    "uninstall_signal_handlers",
]

if TYPE_CHECKING:
    from . import action as action
    from . import callback_groups as callback_groups
    from . import client as client
    from . import clock as clock
    from . import clock_type as clock_type
    from . import constants as constants
    from . import context as context
    from . import duration as duration
    from . import event_handler as event_handler
    from . import exceptions as exceptions
    from . import executors as executors
    from . import expand_topic_name as expand_topic_name
    from . import experimental as experimental
    from . import guard_condition as guard_condition
    from . import impl as impl
    from . import lifecycle as lifecycle
    from . import logging as logging
    from . import logging_service as logging_service
    from . import node as node
    from . import parameter as parameter
    from . import parameter_client as parameter_client
    from . import parameter_event_handler as parameter_event_handler
    from . import parameter_service as parameter_service
    from . import publisher as publisher
    from . import qos as qos
    from . import qos_event as qos_event
    from . import qos_overriding_options as qos_overriding_options
    from . import serialization as serialization
    from . import service as service
    from . import service_introspection as service_introspection
    from . import signals as signals
    from . import subscription as subscription
    from . import subscription_content_filter_options as subscription_content_filter_options
    from . import task as task
    from . import time as time
    from . import time_source as time_source
    from . import timer as timer
    from . import topic_endpoint_info as topic_endpoint_info
    from . import topic_or_service_is_hidden as topic_or_service_is_hidden
    from . import type_description_service as type_description_service
    from . import type_hash as type_hash
    from . import type_support as type_support
    from . import utilities as utilities
    from . import validate_full_topic_name as validate_full_topic_name
    from . import validate_namespace as validate_namespace
    from . import validate_node_name as validate_node_name
    from . import validate_parameter_name as validate_parameter_name
    from . import validate_topic_name as validate_topic_name
    from . import wait_for_message as wait_for_message
    from . import waitable as waitable
else:
    __getattr__ = lazy_names(
        __name__,
        {
        },
        submodules=(
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
        ),
    )[0]
