# Written by python -m zbot.interfaces.stubs; do not edit.
from array import array
from collections.abc import Collection
from typing import Final, TypeAlias

import numpy
from numpy.typing import NDArray

import geometry_msgs.msg
import simulation_interfaces.msg
import std_msgs.msg
from zbot.interfaces import Action, Message, Service

class Bounds(Message):
    """simulation_interfaces/msg/Bounds

    uint8 TYPE_EMPTY=0
    uint8 TYPE_BOX=1
    uint8 TYPE_CONVEX_HULL=2
    uint8 TYPE_SPHERE=3
    uint8 type
    geometry_msgs/Vector3[] points
    """
    TYPE_EMPTY: Final = 0
    TYPE_BOX: Final = 1
    TYPE_CONVEX_HULL: Final = 2
    TYPE_SPHERE: Final = 3
    def __init__(self, *, type: int = ..., points: Collection[geometry_msgs.msg.Vector3] = ..., check_fields: bool = ...) -> None: ...
    type: int
    @property
    def points(self) -> list[geometry_msgs.msg.Vector3]: ...
    @points.setter
    def points(self, value: Collection[geometry_msgs.msg.Vector3]) -> None: ...

class EntityCategory(Message):
    """simulation_interfaces/msg/EntityCategory

    uint8 CATEGORY_OBJECT=0
    uint8 CATEGORY_ROBOT=1
    uint8 CATEGORY_HUMAN=2
    uint8 CATEGORY_DYNAMIC_OBJECT=4
    uint8 CATEGORY_STATIC_OBJECT=5
    uint8 category
    """
    CATEGORY_OBJECT: Final = 0
    CATEGORY_ROBOT: Final = 1
    CATEGORY_HUMAN: Final = 2
    CATEGORY_DYNAMIC_OBJECT: Final = 4
    CATEGORY_STATIC_OBJECT: Final = 5
    def __init__(self, *, category: int = ..., check_fields: bool = ...) -> None: ...
    category: int

class EntityFilters(Message):
    """simulation_interfaces/msg/EntityFilters

    string filter
    EntityCategory[] categories
    TagsFilter tags
    Bounds bounds
    """
    def __init__(self, *, filter: str = ..., categories: Collection[simulation_interfaces.msg.EntityCategory] = ..., tags: simulation_interfaces.msg.TagsFilter = ..., bounds: simulation_interfaces.msg.Bounds = ..., check_fields: bool = ...) -> None: ...
    filter: str
    @property
    def categories(self) -> list[simulation_interfaces.msg.EntityCategory]: ...
    @categories.setter
    def categories(self, value: Collection[simulation_interfaces.msg.EntityCategory]) -> None: ...
    tags: simulation_interfaces.msg.TagsFilter
    bounds: simulation_interfaces.msg.Bounds

class EntityInfo(Message):
    """simulation_interfaces/msg/EntityInfo

    EntityCategory category
    string description
    string[] tags
    """
    def __init__(self, *, category: simulation_interfaces.msg.EntityCategory = ..., description: str = ..., tags: Collection[str] = ..., check_fields: bool = ...) -> None: ...
    category: simulation_interfaces.msg.EntityCategory
    description: str
    @property
    def tags(self) -> list[str]: ...
    @tags.setter
    def tags(self, value: Collection[str]) -> None: ...

