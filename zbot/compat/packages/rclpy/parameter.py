# Written by python -m zbot.compat.generator; do not edit.
"""Parameters."""

from zbot.compat.annotation import AllowableParameterValue, AllowableParameterValueT
from zbot.parameters.parameter import (
    Parameter,
    get_parameter_value,
    parameter_dict_from_yaml_file,
    parameter_value_to_python,
)
from rcl_interfaces.msg import Parameter as ParameterMsg, ParameterType, ParameterValue
from zbot.compat.constants import PARAMETER_SEPARATOR_STRING

__all__ = [
    "AllowableParameterValue",
    "AllowableParameterValueT",
    "PARAMETER_SEPARATOR_STRING",
    "Parameter",
    "ParameterMsg",
    "ParameterType",
    "ParameterValue",
    "get_parameter_value",
    "parameter_dict_from_yaml_file",
    "parameter_value_to_python",
]
