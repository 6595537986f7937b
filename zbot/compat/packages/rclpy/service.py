# Written by python -m zbot.compat.generator; do not edit.
"""Services."""

from zbot.executor.callback_group import CallbackGroup
from zbot.executor.clock import Clock
from zbot.interfaces.message import Service as Srv
from zbot.interfaces.python_class import (
    SrvRequestT,
    SrvRequestT as SrvTypeRequest,
    SrvResponseT,
    SrvResponseT as SrvTypeResponse,
    SrvT as SrvType,
)
from zbot.node.service import Service
from zbot.node.service_introspection import ServiceIntrospectionState
from zbot.qos import QoSProfile

__all__ = [
    "CallbackGroup",
    "Clock",
    "QoSProfile",
    "Service",
    "ServiceIntrospectionState",
    "Srv",
    "SrvRequestT",
    "SrvResponseT",
    "SrvType",
    "SrvTypeRequest",
    "SrvTypeResponse",
]
