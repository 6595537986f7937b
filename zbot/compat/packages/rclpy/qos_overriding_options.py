"""Parameters that override the quality of service."""

from typing import Any

from zbot.compat.annotation import QosCallbackType, QoSProfileAttributes
from zbot.node.node import Node
from zbot.node.publisher import Publisher
from zbot.node.subscription import Subscription
from zbot.parameters.errors import (
    InvalidQosOverridesError,
    ParameterAlreadyDeclaredException,
)
from zbot.parameters.parameter import Parameter
from zbot.parameters.qos_overrides import QoSOverridingOptions, override
from zbot.parameters.qos_overrides import policy_parameter as _get_qos_policy_parameter
from zbot.qos import (
    QoSDurabilityPolicy,
    QoSHistoryPolicy,
    QoSLivelinessPolicy,
    QoSPolicyKind,
    QoSProfile,
    QoSReliabilityPolicy,
)
from zbot.time import Duration

from rcl_interfaces.msg import ParameterDescriptor, SetParametersResult
from rcl_interfaces.msg import SetParametersResult as QosCallbackResult


def _declare_qos_parameters(
    entity_type: type[Publisher[Any] | Subscription[Any]],
    node: Node,
    topic_name: str,
    qos: QoSProfile,
    options: QoSOverridingOptions,
) -> None:
    """Declare the policies of a publisher or subscription as parameters.

    Write the values of the parameters into `qos`.

    Raises:
        InvalidQosOverridesError: The options' callback refuses the result.
    """
    entity = "publisher" if issubclass(entity_type, Publisher) else "subscription"
    override(node.handle.parameters, entity, topic_name, qos, options)
