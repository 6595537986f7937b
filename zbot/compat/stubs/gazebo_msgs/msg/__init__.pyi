# Written by python -m zbot.interfaces.stubs; do not edit.
from array import array
from collections.abc import Collection
from typing import Final, TypeAlias

import numpy
from numpy.typing import NDArray

import gazebo_msgs.msg
import geometry_msgs.msg
import std_msgs.msg
from zbot.interfaces import Action, Message, Service

class ContactState(Message):
    """gazebo_msgs/msg/ContactState

    string info
    string collision1_name
    string collision2_name
    geometry_msgs/Wrench[] wrenches
    geometry_msgs/Wrench total_wrench
    geometry_msgs/Vector3[] contact_positions
    geometry_msgs/Vector3[] contact_normals
    float64[] depths
    """
    def __init__(self, *, info: str = ..., collision1_name: str = ..., collision2_name: str = ..., wrenches: Collection[geometry_msgs.msg.Wrench] = ..., total_wrench: geometry_msgs.msg.Wrench = ..., contact_positions: Collection[geometry_msgs.msg.Vector3] = ..., contact_normals: Collection[geometry_msgs.msg.Vector3] = ..., depths: Collection[float] = ..., check_fields: bool = ...) -> None: ...
    info: str
    collision1_name: str
    collision2_name: str
    @property
    def wrenches(self) -> list[geometry_msgs.msg.Wrench]: ...
    @wrenches.setter
    def wrenches(self, value: Collection[geometry_msgs.msg.Wrench]) -> None: ...
    total_wrench: geometry_msgs.msg.Wrench
    @property
    def contact_positions(self) -> list[geometry_msgs.msg.Vector3]: ...
    @contact_positions.setter
    def contact_positions(self, value: Collection[geometry_msgs.msg.Vector3]) -> None: ...
    @property
    def contact_normals(self) -> list[geometry_msgs.msg.Vector3]: ...
    @contact_normals.setter
    def contact_normals(self, value: Collection[geometry_msgs.msg.Vector3]) -> None: ...
    @property
    def depths(self) -> array[float]: ...
    @depths.setter
    def depths(self, value: Collection[float]) -> None: ...

