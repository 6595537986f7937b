# Written by python -m zbot.interfaces.stubs; do not edit.
from array import array
from collections.abc import Collection
from typing import Final, TypeAlias

import numpy
from numpy.typing import NDArray

import geometry_msgs.msg
import nav_msgs.msg
import nav_msgs.srv
import service_msgs.msg
from zbot.interfaces import Action, Message, Service

class GetMap_Request(Message):
    """nav_msgs/srv/GetMap_Request

    # Asks for the map that a server holds.
    """
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class GetMap_Response(Message):
    """nav_msgs/srv/GetMap_Response

    # That map.
    OccupancyGrid map
    """
    def __init__(self, *, map: nav_msgs.msg.OccupancyGrid = ..., check_fields: bool = ...) -> None: ...
    map: nav_msgs.msg.OccupancyGrid

class GetMap_Event(Message):
    """nav_msgs/srv/GetMap_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[nav_msgs.srv.GetMap_Request] = ..., response: Collection[nav_msgs.srv.GetMap_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[nav_msgs.srv.GetMap_Request]: ...
    @request.setter
    def request(self, value: Collection[nav_msgs.srv.GetMap_Request]) -> None: ...
    @property
    def response(self) -> list[nav_msgs.srv.GetMap_Response]: ...
    @response.setter
    def response(self, value: Collection[nav_msgs.srv.GetMap_Response]) -> None: ...

class GetMap(Service):
    Request: TypeAlias = GetMap_Request
    Response: TypeAlias = GetMap_Response
    Event: TypeAlias = GetMap_Event

class GetPlan_Request(Message):
    """nav_msgs/srv/GetPlan_Request

    # Asks for a way from one pose to another.

    # Where it begins.
    geometry_msgs/PoseStamped start

    # Where it shall end.
    geometry_msgs/PoseStamped goal

    # How far from a blocked goal it may end instead, in m along x and y.
    float32 tolerance
    """
    def __init__(self, *, start: geometry_msgs.msg.PoseStamped = ..., goal: geometry_msgs.msg.PoseStamped = ..., tolerance: float = ..., check_fields: bool = ...) -> None: ...
    start: geometry_msgs.msg.PoseStamped
    goal: geometry_msgs.msg.PoseStamped
    tolerance: float

class GetPlan_Response(Message):
    """nav_msgs/srv/GetPlan_Response

    # The way; empty if there is none.
    Path plan
    """
    def __init__(self, *, plan: nav_msgs.msg.Path = ..., check_fields: bool = ...) -> None: ...
    plan: nav_msgs.msg.Path

class GetPlan_Event(Message):
    """nav_msgs/srv/GetPlan_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[nav_msgs.srv.GetPlan_Request] = ..., response: Collection[nav_msgs.srv.GetPlan_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[nav_msgs.srv.GetPlan_Request]: ...
    @request.setter
    def request(self, value: Collection[nav_msgs.srv.GetPlan_Request]) -> None: ...
    @property
    def response(self) -> list[nav_msgs.srv.GetPlan_Response]: ...
    @response.setter
    def response(self, value: Collection[nav_msgs.srv.GetPlan_Response]) -> None: ...

class GetPlan(Service):
    Request: TypeAlias = GetPlan_Request
    Response: TypeAlias = GetPlan_Response
    Event: TypeAlias = GetPlan_Event

class LoadMap_Request(Message):
    """nav_msgs/srv/LoadMap_Request

    # Tells a map server to read a map.

    # Where the map is: 'file:///home/me/maps/lab.yaml' or 'package://my_maps/lab.yaml'.
    string map_url
    """
    def __init__(self, *, map_url: str = ..., check_fields: bool = ...) -> None: ...
    map_url: str

class LoadMap_Response(Message):
    """nav_msgs/srv/LoadMap_Response

    # How it went.
    uint8 RESULT_SUCCESS=0
    uint8 RESULT_MAP_DOES_NOT_EXIST=1
    uint8 RESULT_INVALID_MAP_DATA=2
    uint8 RESULT_INVALID_MAP_METADATA=3
    uint8 RESULT_UNDEFINED_FAILURE=255

    # The map, meaningful after RESULT_SUCCESS only, and one of the codes above.
    nav_msgs/OccupancyGrid map
    uint8 result
    """
    RESULT_SUCCESS: Final = 0
    RESULT_MAP_DOES_NOT_EXIST: Final = 1
    RESULT_INVALID_MAP_DATA: Final = 2
    RESULT_INVALID_MAP_METADATA: Final = 3
    RESULT_UNDEFINED_FAILURE: Final = 255
    def __init__(self, *, map: nav_msgs.msg.OccupancyGrid = ..., result: int = ..., check_fields: bool = ...) -> None: ...
    map: nav_msgs.msg.OccupancyGrid
    result: int

class LoadMap_Event(Message):
    """nav_msgs/srv/LoadMap_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[nav_msgs.srv.LoadMap_Request] = ..., response: Collection[nav_msgs.srv.LoadMap_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[nav_msgs.srv.LoadMap_Request]: ...
    @request.setter
    def request(self, value: Collection[nav_msgs.srv.LoadMap_Request]) -> None: ...
    @property
    def response(self) -> list[nav_msgs.srv.LoadMap_Response]: ...
    @response.setter
    def response(self, value: Collection[nav_msgs.srv.LoadMap_Response]) -> None: ...

class LoadMap(Service):
    Request: TypeAlias = LoadMap_Request
    Response: TypeAlias = LoadMap_Response
    Event: TypeAlias = LoadMap_Event

class SetMap_Request(Message):
    """nav_msgs/srv/SetMap_Request

    # Replaces the map and says where in it the robot is.

    # The new map.
    nav_msgs/OccupancyGrid map

    # First guess of the robot's place.
    geometry_msgs/PoseWithCovarianceStamped initial_pose
    """
    def __init__(self, *, map: nav_msgs.msg.OccupancyGrid = ..., initial_pose: geometry_msgs.msg.PoseWithCovarianceStamped = ..., check_fields: bool = ...) -> None: ...
    map: nav_msgs.msg.OccupancyGrid
    initial_pose: geometry_msgs.msg.PoseWithCovarianceStamped

class SetMap_Response(Message):
    """nav_msgs/srv/SetMap_Response


    # Did the server take the map?
    bool success
    """
    def __init__(self, *, success: bool = ..., check_fields: bool = ...) -> None: ...
    success: bool

class SetMap_Event(Message):
    """nav_msgs/srv/SetMap_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[nav_msgs.srv.SetMap_Request] = ..., response: Collection[nav_msgs.srv.SetMap_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[nav_msgs.srv.SetMap_Request]: ...
    @request.setter
    def request(self, value: Collection[nav_msgs.srv.SetMap_Request]) -> None: ...
    @property
    def response(self) -> list[nav_msgs.srv.SetMap_Response]: ...
    @response.setter
    def response(self, value: Collection[nav_msgs.srv.SetMap_Response]) -> None: ...

class SetMap(Service):
    Request: TypeAlias = SetMap_Request
    Response: TypeAlias = SetMap_Response
    Event: TypeAlias = SetMap_Event
