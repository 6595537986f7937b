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
from zbot.interfaces import Action, Message, Service

class BehaviorTreeLog(Message):
    """nav2_msgs/msg/BehaviorTreeLog

    # What has changed in a behaviour tree.

    builtin_interfaces/Time timestamp
    BehaviorTreeStatusChange[] event_log
    """
    def __init__(self, *, timestamp: builtin_interfaces.msg.Time = ..., event_log: Collection[nav2_msgs.msg.BehaviorTreeStatusChange] = ...) -> None: ...
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
    def __init__(self, *, timestamp: builtin_interfaces.msg.Time = ..., node_name: str = ..., uid: int = ..., previous_status: str = ..., current_status: str = ...) -> None: ...
    timestamp: builtin_interfaces.msg.Time
    node_name: str
    uid: int
    previous_status: str
    current_status: str

class Costmap(Message):
    """nav2_msgs/msg/Costmap

    # What it costs to be at each place, 0 to 255, row by row.

    std_msgs/Header header
    CostmapMetaData metadata
    uint8[] data
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., metadata: nav2_msgs.msg.CostmapMetaData = ..., data: Collection[int] = ...) -> None: ...
    header: std_msgs.msg.Header
    metadata: nav2_msgs.msg.CostmapMetaData
    @property
    def data(self) -> array[int]: ...
    @data.setter
    def data(self, value: Collection[int]) -> None: ...

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
    def __init__(self, *, map_load_time: builtin_interfaces.msg.Time = ..., update_time: builtin_interfaces.msg.Time = ..., layer: str = ..., resolution: float = ..., size_x: int = ..., size_y: int = ..., origin: geometry_msgs.msg.Pose = ...) -> None: ...
    map_load_time: builtin_interfaces.msg.Time
    update_time: builtin_interfaces.msg.Time
    layer: str
    resolution: float
    size_x: int
    size_y: int
    origin: geometry_msgs.msg.Pose

class MissedWaypoint(Message):
    """nav2_msgs/msg/MissedWaypoint

    # A place of a tour that was not reached, and why.

    uint32 index
    geometry_msgs/PoseStamped goal
    uint16 error_code
    """
    def __init__(self, *, index: int = ..., goal: geometry_msgs.msg.PoseStamped = ..., error_code: int = ...) -> None: ...
    index: int
    goal: geometry_msgs.msg.PoseStamped
    error_code: int

class Particle(Message):
    """nav2_msgs/msg/Particle

    # One guess of where the robot is.

    geometry_msgs/Pose pose
    float64 weight
    """
    def __init__(self, *, pose: geometry_msgs.msg.Pose = ..., weight: float = ...) -> None: ...
    pose: geometry_msgs.msg.Pose
    weight: float

class ParticleCloud(Message):
    """nav2_msgs/msg/ParticleCloud

    # All guesses of where the robot is.

    std_msgs/Header header
    Particle[] particles
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., particles: Collection[nav2_msgs.msg.Particle] = ...) -> None: ...
    header: std_msgs.msg.Header
    @property
    def particles(self) -> list[nav2_msgs.msg.Particle]: ...
    @particles.setter
    def particles(self, value: Collection[nav2_msgs.msg.Particle]) -> None: ...

class SpeedLimit(Message):
    """nav2_msgs/msg/SpeedLimit

    # How fast a robot may drive from now on.

    std_msgs/Header header
    bool percentage      # of its own top speed; else m/s
    float64 speed_limit  # 0: no limit
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., percentage: bool = ..., speed_limit: float = ...) -> None: ...
    header: std_msgs.msg.Header
    percentage: bool
    speed_limit: float
