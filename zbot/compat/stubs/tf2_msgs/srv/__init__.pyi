# Written by python -m zbot.interfaces.stubs; do not edit.
from array import array
from collections.abc import Collection
from typing import Final, TypeAlias

import numpy
from numpy.typing import NDArray

import service_msgs.msg
import tf2_msgs.srv
from zbot.interfaces import Action, Message, Service

class FrameGraph_Request(Message):
    """tf2_msgs/srv/FrameGraph_Request

    # Asks for the tree of all coordinate frames.
    """
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class FrameGraph_Response(Message):
    """tf2_msgs/srv/FrameGraph_Response

    string frame_yaml # frames with their parents, as YAML
    """
    def __init__(self, *, frame_yaml: str = ..., check_fields: bool = ...) -> None: ...
    frame_yaml: str

class FrameGraph_Event(Message):
    """tf2_msgs/srv/FrameGraph_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[tf2_msgs.srv.FrameGraph_Request] = ..., response: Collection[tf2_msgs.srv.FrameGraph_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[tf2_msgs.srv.FrameGraph_Request]: ...
    @request.setter
    def request(self, value: Collection[tf2_msgs.srv.FrameGraph_Request]) -> None: ...
    @property
    def response(self) -> list[tf2_msgs.srv.FrameGraph_Response]: ...
    @response.setter
    def response(self, value: Collection[tf2_msgs.srv.FrameGraph_Response]) -> None: ...

class FrameGraph(Service):
    Request: TypeAlias = FrameGraph_Request
    Response: TypeAlias = FrameGraph_Response
    Event: TypeAlias = FrameGraph_Event
