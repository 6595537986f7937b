"""Other nodes' parameters."""

from zbot.executor.callback_group import CallbackGroup as CallbackGroup
from zbot.executor.task import Future as Future
from zbot.node.client import Client as Client
from zbot.node.event_callbacks import SubscriptionEventCallbacks as SubscriptionEventCallbacks
from zbot.node.message_info import MessageInfo as MessageInfo
from zbot.node.node import Node as Node
from zbot.node.parameter_client import AsyncParameterClient as AsyncParameterClient
from zbot.node.subscription import Subscription as Subscription
from zbot.parameters.parameter import Parameter as Parameter
from zbot.parameters.parameter import parameter_dict_from_yaml_file as parameter_dict_from_yaml_file
from zbot.parameters.qos_overrides import QoSOverridingOptions as QoSOverridingOptions
from zbot.qos import QoSProfile as QoSProfile
from zbot.qos import qos_profile_parameter_events as qos_profile_parameter_events
from zbot.qos import qos_profile_services_default as qos_profile_services_default

from rcl_interfaces.msg import Parameter as ParameterMsg
from rcl_interfaces.msg import ParameterEvent as ParameterEvent
from rcl_interfaces.srv import DescribeParameters as DescribeParameters
from rcl_interfaces.srv import GetParameters as GetParameters
from rcl_interfaces.srv import GetParameterTypes as GetParameterTypes
from rcl_interfaces.srv import ListParameters as ListParameters
from rcl_interfaces.srv import SetParameters as SetParameters
from rcl_interfaces.srv import SetParametersAtomically as SetParametersAtomically
