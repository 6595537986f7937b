# Written by python -m zbot.interfaces.stubs; do not edit.
from array import array
from collections.abc import Collection
from typing import Final, TypeAlias

import numpy
from numpy.typing import NDArray

import geometry_msgs.msg
import service_msgs.msg
import slam_toolbox.srv
import std_msgs.msg
from zbot.interfaces import Action, Message, Service

class AddSubmap_Request(Message):
    """slam_toolbox/srv/AddSubmap_Request

    string filename
    """
    def __init__(self, *, filename: str = ..., check_fields: bool = ...) -> None: ...
    filename: str

class AddSubmap_Response(Message):
    """slam_toolbox/srv/AddSubmap_Response"""
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class AddSubmap_Event(Message):
    """slam_toolbox/srv/AddSubmap_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[slam_toolbox.srv.AddSubmap_Request] = ..., response: Collection[slam_toolbox.srv.AddSubmap_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[slam_toolbox.srv.AddSubmap_Request]: ...
    @request.setter
    def request(self, value: Collection[slam_toolbox.srv.AddSubmap_Request]) -> None: ...
    @property
    def response(self) -> list[slam_toolbox.srv.AddSubmap_Response]: ...
    @response.setter
    def response(self, value: Collection[slam_toolbox.srv.AddSubmap_Response]) -> None: ...

class AddSubmap(Service):
    Request: TypeAlias = AddSubmap_Request
    Response: TypeAlias = AddSubmap_Response
    Event: TypeAlias = AddSubmap_Event

class Clear_Request(Message):
    """slam_toolbox/srv/Clear_Request"""
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class Clear_Response(Message):
    """slam_toolbox/srv/Clear_Response"""
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class Clear_Event(Message):
    """slam_toolbox/srv/Clear_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[slam_toolbox.srv.Clear_Request] = ..., response: Collection[slam_toolbox.srv.Clear_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[slam_toolbox.srv.Clear_Request]: ...
    @request.setter
    def request(self, value: Collection[slam_toolbox.srv.Clear_Request]) -> None: ...
    @property
    def response(self) -> list[slam_toolbox.srv.Clear_Response]: ...
    @response.setter
    def response(self, value: Collection[slam_toolbox.srv.Clear_Response]) -> None: ...

class Clear(Service):
    Request: TypeAlias = Clear_Request
    Response: TypeAlias = Clear_Response
    Event: TypeAlias = Clear_Event

class ClearQueue_Request(Message):
    """slam_toolbox/srv/ClearQueue_Request"""
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class ClearQueue_Response(Message):
    """slam_toolbox/srv/ClearQueue_Response

    bool status
    """
    def __init__(self, *, status: bool = ..., check_fields: bool = ...) -> None: ...
    status: bool

class ClearQueue_Event(Message):
    """slam_toolbox/srv/ClearQueue_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[slam_toolbox.srv.ClearQueue_Request] = ..., response: Collection[slam_toolbox.srv.ClearQueue_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[slam_toolbox.srv.ClearQueue_Request]: ...
    @request.setter
    def request(self, value: Collection[slam_toolbox.srv.ClearQueue_Request]) -> None: ...
    @property
    def response(self) -> list[slam_toolbox.srv.ClearQueue_Response]: ...
    @response.setter
    def response(self, value: Collection[slam_toolbox.srv.ClearQueue_Response]) -> None: ...

class ClearQueue(Service):
    Request: TypeAlias = ClearQueue_Request
    Response: TypeAlias = ClearQueue_Response
    Event: TypeAlias = ClearQueue_Event

class DeserializePoseGraph_Request(Message):
    """slam_toolbox/srv/DeserializePoseGraph_Request

    int8 UNSET=0
    int8 START_AT_FIRST_NODE=1
    int8 START_AT_GIVEN_POSE=2
    int8 LOCALIZE_AT_POSE=3
    string filename
    int8 match_type
    geometry_msgs/Pose2D initial_pose
    """
    UNSET: Final = 0
    START_AT_FIRST_NODE: Final = 1
    START_AT_GIVEN_POSE: Final = 2
    LOCALIZE_AT_POSE: Final = 3
    def __init__(self, *, filename: str = ..., match_type: int = ..., initial_pose: geometry_msgs.msg.Pose2D = ..., check_fields: bool = ...) -> None: ...
    filename: str
    match_type: int
    initial_pose: geometry_msgs.msg.Pose2D

class DeserializePoseGraph_Response(Message):
    """slam_toolbox/srv/DeserializePoseGraph_Response"""
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class DeserializePoseGraph_Event(Message):
    """slam_toolbox/srv/DeserializePoseGraph_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[slam_toolbox.srv.DeserializePoseGraph_Request] = ..., response: Collection[slam_toolbox.srv.DeserializePoseGraph_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[slam_toolbox.srv.DeserializePoseGraph_Request]: ...
    @request.setter
    def request(self, value: Collection[slam_toolbox.srv.DeserializePoseGraph_Request]) -> None: ...
    @property
    def response(self) -> list[slam_toolbox.srv.DeserializePoseGraph_Response]: ...
    @response.setter
    def response(self, value: Collection[slam_toolbox.srv.DeserializePoseGraph_Response]) -> None: ...

class DeserializePoseGraph(Service):
    Request: TypeAlias = DeserializePoseGraph_Request
    Response: TypeAlias = DeserializePoseGraph_Response
    Event: TypeAlias = DeserializePoseGraph_Event

class LoopClosure_Request(Message):
    """slam_toolbox/srv/LoopClosure_Request"""
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class LoopClosure_Response(Message):
    """slam_toolbox/srv/LoopClosure_Response"""
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class LoopClosure_Event(Message):
    """slam_toolbox/srv/LoopClosure_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[slam_toolbox.srv.LoopClosure_Request] = ..., response: Collection[slam_toolbox.srv.LoopClosure_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[slam_toolbox.srv.LoopClosure_Request]: ...
    @request.setter
    def request(self, value: Collection[slam_toolbox.srv.LoopClosure_Request]) -> None: ...
    @property
    def response(self) -> list[slam_toolbox.srv.LoopClosure_Response]: ...
    @response.setter
    def response(self, value: Collection[slam_toolbox.srv.LoopClosure_Response]) -> None: ...

class LoopClosure(Service):
    Request: TypeAlias = LoopClosure_Request
    Response: TypeAlias = LoopClosure_Response
    Event: TypeAlias = LoopClosure_Event

class MergeMaps_Request(Message):
    """slam_toolbox/srv/MergeMaps_Request"""
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class MergeMaps_Response(Message):
    """slam_toolbox/srv/MergeMaps_Response"""
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class MergeMaps_Event(Message):
    """slam_toolbox/srv/MergeMaps_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[slam_toolbox.srv.MergeMaps_Request] = ..., response: Collection[slam_toolbox.srv.MergeMaps_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[slam_toolbox.srv.MergeMaps_Request]: ...
    @request.setter
    def request(self, value: Collection[slam_toolbox.srv.MergeMaps_Request]) -> None: ...
    @property
    def response(self) -> list[slam_toolbox.srv.MergeMaps_Response]: ...
    @response.setter
    def response(self, value: Collection[slam_toolbox.srv.MergeMaps_Response]) -> None: ...

class MergeMaps(Service):
    Request: TypeAlias = MergeMaps_Request
    Response: TypeAlias = MergeMaps_Response
    Event: TypeAlias = MergeMaps_Event

class Pause_Request(Message):
    """slam_toolbox/srv/Pause_Request"""
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class Pause_Response(Message):
    """slam_toolbox/srv/Pause_Response

    bool status
    """
    def __init__(self, *, status: bool = ..., check_fields: bool = ...) -> None: ...
    status: bool

class Pause_Event(Message):
    """slam_toolbox/srv/Pause_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[slam_toolbox.srv.Pause_Request] = ..., response: Collection[slam_toolbox.srv.Pause_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[slam_toolbox.srv.Pause_Request]: ...
    @request.setter
    def request(self, value: Collection[slam_toolbox.srv.Pause_Request]) -> None: ...
    @property
    def response(self) -> list[slam_toolbox.srv.Pause_Response]: ...
    @response.setter
    def response(self, value: Collection[slam_toolbox.srv.Pause_Response]) -> None: ...

class Pause(Service):
    Request: TypeAlias = Pause_Request
    Response: TypeAlias = Pause_Response
    Event: TypeAlias = Pause_Event

class Reset_Request(Message):
    """slam_toolbox/srv/Reset_Request

    bool pause_new_measurements false
    """
    def __init__(self, *, pause_new_measurements: bool = ..., check_fields: bool = ...) -> None: ...
    pause_new_measurements: bool

class Reset_Response(Message):
    """slam_toolbox/srv/Reset_Response

    uint8 RESULT_SUCCESS=0
    uint8 result
    """
    RESULT_SUCCESS: Final = 0
    def __init__(self, *, result: int = ..., check_fields: bool = ...) -> None: ...
    result: int

class Reset_Event(Message):
    """slam_toolbox/srv/Reset_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[slam_toolbox.srv.Reset_Request] = ..., response: Collection[slam_toolbox.srv.Reset_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[slam_toolbox.srv.Reset_Request]: ...
    @request.setter
    def request(self, value: Collection[slam_toolbox.srv.Reset_Request]) -> None: ...
    @property
    def response(self) -> list[slam_toolbox.srv.Reset_Response]: ...
    @response.setter
    def response(self, value: Collection[slam_toolbox.srv.Reset_Response]) -> None: ...

class Reset(Service):
    Request: TypeAlias = Reset_Request
    Response: TypeAlias = Reset_Response
    Event: TypeAlias = Reset_Event

class SaveMap_Request(Message):
    """slam_toolbox/srv/SaveMap_Request

    std_msgs/String name
    """
    def __init__(self, *, name: std_msgs.msg.String = ..., check_fields: bool = ...) -> None: ...
    name: std_msgs.msg.String

class SaveMap_Response(Message):
    """slam_toolbox/srv/SaveMap_Response

    uint8 RESULT_SUCCESS=0
    uint8 RESULT_NO_MAP_RECEIEVD=1
    uint8 RESULT_UNDEFINED_FAILURE=255
    uint8 result
    """
    RESULT_SUCCESS: Final = 0
    RESULT_NO_MAP_RECEIEVD: Final = 1
    RESULT_UNDEFINED_FAILURE: Final = 255
    def __init__(self, *, result: int = ..., check_fields: bool = ...) -> None: ...
    result: int

class SaveMap_Event(Message):
    """slam_toolbox/srv/SaveMap_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[slam_toolbox.srv.SaveMap_Request] = ..., response: Collection[slam_toolbox.srv.SaveMap_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[slam_toolbox.srv.SaveMap_Request]: ...
    @request.setter
    def request(self, value: Collection[slam_toolbox.srv.SaveMap_Request]) -> None: ...
    @property
    def response(self) -> list[slam_toolbox.srv.SaveMap_Response]: ...
    @response.setter
    def response(self, value: Collection[slam_toolbox.srv.SaveMap_Response]) -> None: ...

class SaveMap(Service):
    Request: TypeAlias = SaveMap_Request
    Response: TypeAlias = SaveMap_Response
    Event: TypeAlias = SaveMap_Event

class SerializePoseGraph_Request(Message):
    """slam_toolbox/srv/SerializePoseGraph_Request

    string filename
    """
    def __init__(self, *, filename: str = ..., check_fields: bool = ...) -> None: ...
    filename: str

class SerializePoseGraph_Response(Message):
    """slam_toolbox/srv/SerializePoseGraph_Response

    uint8 RESULT_SUCCESS=0
    uint8 RESULT_FAILED_TO_WRITE_FILE=255
    uint8 result
    """
    RESULT_SUCCESS: Final = 0
    RESULT_FAILED_TO_WRITE_FILE: Final = 255
    def __init__(self, *, result: int = ..., check_fields: bool = ...) -> None: ...
    result: int

class SerializePoseGraph_Event(Message):
    """slam_toolbox/srv/SerializePoseGraph_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[slam_toolbox.srv.SerializePoseGraph_Request] = ..., response: Collection[slam_toolbox.srv.SerializePoseGraph_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[slam_toolbox.srv.SerializePoseGraph_Request]: ...
    @request.setter
    def request(self, value: Collection[slam_toolbox.srv.SerializePoseGraph_Request]) -> None: ...
    @property
    def response(self) -> list[slam_toolbox.srv.SerializePoseGraph_Response]: ...
    @response.setter
    def response(self, value: Collection[slam_toolbox.srv.SerializePoseGraph_Response]) -> None: ...

class SerializePoseGraph(Service):
    Request: TypeAlias = SerializePoseGraph_Request
    Response: TypeAlias = SerializePoseGraph_Response
    Event: TypeAlias = SerializePoseGraph_Event

class ToggleInteractive_Request(Message):
    """slam_toolbox/srv/ToggleInteractive_Request"""
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class ToggleInteractive_Response(Message):
    """slam_toolbox/srv/ToggleInteractive_Response"""
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class ToggleInteractive_Event(Message):
    """slam_toolbox/srv/ToggleInteractive_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[slam_toolbox.srv.ToggleInteractive_Request] = ..., response: Collection[slam_toolbox.srv.ToggleInteractive_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[slam_toolbox.srv.ToggleInteractive_Request]: ...
    @request.setter
    def request(self, value: Collection[slam_toolbox.srv.ToggleInteractive_Request]) -> None: ...
    @property
    def response(self) -> list[slam_toolbox.srv.ToggleInteractive_Response]: ...
    @response.setter
    def response(self, value: Collection[slam_toolbox.srv.ToggleInteractive_Response]) -> None: ...

class ToggleInteractive(Service):
    Request: TypeAlias = ToggleInteractive_Request
    Response: TypeAlias = ToggleInteractive_Response
    Event: TypeAlias = ToggleInteractive_Event
