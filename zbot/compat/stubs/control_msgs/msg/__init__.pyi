# Written by python -m zbot.interfaces.stubs; do not edit.
from array import array
from collections.abc import Collection
from typing import Final, TypeAlias

import numpy
from numpy.typing import NDArray

import builtin_interfaces.msg
import control_msgs.msg
import diagnostic_msgs.msg
import geometry_msgs.msg
import sensor_msgs.msg
import std_msgs.msg
import trajectory_msgs.msg
from zbot.interfaces import Action, Message, Service

class AdmittanceControllerState(Message):
    """control_msgs/msg/AdmittanceControllerState

    # Parameters and state of an admittance controller, which yields to forces.

    std_msgs/Float64MultiArray mass  # per axis of the end effector
    std_msgs/Float64MultiArray damping
    std_msgs/Float64MultiArray stiffness
    geometry_msgs/Quaternion rot_base_control
    geometry_msgs/TransformStamped ref_trans_base_ft
    std_msgs/Int8MultiArray selected_axes  # axes that yield
    std_msgs/String ft_sensor_frame  # frame of the force and torque sensor
    geometry_msgs/TransformStamped admittance_position
    geometry_msgs/TwistStamped admittance_acceleration
    geometry_msgs/TwistStamped admittance_velocity
    geometry_msgs/WrenchStamped wrench_base
    sensor_msgs/JointState joint_state
    """
    def __init__(self, *, mass: std_msgs.msg.Float64MultiArray = ..., damping: std_msgs.msg.Float64MultiArray = ..., stiffness: std_msgs.msg.Float64MultiArray = ..., rot_base_control: geometry_msgs.msg.Quaternion = ..., ref_trans_base_ft: geometry_msgs.msg.TransformStamped = ..., selected_axes: std_msgs.msg.Int8MultiArray = ..., ft_sensor_frame: std_msgs.msg.String = ..., admittance_position: geometry_msgs.msg.TransformStamped = ..., admittance_acceleration: geometry_msgs.msg.TwistStamped = ..., admittance_velocity: geometry_msgs.msg.TwistStamped = ..., wrench_base: geometry_msgs.msg.WrenchStamped = ..., joint_state: sensor_msgs.msg.JointState = ..., check_fields: bool = ...) -> None: ...
    mass: std_msgs.msg.Float64MultiArray
    damping: std_msgs.msg.Float64MultiArray
    stiffness: std_msgs.msg.Float64MultiArray
    rot_base_control: geometry_msgs.msg.Quaternion
    ref_trans_base_ft: geometry_msgs.msg.TransformStamped
    selected_axes: std_msgs.msg.Int8MultiArray
    ft_sensor_frame: std_msgs.msg.String
    admittance_position: geometry_msgs.msg.TransformStamped
    admittance_acceleration: geometry_msgs.msg.TwistStamped
    admittance_velocity: geometry_msgs.msg.TwistStamped
    wrench_base: geometry_msgs.msg.WrenchStamped
    joint_state: sensor_msgs.msg.JointState

class BatteryStateArray(Message):
    """control_msgs/msg/BatteryStateArray

    # States of several batteries.

    sensor_msgs/BatteryState[] battery_states
    """
    def __init__(self, *, battery_states: Collection[sensor_msgs.msg.BatteryState] = ..., check_fields: bool = ...) -> None: ...
    @property
    def battery_states(self) -> list[sensor_msgs.msg.BatteryState]: ...
    @battery_states.setter
    def battery_states(self, value: Collection[sensor_msgs.msg.BatteryState]) -> None: ...

class CANopenState(Message):
    """control_msgs/msg/CANopenState

    # State of one device on a CANopen bus.

    uint8 node_id
    uint8 nmt_state  # one of NMT_...
    uint8 dsp_402_state  # one of DSP402_..., for drives
    uint32 last_emcy_code  # code of the last emergency message
    uint8 NMT_INITIALISING=0
    uint8 NMT_PRE_OPERATIONAL=127
    uint8 NMT_OPERATIONAL=5
    uint8 NMT_STOPPED=4
    uint8 DSP402_NOT_READY_TO_SWITCH_ON=0
    uint8 DSP402_SWITCH_ON_DISABLED=1
    uint8 DSP402_READY_TO_SWITCH_ON=2
    uint8 DSP402_SWITCHED_ON=3
    uint8 DSP402_OPERATION_ENABLED=4
    uint8 DSP402_QUICK_STOP_ACTIVE=5
    uint8 DSP402_FAULT_REACTION_ACTIVE=6
    uint8 DSP402_FAULT=7
    """
    NMT_INITIALISING: Final = 0
    NMT_PRE_OPERATIONAL: Final = 127
    NMT_OPERATIONAL: Final = 5
    NMT_STOPPED: Final = 4
    DSP402_NOT_READY_TO_SWITCH_ON: Final = 0
    DSP402_SWITCH_ON_DISABLED: Final = 1
    DSP402_READY_TO_SWITCH_ON: Final = 2
    DSP402_SWITCHED_ON: Final = 3
    DSP402_OPERATION_ENABLED: Final = 4
    DSP402_QUICK_STOP_ACTIVE: Final = 5
    DSP402_FAULT_REACTION_ACTIVE: Final = 6
    DSP402_FAULT: Final = 7
    def __init__(self, *, node_id: int = ..., nmt_state: int = ..., dsp_402_state: int = ..., last_emcy_code: int = ..., check_fields: bool = ...) -> None: ...
    node_id: int
    nmt_state: int
    dsp_402_state: int
    last_emcy_code: int

