# Written by python -m zbot.interfaces.stubs; do not edit.
from array import array
from collections.abc import Collection
from typing import Final, TypeAlias

import numpy
from numpy.typing import NDArray

import builtin_interfaces.msg
import geometry_msgs.msg
import nav2_msgs.msg
import std_msgs.msg
import unique_identifier_msgs.msg
from zbot.interfaces import Action, Message, Service

class BehaviorTreeLog(Message):
    """nav2_msgs/msg/BehaviorTreeLog

    # What has changed in a behaviour tree.

    builtin_interfaces/Time timestamp
    BehaviorTreeStatusChange[] event_log
    """
    def __init__(self, *, timestamp: builtin_interfaces.msg.Time = ..., event_log: Collection[nav2_msgs.msg.BehaviorTreeStatusChange] = ..., check_fields: bool = ...) -> None: ...
    timestamp: builtin_interfaces.msg.Time
    @property
    def event_log(self) -> list[nav2_msgs.msg.BehaviorTreeStatusChange]: ...
    @event_log.setter
    def event_log(self, value: Collection[nav2_msgs.msg.BehaviorTreeStatusChange]) -> None: ...

class BehaviorTreeStatusChange(Message):
    """nav2_msgs/msg/BehaviorTreeStatusChange

    # A node of a behaviour tree has another state now.

    builtin_interfaces/Time timestamp
    string node_name
    uint16 uid
    string previous_status  # IDLE, RUNNING, SUCCESS or FAILURE
    string current_status
    """
    def __init__(self, *, timestamp: builtin_interfaces.msg.Time = ..., node_name: str = ..., uid: int = ..., previous_status: str = ..., current_status: str = ..., check_fields: bool = ...) -> None: ...
    timestamp: builtin_interfaces.msg.Time
    node_name: str
    uid: int
    previous_status: str
    current_status: str

class CircleObject(Message):
    """nav2_msgs/msg/CircleObject

    std_msgs/Header header
    unique_identifier_msgs/UUID uuid
    geometry_msgs/Point32 center
    float32 radius
    bool fill
    int8 value
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., uuid: unique_identifier_msgs.msg.UUID = ..., center: geometry_msgs.msg.Point32 = ..., radius: float = ..., fill: bool = ..., value: int = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    uuid: unique_identifier_msgs.msg.UUID
    center: geometry_msgs.msg.Point32
    radius: float
    fill: bool
    value: int

class CollisionDetectorState(Message):
    """nav2_msgs/msg/CollisionDetectorState

    # In which of a robot's areas something is.

    string[] polygons
    bool[] detections  # one for each of them
    """
    def __init__(self, *, polygons: Collection[str] = ..., detections: Collection[bool] = ..., check_fields: bool = ...) -> None: ...
    @property
    def polygons(self) -> list[str]: ...
    @polygons.setter
    def polygons(self, value: Collection[str]) -> None: ...
    @property
    def detections(self) -> list[bool]: ...
    @detections.setter
    def detections(self, value: Collection[bool]) -> None: ...

class CollisionMonitorState(Message):
    """nav2_msgs/msg/CollisionMonitorState

    # What a robot's guard against collisions does at the moment, and why.

    uint8 DO_NOTHING=0
    uint8 STOP=1
    uint8 SLOWDOWN=2
    uint8 APPROACH=3
    uint8 LIMIT=4
    uint8 action_type
    string polygon_name  # which of its areas something is in
    """
    DO_NOTHING: Final = 0
    STOP: Final = 1
    SLOWDOWN: Final = 2
    APPROACH: Final = 3
    LIMIT: Final = 4
    def __init__(self, *, action_type: int = ..., polygon_name: str = ..., check_fields: bool = ...) -> None: ...
    action_type: int
    polygon_name: str

class Costmap(Message):
    """nav2_msgs/msg/Costmap

    # What it costs to be at each place, 0 to 255, row by row.

    std_msgs/Header header
    CostmapMetaData metadata
    uint8[] data
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., metadata: nav2_msgs.msg.CostmapMetaData = ..., data: Collection[int] = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    metadata: nav2_msgs.msg.CostmapMetaData
    @property
    def data(self) -> array[int]: ...
    @data.setter
    def data(self, value: Collection[int]) -> None: ...

