"""Quality of service by parameters."""

from zbot.compat.annotation import QosCallbackType as QosCallbackType
from zbot.compat.annotation import QoSProfileAttributes as QoSProfileAttributes
from zbot.parameter import Parameter as Parameter
from zbot.parameter_errors import InvalidQosOverridesError as InvalidQosOverridesError
from zbot.parameter_errors import (
    ParameterAlreadyDeclaredException as ParameterAlreadyDeclaredException,
)
from zbot.publisher import Publisher as Publisher
from zbot.qos import QoSDurabilityPolicy as QoSDurabilityPolicy
from zbot.qos import QoSHistoryPolicy as QoSHistoryPolicy
from zbot.qos import QoSLivelinessPolicy as QoSLivelinessPolicy
from zbot.qos import QoSPolicyKind as QoSPolicyKind
from zbot.qos import QoSProfile as QoSProfile
from zbot.qos import QoSReliabilityPolicy as QoSReliabilityPolicy
from zbot.qos_overriding_options import QoSOverridingOptions as QoSOverridingOptions
from zbot.subscription import Subscription as Subscription
from zbot.time import Duration as Duration

from rcl_interfaces.msg import ParameterDescriptor as ParameterDescriptor
from rcl_interfaces.msg import SetParametersResult as QosCallbackResult
from rcl_interfaces.msg import SetParametersResult as SetParametersResult