class DynamicInterfaceGroupValues(Message):
    """control_msgs/msg/DynamicInterfaceGroupValues

    # Values of the interfaces of several groups, e.g. groups of GPIO pins.

    std_msgs/Header header
    string[] interface_groups  # names of the groups
    InterfaceValue[] interface_values  # one entry for each group
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., interface_groups: Collection[str] = ..., interface_values: Collection[control_msgs.msg.InterfaceValue] = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    @property
    def interface_groups(self) -> list[str]: ...
    @interface_groups.setter
    def interface_groups(self, value: Collection[str]) -> None: ...
    @property
    def interface_values(self) -> list[control_msgs.msg.InterfaceValue]: ...
    @interface_values.setter
    def interface_values(self, value: Collection[control_msgs.msg.InterfaceValue]) -> None: ...

class DynamicInterfaceValues(Message):
    """control_msgs/msg/DynamicInterfaceValues

    # Values of state interfaces and command interfaces.

    std_msgs/Header header
    InterfaceValue states
    InterfaceValue commands
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., states: control_msgs.msg.InterfaceValue = ..., commands: control_msgs.msg.InterfaceValue = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    states: control_msgs.msg.InterfaceValue
    commands: control_msgs.msg.InterfaceValue

class DynamicJointState(Message):
    """control_msgs/msg/DynamicJointState

    # Whatever values joints have, each by the name of its interface.

    std_msgs/Header header
    string[] joint_names
    InterfaceValue[] interface_values
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., joint_names: Collection[str] = ..., interface_values: Collection[control_msgs.msg.InterfaceValue] = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    @property
    def joint_names(self) -> list[str]: ...
    @joint_names.setter
    def joint_names(self, value: Collection[str]) -> None: ...
    @property
    def interface_values(self) -> list[control_msgs.msg.InterfaceValue]: ...
    @interface_values.setter
    def interface_values(self, value: Collection[control_msgs.msg.InterfaceValue]) -> None: ...

class EtherCATState(Message):
    """control_msgs/msg/EtherCATState

    # State of one device on an EtherCAT bus.

    uint16 slave_position  # position on the bus
    string vendor_id
    string product_code
    uint8 al_state  # one of AL_STATE_...
    bool has_error
    uint16 al_status_code  # reason of an error
    uint8 AL_STATE_INIT=1
    uint8 AL_STATE_PREOP=2
    uint8 AL_STATE_BOOTSTRAP=3
    uint8 AL_STATE_SAFEOP=4
    uint8 AL_STATE_OP=8
    """
    AL_STATE_INIT: Final = 1
    AL_STATE_PREOP: Final = 2
    AL_STATE_BOOTSTRAP: Final = 3
    AL_STATE_SAFEOP: Final = 4
    AL_STATE_OP: Final = 8
    def __init__(self, *, slave_position: int = ..., vendor_id: str = ..., product_code: str = ..., al_state: int = ..., has_error: bool = ..., al_status_code: int = ..., check_fields: bool = ...) -> None: ...
    slave_position: int
    vendor_id: str
    product_code: str
    al_state: int
    has_error: bool
    al_status_code: int

class Float64Values(Message):
    """control_msgs/msg/Float64Values

    # Numbers with a time. The program that sends them says what they mean.

    std_msgs/Header header
    float64[] values
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., values: Collection[float] = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    @property
    def values(self) -> array[float]: ...
    @values.setter
    def values(self, value: Collection[float]) -> None: ...

