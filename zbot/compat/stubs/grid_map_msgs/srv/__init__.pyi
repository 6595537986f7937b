# Written by python -m zbot.interfaces.stubs; do not edit.
from array import array
from collections.abc import Collection
from typing import Final, TypeAlias

import numpy
from numpy.typing import NDArray

import grid_map_msgs.msg
import grid_map_msgs.srv
import service_msgs.msg
from zbot.interfaces import Action, Message, Service

class GetGridMap_Request(Message):
    """grid_map_msgs/srv/GetGridMap_Request

    string frame_id
    float64 position_x
    float64 position_y
    float64 length_x
    float64 length_y
    string[] layers
    """
    def __init__(self, *, frame_id: str = ..., position_x: float = ..., position_y: float = ..., length_x: float = ..., length_y: float = ..., layers: Collection[str] = ..., check_fields: bool = ...) -> None: ...
    frame_id: str
    position_x: float
    position_y: float
    length_x: float
    length_y: float
    @property
    def layers(self) -> list[str]: ...
    @layers.setter
    def layers(self, value: Collection[str]) -> None: ...

class GetGridMap_Response(Message):
    """grid_map_msgs/srv/GetGridMap_Response

    grid_map_msgs/GridMap map
    """
    def __init__(self, *, map: grid_map_msgs.msg.GridMap = ..., check_fields: bool = ...) -> None: ...
    map: grid_map_msgs.msg.GridMap

class GetGridMap_Event(Message):
    """grid_map_msgs/srv/GetGridMap_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[grid_map_msgs.srv.GetGridMap_Request] = ..., response: Collection[grid_map_msgs.srv.GetGridMap_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[grid_map_msgs.srv.GetGridMap_Request]: ...
    @request.setter
    def request(self, value: Collection[grid_map_msgs.srv.GetGridMap_Request]) -> None: ...
    @property
    def response(self) -> list[grid_map_msgs.srv.GetGridMap_Response]: ...
    @response.setter
    def response(self, value: Collection[grid_map_msgs.srv.GetGridMap_Response]) -> None: ...

class GetGridMap(Service):
    Request: TypeAlias = GetGridMap_Request
    Response: TypeAlias = GetGridMap_Response
    Event: TypeAlias = GetGridMap_Event

class GetGridMapInfo_Request(Message):
    """grid_map_msgs/srv/GetGridMapInfo_Request"""
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class GetGridMapInfo_Response(Message):
    """grid_map_msgs/srv/GetGridMapInfo_Response

    grid_map_msgs/GridMapInfo info
    """
    def __init__(self, *, info: grid_map_msgs.msg.GridMapInfo = ..., check_fields: bool = ...) -> None: ...
    info: grid_map_msgs.msg.GridMapInfo

class GetGridMapInfo_Event(Message):
    """grid_map_msgs/srv/GetGridMapInfo_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[grid_map_msgs.srv.GetGridMapInfo_Request] = ..., response: Collection[grid_map_msgs.srv.GetGridMapInfo_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[grid_map_msgs.srv.GetGridMapInfo_Request]: ...
    @request.setter
    def request(self, value: Collection[grid_map_msgs.srv.GetGridMapInfo_Request]) -> None: ...
    @property
    def response(self) -> list[grid_map_msgs.srv.GetGridMapInfo_Response]: ...
    @response.setter
    def response(self, value: Collection[grid_map_msgs.srv.GetGridMapInfo_Response]) -> None: ...

class GetGridMapInfo(Service):
    Request: TypeAlias = GetGridMapInfo_Request
    Response: TypeAlias = GetGridMapInfo_Response
    Event: TypeAlias = GetGridMapInfo_Event

class ProcessFile_Request(Message):
    """grid_map_msgs/srv/ProcessFile_Request

    string file_path
    string topic_name
    """
    def __init__(self, *, file_path: str = ..., topic_name: str = ..., check_fields: bool = ...) -> None: ...
    file_path: str
    topic_name: str

class ProcessFile_Response(Message):
    """grid_map_msgs/srv/ProcessFile_Response

    bool success
    """
    def __init__(self, *, success: bool = ..., check_fields: bool = ...) -> None: ...
    success: bool

class ProcessFile_Event(Message):
    """grid_map_msgs/srv/ProcessFile_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[grid_map_msgs.srv.ProcessFile_Request] = ..., response: Collection[grid_map_msgs.srv.ProcessFile_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[grid_map_msgs.srv.ProcessFile_Request]: ...
    @request.setter
    def request(self, value: Collection[grid_map_msgs.srv.ProcessFile_Request]) -> None: ...
    @property
    def response(self) -> list[grid_map_msgs.srv.ProcessFile_Response]: ...
    @response.setter
    def response(self, value: Collection[grid_map_msgs.srv.ProcessFile_Response]) -> None: ...

class ProcessFile(Service):
    Request: TypeAlias = ProcessFile_Request
    Response: TypeAlias = ProcessFile_Response
    Event: TypeAlias = ProcessFile_Event

class SetGridMap_Request(Message):
    """grid_map_msgs/srv/SetGridMap_Request

    grid_map_msgs/GridMap map
    """
    def __init__(self, *, map: grid_map_msgs.msg.GridMap = ..., check_fields: bool = ...) -> None: ...
    map: grid_map_msgs.msg.GridMap

class SetGridMap_Response(Message):
    """grid_map_msgs/srv/SetGridMap_Response"""
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class SetGridMap_Event(Message):
    """grid_map_msgs/srv/SetGridMap_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[grid_map_msgs.srv.SetGridMap_Request] = ..., response: Collection[grid_map_msgs.srv.SetGridMap_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[grid_map_msgs.srv.SetGridMap_Request]: ...
    @request.setter
    def request(self, value: Collection[grid_map_msgs.srv.SetGridMap_Request]) -> None: ...
    @property
    def response(self) -> list[grid_map_msgs.srv.SetGridMap_Response]: ...
    @response.setter
    def response(self, value: Collection[grid_map_msgs.srv.SetGridMap_Response]) -> None: ...

class SetGridMap(Service):
    Request: TypeAlias = SetGridMap_Request
    Response: TypeAlias = SetGridMap_Response
    Event: TypeAlias = SetGridMap_Event
