# Written by python -m zbot.interfaces.stubs; do not edit.
from array import array
from collections.abc import Collection
from typing import Final, TypeAlias

import numpy
from numpy.typing import NDArray

import service_msgs.msg
import std_srvs.srv
from zbot.interfaces import Action, Message, Service

class Empty_Request(Message):
    """std_srvs/srv/Empty_Request

    # Asks for something to happen; neither the request nor the answer carries data.
    """
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class Empty_Response(Message):
    """std_srvs/srv/Empty_Response"""
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class Empty_Event(Message):
    """std_srvs/srv/Empty_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[std_srvs.srv.Empty_Request] = ..., response: Collection[std_srvs.srv.Empty_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[std_srvs.srv.Empty_Request]: ...
    @request.setter
    def request(self, value: Collection[std_srvs.srv.Empty_Request]) -> None: ...
    @property
    def response(self) -> list[std_srvs.srv.Empty_Response]: ...
    @response.setter
    def response(self, value: Collection[std_srvs.srv.Empty_Response]) -> None: ...

class Empty(Service):
    Request: TypeAlias = Empty_Request
    Response: TypeAlias = Empty_Response
    Event: TypeAlias = Empty_Event

class SetBool_Request(Message):
    """std_srvs/srv/SetBool_Request

    bool data # the wanted state, such as motor on or off
    """
    def __init__(self, *, data: bool = ..., check_fields: bool = ...) -> None: ...
    data: bool

class SetBool_Response(Message):
    """std_srvs/srv/SetBool_Response

    bool success   # did it work?
    string message # details for people, such as the reason of a failure
    """
    def __init__(self, *, success: bool = ..., message: str = ..., check_fields: bool = ...) -> None: ...
    success: bool
    message: str

class SetBool_Event(Message):
    """std_srvs/srv/SetBool_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[std_srvs.srv.SetBool_Request] = ..., response: Collection[std_srvs.srv.SetBool_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[std_srvs.srv.SetBool_Request]: ...
    @request.setter
    def request(self, value: Collection[std_srvs.srv.SetBool_Request]) -> None: ...
    @property
    def response(self) -> list[std_srvs.srv.SetBool_Response]: ...
    @response.setter
    def response(self, value: Collection[std_srvs.srv.SetBool_Response]) -> None: ...

class SetBool(Service):
    Request: TypeAlias = SetBool_Request
    Response: TypeAlias = SetBool_Response
    Event: TypeAlias = SetBool_Event

class Trigger_Request(Message):
    """std_srvs/srv/Trigger_Request

    # Asks for an action and hears how it went.
    """
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class Trigger_Response(Message):
    """std_srvs/srv/Trigger_Response

    bool success   # did it work?
    string message # details for people, such as the reason of a failure
    """
    def __init__(self, *, success: bool = ..., message: str = ..., check_fields: bool = ...) -> None: ...
    success: bool
    message: str

class Trigger_Event(Message):
    """std_srvs/srv/Trigger_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[std_srvs.srv.Trigger_Request] = ..., response: Collection[std_srvs.srv.Trigger_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[std_srvs.srv.Trigger_Request]: ...
    @request.setter
    def request(self, value: Collection[std_srvs.srv.Trigger_Request]) -> None: ...
    @property
    def response(self) -> list[std_srvs.srv.Trigger_Response]: ...
    @response.setter
    def response(self, value: Collection[std_srvs.srv.Trigger_Response]) -> None: ...

class Trigger(Service):
    Request: TypeAlias = Trigger_Request
    Response: TypeAlias = Trigger_Response
    Event: TypeAlias = Trigger_Event
