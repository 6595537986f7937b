"""Nodes."""

from zbot.compat.annotation import AllowableParameterValue as AllowableParameterValue
from zbot.compat.annotation import AllowableParameterValueT as AllowableParameterValueT
from zbot.context import Context as Context
from zbot.context import get_default_context as get_default_context
from zbot.errors import InvalidHandleError as InvalidHandle
from zbot.errors import InvalidTopicNameError as InvalidTopicNameException
from zbot.errors import NotInitializedError as NotInitializedException
from zbot.executor.callback_group import CallbackGroup as CallbackGroup
from zbot.executor.callback_group import (
    MutuallyExclusiveCallbackGroup as MutuallyExclusiveCallbackGroup,
)
from zbot.executor.callback_group import ReentrantCallbackGroup as ReentrantCallbackGroup
from zbot.executor.clock import Clock as Clock
from zbot.executor.clock import ROSClock as ROSClock
from zbot.executor.executor import Executor as Executor
from zbot.executor.guard_condition import GuardCondition as GuardCondition
from zbot.executor.timer import Rate as Rate
from zbot.executor.timer import Timer as Timer
from zbot.executor.timer import TimerInfo as TimerInfo
from zbot.executor.waitable import Waitable as Waitable
from zbot.graph.endpoint_info import TopicEndpointInfo as TopicEndpointInfo
from zbot.interfaces.message import Service as Srv
from zbot.interfaces.type_support import MsgT as MsgT
from zbot.interfaces.type_support import MsgT as MsgType
from zbot.interfaces.type_support import SrvRequestT as SrvRequestT
from zbot.interfaces.type_support import SrvRequestT as SrvTypeRequest
from zbot.interfaces.type_support import SrvResponseT as SrvResponseT
from zbot.interfaces.type_support import SrvResponseT as SrvTypeResponse
from zbot.interfaces.type_support import SrvT as SrvType
from zbot.interfaces.type_support import check_for_type_support as check_for_type_support
from zbot.interfaces.type_support import check_is_valid_msg_type as check_is_valid_msg_type
from zbot.interfaces.type_support import check_is_valid_srv_type as check_is_valid_srv_type
from zbot.log import Logger as RcutilsLogger
from zbot.log import get_logger as get_logger
from zbot.names import expand_topic_name as expand_topic_name
from zbot.names import validate_full_topic_name as validate_full_topic_name
from zbot.names import validate_namespace as validate_namespace
from zbot.names import validate_node_name as validate_node_name
from zbot.names import validate_parameter_name as validate_parameter_name
from zbot.names import validate_topic_name as validate_topic_name
from zbot.node.client import Client as Client
from zbot.node.content_filter_options import ContentFilterOptions as ContentFilterOptions
from zbot.node.errors import UnknownNodeError as NodeNameNonExistentError
from zbot.node.event_callbacks import PublisherEventCallbacks as PublisherEventCallbacks
from zbot.node.event_callbacks import SubscriptionEventCallbacks as SubscriptionEventCallbacks
from zbot.node.logger_services import LoggingService as LoggingService
from zbot.node.message_info import MessageInfo as MessageInfo
from zbot.node.node import Node as Node
from zbot.node.parameter_services import ParameterServices as ParameterService
from zbot.node.publisher import Publisher as Publisher
from zbot.node.service import Service as Service
from zbot.node.subscription import Subscription as Subscription
from zbot.node.time_source import TimeSource as TimeSource
from zbot.node.type_description import TypeDescriptionService as TypeDescriptionService
from zbot.parameters.errors import InvalidParameterTypeException as InvalidParameterTypeException
from zbot.parameters.errors import InvalidParameterValueException as InvalidParameterValueException
from zbot.parameters.errors import (
    ParameterAlreadyDeclaredException as ParameterAlreadyDeclaredException,
)
from zbot.parameters.errors import ParameterImmutableException as ParameterImmutableException
from zbot.parameters.errors import ParameterNotDeclaredException as ParameterNotDeclaredException
from zbot.parameters.errors import (
    ParameterUninitializedException as ParameterUninitializedException,
)
from zbot.parameters.parameter import Parameter as Parameter
from zbot.parameters.qos_overrides import QoSOverridingOptions as QoSOverridingOptions
from zbot.qos import QoSProfile as QoSProfile
from zbot.qos import qos_profile_parameter_events as qos_profile_parameter_events
from zbot.qos import qos_profile_rosout_default as qos_profile_rosout_default
from zbot.qos import qos_profile_services_default as qos_profile_services_default
from zbot.time import S_TO_NS as S_TO_NS

from rcl_interfaces.msg import FloatingPointRange as FloatingPointRange
from rcl_interfaces.msg import IntegerRange as IntegerRange
from rcl_interfaces.msg import ListParametersResult as ListParametersResult
from rcl_interfaces.msg import Parameter as ParameterMsg
from rcl_interfaces.msg import ParameterDescriptor as ParameterDescriptor
from rcl_interfaces.msg import ParameterEvent as ParameterEvent
from rcl_interfaces.msg import ParameterType as ParameterType
from rcl_interfaces.msg import ParameterValue as ParameterValue
from rcl_interfaces.msg import SetParametersResult as SetParametersResult
from rcl_interfaces.srv import ListParameters as ListParameters

HIDDEN_NODE_PREFIX = "_"
PARAMETER_SEPARATOR_STRING = "."
