"""What a node tells of its types."""

from zbot.parameter import Parameter as Parameter
from zbot.qos import qos_profile_services_default as qos_profile_services_default
from zbot.service import Service as Service

from rcl_interfaces.msg import ParameterDescriptor as ParameterDescriptor
from rcl_interfaces.msg import ParameterType as ParameterType

START_TYPE_DESCRIPTION_SERVICE_PARAM = "start_type_description_service"
TOPIC_SEPARATOR_STRING = "/"