class GenericHardwareState(Message):
    """control_msgs/msg/GenericHardwareState

    # State of a device, in words that fit all kinds of devices.

    uint8 health_status  # one of HEALTH_...
    uint8[] error_domain  # some of ERROR_NONE to CALIBRATION_REQUIRED
    uint8 operational_mode  # one of MODE_...
    uint8 power_state  # one of POWER_...
    uint8 connectivity_status  # one of CONNECT_... or CONNECTION_SLOW
    string manufacturer
    string model
    string firmware_version
    diagnostic_msgs/KeyValue[] state_details  # anything else
    uint8 HEALTH_UNKNOWN=0
    uint8 HEALTH_OK=1
    uint8 HEALTH_DEGRADED=2
    uint8 HEALTH_WARNING=3
    uint8 HEALTH_ERROR=4
    uint8 HEALTH_FATAL=5
    uint8 ERROR_NONE=0
    uint8 ERROR_UNKNOWN=1
    uint8 ERROR_HW=2
    uint8 ERROR_SW=3
    uint8 ERROR_OVER_TRAVEL=4
    uint8 EMERGENCY_STOP_HW=5
    uint8 EMERGENCY_STOP_SW=6
    uint8 PROTECTIVE_STOP_HW=7
    uint8 PROTECTIVE_STOP_SW=8
    uint8 SAFETY_STOP=9
    uint8 CALIBRATION_REQUIRED=10
    uint8 MODE_UNKNOWN=0
    uint8 MODE_MANUAL=1
    uint8 MODE_AUTO=2
    uint8 MODE_SAFE=3
    uint8 MODE_MAINTENANCE=4
    uint8 MODE_JOG_MANUAL=5
    uint8 MODE_ADMITTANCE=6
    uint8 MODE_MONITORED_STOP=7
    uint8 MODE_HOLD_TO_RUN=8
    uint8 MODE_CARTESIAN_TWIST=9
    uint8 MODE_CARTESIAN_POSE=10
    uint8 MODE_TRAJECTORY_FORWARDING=11
    uint8 MODE_TRAJECTORY_STREAMING=12
    uint8 POWER_UNKNOWN=0
    uint8 POWER_OFF=1
    uint8 POWER_STANDBY=2
    uint8 POWER_ON=3
    uint8 POWER_SLEEP=4
    uint8 POWER_ERROR=5
    uint8 POWER_LEVEL_LOW=6
    uint8 POWER_LEVEL_CRITICAL=7
    uint8 POWER_CHARGING=8
    uint8 POWER_CHARGING_ERROR=9
    uint8 CONNECT_UNKNOWN=0
    uint8 CONNECT_UP=1
    uint8 CONNECT_DOWN=2
    uint8 CONNECT_FAILURE=3
    uint8 CONNECTION_SLOW=4
    """
    HEALTH_UNKNOWN: Final = 0
    HEALTH_OK: Final = 1
    HEALTH_DEGRADED: Final = 2
    HEALTH_WARNING: Final = 3
    HEALTH_ERROR: Final = 4
    HEALTH_FATAL: Final = 5
    ERROR_NONE: Final = 0
    ERROR_UNKNOWN: Final = 1
    ERROR_HW: Final = 2
    ERROR_SW: Final = 3
    ERROR_OVER_TRAVEL: Final = 4
    EMERGENCY_STOP_HW: Final = 5
    EMERGENCY_STOP_SW: Final = 6
    PROTECTIVE_STOP_HW: Final = 7
    PROTECTIVE_STOP_SW: Final = 8
    SAFETY_STOP: Final = 9
    CALIBRATION_REQUIRED: Final = 10
    MODE_UNKNOWN: Final = 0
    MODE_MANUAL: Final = 1
    MODE_AUTO: Final = 2
    MODE_SAFE: Final = 3
    MODE_MAINTENANCE: Final = 4
    MODE_JOG_MANUAL: Final = 5
    MODE_ADMITTANCE: Final = 6
    MODE_MONITORED_STOP: Final = 7
    MODE_HOLD_TO_RUN: Final = 8
    MODE_CARTESIAN_TWIST: Final = 9
    MODE_CARTESIAN_POSE: Final = 10
    MODE_TRAJECTORY_FORWARDING: Final = 11
    MODE_TRAJECTORY_STREAMING: Final = 12
    POWER_UNKNOWN: Final = 0
    POWER_OFF: Final = 1
    POWER_STANDBY: Final = 2
    POWER_ON: Final = 3
    POWER_SLEEP: Final = 4
    POWER_ERROR: Final = 5
    POWER_LEVEL_LOW: Final = 6
    POWER_LEVEL_CRITICAL: Final = 7
    POWER_CHARGING: Final = 8
    POWER_CHARGING_ERROR: Final = 9
    CONNECT_UNKNOWN: Final = 0
    CONNECT_UP: Final = 1
    CONNECT_DOWN: Final = 2
    CONNECT_FAILURE: Final = 3
    CONNECTION_SLOW: Final = 4
    def __init__(self, *, health_status: int = ..., error_domain: Collection[int] = ..., operational_mode: int = ..., power_state: int = ..., connectivity_status: int = ..., manufacturer: str = ..., model: str = ..., firmware_version: str = ..., state_details: Collection[diagnostic_msgs.msg.KeyValue] = ..., check_fields: bool = ...) -> None: ...
    health_status: int
    @property
    def error_domain(self) -> array[int]: ...
    @error_domain.setter
    def error_domain(self, value: Collection[int]) -> None: ...
    operational_mode: int
    power_state: int
    connectivity_status: int
    manufacturer: str
    model: str
    firmware_version: str
    @property
    def state_details(self) -> list[diagnostic_msgs.msg.KeyValue]: ...
    @state_details.setter
    def state_details(self, value: Collection[diagnostic_msgs.msg.KeyValue]) -> None: ...

