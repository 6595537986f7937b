"""Clients of services."""

from zbot.context import Context as Context
from zbot.executor.callback_group import CallbackGroup as CallbackGroup
from zbot.executor.clock import Clock as Clock
from zbot.executor.task import Future as Future
from zbot.interfaces.message import Service as Srv
from zbot.interfaces.type_support import SrvRequestT as SrvRequestT
from zbot.interfaces.type_support import SrvRequestT as SrvTypeRequest
from zbot.interfaces.type_support import SrvResponseT as SrvResponseT
from zbot.interfaces.type_support import SrvResponseT as SrvTypeResponse
from zbot.interfaces.type_support import SrvT as SrvType
from zbot.node.client import Client as Client
from zbot.node.service_introspection import ServiceIntrospectionState as ServiceIntrospectionState
from zbot.qos import QoSProfile as QoSProfile
