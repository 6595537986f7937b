# Written by python -m zbot.interfaces.stubs; do not edit.
from array import array
from collections.abc import Collection
from typing import Final, TypeAlias

import numpy
from numpy.typing import NDArray

import pcl_msgs.srv
import service_msgs.msg
from zbot.interfaces import Action, Message, Service

class UpdateFilename_Request(Message):
    """pcl_msgs/srv/UpdateFilename_Request

    string filename
    """
    def __init__(self, *, filename: str = ..., check_fields: bool = ...) -> None: ...
    filename: str

class UpdateFilename_Response(Message):
    """pcl_msgs/srv/UpdateFilename_Response

    bool success
    """
    def __init__(self, *, success: bool = ..., check_fields: bool = ...) -> None: ...
    success: bool

class UpdateFilename_Event(Message):
    """pcl_msgs/srv/UpdateFilename_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[pcl_msgs.srv.UpdateFilename_Request] = ..., response: Collection[pcl_msgs.srv.UpdateFilename_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[pcl_msgs.srv.UpdateFilename_Request]: ...
    @request.setter
    def request(self, value: Collection[pcl_msgs.srv.UpdateFilename_Request]) -> None: ...
    @property
    def response(self) -> list[pcl_msgs.srv.UpdateFilename_Response]: ...
    @response.setter
    def response(self, value: Collection[pcl_msgs.srv.UpdateFilename_Response]) -> None: ...

class UpdateFilename(Service):
    Request: TypeAlias = UpdateFilename_Request
    Response: TypeAlias = UpdateFilename_Response
    Event: TypeAlias = UpdateFilename_Event
