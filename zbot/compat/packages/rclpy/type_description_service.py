"""Service that returns the definitions of a node's types."""

from zbot.interfaces.type_support import check_is_valid_srv_type
from zbot.node.service import Service
from zbot.node.type_description import TypeDescriptionService
from zbot.parameters.parameter import Parameter
from zbot.qos import qos_profile_services_default

from rcl_interfaces.msg import ParameterDescriptor, ParameterType
from type_description_interfaces.srv import GetTypeDescription

START_TYPE_DESCRIPTION_SERVICE_PARAM = "start_type_description_service"
TOPIC_SEPARATOR_STRING = "/"
