# Written by python -m zbot.interfaces.stubs; do not edit.
from array import array
from collections.abc import Collection
from typing import Final, TypeAlias

import numpy
from numpy.typing import NDArray

import service_msgs.msg
import turtlebot3_msgs.srv
from zbot.interfaces import Action, Message, Service

class Dqn_Request(Message):
    """turtlebot3_msgs/srv/Dqn_Request

    # One step of a robot that learns by deep Q-learning.

    uint8 action
    bool init  # begin anew
    """
    def __init__(self, *, action: int = ..., init: bool = ..., check_fields: bool = ...) -> None: ...
    action: int
    init: bool

class Dqn_Response(Message):
    """turtlebot3_msgs/srv/Dqn_Response

    float32[] state
    float32 reward
    bool done
    """
    def __init__(self, *, state: Collection[float] = ..., reward: float = ..., done: bool = ..., check_fields: bool = ...) -> None: ...
    @property
    def state(self) -> array[float]: ...
    @state.setter
    def state(self, value: Collection[float]) -> None: ...
    reward: float
    done: bool

class Dqn_Event(Message):
    """turtlebot3_msgs/srv/Dqn_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[turtlebot3_msgs.srv.Dqn_Request] = ..., response: Collection[turtlebot3_msgs.srv.Dqn_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[turtlebot3_msgs.srv.Dqn_Request]: ...
    @request.setter
    def request(self, value: Collection[turtlebot3_msgs.srv.Dqn_Request]) -> None: ...
    @property
    def response(self) -> list[turtlebot3_msgs.srv.Dqn_Response]: ...
    @response.setter
    def response(self, value: Collection[turtlebot3_msgs.srv.Dqn_Response]) -> None: ...

class Dqn(Service):
    Request: TypeAlias = Dqn_Request
    Response: TypeAlias = Dqn_Response
    Event: TypeAlias = Dqn_Event

class Goal_Request(Message):
    """turtlebot3_msgs/srv/Goal_Request

    # Returns the goal of a robot that learns.
    """
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class Goal_Response(Message):
    """turtlebot3_msgs/srv/Goal_Response

    float32 pose_x  # m
    float32 pose_y  # m
    bool success
    """
    def __init__(self, *, pose_x: float = ..., pose_y: float = ..., success: bool = ..., check_fields: bool = ...) -> None: ...
    pose_x: float
    pose_y: float
    success: bool

class Goal_Event(Message):
    """turtlebot3_msgs/srv/Goal_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[turtlebot3_msgs.srv.Goal_Request] = ..., response: Collection[turtlebot3_msgs.srv.Goal_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[turtlebot3_msgs.srv.Goal_Request]: ...
    @request.setter
    def request(self, value: Collection[turtlebot3_msgs.srv.Goal_Request]) -> None: ...
    @property
    def response(self) -> list[turtlebot3_msgs.srv.Goal_Response]: ...
    @response.setter
    def response(self, value: Collection[turtlebot3_msgs.srv.Goal_Response]) -> None: ...

class Goal(Service):
    Request: TypeAlias = Goal_Request
    Response: TypeAlias = Goal_Response
    Event: TypeAlias = Goal_Event

class Sound_Request(Message):
    """turtlebot3_msgs/srv/Sound_Request

    # Plays a sound.

    uint8 value  # one of turtlebot3_msgs/msg/Sound
    """
    def __init__(self, *, value: int = ..., check_fields: bool = ...) -> None: ...
    value: int

class Sound_Response(Message):
    """turtlebot3_msgs/srv/Sound_Response

    bool success
    string message
    """
    def __init__(self, *, success: bool = ..., message: str = ..., check_fields: bool = ...) -> None: ...
    success: bool
    message: str

class Sound_Event(Message):
    """turtlebot3_msgs/srv/Sound_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[turtlebot3_msgs.srv.Sound_Request] = ..., response: Collection[turtlebot3_msgs.srv.Sound_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[turtlebot3_msgs.srv.Sound_Request]: ...
    @request.setter
    def request(self, value: Collection[turtlebot3_msgs.srv.Sound_Request]) -> None: ...
    @property
    def response(self) -> list[turtlebot3_msgs.srv.Sound_Response]: ...
    @response.setter
    def response(self, value: Collection[turtlebot3_msgs.srv.Sound_Response]) -> None: ...

class Sound(Service):
    Request: TypeAlias = Sound_Request
    Response: TypeAlias = Sound_Response
    Event: TypeAlias = Sound_Event
