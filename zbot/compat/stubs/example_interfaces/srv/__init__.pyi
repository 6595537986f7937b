# Written by python -m zbot.interfaces.stubs; do not edit.
from array import array
from collections.abc import Collection
from typing import Final, TypeAlias

import numpy
from numpy.typing import NDArray

import example_interfaces.srv
import service_msgs.msg
from zbot.interfaces import Action, Message, Service

class AddTwoInts_Request(Message):
    """example_interfaces/srv/AddTwoInts_Request

    # Adds two whole numbers: the service of the first lesson.

    int64 a
    int64 b
    """
    def __init__(self, *, a: int = ..., b: int = ..., check_fields: bool = ...) -> None: ...
    a: int
    b: int

class AddTwoInts_Response(Message):
    """example_interfaces/srv/AddTwoInts_Response

    int64 sum
    """
    def __init__(self, *, sum: int = ..., check_fields: bool = ...) -> None: ...
    sum: int

class AddTwoInts_Event(Message):
    """example_interfaces/srv/AddTwoInts_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[example_interfaces.srv.AddTwoInts_Request] = ..., response: Collection[example_interfaces.srv.AddTwoInts_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[example_interfaces.srv.AddTwoInts_Request]: ...
    @request.setter
    def request(self, value: Collection[example_interfaces.srv.AddTwoInts_Request]) -> None: ...
    @property
    def response(self) -> list[example_interfaces.srv.AddTwoInts_Response]: ...
    @response.setter
    def response(self, value: Collection[example_interfaces.srv.AddTwoInts_Response]) -> None: ...

class AddTwoInts(Service):
    Request: TypeAlias = AddTwoInts_Request
    Response: TypeAlias = AddTwoInts_Response
    Event: TypeAlias = AddTwoInts_Event

class SetBool_Request(Message):
    """example_interfaces/srv/SetBool_Request

    # Switches something on or off; an example to copy into a package of your own.

    bool data # the wanted state
    """
    def __init__(self, *, data: bool = ..., check_fields: bool = ...) -> None: ...
    data: bool

class SetBool_Response(Message):
    """example_interfaces/srv/SetBool_Response

    bool success # did it work?
    string message # details for people, such as the reason of a failure
    """
    def __init__(self, *, success: bool = ..., message: str = ..., check_fields: bool = ...) -> None: ...
    success: bool
    message: str

class SetBool_Event(Message):
    """example_interfaces/srv/SetBool_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[example_interfaces.srv.SetBool_Request] = ..., response: Collection[example_interfaces.srv.SetBool_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[example_interfaces.srv.SetBool_Request]: ...
    @request.setter
    def request(self, value: Collection[example_interfaces.srv.SetBool_Request]) -> None: ...
    @property
    def response(self) -> list[example_interfaces.srv.SetBool_Response]: ...
    @response.setter
    def response(self, value: Collection[example_interfaces.srv.SetBool_Response]) -> None: ...

class SetBool(Service):
    Request: TypeAlias = SetBool_Request
    Response: TypeAlias = SetBool_Response
    Event: TypeAlias = SetBool_Event

class Trigger_Request(Message):
    """example_interfaces/srv/Trigger_Request

    # Asks for an action and hears how it went; an example to copy into a package of your own.
    """
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class Trigger_Response(Message):
    """example_interfaces/srv/Trigger_Response

    bool success # did it work?
    string message # details for people, such as the reason of a failure
    """
    def __init__(self, *, success: bool = ..., message: str = ..., check_fields: bool = ...) -> None: ...
    success: bool
    message: str

class Trigger_Event(Message):
    """example_interfaces/srv/Trigger_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[example_interfaces.srv.Trigger_Request] = ..., response: Collection[example_interfaces.srv.Trigger_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[example_interfaces.srv.Trigger_Request]: ...
    @request.setter
    def request(self, value: Collection[example_interfaces.srv.Trigger_Request]) -> None: ...
    @property
    def response(self) -> list[example_interfaces.srv.Trigger_Response]: ...
    @response.setter
    def response(self, value: Collection[example_interfaces.srv.Trigger_Response]) -> None: ...

class Trigger(Service):
    Request: TypeAlias = Trigger_Request
    Response: TypeAlias = Trigger_Response
    Event: TypeAlias = Trigger_Event
