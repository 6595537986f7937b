"""Checks of parameters' names."""

from zbot.names import validate_parameter_name
from zbot.parameters.errors import InvalidParameterException
