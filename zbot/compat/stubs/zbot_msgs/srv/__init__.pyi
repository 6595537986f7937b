# Written by python -m zbot.interfaces.stubs; do not edit.
from array import array
from collections.abc import Collection
from typing import Final, TypeAlias

import numpy
from numpy.typing import NDArray

import service_msgs.msg
import turtlesim.msg
import zbot_msgs.msg
import zbot_msgs.srv
from zbot.interfaces import Action, Message, Service

class TurtleScene_Request(Message):
    """zbot_msgs/srv/TurtleScene_Request

    # What a page needs to draw a turtlesim. It asks again and again, and gets what is new since.

    uint32 run # of the last answer
    uint32 until # of the last answer; 0 at first
    """
    def __init__(self, *, run: int = ..., until: int = ..., check_fields: bool = ...) -> None: ...
    run: int
    until: int

class TurtleScene_Response(Message):
    """zbot_msgs/srv/TurtleScene_Response

    uint32 run # another one after each start of the simulator
    uint32 until # how much was drawn so far; tell it in the next request
    uint8[] sheet # PNG of all that was drawn, transparent elsewhere; empty if the lines suffice
    float32[] lines # x0, y0, x1 and y1 of each new line, in pixels from the upper left corner
    uint8[] pens # red, green, blue and width in pixels of each new line
    turtlesim/Color background
    SceneTurtle[] turtles
    """
    def __init__(self, *, run: int = ..., until: int = ..., sheet: Collection[int] = ..., lines: Collection[float] = ..., pens: Collection[int] = ..., background: turtlesim.msg.Color = ..., turtles: Collection[zbot_msgs.msg.SceneTurtle] = ..., check_fields: bool = ...) -> None: ...
    run: int
    until: int
    @property
    def sheet(self) -> array[int]: ...
    @sheet.setter
    def sheet(self, value: Collection[int]) -> None: ...
    @property
    def lines(self) -> array[float]: ...
    @lines.setter
    def lines(self, value: Collection[float]) -> None: ...
    @property
    def pens(self) -> array[int]: ...
    @pens.setter
    def pens(self, value: Collection[int]) -> None: ...
    background: turtlesim.msg.Color
    @property
    def turtles(self) -> list[zbot_msgs.msg.SceneTurtle]: ...
    @turtles.setter
    def turtles(self, value: Collection[zbot_msgs.msg.SceneTurtle]) -> None: ...

class TurtleScene_Event(Message):
    """zbot_msgs/srv/TurtleScene_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[zbot_msgs.srv.TurtleScene_Request] = ..., response: Collection[zbot_msgs.srv.TurtleScene_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[zbot_msgs.srv.TurtleScene_Request]: ...
    @request.setter
    def request(self, value: Collection[zbot_msgs.srv.TurtleScene_Request]) -> None: ...
    @property
    def response(self) -> list[zbot_msgs.srv.TurtleScene_Response]: ...
    @response.setter
    def response(self, value: Collection[zbot_msgs.srv.TurtleScene_Response]) -> None: ...

class TurtleScene(Service):
    Request: TypeAlias = TurtleScene_Request
    Response: TypeAlias = TurtleScene_Response
    Event: TypeAlias = TurtleScene_Event
