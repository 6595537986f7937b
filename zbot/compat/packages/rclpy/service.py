"""Services."""

from zbot.executor.callback_group import CallbackGroup as CallbackGroup
from zbot.executor.clock import Clock as Clock
from zbot.interfaces.message import Service as Srv
from zbot.interfaces.type_support import SrvRequestT as SrvRequestT
from zbot.interfaces.type_support import SrvRequestT as SrvTypeRequest
from zbot.interfaces.type_support import SrvResponseT as SrvResponseT
from zbot.interfaces.type_support import SrvResponseT as SrvTypeResponse
from zbot.interfaces.type_support import SrvT as SrvType
from zbot.node.service import Service as Service
from zbot.node.service_introspection import ServiceIntrospectionState as ServiceIntrospectionState
from zbot.qos import QoSProfile as QoSProfile
