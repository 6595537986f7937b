"""Parameters."""

from zbot.compat.annotation import AllowableParameterValue as AllowableParameterValue
from zbot.compat.annotation import AllowableParameterValueT as AllowableParameterValueT
from zbot.parameters.parameter import Parameter as Parameter
from zbot.parameters.parameter import get_parameter_value as get_parameter_value
from zbot.parameters.parameter import parameter_dict_from_yaml_file as parameter_dict_from_yaml_file
from zbot.parameters.parameter import parameter_value_to_python as parameter_value_to_python

from rcl_interfaces.msg import Parameter as ParameterMsg
from rcl_interfaces.msg import ParameterType as ParameterType
from rcl_interfaces.msg import ParameterValue as ParameterValue

PARAMETER_SEPARATOR_STRING = "."
