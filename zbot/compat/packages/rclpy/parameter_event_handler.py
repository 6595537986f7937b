"""Changes of parameters."""

from zbot.executor.callback_group import CallbackGroup as CallbackGroup
from zbot.node.event_callbacks import SubscriptionEventCallbacks as SubscriptionEventCallbacks
from zbot.node.node import Node as Node
from zbot.node.parameter_event_handler import ParameterCallbackHandle as ParameterCallbackHandle
from zbot.node.parameter_event_handler import (
    ParameterEventCallbackHandle as ParameterEventCallbackHandle,
)
from zbot.node.parameter_event_handler import ParameterEventHandler as ParameterEventHandler
from zbot.parameters.qos_overrides import QoSOverridingOptions as QoSOverridingOptions
from zbot.qos import QoSProfile as QoSProfile
from zbot.qos import qos_profile_parameter_events as qos_profile_parameter_events

from rcl_interfaces.msg import Parameter as ParameterMsg
from rcl_interfaces.msg import ParameterEvent as ParameterEvent
