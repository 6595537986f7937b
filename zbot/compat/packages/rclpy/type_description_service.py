# Written by python -m zbot.compat.generator; do not edit.
"""Service that returns the definitions of a node's types."""

from zbot.interfaces.python_class import check_is_valid_srv_type
from zbot.node.service import Service
from zbot.node.type_description import TypeDescriptionService
from zbot.parameters.parameter import Parameter
from zbot.qos import qos_profile_services_default
from rcl_interfaces.msg import ParameterDescriptor, ParameterType
from type_description_interfaces.srv import GetTypeDescription
from zbot.compat.constants import START_TYPE_DESCRIPTION_SERVICE_PARAM, TOPIC_SEPARATOR_STRING

__all__ = [
    "GetTypeDescription",
    "Parameter",
    "ParameterDescriptor",
    "ParameterType",
    "START_TYPE_DESCRIPTION_SERVICE_PARAM",
    "Service",
    "TOPIC_SEPARATOR_STRING",
    "TypeDescriptionService",
    "check_is_valid_srv_type",
    "qos_profile_services_default",
]
