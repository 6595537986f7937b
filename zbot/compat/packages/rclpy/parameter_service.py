"""A node's parameter services."""

from zbot.node.parameter_services import ParameterServices as ParameterService
from zbot.parameters.errors import ParameterNotDeclaredException as ParameterNotDeclaredException
from zbot.parameters.errors import (
    ParameterUninitializedException as ParameterUninitializedException,
)
from zbot.parameters.parameter import Parameter as Parameter
from zbot.qos import qos_profile_parameters as qos_profile_parameters

from rcl_interfaces.msg import ListParametersResult as ListParametersResult
from rcl_interfaces.msg import SetParametersResult as SetParametersResult
from rcl_interfaces.srv import DescribeParameters as DescribeParameters
from rcl_interfaces.srv import GetParameters as GetParameters
from rcl_interfaces.srv import GetParameterTypes as GetParameterTypes
from rcl_interfaces.srv import ListParameters as ListParameters
from rcl_interfaces.srv import SetParameters as SetParameters
from rcl_interfaces.srv import SetParametersAtomically as SetParametersAtomically

TOPIC_SEPARATOR_STRING = "/"
