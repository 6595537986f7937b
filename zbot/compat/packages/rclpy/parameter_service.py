"""A node's parameter services."""

from zbot.node.parameter_services import ParameterServices as ParameterService
from zbot.parameters.errors import (
    ParameterNotDeclaredException,
    ParameterUninitializedException,
)
from zbot.parameters.parameter import Parameter
from zbot.qos import qos_profile_parameters

from rcl_interfaces.msg import ListParametersResult, SetParametersResult
from rcl_interfaces.srv import (
    DescribeParameters,
    GetParameters,
    GetParameterTypes,
    ListParameters,
    SetParameters,
    SetParametersAtomically,
)

TOPIC_SEPARATOR_STRING = "/"
