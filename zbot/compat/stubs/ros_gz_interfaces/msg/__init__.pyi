# Written by python -m zbot.interfaces.stubs; do not edit.
from array import array
from collections.abc import Collection
from typing import Final, TypeAlias

import numpy
from numpy.typing import NDArray

import builtin_interfaces.msg
import geometry_msgs.msg
import rcl_interfaces.msg
import ros_gz_interfaces.msg
import std_msgs.msg
from zbot.interfaces import Action, Message, Service

class Altimeter(Message):
    """ros_gz_interfaces/msg/Altimeter

    std_msgs/Header header
    float64 vertical_position
    float64 vertical_velocity
    float64 vertical_reference
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., vertical_position: float = ..., vertical_velocity: float = ..., vertical_reference: float = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    vertical_position: float
    vertical_velocity: float
    vertical_reference: float

class Contact(Message):
    """ros_gz_interfaces/msg/Contact

    ros_gz_interfaces/Entity collision1
    ros_gz_interfaces/Entity collision2
    geometry_msgs/Vector3[] positions
    geometry_msgs/Vector3[] normals
    float64[] depths
    ros_gz_interfaces/JointWrench[] wrenches
    """
    def __init__(self, *, collision1: ros_gz_interfaces.msg.Entity = ..., collision2: ros_gz_interfaces.msg.Entity = ..., positions: Collection[geometry_msgs.msg.Vector3] = ..., normals: Collection[geometry_msgs.msg.Vector3] = ..., depths: Collection[float] = ..., wrenches: Collection[ros_gz_interfaces.msg.JointWrench] = ..., check_fields: bool = ...) -> None: ...
    collision1: ros_gz_interfaces.msg.Entity
    collision2: ros_gz_interfaces.msg.Entity
    @property
    def positions(self) -> list[geometry_msgs.msg.Vector3]: ...
    @positions.setter
    def positions(self, value: Collection[geometry_msgs.msg.Vector3]) -> None: ...
    @property
    def normals(self) -> list[geometry_msgs.msg.Vector3]: ...
    @normals.setter
    def normals(self, value: Collection[geometry_msgs.msg.Vector3]) -> None: ...
    @property
    def depths(self) -> array[float]: ...
    @depths.setter
    def depths(self, value: Collection[float]) -> None: ...
    @property
    def wrenches(self) -> list[ros_gz_interfaces.msg.JointWrench]: ...
    @wrenches.setter
    def wrenches(self, value: Collection[ros_gz_interfaces.msg.JointWrench]) -> None: ...

class Contacts(Message):
    """ros_gz_interfaces/msg/Contacts

    std_msgs/Header header
    ros_gz_interfaces/Contact[] contacts
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., contacts: Collection[ros_gz_interfaces.msg.Contact] = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    @property
    def contacts(self) -> list[ros_gz_interfaces.msg.Contact]: ...
    @contacts.setter
    def contacts(self, value: Collection[ros_gz_interfaces.msg.Contact]) -> None: ...

class Dataframe(Message):
    """ros_gz_interfaces/msg/Dataframe

    std_msgs/Header header
    string src_address
    string dst_address
    uint8[] data
    float64 rssi
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., src_address: str = ..., dst_address: str = ..., data: Collection[int] = ..., rssi: float = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    src_address: str
    dst_address: str
    @property
    def data(self) -> array[int]: ...
    @data.setter
    def data(self, value: Collection[int]) -> None: ...
    rssi: float

class Entity(Message):
    """ros_gz_interfaces/msg/Entity

    uint8 NONE=0
    uint8 LIGHT=1
    uint8 MODEL=2
    uint8 LINK=3
    uint8 VISUAL=4
    uint8 COLLISION=5
    uint8 SENSOR=6
    uint8 JOINT=7
    uint64 id
    string name
    uint8 type
    """
    NONE: Final = 0
    LIGHT: Final = 1
    MODEL: Final = 2
    LINK: Final = 3
    VISUAL: Final = 4
    COLLISION: Final = 5
    SENSOR: Final = 6
    JOINT: Final = 7
    def __init__(self, *, id: int = ..., name: str = ..., type: int = ..., check_fields: bool = ...) -> None: ...
    id: int
    name: str
    type: int

class EntityFactory(Message):
    """ros_gz_interfaces/msg/EntityFactory

    string name
    bool allow_renaming false
    string sdf
    string sdf_filename
    string clone_name
    geometry_msgs/Pose pose
    string relative_to "world"
    """
    def __init__(self, *, name: str = ..., allow_renaming: bool = ..., sdf: str = ..., sdf_filename: str = ..., clone_name: str = ..., pose: geometry_msgs.msg.Pose = ..., relative_to: str = ..., check_fields: bool = ...) -> None: ...
    name: str
    allow_renaming: bool
    sdf: str
    sdf_filename: str
    clone_name: str
    pose: geometry_msgs.msg.Pose
    relative_to: str

class EntityWrench(Message):
    """ros_gz_interfaces/msg/EntityWrench

    std_msgs/Header header
    ros_gz_interfaces/Entity entity
    geometry_msgs/Wrench wrench
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., entity: ros_gz_interfaces.msg.Entity = ..., wrench: geometry_msgs.msg.Wrench = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    entity: ros_gz_interfaces.msg.Entity
    wrench: geometry_msgs.msg.Wrench

