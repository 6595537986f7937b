# Written by python -m zbot.interfaces.stubs; do not edit.
from array import array
from collections.abc import Collection
from typing import Final, TypeAlias

import numpy
from numpy.typing import NDArray

import geometry_msgs.msg
import nav2_msgs.msg
import nav2_msgs.srv
import nav_msgs.msg
import service_msgs.msg
import std_msgs.msg
from zbot.interfaces import Action, Message, Service

class ClearEntireCostmap_Request(Message):
    """nav2_msgs/srv/ClearEntireCostmap_Request

    # Forgets all obstacles of a map of costs.

    std_msgs/Empty request
    """
    def __init__(self, *, request: std_msgs.msg.Empty = ...) -> None: ...
    request: std_msgs.msg.Empty

class ClearEntireCostmap_Response(Message):
    """nav2_msgs/srv/ClearEntireCostmap_Response

    std_msgs/Empty response
    """
    def __init__(self, *, response: std_msgs.msg.Empty = ...) -> None: ...
    response: std_msgs.msg.Empty

class ClearEntireCostmap_Event(Message):
    """nav2_msgs/srv/ClearEntireCostmap_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[nav2_msgs.srv.ClearEntireCostmap_Request] = ..., response: Collection[nav2_msgs.srv.ClearEntireCostmap_Response] = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[nav2_msgs.srv.ClearEntireCostmap_Request]: ...
    @request.setter
    def request(self, value: Collection[nav2_msgs.srv.ClearEntireCostmap_Request]) -> None: ...
    @property
    def response(self) -> list[nav2_msgs.srv.ClearEntireCostmap_Response]: ...
    @response.setter
    def response(self, value: Collection[nav2_msgs.srv.ClearEntireCostmap_Response]) -> None: ...

class ClearEntireCostmap(Service):
    Request: TypeAlias = ClearEntireCostmap_Request
    Response: TypeAlias = ClearEntireCostmap_Response
    Event: TypeAlias = ClearEntireCostmap_Event

class GetCostmap_Request(Message):
    """nav2_msgs/srv/GetCostmap_Request

    # Asks for a map of costs.

    CostmapMetaData specs  # not looked at
    """
    def __init__(self, *, specs: nav2_msgs.msg.CostmapMetaData = ...) -> None: ...
    specs: nav2_msgs.msg.CostmapMetaData

class GetCostmap_Response(Message):
    """nav2_msgs/srv/GetCostmap_Response

    Costmap map
    """
    def __init__(self, *, map: nav2_msgs.msg.Costmap = ...) -> None: ...
    map: nav2_msgs.msg.Costmap

class GetCostmap_Event(Message):
    """nav2_msgs/srv/GetCostmap_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[nav2_msgs.srv.GetCostmap_Request] = ..., response: Collection[nav2_msgs.srv.GetCostmap_Response] = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[nav2_msgs.srv.GetCostmap_Request]: ...
    @request.setter
    def request(self, value: Collection[nav2_msgs.srv.GetCostmap_Request]) -> None: ...
    @property
    def response(self) -> list[nav2_msgs.srv.GetCostmap_Response]: ...
    @response.setter
    def response(self, value: Collection[nav2_msgs.srv.GetCostmap_Response]) -> None: ...

class GetCostmap(Service):
    Request: TypeAlias = GetCostmap_Request
    Response: TypeAlias = GetCostmap_Response
    Event: TypeAlias = GetCostmap_Event

class IsPathValid_Request(Message):
    """nav2_msgs/srv/IsPathValid_Request

    # Asks whether a path is free.

    nav_msgs/Path path
    """
    def __init__(self, *, path: nav_msgs.msg.Path = ...) -> None: ...
    path: nav_msgs.msg.Path

