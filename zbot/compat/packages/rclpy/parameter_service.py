# Written by python -m zbot.compat.generator; do not edit.
"""A node's parameter services."""

from zbot.node.parameter_services import ParameterServices as ParameterService
from zbot.parameters.errors import ParameterNotDeclaredException, ParameterUninitializedException
from zbot.parameters.parameter import Parameter
from zbot.qos import qos_profile_parameters
from rcl_interfaces.msg import ListParametersResult, SetParametersResult
from rcl_interfaces.srv import (
    DescribeParameters,
    GetParameterTypes,
    GetParameters,
    ListParameters,
    SetParameters,
    SetParametersAtomically,
)
from zbot.compat.constants import TOPIC_SEPARATOR_STRING

__all__ = [
    "DescribeParameters",
    "GetParameterTypes",
    "GetParameters",
    "ListParameters",
    "ListParametersResult",
    "Parameter",
    "ParameterNotDeclaredException",
    "ParameterService",
    "ParameterUninitializedException",
    "SetParameters",
    "SetParametersAtomically",
    "SetParametersResult",
    "TOPIC_SEPARATOR_STRING",
    "qos_profile_parameters",
]