class GripperCommand(Message):
    """control_msgs/msg/GripperCommand

    # How wide a gripper is to open, and how strongly at most.

    float64 position    # m between the fingers
    float64 max_effort  # N
    """
    def __init__(self, *, position: float = ..., max_effort: float = ..., check_fields: bool = ...) -> None: ...
    position: float
    max_effort: float

class HardwareDeviceDiagnostics(Message):
    """control_msgs/msg/HardwareDeviceDiagnostics

    # Diagnostic values of one device.

    std_msgs/Header header
    string device_id
    diagnostic_msgs/KeyValue[] entries
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., device_id: str = ..., entries: Collection[diagnostic_msgs.msg.KeyValue] = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    device_id: str
    @property
    def entries(self) -> list[diagnostic_msgs.msg.KeyValue]: ...
    @entries.setter
    def entries(self, value: Collection[diagnostic_msgs.msg.KeyValue]) -> None: ...

class HardwareDeviceStatus(Message):
    """control_msgs/msg/HardwareDeviceStatus

    # State of one device, in general and for its bus.

    std_msgs/Header header
    string device_id
    GenericHardwareState[] hardware_status
    CANopenState[] canopen_states
    EtherCATState[] ethercat_states
    VDA5050State[] vda5050_states
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., device_id: str = ..., hardware_status: Collection[control_msgs.msg.GenericHardwareState] = ..., canopen_states: Collection[control_msgs.msg.CANopenState] = ..., ethercat_states: Collection[control_msgs.msg.EtherCATState] = ..., vda5050_states: Collection[control_msgs.msg.VDA5050State] = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    device_id: str
    @property
    def hardware_status(self) -> list[control_msgs.msg.GenericHardwareState]: ...
    @hardware_status.setter
    def hardware_status(self, value: Collection[control_msgs.msg.GenericHardwareState]) -> None: ...
    @property
    def canopen_states(self) -> list[control_msgs.msg.CANopenState]: ...
    @canopen_states.setter
    def canopen_states(self, value: Collection[control_msgs.msg.CANopenState]) -> None: ...
    @property
    def ethercat_states(self) -> list[control_msgs.msg.EtherCATState]: ...
    @ethercat_states.setter
    def ethercat_states(self, value: Collection[control_msgs.msg.EtherCATState]) -> None: ...
    @property
    def vda5050_states(self) -> list[control_msgs.msg.VDA5050State]: ...
    @vda5050_states.setter
    def vda5050_states(self, value: Collection[control_msgs.msg.VDA5050State]) -> None: ...

class HardwareDiagnostics(Message):
    """control_msgs/msg/HardwareDiagnostics

    # Diagnostic values of all devices of a hardware component.

    std_msgs/Header header
    string hardware_id
    HardwareDeviceDiagnostics[] hardware_device_diagnostics
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., hardware_id: str = ..., hardware_device_diagnostics: Collection[control_msgs.msg.HardwareDeviceDiagnostics] = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    hardware_id: str
    @property
    def hardware_device_diagnostics(self) -> list[control_msgs.msg.HardwareDeviceDiagnostics]: ...
    @hardware_device_diagnostics.setter
    def hardware_device_diagnostics(self, value: Collection[control_msgs.msg.HardwareDeviceDiagnostics]) -> None: ...

class HardwareStatus(Message):
    """control_msgs/msg/HardwareStatus

    # States of all devices of a hardware component.

    std_msgs/Header header
    string hardware_id
    HardwareDeviceStatus[] hardware_device_states
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., hardware_id: str = ..., hardware_device_states: Collection[control_msgs.msg.HardwareDeviceStatus] = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    hardware_id: str
    @property
    def hardware_device_states(self) -> list[control_msgs.msg.HardwareDeviceStatus]: ...
    @hardware_device_states.setter
    def hardware_device_states(self, value: Collection[control_msgs.msg.HardwareDeviceStatus]) -> None: ...

class InterfaceValue(Message):
    """control_msgs/msg/InterfaceValue

    # Values of one joint by the names of its interfaces.

    string[] interface_names
    float64[] values
    """
    def __init__(self, *, interface_names: Collection[str] = ..., values: Collection[float] = ..., check_fields: bool = ...) -> None: ...
    @property
    def interface_names(self) -> list[str]: ...
    @interface_names.setter
    def interface_names(self, value: Collection[str]) -> None: ...
    @property
    def values(self) -> array[float]: ...
    @values.setter
    def values(self, value: Collection[float]) -> None: ...

