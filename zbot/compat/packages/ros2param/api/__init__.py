"""Parameters of other nodes."""

from zbot.compat.parameter_calls import call_describe_parameters as call_describe_parameters
from zbot.compat.parameter_calls import call_get_parameters as call_get_parameters
from zbot.compat.parameter_calls import call_list_parameters as call_list_parameters
from zbot.compat.parameter_calls import call_set_parameters as call_set_parameters
from zbot.compat.parameter_calls import get_parameter_type_string as get_parameter_type_string
from zbot.compat.parameter_calls import get_parameter_value as get_parameter_value
from zbot.compat.parameter_calls import get_value as get_value