class ContactsState(Message):
    """gazebo_msgs/msg/ContactsState

    std_msgs/Header header
    gazebo_msgs/ContactState[] states
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., states: Collection[gazebo_msgs.msg.ContactState] = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    @property
    def states(self) -> list[gazebo_msgs.msg.ContactState]: ...
    @states.setter
    def states(self, value: Collection[gazebo_msgs.msg.ContactState]) -> None: ...

class EntityState(Message):
    """gazebo_msgs/msg/EntityState

    string name
    geometry_msgs/Pose pose
    geometry_msgs/Twist twist
    string reference_frame
    """
    def __init__(self, *, name: str = ..., pose: geometry_msgs.msg.Pose = ..., twist: geometry_msgs.msg.Twist = ..., reference_frame: str = ..., check_fields: bool = ...) -> None: ...
    name: str
    pose: geometry_msgs.msg.Pose
    twist: geometry_msgs.msg.Twist
    reference_frame: str

class LinkState(Message):
    """gazebo_msgs/msg/LinkState

    string link_name
    geometry_msgs/Pose pose
    geometry_msgs/Twist twist
    string reference_frame
    """
    def __init__(self, *, link_name: str = ..., pose: geometry_msgs.msg.Pose = ..., twist: geometry_msgs.msg.Twist = ..., reference_frame: str = ..., check_fields: bool = ...) -> None: ...
    link_name: str
    pose: geometry_msgs.msg.Pose
    twist: geometry_msgs.msg.Twist
    reference_frame: str

class LinkStates(Message):
    """gazebo_msgs/msg/LinkStates

    string[] name
    geometry_msgs/Pose[] pose
    geometry_msgs/Twist[] twist
    """
    def __init__(self, *, name: Collection[str] = ..., pose: Collection[geometry_msgs.msg.Pose] = ..., twist: Collection[geometry_msgs.msg.Twist] = ..., check_fields: bool = ...) -> None: ...
    @property
    def name(self) -> list[str]: ...
    @name.setter
    def name(self, value: Collection[str]) -> None: ...
    @property
    def pose(self) -> list[geometry_msgs.msg.Pose]: ...
    @pose.setter
    def pose(self, value: Collection[geometry_msgs.msg.Pose]) -> None: ...
    @property
    def twist(self) -> list[geometry_msgs.msg.Twist]: ...
    @twist.setter
    def twist(self, value: Collection[geometry_msgs.msg.Twist]) -> None: ...

class ModelState(Message):
    """gazebo_msgs/msg/ModelState

    string model_name
    geometry_msgs/Pose pose
    geometry_msgs/Twist twist
    string reference_frame
    """
    def __init__(self, *, model_name: str = ..., pose: geometry_msgs.msg.Pose = ..., twist: geometry_msgs.msg.Twist = ..., reference_frame: str = ..., check_fields: bool = ...) -> None: ...
    model_name: str
    pose: geometry_msgs.msg.Pose
    twist: geometry_msgs.msg.Twist
    reference_frame: str

class ModelStates(Message):
    """gazebo_msgs/msg/ModelStates

    string[] name
    geometry_msgs/Pose[] pose
    geometry_msgs/Twist[] twist
    """
    def __init__(self, *, name: Collection[str] = ..., pose: Collection[geometry_msgs.msg.Pose] = ..., twist: Collection[geometry_msgs.msg.Twist] = ..., check_fields: bool = ...) -> None: ...
    @property
    def name(self) -> list[str]: ...
    @name.setter
    def name(self, value: Collection[str]) -> None: ...
    @property
    def pose(self) -> list[geometry_msgs.msg.Pose]: ...
    @pose.setter
    def pose(self, value: Collection[geometry_msgs.msg.Pose]) -> None: ...
    @property
    def twist(self) -> list[geometry_msgs.msg.Twist]: ...
    @twist.setter
    def twist(self, value: Collection[geometry_msgs.msg.Twist]) -> None: ...

class ODEJointProperties(Message):
    """gazebo_msgs/msg/ODEJointProperties

    float64[] damping
    float64[] hi_stop
    float64[] lo_stop
    float64[] erp
    float64[] cfm
    float64[] stop_erp
    float64[] stop_cfm
    float64[] fudge_factor
    float64[] fmax
    float64[] vel
    """
    def __init__(self, *, damping: Collection[float] = ..., hi_stop: Collection[float] = ..., lo_stop: Collection[float] = ..., erp: Collection[float] = ..., cfm: Collection[float] = ..., stop_erp: Collection[float] = ..., stop_cfm: Collection[float] = ..., fudge_factor: Collection[float] = ..., fmax: Collection[float] = ..., vel: Collection[float] = ..., check_fields: bool = ...) -> None: ...
    @property
    def damping(self) -> array[float]: ...
    @damping.setter
    def damping(self, value: Collection[float]) -> None: ...
    @property
    def hi_stop(self) -> array[float]: ...
    @hi_stop.setter
    def hi_stop(self, value: Collection[float]) -> None: ...
    @property
    def lo_stop(self) -> array[float]: ...
    @lo_stop.setter
    def lo_stop(self, value: Collection[float]) -> None: ...
    @property
    def erp(self) -> array[float]: ...
    @erp.setter
    def erp(self, value: Collection[float]) -> None: ...
    @property
    def cfm(self) -> array[float]: ...
    @cfm.setter
    def cfm(self, value: Collection[float]) -> None: ...
    @property
    def stop_erp(self) -> array[float]: ...
    @stop_erp.setter
    def stop_erp(self, value: Collection[float]) -> None: ...
    @property
    def stop_cfm(self) -> array[float]: ...
    @stop_cfm.setter
    def stop_cfm(self, value: Collection[float]) -> None: ...
    @property
    def fudge_factor(self) -> array[float]: ...
    @fudge_factor.setter
    def fudge_factor(self, value: Collection[float]) -> None: ...
    @property
    def fmax(self) -> array[float]: ...
    @fmax.setter
    def fmax(self, value: Collection[float]) -> None: ...
    @property
    def vel(self) -> array[float]: ...
    @vel.setter
    def vel(self, value: Collection[float]) -> None: ...

class ODEPhysics(Message):
    """gazebo_msgs/msg/ODEPhysics

    bool auto_disable_bodies
    uint32 sor_pgs_precon_iters
    uint32 sor_pgs_iters
    float64 sor_pgs_w
    float64 sor_pgs_rms_error_tol
    float64 contact_surface_layer
    float64 contact_max_correcting_vel
    float64 cfm
    float64 erp
    uint32 max_contacts
    """
    def __init__(self, *, auto_disable_bodies: bool = ..., sor_pgs_precon_iters: int = ..., sor_pgs_iters: int = ..., sor_pgs_w: float = ..., sor_pgs_rms_error_tol: float = ..., contact_surface_layer: float = ..., contact_max_correcting_vel: float = ..., cfm: float = ..., erp: float = ..., max_contacts: int = ..., check_fields: bool = ...) -> None: ...
    auto_disable_bodies: bool
    sor_pgs_precon_iters: int
    sor_pgs_iters: int
    sor_pgs_w: float
    sor_pgs_rms_error_tol: float
    contact_surface_layer: float
    contact_max_correcting_vel: float
    cfm: float
    erp: float
    max_contacts: int

class PerformanceMetrics(Message):
    """gazebo_msgs/msg/PerformanceMetrics

    std_msgs/Header header
    float64 real_time_factor
    gazebo_msgs/SensorPerformanceMetric[] sensors
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., real_time_factor: float = ..., sensors: Collection[gazebo_msgs.msg.SensorPerformanceMetric] = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    real_time_factor: float
    @property
    def sensors(self) -> list[gazebo_msgs.msg.SensorPerformanceMetric]: ...
    @sensors.setter
    def sensors(self, value: Collection[gazebo_msgs.msg.SensorPerformanceMetric]) -> None: ...