class IsPathValid_Response(Message):
    """nav2_msgs/srv/IsPathValid_Response

    bool is_valid
    int32[] invalid_pose_indices
    """
    def __init__(self, *, is_valid: bool = ..., invalid_pose_indices: Collection[int] = ...) -> None: ...
    is_valid: bool
    @property
    def invalid_pose_indices(self) -> array[int]: ...
    @invalid_pose_indices.setter
    def invalid_pose_indices(self, value: Collection[int]) -> None: ...

class IsPathValid_Event(Message):
    """nav2_msgs/srv/IsPathValid_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[nav2_msgs.srv.IsPathValid_Request] = ..., response: Collection[nav2_msgs.srv.IsPathValid_Response] = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[nav2_msgs.srv.IsPathValid_Request]: ...
    @request.setter
    def request(self, value: Collection[nav2_msgs.srv.IsPathValid_Request]) -> None: ...
    @property
    def response(self) -> list[nav2_msgs.srv.IsPathValid_Response]: ...
    @response.setter
    def response(self, value: Collection[nav2_msgs.srv.IsPathValid_Response]) -> None: ...

class IsPathValid(Service):
    Request: TypeAlias = IsPathValid_Request
    Response: TypeAlias = IsPathValid_Response
    Event: TypeAlias = IsPathValid_Event

class LoadMap_Request(Message):
    """nav2_msgs/srv/LoadMap_Request

    # Has a map read from a file.

    string map_url
    """
    def __init__(self, *, map_url: str = ...) -> None: ...
    map_url: str

class LoadMap_Response(Message):
    """nav2_msgs/srv/LoadMap_Response

    uint8 RESULT_SUCCESS=0
    uint8 RESULT_MAP_DOES_NOT_EXIST=1
    uint8 RESULT_INVALID_MAP_DATA=2
    uint8 RESULT_INVALID_MAP_METADATA=3
    uint8 RESULT_UNDEFINED_FAILURE=255

    nav_msgs/OccupancyGrid map
    uint8 result
    """
    RESULT_SUCCESS: Final = 0
    RESULT_MAP_DOES_NOT_EXIST: Final = 1
    RESULT_INVALID_MAP_DATA: Final = 2
    RESULT_INVALID_MAP_METADATA: Final = 3
    RESULT_UNDEFINED_FAILURE: Final = 255
    def __init__(self, *, map: nav_msgs.msg.OccupancyGrid = ..., result: int = ...) -> None: ...
    map: nav_msgs.msg.OccupancyGrid
    result: int

class LoadMap_Event(Message):
    """nav2_msgs/srv/LoadMap_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[nav2_msgs.srv.LoadMap_Request] = ..., response: Collection[nav2_msgs.srv.LoadMap_Response] = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[nav2_msgs.srv.LoadMap_Request]: ...
    @request.setter
    def request(self, value: Collection[nav2_msgs.srv.LoadMap_Request]) -> None: ...
    @property
    def response(self) -> list[nav2_msgs.srv.LoadMap_Response]: ...
    @response.setter
    def response(self, value: Collection[nav2_msgs.srv.LoadMap_Response]) -> None: ...

class LoadMap(Service):
    Request: TypeAlias = LoadMap_Request
    Response: TypeAlias = LoadMap_Response
    Event: TypeAlias = LoadMap_Event

class ManageLifecycleNodes_Request(Message):
    """nav2_msgs/srv/ManageLifecycleNodes_Request

    # Leads all nodes of the navigation through their lives together.

    uint8 STARTUP = 0
    uint8 PAUSE = 1
    uint8 RESUME = 2
    uint8 RESET = 3
    uint8 SHUTDOWN = 4

    uint8 command
    """
    STARTUP: Final = 0
    PAUSE: Final = 1
    RESUME: Final = 2
    RESET: Final = 3
    SHUTDOWN: Final = 4
    def __init__(self, *, command: int = ...) -> None: ...
    command: int

class ManageLifecycleNodes_Response(Message):
    """nav2_msgs/srv/ManageLifecycleNodes_Response

    bool success
    """
    def __init__(self, *, success: bool = ...) -> None: ...
    success: bool