class CostmapFilterInfo(Message):
    """nav2_msgs/msg/CostmapFilterInfo

    # How a mask of a map is to be read: base + multiplier * cell.

    std_msgs/Header header
    uint8 type
    string filter_mask_topic
    float32 base
    float32 multiplier
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., type: int = ..., filter_mask_topic: str = ..., base: float = ..., multiplier: float = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    type: int
    filter_mask_topic: str
    base: float
    multiplier: float

class CostmapMetaData(Message):
    """nav2_msgs/msg/CostmapMetaData

    # Where a map of costs lies, and how fine it is.

    builtin_interfaces/Time map_load_time
    builtin_interfaces/Time update_time
    string layer
    float32 resolution  # m per cell
    uint32 size_x       # cells
    uint32 size_y       # cells
    geometry_msgs/Pose origin  # of the first cell
    """
    def __init__(self, *, map_load_time: builtin_interfaces.msg.Time = ..., update_time: builtin_interfaces.msg.Time = ..., layer: str = ..., resolution: float = ..., size_x: int = ..., size_y: int = ..., origin: geometry_msgs.msg.Pose = ..., check_fields: bool = ...) -> None: ...
    map_load_time: builtin_interfaces.msg.Time
    update_time: builtin_interfaces.msg.Time
    layer: str
    resolution: float
    size_x: int
    size_y: int
    origin: geometry_msgs.msg.Pose

class CostmapUpdate(Message):
    """nav2_msgs/msg/CostmapUpdate

    # A rectangle of a map of costs that has changed.

    std_msgs/Header header
    uint32 x  # cells
    uint32 y
    uint32 size_x
    uint32 size_y
    uint8[] data  # row by row
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., x: int = ..., y: int = ..., size_x: int = ..., size_y: int = ..., data: Collection[int] = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    x: int
    y: int
    size_x: int
    size_y: int
    @property
    def data(self) -> array[int]: ...
    @data.setter
    def data(self, value: Collection[int]) -> None: ...

class CriticsStats(Message):
    """nav2_msgs/msg/CriticsStats

    builtin_interfaces/Time stamp
    string[] critics
    bool[] changed
    float32[] costs_sum
    """
    def __init__(self, *, stamp: builtin_interfaces.msg.Time = ..., critics: Collection[str] = ..., changed: Collection[bool] = ..., costs_sum: Collection[float] = ..., check_fields: bool = ...) -> None: ...
    stamp: builtin_interfaces.msg.Time
    @property
    def critics(self) -> list[str]: ...
    @critics.setter
    def critics(self, value: Collection[str]) -> None: ...
    @property
    def changed(self) -> list[bool]: ...
    @changed.setter
    def changed(self, value: Collection[bool]) -> None: ...
    @property
    def costs_sum(self) -> array[float]: ...
    @costs_sum.setter
    def costs_sum(self, value: Collection[float]) -> None: ...

class EdgeCost(Message):
    """nav2_msgs/msg/EdgeCost

    # What a way between two places costs from now on.

    uint16 edgeid
    float32 cost
    """
    def __init__(self, *, edgeid: int = ..., cost: float = ..., check_fields: bool = ...) -> None: ...
    edgeid: int
    cost: float

class ExclusionZoneDescription(Message):
    """nav2_msgs/msg/ExclusionZoneDescription

    string zone_name
    string type
    string frame_id
    geometry_msgs/Point32[] points
    float64 radius 0.0
    float64 min_height -1.7976931348623158e+308
    float64 max_height 1.7976931348623158e+308
    bool enabled true
    bool visualize false
    float64 frame_hold_timeout 0.0
    """
    def __init__(self, *, zone_name: str = ..., type: str = ..., frame_id: str = ..., points: Collection[geometry_msgs.msg.Point32] = ..., radius: float = ..., min_height: float = ..., max_height: float = ..., enabled: bool = ..., visualize: bool = ..., frame_hold_timeout: float = ..., check_fields: bool = ...) -> None: ...
    zone_name: str
    type: str
    frame_id: str
    @property
    def points(self) -> list[geometry_msgs.msg.Point32]: ...
    @points.setter
    def points(self, value: Collection[geometry_msgs.msg.Point32]) -> None: ...
    radius: float
    min_height: float
    max_height: float
    enabled: bool
    visualize: bool
    frame_hold_timeout: float

class Particle(Message):
    """nav2_msgs/msg/Particle

    # One guess of where the robot is.

    geometry_msgs/Pose pose
    float64 weight
    """
    def __init__(self, *, pose: geometry_msgs.msg.Pose = ..., weight: float = ..., check_fields: bool = ...) -> None: ...
    pose: geometry_msgs.msg.Pose
    weight: float

class ParticleCloud(Message):
    """nav2_msgs/msg/ParticleCloud

    # All guesses of where the robot is.

    std_msgs/Header header
    Particle[] particles
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., particles: Collection[nav2_msgs.msg.Particle] = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    @property
    def particles(self) -> list[nav2_msgs.msg.Particle]: ...
    @particles.setter
    def particles(self, value: Collection[nav2_msgs.msg.Particle]) -> None: ...

class PolygonObject(Message):
    """nav2_msgs/msg/PolygonObject

    std_msgs/Header header
    unique_identifier_msgs/UUID uuid
    geometry_msgs/Point32[] points
    bool closed
    int8 value
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., uuid: unique_identifier_msgs.msg.UUID = ..., points: Collection[geometry_msgs.msg.Point32] = ..., closed: bool = ..., value: int = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    uuid: unique_identifier_msgs.msg.UUID
    @property
    def points(self) -> list[geometry_msgs.msg.Point32]: ...
    @points.setter
    def points(self, value: Collection[geometry_msgs.msg.Point32]) -> None: ...
    closed: bool
    value: int

