# Written by python -m zbot.compat.generator; do not edit.
"""Changes of parameters."""

from zbot.executor.callback_group import CallbackGroup
from zbot.node.event_callbacks import SubscriptionEventCallbacks
from zbot.node.node import Node
from zbot.parameters.qos_overrides import QoSOverridingOptions
from zbot.qos import QoSProfile, qos_profile_parameter_events
from zbot.remote.parameter_event_handler import (
    ParameterCallbackHandle,
    ParameterEventCallbackHandle,
    ParameterEventHandler,
)
from rcl_interfaces.msg import Parameter as ParameterMsg, ParameterEvent

__all__ = [
    "CallbackGroup",
    "Node",
    "ParameterCallbackHandle",
    "ParameterEvent",
    "ParameterEventCallbackHandle",
    "ParameterEventHandler",
    "ParameterMsg",
    "QoSOverridingOptions",
    "QoSProfile",
    "SubscriptionEventCallbacks",
    "qos_profile_parameter_events",
]
