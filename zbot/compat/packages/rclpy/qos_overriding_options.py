"""Quality of service by parameters."""

from typing import Any

from zbot.compat.annotation import QosCallbackType as QosCallbackType
from zbot.compat.annotation import QoSProfileAttributes as QoSProfileAttributes
from zbot.node.node import Node
from zbot.node.publisher import Publisher as Publisher
from zbot.node.subscription import Subscription as Subscription
from zbot.parameters.errors import InvalidQosOverridesError as InvalidQosOverridesError
from zbot.parameters.errors import (
    ParameterAlreadyDeclaredException as ParameterAlreadyDeclaredException,
)
from zbot.parameters.parameter import Parameter as Parameter
from zbot.parameters.qos_overrides import QoSOverridingOptions as QoSOverridingOptions
from zbot.parameters.qos_overrides import override
from zbot.qos import QoSDurabilityPolicy as QoSDurabilityPolicy
from zbot.qos import QoSHistoryPolicy as QoSHistoryPolicy
from zbot.qos import QoSLivelinessPolicy as QoSLivelinessPolicy
from zbot.qos import QoSPolicyKind as QoSPolicyKind
from zbot.qos import QoSProfile as QoSProfile
from zbot.qos import QoSReliabilityPolicy as QoSReliabilityPolicy
from zbot.time import Duration as Duration

from rcl_interfaces.msg import ParameterDescriptor as ParameterDescriptor
from rcl_interfaces.msg import SetParametersResult as QosCallbackResult
from rcl_interfaces.msg import SetParametersResult as SetParametersResult


def _declare_qos_parameters(
    entity_type: type[Publisher[Any] | Subscription[Any]],
    node: Node,
    topic_name: str,
    qos: QoSProfile,
    options: QoSOverridingOptions,
) -> None:
    """Declare the policies of a publisher or subscription as parameters, and change `qos` by them.

    Raises:
        InvalidQosOverridesError: The options' callback refuses the result.
    """
    entity = "publisher" if issubclass(entity_type, Publisher) else "subscription"
    override(node.handle.parameters, entity, topic_name, qos, options)