class JointComponentTolerance(Message):
    """control_msgs/msg/JointComponentTolerance

    # How far one part of a joint with several degrees of freedom may be from where it should be.

    uint16 X_AXIS=1
    uint16 Y_AXIS=2
    uint16 Z_AXIS=3
    uint16 TRANSLATION=4  # all axes together
    uint16 ROTATION=5

    string joint_name
    uint16 component
    float64 position
    float64 velocity
    float64 acceleration
    """
    X_AXIS: Final = 1
    Y_AXIS: Final = 2
    Z_AXIS: Final = 3
    TRANSLATION: Final = 4
    ROTATION: Final = 5
    def __init__(self, *, joint_name: str = ..., component: int = ..., position: float = ..., velocity: float = ..., acceleration: float = ..., check_fields: bool = ...) -> None: ...
    joint_name: str
    component: int
    position: float
    velocity: float
    acceleration: float

class JointControllerState(Message):
    """control_msgs/msg/JointControllerState

    # State of the controller of one joint.

    std_msgs/Header header
    float64 set_point  # wanted value
    float64 process_value  # measured value
    float64 process_value_dot  # change of the measured value per second
    float64 error
    float64 time_step  # s
    float64 command
    float64 p  # gains of the PID controller
    float64 i
    float64 d
    float64 i_clamp  # limit of the integral part
    bool antiwindup
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., set_point: float = ..., process_value: float = ..., process_value_dot: float = ..., error: float = ..., time_step: float = ..., command: float = ..., p: float = ..., i: float = ..., d: float = ..., i_clamp: float = ..., antiwindup: bool = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    set_point: float
    process_value: float
    process_value_dot: float
    error: float
    time_step: float
    command: float
    p: float
    i: float
    d: float
    i_clamp: float
    antiwindup: bool

class JointJog(Message):
    """control_msgs/msg/JointJog

    # Moves joints by a little, or at a speed for a while.

    std_msgs/Header header
    string[] joint_names
    float64[] displacements  # rad or m
    float64[] velocities     # rad/s or m/s
    float64 duration         # s
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., joint_names: Collection[str] = ..., displacements: Collection[float] = ..., velocities: Collection[float] = ..., duration: float = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    @property
    def joint_names(self) -> list[str]: ...
    @joint_names.setter
    def joint_names(self, value: Collection[str]) -> None: ...
    @property
    def displacements(self) -> array[float]: ...
    @displacements.setter
    def displacements(self, value: Collection[float]) -> None: ...
    @property
    def velocities(self) -> array[float]: ...
    @velocities.setter
    def velocities(self, value: Collection[float]) -> None: ...
    duration: float

class JointTolerance(Message):
    """control_msgs/msg/JointTolerance

    # How far a joint may be from where it should be; 0: the default, -1: as far as it likes.

    string name
    float64 position      # rad, or m for a sliding joint
    float64 velocity      # rad/s or m/s
    float64 acceleration  # rad/s^2 or m/s^2
    """
    def __init__(self, *, name: str = ..., position: float = ..., velocity: float = ..., acceleration: float = ..., check_fields: bool = ...) -> None: ...
    name: str
    position: float
    velocity: float
    acceleration: float

class JointTrajectoryControllerState(Message):
    """control_msgs/msg/JointTrajectoryControllerState

    # Where joints are, and where their controller wants them.

    std_msgs/Header header
    string[] joint_names
    trajectory_msgs/JointTrajectoryPoint reference  # wanted
    trajectory_msgs/JointTrajectoryPoint feedback  # measured
    trajectory_msgs/JointTrajectoryPoint error
    trajectory_msgs/JointTrajectoryPoint output  # command to the joints
    string[] multi_dof_joint_names
    trajectory_msgs/MultiDOFJointTrajectoryPoint multi_dof_reference
    trajectory_msgs/MultiDOFJointTrajectoryPoint multi_dof_feedback
    trajectory_msgs/MultiDOFJointTrajectoryPoint multi_dof_error
    trajectory_msgs/MultiDOFJointTrajectoryPoint multi_dof_output
    float64 speed_scaling_factor  # 1.0 is the full speed
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., joint_names: Collection[str] = ..., reference: trajectory_msgs.msg.JointTrajectoryPoint = ..., feedback: trajectory_msgs.msg.JointTrajectoryPoint = ..., error: trajectory_msgs.msg.JointTrajectoryPoint = ..., output: trajectory_msgs.msg.JointTrajectoryPoint = ..., multi_dof_joint_names: Collection[str] = ..., multi_dof_reference: trajectory_msgs.msg.MultiDOFJointTrajectoryPoint = ..., multi_dof_feedback: trajectory_msgs.msg.MultiDOFJointTrajectoryPoint = ..., multi_dof_error: trajectory_msgs.msg.MultiDOFJointTrajectoryPoint = ..., multi_dof_output: trajectory_msgs.msg.MultiDOFJointTrajectoryPoint = ..., speed_scaling_factor: float = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    @property
    def joint_names(self) -> list[str]: ...
    @joint_names.setter
    def joint_names(self, value: Collection[str]) -> None: ...
    reference: trajectory_msgs.msg.JointTrajectoryPoint
    feedback: trajectory_msgs.msg.JointTrajectoryPoint
    error: trajectory_msgs.msg.JointTrajectoryPoint
    output: trajectory_msgs.msg.JointTrajectoryPoint
    @property
    def multi_dof_joint_names(self) -> list[str]: ...
    @multi_dof_joint_names.setter
    def multi_dof_joint_names(self, value: Collection[str]) -> None: ...
    multi_dof_reference: trajectory_msgs.msg.MultiDOFJointTrajectoryPoint
    multi_dof_feedback: trajectory_msgs.msg.MultiDOFJointTrajectoryPoint
    multi_dof_error: trajectory_msgs.msg.MultiDOFJointTrajectoryPoint
    multi_dof_output: trajectory_msgs.msg.MultiDOFJointTrajectoryPoint
    speed_scaling_factor: float

class JointWrenchTrajectory(Message):
    """control_msgs/msg/JointWrenchTrajectory

    # Positions and wrenches of joints over time.

    std_msgs/Header header
    string[] joint_names
    control_msgs/JointWrenchTrajectoryPoint[] points
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., joint_names: Collection[str] = ..., points: Collection[control_msgs.msg.JointWrenchTrajectoryPoint] = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    @property
    def joint_names(self) -> list[str]: ...
    @joint_names.setter
    def joint_names(self, value: Collection[str]) -> None: ...
    @property
    def points(self) -> list[control_msgs.msg.JointWrenchTrajectoryPoint]: ...
    @points.setter
    def points(self, value: Collection[control_msgs.msg.JointWrenchTrajectoryPoint]) -> None: ...