class Route(Message):
    """nav2_msgs/msg/Route

    # A way through a graph of places.

    std_msgs/Header header
    float32 route_cost
    RouteNode[] nodes  # in order
    RouteEdge[] edges  # from each node to the next
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., route_cost: float = ..., nodes: Collection[nav2_msgs.msg.RouteNode] = ..., edges: Collection[nav2_msgs.msg.RouteEdge] = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    route_cost: float
    @property
    def nodes(self) -> list[nav2_msgs.msg.RouteNode]: ...
    @nodes.setter
    def nodes(self, value: Collection[nav2_msgs.msg.RouteNode]) -> None: ...
    @property
    def edges(self) -> list[nav2_msgs.msg.RouteEdge]: ...
    @edges.setter
    def edges(self, value: Collection[nav2_msgs.msg.RouteEdge]) -> None: ...

class RouteEdge(Message):
    """nav2_msgs/msg/RouteEdge

    # A way between two places of a graph.

    uint16 edgeid
    geometry_msgs/Point start
    geometry_msgs/Point end
    """
    def __init__(self, *, edgeid: int = ..., start: geometry_msgs.msg.Point = ..., end: geometry_msgs.msg.Point = ..., check_fields: bool = ...) -> None: ...
    edgeid: int
    start: geometry_msgs.msg.Point
    end: geometry_msgs.msg.Point

class RouteNode(Message):
    """nav2_msgs/msg/RouteNode

    # A place in a graph of places.

    uint16 nodeid
    geometry_msgs/Point position
    """
    def __init__(self, *, nodeid: int = ..., position: geometry_msgs.msg.Point = ..., check_fields: bool = ...) -> None: ...
    nodeid: int
    position: geometry_msgs.msg.Point

class SpeedLimit(Message):
    """nav2_msgs/msg/SpeedLimit

    # How fast a robot may drive from now on.

    std_msgs/Header header
    bool percentage      # of its own top speed; else m/s
    float64 speed_limit  # 0: no limit
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., percentage: bool = ..., speed_limit: float = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    percentage: bool
    speed_limit: float

class TrackingFeedback(Message):
    """nav2_msgs/msg/TrackingFeedback

    std_msgs/Header header
    float32 position_tracking_error
    float32 heading_tracking_error
    uint32 current_path_index
    geometry_msgs/PoseStamped robot_pose
    float32 distance_to_goal
    float32 speed
    float32 remaining_path_length
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., position_tracking_error: float = ..., heading_tracking_error: float = ..., current_path_index: int = ..., robot_pose: geometry_msgs.msg.PoseStamped = ..., distance_to_goal: float = ..., speed: float = ..., remaining_path_length: float = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    position_tracking_error: float
    heading_tracking_error: float
    current_path_index: int
    robot_pose: geometry_msgs.msg.PoseStamped
    distance_to_goal: float
    speed: float
    remaining_path_length: float

class VoxelGrid(Message):
    """nav2_msgs/msg/VoxelGrid

    # A space of little cubes, each free, taken or unknown.

    std_msgs/Header header
    uint32[] data  # one column of cubes in each
    geometry_msgs/Point32 origin
    geometry_msgs/Vector3 resolutions  # m, the sides of a cube
    uint32 size_x
    uint32 size_y
    uint32 size_z
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., data: Collection[int] = ..., origin: geometry_msgs.msg.Point32 = ..., resolutions: geometry_msgs.msg.Vector3 = ..., size_x: int = ..., size_y: int = ..., size_z: int = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    @property
    def data(self) -> array[int]: ...
    @data.setter
    def data(self, value: Collection[int]) -> None: ...
    origin: geometry_msgs.msg.Point32
    resolutions: geometry_msgs.msg.Vector3
    size_x: int
    size_y: int
    size_z: int

class WaypointStatus(Message):
    """nav2_msgs/msg/WaypointStatus

    uint8 PENDING=0
    uint8 COMPLETED=1
    uint8 SKIPPED=2
    uint8 FAILED=3
    uint8 waypoint_status
    uint32 waypoint_index
    geometry_msgs/PoseStamped waypoint_pose
    uint16 error_code
    string error_msg
    """
    PENDING: Final = 0
    COMPLETED: Final = 1
    SKIPPED: Final = 2
    FAILED: Final = 3
    def __init__(self, *, waypoint_status: int = ..., waypoint_index: int = ..., waypoint_pose: geometry_msgs.msg.PoseStamped = ..., error_code: int = ..., error_msg: str = ..., check_fields: bool = ...) -> None: ...
    waypoint_status: int
    waypoint_index: int
    waypoint_pose: geometry_msgs.msg.PoseStamped
    error_code: int
    error_msg: str
