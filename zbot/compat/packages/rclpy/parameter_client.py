# Written by python -m zbot.compat.generator; do not edit.
"""Client for the parameters of other nodes."""

from zbot.executor.callback_group import CallbackGroup
from zbot.executor.task import Future
from zbot.node.client import Client
from zbot.node.event_callbacks import SubscriptionEventCallbacks
from zbot.node.message_info import MessageInfo
from zbot.node.node import Node
from zbot.node.subscription import Subscription
from zbot.parameters.parameter import Parameter, parameter_dict_from_yaml_file
from zbot.parameters.qos_overrides import QoSOverridingOptions
from zbot.qos import QoSProfile, qos_profile_parameter_events, qos_profile_services_default
from zbot.remote.parameter_client import AsyncParameterClient
from rcl_interfaces.msg import Parameter as ParameterMsg, ParameterEvent
from rcl_interfaces.srv import (
    DescribeParameters,
    GetParameterTypes,
    GetParameters,
    ListParameters,
    SetParameters,
    SetParametersAtomically,
)

__all__ = [
    "AsyncParameterClient",
    "CallbackGroup",
    "Client",
    "DescribeParameters",
    "Future",
    "GetParameterTypes",
    "GetParameters",
    "ListParameters",
    "MessageInfo",
    "Node",
    "Parameter",
    "ParameterEvent",
    "ParameterMsg",
    "QoSOverridingOptions",
    "QoSProfile",
    "SetParameters",
    "SetParametersAtomically",
    "Subscription",
    "SubscriptionEventCallbacks",
    "parameter_dict_from_yaml_file",
    "qos_profile_parameter_events",
    "qos_profile_services_default",
]
