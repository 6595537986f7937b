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

class ClearCostmapAroundRobot_Request(Message):
    """nav2_msgs/srv/ClearCostmapAroundRobot_Request

    # Forgets the obstacles near the robot.

    float32 reset_distance  # m
    """
    def __init__(self, *, reset_distance: float = ..., check_fields: bool = ...) -> None: ...
    reset_distance: float

class ClearCostmapAroundRobot_Response(Message):
    """nav2_msgs/srv/ClearCostmapAroundRobot_Response

    std_msgs/Empty response
    """
    def __init__(self, *, response: std_msgs.msg.Empty = ..., check_fields: bool = ...) -> None: ...
    response: std_msgs.msg.Empty

class ClearCostmapAroundRobot_Event(Message):
    """nav2_msgs/srv/ClearCostmapAroundRobot_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[nav2_msgs.srv.ClearCostmapAroundRobot_Request] = ..., response: Collection[nav2_msgs.srv.ClearCostmapAroundRobot_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[nav2_msgs.srv.ClearCostmapAroundRobot_Request]: ...
    @request.setter
    def request(self, value: Collection[nav2_msgs.srv.ClearCostmapAroundRobot_Request]) -> None: ...
    @property
    def response(self) -> list[nav2_msgs.srv.ClearCostmapAroundRobot_Response]: ...
    @response.setter
    def response(self, value: Collection[nav2_msgs.srv.ClearCostmapAroundRobot_Response]) -> None: ...

class ClearCostmapAroundRobot(Service):
    Request: TypeAlias = ClearCostmapAroundRobot_Request
    Response: TypeAlias = ClearCostmapAroundRobot_Response
    Event: TypeAlias = ClearCostmapAroundRobot_Event

class ClearCostmapExceptRegion_Request(Message):
    """nav2_msgs/srv/ClearCostmapExceptRegion_Request

    # Forgets all obstacles but those near the robot.

    float32 reset_distance  # m
    """
    def __init__(self, *, reset_distance: float = ..., check_fields: bool = ...) -> None: ...
    reset_distance: float

class ClearCostmapExceptRegion_Response(Message):
    """nav2_msgs/srv/ClearCostmapExceptRegion_Response

    std_msgs/Empty response
    """
    def __init__(self, *, response: std_msgs.msg.Empty = ..., check_fields: bool = ...) -> None: ...
    response: std_msgs.msg.Empty

class ClearCostmapExceptRegion_Event(Message):
    """nav2_msgs/srv/ClearCostmapExceptRegion_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[nav2_msgs.srv.ClearCostmapExceptRegion_Request] = ..., response: Collection[nav2_msgs.srv.ClearCostmapExceptRegion_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[nav2_msgs.srv.ClearCostmapExceptRegion_Request]: ...
    @request.setter
    def request(self, value: Collection[nav2_msgs.srv.ClearCostmapExceptRegion_Request]) -> None: ...
    @property
    def response(self) -> list[nav2_msgs.srv.ClearCostmapExceptRegion_Response]: ...
    @response.setter
    def response(self, value: Collection[nav2_msgs.srv.ClearCostmapExceptRegion_Response]) -> None: ...

class ClearCostmapExceptRegion(Service):
    Request: TypeAlias = ClearCostmapExceptRegion_Request
    Response: TypeAlias = ClearCostmapExceptRegion_Response
    Event: TypeAlias = ClearCostmapExceptRegion_Event

class ClearEntireCostmap_Request(Message):
    """nav2_msgs/srv/ClearEntireCostmap_Request

    # Forgets all obstacles of a map of costs.

    std_msgs/Empty request
    """
    def __init__(self, *, request: std_msgs.msg.Empty = ..., check_fields: bool = ...) -> None: ...
    request: std_msgs.msg.Empty

class ClearEntireCostmap_Response(Message):
    """nav2_msgs/srv/ClearEntireCostmap_Response

    std_msgs/Empty response
    """
    def __init__(self, *, response: std_msgs.msg.Empty = ..., check_fields: bool = ...) -> None: ...
    response: std_msgs.msg.Empty

class ClearEntireCostmap_Event(Message):
    """nav2_msgs/srv/ClearEntireCostmap_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[nav2_msgs.srv.ClearEntireCostmap_Request] = ..., response: Collection[nav2_msgs.srv.ClearEntireCostmap_Response] = ..., check_fields: bool = ...) -> None: ...
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

class DynamicEdges_Request(Message):
    """nav2_msgs/srv/DynamicEdges_Request

    # Closes and opens ways of a graph of places, or changes what they cost.

    uint16[] closed_edges
    uint16[] opened_edges
    EdgeCost[] adjust_edges
    """
    def __init__(self, *, closed_edges: Collection[int] = ..., opened_edges: Collection[int] = ..., adjust_edges: Collection[nav2_msgs.msg.EdgeCost] = ..., check_fields: bool = ...) -> None: ...
    @property
    def closed_edges(self) -> array[int]: ...
    @closed_edges.setter
    def closed_edges(self, value: Collection[int]) -> None: ...
    @property
    def opened_edges(self) -> array[int]: ...
    @opened_edges.setter
    def opened_edges(self, value: Collection[int]) -> None: ...
    @property
    def adjust_edges(self) -> list[nav2_msgs.msg.EdgeCost]: ...
    @adjust_edges.setter
    def adjust_edges(self, value: Collection[nav2_msgs.msg.EdgeCost]) -> None: ...

class DynamicEdges_Response(Message):
    """nav2_msgs/srv/DynamicEdges_Response

    bool success
    """
    def __init__(self, *, success: bool = ..., check_fields: bool = ...) -> None: ...
    success: bool

class DynamicEdges_Event(Message):
    """nav2_msgs/srv/DynamicEdges_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[nav2_msgs.srv.DynamicEdges_Request] = ..., response: Collection[nav2_msgs.srv.DynamicEdges_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[nav2_msgs.srv.DynamicEdges_Request]: ...
    @request.setter
    def request(self, value: Collection[nav2_msgs.srv.DynamicEdges_Request]) -> None: ...
    @property
    def response(self) -> list[nav2_msgs.srv.DynamicEdges_Response]: ...
    @response.setter
    def response(self, value: Collection[nav2_msgs.srv.DynamicEdges_Response]) -> None: ...

class DynamicEdges(Service):
    Request: TypeAlias = DynamicEdges_Request
    Response: TypeAlias = DynamicEdges_Response
    Event: TypeAlias = DynamicEdges_Event

class GetCostmap_Request(Message):
    """nav2_msgs/srv/GetCostmap_Request

    # Asks for a map of costs.

    CostmapMetaData specs  # not looked at
    """
    def __init__(self, *, specs: nav2_msgs.msg.CostmapMetaData = ..., check_fields: bool = ...) -> None: ...
    specs: nav2_msgs.msg.CostmapMetaData

class GetCostmap_Response(Message):
    """nav2_msgs/srv/GetCostmap_Response

    Costmap map
    """
    def __init__(self, *, map: nav2_msgs.msg.Costmap = ..., check_fields: bool = ...) -> None: ...
    map: nav2_msgs.msg.Costmap

class GetCostmap_Event(Message):
    """nav2_msgs/srv/GetCostmap_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[nav2_msgs.srv.GetCostmap_Request] = ..., response: Collection[nav2_msgs.srv.GetCostmap_Response] = ..., check_fields: bool = ...) -> None: ...
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

class GetCosts_Request(Message):
    """nav2_msgs/srv/GetCosts_Request

    # Asks what places cost.

    bool use_footprint  # false: that of one cell
    geometry_msgs/PoseStamped[] poses
    """
    def __init__(self, *, use_footprint: bool = ..., poses: Collection[geometry_msgs.msg.PoseStamped] = ..., check_fields: bool = ...) -> None: ...
    use_footprint: bool
    @property
    def poses(self) -> list[geometry_msgs.msg.PoseStamped]: ...
    @poses.setter
    def poses(self, value: Collection[geometry_msgs.msg.PoseStamped]) -> None: ...

class GetCosts_Response(Message):
    """nav2_msgs/srv/GetCosts_Response

    float32[] costs
    bool success
    """
    def __init__(self, *, costs: Collection[float] = ..., success: bool = ..., check_fields: bool = ...) -> None: ...
    @property
    def costs(self) -> array[float]: ...
    @costs.setter
    def costs(self, value: Collection[float]) -> None: ...
    success: bool

class GetCosts_Event(Message):
    """nav2_msgs/srv/GetCosts_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[nav2_msgs.srv.GetCosts_Request] = ..., response: Collection[nav2_msgs.srv.GetCosts_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[nav2_msgs.srv.GetCosts_Request]: ...
    @request.setter
    def request(self, value: Collection[nav2_msgs.srv.GetCosts_Request]) -> None: ...
    @property
    def response(self) -> list[nav2_msgs.srv.GetCosts_Response]: ...
    @response.setter
    def response(self, value: Collection[nav2_msgs.srv.GetCosts_Response]) -> None: ...

class GetCosts(Service):
    Request: TypeAlias = GetCosts_Request
    Response: TypeAlias = GetCosts_Response
    Event: TypeAlias = GetCosts_Event

class IsPathValid_Request(Message):
    """nav2_msgs/srv/IsPathValid_Request

    # Asks whether a path is free.

    nav_msgs/Path path
    """
    def __init__(self, *, path: nav_msgs.msg.Path = ..., check_fields: bool = ...) -> None: ...
    path: nav_msgs.msg.Path

class IsPathValid_Response(Message):
    """nav2_msgs/srv/IsPathValid_Response

    bool is_valid
    int32[] invalid_pose_indices
    """
    def __init__(self, *, is_valid: bool = ..., invalid_pose_indices: Collection[int] = ..., check_fields: bool = ...) -> None: ...
    is_valid: bool
    @property
    def invalid_pose_indices(self) -> array[int]: ...
    @invalid_pose_indices.setter
    def invalid_pose_indices(self, value: Collection[int]) -> None: ...

class IsPathValid_Event(Message):
    """nav2_msgs/srv/IsPathValid_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[nav2_msgs.srv.IsPathValid_Request] = ..., response: Collection[nav2_msgs.srv.IsPathValid_Response] = ..., check_fields: bool = ...) -> None: ...
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
    def __init__(self, *, map_url: str = ..., check_fields: bool = ...) -> None: ...
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
    def __init__(self, *, map: nav_msgs.msg.OccupancyGrid = ..., result: int = ..., check_fields: bool = ...) -> None: ...
    map: nav_msgs.msg.OccupancyGrid
    result: int

class LoadMap_Event(Message):
    """nav2_msgs/srv/LoadMap_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[nav2_msgs.srv.LoadMap_Request] = ..., response: Collection[nav2_msgs.srv.LoadMap_Response] = ..., check_fields: bool = ...) -> None: ...
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
    def __init__(self, *, command: int = ..., check_fields: bool = ...) -> None: ...
    command: int

class ManageLifecycleNodes_Response(Message):
    """nav2_msgs/srv/ManageLifecycleNodes_Response

    bool success
    """
    def __init__(self, *, success: bool = ..., check_fields: bool = ...) -> None: ...
    success: bool

class ManageLifecycleNodes_Event(Message):
    """nav2_msgs/srv/ManageLifecycleNodes_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[nav2_msgs.srv.ManageLifecycleNodes_Request] = ..., response: Collection[nav2_msgs.srv.ManageLifecycleNodes_Response] = ..., check_fields: bool = ...) -> None: ...
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

class ReloadDockDatabase_Request(Message):
    """nav2_msgs/srv/ReloadDockDatabase_Request

    # Has the list of docks read from a file.

    string filepath
    """
    def __init__(self, *, filepath: str = ..., check_fields: bool = ...) -> None: ...
    filepath: str

class ReloadDockDatabase_Response(Message):
    """nav2_msgs/srv/ReloadDockDatabase_Response

    bool success
    """
    def __init__(self, *, success: bool = ..., check_fields: bool = ...) -> None: ...
    success: bool

class ReloadDockDatabase_Event(Message):
    """nav2_msgs/srv/ReloadDockDatabase_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[nav2_msgs.srv.ReloadDockDatabase_Request] = ..., response: Collection[nav2_msgs.srv.ReloadDockDatabase_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[nav2_msgs.srv.ReloadDockDatabase_Request]: ...
    @request.setter
    def request(self, value: Collection[nav2_msgs.srv.ReloadDockDatabase_Request]) -> None: ...
    @property
    def response(self) -> list[nav2_msgs.srv.ReloadDockDatabase_Response]: ...
    @response.setter
    def response(self, value: Collection[nav2_msgs.srv.ReloadDockDatabase_Response]) -> None: ...

class ReloadDockDatabase(Service):
    Request: TypeAlias = ReloadDockDatabase_Request
    Response: TypeAlias = ReloadDockDatabase_Response
    Event: TypeAlias = ReloadDockDatabase_Event

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
    def __init__(self, *, map_topic: str = ..., map_url: str = ..., image_format: str = ..., map_mode: str = ..., free_thresh: float = ..., occupied_thresh: float = ..., check_fields: bool = ...) -> None: ...
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
    def __init__(self, *, result: bool = ..., check_fields: bool = ...) -> None: ...
    result: bool

class SaveMap_Event(Message):
    """nav2_msgs/srv/SaveMap_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[nav2_msgs.srv.SaveMap_Request] = ..., response: Collection[nav2_msgs.srv.SaveMap_Response] = ..., check_fields: bool = ...) -> None: ...
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
    def __init__(self, *, pose: geometry_msgs.msg.PoseWithCovarianceStamped = ..., check_fields: bool = ...) -> None: ...
    pose: geometry_msgs.msg.PoseWithCovarianceStamped

class SetInitialPose_Response(Message):
    """nav2_msgs/srv/SetInitialPose_Response"""
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class SetInitialPose_Event(Message):
    """nav2_msgs/srv/SetInitialPose_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[nav2_msgs.srv.SetInitialPose_Request] = ..., response: Collection[nav2_msgs.srv.SetInitialPose_Response] = ..., check_fields: bool = ...) -> None: ...
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

class SetRouteGraph_Request(Message):
    """nav2_msgs/srv/SetRouteGraph_Request

    # Has a graph of places read from a file.

    string graph_filepath
    """
    def __init__(self, *, graph_filepath: str = ..., check_fields: bool = ...) -> None: ...
    graph_filepath: str

class SetRouteGraph_Response(Message):
    """nav2_msgs/srv/SetRouteGraph_Response

    bool success
    """
    def __init__(self, *, success: bool = ..., check_fields: bool = ...) -> None: ...
    success: bool

class SetRouteGraph_Event(Message):
    """nav2_msgs/srv/SetRouteGraph_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[nav2_msgs.srv.SetRouteGraph_Request] = ..., response: Collection[nav2_msgs.srv.SetRouteGraph_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[nav2_msgs.srv.SetRouteGraph_Request]: ...
    @request.setter
    def request(self, value: Collection[nav2_msgs.srv.SetRouteGraph_Request]) -> None: ...
    @property
    def response(self) -> list[nav2_msgs.srv.SetRouteGraph_Response]: ...
    @response.setter
    def response(self, value: Collection[nav2_msgs.srv.SetRouteGraph_Response]) -> None: ...

class SetRouteGraph(Service):
    Request: TypeAlias = SetRouteGraph_Request
    Response: TypeAlias = SetRouteGraph_Response
    Event: TypeAlias = SetRouteGraph_Event

class Toggle_Request(Message):
    """nav2_msgs/srv/Toggle_Request

    # Turns something on or off.

    bool enable
    """
    def __init__(self, *, enable: bool = ..., check_fields: bool = ...) -> None: ...
    enable: bool

class Toggle_Response(Message):
    """nav2_msgs/srv/Toggle_Response

    bool success
    string message
    """
    def __init__(self, *, success: bool = ..., message: str = ..., check_fields: bool = ...) -> None: ...
    success: bool
    message: str

class Toggle_Event(Message):
    """nav2_msgs/srv/Toggle_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[nav2_msgs.srv.Toggle_Request] = ..., response: Collection[nav2_msgs.srv.Toggle_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[nav2_msgs.srv.Toggle_Request]: ...
    @request.setter
    def request(self, value: Collection[nav2_msgs.srv.Toggle_Request]) -> None: ...
    @property
    def response(self) -> list[nav2_msgs.srv.Toggle_Response]: ...
    @response.setter
    def response(self, value: Collection[nav2_msgs.srv.Toggle_Response]) -> None: ...

class Toggle(Service):
    Request: TypeAlias = Toggle_Request
    Response: TypeAlias = Toggle_Response
    Event: TypeAlias = Toggle_Event
