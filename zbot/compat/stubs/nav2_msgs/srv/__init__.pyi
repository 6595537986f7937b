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
import unique_identifier_msgs.msg
from zbot.interfaces import Action, Message, Service

class AddExclusionZone_Request(Message):
    """nav2_msgs/srv/AddExclusionZone_Request

    nav2_msgs/ExclusionZoneDescription zone
    """
    def __init__(self, *, zone: nav2_msgs.msg.ExclusionZoneDescription = ..., check_fields: bool = ...) -> None: ...
    zone: nav2_msgs.msg.ExclusionZoneDescription

class AddExclusionZone_Response(Message):
    """nav2_msgs/srv/AddExclusionZone_Response

    bool success
    string message
    """
    def __init__(self, *, success: bool = ..., message: str = ..., check_fields: bool = ...) -> None: ...
    success: bool
    message: str

class AddExclusionZone_Event(Message):
    """nav2_msgs/srv/AddExclusionZone_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[nav2_msgs.srv.AddExclusionZone_Request] = ..., response: Collection[nav2_msgs.srv.AddExclusionZone_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[nav2_msgs.srv.AddExclusionZone_Request]: ...
    @request.setter
    def request(self, value: Collection[nav2_msgs.srv.AddExclusionZone_Request]) -> None: ...
    @property
    def response(self) -> list[nav2_msgs.srv.AddExclusionZone_Response]: ...
    @response.setter
    def response(self, value: Collection[nav2_msgs.srv.AddExclusionZone_Response]) -> None: ...

class AddExclusionZone(Service):
    Request: TypeAlias = AddExclusionZone_Request
    Response: TypeAlias = AddExclusionZone_Response
    Event: TypeAlias = AddExclusionZone_Event

class AddShapes_Request(Message):
    """nav2_msgs/srv/AddShapes_Request

    CircleObject[] circles
    PolygonObject[] polygons
    """
    def __init__(self, *, circles: Collection[nav2_msgs.msg.CircleObject] = ..., polygons: Collection[nav2_msgs.msg.PolygonObject] = ..., check_fields: bool = ...) -> None: ...
    @property
    def circles(self) -> list[nav2_msgs.msg.CircleObject]: ...
    @circles.setter
    def circles(self, value: Collection[nav2_msgs.msg.CircleObject]) -> None: ...
    @property
    def polygons(self) -> list[nav2_msgs.msg.PolygonObject]: ...
    @polygons.setter
    def polygons(self, value: Collection[nav2_msgs.msg.PolygonObject]) -> None: ...

class AddShapes_Response(Message):
    """nav2_msgs/srv/AddShapes_Response

    bool success
    """
    def __init__(self, *, success: bool = ..., check_fields: bool = ...) -> None: ...
    success: bool

class AddShapes_Event(Message):
    """nav2_msgs/srv/AddShapes_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[nav2_msgs.srv.AddShapes_Request] = ..., response: Collection[nav2_msgs.srv.AddShapes_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[nav2_msgs.srv.AddShapes_Request]: ...
    @request.setter
    def request(self, value: Collection[nav2_msgs.srv.AddShapes_Request]) -> None: ...
    @property
    def response(self) -> list[nav2_msgs.srv.AddShapes_Response]: ...
    @response.setter
    def response(self, value: Collection[nav2_msgs.srv.AddShapes_Response]) -> None: ...

class AddShapes(Service):
    Request: TypeAlias = AddShapes_Request
    Response: TypeAlias = AddShapes_Response
    Event: TypeAlias = AddShapes_Event

class ClearCostmapAroundPose_Request(Message):
    """nav2_msgs/srv/ClearCostmapAroundPose_Request

    geometry_msgs/PoseStamped pose
    float64 reset_distance
    string[] plugins
    """
    def __init__(self, *, pose: geometry_msgs.msg.PoseStamped = ..., reset_distance: float = ..., plugins: Collection[str] = ..., check_fields: bool = ...) -> None: ...
    pose: geometry_msgs.msg.PoseStamped
    reset_distance: float
    @property
    def plugins(self) -> list[str]: ...
    @plugins.setter
    def plugins(self, value: Collection[str]) -> None: ...

class ClearCostmapAroundPose_Response(Message):
    """nav2_msgs/srv/ClearCostmapAroundPose_Response

    bool success
    """
    def __init__(self, *, success: bool = ..., check_fields: bool = ...) -> None: ...
    success: bool

class ClearCostmapAroundPose_Event(Message):
    """nav2_msgs/srv/ClearCostmapAroundPose_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[nav2_msgs.srv.ClearCostmapAroundPose_Request] = ..., response: Collection[nav2_msgs.srv.ClearCostmapAroundPose_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[nav2_msgs.srv.ClearCostmapAroundPose_Request]: ...
    @request.setter
    def request(self, value: Collection[nav2_msgs.srv.ClearCostmapAroundPose_Request]) -> None: ...
    @property
    def response(self) -> list[nav2_msgs.srv.ClearCostmapAroundPose_Response]: ...
    @response.setter
    def response(self, value: Collection[nav2_msgs.srv.ClearCostmapAroundPose_Response]) -> None: ...

class ClearCostmapAroundPose(Service):
    Request: TypeAlias = ClearCostmapAroundPose_Request
    Response: TypeAlias = ClearCostmapAroundPose_Response
    Event: TypeAlias = ClearCostmapAroundPose_Event

class ClearCostmapAroundRobot_Request(Message):
    """nav2_msgs/srv/ClearCostmapAroundRobot_Request

    # Forgets the obstacles near the robot.

    float32 reset_distance  # m
    string[] plugins
    """
    def __init__(self, *, reset_distance: float = ..., plugins: Collection[str] = ..., check_fields: bool = ...) -> None: ...
    reset_distance: float
    @property
    def plugins(self) -> list[str]: ...
    @plugins.setter
    def plugins(self, value: Collection[str]) -> None: ...

class ClearCostmapAroundRobot_Response(Message):
    """nav2_msgs/srv/ClearCostmapAroundRobot_Response

    bool success
    """
    def __init__(self, *, success: bool = ..., check_fields: bool = ...) -> None: ...
    success: bool

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
    string[] plugins
    """
    def __init__(self, *, reset_distance: float = ..., plugins: Collection[str] = ..., check_fields: bool = ...) -> None: ...
    reset_distance: float
    @property
    def plugins(self) -> list[str]: ...
    @plugins.setter
    def plugins(self, value: Collection[str]) -> None: ...

class ClearCostmapExceptRegion_Response(Message):
    """nav2_msgs/srv/ClearCostmapExceptRegion_Response

    bool success
    """
    def __init__(self, *, success: bool = ..., check_fields: bool = ...) -> None: ...
    success: bool

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

    string[] plugins
    """
    def __init__(self, *, plugins: Collection[str] = ..., check_fields: bool = ...) -> None: ...
    @property
    def plugins(self) -> list[str]: ...
    @plugins.setter
    def plugins(self, value: Collection[str]) -> None: ...

class ClearEntireCostmap_Response(Message):
    """nav2_msgs/srv/ClearEntireCostmap_Response

    bool success
    """
    def __init__(self, *, success: bool = ..., check_fields: bool = ...) -> None: ...
    success: bool

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

class GetShapes_Request(Message):
    """nav2_msgs/srv/GetShapes_Request"""
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class GetShapes_Response(Message):
    """nav2_msgs/srv/GetShapes_Response

    CircleObject[] circles
    PolygonObject[] polygons
    """
    def __init__(self, *, circles: Collection[nav2_msgs.msg.CircleObject] = ..., polygons: Collection[nav2_msgs.msg.PolygonObject] = ..., check_fields: bool = ...) -> None: ...
    @property
    def circles(self) -> list[nav2_msgs.msg.CircleObject]: ...
    @circles.setter
    def circles(self, value: Collection[nav2_msgs.msg.CircleObject]) -> None: ...
    @property
    def polygons(self) -> list[nav2_msgs.msg.PolygonObject]: ...
    @polygons.setter
    def polygons(self, value: Collection[nav2_msgs.msg.PolygonObject]) -> None: ...

class GetShapes_Event(Message):
    """nav2_msgs/srv/GetShapes_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[nav2_msgs.srv.GetShapes_Request] = ..., response: Collection[nav2_msgs.srv.GetShapes_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[nav2_msgs.srv.GetShapes_Request]: ...
    @request.setter
    def request(self, value: Collection[nav2_msgs.srv.GetShapes_Request]) -> None: ...
    @property
    def response(self) -> list[nav2_msgs.srv.GetShapes_Response]: ...
    @response.setter
    def response(self, value: Collection[nav2_msgs.srv.GetShapes_Response]) -> None: ...

class GetShapes(Service):
    Request: TypeAlias = GetShapes_Request
    Response: TypeAlias = GetShapes_Response
    Event: TypeAlias = GetShapes_Event

class IsPathValid_Request(Message):
    """nav2_msgs/srv/IsPathValid_Request

    # Asks whether a path is free.

    nav_msgs/Path path
    uint8 max_cost 254
    bool consider_unknown_as_obstacle false
    string layer_name ""
    string footprint ""
    bool stop_at_first_collision true
    float64 max_lookahead_distance -1.0
    """
    def __init__(self, *, path: nav_msgs.msg.Path = ..., max_cost: int = ..., consider_unknown_as_obstacle: bool = ..., layer_name: str = ..., footprint: str = ..., stop_at_first_collision: bool = ..., max_lookahead_distance: float = ..., check_fields: bool = ...) -> None: ...
    path: nav_msgs.msg.Path
    max_cost: int
    consider_unknown_as_obstacle: bool
    layer_name: str
    footprint: str
    stop_at_first_collision: bool
    max_lookahead_distance: float

class IsPathValid_Response(Message):
    """nav2_msgs/srv/IsPathValid_Response

    bool success
    bool is_valid
    int32[] invalid_pose_indices
    """
    def __init__(self, *, success: bool = ..., is_valid: bool = ..., invalid_pose_indices: Collection[int] = ..., check_fields: bool = ...) -> None: ...
    success: bool
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

    uint8 STARTUP=0
    uint8 PAUSE=1
    uint8 RESUME=2
    uint8 RESET=3
    uint8 SHUTDOWN=4
    uint8 CONFIGURE=5
    uint8 CLEANUP=6
    uint8 command
    """
    STARTUP: Final = 0
    PAUSE: Final = 1
    RESUME: Final = 2
    RESET: Final = 3
    SHUTDOWN: Final = 4
    CONFIGURE: Final = 5
    CLEANUP: Final = 6
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

class RemoveExclusionZone_Request(Message):
    """nav2_msgs/srv/RemoveExclusionZone_Request

    string zone_name
    bool remove_all false
    """
    def __init__(self, *, zone_name: str = ..., remove_all: bool = ..., check_fields: bool = ...) -> None: ...
    zone_name: str
    remove_all: bool

class RemoveExclusionZone_Response(Message):
    """nav2_msgs/srv/RemoveExclusionZone_Response

    bool success
    string message
    """
    def __init__(self, *, success: bool = ..., message: str = ..., check_fields: bool = ...) -> None: ...
    success: bool
    message: str

class RemoveExclusionZone_Event(Message):
    """nav2_msgs/srv/RemoveExclusionZone_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[nav2_msgs.srv.RemoveExclusionZone_Request] = ..., response: Collection[nav2_msgs.srv.RemoveExclusionZone_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[nav2_msgs.srv.RemoveExclusionZone_Request]: ...
    @request.setter
    def request(self, value: Collection[nav2_msgs.srv.RemoveExclusionZone_Request]) -> None: ...
    @property
    def response(self) -> list[nav2_msgs.srv.RemoveExclusionZone_Response]: ...
    @response.setter
    def response(self, value: Collection[nav2_msgs.srv.RemoveExclusionZone_Response]) -> None: ...

class RemoveExclusionZone(Service):
    Request: TypeAlias = RemoveExclusionZone_Request
    Response: TypeAlias = RemoveExclusionZone_Response
    Event: TypeAlias = RemoveExclusionZone_Event

class RemoveShapes_Request(Message):
    """nav2_msgs/srv/RemoveShapes_Request

    bool all_objects
    unique_identifier_msgs/UUID[] uuids
    """
    def __init__(self, *, all_objects: bool = ..., uuids: Collection[unique_identifier_msgs.msg.UUID] = ..., check_fields: bool = ...) -> None: ...
    all_objects: bool
    @property
    def uuids(self) -> list[unique_identifier_msgs.msg.UUID]: ...
    @uuids.setter
    def uuids(self, value: Collection[unique_identifier_msgs.msg.UUID]) -> None: ...

class RemoveShapes_Response(Message):
    """nav2_msgs/srv/RemoveShapes_Response

    bool success
    """
    def __init__(self, *, success: bool = ..., check_fields: bool = ...) -> None: ...
    success: bool

class RemoveShapes_Event(Message):
    """nav2_msgs/srv/RemoveShapes_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[nav2_msgs.srv.RemoveShapes_Request] = ..., response: Collection[nav2_msgs.srv.RemoveShapes_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[nav2_msgs.srv.RemoveShapes_Request]: ...
    @request.setter
    def request(self, value: Collection[nav2_msgs.srv.RemoveShapes_Request]) -> None: ...
    @property
    def response(self) -> list[nav2_msgs.srv.RemoveShapes_Response]: ...
    @response.setter
    def response(self, value: Collection[nav2_msgs.srv.RemoveShapes_Response]) -> None: ...

class RemoveShapes(Service):
    Request: TypeAlias = RemoveShapes_Request
    Response: TypeAlias = RemoveShapes_Response
    Event: TypeAlias = RemoveShapes_Event

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
