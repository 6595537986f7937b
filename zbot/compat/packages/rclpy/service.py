"""Services."""

from zbot.executor.callback_group import CallbackGroup
from zbot.executor.clock import Clock
from zbot.interfaces.message import Service as Srv
from zbot.interfaces.type_support import SrvRequestT, SrvResponseT
from zbot.interfaces.type_support import SrvRequestT as SrvTypeRequest
from zbot.interfaces.type_support import SrvResponseT as SrvTypeResponse
from zbot.interfaces.type_support import SrvT as SrvType
from zbot.node.service import Service
from zbot.node.service_introspection import ServiceIntrospectionState
from zbot.qos import QoSProfile
