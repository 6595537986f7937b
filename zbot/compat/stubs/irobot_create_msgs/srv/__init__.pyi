# Written by python -m zbot.interfaces.stubs; do not edit.
from array import array
from collections.abc import Collection
from typing import Final, TypeAlias

import numpy
from numpy.typing import NDArray

import geometry_msgs.msg
import irobot_create_msgs.srv
import service_msgs.msg
from zbot.interfaces import Action, Message, Service

class EStop_Request(Message):
    """irobot_create_msgs/srv/EStop_Request

    # Switches the emergency stop on or off.

    bool e_stop_on
    """
    def __init__(self, *, e_stop_on: bool = ..., check_fields: bool = ...) -> None: ...
    e_stop_on: bool

class EStop_Response(Message):
    """irobot_create_msgs/srv/EStop_Response

    bool success
    string message
    """
    def __init__(self, *, success: bool = ..., message: str = ..., check_fields: bool = ...) -> None: ...
    success: bool
    message: str

class EStop_Event(Message):
    """irobot_create_msgs/srv/EStop_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[irobot_create_msgs.srv.EStop_Request] = ..., response: Collection[irobot_create_msgs.srv.EStop_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[irobot_create_msgs.srv.EStop_Request]: ...
    @request.setter
    def request(self, value: Collection[irobot_create_msgs.srv.EStop_Request]) -> None: ...
    @property
    def response(self) -> list[irobot_create_msgs.srv.EStop_Response]: ...
    @response.setter
    def response(self, value: Collection[irobot_create_msgs.srv.EStop_Response]) -> None: ...

class EStop(Service):
    Request: TypeAlias = EStop_Request
    Response: TypeAlias = EStop_Response
    Event: TypeAlias = EStop_Event

class ResetPose_Request(Message):
    """irobot_create_msgs/srv/ResetPose_Request

    # Sets the pose that odometry continues from.

    geometry_msgs/Pose pose
    """
    def __init__(self, *, pose: geometry_msgs.msg.Pose = ..., check_fields: bool = ...) -> None: ...
    pose: geometry_msgs.msg.Pose

class ResetPose_Response(Message):
    """irobot_create_msgs/srv/ResetPose_Response"""
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class ResetPose_Event(Message):
    """irobot_create_msgs/srv/ResetPose_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[irobot_create_msgs.srv.ResetPose_Request] = ..., response: Collection[irobot_create_msgs.srv.ResetPose_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[irobot_create_msgs.srv.ResetPose_Request]: ...
    @request.setter
    def request(self, value: Collection[irobot_create_msgs.srv.ResetPose_Request]) -> None: ...
    @property
    def response(self) -> list[irobot_create_msgs.srv.ResetPose_Response]: ...
    @response.setter
    def response(self, value: Collection[irobot_create_msgs.srv.ResetPose_Response]) -> None: ...

class ResetPose(Service):
    Request: TypeAlias = ResetPose_Request
    Response: TypeAlias = ResetPose_Response
    Event: TypeAlias = ResetPose_Event

class RobotPower_Request(Message):
    """irobot_create_msgs/srv/RobotPower_Request

    # Switches the robot off.
    """
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class RobotPower_Response(Message):
    """irobot_create_msgs/srv/RobotPower_Response

    bool success
    string message
    """
    def __init__(self, *, success: bool = ..., message: str = ..., check_fields: bool = ...) -> None: ...
    success: bool
    message: str

class RobotPower_Event(Message):
    """irobot_create_msgs/srv/RobotPower_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[irobot_create_msgs.srv.RobotPower_Request] = ..., response: Collection[irobot_create_msgs.srv.RobotPower_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[irobot_create_msgs.srv.RobotPower_Request]: ...
    @request.setter
    def request(self, value: Collection[irobot_create_msgs.srv.RobotPower_Request]) -> None: ...
    @property
    def response(self) -> list[irobot_create_msgs.srv.RobotPower_Response]: ...
    @response.setter
    def response(self, value: Collection[irobot_create_msgs.srv.RobotPower_Response]) -> None: ...

class RobotPower(Service):
    Request: TypeAlias = RobotPower_Request
    Response: TypeAlias = RobotPower_Response
    Event: TypeAlias = RobotPower_Event