class JointWrenchTrajectoryPoint(Message):
    """control_msgs/msg/JointWrenchTrajectoryPoint

    # Positions of joints, and the wrench to apply there.

    trajectory_msgs/JointTrajectoryPoint point
    control_msgs/WrenchFramed wrench
    """
    def __init__(self, *, point: trajectory_msgs.msg.JointTrajectoryPoint = ..., wrench: control_msgs.msg.WrenchFramed = ..., check_fields: bool = ...) -> None: ...
    point: trajectory_msgs.msg.JointTrajectoryPoint
    wrench: control_msgs.msg.WrenchFramed

class Keys(Message):
    """control_msgs/msg/Keys

    # Names with a time.

    std_msgs/Header header
    string[] keys
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., keys: Collection[str] = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    @property
    def keys(self) -> list[str]: ...
    @keys.setter
    def keys(self, value: Collection[str]) -> None: ...

class MecanumDriveControllerState(Message):
    """control_msgs/msg/MecanumDriveControllerState

    # State of the controller of a robot with four mecanum wheels.

    std_msgs/Header header
    float64 front_left_wheel_velocity  # rad/s
    float64 back_left_wheel_velocity  # rad/s
    float64 back_right_wheel_velocity  # rad/s
    float64 front_right_wheel_velocity  # rad/s
    geometry_msgs/Twist reference_velocity
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., front_left_wheel_velocity: float = ..., back_left_wheel_velocity: float = ..., back_right_wheel_velocity: float = ..., front_right_wheel_velocity: float = ..., reference_velocity: geometry_msgs.msg.Twist = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    front_left_wheel_velocity: float
    back_left_wheel_velocity: float
    back_right_wheel_velocity: float
    front_right_wheel_velocity: float
    reference_velocity: geometry_msgs.msg.Twist

class MotionArgument(Message):
    """control_msgs/msg/MotionArgument

    # A named number for a motion, e.g. a speed.

    string name
    float64 value
    """
    def __init__(self, *, name: str = ..., value: float = ..., check_fields: bool = ...) -> None: ...
    name: str
    value: float

class MotionPrimitive(Message):
    """control_msgs/msg/MotionPrimitive

    # One motion: to joint positions, along a line, or along an arc.

    int8 UNKNOWN=-1
    int8 LINEAR_JOINT=0
    int8 LINEAR_CARTESIAN=50
    int8 CIRCULAR_CARTESIAN=51
    int8 type -1
    float64 blend_radius  # m, how early the next motion may begin
    MotionArgument[] additional_arguments
    geometry_msgs/PoseStamped[] poses  # for motions of type LINEAR_CARTESIAN and CIRCULAR_CARTESIAN
    float64[] joint_positions  # for motions of type LINEAR_JOINT
    """
    UNKNOWN: Final = -1
    LINEAR_JOINT: Final = 0
    LINEAR_CARTESIAN: Final = 50
    CIRCULAR_CARTESIAN: Final = 51
    def __init__(self, *, type: int = ..., blend_radius: float = ..., additional_arguments: Collection[control_msgs.msg.MotionArgument] = ..., poses: Collection[geometry_msgs.msg.PoseStamped] = ..., joint_positions: Collection[float] = ..., check_fields: bool = ...) -> None: ...
    type: int
    blend_radius: float
    @property
    def additional_arguments(self) -> list[control_msgs.msg.MotionArgument]: ...
    @additional_arguments.setter
    def additional_arguments(self, value: Collection[control_msgs.msg.MotionArgument]) -> None: ...
    @property
    def poses(self) -> list[geometry_msgs.msg.PoseStamped]: ...
    @poses.setter
    def poses(self, value: Collection[geometry_msgs.msg.PoseStamped]) -> None: ...
    @property
    def joint_positions(self) -> array[float]: ...
    @joint_positions.setter
    def joint_positions(self, value: Collection[float]) -> None: ...

