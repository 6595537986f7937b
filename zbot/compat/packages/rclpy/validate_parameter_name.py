# Written by python -m zbot.compat.generator; do not edit.
"""Checks of parameters' names."""

from zbot.names import validate_parameter_name
from zbot.parameters.errors import InvalidParameterException

__all__ = [
    "InvalidParameterException",
    "validate_parameter_name",
]