class SensorPerformanceMetric(Message):
    """gazebo_msgs/msg/SensorPerformanceMetric

    string name
    float64 sim_update_rate
    float64 real_update_rate
    float64 fps
    """
    def __init__(self, *, name: str = ..., sim_update_rate: float = ..., real_update_rate: float = ..., fps: float = ..., check_fields: bool = ...) -> None: ...
    name: str
    sim_update_rate: float
    real_update_rate: float
    fps: float

class WheelSlip(Message):
    """gazebo_msgs/msg/WheelSlip

    string[] name
    float64[] lateral_slip
    float64[] longitudinal_slip
    """
    def __init__(self, *, name: Collection[str] = ..., lateral_slip: Collection[float] = ..., longitudinal_slip: Collection[float] = ..., check_fields: bool = ...) -> None: ...
    @property
    def name(self) -> list[str]: ...
    @name.setter
    def name(self, value: Collection[str]) -> None: ...
    @property
    def lateral_slip(self) -> array[float]: ...
    @lateral_slip.setter
    def lateral_slip(self, value: Collection[float]) -> None: ...
    @property
    def longitudinal_slip(self) -> array[float]: ...
    @longitudinal_slip.setter
    def longitudinal_slip(self, value: Collection[float]) -> None: ...

class WorldState(Message):
    """gazebo_msgs/msg/WorldState

    std_msgs/Header header
    string[] name
    geometry_msgs/Pose[] pose
    geometry_msgs/Twist[] twist
    geometry_msgs/Wrench[] wrench
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., name: Collection[str] = ..., pose: Collection[geometry_msgs.msg.Pose] = ..., twist: Collection[geometry_msgs.msg.Twist] = ..., wrench: Collection[geometry_msgs.msg.Wrench] = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    @property
    def name(self) -> list[str]: ...
    @name.setter
    def name(self, value: Collection[str]) -> None: ...
    @property
    def pose(self) -> list[geometry_msgs.msg.Pose]: ...
    @pose.setter
    def pose(self, value: Collection[geometry_msgs.msg.Pose]) -> None: ...
    @property
    def twist(self) -> list[geometry_msgs.msg.Twist]: ...
    @twist.setter
    def twist(self, value: Collection[geometry_msgs.msg.Twist]) -> None: ...
    @property
    def wrench(self) -> list[geometry_msgs.msg.Wrench]: ...
    @wrench.setter
    def wrench(self, value: Collection[geometry_msgs.msg.Wrench]) -> None: ...