class MotionPrimitiveSequence(Message):
    """control_msgs/msg/MotionPrimitiveSequence

    # Motions to run one after another.

    MotionPrimitive[] motions
    """
    def __init__(self, *, motions: Collection[control_msgs.msg.MotionPrimitive] = ..., check_fields: bool = ...) -> None: ...
    @property
    def motions(self) -> list[control_msgs.msg.MotionPrimitive]: ...
    @motions.setter
    def motions(self, value: Collection[control_msgs.msg.MotionPrimitive]) -> None: ...

class MultiDOFCommand(Message):
    """control_msgs/msg/MultiDOFCommand

    # Commands for several degrees of freedom.

    string[] dof_names
    float64[] values
    float64[] values_dot  # change per second
    """
    def __init__(self, *, dof_names: Collection[str] = ..., values: Collection[float] = ..., values_dot: Collection[float] = ..., check_fields: bool = ...) -> None: ...
    @property
    def dof_names(self) -> list[str]: ...
    @dof_names.setter
    def dof_names(self, value: Collection[str]) -> None: ...
    @property
    def values(self) -> array[float]: ...
    @values.setter
    def values(self, value: Collection[float]) -> None: ...
    @property
    def values_dot(self) -> array[float]: ...
    @values_dot.setter
    def values_dot(self, value: Collection[float]) -> None: ...

class MultiDOFStateStamped(Message):
    """control_msgs/msg/MultiDOFStateStamped

    # States of several degrees of freedom.

    std_msgs/Header header
    SingleDOFState[] dof_states
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., dof_states: Collection[control_msgs.msg.SingleDOFState] = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    @property
    def dof_states(self) -> list[control_msgs.msg.SingleDOFState]: ...
    @dof_states.setter
    def dof_states(self, value: Collection[control_msgs.msg.SingleDOFState]) -> None: ...

class PidState(Message):
    """control_msgs/msg/PidState

    # Values inside a PID controller.

    std_msgs/Header header
    builtin_interfaces/Duration timestep  # time since the last update
    float64 error  # wanted value minus measured value
    float64 error_dot  # change of the error per second
    float64 i_term  # sum of the errors over time, times the gain
    float64 p_gain
    float64 i_gain
    float64 d_gain
    float64 output  # command to the joint
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., timestep: builtin_interfaces.msg.Duration = ..., error: float = ..., error_dot: float = ..., i_term: float = ..., p_gain: float = ..., i_gain: float = ..., d_gain: float = ..., output: float = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    timestep: builtin_interfaces.msg.Duration
    error: float
    error_dot: float
    i_term: float
    p_gain: float
    i_gain: float
    d_gain: float
    output: float

class SingleDOFState(Message):
    """control_msgs/msg/SingleDOFState

    # State of one degree of freedom, such as a joint.

    string name
    float64 reference  # wanted
    float64 feedback  # measured
    float64 feedback_dot  # change of the measured value per second
    float64 error
    float64 error_dot
    float64 time_step  # s
    float64 output
    """
    def __init__(self, *, name: str = ..., reference: float = ..., feedback: float = ..., feedback_dot: float = ..., error: float = ..., error_dot: float = ..., time_step: float = ..., output: float = ..., check_fields: bool = ...) -> None: ...
    name: str
    reference: float
    feedback: float
    feedback_dot: float
    error: float
    error_dot: float
    time_step: float
    output: float

class SingleDOFStateStamped(Message):
    """control_msgs/msg/SingleDOFStateStamped

    # State of one degree of freedom with a time.

    std_msgs/Header header
    SingleDOFState dof_state
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., dof_state: control_msgs.msg.SingleDOFState = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    dof_state: control_msgs.msg.SingleDOFState

class SpeedScalingFactor(Message):
    """control_msgs/msg/SpeedScalingFactor

    # Slows a trajectory down.

    float64 factor  # 1.0 is the full speed
    """
    def __init__(self, *, factor: float = ..., check_fields: bool = ...) -> None: ...
    factor: float

class SteeringControllerCommand(Message):
    """control_msgs/msg/SteeringControllerCommand

    # Drives a robot with a steered wheel.

    std_msgs/Header header
    float64 steering_angle  # rad
    float64 linear_velocity  # m/s
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., steering_angle: float = ..., linear_velocity: float = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    steering_angle: float
    linear_velocity: float

