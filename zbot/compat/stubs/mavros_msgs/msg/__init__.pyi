# Written by python -m zbot.interfaces.stubs; do not edit.
from array import array
from collections.abc import Collection
from typing import Final, TypeAlias

import numpy
from numpy.typing import NDArray

import builtin_interfaces.msg
import geographic_msgs.msg
import geometry_msgs.msg
import mavros_msgs.msg
import rcl_interfaces.msg
import std_msgs.msg
from zbot.interfaces import Action, Message, Service

class ADSBVehicle(Message):
    """mavros_msgs/msg/ADSBVehicle

    uint8 ALT_PRESSURE_QNH=0
    uint8 ALT_GEOMETRIC=1
    uint8 EMITTER_NO_INFO=0
    uint8 EMITTER_LIGHT=1
    uint8 EMITTER_SMALL=2
    uint8 EMITTER_LARGE=3
    uint8 EMITTER_HIGH_VORTEX_LARGE=4
    uint8 EMITTER_HEAVY=5
    uint8 EMITTER_HIGHLY_MANUV=6
    uint8 EMITTER_ROTOCRAFT=7
    uint8 EMITTER_UNASSIGNED=8
    uint8 EMITTER_GLIDER=9
    uint8 EMITTER_LIGHTER_AIR=10
    uint8 EMITTER_PARACHUTE=11
    uint8 EMITTER_ULTRA_LIGHT=12
    uint8 EMITTER_UNASSIGNED2=13
    uint8 EMITTER_UAV=14
    uint8 EMITTER_SPACE=15
    uint8 EMITTER_UNASSGINED3=16
    uint8 EMITTER_EMERGENCY_SURFACE=17
    uint8 EMITTER_SERVICE_SURFACE=18
    uint8 EMITTER_POINT_OBSTACLE=19
    uint16 FLAG_VALID_COORDS=1
    uint16 FLAG_VALID_ALTITUDE=2
    uint16 FLAG_VALID_HEADING=4
    uint16 FLAG_VALID_VELOCITY=8
    uint16 FLAG_VALID_CALLSIGN=16
    uint16 FLAG_VALID_SQUAWK=32
    uint16 FLAG_SIMULATED=64
    uint16 FLAG_VERTICAL_VELOCITY_VALID=128
    uint16 FLAG_BARO_VALID=256
    uint16 FLAG_SOURCE_UAT=32768
    std_msgs/Header header
    uint32 icao_address
    string callsign
    float64 latitude
    float64 longitude
    float32 altitude
    float32 heading
    float32 hor_velocity
    float32 ver_velocity
    uint8 altitude_type
    uint8 emitter_type
    builtin_interfaces/Duration tslc
    uint16 flags
    uint16 squawk
    """
    ALT_PRESSURE_QNH: Final = 0
    ALT_GEOMETRIC: Final = 1
    EMITTER_NO_INFO: Final = 0
    EMITTER_LIGHT: Final = 1
    EMITTER_SMALL: Final = 2
    EMITTER_LARGE: Final = 3
    EMITTER_HIGH_VORTEX_LARGE: Final = 4
    EMITTER_HEAVY: Final = 5
    EMITTER_HIGHLY_MANUV: Final = 6
    EMITTER_ROTOCRAFT: Final = 7
    EMITTER_UNASSIGNED: Final = 8
    EMITTER_GLIDER: Final = 9
    EMITTER_LIGHTER_AIR: Final = 10
    EMITTER_PARACHUTE: Final = 11
    EMITTER_ULTRA_LIGHT: Final = 12
    EMITTER_UNASSIGNED2: Final = 13
    EMITTER_UAV: Final = 14
    EMITTER_SPACE: Final = 15
    EMITTER_UNASSGINED3: Final = 16
    EMITTER_EMERGENCY_SURFACE: Final = 17
    EMITTER_SERVICE_SURFACE: Final = 18
    EMITTER_POINT_OBSTACLE: Final = 19
    FLAG_VALID_COORDS: Final = 1
    FLAG_VALID_ALTITUDE: Final = 2
    FLAG_VALID_HEADING: Final = 4
    FLAG_VALID_VELOCITY: Final = 8
    FLAG_VALID_CALLSIGN: Final = 16
    FLAG_VALID_SQUAWK: Final = 32
    FLAG_SIMULATED: Final = 64
    FLAG_VERTICAL_VELOCITY_VALID: Final = 128
    FLAG_BARO_VALID: Final = 256
    FLAG_SOURCE_UAT: Final = 32768
    def __init__(self, *, header: std_msgs.msg.Header = ..., icao_address: int = ..., callsign: str = ..., latitude: float = ..., longitude: float = ..., altitude: float = ..., heading: float = ..., hor_velocity: float = ..., ver_velocity: float = ..., altitude_type: int = ..., emitter_type: int = ..., tslc: builtin_interfaces.msg.Duration = ..., flags: int = ..., squawk: int = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    icao_address: int
    callsign: str
    latitude: float
    longitude: float
    altitude: float
    heading: float
    hor_velocity: float
    ver_velocity: float
    altitude_type: int
    emitter_type: int
    tslc: builtin_interfaces.msg.Duration
    flags: int
    squawk: int

class ActuatorControl(Message):
    """mavros_msgs/msg/ActuatorControl

    uint8 PX4_MIX_FLIGHT_CONTROL=0
    uint8 PX4_MIX_FLIGHT_CONTROL_VTOL_ALT=1
    uint8 PX4_MIX_PAYLOAD=2
    uint8 PX4_MIX_MANUAL_PASSTHROUGH=3
    std_msgs/Header header
    uint8 group_mix
    float32[8] controls
    """
    PX4_MIX_FLIGHT_CONTROL: Final = 0
    PX4_MIX_FLIGHT_CONTROL_VTOL_ALT: Final = 1
    PX4_MIX_PAYLOAD: Final = 2
    PX4_MIX_MANUAL_PASSTHROUGH: Final = 3
    def __init__(self, *, header: std_msgs.msg.Header = ..., group_mix: int = ..., controls: Collection[float] = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    group_mix: int
    @property
    def controls(self) -> NDArray[numpy.float32]: ...
    @controls.setter
    def controls(self, value: Collection[float]) -> None: ...

class Altitude(Message):
    """mavros_msgs/msg/Altitude

    std_msgs/Header header
    float32 monotonic
    float32 amsl
    float32 local
    float32 relative
    float32 terrain
    float32 bottom_clearance
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., monotonic: float = ..., amsl: float = ..., local: float = ..., relative: float = ..., terrain: float = ..., bottom_clearance: float = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    monotonic: float
    amsl: float
    local: float
    relative: float
    terrain: float
    bottom_clearance: float

class AttitudeTarget(Message):
    """mavros_msgs/msg/AttitudeTarget

    std_msgs/Header header
    uint8 type_mask
    uint8 IGNORE_ROLL_RATE=1
    uint8 IGNORE_PITCH_RATE=2
    uint8 IGNORE_YAW_RATE=4
    uint8 IGNORE_THRUST=64
    uint8 IGNORE_ATTITUDE=128
    geometry_msgs/Quaternion orientation
    geometry_msgs/Vector3 body_rate
    float32 thrust
    """
    IGNORE_ROLL_RATE: Final = 1
    IGNORE_PITCH_RATE: Final = 2
    IGNORE_YAW_RATE: Final = 4
    IGNORE_THRUST: Final = 64
    IGNORE_ATTITUDE: Final = 128
    def __init__(self, *, header: std_msgs.msg.Header = ..., type_mask: int = ..., orientation: geometry_msgs.msg.Quaternion = ..., body_rate: geometry_msgs.msg.Vector3 = ..., thrust: float = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    type_mask: int
    orientation: geometry_msgs.msg.Quaternion
    body_rate: geometry_msgs.msg.Vector3
    thrust: float

class CamIMUStamp(Message):
    """mavros_msgs/msg/CamIMUStamp

    builtin_interfaces/Time frame_stamp
    int32 frame_seq_id
    """
    def __init__(self, *, frame_stamp: builtin_interfaces.msg.Time = ..., frame_seq_id: int = ..., check_fields: bool = ...) -> None: ...
    frame_stamp: builtin_interfaces.msg.Time
    frame_seq_id: int

class CameraImageCaptured(Message):
    """mavros_msgs/msg/CameraImageCaptured

    std_msgs/Header header
    geometry_msgs/Quaternion orientation
    geographic_msgs/GeoPoint geo
    float32 relative_alt
    int32 image_index
    int8 capture_result
    string file_url
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., orientation: geometry_msgs.msg.Quaternion = ..., geo: geographic_msgs.msg.GeoPoint = ..., relative_alt: float = ..., image_index: int = ..., capture_result: int = ..., file_url: str = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    orientation: geometry_msgs.msg.Quaternion
    geo: geographic_msgs.msg.GeoPoint
    relative_alt: float
    image_index: int
    capture_result: int
    file_url: str

class CellularStatus(Message):
    """mavros_msgs/msg/CellularStatus

    uint8 status
    uint8 failure_reason
    uint8 type
    uint8 quality
    uint16 mcc
    uint16 mnc
    uint16 lac
    """
    def __init__(self, *, status: int = ..., failure_reason: int = ..., type: int = ..., quality: int = ..., mcc: int = ..., mnc: int = ..., lac: int = ..., check_fields: bool = ...) -> None: ...
    status: int
    failure_reason: int
    type: int
    quality: int
    mcc: int
    mnc: int
    lac: int

class CommandCode(Message):
    """mavros_msgs/msg/CommandCode

    uint16 AIRFRAME_CONFIGURATION=2520
    uint16 ARM_AUTHORIZATION_REQUEST=3001
    uint16 CAMERA_TRACK_POINT=2004
    uint16 CAMERA_TRACK_RECTANGLE=2005
    uint16 CAMERA_STOP_TRACKING=2010
    uint16 CAN_FORWARD=32000
    uint16 COMPONENT_ARM_DISARM=400
    uint16 CONDITION_DELAY=112
    uint16 CONDITION_CHANGE_ALT=113
    uint16 CONDITION_DISTANCE=114
    uint16 CONDITION_YAW=115
    uint16 CONDITION_LAST=159
    uint16 CONTROL_HIGH_LATENCY=2600
    uint16 DO_FOLLOW=32
    uint16 DO_FOLLOW_REPOSITION=33
    uint16 DO_SET_MODE=176
    uint16 DO_JUMP=177
    uint16 DO_CHANGE_SPEED=178
    uint16 DO_SET_HOME=179
    uint16 DO_SET_PARAMETER=180
    uint16 DO_SET_RELAY=181
    uint16 DO_REPEAT_RELAY=182
    uint16 DO_SET_SERVO=183
    uint16 DO_REPEAT_SERVO=184
    uint16 DO_FLIGHTTERMINATION=185
    uint16 DO_CHANGE_ALTITUDE=186
    uint16 DO_RETURN_PATH_START=188
    uint16 DO_LAND_START=189
    uint16 DO_RALLY_LAND=190
    uint16 DO_GO_AROUND=191
    uint16 DO_REPOSITION=192
    uint16 DO_PAUSE_CONTINUE=193
    uint16 DO_SET_REVERSE=194
    uint16 DO_SET_ROI_LOCATION=195
    uint16 DO_SET_ROI_WPNEXT_OFFSET=196
    uint16 DO_SET_ROI_NONE=197
    uint16 DO_SET_ROI_SYSID=198
    uint16 DO_CONTROL_VIDEO=200
    uint16 DO_SET_ROI=201
    uint16 DO_DIGICAM_CONFIGURE=202
    uint16 DO_DIGICAM_CONTROL=203
    uint16 DO_MOUNT_CONFIGURE=204
    uint16 DO_MOUNT_CONTROL=205
    uint16 DO_SET_CAM_TRIGG_DIST=206
    uint16 DO_FENCE_ENABLE=207
    uint16 DO_PARACHUTE=208
    uint16 DO_MOTOR_TEST=209
    uint16 DO_INVERTED_FLIGHT=210
    uint16 DO_GRIPPER=211
    uint16 DO_AUTOTUNE_ENABLE=212
    uint16 DO_SET_CAM_TRIGG_INTERVAL=214
    uint16 DO_MOUNT_CONTROL_QUAT=220
    uint16 DO_GUIDED_MASTER=221
    uint16 DO_GUIDED_LIMITS=222
    uint16 DO_ENGINE_CONTROL=223
    uint16 DO_SET_MISSION_CURRENT=224
    uint16 DO_LAST=240
    uint16 DO_JUMP_TAG=601
    uint16 DO_GIMBAL_MANAGER_PITCHYAW=1000
    uint16 DO_GIMBAL_MANAGER_CONFIGURE=1001
    uint16 DO_TRIGGER_CONTROL=2003
    uint16 DO_VTOL_TRANSITION=3000
    uint16 DO_SET_SAFETY_SWITCH_STATE=5300
    uint16 DO_ADSB_OUT_IDENT=10001
    uint16 DO_WINCH=42600
    uint16 EXTERNAL_POSITION_ESTIMATE=43003
    uint16 FIXED_MAG_CAL_YAW=42006
    uint16 GET_HOME_POSITION=410
    uint16 GET_MESSAGE_INTERVAL=510
    uint16 IMAGE_START_CAPTURE=2000
    uint16 IMAGE_STOP_CAPTURE=2001
    uint16 JUMP_TAG=600
    uint16 LOGGING_START=2510
    uint16 LOGGING_STOP=2511
    uint16 MISSION_START=300
    uint16 NAV_WAYPOINT=16
    uint16 NAV_LOITER_UNLIM=17
    uint16 NAV_LOITER_TURNS=18
    uint16 NAV_LOITER_TIME=19
    uint16 NAV_RETURN_TO_LAUNCH=20
    uint16 NAV_LAND=21
    uint16 NAV_TAKEOFF=22
    uint16 NAV_LAND_LOCAL=23
    uint16 NAV_TAKEOFF_LOCAL=24
    uint16 NAV_FOLLOW=25
    uint16 NAV_CONTINUE_AND_CHANGE_ALT=30
    uint16 NAV_LOITER_TO_ALT=31
    uint16 NAV_ROI=80
    uint16 NAV_PATHPLANNING=81
    uint16 NAV_SPLINE_WAYPOINT=82
    uint16 NAV_VTOL_TAKEOFF=84
    uint16 NAV_VTOL_LAND=85
    uint16 NAV_GUIDED_ENABLE=92
    uint16 NAV_DELAY=93
    uint16 NAV_PAYLOAD_PLACE=94
    uint16 NAV_LAST=95
    uint16 NAV_SET_YAW_SPEED=213
    uint16 NAV_FENCE_RETURN_POINT=5000
    uint16 NAV_FENCE_POLYGON_VERTEX_INCLUSION=5001
    uint16 NAV_FENCE_POLYGON_VERTEX_EXCLUSION=5002
    uint16 NAV_FENCE_CIRCLE_INCLUSION=5003
    uint16 NAV_FENCE_CIRCLE_EXCLUSION=5004
    uint16 NAV_RALLY_POINT=5100
    uint16 OBLIQUE_SURVEY=260
    uint16 OVERRIDE_GOTO=252
    uint16 PANORAMA_CREATE=2800
    uint16 PAYLOAD_PREPARE_DEPLOY=30001
    uint16 PAYLOAD_CONTROL_DEPLOY=30002
    uint16 PREFLIGHT_CALIBRATION=241
    uint16 PREFLIGHT_SET_SENSOR_OFFSETS=242
    uint16 PREFLIGHT_UAVCAN=243
    uint16 PREFLIGHT_STORAGE=245
    uint16 PREFLIGHT_REBOOT_SHUTDOWN=246
    uint16 REQUEST_MESSAGE=512
    uint16 REQUEST_PROTOCOL_VERSION=519
    uint16 REQUEST_AUTOPILOT_CAPABILITIES=520
    uint16 REQUEST_CAMERA_INFORMATION=521
    uint16 REQUEST_CAMERA_SETTINGS=522
    uint16 REQUEST_STORAGE_INFORMATION=525
    uint16 REQUEST_CAMERA_CAPTURE_STATUS=527
    uint16 REQUEST_FLIGHT_INFORMATION=528
    uint16 REQUEST_VIDEO_STREAM_INFORMATION=2504
    uint16 REQUEST_VIDEO_STREAM_STATUS=2505
    uint16 RESET_CAMERA_SETTINGS=529
    uint16 RUN_PREARM_CHECKS=401
    uint16 SET_MESSAGE_INTERVAL=511
    uint16 SET_CAMERA_MODE=530
    uint16 SET_CAMERA_ZOOM=531
    uint16 SET_CAMERA_FOCUS=532
    uint16 SET_STORAGE_USAGE=533
    uint16 SET_CAMERA_SOURCE=534
    uint16 SET_GUIDED_SUBMODE_STANDARD=4000
    uint16 SET_GUIDED_SUBMODE_CIRCLE=4001
    uint16 START_RX_PAIR=500
    uint16 STORAGE_FORMAT=526
    uint16 UAVCAN_GET_NODE_INFO=5200
    uint16 VIDEO_START_CAPTURE=2500
    uint16 VIDEO_STOP_CAPTURE=2501
    uint16 VIDEO_START_STREAMING=2502
    uint16 VIDEO_STOP_STREAMING=2503
    """
    AIRFRAME_CONFIGURATION: Final = 2520
    ARM_AUTHORIZATION_REQUEST: Final = 3001
    CAMERA_TRACK_POINT: Final = 2004
    CAMERA_TRACK_RECTANGLE: Final = 2005
    CAMERA_STOP_TRACKING: Final = 2010
    CAN_FORWARD: Final = 32000
    COMPONENT_ARM_DISARM: Final = 400
    CONDITION_DELAY: Final = 112
    CONDITION_CHANGE_ALT: Final = 113
    CONDITION_DISTANCE: Final = 114
    CONDITION_YAW: Final = 115
    CONDITION_LAST: Final = 159
    CONTROL_HIGH_LATENCY: Final = 2600
    DO_FOLLOW: Final = 32
    DO_FOLLOW_REPOSITION: Final = 33
    DO_SET_MODE: Final = 176
    DO_JUMP: Final = 177
    DO_CHANGE_SPEED: Final = 178
    DO_SET_HOME: Final = 179
    DO_SET_PARAMETER: Final = 180
    DO_SET_RELAY: Final = 181
    DO_REPEAT_RELAY: Final = 182
    DO_SET_SERVO: Final = 183
    DO_REPEAT_SERVO: Final = 184
    DO_FLIGHTTERMINATION: Final = 185
    DO_CHANGE_ALTITUDE: Final = 186
    DO_RETURN_PATH_START: Final = 188
    DO_LAND_START: Final = 189
    DO_RALLY_LAND: Final = 190
    DO_GO_AROUND: Final = 191
    DO_REPOSITION: Final = 192
    DO_PAUSE_CONTINUE: Final = 193
    DO_SET_REVERSE: Final = 194
    DO_SET_ROI_LOCATION: Final = 195
    DO_SET_ROI_WPNEXT_OFFSET: Final = 196
    DO_SET_ROI_NONE: Final = 197
    DO_SET_ROI_SYSID: Final = 198
    DO_CONTROL_VIDEO: Final = 200
    DO_SET_ROI: Final = 201
    DO_DIGICAM_CONFIGURE: Final = 202
    DO_DIGICAM_CONTROL: Final = 203
    DO_MOUNT_CONFIGURE: Final = 204
    DO_MOUNT_CONTROL: Final = 205
    DO_SET_CAM_TRIGG_DIST: Final = 206
    DO_FENCE_ENABLE: Final = 207
    DO_PARACHUTE: Final = 208
    DO_MOTOR_TEST: Final = 209
    DO_INVERTED_FLIGHT: Final = 210
    DO_GRIPPER: Final = 211
    DO_AUTOTUNE_ENABLE: Final = 212
    DO_SET_CAM_TRIGG_INTERVAL: Final = 214
    DO_MOUNT_CONTROL_QUAT: Final = 220
    DO_GUIDED_MASTER: Final = 221
    DO_GUIDED_LIMITS: Final = 222
    DO_ENGINE_CONTROL: Final = 223
    DO_SET_MISSION_CURRENT: Final = 224
    DO_LAST: Final = 240
    DO_JUMP_TAG: Final = 601
    DO_GIMBAL_MANAGER_PITCHYAW: Final = 1000
    DO_GIMBAL_MANAGER_CONFIGURE: Final = 1001
    DO_TRIGGER_CONTROL: Final = 2003
    DO_VTOL_TRANSITION: Final = 3000
    DO_SET_SAFETY_SWITCH_STATE: Final = 5300
    DO_ADSB_OUT_IDENT: Final = 10001
    DO_WINCH: Final = 42600
    EXTERNAL_POSITION_ESTIMATE: Final = 43003
    FIXED_MAG_CAL_YAW: Final = 42006
    GET_HOME_POSITION: Final = 410
    GET_MESSAGE_INTERVAL: Final = 510
    IMAGE_START_CAPTURE: Final = 2000
    IMAGE_STOP_CAPTURE: Final = 2001
    JUMP_TAG: Final = 600
    LOGGING_START: Final = 2510
    LOGGING_STOP: Final = 2511
    MISSION_START: Final = 300
    NAV_WAYPOINT: Final = 16
    NAV_LOITER_UNLIM: Final = 17
    NAV_LOITER_TURNS: Final = 18
    NAV_LOITER_TIME: Final = 19
    NAV_RETURN_TO_LAUNCH: Final = 20
    NAV_LAND: Final = 21
    NAV_TAKEOFF: Final = 22
    NAV_LAND_LOCAL: Final = 23
    NAV_TAKEOFF_LOCAL: Final = 24
    NAV_FOLLOW: Final = 25
    NAV_CONTINUE_AND_CHANGE_ALT: Final = 30
    NAV_LOITER_TO_ALT: Final = 31
    NAV_ROI: Final = 80
    NAV_PATHPLANNING: Final = 81
    NAV_SPLINE_WAYPOINT: Final = 82
    NAV_VTOL_TAKEOFF: Final = 84
    NAV_VTOL_LAND: Final = 85
    NAV_GUIDED_ENABLE: Final = 92
    NAV_DELAY: Final = 93
    NAV_PAYLOAD_PLACE: Final = 94
    NAV_LAST: Final = 95
    NAV_SET_YAW_SPEED: Final = 213
    NAV_FENCE_RETURN_POINT: Final = 5000
    NAV_FENCE_POLYGON_VERTEX_INCLUSION: Final = 5001
    NAV_FENCE_POLYGON_VERTEX_EXCLUSION: Final = 5002
    NAV_FENCE_CIRCLE_INCLUSION: Final = 5003
    NAV_FENCE_CIRCLE_EXCLUSION: Final = 5004
    NAV_RALLY_POINT: Final = 5100
    OBLIQUE_SURVEY: Final = 260
    OVERRIDE_GOTO: Final = 252
    PANORAMA_CREATE: Final = 2800
    PAYLOAD_PREPARE_DEPLOY: Final = 30001
    PAYLOAD_CONTROL_DEPLOY: Final = 30002
    PREFLIGHT_CALIBRATION: Final = 241
    PREFLIGHT_SET_SENSOR_OFFSETS: Final = 242
    PREFLIGHT_UAVCAN: Final = 243
    PREFLIGHT_STORAGE: Final = 245
    PREFLIGHT_REBOOT_SHUTDOWN: Final = 246
    REQUEST_MESSAGE: Final = 512
    REQUEST_PROTOCOL_VERSION: Final = 519
    REQUEST_AUTOPILOT_CAPABILITIES: Final = 520
    REQUEST_CAMERA_INFORMATION: Final = 521
    REQUEST_CAMERA_SETTINGS: Final = 522
    REQUEST_STORAGE_INFORMATION: Final = 525
    REQUEST_CAMERA_CAPTURE_STATUS: Final = 527
    REQUEST_FLIGHT_INFORMATION: Final = 528
    REQUEST_VIDEO_STREAM_INFORMATION: Final = 2504
    REQUEST_VIDEO_STREAM_STATUS: Final = 2505
    RESET_CAMERA_SETTINGS: Final = 529
    RUN_PREARM_CHECKS: Final = 401
    SET_MESSAGE_INTERVAL: Final = 511
    SET_CAMERA_MODE: Final = 530
    SET_CAMERA_ZOOM: Final = 531
    SET_CAMERA_FOCUS: Final = 532
    SET_STORAGE_USAGE: Final = 533
    SET_CAMERA_SOURCE: Final = 534
    SET_GUIDED_SUBMODE_STANDARD: Final = 4000
    SET_GUIDED_SUBMODE_CIRCLE: Final = 4001
    START_RX_PAIR: Final = 500
    STORAGE_FORMAT: Final = 526
    UAVCAN_GET_NODE_INFO: Final = 5200
    VIDEO_START_CAPTURE: Final = 2500
    VIDEO_STOP_CAPTURE: Final = 2501
    VIDEO_START_STREAMING: Final = 2502
    VIDEO_STOP_STREAMING: Final = 2503
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class CompanionProcessStatus(Message):
    """mavros_msgs/msg/CompanionProcessStatus

    std_msgs/Header header
    uint8 state
    uint8 component
    uint8 MAV_STATE_UNINIT=0
    uint8 MAV_STATE_BOOT=1
    uint8 MAV_STATE_CALIBRATING=2
    uint8 MAV_STATE_STANDBY=3
    uint8 MAV_STATE_ACTIVE=4
    uint8 MAV_STATE_CRITICAL=5
    uint8 MAV_STATE_EMERGENCY=6
    uint8 MAV_STATE_POWEROFF=7
    uint8 MAV_STATE_FLIGHT_TERMINATION=8
    uint8 MAV_COMP_ID_OBSTACLE_AVOIDANCE=196
    uint8 MAV_COMP_ID_VISUAL_INERTIAL_ODOMETRY=197
    """
    MAV_STATE_UNINIT: Final = 0
    MAV_STATE_BOOT: Final = 1
    MAV_STATE_CALIBRATING: Final = 2
    MAV_STATE_STANDBY: Final = 3
    MAV_STATE_ACTIVE: Final = 4
    MAV_STATE_CRITICAL: Final = 5
    MAV_STATE_EMERGENCY: Final = 6
    MAV_STATE_POWEROFF: Final = 7
    MAV_STATE_FLIGHT_TERMINATION: Final = 8
    MAV_COMP_ID_OBSTACLE_AVOIDANCE: Final = 196
    MAV_COMP_ID_VISUAL_INERTIAL_ODOMETRY: Final = 197
    def __init__(self, *, header: std_msgs.msg.Header = ..., state: int = ..., component: int = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    state: int
    component: int

class DebugValue(Message):
    """mavros_msgs/msg/DebugValue

    std_msgs/Header header
    int32 index
    int32 array_id
    string name
    float32 value_float
    int32 value_int
    float32[] data
    uint8 type
    uint8 TYPE_DEBUG=0
    uint8 TYPE_DEBUG_VECT=1
    uint8 TYPE_DEBUG_FLOAT_ARRAY=2
    uint8 TYPE_NAMED_VALUE_FLOAT=3
    uint8 TYPE_NAMED_VALUE_INT=4
    """
    TYPE_DEBUG: Final = 0
    TYPE_DEBUG_VECT: Final = 1
    TYPE_DEBUG_FLOAT_ARRAY: Final = 2
    TYPE_NAMED_VALUE_FLOAT: Final = 3
    TYPE_NAMED_VALUE_INT: Final = 4
    def __init__(self, *, header: std_msgs.msg.Header = ..., index: int = ..., array_id: int = ..., name: str = ..., value_float: float = ..., value_int: int = ..., data: Collection[float] = ..., type: int = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    index: int
    array_id: int
    name: str
    value_float: float
    value_int: int
    @property
    def data(self) -> array[float]: ...
    @data.setter
    def data(self, value: Collection[float]) -> None: ...
    type: int

class ESCInfo(Message):
    """mavros_msgs/msg/ESCInfo

    std_msgs/Header header
    uint16 counter
    uint8 count
    uint8 connection_type
    uint8 info
    mavros_msgs/ESCInfoItem[] esc_info
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., counter: int = ..., count: int = ..., connection_type: int = ..., info: int = ..., esc_info: Collection[mavros_msgs.msg.ESCInfoItem] = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    counter: int
    count: int
    connection_type: int
    info: int
    @property
    def esc_info(self) -> list[mavros_msgs.msg.ESCInfoItem]: ...
    @esc_info.setter
    def esc_info(self, value: Collection[mavros_msgs.msg.ESCInfoItem]) -> None: ...

class ESCInfoItem(Message):
    """mavros_msgs/msg/ESCInfoItem

    std_msgs/Header header
    uint16 failure_flags
    uint32 error_count
    int32 temperature
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., failure_flags: int = ..., error_count: int = ..., temperature: int = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    failure_flags: int
    error_count: int
    temperature: int

class ESCStatus(Message):
    """mavros_msgs/msg/ESCStatus

    std_msgs/Header header
    mavros_msgs/ESCStatusItem[] esc_status
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., esc_status: Collection[mavros_msgs.msg.ESCStatusItem] = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    @property
    def esc_status(self) -> list[mavros_msgs.msg.ESCStatusItem]: ...
    @esc_status.setter
    def esc_status(self, value: Collection[mavros_msgs.msg.ESCStatusItem]) -> None: ...

class ESCStatusItem(Message):
    """mavros_msgs/msg/ESCStatusItem

    std_msgs/Header header
    int32 rpm
    float32 voltage
    float32 current
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., rpm: int = ..., voltage: float = ..., current: float = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    rpm: int
    voltage: float
    current: float

class ESCTelemetry(Message):
    """mavros_msgs/msg/ESCTelemetry

    std_msgs/Header header
    mavros_msgs/ESCTelemetryItem[] esc_telemetry
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., esc_telemetry: Collection[mavros_msgs.msg.ESCTelemetryItem] = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    @property
    def esc_telemetry(self) -> list[mavros_msgs.msg.ESCTelemetryItem]: ...
    @esc_telemetry.setter
    def esc_telemetry(self, value: Collection[mavros_msgs.msg.ESCTelemetryItem]) -> None: ...

class ESCTelemetryItem(Message):
    """mavros_msgs/msg/ESCTelemetryItem

    std_msgs/Header header
    float32 temperature
    float32 voltage
    float32 current
    float32 totalcurrent
    int32 rpm
    uint16 count
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., temperature: float = ..., voltage: float = ..., current: float = ..., totalcurrent: float = ..., rpm: int = ..., count: int = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    temperature: float
    voltage: float
    current: float
    totalcurrent: float
    rpm: int
    count: int

class EstimatorStatus(Message):
    """mavros_msgs/msg/EstimatorStatus

    std_msgs/Header header
    bool attitude_status_flag
    bool velocity_horiz_status_flag
    bool velocity_vert_status_flag
    bool pos_horiz_rel_status_flag
    bool pos_horiz_abs_status_flag
    bool pos_vert_abs_status_flag
    bool pos_vert_agl_status_flag
    bool const_pos_mode_status_flag
    bool pred_pos_horiz_rel_status_flag
    bool pred_pos_horiz_abs_status_flag
    bool gps_glitch_status_flag
    bool accel_error_status_flag
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., attitude_status_flag: bool = ..., velocity_horiz_status_flag: bool = ..., velocity_vert_status_flag: bool = ..., pos_horiz_rel_status_flag: bool = ..., pos_horiz_abs_status_flag: bool = ..., pos_vert_abs_status_flag: bool = ..., pos_vert_agl_status_flag: bool = ..., const_pos_mode_status_flag: bool = ..., pred_pos_horiz_rel_status_flag: bool = ..., pred_pos_horiz_abs_status_flag: bool = ..., gps_glitch_status_flag: bool = ..., accel_error_status_flag: bool = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    attitude_status_flag: bool
    velocity_horiz_status_flag: bool
    velocity_vert_status_flag: bool
    pos_horiz_rel_status_flag: bool
    pos_horiz_abs_status_flag: bool
    pos_vert_abs_status_flag: bool
    pos_vert_agl_status_flag: bool
    const_pos_mode_status_flag: bool
    pred_pos_horiz_rel_status_flag: bool
    pred_pos_horiz_abs_status_flag: bool
    gps_glitch_status_flag: bool
    accel_error_status_flag: bool

class ExtendedState(Message):
    """mavros_msgs/msg/ExtendedState

    uint8 VTOL_STATE_UNDEFINED=0
    uint8 VTOL_STATE_TRANSITION_TO_FW=1
    uint8 VTOL_STATE_TRANSITION_TO_MC=2
    uint8 VTOL_STATE_MC=3
    uint8 VTOL_STATE_FW=4
    uint8 LANDED_STATE_UNDEFINED=0
    uint8 LANDED_STATE_ON_GROUND=1
    uint8 LANDED_STATE_IN_AIR=2
    uint8 LANDED_STATE_TAKEOFF=3
    uint8 LANDED_STATE_LANDING=4
    std_msgs/Header header
    uint8 vtol_state
    uint8 landed_state
    """
    VTOL_STATE_UNDEFINED: Final = 0
    VTOL_STATE_TRANSITION_TO_FW: Final = 1
    VTOL_STATE_TRANSITION_TO_MC: Final = 2
    VTOL_STATE_MC: Final = 3
    VTOL_STATE_FW: Final = 4
    LANDED_STATE_UNDEFINED: Final = 0
    LANDED_STATE_ON_GROUND: Final = 1
    LANDED_STATE_IN_AIR: Final = 2
    LANDED_STATE_TAKEOFF: Final = 3
    LANDED_STATE_LANDING: Final = 4
    def __init__(self, *, header: std_msgs.msg.Header = ..., vtol_state: int = ..., landed_state: int = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    vtol_state: int
    landed_state: int

class FileEntry(Message):
    """mavros_msgs/msg/FileEntry

    uint8 TYPE_FILE=0
    uint8 TYPE_DIRECTORY=1
    string name
    uint8 type
    uint64 size
    """
    TYPE_FILE: Final = 0
    TYPE_DIRECTORY: Final = 1
    def __init__(self, *, name: str = ..., type: int = ..., size: int = ..., check_fields: bool = ...) -> None: ...
    name: str
    type: int
    size: int

class GPSINPUT(Message):
    """mavros_msgs/msg/GPSINPUT

    std_msgs/Header header
    uint8 GPS_FIX_TYPE_NO_GPS=0
    uint8 GPS_FIX_TYPE_NO_FIX=1
    uint8 GPS_FIX_TYPE_2D_FIX=2
    uint8 GPS_FIX_TYPE_3D_FIX=3
    uint8 GPS_FIX_TYPE_DGPS=4
    uint8 GPS_FIX_TYPE_RTK_FLOATR=5
    uint8 GPS_FIX_TYPE_RTK_FIXEDR=6
    uint8 GPS_FIX_TYPE_STATIC=7
    uint8 GPS_FIX_TYPE_PPP=8
    uint8 fix_type
    uint8 gps_id
    uint16 ignore_flags
    uint32 time_week_ms
    uint16 time_week
    int32 lat
    int32 lon
    float32 alt
    float32 hdop
    float32 vdop
    float32 vn
    float32 ve
    float32 vd
    float32 speed_accuracy
    float32 horiz_accuracy
    float32 vert_accuracy
    uint8 satellites_visible
    uint16 yaw
    """
    GPS_FIX_TYPE_NO_GPS: Final = 0
    GPS_FIX_TYPE_NO_FIX: Final = 1
    GPS_FIX_TYPE_2D_FIX: Final = 2
    GPS_FIX_TYPE_3D_FIX: Final = 3
    GPS_FIX_TYPE_DGPS: Final = 4
    GPS_FIX_TYPE_RTK_FLOATR: Final = 5
    GPS_FIX_TYPE_RTK_FIXEDR: Final = 6
    GPS_FIX_TYPE_STATIC: Final = 7
    GPS_FIX_TYPE_PPP: Final = 8
    def __init__(self, *, header: std_msgs.msg.Header = ..., fix_type: int = ..., gps_id: int = ..., ignore_flags: int = ..., time_week_ms: int = ..., time_week: int = ..., lat: int = ..., lon: int = ..., alt: float = ..., hdop: float = ..., vdop: float = ..., vn: float = ..., ve: float = ..., vd: float = ..., speed_accuracy: float = ..., horiz_accuracy: float = ..., vert_accuracy: float = ..., satellites_visible: int = ..., yaw: int = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    fix_type: int
    gps_id: int
    ignore_flags: int
    time_week_ms: int
    time_week: int
    lat: int
    lon: int
    alt: float
    hdop: float
    vdop: float
    vn: float
    ve: float
    vd: float
    speed_accuracy: float
    horiz_accuracy: float
    vert_accuracy: float
    satellites_visible: int
    yaw: int

class GPSRAW(Message):
    """mavros_msgs/msg/GPSRAW

    std_msgs/Header header
    uint8 GPS_FIX_TYPE_NO_GPS=0
    uint8 GPS_FIX_TYPE_NO_FIX=1
    uint8 GPS_FIX_TYPE_2D_FIX=2
    uint8 GPS_FIX_TYPE_3D_FIX=3
    uint8 GPS_FIX_TYPE_DGPS=4
    uint8 GPS_FIX_TYPE_RTK_FLOAT=5
    uint8 GPS_FIX_TYPE_RTK_FIXED=6
    uint8 GPS_FIX_TYPE_STATIC=7
    uint8 GPS_FIX_TYPE_PPP=8
    uint8 fix_type
    int32 lat
    int32 lon
    int32 alt
    uint16 eph
    uint16 epv
    uint16 vel
    uint16 cog
    uint8 satellites_visible
    int32 alt_ellipsoid
    uint32 h_acc
    uint32 v_acc
    uint32 vel_acc
    int32 hdg_acc
    uint16 yaw
    uint8 dgps_numch
    uint32 dgps_age
    """
    GPS_FIX_TYPE_NO_GPS: Final = 0
    GPS_FIX_TYPE_NO_FIX: Final = 1
    GPS_FIX_TYPE_2D_FIX: Final = 2
    GPS_FIX_TYPE_3D_FIX: Final = 3
    GPS_FIX_TYPE_DGPS: Final = 4
    GPS_FIX_TYPE_RTK_FLOAT: Final = 5
    GPS_FIX_TYPE_RTK_FIXED: Final = 6
    GPS_FIX_TYPE_STATIC: Final = 7
    GPS_FIX_TYPE_PPP: Final = 8
    def __init__(self, *, header: std_msgs.msg.Header = ..., fix_type: int = ..., lat: int = ..., lon: int = ..., alt: int = ..., eph: int = ..., epv: int = ..., vel: int = ..., cog: int = ..., satellites_visible: int = ..., alt_ellipsoid: int = ..., h_acc: int = ..., v_acc: int = ..., vel_acc: int = ..., hdg_acc: int = ..., yaw: int = ..., dgps_numch: int = ..., dgps_age: int = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    fix_type: int
    lat: int
    lon: int
    alt: int
    eph: int
    epv: int
    vel: int
    cog: int
    satellites_visible: int
    alt_ellipsoid: int
    h_acc: int
    v_acc: int
    vel_acc: int
    hdg_acc: int
    yaw: int
    dgps_numch: int
    dgps_age: int

class GPSRTK(Message):
    """mavros_msgs/msg/GPSRTK

    std_msgs/Header header
    uint8 rtk_receiver_id
    int16 wn
    uint32 tow
    uint8 rtk_health
    uint8 rtk_rate
    uint8 nsats
    int32 baseline_a
    int32 baseline_b
    int32 baseline_c
    uint32 accuracy
    int32 iar_num_hypotheses
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., rtk_receiver_id: int = ..., wn: int = ..., tow: int = ..., rtk_health: int = ..., rtk_rate: int = ..., nsats: int = ..., baseline_a: int = ..., baseline_b: int = ..., baseline_c: int = ..., accuracy: int = ..., iar_num_hypotheses: int = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    rtk_receiver_id: int
    wn: int
    tow: int
    rtk_health: int
    rtk_rate: int
    nsats: int
    baseline_a: int
    baseline_b: int
    baseline_c: int
    accuracy: int
    iar_num_hypotheses: int

class GimbalDeviceAttitudeStatus(Message):
    """mavros_msgs/msg/GimbalDeviceAttitudeStatus

    std_msgs/Header header
    uint8 target_system
    uint8 target_component
    uint16 flags
    uint16 FLAGS_RETRACT=1
    uint16 FLAGS_NEUTRAL=2
    uint16 FLAGS_ROLL_LOCK=4
    uint16 FLAGS_PITCH_LOCK=8
    uint16 FLAGS_YAW_LOCK=16
    geometry_msgs/Quaternion q
    float32 angular_velocity_x
    float32 angular_velocity_y
    float32 angular_velocity_z
    uint32 failure_flags
    uint32 ERROR_FLAGS_AT_ROLL_LIMIT=1
    uint32 ERROR_FLAGS_AT_PITCH_LIMIT=2
    uint32 ERROR_FLAGS_AT_YAW_LIMIT=4
    uint32 ERROR_FLAGS_ENCODER_ERROR=8
    uint32 ERROR_FLAGS_POWER_ERROR=16
    uint32 ERROR_FLAGS_MOTOR_ERROR=32
    uint32 ERROR_FLAGS_SOFTWARE_ERROR=64
    uint32 ERROR_FLAGS_COMMS_ERROR=128
    uint32 ERROR_FLAGS_CALIBRATION_RUNNING=256
    """
    FLAGS_RETRACT: Final = 1
    FLAGS_NEUTRAL: Final = 2
    FLAGS_ROLL_LOCK: Final = 4
    FLAGS_PITCH_LOCK: Final = 8
    FLAGS_YAW_LOCK: Final = 16
    ERROR_FLAGS_AT_ROLL_LIMIT: Final = 1
    ERROR_FLAGS_AT_PITCH_LIMIT: Final = 2
    ERROR_FLAGS_AT_YAW_LIMIT: Final = 4
    ERROR_FLAGS_ENCODER_ERROR: Final = 8
    ERROR_FLAGS_POWER_ERROR: Final = 16
    ERROR_FLAGS_MOTOR_ERROR: Final = 32
    ERROR_FLAGS_SOFTWARE_ERROR: Final = 64
    ERROR_FLAGS_COMMS_ERROR: Final = 128
    ERROR_FLAGS_CALIBRATION_RUNNING: Final = 256
    def __init__(self, *, header: std_msgs.msg.Header = ..., target_system: int = ..., target_component: int = ..., flags: int = ..., q: geometry_msgs.msg.Quaternion = ..., angular_velocity_x: float = ..., angular_velocity_y: float = ..., angular_velocity_z: float = ..., failure_flags: int = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    target_system: int
    target_component: int
    flags: int
    q: geometry_msgs.msg.Quaternion
    angular_velocity_x: float
    angular_velocity_y: float
    angular_velocity_z: float
    failure_flags: int

class GimbalDeviceInformation(Message):
    """mavros_msgs/msg/GimbalDeviceInformation

    std_msgs/Header header
    string vendor_name
    string model_name
    string custom_name
    uint32 firmware_version
    uint32 hardware_version
    uint64 uid
    uint32 cap_flags
    uint32 CAP_FLAGS_HAS_RETRACT=1
    uint32 CAP_FLAGS_HAS_NEUTRAL=2
    uint32 CAP_FLAGS_HAS_ROLL_AXIS=4
    uint32 CAP_FLAGS_HAS_ROLL_FOLLOW=8
    uint32 CAP_FLAGS_HAS_ROLL_LOCK=16
    uint32 CAP_FLAGS_HAS_PITCH_AXIS=32
    uint32 CAP_FLAGS_HAS_PITCH_FOLLOW=64
    uint32 CAP_FLAGS_HAS_PITCH_LOCK=128
    uint32 CAP_FLAGS_HAS_YAW_AXIS=256
    uint32 CAP_FLAGS_HAS_YAW_FOLLOW=512
    uint32 CAP_FLAGS_HAS_YAW_LOCK=1024
    uint32 CAP_FLAGS_SUPPORTS_INFINITE_YAW=2048
    uint16 custom_cap_flags
    float32 roll_min
    float32 roll_max
    float32 pitch_min
    float32 pitch_max
    float32 yaw_min
    float32 yaw_max
    """
    CAP_FLAGS_HAS_RETRACT: Final = 1
    CAP_FLAGS_HAS_NEUTRAL: Final = 2
    CAP_FLAGS_HAS_ROLL_AXIS: Final = 4
    CAP_FLAGS_HAS_ROLL_FOLLOW: Final = 8
    CAP_FLAGS_HAS_ROLL_LOCK: Final = 16
    CAP_FLAGS_HAS_PITCH_AXIS: Final = 32
    CAP_FLAGS_HAS_PITCH_FOLLOW: Final = 64
    CAP_FLAGS_HAS_PITCH_LOCK: Final = 128
    CAP_FLAGS_HAS_YAW_AXIS: Final = 256
    CAP_FLAGS_HAS_YAW_FOLLOW: Final = 512
    CAP_FLAGS_HAS_YAW_LOCK: Final = 1024
    CAP_FLAGS_SUPPORTS_INFINITE_YAW: Final = 2048
    def __init__(self, *, header: std_msgs.msg.Header = ..., vendor_name: str = ..., model_name: str = ..., custom_name: str = ..., firmware_version: int = ..., hardware_version: int = ..., uid: int = ..., cap_flags: int = ..., custom_cap_flags: int = ..., roll_min: float = ..., roll_max: float = ..., pitch_min: float = ..., pitch_max: float = ..., yaw_min: float = ..., yaw_max: float = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    vendor_name: str
    model_name: str
    custom_name: str
    firmware_version: int
    hardware_version: int
    uid: int
    cap_flags: int
    custom_cap_flags: int
    roll_min: float
    roll_max: float
    pitch_min: float
    pitch_max: float
    yaw_min: float
    yaw_max: float

class GimbalDeviceSetAttitude(Message):
    """mavros_msgs/msg/GimbalDeviceSetAttitude

    uint8 target_system
    uint8 target_component
    uint16 flags
    uint16 FLAGS_RETRACT=1
    uint16 FLAGS_NEUTRAL=2
    uint16 FLAGS_ROLL_LOCK=4
    uint16 FLAGS_PITCH_LOCK=8
    uint16 FLAGS_YAW_LOCK=16
    geometry_msgs/Quaternion q
    float32 angular_velocity_x
    float32 angular_velocity_y
    float32 angular_velocity_z
    """
    FLAGS_RETRACT: Final = 1
    FLAGS_NEUTRAL: Final = 2
    FLAGS_ROLL_LOCK: Final = 4
    FLAGS_PITCH_LOCK: Final = 8
    FLAGS_YAW_LOCK: Final = 16
    def __init__(self, *, target_system: int = ..., target_component: int = ..., flags: int = ..., q: geometry_msgs.msg.Quaternion = ..., angular_velocity_x: float = ..., angular_velocity_y: float = ..., angular_velocity_z: float = ..., check_fields: bool = ...) -> None: ...
    target_system: int
    target_component: int
    flags: int
    q: geometry_msgs.msg.Quaternion
    angular_velocity_x: float
    angular_velocity_y: float
    angular_velocity_z: float

class GimbalManagerInformation(Message):
    """mavros_msgs/msg/GimbalManagerInformation

    std_msgs/Header header
    uint32 cap_flags
    uint32 CAP_FLAGS_HAS_RETRACT=1
    uint32 CAP_FLAGS_HAS_NEUTRAL=2
    uint32 CAP_FLAGS_HAS_ROLL_AXIS=4
    uint32 CAP_FLAGS_HAS_ROLL_FOLLOW=8
    uint32 CAP_FLAGS_HAS_ROLL_LOCK=16
    uint32 CAP_FLAGS_HAS_PITCH_AXIS=32
    uint32 CAP_FLAGS_HAS_PITCH_FOLLOW=64
    uint32 CAP_FLAGS_HAS_PITCH_LOCK=128
    uint32 CAP_FLAGS_HAS_YAW_AXIS=256
    uint32 CAP_FLAGS_HAS_YAW_FOLLOW=512
    uint32 CAP_FLAGS_HAS_YAW_LOCK=1024
    uint32 CAP_FLAGS_SUPPORTS_INFINITE_YAW=2048
    uint32 CAP_FLAGS_CAN_POINT_LOCATION_LOCAL=65536
    uint32 CAP_FLAGS_CAN_POINT_LOCATION_GLOBAL=131072
    uint8 gimbal_device_id
    float32 roll_min
    float32 roll_max
    float32 pitch_min
    float32 pitch_max
    float32 yaw_min
    float32 yaw_max
    """
    CAP_FLAGS_HAS_RETRACT: Final = 1
    CAP_FLAGS_HAS_NEUTRAL: Final = 2
    CAP_FLAGS_HAS_ROLL_AXIS: Final = 4
    CAP_FLAGS_HAS_ROLL_FOLLOW: Final = 8
    CAP_FLAGS_HAS_ROLL_LOCK: Final = 16
    CAP_FLAGS_HAS_PITCH_AXIS: Final = 32
    CAP_FLAGS_HAS_PITCH_FOLLOW: Final = 64
    CAP_FLAGS_HAS_PITCH_LOCK: Final = 128
    CAP_FLAGS_HAS_YAW_AXIS: Final = 256
    CAP_FLAGS_HAS_YAW_FOLLOW: Final = 512
    CAP_FLAGS_HAS_YAW_LOCK: Final = 1024
    CAP_FLAGS_SUPPORTS_INFINITE_YAW: Final = 2048
    CAP_FLAGS_CAN_POINT_LOCATION_LOCAL: Final = 65536
    CAP_FLAGS_CAN_POINT_LOCATION_GLOBAL: Final = 131072
    def __init__(self, *, header: std_msgs.msg.Header = ..., cap_flags: int = ..., gimbal_device_id: int = ..., roll_min: float = ..., roll_max: float = ..., pitch_min: float = ..., pitch_max: float = ..., yaw_min: float = ..., yaw_max: float = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    cap_flags: int
    gimbal_device_id: int
    roll_min: float
    roll_max: float
    pitch_min: float
    pitch_max: float
    yaw_min: float
    yaw_max: float

class GimbalManagerSetAttitude(Message):
    """mavros_msgs/msg/GimbalManagerSetAttitude

    uint8 target_system
    uint8 target_component
    uint32 flags
    uint32 GIMBAL_MANAGER_FLAGS_RETRACT=1
    uint32 GIMBAL_MANAGER_FLAGS_NEUTRAL=2
    uint32 GIMBAL_MANAGER_FLAGS_ROLL_LOCK=4
    uint32 GIMBAL_MANAGER_FLAGS_PITCH_LOCK=8
    uint32 GIMBAL_MANAGER_FLAGS_YAW_LOCK=16
    uint8 gimbal_device_id
    geometry_msgs/Quaternion q
    float32 angular_velocity_x
    float32 angular_velocity_y
    float32 angular_velocity_z
    """
    GIMBAL_MANAGER_FLAGS_RETRACT: Final = 1
    GIMBAL_MANAGER_FLAGS_NEUTRAL: Final = 2
    GIMBAL_MANAGER_FLAGS_ROLL_LOCK: Final = 4
    GIMBAL_MANAGER_FLAGS_PITCH_LOCK: Final = 8
    GIMBAL_MANAGER_FLAGS_YAW_LOCK: Final = 16
    def __init__(self, *, target_system: int = ..., target_component: int = ..., flags: int = ..., gimbal_device_id: int = ..., q: geometry_msgs.msg.Quaternion = ..., angular_velocity_x: float = ..., angular_velocity_y: float = ..., angular_velocity_z: float = ..., check_fields: bool = ...) -> None: ...
    target_system: int
    target_component: int
    flags: int
    gimbal_device_id: int
    q: geometry_msgs.msg.Quaternion
    angular_velocity_x: float
    angular_velocity_y: float
    angular_velocity_z: float

class GimbalManagerSetPitchyaw(Message):
    """mavros_msgs/msg/GimbalManagerSetPitchyaw

    uint8 target_system
    uint8 target_component
    uint32 flags
    uint32 GIMBAL_MANAGER_FLAGS_RETRACT=1
    uint32 GIMBAL_MANAGER_FLAGS_NEUTRAL=2
    uint32 GIMBAL_MANAGER_FLAGS_ROLL_LOCK=4
    uint32 GIMBAL_MANAGER_FLAGS_PITCH_LOCK=8
    uint32 GIMBAL_MANAGER_FLAGS_YAW_LOCK=16
    uint8 gimbal_device_id
    float32 pitch
    float32 yaw
    float32 pitch_rate
    float32 yaw_rate
    """
    GIMBAL_MANAGER_FLAGS_RETRACT: Final = 1
    GIMBAL_MANAGER_FLAGS_NEUTRAL: Final = 2
    GIMBAL_MANAGER_FLAGS_ROLL_LOCK: Final = 4
    GIMBAL_MANAGER_FLAGS_PITCH_LOCK: Final = 8
    GIMBAL_MANAGER_FLAGS_YAW_LOCK: Final = 16
    def __init__(self, *, target_system: int = ..., target_component: int = ..., flags: int = ..., gimbal_device_id: int = ..., pitch: float = ..., yaw: float = ..., pitch_rate: float = ..., yaw_rate: float = ..., check_fields: bool = ...) -> None: ...
    target_system: int
    target_component: int
    flags: int
    gimbal_device_id: int
    pitch: float
    yaw: float
    pitch_rate: float
    yaw_rate: float

class GimbalManagerStatus(Message):
    """mavros_msgs/msg/GimbalManagerStatus

    std_msgs/Header header
    uint32 flags
    uint32 GIMBAL_MANAGER_FLAGS_RETRACT=1
    uint32 GIMBAL_MANAGER_FLAGS_NEUTRAL=2
    uint32 GIMBAL_MANAGER_FLAGS_ROLL_LOCK=4
    uint32 GIMBAL_MANAGER_FLAGS_PITCH_LOCK=8
    uint32 GIMBAL_MANAGER_FLAGS_YAW_LOCK=16
    uint8 gimbal_device_id
    uint8 sysid_primary
    uint8 compid_primary
    uint8 sysid_secondary
    uint8 compid_secondary
    """
    GIMBAL_MANAGER_FLAGS_RETRACT: Final = 1
    GIMBAL_MANAGER_FLAGS_NEUTRAL: Final = 2
    GIMBAL_MANAGER_FLAGS_ROLL_LOCK: Final = 4
    GIMBAL_MANAGER_FLAGS_PITCH_LOCK: Final = 8
    GIMBAL_MANAGER_FLAGS_YAW_LOCK: Final = 16
    def __init__(self, *, header: std_msgs.msg.Header = ..., flags: int = ..., gimbal_device_id: int = ..., sysid_primary: int = ..., compid_primary: int = ..., sysid_secondary: int = ..., compid_secondary: int = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    flags: int
    gimbal_device_id: int
    sysid_primary: int
    compid_primary: int
    sysid_secondary: int
    compid_secondary: int

class GlobalPositionTarget(Message):
    """mavros_msgs/msg/GlobalPositionTarget

    std_msgs/Header header
    uint8 coordinate_frame
    uint8 FRAME_GLOBAL_INT=5
    uint8 FRAME_GLOBAL_REL_ALT=6
    uint8 FRAME_GLOBAL_TERRAIN_ALT=11
    uint16 type_mask
    uint16 IGNORE_LATITUDE=1
    uint16 IGNORE_LONGITUDE=2
    uint16 IGNORE_ALTITUDE=4
    uint16 IGNORE_VX=8
    uint16 IGNORE_VY=16
    uint16 IGNORE_VZ=32
    uint16 IGNORE_AFX=64
    uint16 IGNORE_AFY=128
    uint16 IGNORE_AFZ=256
    uint16 FORCE=512
    uint16 IGNORE_YAW=1024
    uint16 IGNORE_YAW_RATE=2048
    float64 latitude
    float64 longitude
    float32 altitude
    geometry_msgs/Vector3 velocity
    geometry_msgs/Vector3 acceleration_or_force
    float32 yaw
    float32 yaw_rate
    """
    FRAME_GLOBAL_INT: Final = 5
    FRAME_GLOBAL_REL_ALT: Final = 6
    FRAME_GLOBAL_TERRAIN_ALT: Final = 11
    IGNORE_LATITUDE: Final = 1
    IGNORE_LONGITUDE: Final = 2
    IGNORE_ALTITUDE: Final = 4
    IGNORE_VX: Final = 8
    IGNORE_VY: Final = 16
    IGNORE_VZ: Final = 32
    IGNORE_AFX: Final = 64
    IGNORE_AFY: Final = 128
    IGNORE_AFZ: Final = 256
    FORCE: Final = 512
    IGNORE_YAW: Final = 1024
    IGNORE_YAW_RATE: Final = 2048
    def __init__(self, *, header: std_msgs.msg.Header = ..., coordinate_frame: int = ..., type_mask: int = ..., latitude: float = ..., longitude: float = ..., altitude: float = ..., velocity: geometry_msgs.msg.Vector3 = ..., acceleration_or_force: geometry_msgs.msg.Vector3 = ..., yaw: float = ..., yaw_rate: float = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    coordinate_frame: int
    type_mask: int
    latitude: float
    longitude: float
    altitude: float
    velocity: geometry_msgs.msg.Vector3
    acceleration_or_force: geometry_msgs.msg.Vector3
    yaw: float
    yaw_rate: float

class HilActuatorControls(Message):
    """mavros_msgs/msg/HilActuatorControls

    std_msgs/Header header
    float32[16] controls
    uint8 mode
    uint64 flags
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., controls: Collection[float] = ..., mode: int = ..., flags: int = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    @property
    def controls(self) -> NDArray[numpy.float32]: ...
    @controls.setter
    def controls(self, value: Collection[float]) -> None: ...
    mode: int
    flags: int

class HilControls(Message):
    """mavros_msgs/msg/HilControls

    std_msgs/Header header
    float32 roll_ailerons
    float32 pitch_elevator
    float32 yaw_rudder
    float32 throttle
    float32 aux1
    float32 aux2
    float32 aux3
    float32 aux4
    uint8 mode
    uint8 nav_mode
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., roll_ailerons: float = ..., pitch_elevator: float = ..., yaw_rudder: float = ..., throttle: float = ..., aux1: float = ..., aux2: float = ..., aux3: float = ..., aux4: float = ..., mode: int = ..., nav_mode: int = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    roll_ailerons: float
    pitch_elevator: float
    yaw_rudder: float
    throttle: float
    aux1: float
    aux2: float
    aux3: float
    aux4: float
    mode: int
    nav_mode: int

class HilGPS(Message):
    """mavros_msgs/msg/HilGPS

    std_msgs/Header header
    uint8 fix_type
    geographic_msgs/GeoPoint geo
    uint16 eph
    uint16 epv
    uint16 vel
    int16 vn
    int16 ve
    int16 vd
    uint16 cog
    uint8 satellites_visible
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., fix_type: int = ..., geo: geographic_msgs.msg.GeoPoint = ..., eph: int = ..., epv: int = ..., vel: int = ..., vn: int = ..., ve: int = ..., vd: int = ..., cog: int = ..., satellites_visible: int = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    fix_type: int
    geo: geographic_msgs.msg.GeoPoint
    eph: int
    epv: int
    vel: int
    vn: int
    ve: int
    vd: int
    cog: int
    satellites_visible: int

class HilSensor(Message):
    """mavros_msgs/msg/HilSensor

    std_msgs/Header header
    geometry_msgs/Vector3 acc
    geometry_msgs/Vector3 gyro
    geometry_msgs/Vector3 mag
    float32 abs_pressure
    float32 diff_pressure
    float32 pressure_alt
    float32 temperature
    uint32 fields_updated
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., acc: geometry_msgs.msg.Vector3 = ..., gyro: geometry_msgs.msg.Vector3 = ..., mag: geometry_msgs.msg.Vector3 = ..., abs_pressure: float = ..., diff_pressure: float = ..., pressure_alt: float = ..., temperature: float = ..., fields_updated: int = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    acc: geometry_msgs.msg.Vector3
    gyro: geometry_msgs.msg.Vector3
    mag: geometry_msgs.msg.Vector3
    abs_pressure: float
    diff_pressure: float
    pressure_alt: float
    temperature: float
    fields_updated: int

class HilStateQuaternion(Message):
    """mavros_msgs/msg/HilStateQuaternion

    std_msgs/Header header
    geometry_msgs/Quaternion orientation
    geometry_msgs/Vector3 angular_velocity
    geometry_msgs/Vector3 linear_acceleration
    geometry_msgs/Vector3 linear_velocity
    geographic_msgs/GeoPoint geo
    float32 ind_airspeed
    float32 true_airspeed
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., orientation: geometry_msgs.msg.Quaternion = ..., angular_velocity: geometry_msgs.msg.Vector3 = ..., linear_acceleration: geometry_msgs.msg.Vector3 = ..., linear_velocity: geometry_msgs.msg.Vector3 = ..., geo: geographic_msgs.msg.GeoPoint = ..., ind_airspeed: float = ..., true_airspeed: float = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    orientation: geometry_msgs.msg.Quaternion
    angular_velocity: geometry_msgs.msg.Vector3
    linear_acceleration: geometry_msgs.msg.Vector3
    linear_velocity: geometry_msgs.msg.Vector3
    geo: geographic_msgs.msg.GeoPoint
    ind_airspeed: float
    true_airspeed: float

class HomePosition(Message):
    """mavros_msgs/msg/HomePosition

    std_msgs/Header header
    geographic_msgs/GeoPoint geo
    geometry_msgs/Point position
    geometry_msgs/Quaternion orientation
    geometry_msgs/Vector3 approach
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., geo: geographic_msgs.msg.GeoPoint = ..., position: geometry_msgs.msg.Point = ..., orientation: geometry_msgs.msg.Quaternion = ..., approach: geometry_msgs.msg.Vector3 = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    geo: geographic_msgs.msg.GeoPoint
    position: geometry_msgs.msg.Point
    orientation: geometry_msgs.msg.Quaternion
    approach: geometry_msgs.msg.Vector3

class LandingTarget(Message):
    """mavros_msgs/msg/LandingTarget

    std_msgs/Header header
    uint8 GLOBAL=0
    uint8 LOCAL_NED=2
    uint8 MISSION=3
    uint8 GLOBAL_RELATIVE_ALT=4
    uint8 LOCAL_ENU=5
    uint8 GLOBAL_INT=6
    uint8 GLOBAL_RELATIVE_ALT_INT=7
    uint8 LOCAL_OFFSET_NED=8
    uint8 BODY_NED=9
    uint8 BODY_OFFSET_NED=10
    uint8 GLOBAL_TERRAIN_ALT=11
    uint8 GLOBAL_TERRAIN_ALT_INT=12
    uint8 LIGHT_BEACON=0
    uint8 RADIO_BEACON=1
    uint8 VISION_FIDUCIAL=2
    uint8 VISION_OTHER=3
    uint8 target_num
    uint8 frame
    float32[2] angle
    float32 distance
    float32[2] size
    geometry_msgs/Pose pose
    uint8 type
    """
    GLOBAL: Final = 0
    LOCAL_NED: Final = 2
    MISSION: Final = 3
    GLOBAL_RELATIVE_ALT: Final = 4
    LOCAL_ENU: Final = 5
    GLOBAL_INT: Final = 6
    GLOBAL_RELATIVE_ALT_INT: Final = 7
    LOCAL_OFFSET_NED: Final = 8
    BODY_NED: Final = 9
    BODY_OFFSET_NED: Final = 10
    GLOBAL_TERRAIN_ALT: Final = 11
    GLOBAL_TERRAIN_ALT_INT: Final = 12
    LIGHT_BEACON: Final = 0
    RADIO_BEACON: Final = 1
    VISION_FIDUCIAL: Final = 2
    VISION_OTHER: Final = 3
    def __init__(self, *, header: std_msgs.msg.Header = ..., target_num: int = ..., frame: int = ..., angle: Collection[float] = ..., distance: float = ..., size: Collection[float] = ..., pose: geometry_msgs.msg.Pose = ..., type: int = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    target_num: int
    frame: int
    @property
    def angle(self) -> NDArray[numpy.float32]: ...
    @angle.setter
    def angle(self, value: Collection[float]) -> None: ...
    distance: float
    @property
    def size(self) -> NDArray[numpy.float32]: ...
    @size.setter
    def size(self, value: Collection[float]) -> None: ...
    pose: geometry_msgs.msg.Pose
    type: int

class LogData(Message):
    """mavros_msgs/msg/LogData

    std_msgs/Header header
    uint16 id
    uint32 offset
    uint8[] data
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., id: int = ..., offset: int = ..., data: Collection[int] = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    id: int
    offset: int
    @property
    def data(self) -> array[int]: ...
    @data.setter
    def data(self, value: Collection[int]) -> None: ...

class LogEntry(Message):
    """mavros_msgs/msg/LogEntry

    std_msgs/Header header
    uint16 id
    uint16 num_logs
    uint16 last_log_num
    builtin_interfaces/Time time_utc
    uint32 size
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., id: int = ..., num_logs: int = ..., last_log_num: int = ..., time_utc: builtin_interfaces.msg.Time = ..., size: int = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    id: int
    num_logs: int
    last_log_num: int
    time_utc: builtin_interfaces.msg.Time
    size: int

class MagnetometerReporter(Message):
    """mavros_msgs/msg/MagnetometerReporter

    std_msgs/Header header
    uint8 report
    float32 confidence
    uint8 compass_id
    uint8 cal_mask
    uint8 cal_status
    uint8 autosaved
    float32 fitness
    float32 ofs_x
    float32 ofs_y
    float32 ofs_z
    float32 diag_x
    float32 diag_y
    float32 diag_z
    float32 offdiag_x
    float32 offdiag_y
    float32 offdiag_z
    float32 orientation_confidence
    uint8 old_orientation
    uint8 new_orientation
    float32 scale_factor
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., report: int = ..., confidence: float = ..., compass_id: int = ..., cal_mask: int = ..., cal_status: int = ..., autosaved: int = ..., fitness: float = ..., ofs_x: float = ..., ofs_y: float = ..., ofs_z: float = ..., diag_x: float = ..., diag_y: float = ..., diag_z: float = ..., offdiag_x: float = ..., offdiag_y: float = ..., offdiag_z: float = ..., orientation_confidence: float = ..., old_orientation: int = ..., new_orientation: int = ..., scale_factor: float = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    report: int
    confidence: float
    compass_id: int
    cal_mask: int
    cal_status: int
    autosaved: int
    fitness: float
    ofs_x: float
    ofs_y: float
    ofs_z: float
    diag_x: float
    diag_y: float
    diag_z: float
    offdiag_x: float
    offdiag_y: float
    offdiag_z: float
    orientation_confidence: float
    old_orientation: int
    new_orientation: int
    scale_factor: float

class ManualControl(Message):
    """mavros_msgs/msg/ManualControl

    std_msgs/Header header
    float32 x
    float32 y
    float32 z
    float32 r
    uint16 buttons
    uint16 buttons2
    uint8 enabled_extensions
    float32 s
    float32 t
    float32 aux1
    float32 aux2
    float32 aux3
    float32 aux4
    float32 aux5
    float32 aux6
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., x: float = ..., y: float = ..., z: float = ..., r: float = ..., buttons: int = ..., buttons2: int = ..., enabled_extensions: int = ..., s: float = ..., t: float = ..., aux1: float = ..., aux2: float = ..., aux3: float = ..., aux4: float = ..., aux5: float = ..., aux6: float = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    x: float
    y: float
    z: float
    r: float
    buttons: int
    buttons2: int
    enabled_extensions: int
    s: float
    t: float
    aux1: float
    aux2: float
    aux3: float
    aux4: float
    aux5: float
    aux6: float

class Mavlink(Message):
    """mavros_msgs/msg/Mavlink

    uint8 FRAMING_OK=1
    uint8 FRAMING_BAD_CRC=2
    uint8 FRAMING_BAD_SIGNATURE=3
    uint8 MAVLINK_V10=254
    uint8 MAVLINK_V20=253
    std_msgs/Header header
    uint8 framing_status
    uint8 magic
    uint8 len
    uint8 incompat_flags
    uint8 compat_flags
    uint8 seq
    uint8 sysid
    uint8 compid
    uint32 msgid
    uint16 checksum
    uint64[<=33] payload64
    uint8[<=13] signature
    """
    FRAMING_OK: Final = 1
    FRAMING_BAD_CRC: Final = 2
    FRAMING_BAD_SIGNATURE: Final = 3
    MAVLINK_V10: Final = 254
    MAVLINK_V20: Final = 253
    def __init__(self, *, header: std_msgs.msg.Header = ..., framing_status: int = ..., magic: int = ..., len: int = ..., incompat_flags: int = ..., compat_flags: int = ..., seq: int = ..., sysid: int = ..., compid: int = ..., msgid: int = ..., checksum: int = ..., payload64: Collection[int] = ..., signature: Collection[int] = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    framing_status: int
    magic: int
    len: int
    incompat_flags: int
    compat_flags: int
    seq: int
    sysid: int
    compid: int
    msgid: int
    checksum: int
    @property
    def payload64(self) -> array[int]: ...
    @payload64.setter
    def payload64(self, value: Collection[int]) -> None: ...
    @property
    def signature(self) -> array[int]: ...
    @signature.setter
    def signature(self, value: Collection[int]) -> None: ...

class MountControl(Message):
    """mavros_msgs/msg/MountControl

    std_msgs/Header header
    uint8 mode
    uint8 MAV_MOUNT_MODE_RETRACT=0
    uint8 MAV_MOUNT_MODE_NEUTRAL=1
    uint8 MAV_MOUNT_MODE_MAVLINK_TARGETING=2
    uint8 MAV_MOUNT_MODE_RC_TARGETING=3
    uint8 MAV_MOUNT_MODE_GPS_POINT=4
    float32 pitch
    float32 roll
    float32 yaw
    float32 altitude
    float32 latitude
    float32 longitude
    """
    MAV_MOUNT_MODE_RETRACT: Final = 0
    MAV_MOUNT_MODE_NEUTRAL: Final = 1
    MAV_MOUNT_MODE_MAVLINK_TARGETING: Final = 2
    MAV_MOUNT_MODE_RC_TARGETING: Final = 3
    MAV_MOUNT_MODE_GPS_POINT: Final = 4
    def __init__(self, *, header: std_msgs.msg.Header = ..., mode: int = ..., pitch: float = ..., roll: float = ..., yaw: float = ..., altitude: float = ..., latitude: float = ..., longitude: float = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    mode: int
    pitch: float
    roll: float
    yaw: float
    altitude: float
    latitude: float
    longitude: float

class NavControllerOutput(Message):
    """mavros_msgs/msg/NavControllerOutput

    std_msgs/Header header
    float32 nav_roll
    float32 nav_pitch
    int16 nav_bearing
    int16 target_bearing
    uint16 wp_dist
    float32 alt_error
    float32 aspd_error
    float32 xtrack_error
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., nav_roll: float = ..., nav_pitch: float = ..., nav_bearing: int = ..., target_bearing: int = ..., wp_dist: int = ..., alt_error: float = ..., aspd_error: float = ..., xtrack_error: float = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    nav_roll: float
    nav_pitch: float
    nav_bearing: int
    target_bearing: int
    wp_dist: int
    alt_error: float
    aspd_error: float
    xtrack_error: float

class OnboardComputerStatus(Message):
    """mavros_msgs/msg/OnboardComputerStatus

    std_msgs/Header header
    uint8 component
    uint32 uptime
    uint8 type
    uint8[8] cpu_cores
    uint8[10] cpu_combined
    uint8[4] gpu_cores
    uint8[10] gpu_combined
    int8 temperature_board
    int8[8] temperature_core
    int16[4] fan_speed
    uint32 ram_usage
    uint32 ram_total
    uint32[4] storage_type
    uint32[4] storage_usage
    uint32[4] storage_total
    uint32[6] link_type
    uint32[6] link_tx_rate
    uint32[6] link_rx_rate
    uint32[6] link_tx_max
    uint32[6] link_rx_max
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., component: int = ..., uptime: int = ..., type: int = ..., cpu_cores: Collection[int] = ..., cpu_combined: Collection[int] = ..., gpu_cores: Collection[int] = ..., gpu_combined: Collection[int] = ..., temperature_board: int = ..., temperature_core: Collection[int] = ..., fan_speed: Collection[int] = ..., ram_usage: int = ..., ram_total: int = ..., storage_type: Collection[int] = ..., storage_usage: Collection[int] = ..., storage_total: Collection[int] = ..., link_type: Collection[int] = ..., link_tx_rate: Collection[int] = ..., link_rx_rate: Collection[int] = ..., link_tx_max: Collection[int] = ..., link_rx_max: Collection[int] = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    component: int
    uptime: int
    type: int
    @property
    def cpu_cores(self) -> NDArray[numpy.uint8]: ...
    @cpu_cores.setter
    def cpu_cores(self, value: Collection[int]) -> None: ...
    @property
    def cpu_combined(self) -> NDArray[numpy.uint8]: ...
    @cpu_combined.setter
    def cpu_combined(self, value: Collection[int]) -> None: ...
    @property
    def gpu_cores(self) -> NDArray[numpy.uint8]: ...
    @gpu_cores.setter
    def gpu_cores(self, value: Collection[int]) -> None: ...
    @property
    def gpu_combined(self) -> NDArray[numpy.uint8]: ...
    @gpu_combined.setter
    def gpu_combined(self, value: Collection[int]) -> None: ...
    temperature_board: int
    @property
    def temperature_core(self) -> NDArray[numpy.int8]: ...
    @temperature_core.setter
    def temperature_core(self, value: Collection[int]) -> None: ...
    @property
    def fan_speed(self) -> NDArray[numpy.int16]: ...
    @fan_speed.setter
    def fan_speed(self, value: Collection[int]) -> None: ...
    ram_usage: int
    ram_total: int
    @property
    def storage_type(self) -> NDArray[numpy.uint32]: ...
    @storage_type.setter
    def storage_type(self, value: Collection[int]) -> None: ...
    @property
    def storage_usage(self) -> NDArray[numpy.uint32]: ...
    @storage_usage.setter
    def storage_usage(self, value: Collection[int]) -> None: ...
    @property
    def storage_total(self) -> NDArray[numpy.uint32]: ...
    @storage_total.setter
    def storage_total(self, value: Collection[int]) -> None: ...
    @property
    def link_type(self) -> NDArray[numpy.uint32]: ...
    @link_type.setter
    def link_type(self, value: Collection[int]) -> None: ...
    @property
    def link_tx_rate(self) -> NDArray[numpy.uint32]: ...
    @link_tx_rate.setter
    def link_tx_rate(self, value: Collection[int]) -> None: ...
    @property
    def link_rx_rate(self) -> NDArray[numpy.uint32]: ...
    @link_rx_rate.setter
    def link_rx_rate(self, value: Collection[int]) -> None: ...
    @property
    def link_tx_max(self) -> NDArray[numpy.uint32]: ...
    @link_tx_max.setter
    def link_tx_max(self, value: Collection[int]) -> None: ...
    @property
    def link_rx_max(self) -> NDArray[numpy.uint32]: ...
    @link_rx_max.setter
    def link_rx_max(self, value: Collection[int]) -> None: ...

class OpenDroneIDBasicID(Message):
    """mavros_msgs/msg/OpenDroneIDBasicID

    uint8 ID_TYPE_NONE=0
    uint8 ID_TYPE_SERIAL_NUMBER=1
    uint8 ID_TYPE_CAA_REGISTRATION_ID=2
    uint8 ID_TYPE_UTM_ASSIGNED_UUID=3
    uint8 ID_TYPE_SPECIFIC_SESSION_ID=4
    uint8 UA_TYPE_NONE=0
    uint8 UA_TYPE_AEROPLANE=1
    uint8 UA_TYPE_HELICOPTER_OR_MULTIROTOR=2
    uint8 UA_TYPE_GYROPLANE=3
    uint8 UA_TYPE_HYBRID_LIFT=4
    uint8 UA_TYPE_ORNITHOPTER=5
    uint8 UA_TYPE_GLIDER=6
    uint8 UA_TYPE_KITE=7
    uint8 UA_TYPE_FREE_BALLOON=8
    uint8 UA_TYPE_CAPTIVE_BALLOON=9
    uint8 UA_TYPE_AIRSHIP=10
    uint8 UA_TYPE_FREE_FALL_PARACHUTE=11
    uint8 UA_TYPE_ROCKET=12
    uint8 UA_TYPE_TETHERED_POWERED_AIRCRAFT=13
    uint8 UA_TYPE_GROUND_OBSTACLE=14
    uint8 UA_TYPE_OTHER=15
    std_msgs/Header header
    string id_or_mac
    uint8 id_type
    uint8 ua_type
    string uas_id
    """
    ID_TYPE_NONE: Final = 0
    ID_TYPE_SERIAL_NUMBER: Final = 1
    ID_TYPE_CAA_REGISTRATION_ID: Final = 2
    ID_TYPE_UTM_ASSIGNED_UUID: Final = 3
    ID_TYPE_SPECIFIC_SESSION_ID: Final = 4
    UA_TYPE_NONE: Final = 0
    UA_TYPE_AEROPLANE: Final = 1
    UA_TYPE_HELICOPTER_OR_MULTIROTOR: Final = 2
    UA_TYPE_GYROPLANE: Final = 3
    UA_TYPE_HYBRID_LIFT: Final = 4
    UA_TYPE_ORNITHOPTER: Final = 5
    UA_TYPE_GLIDER: Final = 6
    UA_TYPE_KITE: Final = 7
    UA_TYPE_FREE_BALLOON: Final = 8
    UA_TYPE_CAPTIVE_BALLOON: Final = 9
    UA_TYPE_AIRSHIP: Final = 10
    UA_TYPE_FREE_FALL_PARACHUTE: Final = 11
    UA_TYPE_ROCKET: Final = 12
    UA_TYPE_TETHERED_POWERED_AIRCRAFT: Final = 13
    UA_TYPE_GROUND_OBSTACLE: Final = 14
    UA_TYPE_OTHER: Final = 15
    def __init__(self, *, header: std_msgs.msg.Header = ..., id_or_mac: str = ..., id_type: int = ..., ua_type: int = ..., uas_id: str = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    id_or_mac: str
    id_type: int
    ua_type: int
    uas_id: str

class OpenDroneIDOperatorID(Message):
    """mavros_msgs/msg/OpenDroneIDOperatorID

    uint8 ID_TYPE_CAA=0
    std_msgs/Header header
    string id_or_mac
    uint8 operator_id_type
    string operator_id
    """
    ID_TYPE_CAA: Final = 0
    def __init__(self, *, header: std_msgs.msg.Header = ..., id_or_mac: str = ..., operator_id_type: int = ..., operator_id: str = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    id_or_mac: str
    operator_id_type: int
    operator_id: str

class OpenDroneIDSelfID(Message):
    """mavros_msgs/msg/OpenDroneIDSelfID

    uint8 DESC_TYPE_TEXT=0
    uint8 DESC_TYPE_EMERGENCY=1
    uint8 DESC_TYPE_EXTENDED_STATUS=2
    std_msgs/Header header
    string id_or_mac
    uint8 description_type
    string description
    """
    DESC_TYPE_TEXT: Final = 0
    DESC_TYPE_EMERGENCY: Final = 1
    DESC_TYPE_EXTENDED_STATUS: Final = 2
    def __init__(self, *, header: std_msgs.msg.Header = ..., id_or_mac: str = ..., description_type: int = ..., description: str = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    id_or_mac: str
    description_type: int
    description: str

class OpenDroneIDSystem(Message):
    """mavros_msgs/msg/OpenDroneIDSystem

    uint8 LOCATION_TYPE_TAKEOFF=0
    uint8 LOCATION_TYPE_LIVE_GNSS=1
    uint8 LOCATION_TYPE_FIXED=2
    uint8 CLASSIFICATION_TYPE_UNDECLARED=0
    uint8 CLASSIFICATION_TYPE_EU=1
    std_msgs/Header header
    string id_or_mac
    uint8 operator_location_type
    uint8 classification_type
    int32 operator_latitude
    int32 operator_longitude
    uint16 area_count
    uint16 area_radius
    float32 area_ceiling
    float32 area_floor
    uint8 category_eu
    uint8 class_eu
    float32 operator_altitude_geo
    """
    LOCATION_TYPE_TAKEOFF: Final = 0
    LOCATION_TYPE_LIVE_GNSS: Final = 1
    LOCATION_TYPE_FIXED: Final = 2
    CLASSIFICATION_TYPE_UNDECLARED: Final = 0
    CLASSIFICATION_TYPE_EU: Final = 1
    def __init__(self, *, header: std_msgs.msg.Header = ..., id_or_mac: str = ..., operator_location_type: int = ..., classification_type: int = ..., operator_latitude: int = ..., operator_longitude: int = ..., area_count: int = ..., area_radius: int = ..., area_ceiling: float = ..., area_floor: float = ..., category_eu: int = ..., class_eu: int = ..., operator_altitude_geo: float = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    id_or_mac: str
    operator_location_type: int
    classification_type: int
    operator_latitude: int
    operator_longitude: int
    area_count: int
    area_radius: int
    area_ceiling: float
    area_floor: float
    category_eu: int
    class_eu: int
    operator_altitude_geo: float

class OpenDroneIDSystemUpdate(Message):
    """mavros_msgs/msg/OpenDroneIDSystemUpdate

    std_msgs/Header header
    int32 operator_latitude
    int32 operator_longitude
    float32 operator_altitude_geo
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., operator_latitude: int = ..., operator_longitude: int = ..., operator_altitude_geo: float = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    operator_latitude: int
    operator_longitude: int
    operator_altitude_geo: float

class OpticalFlow(Message):
    """mavros_msgs/msg/OpticalFlow

    std_msgs/Header header
    geometry_msgs/Vector3 flow
    geometry_msgs/Vector3 flow_comp_m
    uint8 quality
    float32 ground_distance
    geometry_msgs/Vector3 flow_rate
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., flow: geometry_msgs.msg.Vector3 = ..., flow_comp_m: geometry_msgs.msg.Vector3 = ..., quality: int = ..., ground_distance: float = ..., flow_rate: geometry_msgs.msg.Vector3 = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    flow: geometry_msgs.msg.Vector3
    flow_comp_m: geometry_msgs.msg.Vector3
    quality: int
    ground_distance: float
    flow_rate: geometry_msgs.msg.Vector3

class OpticalFlowRad(Message):
    """mavros_msgs/msg/OpticalFlowRad

    std_msgs/Header header
    uint32 integration_time_us
    float32 integrated_x
    float32 integrated_y
    float32 integrated_xgyro
    float32 integrated_ygyro
    float32 integrated_zgyro
    int16 temperature
    uint8 quality
    uint32 time_delta_distance_us
    float32 distance
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., integration_time_us: int = ..., integrated_x: float = ..., integrated_y: float = ..., integrated_xgyro: float = ..., integrated_ygyro: float = ..., integrated_zgyro: float = ..., temperature: int = ..., quality: int = ..., time_delta_distance_us: int = ..., distance: float = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    integration_time_us: int
    integrated_x: float
    integrated_y: float
    integrated_xgyro: float
    integrated_ygyro: float
    integrated_zgyro: float
    temperature: int
    quality: int
    time_delta_distance_us: int
    distance: float

class OverrideRCIn(Message):
    """mavros_msgs/msg/OverrideRCIn

    uint16 CHAN_RELEASE=0
    uint16 CHAN_NOCHANGE=65535
    uint16[18] channels
    """
    CHAN_RELEASE: Final = 0
    CHAN_NOCHANGE: Final = 65535
    def __init__(self, *, channels: Collection[int] = ..., check_fields: bool = ...) -> None: ...
    @property
    def channels(self) -> NDArray[numpy.uint16]: ...
    @channels.setter
    def channels(self, value: Collection[int]) -> None: ...

class Param(Message):
    """mavros_msgs/msg/Param

    std_msgs/Header header
    string param_id
    mavros_msgs/ParamValue value
    uint16 param_index
    uint16 param_count
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., param_id: str = ..., value: mavros_msgs.msg.ParamValue = ..., param_index: int = ..., param_count: int = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    param_id: str
    value: mavros_msgs.msg.ParamValue
    param_index: int
    param_count: int

class ParamEvent(Message):
    """mavros_msgs/msg/ParamEvent

    std_msgs/Header header
    string param_id
    rcl_interfaces/ParameterValue value
    uint16 param_index
    uint16 param_count
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., param_id: str = ..., value: rcl_interfaces.msg.ParameterValue = ..., param_index: int = ..., param_count: int = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    param_id: str
    value: rcl_interfaces.msg.ParameterValue
    param_index: int
    param_count: int

class ParamValue(Message):
    """mavros_msgs/msg/ParamValue

    int64 integer
    float64 real
    """
    def __init__(self, *, integer: int = ..., real: float = ..., check_fields: bool = ...) -> None: ...
    integer: int
    real: float

class PlayTuneV2(Message):
    """mavros_msgs/msg/PlayTuneV2

    uint8 QBASIC1_1=1
    uint8 MML_MODERN=2
    uint8 format
    string tune
    """
    QBASIC1_1: Final = 1
    MML_MODERN: Final = 2
    def __init__(self, *, format: int = ..., tune: str = ..., check_fields: bool = ...) -> None: ...
    format: int
    tune: str

class PositionTarget(Message):
    """mavros_msgs/msg/PositionTarget

    std_msgs/Header header
    uint8 coordinate_frame
    uint8 FRAME_LOCAL_NED=1
    uint8 FRAME_LOCAL_OFFSET_NED=7
    uint8 FRAME_BODY_NED=8
    uint8 FRAME_BODY_OFFSET_NED=9
    uint16 type_mask
    uint16 IGNORE_PX=1
    uint16 IGNORE_PY=2
    uint16 IGNORE_PZ=4
    uint16 IGNORE_VX=8
    uint16 IGNORE_VY=16
    uint16 IGNORE_VZ=32
    uint16 IGNORE_AFX=64
    uint16 IGNORE_AFY=128
    uint16 IGNORE_AFZ=256
    uint16 FORCE=512
    uint16 IGNORE_YAW=1024
    uint16 IGNORE_YAW_RATE=2048
    geometry_msgs/Point position
    geometry_msgs/Vector3 velocity
    geometry_msgs/Vector3 acceleration_or_force
    float32 yaw
    float32 yaw_rate
    """
    FRAME_LOCAL_NED: Final = 1
    FRAME_LOCAL_OFFSET_NED: Final = 7
    FRAME_BODY_NED: Final = 8
    FRAME_BODY_OFFSET_NED: Final = 9
    IGNORE_PX: Final = 1
    IGNORE_PY: Final = 2
    IGNORE_PZ: Final = 4
    IGNORE_VX: Final = 8
    IGNORE_VY: Final = 16
    IGNORE_VZ: Final = 32
    IGNORE_AFX: Final = 64
    IGNORE_AFY: Final = 128
    IGNORE_AFZ: Final = 256
    FORCE: Final = 512
    IGNORE_YAW: Final = 1024
    IGNORE_YAW_RATE: Final = 2048
    def __init__(self, *, header: std_msgs.msg.Header = ..., coordinate_frame: int = ..., type_mask: int = ..., position: geometry_msgs.msg.Point = ..., velocity: geometry_msgs.msg.Vector3 = ..., acceleration_or_force: geometry_msgs.msg.Vector3 = ..., yaw: float = ..., yaw_rate: float = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    coordinate_frame: int
    type_mask: int
    position: geometry_msgs.msg.Point
    velocity: geometry_msgs.msg.Vector3
    acceleration_or_force: geometry_msgs.msg.Vector3
    yaw: float
    yaw_rate: float

class RCIn(Message):
    """mavros_msgs/msg/RCIn

    std_msgs/Header header
    uint8 rssi
    uint16[] channels
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., rssi: int = ..., channels: Collection[int] = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    rssi: int
    @property
    def channels(self) -> array[int]: ...
    @channels.setter
    def channels(self, value: Collection[int]) -> None: ...

class RCOut(Message):
    """mavros_msgs/msg/RCOut

    std_msgs/Header header
    uint16[] channels
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., channels: Collection[int] = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    @property
    def channels(self) -> array[int]: ...
    @channels.setter
    def channels(self, value: Collection[int]) -> None: ...

class RTCM(Message):
    """mavros_msgs/msg/RTCM

    std_msgs/Header header
    uint8[] data
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., data: Collection[int] = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    @property
    def data(self) -> array[int]: ...
    @data.setter
    def data(self, value: Collection[int]) -> None: ...

class RTKBaseline(Message):
    """mavros_msgs/msg/RTKBaseline

    std_msgs/Header header
    uint32 time_last_baseline_ms
    uint8 rtk_receiver_id
    uint16 wn
    uint32 tow
    uint8 rtk_health
    uint8 rtk_rate
    uint8 nsats
    uint8 baseline_coords_type
    uint8 RTK_BASELINE_COORDINATE_SYSTEM_ECEF=0
    uint8 RTK_BASELINE_COORDINATE_SYSTEM_NED=1
    int32 baseline_a_mm
    int32 baseline_b_mm
    int32 baseline_c_mm
    uint32 accuracy
    int32 iar_num_hypotheses
    """
    RTK_BASELINE_COORDINATE_SYSTEM_ECEF: Final = 0
    RTK_BASELINE_COORDINATE_SYSTEM_NED: Final = 1
    def __init__(self, *, header: std_msgs.msg.Header = ..., time_last_baseline_ms: int = ..., rtk_receiver_id: int = ..., wn: int = ..., tow: int = ..., rtk_health: int = ..., rtk_rate: int = ..., nsats: int = ..., baseline_coords_type: int = ..., baseline_a_mm: int = ..., baseline_b_mm: int = ..., baseline_c_mm: int = ..., accuracy: int = ..., iar_num_hypotheses: int = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    time_last_baseline_ms: int
    rtk_receiver_id: int
    wn: int
    tow: int
    rtk_health: int
    rtk_rate: int
    nsats: int
    baseline_coords_type: int
    baseline_a_mm: int
    baseline_b_mm: int
    baseline_c_mm: int
    accuracy: int
    iar_num_hypotheses: int

class RadioStatus(Message):
    """mavros_msgs/msg/RadioStatus

    std_msgs/Header header
    uint8 rssi
    uint8 remrssi
    uint8 txbuf
    uint8 noise
    uint8 remnoise
    uint16 rxerrors
    uint16 fixed
    float32 rssi_dbm
    float32 remrssi_dbm
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., rssi: int = ..., remrssi: int = ..., txbuf: int = ..., noise: int = ..., remnoise: int = ..., rxerrors: int = ..., fixed: int = ..., rssi_dbm: float = ..., remrssi_dbm: float = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    rssi: int
    remrssi: int
    txbuf: int
    noise: int
    remnoise: int
    rxerrors: int
    fixed: int
    rssi_dbm: float
    remrssi_dbm: float

class State(Message):
    """mavros_msgs/msg/State

    std_msgs/Header header
    bool connected
    bool armed
    bool guided
    bool manual_input
    string mode
    uint8 system_status
    string MODE_APM_PLANE_MANUAL=MANUAL
    string MODE_APM_PLANE_CIRCLE=CIRCLE
    string MODE_APM_PLANE_STABILIZE=STABILIZE
    string MODE_APM_PLANE_TRAINING=TRAINING
    string MODE_APM_PLANE_ACRO=ACRO
    string MODE_APM_PLANE_FBWA=FBWA
    string MODE_APM_PLANE_FBWB=FBWB
    string MODE_APM_PLANE_CRUISE=CRUISE
    string MODE_APM_PLANE_AUTOTUNE=AUTOTUNE
    string MODE_APM_PLANE_AUTO=AUTO
    string MODE_APM_PLANE_RTL=RTL
    string MODE_APM_PLANE_LOITER=LOITER
    string MODE_APM_PLANE_LAND=LAND
    string MODE_APM_PLANE_GUIDED=GUIDED
    string MODE_APM_PLANE_INITIALISING=INITIALISING
    string MODE_APM_PLANE_QSTABILIZE=QSTABILIZE
    string MODE_APM_PLANE_QHOVER=QHOVER
    string MODE_APM_PLANE_QLOITER=QLOITER
    string MODE_APM_PLANE_QLAND=QLAND
    string MODE_APM_PLANE_QRTL=QRTL
    string MODE_APM_COPTER_STABILIZE=STABILIZE
    string MODE_APM_COPTER_ACRO=ACRO
    string MODE_APM_COPTER_ALT_HOLD=ALT_HOLD
    string MODE_APM_COPTER_AUTO=AUTO
    string MODE_APM_COPTER_GUIDED=GUIDED
    string MODE_APM_COPTER_LOITER=LOITER
    string MODE_APM_COPTER_RTL=RTL
    string MODE_APM_COPTER_CIRCLE=CIRCLE
    string MODE_APM_COPTER_POSITION=POSITION
    string MODE_APM_COPTER_LAND=LAND
    string MODE_APM_COPTER_OF_LOITER=OF_LOITER
    string MODE_APM_COPTER_DRIFT=DRIFT
    string MODE_APM_COPTER_SPORT=SPORT
    string MODE_APM_COPTER_FLIP=FLIP
    string MODE_APM_COPTER_AUTOTUNE=AUTOTUNE
    string MODE_APM_COPTER_POSHOLD=POSHOLD
    string MODE_APM_COPTER_BRAKE=BRAKE
    string MODE_APM_COPTER_THROW=THROW
    string MODE_APM_COPTER_AVOID_ADSB=AVOID_ADSB
    string MODE_APM_COPTER_GUIDED_NOGPS=GUIDED_NOGPS
    string MODE_APM_ROVER_MANUAL=MANUAL
    string MODE_APM_ROVER_LEARNING=LEARNING
    string MODE_APM_ROVER_STEERING=STEERING
    string MODE_APM_ROVER_HOLD=HOLD
    string MODE_APM_ROVER_AUTO=AUTO
    string MODE_APM_ROVER_RTL=RTL
    string MODE_APM_ROVER_GUIDED=GUIDED
    string MODE_APM_ROVER_INITIALISING=INITIALISING
    string MODE_PX4_MANUAL=MANUAL
    string MODE_PX4_ACRO=ACRO
    string MODE_PX4_ALTITUDE=ALTCTL
    string MODE_PX4_POSITION=POSCTL
    string MODE_PX4_OFFBOARD=OFFBOARD
    string MODE_PX4_STABILIZED=STABILIZED
    string MODE_PX4_RATTITUDE=RATTITUDE
    string MODE_PX4_MISSION=AUTO.MISSION
    string MODE_PX4_LOITER=AUTO.LOITER
    string MODE_PX4_RTL=AUTO.RTL
    string MODE_PX4_LAND=AUTO.LAND
    string MODE_PX4_RTGS=AUTO.RTGS
    string MODE_PX4_READY=AUTO.READY
    string MODE_PX4_TAKEOFF=AUTO.TAKEOFF
    """
    MODE_APM_PLANE_MANUAL: Final = 'MANUAL'
    MODE_APM_PLANE_CIRCLE: Final = 'CIRCLE'
    MODE_APM_PLANE_STABILIZE: Final = 'STABILIZE'
    MODE_APM_PLANE_TRAINING: Final = 'TRAINING'
    MODE_APM_PLANE_ACRO: Final = 'ACRO'
    MODE_APM_PLANE_FBWA: Final = 'FBWA'
    MODE_APM_PLANE_FBWB: Final = 'FBWB'
    MODE_APM_PLANE_CRUISE: Final = 'CRUISE'
    MODE_APM_PLANE_AUTOTUNE: Final = 'AUTOTUNE'
    MODE_APM_PLANE_AUTO: Final = 'AUTO'
    MODE_APM_PLANE_RTL: Final = 'RTL'
    MODE_APM_PLANE_LOITER: Final = 'LOITER'
    MODE_APM_PLANE_LAND: Final = 'LAND'
    MODE_APM_PLANE_GUIDED: Final = 'GUIDED'
    MODE_APM_PLANE_INITIALISING: Final = 'INITIALISING'
    MODE_APM_PLANE_QSTABILIZE: Final = 'QSTABILIZE'
    MODE_APM_PLANE_QHOVER: Final = 'QHOVER'
    MODE_APM_PLANE_QLOITER: Final = 'QLOITER'
    MODE_APM_PLANE_QLAND: Final = 'QLAND'
    MODE_APM_PLANE_QRTL: Final = 'QRTL'
    MODE_APM_COPTER_STABILIZE: Final = 'STABILIZE'
    MODE_APM_COPTER_ACRO: Final = 'ACRO'
    MODE_APM_COPTER_ALT_HOLD: Final = 'ALT_HOLD'
    MODE_APM_COPTER_AUTO: Final = 'AUTO'
    MODE_APM_COPTER_GUIDED: Final = 'GUIDED'
    MODE_APM_COPTER_LOITER: Final = 'LOITER'
    MODE_APM_COPTER_RTL: Final = 'RTL'
    MODE_APM_COPTER_CIRCLE: Final = 'CIRCLE'
    MODE_APM_COPTER_POSITION: Final = 'POSITION'
    MODE_APM_COPTER_LAND: Final = 'LAND'
    MODE_APM_COPTER_OF_LOITER: Final = 'OF_LOITER'
    MODE_APM_COPTER_DRIFT: Final = 'DRIFT'
    MODE_APM_COPTER_SPORT: Final = 'SPORT'
    MODE_APM_COPTER_FLIP: Final = 'FLIP'
    MODE_APM_COPTER_AUTOTUNE: Final = 'AUTOTUNE'
    MODE_APM_COPTER_POSHOLD: Final = 'POSHOLD'
    MODE_APM_COPTER_BRAKE: Final = 'BRAKE'
    MODE_APM_COPTER_THROW: Final = 'THROW'
    MODE_APM_COPTER_AVOID_ADSB: Final = 'AVOID_ADSB'
    MODE_APM_COPTER_GUIDED_NOGPS: Final = 'GUIDED_NOGPS'
    MODE_APM_ROVER_MANUAL: Final = 'MANUAL'
    MODE_APM_ROVER_LEARNING: Final = 'LEARNING'
    MODE_APM_ROVER_STEERING: Final = 'STEERING'
    MODE_APM_ROVER_HOLD: Final = 'HOLD'
    MODE_APM_ROVER_AUTO: Final = 'AUTO'
    MODE_APM_ROVER_RTL: Final = 'RTL'
    MODE_APM_ROVER_GUIDED: Final = 'GUIDED'
    MODE_APM_ROVER_INITIALISING: Final = 'INITIALISING'
    MODE_PX4_MANUAL: Final = 'MANUAL'
    MODE_PX4_ACRO: Final = 'ACRO'
    MODE_PX4_ALTITUDE: Final = 'ALTCTL'
    MODE_PX4_POSITION: Final = 'POSCTL'
    MODE_PX4_OFFBOARD: Final = 'OFFBOARD'
    MODE_PX4_STABILIZED: Final = 'STABILIZED'
    MODE_PX4_RATTITUDE: Final = 'RATTITUDE'
    MODE_PX4_MISSION: Final = 'AUTO.MISSION'
    MODE_PX4_LOITER: Final = 'AUTO.LOITER'
    MODE_PX4_RTL: Final = 'AUTO.RTL'
    MODE_PX4_LAND: Final = 'AUTO.LAND'
    MODE_PX4_RTGS: Final = 'AUTO.RTGS'
    MODE_PX4_READY: Final = 'AUTO.READY'
    MODE_PX4_TAKEOFF: Final = 'AUTO.TAKEOFF'
    def __init__(self, *, header: std_msgs.msg.Header = ..., connected: bool = ..., armed: bool = ..., guided: bool = ..., manual_input: bool = ..., mode: str = ..., system_status: int = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    connected: bool
    armed: bool
    guided: bool
    manual_input: bool
    mode: str
    system_status: int

class StatusEvent(Message):
    """mavros_msgs/msg/StatusEvent

    uint8 EMERGENCY=0
    uint8 ALERT=1
    uint8 CRITICAL=2
    uint8 ERROR=3
    uint8 WARNING=4
    uint8 NOTICE=5
    uint8 INFO=6
    uint8 DEBUG=7
    std_msgs/Header header
    uint8 severity
    uint32 px4_id
    uint8[40] arguments
    uint16 sequence
    """
    EMERGENCY: Final = 0
    ALERT: Final = 1
    CRITICAL: Final = 2
    ERROR: Final = 3
    WARNING: Final = 4
    NOTICE: Final = 5
    INFO: Final = 6
    DEBUG: Final = 7
    def __init__(self, *, header: std_msgs.msg.Header = ..., severity: int = ..., px4_id: int = ..., arguments: Collection[int] = ..., sequence: int = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    severity: int
    px4_id: int
    @property
    def arguments(self) -> NDArray[numpy.uint8]: ...
    @arguments.setter
    def arguments(self, value: Collection[int]) -> None: ...
    sequence: int

class StatusText(Message):
    """mavros_msgs/msg/StatusText

    uint8 EMERGENCY=0
    uint8 ALERT=1
    uint8 CRITICAL=2
    uint8 ERROR=3
    uint8 WARNING=4
    uint8 NOTICE=5
    uint8 INFO=6
    uint8 DEBUG=7
    std_msgs/Header header
    uint8 severity
    string text
    """
    EMERGENCY: Final = 0
    ALERT: Final = 1
    CRITICAL: Final = 2
    ERROR: Final = 3
    WARNING: Final = 4
    NOTICE: Final = 5
    INFO: Final = 6
    DEBUG: Final = 7
    def __init__(self, *, header: std_msgs.msg.Header = ..., severity: int = ..., text: str = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    severity: int
    text: str

class SysStatus(Message):
    """mavros_msgs/msg/SysStatus

    std_msgs/Header header
    uint32 sensors_present
    uint32 sensors_enabled
    uint32 sensors_health
    uint16 load
    uint16 voltage_battery
    int16 current_battery
    int8 battery_remaining
    uint16 drop_rate_comm
    uint16 errors_comm
    uint16 errors_count1
    uint16 errors_count2
    uint16 errors_count3
    uint16 errors_count4
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., sensors_present: int = ..., sensors_enabled: int = ..., sensors_health: int = ..., load: int = ..., voltage_battery: int = ..., current_battery: int = ..., battery_remaining: int = ..., drop_rate_comm: int = ..., errors_comm: int = ..., errors_count1: int = ..., errors_count2: int = ..., errors_count3: int = ..., errors_count4: int = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    sensors_present: int
    sensors_enabled: int
    sensors_health: int
    load: int
    voltage_battery: int
    current_battery: int
    battery_remaining: int
    drop_rate_comm: int
    errors_comm: int
    errors_count1: int
    errors_count2: int
    errors_count3: int
    errors_count4: int

class TerrainReport(Message):
    """mavros_msgs/msg/TerrainReport

    std_msgs/Header header
    float64 latitude
    float64 longitude
    uint16 spacing
    float32 terrain_height
    float32 current_height
    uint16 pending
    uint16 loaded
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., latitude: float = ..., longitude: float = ..., spacing: int = ..., terrain_height: float = ..., current_height: float = ..., pending: int = ..., loaded: int = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    latitude: float
    longitude: float
    spacing: int
    terrain_height: float
    current_height: float
    pending: int
    loaded: int

class Thrust(Message):
    """mavros_msgs/msg/Thrust

    std_msgs/Header header
    float32 thrust
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., thrust: float = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    thrust: float

class TimesyncStatus(Message):
    """mavros_msgs/msg/TimesyncStatus

    std_msgs/Header header
    uint64 remote_timestamp_ns
    int64 observed_offset_ns
    int64 estimated_offset_ns
    float32 round_trip_time_ms
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., remote_timestamp_ns: int = ..., observed_offset_ns: int = ..., estimated_offset_ns: int = ..., round_trip_time_ms: float = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    remote_timestamp_ns: int
    observed_offset_ns: int
    estimated_offset_ns: int
    round_trip_time_ms: float

class Trajectory(Message):
    """mavros_msgs/msg/Trajectory

    std_msgs/Header header
    uint8 type
    uint8 MAV_TRAJECTORY_REPRESENTATION_WAYPOINTS=0
    uint8 MAV_TRAJECTORY_REPRESENTATION_BEZIER=1
    mavros_msgs/PositionTarget point_1
    mavros_msgs/PositionTarget point_2
    mavros_msgs/PositionTarget point_3
    mavros_msgs/PositionTarget point_4
    mavros_msgs/PositionTarget point_5
    uint8[5] point_valid
    uint16[5] command
    float32[5] time_horizon
    """
    MAV_TRAJECTORY_REPRESENTATION_WAYPOINTS: Final = 0
    MAV_TRAJECTORY_REPRESENTATION_BEZIER: Final = 1
    def __init__(self, *, header: std_msgs.msg.Header = ..., type: int = ..., point_1: mavros_msgs.msg.PositionTarget = ..., point_2: mavros_msgs.msg.PositionTarget = ..., point_3: mavros_msgs.msg.PositionTarget = ..., point_4: mavros_msgs.msg.PositionTarget = ..., point_5: mavros_msgs.msg.PositionTarget = ..., point_valid: Collection[int] = ..., command: Collection[int] = ..., time_horizon: Collection[float] = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    type: int
    point_1: mavros_msgs.msg.PositionTarget
    point_2: mavros_msgs.msg.PositionTarget
    point_3: mavros_msgs.msg.PositionTarget
    point_4: mavros_msgs.msg.PositionTarget
    point_5: mavros_msgs.msg.PositionTarget
    @property
    def point_valid(self) -> NDArray[numpy.uint8]: ...
    @point_valid.setter
    def point_valid(self, value: Collection[int]) -> None: ...
    @property
    def command(self) -> NDArray[numpy.uint16]: ...
    @command.setter
    def command(self, value: Collection[int]) -> None: ...
    @property
    def time_horizon(self) -> NDArray[numpy.float32]: ...
    @time_horizon.setter
    def time_horizon(self, value: Collection[float]) -> None: ...

class Tunnel(Message):
    """mavros_msgs/msg/Tunnel

    uint8 target_system
    uint8 target_component
    uint16 payload_type
    uint8 payload_length
    uint8[128] payload
    uint16 PAYLOAD_TYPE_UNKNOWN=0
    uint16 PAYLOAD_TYPE_STORM32_RESERVED0=200
    uint16 PAYLOAD_TYPE_STORM32_RESERVED1=201
    uint16 PAYLOAD_TYPE_STORM32_RESERVED2=202
    uint16 PAYLOAD_TYPE_STORM32_RESERVED3=203
    uint16 PAYLOAD_TYPE_STORM32_RESERVED4=204
    uint16 PAYLOAD_TYPE_STORM32_RESERVED5=205
    uint16 PAYLOAD_TYPE_STORM32_RESERVED6=206
    uint16 PAYLOAD_TYPE_STORM32_RESERVED7=207
    uint16 PAYLOAD_TYPE_STORM32_RESERVED8=208
    uint16 PAYLOAD_TYPE_STORM32_RESERVED9=209
    """
    PAYLOAD_TYPE_UNKNOWN: Final = 0
    PAYLOAD_TYPE_STORM32_RESERVED0: Final = 200
    PAYLOAD_TYPE_STORM32_RESERVED1: Final = 201
    PAYLOAD_TYPE_STORM32_RESERVED2: Final = 202
    PAYLOAD_TYPE_STORM32_RESERVED3: Final = 203
    PAYLOAD_TYPE_STORM32_RESERVED4: Final = 204
    PAYLOAD_TYPE_STORM32_RESERVED5: Final = 205
    PAYLOAD_TYPE_STORM32_RESERVED6: Final = 206
    PAYLOAD_TYPE_STORM32_RESERVED7: Final = 207
    PAYLOAD_TYPE_STORM32_RESERVED8: Final = 208
    PAYLOAD_TYPE_STORM32_RESERVED9: Final = 209
    def __init__(self, *, target_system: int = ..., target_component: int = ..., payload_type: int = ..., payload_length: int = ..., payload: Collection[int] = ..., check_fields: bool = ...) -> None: ...
    target_system: int
    target_component: int
    payload_type: int
    payload_length: int
    @property
    def payload(self) -> NDArray[numpy.uint8]: ...
    @payload.setter
    def payload(self, value: Collection[int]) -> None: ...

class VehicleInfo(Message):
    """mavros_msgs/msg/VehicleInfo

    std_msgs/Header header
    uint8 HAVE_INFO_HEARTBEAT=1
    uint8 HAVE_INFO_AUTOPILOT_VERSION=2
    uint8 available_info
    uint8 sysid
    uint8 compid
    uint8 autopilot
    uint8 type
    uint8 system_status
    uint8 base_mode
    uint32 custom_mode
    string mode
    uint32 mode_id
    uint64 capabilities
    uint32 flight_sw_version
    uint32 middleware_sw_version
    uint32 os_sw_version
    uint32 board_version
    string flight_custom_version
    uint16 vendor_id
    uint16 product_id
    uint64 uid
    """
    HAVE_INFO_HEARTBEAT: Final = 1
    HAVE_INFO_AUTOPILOT_VERSION: Final = 2
    def __init__(self, *, header: std_msgs.msg.Header = ..., available_info: int = ..., sysid: int = ..., compid: int = ..., autopilot: int = ..., type: int = ..., system_status: int = ..., base_mode: int = ..., custom_mode: int = ..., mode: str = ..., mode_id: int = ..., capabilities: int = ..., flight_sw_version: int = ..., middleware_sw_version: int = ..., os_sw_version: int = ..., board_version: int = ..., flight_custom_version: str = ..., vendor_id: int = ..., product_id: int = ..., uid: int = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    available_info: int
    sysid: int
    compid: int
    autopilot: int
    type: int
    system_status: int
    base_mode: int
    custom_mode: int
    mode: str
    mode_id: int
    capabilities: int
    flight_sw_version: int
    middleware_sw_version: int
    os_sw_version: int
    board_version: int
    flight_custom_version: str
    vendor_id: int
    product_id: int
    uid: int

class VfrHud(Message):
    """mavros_msgs/msg/VfrHud

    std_msgs/Header header
    float32 airspeed
    float32 groundspeed
    int16 heading
    float32 throttle
    float32 altitude
    float32 climb
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., airspeed: float = ..., groundspeed: float = ..., heading: int = ..., throttle: float = ..., altitude: float = ..., climb: float = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    airspeed: float
    groundspeed: float
    heading: int
    throttle: float
    altitude: float
    climb: float

class Vibration(Message):
    """mavros_msgs/msg/Vibration

    std_msgs/Header header
    geometry_msgs/Vector3 vibration
    float32[3] clipping
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., vibration: geometry_msgs.msg.Vector3 = ..., clipping: Collection[float] = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    vibration: geometry_msgs.msg.Vector3
    @property
    def clipping(self) -> NDArray[numpy.float32]: ...
    @clipping.setter
    def clipping(self, value: Collection[float]) -> None: ...

class Waypoint(Message):
    """mavros_msgs/msg/Waypoint

    uint8 frame
    uint8 FRAME_GLOBAL=0
    uint8 FRAME_LOCAL_NED=1
    uint8 FRAME_MISSION=2
    uint8 FRAME_GLOBAL_REL_ALT=3
    uint8 FRAME_LOCAL_ENU=4
    uint8 FRAME_GLOBAL_INT=5
    uint8 FRAME_GLOBAL_RELATIVE_ALT_INT=6
    uint8 FRAME_LOCAL_OFFSET_NED=7
    uint8 FRAME_BODY_NED=8
    uint8 FRAME_BODY_OFFSET_NED=9
    uint8 FRAME_GLOBAL_TERRAIN_ALT=10
    uint8 FRAME_GLOBAL_TERRAIN_ALT_INT=11
    uint8 FRAME_BODY_FRD=12
    uint8 FRAME_RESERVED_13=13
    uint8 FRAME_RESERVED_14=14
    uint8 FRAME_RESERVED_15=15
    uint8 FRAME_RESERVED_16=16
    uint8 FRAME_RESERVED_17=17
    uint8 FRAME_RESERVED_18=18
    uint8 FRAME_RESERVED_19=19
    uint8 FRAME_LOCAL_FRD=20
    uint8 FRAME_LOCAL_FLU=21
    uint16 command
    bool is_current
    bool autocontinue
    float32 param1
    float32 param2
    float32 param3
    float32 param4
    float64 x_lat
    float64 y_long
    float64 z_alt
    """
    FRAME_GLOBAL: Final = 0
    FRAME_LOCAL_NED: Final = 1
    FRAME_MISSION: Final = 2
    FRAME_GLOBAL_REL_ALT: Final = 3
    FRAME_LOCAL_ENU: Final = 4
    FRAME_GLOBAL_INT: Final = 5
    FRAME_GLOBAL_RELATIVE_ALT_INT: Final = 6
    FRAME_LOCAL_OFFSET_NED: Final = 7
    FRAME_BODY_NED: Final = 8
    FRAME_BODY_OFFSET_NED: Final = 9
    FRAME_GLOBAL_TERRAIN_ALT: Final = 10
    FRAME_GLOBAL_TERRAIN_ALT_INT: Final = 11
    FRAME_BODY_FRD: Final = 12
    FRAME_RESERVED_13: Final = 13
    FRAME_RESERVED_14: Final = 14
    FRAME_RESERVED_15: Final = 15
    FRAME_RESERVED_16: Final = 16
    FRAME_RESERVED_17: Final = 17
    FRAME_RESERVED_18: Final = 18
    FRAME_RESERVED_19: Final = 19
    FRAME_LOCAL_FRD: Final = 20
    FRAME_LOCAL_FLU: Final = 21
    def __init__(self, *, frame: int = ..., command: int = ..., is_current: bool = ..., autocontinue: bool = ..., param1: float = ..., param2: float = ..., param3: float = ..., param4: float = ..., x_lat: float = ..., y_long: float = ..., z_alt: float = ..., check_fields: bool = ...) -> None: ...
    frame: int
    command: int
    is_current: bool
    autocontinue: bool
    param1: float
    param2: float
    param3: float
    param4: float
    x_lat: float
    y_long: float
    z_alt: float

class WaypointList(Message):
    """mavros_msgs/msg/WaypointList

    uint16 current_seq
    mavros_msgs/Waypoint[] waypoints
    """
    def __init__(self, *, current_seq: int = ..., waypoints: Collection[mavros_msgs.msg.Waypoint] = ..., check_fields: bool = ...) -> None: ...
    current_seq: int
    @property
    def waypoints(self) -> list[mavros_msgs.msg.Waypoint]: ...
    @waypoints.setter
    def waypoints(self, value: Collection[mavros_msgs.msg.Waypoint]) -> None: ...

class WaypointReached(Message):
    """mavros_msgs/msg/WaypointReached

    std_msgs/Header header
    uint16 wp_seq
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., wp_seq: int = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    wp_seq: int

class WheelOdomStamped(Message):
    """mavros_msgs/msg/WheelOdomStamped

    std_msgs/Header header
    float64[] data
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., data: Collection[float] = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    @property
    def data(self) -> array[float]: ...
    @data.setter
    def data(self, value: Collection[float]) -> None: ...
