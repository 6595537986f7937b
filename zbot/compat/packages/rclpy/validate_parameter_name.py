"""Checks of parameters' names."""

from zbot.names import validate_parameter_name as validate_parameter_name
from zbot.parameter_errors import InvalidParameterException as InvalidParameterException
