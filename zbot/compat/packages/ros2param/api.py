# Written by python -m zbot.compat.generator; do not edit.
"""Parameters of other nodes."""

from zbot.compat.parameter_calls import (
    call_describe_parameters,
    call_get_parameters,
    call_list_parameters,
    call_set_parameters,
    get_parameter_type_string,
    get_parameter_value,
    get_value,
)

__all__ = [
    "call_describe_parameters",
    "call_get_parameters",
    "call_list_parameters",
    "call_set_parameters",
    "get_parameter_type_string",
    "get_parameter_value",
    "get_value",
]
