# Written by python -m zbot.compat.generator; do not edit.
"""Nodes."""

from zbot.compat.annotation import AllowableParameterValue, AllowableParameterValueT
from zbot.context import Context, get_default_context
from zbot.errors import (
    InvalidHandleError as InvalidHandle,
    InvalidTopicNameError as InvalidTopicNameException,
    NotInitializedError as NotInitializedException,
)
from zbot.executor.callback_group import (
    CallbackGroup,
    MutuallyExclusiveCallbackGroup,
    ReentrantCallbackGroup,
)
from zbot.executor.clock import Clock, ROSClock
from zbot.executor.executor import Executor
from zbot.executor.guard_condition import GuardCondition
from zbot.executor.timer import Rate, Timer, TimerInfo
from zbot.executor.waitable import Waitable
from zbot.graph.endpoint_info import TopicEndpointInfo
from zbot.interfaces.message import Service as Srv
from zbot.interfaces.python_class import (
    MsgT,
    MsgT as MsgType,
    SrvRequestT,
    SrvRequestT as SrvTypeRequest,
    SrvResponseT,
    SrvResponseT as SrvTypeResponse,
    SrvT as SrvType,
    check_for_type_support,
    check_is_valid_msg_type,
    check_is_valid_srv_type,
)
from zbot.log import Logger as RcutilsLogger, get_logger
from zbot.names import (
    expand_topic_name,
    validate_full_topic_name,
    validate_namespace,
    validate_node_name,
    validate_parameter_name,
    validate_topic_name,
)
from zbot.node.client import Client
from zbot.node.message_decoder import ContentFilterOptions
from zbot.node.errors import UnknownNodeError as NodeNameNonExistentError
from zbot.node.event_callbacks import PublisherEventCallbacks, SubscriptionEventCallbacks
from zbot.node.logger_services import LoggingService
from zbot.node.message_info import MessageInfo
from zbot.node.node import Node
from zbot.node.parameter_services import ParameterServices as ParameterService
from zbot.node.publisher import Publisher
from zbot.node.service import Service
from zbot.node.subscription import Subscription
from zbot.node.time_source import TimeSource
from zbot.node.type_description import TypeDescriptionService
from zbot.parameters.errors import (
    InvalidParameterValueException,
    ParameterAlreadyDeclaredException,
    ParameterImmutableException,
    ParameterNotDeclaredException,
    ParameterUninitializedException,
)
from zbot.parameters.parameter import InvalidParameterTypeException, Parameter
from zbot.parameters.qos_overrides import QoSOverridingOptions
from zbot.qos import (
    QoSProfile,
    qos_profile_parameter_events,
    qos_profile_rosout_default,
    qos_profile_services_default,
)
from zbot.time import S_TO_NS
from rcl_interfaces.msg import (
    FloatingPointRange,
    IntegerRange,
    ListParametersResult,
    Parameter as ParameterMsg,
    ParameterDescriptor,
    ParameterEvent,
    ParameterType,
    ParameterValue,
    SetParametersResult,
)
from rcl_interfaces.srv import ListParameters
from zbot.compat.constants import HIDDEN_NODE_PREFIX, PARAMETER_SEPARATOR_STRING

__all__ = [
    "AllowableParameterValue",
    "AllowableParameterValueT",
    "CallbackGroup",
    "Client",
    "Clock",
    "ContentFilterOptions",
    "Context",
    "Executor",
    "FloatingPointRange",
    "GuardCondition",
    "HIDDEN_NODE_PREFIX",
    "IntegerRange",
    "InvalidHandle",
    "InvalidParameterTypeException",
    "InvalidParameterValueException",
    "InvalidTopicNameException",
    "ListParameters",
    "ListParametersResult",
    "LoggingService",
    "MessageInfo",
    "MsgT",
    "MsgType",
    "MutuallyExclusiveCallbackGroup",
    "Node",
    "NodeNameNonExistentError",
    "NotInitializedException",
    "PARAMETER_SEPARATOR_STRING",
    "Parameter",
    "ParameterAlreadyDeclaredException",
    "ParameterDescriptor",
    "ParameterEvent",
    "ParameterImmutableException",
    "ParameterMsg",
    "ParameterNotDeclaredException",
    "ParameterService",
    "ParameterType",
    "ParameterUninitializedException",
    "ParameterValue",
    "Publisher",
    "PublisherEventCallbacks",
    "QoSOverridingOptions",
    "QoSProfile",
    "ROSClock",
    "Rate",
    "RcutilsLogger",
    "ReentrantCallbackGroup",
    "S_TO_NS",
    "Service",
    "SetParametersResult",
    "Srv",
    "SrvRequestT",
    "SrvResponseT",
    "SrvType",
    "SrvTypeRequest",
    "SrvTypeResponse",
    "Subscription",
    "SubscriptionEventCallbacks",
    "TimeSource",
    "Timer",
    "TimerInfo",
    "TopicEndpointInfo",
    "TypeDescriptionService",
    "Waitable",
    "check_for_type_support",
    "check_is_valid_msg_type",
    "check_is_valid_srv_type",
    "expand_topic_name",
    "get_default_context",
    "get_logger",
    "qos_profile_parameter_events",
    "qos_profile_rosout_default",
    "qos_profile_services_default",
    "validate_full_topic_name",
    "validate_namespace",
    "validate_node_name",
    "validate_parameter_name",
    "validate_topic_name",
]
