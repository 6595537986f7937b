# Written by python -m zbot.interfaces.stubs; do not edit.
from array import array
from collections.abc import Collection
from typing import Final, TypeAlias

import numpy
from numpy.typing import NDArray

import map_msgs.msg
import map_msgs.srv
import nav_msgs.msg
import sensor_msgs.msg
import service_msgs.msg
import std_msgs.msg
from zbot.interfaces import Action, Message, Service

class GetMapROI_Request(Message):
    """map_msgs/srv/GetMapROI_Request

    # Returns a rectangle of a map.

    float64 x  # m, of the middle
    float64 y  # m
    float64 l_x  # m, length
    float64 l_y  # m
    """
    def __init__(self, *, x: float = ..., y: float = ..., l_x: float = ..., l_y: float = ..., check_fields: bool = ...) -> None: ...
    x: float
    y: float
    l_x: float
    l_y: float

class GetMapROI_Response(Message):
    """map_msgs/srv/GetMapROI_Response

    nav_msgs/OccupancyGrid sub_map
    """
    def __init__(self, *, sub_map: nav_msgs.msg.OccupancyGrid = ..., check_fields: bool = ...) -> None: ...
    sub_map: nav_msgs.msg.OccupancyGrid

class GetMapROI_Event(Message):
    """map_msgs/srv/GetMapROI_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[map_msgs.srv.GetMapROI_Request] = ..., response: Collection[map_msgs.srv.GetMapROI_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[map_msgs.srv.GetMapROI_Request]: ...
    @request.setter
    def request(self, value: Collection[map_msgs.srv.GetMapROI_Request]) -> None: ...
    @property
    def response(self) -> list[map_msgs.srv.GetMapROI_Response]: ...
    @response.setter
    def response(self, value: Collection[map_msgs.srv.GetMapROI_Response]) -> None: ...

class GetMapROI(Service):
    Request: TypeAlias = GetMapROI_Request
    Response: TypeAlias = GetMapROI_Response
    Event: TypeAlias = GetMapROI_Event

class GetPointMap_Request(Message):
    """map_msgs/srv/GetPointMap_Request

    # Returns a map of points.
    """
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class GetPointMap_Response(Message):
    """map_msgs/srv/GetPointMap_Response

    sensor_msgs/PointCloud2 map
    """
    def __init__(self, *, map: sensor_msgs.msg.PointCloud2 = ..., check_fields: bool = ...) -> None: ...
    map: sensor_msgs.msg.PointCloud2

class GetPointMap_Event(Message):
    """map_msgs/srv/GetPointMap_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[map_msgs.srv.GetPointMap_Request] = ..., response: Collection[map_msgs.srv.GetPointMap_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[map_msgs.srv.GetPointMap_Request]: ...
    @request.setter
    def request(self, value: Collection[map_msgs.srv.GetPointMap_Request]) -> None: ...
    @property
    def response(self) -> list[map_msgs.srv.GetPointMap_Response]: ...
    @response.setter
    def response(self, value: Collection[map_msgs.srv.GetPointMap_Response]) -> None: ...

class GetPointMap(Service):
    Request: TypeAlias = GetPointMap_Request
    Response: TypeAlias = GetPointMap_Response
    Event: TypeAlias = GetPointMap_Event

class GetPointMapROI_Request(Message):
    """map_msgs/srv/GetPointMapROI_Request

    # Returns the points of a map in a ball or a box.

    float64 x  # m, of the middle
    float64 y  # m
    float64 z  # m
    float64 r  # m, radius, or 0.0 for a box
    float64 l_x  # m, length
    float64 l_y  # m
    float64 l_z  # m
    """
    def __init__(self, *, x: float = ..., y: float = ..., z: float = ..., r: float = ..., l_x: float = ..., l_y: float = ..., l_z: float = ..., check_fields: bool = ...) -> None: ...
    x: float
    y: float
    z: float
    r: float
    l_x: float
    l_y: float
    l_z: float

class GetPointMapROI_Response(Message):
    """map_msgs/srv/GetPointMapROI_Response

    sensor_msgs/PointCloud2 sub_map
    """
    def __init__(self, *, sub_map: sensor_msgs.msg.PointCloud2 = ..., check_fields: bool = ...) -> None: ...
    sub_map: sensor_msgs.msg.PointCloud2

class GetPointMapROI_Event(Message):
    """map_msgs/srv/GetPointMapROI_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[map_msgs.srv.GetPointMapROI_Request] = ..., response: Collection[map_msgs.srv.GetPointMapROI_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[map_msgs.srv.GetPointMapROI_Request]: ...
    @request.setter
    def request(self, value: Collection[map_msgs.srv.GetPointMapROI_Request]) -> None: ...
    @property
    def response(self) -> list[map_msgs.srv.GetPointMapROI_Response]: ...
    @response.setter
    def response(self, value: Collection[map_msgs.srv.GetPointMapROI_Response]) -> None: ...

class GetPointMapROI(Service):
    Request: TypeAlias = GetPointMapROI_Request
    Response: TypeAlias = GetPointMapROI_Response
    Event: TypeAlias = GetPointMapROI_Event

class ProjectedMapsInfo_Request(Message):
    """map_msgs/srv/ProjectedMapsInfo_Request

    # Sets the flat maps to make.

    map_msgs/ProjectedMapInfo[] projected_maps_info
    """
    def __init__(self, *, projected_maps_info: Collection[map_msgs.msg.ProjectedMapInfo] = ..., check_fields: bool = ...) -> None: ...
    @property
    def projected_maps_info(self) -> list[map_msgs.msg.ProjectedMapInfo]: ...
    @projected_maps_info.setter
    def projected_maps_info(self, value: Collection[map_msgs.msg.ProjectedMapInfo]) -> None: ...

class ProjectedMapsInfo_Response(Message):
    """map_msgs/srv/ProjectedMapsInfo_Response"""
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class ProjectedMapsInfo_Event(Message):
    """map_msgs/srv/ProjectedMapsInfo_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[map_msgs.srv.ProjectedMapsInfo_Request] = ..., response: Collection[map_msgs.srv.ProjectedMapsInfo_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[map_msgs.srv.ProjectedMapsInfo_Request]: ...
    @request.setter
    def request(self, value: Collection[map_msgs.srv.ProjectedMapsInfo_Request]) -> None: ...
    @property
    def response(self) -> list[map_msgs.srv.ProjectedMapsInfo_Response]: ...
    @response.setter
    def response(self, value: Collection[map_msgs.srv.ProjectedMapsInfo_Response]) -> None: ...

class ProjectedMapsInfo(Service):
    Request: TypeAlias = ProjectedMapsInfo_Request
    Response: TypeAlias = ProjectedMapsInfo_Response
    Event: TypeAlias = ProjectedMapsInfo_Event

class SaveMap_Request(Message):
    """map_msgs/srv/SaveMap_Request

    # Saves the map to a file.

    std_msgs/String filename
    """
    def __init__(self, *, filename: std_msgs.msg.String = ..., check_fields: bool = ...) -> None: ...
    filename: std_msgs.msg.String

class SaveMap_Response(Message):
    """map_msgs/srv/SaveMap_Response"""
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class SaveMap_Event(Message):
    """map_msgs/srv/SaveMap_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[map_msgs.srv.SaveMap_Request] = ..., response: Collection[map_msgs.srv.SaveMap_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[map_msgs.srv.SaveMap_Request]: ...
    @request.setter
    def request(self, value: Collection[map_msgs.srv.SaveMap_Request]) -> None: ...
    @property
    def response(self) -> list[map_msgs.srv.SaveMap_Response]: ...
    @response.setter
    def response(self, value: Collection[map_msgs.srv.SaveMap_Response]) -> None: ...

class SaveMap(Service):
    Request: TypeAlias = SaveMap_Request
    Response: TypeAlias = SaveMap_Response
    Event: TypeAlias = SaveMap_Event

class SetMapProjections_Request(Message):
    """map_msgs/srv/SetMapProjections_Request

    # Returns the flat maps that are made.
    """
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class SetMapProjections_Response(Message):
    """map_msgs/srv/SetMapProjections_Response

    map_msgs/ProjectedMapInfo[] projected_maps_info
    """
    def __init__(self, *, projected_maps_info: Collection[map_msgs.msg.ProjectedMapInfo] = ..., check_fields: bool = ...) -> None: ...
    @property
    def projected_maps_info(self) -> list[map_msgs.msg.ProjectedMapInfo]: ...
    @projected_maps_info.setter
    def projected_maps_info(self, value: Collection[map_msgs.msg.ProjectedMapInfo]) -> None: ...

class SetMapProjections_Event(Message):
    """map_msgs/srv/SetMapProjections_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[map_msgs.srv.SetMapProjections_Request] = ..., response: Collection[map_msgs.srv.SetMapProjections_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[map_msgs.srv.SetMapProjections_Request]: ...
    @request.setter
    def request(self, value: Collection[map_msgs.srv.SetMapProjections_Request]) -> None: ...
    @property
    def response(self) -> list[map_msgs.srv.SetMapProjections_Response]: ...
    @response.setter
    def response(self, value: Collection[map_msgs.srv.SetMapProjections_Response]) -> None: ...

class SetMapProjections(Service):
    Request: TypeAlias = SetMapProjections_Request
    Response: TypeAlias = SetMapProjections_Response
    Event: TypeAlias = SetMapProjections_Event
