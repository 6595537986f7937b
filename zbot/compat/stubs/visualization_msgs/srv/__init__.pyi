# Written by python -m zbot.interfaces.stubs; do not edit.
from array import array
from collections.abc import Collection
from typing import Final, TypeAlias

import numpy
from numpy.typing import NDArray

import service_msgs.msg
import visualization_msgs.msg
import visualization_msgs.srv
from zbot.interfaces import Action, Message, Service

class GetInteractiveMarkers_Request(Message):
    """visualization_msgs/srv/GetInteractiveMarkers_Request

    # Asks a server for all its interactive markers.
    """
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class GetInteractiveMarkers_Response(Message):
    """visualization_msgs/srv/GetInteractiveMarkers_Response

    # Number of the last update contained in here, so that a viewer notices what it missed.
    uint64 sequence_number

    # The markers.
    InteractiveMarker[] markers
    """
    def __init__(self, *, sequence_number: int = ..., markers: Collection[visualization_msgs.msg.InteractiveMarker] = ..., check_fields: bool = ...) -> None: ...
    sequence_number: int
    @property
    def markers(self) -> list[visualization_msgs.msg.InteractiveMarker]: ...
    @markers.setter
    def markers(self, value: Collection[visualization_msgs.msg.InteractiveMarker]) -> None: ...

class GetInteractiveMarkers_Event(Message):
    """visualization_msgs/srv/GetInteractiveMarkers_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[visualization_msgs.srv.GetInteractiveMarkers_Request] = ..., response: Collection[visualization_msgs.srv.GetInteractiveMarkers_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[visualization_msgs.srv.GetInteractiveMarkers_Request]: ...
    @request.setter
    def request(self, value: Collection[visualization_msgs.srv.GetInteractiveMarkers_Request]) -> None: ...
    @property
    def response(self) -> list[visualization_msgs.srv.GetInteractiveMarkers_Response]: ...
    @response.setter
    def response(self, value: Collection[visualization_msgs.srv.GetInteractiveMarkers_Response]) -> None: ...

class GetInteractiveMarkers(Service):
    Request: TypeAlias = GetInteractiveMarkers_Request
    Response: TypeAlias = GetInteractiveMarkers_Response
    Event: TypeAlias = GetInteractiveMarkers_Event