class EntityState(Message):
    """simulation_interfaces/msg/EntityState

    std_msgs/Header header
    geometry_msgs/Pose pose
    geometry_msgs/Twist twist
    geometry_msgs/Accel acceleration
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., pose: geometry_msgs.msg.Pose = ..., twist: geometry_msgs.msg.Twist = ..., acceleration: geometry_msgs.msg.Accel = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    pose: geometry_msgs.msg.Pose
    twist: geometry_msgs.msg.Twist
    acceleration: geometry_msgs.msg.Accel

class NamedPose(Message):
    """simulation_interfaces/msg/NamedPose

    string name
    string description
    string[] tags
    geometry_msgs/Pose pose
    """
    def __init__(self, *, name: str = ..., description: str = ..., tags: Collection[str] = ..., pose: geometry_msgs.msg.Pose = ..., check_fields: bool = ...) -> None: ...
    name: str
    description: str
    @property
    def tags(self) -> list[str]: ...
    @tags.setter
    def tags(self, value: Collection[str]) -> None: ...
    pose: geometry_msgs.msg.Pose

class Resource(Message):
    """simulation_interfaces/msg/Resource

    string uri
    string resource_string
    """
    def __init__(self, *, uri: str = ..., resource_string: str = ..., check_fields: bool = ...) -> None: ...
    uri: str
    resource_string: str

class Result(Message):
    """simulation_interfaces/msg/Result

    uint8 RESULT_FEATURE_UNSUPPORTED=0
    uint8 RESULT_OK=1
    uint8 RESULT_NOT_FOUND=2
    uint8 RESULT_INCORRECT_STATE=3
    uint8 RESULT_OPERATION_FAILED=4
    uint8 result
    string error_message
    """
    RESULT_FEATURE_UNSUPPORTED: Final = 0
    RESULT_OK: Final = 1
    RESULT_NOT_FOUND: Final = 2
    RESULT_INCORRECT_STATE: Final = 3
    RESULT_OPERATION_FAILED: Final = 4
    def __init__(self, *, result: int = ..., error_message: str = ..., check_fields: bool = ...) -> None: ...
    result: int
    error_message: str

class SimulationState(Message):
    """simulation_interfaces/msg/SimulationState

    uint8 STATE_STOPPED=0
    uint8 STATE_PLAYING=1
    uint8 STATE_PAUSED=2
    uint8 STATE_QUITTING=3
    uint8 STATE_NO_WORLD=4
    uint8 STATE_LOADING_WORLD=5
    uint8 state
    """
    STATE_STOPPED: Final = 0
    STATE_PLAYING: Final = 1
    STATE_PAUSED: Final = 2
    STATE_QUITTING: Final = 3
    STATE_NO_WORLD: Final = 4
    STATE_LOADING_WORLD: Final = 5
    def __init__(self, *, state: int = ..., check_fields: bool = ...) -> None: ...
    state: int

class SimulatorFeatures(Message):
    """simulation_interfaces/msg/SimulatorFeatures

    uint8 SPAWNING=0
    uint8 DELETING=1
    uint8 NAMED_POSES=2
    uint8 POSE_BOUNDS=3
    uint8 ENTITY_TAGS=4
    uint8 ENTITY_BOUNDS=5
    uint8 ENTITY_BOUNDS_BOX=6
    uint8 ENTITY_BOUNDS_CONVEX=7
    uint8 ENTITY_CATEGORIES=8
    uint8 SPAWNING_RESOURCE_STRING=9
    uint8 ENTITY_STATE_GETTING=10
    uint8 ENTITY_STATE_SETTING=11
    uint8 ENTITY_INFO_GETTING=12
    uint8 ENTITY_INFO_SETTING=13
    uint8 SPAWNABLES=14
    uint8 SIMULATION_RESET=20
    uint8 SIMULATION_RESET_TIME=21
    uint8 SIMULATION_RESET_STATE=22
    uint8 SIMULATION_RESET_SPAWNED=23
    uint8 SIMULATION_STATE_GETTING=24
    uint8 SIMULATION_STATE_SETTING=25
    uint8 SIMULATION_STATE_PAUSE=26
    uint8 STEP_SIMULATION_SINGLE=31
    uint8 STEP_SIMULATION_MULTIPLE=32
    uint8 STEP_SIMULATION_ACTION=33
    uint8 WORLD_LOADING=40
    uint8 WORLD_RESOURCE_STRING=41
    uint8 WORLD_TAGS=42
    uint8 WORLD_UNLOADING=43
    uint8 WORLD_INFO_GETTING=44
    uint8 AVAILABLE_WORLDS=45
    uint8 SPAWNING_ENTITIES=50
    uint16[] features
    string[] spawn_formats
    string custom_info
    """
    SPAWNING: Final = 0
    DELETING: Final = 1
    NAMED_POSES: Final = 2
    POSE_BOUNDS: Final = 3
    ENTITY_TAGS: Final = 4
    ENTITY_BOUNDS: Final = 5
    ENTITY_BOUNDS_BOX: Final = 6
    ENTITY_BOUNDS_CONVEX: Final = 7
    ENTITY_CATEGORIES: Final = 8
    SPAWNING_RESOURCE_STRING: Final = 9
    ENTITY_STATE_GETTING: Final = 10
    ENTITY_STATE_SETTING: Final = 11
    ENTITY_INFO_GETTING: Final = 12
    ENTITY_INFO_SETTING: Final = 13
    SPAWNABLES: Final = 14
    SIMULATION_RESET: Final = 20
    SIMULATION_RESET_TIME: Final = 21
    SIMULATION_RESET_STATE: Final = 22
    SIMULATION_RESET_SPAWNED: Final = 23
    SIMULATION_STATE_GETTING: Final = 24
    SIMULATION_STATE_SETTING: Final = 25
    SIMULATION_STATE_PAUSE: Final = 26
    STEP_SIMULATION_SINGLE: Final = 31
    STEP_SIMULATION_MULTIPLE: Final = 32
    STEP_SIMULATION_ACTION: Final = 33
    WORLD_LOADING: Final = 40
    WORLD_RESOURCE_STRING: Final = 41
    WORLD_TAGS: Final = 42
    WORLD_UNLOADING: Final = 43
    WORLD_INFO_GETTING: Final = 44
    AVAILABLE_WORLDS: Final = 45
    SPAWNING_ENTITIES: Final = 50
    def __init__(self, *, features: Collection[int] = ..., spawn_formats: Collection[str] = ..., custom_info: str = ..., check_fields: bool = ...) -> None: ...
    @property
    def features(self) -> array[int]: ...
    @features.setter
    def features(self, value: Collection[int]) -> None: ...
    @property
    def spawn_formats(self) -> list[str]: ...
    @spawn_formats.setter
    def spawn_formats(self, value: Collection[str]) -> None: ...
    custom_info: str

class SpawnEntity(Message):
    """simulation_interfaces/msg/SpawnEntity

    string name
    bool allow_renaming
    Resource entity_resource
    string entity_namespace
    geometry_msgs/PoseStamped initial_pose
    """
    def __init__(self, *, name: str = ..., allow_renaming: bool = ..., entity_resource: simulation_interfaces.msg.Resource = ..., entity_namespace: str = ..., initial_pose: geometry_msgs.msg.PoseStamped = ..., check_fields: bool = ...) -> None: ...
    name: str
    allow_renaming: bool
    entity_resource: simulation_interfaces.msg.Resource
    entity_namespace: str
    initial_pose: geometry_msgs.msg.PoseStamped

class SpawnResult(Message):
    """simulation_interfaces/msg/SpawnResult

    uint8 NAME_NOT_UNIQUE=101
    uint8 NAME_INVALID=102
    uint8 UNSUPPORTED_FORMAT=103
    uint8 NO_RESOURCE=104
    uint8 NAMESPACE_INVALID=105
    uint8 RESOURCE_PARSE_ERROR=106
    uint8 MISSING_ASSETS=107
    uint8 UNSUPPORTED_ASSETS=108
    uint8 INVALID_POSE=109
    Result result
    string entity_name
    """
    NAME_NOT_UNIQUE: Final = 101
    NAME_INVALID: Final = 102
    UNSUPPORTED_FORMAT: Final = 103
    NO_RESOURCE: Final = 104
    NAMESPACE_INVALID: Final = 105
    RESOURCE_PARSE_ERROR: Final = 106
    MISSING_ASSETS: Final = 107
    UNSUPPORTED_ASSETS: Final = 108
    INVALID_POSE: Final = 109
    def __init__(self, *, result: simulation_interfaces.msg.Result = ..., entity_name: str = ..., check_fields: bool = ...) -> None: ...
    result: simulation_interfaces.msg.Result
    entity_name: str

class Spawnable(Message):
    """simulation_interfaces/msg/Spawnable

    Resource entity_resource
    string description
    Bounds spawn_bounds
    """
    def __init__(self, *, entity_resource: simulation_interfaces.msg.Resource = ..., description: str = ..., spawn_bounds: simulation_interfaces.msg.Bounds = ..., check_fields: bool = ...) -> None: ...
    entity_resource: simulation_interfaces.msg.Resource
    description: str
    spawn_bounds: simulation_interfaces.msg.Bounds

class TagsFilter(Message):
    """simulation_interfaces/msg/TagsFilter

    string[] tags
    uint8 FILTER_MODE_ANY=0
    uint8 FILTER_MODE_ALL=1
    uint8 filter_mode
    """
    FILTER_MODE_ANY: Final = 0
    FILTER_MODE_ALL: Final = 1
    def __init__(self, *, tags: Collection[str] = ..., filter_mode: int = ..., check_fields: bool = ...) -> None: ...
    @property
    def tags(self) -> list[str]: ...
    @tags.setter
    def tags(self, value: Collection[str]) -> None: ...
    filter_mode: int

class WorldResource(Message):
    """simulation_interfaces/msg/WorldResource

    string name
    Resource world_resource
    string description
    string[] tags
    """
    def __init__(self, *, name: str = ..., world_resource: simulation_interfaces.msg.Resource = ..., description: str = ..., tags: Collection[str] = ..., check_fields: bool = ...) -> None: ...
    name: str
    world_resource: simulation_interfaces.msg.Resource
    description: str
    @property
    def tags(self) -> list[str]: ...
    @tags.setter
    def tags(self, value: Collection[str]) -> None: ...