class Float32Array(Message):
    """ros_gz_interfaces/msg/Float32Array

    float32[] data
    """
    def __init__(self, *, data: Collection[float] = ..., check_fields: bool = ...) -> None: ...
    @property
    def data(self) -> array[float]: ...
    @data.setter
    def data(self, value: Collection[float]) -> None: ...

class GuiCamera(Message):
    """ros_gz_interfaces/msg/GuiCamera

    std_msgs/Header header
    string name
    string view_controller
    geometry_msgs/Pose pose
    TrackVisual track
    string projection_type
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., name: str = ..., view_controller: str = ..., pose: geometry_msgs.msg.Pose = ..., track: ros_gz_interfaces.msg.TrackVisual = ..., projection_type: str = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    name: str
    view_controller: str
    pose: geometry_msgs.msg.Pose
    track: ros_gz_interfaces.msg.TrackVisual
    projection_type: str

class JointWrench(Message):
    """ros_gz_interfaces/msg/JointWrench

    std_msgs/Header header
    std_msgs/String body_1_name
    std_msgs/UInt32 body_1_id
    std_msgs/String body_2_name
    std_msgs/UInt32 body_2_id
    geometry_msgs/Wrench body_1_wrench
    geometry_msgs/Wrench body_2_wrench
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., body_1_name: std_msgs.msg.String = ..., body_1_id: std_msgs.msg.UInt32 = ..., body_2_name: std_msgs.msg.String = ..., body_2_id: std_msgs.msg.UInt32 = ..., body_1_wrench: geometry_msgs.msg.Wrench = ..., body_2_wrench: geometry_msgs.msg.Wrench = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    body_1_name: std_msgs.msg.String
    body_1_id: std_msgs.msg.UInt32
    body_2_name: std_msgs.msg.String
    body_2_id: std_msgs.msg.UInt32
    body_1_wrench: geometry_msgs.msg.Wrench
    body_2_wrench: geometry_msgs.msg.Wrench

