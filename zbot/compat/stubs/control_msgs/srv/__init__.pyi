# Written by python -m zbot.interfaces.stubs; do not edit.
from array import array
from collections.abc import Collection
from typing import Final, TypeAlias

import numpy
from numpy.typing import NDArray

import builtin_interfaces.msg
import control_msgs.srv
import service_msgs.msg
from zbot.interfaces import Action, Message, Service

class QueryCalibrationState_Request(Message):
    """control_msgs/srv/QueryCalibrationState_Request

    # Asks whether a robot knows where its joints are.
    """
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class QueryCalibrationState_Response(Message):
    """control_msgs/srv/QueryCalibrationState_Response

    bool is_calibrated
    """
    def __init__(self, *, is_calibrated: bool = ..., check_fields: bool = ...) -> None: ...
    is_calibrated: bool

class QueryCalibrationState_Event(Message):
    """control_msgs/srv/QueryCalibrationState_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[control_msgs.srv.QueryCalibrationState_Request] = ..., response: Collection[control_msgs.srv.QueryCalibrationState_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[control_msgs.srv.QueryCalibrationState_Request]: ...
    @request.setter
    def request(self, value: Collection[control_msgs.srv.QueryCalibrationState_Request]) -> None: ...
    @property
    def response(self) -> list[control_msgs.srv.QueryCalibrationState_Response]: ...
    @response.setter
    def response(self, value: Collection[control_msgs.srv.QueryCalibrationState_Response]) -> None: ...

class QueryCalibrationState(Service):
    Request: TypeAlias = QueryCalibrationState_Request
    Response: TypeAlias = QueryCalibrationState_Response
    Event: TypeAlias = QueryCalibrationState_Event

class QueryTrajectoryState_Request(Message):
    """control_msgs/srv/QueryTrajectoryState_Request

    # Asks where the joints are to be at a time.

    builtin_interfaces/Time time
    """
    def __init__(self, *, time: builtin_interfaces.msg.Time = ..., check_fields: bool = ...) -> None: ...
    time: builtin_interfaces.msg.Time

class QueryTrajectoryState_Response(Message):
    """control_msgs/srv/QueryTrajectoryState_Response

    bool success
    string message
    string[] name
    float64[] position
    float64[] velocity
    float64[] acceleration
    """
    def __init__(self, *, success: bool = ..., message: str = ..., name: Collection[str] = ..., position: Collection[float] = ..., velocity: Collection[float] = ..., acceleration: Collection[float] = ..., check_fields: bool = ...) -> None: ...
    success: bool
    message: str
    @property
    def name(self) -> list[str]: ...
    @name.setter
    def name(self, value: Collection[str]) -> None: ...
    @property
    def position(self) -> array[float]: ...
    @position.setter
    def position(self, value: Collection[float]) -> None: ...
    @property
    def velocity(self) -> array[float]: ...
    @velocity.setter
    def velocity(self, value: Collection[float]) -> None: ...
    @property
    def acceleration(self) -> array[float]: ...
    @acceleration.setter
    def acceleration(self, value: Collection[float]) -> None: ...

class QueryTrajectoryState_Event(Message):
    """control_msgs/srv/QueryTrajectoryState_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[control_msgs.srv.QueryTrajectoryState_Request] = ..., response: Collection[control_msgs.srv.QueryTrajectoryState_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[control_msgs.srv.QueryTrajectoryState_Request]: ...
    @request.setter
    def request(self, value: Collection[control_msgs.srv.QueryTrajectoryState_Request]) -> None: ...
    @property
    def response(self) -> list[control_msgs.srv.QueryTrajectoryState_Response]: ...
    @response.setter
    def response(self, value: Collection[control_msgs.srv.QueryTrajectoryState_Response]) -> None: ...

class QueryTrajectoryState(Service):
    Request: TypeAlias = QueryTrajectoryState_Request
    Response: TypeAlias = QueryTrajectoryState_Response
    Event: TypeAlias = QueryTrajectoryState_Event

class SetOdometry_Request(Message):
    """control_msgs/srv/SetOdometry_Request

    # Sets the pose that odometry continues from.

    float64 x  # m
    float64 y  # m
    float64 z  # m
    float64 roll  # rad
    float64 pitch  # rad
    float64 yaw  # rad
    """
    def __init__(self, *, x: float = ..., y: float = ..., z: float = ..., roll: float = ..., pitch: float = ..., yaw: float = ..., check_fields: bool = ...) -> None: ...
    x: float
    y: float
    z: float
    roll: float
    pitch: float
    yaw: float

class SetOdometry_Response(Message):
    """control_msgs/srv/SetOdometry_Response

    bool success
    string message
    """
    def __init__(self, *, success: bool = ..., message: str = ..., check_fields: bool = ...) -> None: ...
    success: bool
    message: str

class SetOdometry_Event(Message):
    """control_msgs/srv/SetOdometry_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[control_msgs.srv.SetOdometry_Request] = ..., response: Collection[control_msgs.srv.SetOdometry_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[control_msgs.srv.SetOdometry_Request]: ...
    @request.setter
    def request(self, value: Collection[control_msgs.srv.SetOdometry_Request]) -> None: ...
    @property
    def response(self) -> list[control_msgs.srv.SetOdometry_Response]: ...
    @response.setter
    def response(self, value: Collection[control_msgs.srv.SetOdometry_Response]) -> None: ...

class SetOdometry(Service):
    Request: TypeAlias = SetOdometry_Request
    Response: TypeAlias = SetOdometry_Response
    Event: TypeAlias = SetOdometry_Event
