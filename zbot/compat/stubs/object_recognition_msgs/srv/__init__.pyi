# Written by python -m zbot.interfaces.stubs; do not edit.
from array import array
from collections.abc import Collection
from typing import Final, TypeAlias

import numpy
from numpy.typing import NDArray

import object_recognition_msgs.msg
import object_recognition_msgs.srv
import service_msgs.msg
from zbot.interfaces import Action, Message, Service

class GetObjectInformation_Request(Message):
    """object_recognition_msgs/srv/GetObjectInformation_Request

    # Returns what is known about a type of object.

    object_recognition_msgs/ObjectType type
    """
    def __init__(self, *, type: object_recognition_msgs.msg.ObjectType = ..., check_fields: bool = ...) -> None: ...
    type: object_recognition_msgs.msg.ObjectType

class GetObjectInformation_Response(Message):
    """object_recognition_msgs/srv/GetObjectInformation_Response

    object_recognition_msgs/ObjectInformation information
    """
    def __init__(self, *, information: object_recognition_msgs.msg.ObjectInformation = ..., check_fields: bool = ...) -> None: ...
    information: object_recognition_msgs.msg.ObjectInformation

class GetObjectInformation_Event(Message):
    """object_recognition_msgs/srv/GetObjectInformation_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[object_recognition_msgs.srv.GetObjectInformation_Request] = ..., response: Collection[object_recognition_msgs.srv.GetObjectInformation_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[object_recognition_msgs.srv.GetObjectInformation_Request]: ...
    @request.setter
    def request(self, value: Collection[object_recognition_msgs.srv.GetObjectInformation_Request]) -> None: ...
    @property
    def response(self) -> list[object_recognition_msgs.srv.GetObjectInformation_Response]: ...
    @response.setter
    def response(self, value: Collection[object_recognition_msgs.srv.GetObjectInformation_Response]) -> None: ...

class GetObjectInformation(Service):
    Request: TypeAlias = GetObjectInformation_Request
    Response: TypeAlias = GetObjectInformation_Response
    Event: TypeAlias = GetObjectInformation_Event
