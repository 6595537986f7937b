"""What a node tells of its types."""

from zbot.interfaces.type_support import check_is_valid_srv_type as check_is_valid_srv_type
from zbot.node.service import Service as Service
from zbot.node.type_description import TypeDescriptionService as TypeDescriptionService
from zbot.parameters.parameter import Parameter as Parameter
from zbot.qos import qos_profile_services_default as qos_profile_services_default

from rcl_interfaces.msg import ParameterDescriptor as ParameterDescriptor
from rcl_interfaces.msg import ParameterType as ParameterType
from type_description_interfaces.srv import GetTypeDescription as GetTypeDescription

START_TYPE_DESCRIPTION_SERVICE_PARAM = "start_type_description_service"
TOPIC_SEPARATOR_STRING = "/"
