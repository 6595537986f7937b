# Written by python -m zbot.compat.generator; do not edit.
"""Parameters that override the quality of service."""

from zbot.compat.annotation import QoSProfileAttributes, QosCallbackType
from zbot.node.node import Node
from zbot.node.publisher import Publisher
from zbot.node.subscription import Subscription
from zbot.parameters.errors import InvalidQosOverridesError, ParameterAlreadyDeclaredException
from zbot.parameters.parameter import Parameter
from zbot.parameters.qos_overrides import (
    QoSOverridingOptions,
    override,
    policy_parameter as _get_qos_policy_parameter,
)
from zbot.qos import (
    QoSDurabilityPolicy,
    QoSHistoryPolicy,
    QoSLivelinessPolicy,
    QoSPolicyKind,
    QoSProfile,
    QoSReliabilityPolicy,
)
from zbot.time import Duration
from rcl_interfaces.msg import (
    ParameterDescriptor,
    SetParametersResult,
    SetParametersResult as QosCallbackResult,
)
from zbot.compat.qos_parameters import declare_qos_parameters as _declare_qos_parameters

__all__ = [
    "Duration",
    "InvalidQosOverridesError",
    "Node",
    "Parameter",
    "ParameterAlreadyDeclaredException",
    "ParameterDescriptor",
    "Publisher",
    "QoSDurabilityPolicy",
    "QoSHistoryPolicy",
    "QoSLivelinessPolicy",
    "QoSOverridingOptions",
    "QoSPolicyKind",
    "QoSProfile",
    "QoSProfileAttributes",
    "QoSReliabilityPolicy",
    "QosCallbackResult",
    "QosCallbackType",
    "SetParametersResult",
    "Subscription",
    "override",
]