class ManageLifecycleNodes_Event(Message):
    """nav2_msgs/srv/ManageLifecycleNodes_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[nav2_msgs.srv.ManageLifecycleNodes_Request] = ..., response: Collection[nav2_msgs.srv.ManageLifecycleNodes_Response] = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[nav2_msgs.srv.ManageLifecycleNodes_Request]: ...
    @request.setter
    def request(self, value: Collection[nav2_msgs.srv.ManageLifecycleNodes_Request]) -> None: ...
    @property
    def response(self) -> list[nav2_msgs.srv.ManageLifecycleNodes_Response]: ...
    @response.setter
    def response(self, value: Collection[nav2_msgs.srv.ManageLifecycleNodes_Response]) -> None: ...

class ManageLifecycleNodes(Service):
    Request: TypeAlias = ManageLifecycleNodes_Request
    Response: TypeAlias = ManageLifecycleNodes_Response
    Event: TypeAlias = ManageLifecycleNodes_Event

class SaveMap_Request(Message):
    """nav2_msgs/srv/SaveMap_Request

    # Has a map written to a file.

    string map_topic
    string map_url
    string image_format    # pgm, png or bmp
    string map_mode        # trinary, scale or raw
    float32 free_thresh
    float32 occupied_thresh
    """
    def __init__(self, *, map_topic: str = ..., map_url: str = ..., image_format: str = ..., map_mode: str = ..., free_thresh: float = ..., occupied_thresh: float = ...) -> None: ...
    map_topic: str
    map_url: str
    image_format: str
    map_mode: str
    free_thresh: float
    occupied_thresh: float

class SaveMap_Response(Message):
    """nav2_msgs/srv/SaveMap_Response

    bool result
    """
    def __init__(self, *, result: bool = ...) -> None: ...
    result: bool

class SaveMap_Event(Message):
    """nav2_msgs/srv/SaveMap_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[nav2_msgs.srv.SaveMap_Request] = ..., response: Collection[nav2_msgs.srv.SaveMap_Response] = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[nav2_msgs.srv.SaveMap_Request]: ...
    @request.setter
    def request(self, value: Collection[nav2_msgs.srv.SaveMap_Request]) -> None: ...
    @property
    def response(self) -> list[nav2_msgs.srv.SaveMap_Response]: ...
    @response.setter
    def response(self, value: Collection[nav2_msgs.srv.SaveMap_Response]) -> None: ...

class SaveMap(Service):
    Request: TypeAlias = SaveMap_Request
    Response: TypeAlias = SaveMap_Response
    Event: TypeAlias = SaveMap_Event

class SetInitialPose_Request(Message):
    """nav2_msgs/srv/SetInitialPose_Request

    # Tells a robot where it is.

    geometry_msgs/PoseWithCovarianceStamped pose
    """
    def __init__(self, *, pose: geometry_msgs.msg.PoseWithCovarianceStamped = ...) -> None: ...
    pose: geometry_msgs.msg.PoseWithCovarianceStamped

class SetInitialPose_Response(Message):
    """nav2_msgs/srv/SetInitialPose_Response"""
    def __init__(self) -> None: ...

class SetInitialPose_Event(Message):
    """nav2_msgs/srv/SetInitialPose_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[nav2_msgs.srv.SetInitialPose_Request] = ..., response: Collection[nav2_msgs.srv.SetInitialPose_Response] = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[nav2_msgs.srv.SetInitialPose_Request]: ...
    @request.setter
    def request(self, value: Collection[nav2_msgs.srv.SetInitialPose_Request]) -> None: ...
    @property
    def response(self) -> list[nav2_msgs.srv.SetInitialPose_Response]: ...
    @response.setter
    def response(self, value: Collection[nav2_msgs.srv.SetInitialPose_Response]) -> None: ...

class SetInitialPose(Service):
    Request: TypeAlias = SetInitialPose_Request
    Response: TypeAlias = SetInitialPose_Response
    Event: TypeAlias = SetInitialPose_Event