class SteeringControllerStatus(Message):
    """control_msgs/msg/SteeringControllerStatus

    # Wheels of a robot that steers, and the commands to them.

    std_msgs/Header header
    float64[] traction_wheels_position  # rad
    float64[] traction_wheels_velocity  # rad/s
    float64[] steer_positions  # rad
    float64[] traction_command  # rad/s
    float64[] steering_angle_command  # rad
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., traction_wheels_position: Collection[float] = ..., traction_wheels_velocity: Collection[float] = ..., steer_positions: Collection[float] = ..., traction_command: Collection[float] = ..., steering_angle_command: Collection[float] = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    @property
    def traction_wheels_position(self) -> array[float]: ...
    @traction_wheels_position.setter
    def traction_wheels_position(self, value: Collection[float]) -> None: ...
    @property
    def traction_wheels_velocity(self) -> array[float]: ...
    @traction_wheels_velocity.setter
    def traction_wheels_velocity(self, value: Collection[float]) -> None: ...
    @property
    def steer_positions(self) -> array[float]: ...
    @steer_positions.setter
    def steer_positions(self, value: Collection[float]) -> None: ...
    @property
    def traction_command(self) -> array[float]: ...
    @traction_command.setter
    def traction_command(self, value: Collection[float]) -> None: ...
    @property
    def steering_angle_command(self) -> array[float]: ...
    @steering_angle_command.setter
    def steering_angle_command(self, value: Collection[float]) -> None: ...

class VDA5050SafetyState(Message):
    """control_msgs/msg/VDA5050SafetyState

    # Safety state of a driverless vehicle, as VDA 5050 defines it.

    string e_stop  # AUTO_ACK, MANUAL, REMOTE or NONE
    bool field_violation  # something is in the protective field
    string AUTO_ACK="autoAck"
    string MANUAL="manual"
    string REMOTE="remote"
    string NONE="none"
    """
    AUTO_ACK: Final = 'autoAck'
    MANUAL: Final = 'manual'
    REMOTE: Final = 'remote'
    NONE: Final = 'none'
    def __init__(self, *, e_stop: str = ..., field_violation: bool = ..., check_fields: bool = ...) -> None: ...
    e_stop: str
    field_violation: bool

class VDA5050State(Message):
    """control_msgs/msg/VDA5050State

    # State of a driverless vehicle, as VDA 5050 defines it.

    string order_id
    string action_status  # one of ACTION_...
    uint32 last_node_id
    bool driving
    float64 battery_charge  # percent
    string operating_mode  # one of MODE_...
    string error_type
    string error_description
    string ACTION_WAITING="WAITING"
    string ACTION_INITIALIZING="INITIALIZING"
    string ACTION_RUNNING="RUNNING"
    string ACTION_PAUSED="PAUSED"
    string ACTION_FINISHED="FINISHED"
    string ACTION_FAILED="FAILED"
    string MODE_AUTOMATIC="AUTOMATIC"
    string MODE_SEMI_AUTOMATIC="SEMIAUTOMATIC"
    string MODE_MANUAL="MANUAL"
    string MODE_SERVICE="SERVICE"
    string MODE_EMERGENCY="EMERGENCY"
    string MODE_TEACHIN="TEACHIN"
    """
    ACTION_WAITING: Final = 'WAITING'
    ACTION_INITIALIZING: Final = 'INITIALIZING'
    ACTION_RUNNING: Final = 'RUNNING'
    ACTION_PAUSED: Final = 'PAUSED'
    ACTION_FINISHED: Final = 'FINISHED'
    ACTION_FAILED: Final = 'FAILED'
    MODE_AUTOMATIC: Final = 'AUTOMATIC'
    MODE_SEMI_AUTOMATIC: Final = 'SEMIAUTOMATIC'
    MODE_MANUAL: Final = 'MANUAL'
    MODE_SERVICE: Final = 'SERVICE'
    MODE_EMERGENCY: Final = 'EMERGENCY'
    MODE_TEACHIN: Final = 'TEACHIN'
    def __init__(self, *, order_id: str = ..., action_status: str = ..., last_node_id: int = ..., driving: bool = ..., battery_charge: float = ..., operating_mode: str = ..., error_type: str = ..., error_description: str = ..., check_fields: bool = ...) -> None: ...
    order_id: str
    action_status: str
    last_node_id: int
    driving: bool
    battery_charge: float
    operating_mode: str
    error_type: str
    error_description: str

class WrenchFramed(Message):
    """control_msgs/msg/WrenchFramed

    # A force and a torque in a frame.

    string frame_id
    geometry_msgs/Wrench wrench
    """
    def __init__(self, *, frame_id: str = ..., wrench: geometry_msgs.msg.Wrench = ..., check_fields: bool = ...) -> None: ...
    frame_id: str
    wrench: geometry_msgs.msg.Wrench
