# Written by python -m zbot.interfaces.stubs; do not edit.
from array import array
from collections.abc import Collection
from typing import Final, TypeAlias

import numpy
from numpy.typing import NDArray

import service_msgs.msg
import turtlesim.srv
from zbot.interfaces import Action, Message, Service

class Kill_Request(Message):
    """turtlesim/srv/Kill_Request

    # Removes a turtle.

    string name
    """
    def __init__(self, *, name: str = ..., check_fields: bool = ...) -> None: ...
    name: str

class Kill_Response(Message):
    """turtlesim/srv/Kill_Response"""
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class Kill_Event(Message):
    """turtlesim/srv/Kill_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[turtlesim.srv.Kill_Request] = ..., response: Collection[turtlesim.srv.Kill_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[turtlesim.srv.Kill_Request]: ...
    @request.setter
    def request(self, value: Collection[turtlesim.srv.Kill_Request]) -> None: ...
    @property
    def response(self) -> list[turtlesim.srv.Kill_Response]: ...
    @response.setter
    def response(self, value: Collection[turtlesim.srv.Kill_Response]) -> None: ...

class Kill(Service):
    Request: TypeAlias = Kill_Request
    Response: TypeAlias = Kill_Response
    Event: TypeAlias = Kill_Event

class SetPen_Request(Message):
    """turtlesim/srv/SetPen_Request

    # Changes the line that a turtle draws; each colour channel from 0 to 255.

    uint8 r
    uint8 g
    uint8 b
    uint8 width # in pixels
    uint8 off # 1 lifts the pen, 0 puts it down
    """
    def __init__(self, *, r: int = ..., g: int = ..., b: int = ..., width: int = ..., off: int = ..., check_fields: bool = ...) -> None: ...
    r: int
    g: int
    b: int
    width: int
    off: int

class SetPen_Response(Message):
    """turtlesim/srv/SetPen_Response"""
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class SetPen_Event(Message):
    """turtlesim/srv/SetPen_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[turtlesim.srv.SetPen_Request] = ..., response: Collection[turtlesim.srv.SetPen_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[turtlesim.srv.SetPen_Request]: ...
    @request.setter
    def request(self, value: Collection[turtlesim.srv.SetPen_Request]) -> None: ...
    @property
    def response(self) -> list[turtlesim.srv.SetPen_Response]: ...
    @response.setter
    def response(self, value: Collection[turtlesim.srv.SetPen_Response]) -> None: ...

class SetPen(Service):
    Request: TypeAlias = SetPen_Request
    Response: TypeAlias = SetPen_Response
    Event: TypeAlias = SetPen_Event

class Spawn_Request(Message):
    """turtlesim/srv/Spawn_Request

    # Adds a turtle.

    float32 x # m from the left edge
    float32 y # m from the lower edge
    float32 theta # heading in rad
    string name # may stay empty: the answer tells which name was chosen
    """
    def __init__(self, *, x: float = ..., y: float = ..., theta: float = ..., name: str = ..., check_fields: bool = ...) -> None: ...
    x: float
    y: float
    theta: float
    name: str

class Spawn_Response(Message):
    """turtlesim/srv/Spawn_Response

    string name # name of the new turtle; empty if the wanted one was taken
    """
    def __init__(self, *, name: str = ..., check_fields: bool = ...) -> None: ...
    name: str

class Spawn_Event(Message):
    """turtlesim/srv/Spawn_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[turtlesim.srv.Spawn_Request] = ..., response: Collection[turtlesim.srv.Spawn_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[turtlesim.srv.Spawn_Request]: ...
    @request.setter
    def request(self, value: Collection[turtlesim.srv.Spawn_Request]) -> None: ...
    @property
    def response(self) -> list[turtlesim.srv.Spawn_Response]: ...
    @response.setter
    def response(self, value: Collection[turtlesim.srv.Spawn_Response]) -> None: ...

class Spawn(Service):
    Request: TypeAlias = Spawn_Request
    Response: TypeAlias = Spawn_Response
    Event: TypeAlias = Spawn_Event

class TeleportAbsolute_Request(Message):
    """turtlesim/srv/TeleportAbsolute_Request

    # Puts a turtle at a place in the window at once.

    float32 x # m from the left edge
    float32 y # m from the lower edge
    float32 theta # heading in rad
    """
    def __init__(self, *, x: float = ..., y: float = ..., theta: float = ..., check_fields: bool = ...) -> None: ...
    x: float
    y: float
    theta: float

class TeleportAbsolute_Response(Message):
    """turtlesim/srv/TeleportAbsolute_Response"""
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class TeleportAbsolute_Event(Message):
    """turtlesim/srv/TeleportAbsolute_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[turtlesim.srv.TeleportAbsolute_Request] = ..., response: Collection[turtlesim.srv.TeleportAbsolute_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[turtlesim.srv.TeleportAbsolute_Request]: ...
    @request.setter
    def request(self, value: Collection[turtlesim.srv.TeleportAbsolute_Request]) -> None: ...
    @property
    def response(self) -> list[turtlesim.srv.TeleportAbsolute_Response]: ...
    @response.setter
    def response(self, value: Collection[turtlesim.srv.TeleportAbsolute_Response]) -> None: ...

class TeleportAbsolute(Service):
    Request: TypeAlias = TeleportAbsolute_Request
    Response: TypeAlias = TeleportAbsolute_Response
    Event: TypeAlias = TeleportAbsolute_Event

class TeleportRelative_Request(Message):
    """turtlesim/srv/TeleportRelative_Request

    # Turns a turtle, then moves it straight ahead, both at once.

    float32 linear # m forward
    float32 angular # rad to the left
    """
    def __init__(self, *, linear: float = ..., angular: float = ..., check_fields: bool = ...) -> None: ...
    linear: float
    angular: float

class TeleportRelative_Response(Message):
    """turtlesim/srv/TeleportRelative_Response"""
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class TeleportRelative_Event(Message):
    """turtlesim/srv/TeleportRelative_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[turtlesim.srv.TeleportRelative_Request] = ..., response: Collection[turtlesim.srv.TeleportRelative_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[turtlesim.srv.TeleportRelative_Request]: ...
    @request.setter
    def request(self, value: Collection[turtlesim.srv.TeleportRelative_Request]) -> None: ...
    @property
    def response(self) -> list[turtlesim.srv.TeleportRelative_Response]: ...
    @response.setter
    def response(self, value: Collection[turtlesim.srv.TeleportRelative_Response]) -> None: ...

class TeleportRelative(Service):
    Request: TypeAlias = TeleportRelative_Request
    Response: TypeAlias = TeleportRelative_Response
    Event: TypeAlias = TeleportRelative_Event