class Light(Message):
    """ros_gz_interfaces/msg/Light

    std_msgs/Header header
    string name
    uint8 POINT=0
    uint8 SPOT=1
    uint8 DIRECTIONAL=2
    uint8 type
    geometry_msgs/Pose pose
    std_msgs/ColorRGBA diffuse
    std_msgs/ColorRGBA specular
    float32 attenuation_constant
    float32 attenuation_linear
    float32 attenuation_quadratic
    geometry_msgs/Vector3 direction
    float32 range
    bool cast_shadows
    float32 spot_inner_angle
    float32 spot_outer_angle
    float32 spot_falloff
    uint32 id
    uint32 parent_id
    float32 intensity
    """
    POINT: Final = 0
    SPOT: Final = 1
    DIRECTIONAL: Final = 2
    def __init__(self, *, header: std_msgs.msg.Header = ..., name: str = ..., type: int = ..., pose: geometry_msgs.msg.Pose = ..., diffuse: std_msgs.msg.ColorRGBA = ..., specular: std_msgs.msg.ColorRGBA = ..., attenuation_constant: float = ..., attenuation_linear: float = ..., attenuation_quadratic: float = ..., direction: geometry_msgs.msg.Vector3 = ..., range: float = ..., cast_shadows: bool = ..., spot_inner_angle: float = ..., spot_outer_angle: float = ..., spot_falloff: float = ..., id: int = ..., parent_id: int = ..., intensity: float = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    name: str
    type: int
    pose: geometry_msgs.msg.Pose
    diffuse: std_msgs.msg.ColorRGBA
    specular: std_msgs.msg.ColorRGBA
    attenuation_constant: float
    attenuation_linear: float
    attenuation_quadratic: float
    direction: geometry_msgs.msg.Vector3
    range: float
    cast_shadows: bool
    spot_inner_angle: float
    spot_outer_angle: float
    spot_falloff: float
    id: int
    parent_id: int
    intensity: float

class MaterialColor(Message):
    """ros_gz_interfaces/msg/MaterialColor

    uint8 FIRST=0
    uint8 ALL=1
    std_msgs/Header header
    ros_gz_interfaces/Entity entity
    std_msgs/ColorRGBA ambient
    std_msgs/ColorRGBA diffuse
    std_msgs/ColorRGBA specular
    std_msgs/ColorRGBA emissive
    float64 shininess
    uint8 entity_match
    """
    FIRST: Final = 0
    ALL: Final = 1
    def __init__(self, *, header: std_msgs.msg.Header = ..., entity: ros_gz_interfaces.msg.Entity = ..., ambient: std_msgs.msg.ColorRGBA = ..., diffuse: std_msgs.msg.ColorRGBA = ..., specular: std_msgs.msg.ColorRGBA = ..., emissive: std_msgs.msg.ColorRGBA = ..., shininess: float = ..., entity_match: int = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    entity: ros_gz_interfaces.msg.Entity
    ambient: std_msgs.msg.ColorRGBA
    diffuse: std_msgs.msg.ColorRGBA
    specular: std_msgs.msg.ColorRGBA
    emissive: std_msgs.msg.ColorRGBA
    shininess: float
    entity_match: int

class ParamVec(Message):
    """ros_gz_interfaces/msg/ParamVec

    std_msgs/Header header
    rcl_interfaces/Parameter[] params
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., params: Collection[rcl_interfaces.msg.Parameter] = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    @property
    def params(self) -> list[rcl_interfaces.msg.Parameter]: ...
    @params.setter
    def params(self, value: Collection[rcl_interfaces.msg.Parameter]) -> None: ...

class SensorNoise(Message):
    """ros_gz_interfaces/msg/SensorNoise

    uint8 NONE=0
    uint8 GAUSSIAN=2
    uint8 GAUSSIAN_QUANTIZED=3
    std_msgs/Header header
    uint8 type
    float64 mean
    float64 stddev
    float64 bias_mean
    float64 bias_stddev
    float64 precision
    float64 dynamic_bias_stddev
    float64 dynamic_bias_correlation_time
    """
    NONE: Final = 0
    GAUSSIAN: Final = 2
    GAUSSIAN_QUANTIZED: Final = 3
    def __init__(self, *, header: std_msgs.msg.Header = ..., type: int = ..., mean: float = ..., stddev: float = ..., bias_mean: float = ..., bias_stddev: float = ..., precision: float = ..., dynamic_bias_stddev: float = ..., dynamic_bias_correlation_time: float = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    type: int
    mean: float
    stddev: float
    bias_mean: float
    bias_stddev: float
    precision: float
    dynamic_bias_stddev: float
    dynamic_bias_correlation_time: float

class StringVec(Message):
    """ros_gz_interfaces/msg/StringVec

    std_msgs/Header header
    string[] data
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., data: Collection[str] = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    @property
    def data(self) -> list[str]: ...
    @data.setter
    def data(self, value: Collection[str]) -> None: ...

class TrackVisual(Message):
    """ros_gz_interfaces/msg/TrackVisual

    std_msgs/Header header
    string name
    uint32 id
    bool inherit_orientation
    float64 min_dist
    float64 max_dist
    bool is_static
    bool use_model_frame
    geometry_msgs/Vector3 xyz
    bool inherit_yaw
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., name: str = ..., id: int = ..., inherit_orientation: bool = ..., min_dist: float = ..., max_dist: float = ..., is_static: bool = ..., use_model_frame: bool = ..., xyz: geometry_msgs.msg.Vector3 = ..., inherit_yaw: bool = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    name: str
    id: int
    inherit_orientation: bool
    min_dist: float
    max_dist: float
    is_static: bool
    use_model_frame: bool
    xyz: geometry_msgs.msg.Vector3
    inherit_yaw: bool

class VideoRecord(Message):
    """ros_gz_interfaces/msg/VideoRecord

    std_msgs/Header header
    bool start
    bool stop
    string format
    string save_filename
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., start: bool = ..., stop: bool = ..., format: str = ..., save_filename: str = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    start: bool
    stop: bool
    format: str
    save_filename: str

class WorldControl(Message):
    """ros_gz_interfaces/msg/WorldControl

    bool pause
    bool step
    uint32 multi_step 0
    ros_gz_interfaces/WorldReset reset
    uint32 seed
    builtin_interfaces/Time run_to_sim_time
    """
    def __init__(self, *, pause: bool = ..., step: bool = ..., multi_step: int = ..., reset: ros_gz_interfaces.msg.WorldReset = ..., seed: int = ..., run_to_sim_time: builtin_interfaces.msg.Time = ..., check_fields: bool = ...) -> None: ...
    pause: bool
    step: bool
    multi_step: int
    reset: ros_gz_interfaces.msg.WorldReset
    seed: int
    run_to_sim_time: builtin_interfaces.msg.Time

class WorldReset(Message):
    """ros_gz_interfaces/msg/WorldReset

    bool all false
    bool time_only false
    bool model_only false
    """
    def __init__(self, *, all: bool = ..., time_only: bool = ..., model_only: bool = ..., check_fields: bool = ...) -> None: ...
    all: bool
    time_only: bool
    model_only: bool
