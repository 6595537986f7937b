# Written by python -m zbot.interfaces.stubs; do not edit.
from array import array
from collections.abc import Collection
from typing import Final, TypeAlias

import numpy
from numpy.typing import NDArray

import builtin_interfaces.msg
import geometry_msgs.msg
import sensor_msgs.msg
import std_msgs.msg
from zbot.interfaces import Action, Message, Service

class BatteryState(Message):
    """sensor_msgs/msg/BatteryState

    # State of a battery. A quantity that nobody measures is NaN.

    # What is happening to the charge
    uint8 POWER_SUPPLY_STATUS_UNKNOWN = 0
    uint8 POWER_SUPPLY_STATUS_CHARGING = 1
    uint8 POWER_SUPPLY_STATUS_DISCHARGING = 2
    uint8 POWER_SUPPLY_STATUS_NOT_CHARGING = 3
    uint8 POWER_SUPPLY_STATUS_FULL = 4

    # How the battery is doing
    uint8 POWER_SUPPLY_HEALTH_UNKNOWN = 0
    uint8 POWER_SUPPLY_HEALTH_GOOD = 1
    uint8 POWER_SUPPLY_HEALTH_OVERHEAT = 2
    uint8 POWER_SUPPLY_HEALTH_DEAD = 3
    uint8 POWER_SUPPLY_HEALTH_OVERVOLTAGE = 4
    uint8 POWER_SUPPLY_HEALTH_UNSPEC_FAILURE = 5
    uint8 POWER_SUPPLY_HEALTH_COLD = 6
    uint8 POWER_SUPPLY_HEALTH_WATCHDOG_TIMER_EXPIRE = 7
    uint8 POWER_SUPPLY_HEALTH_SAFETY_TIMER_EXPIRE = 8

    # What it is made of
    uint8 POWER_SUPPLY_TECHNOLOGY_UNKNOWN = 0
    uint8 POWER_SUPPLY_TECHNOLOGY_NIMH = 1    # nickel-metal hydride
    uint8 POWER_SUPPLY_TECHNOLOGY_LION = 2    # lithium-ion
    uint8 POWER_SUPPLY_TECHNOLOGY_LIPO = 3    # lithium polymer
    uint8 POWER_SUPPLY_TECHNOLOGY_LIFE = 4    # lithium iron phosphate
    uint8 POWER_SUPPLY_TECHNOLOGY_NICD = 5    # nickel-cadmium
    uint8 POWER_SUPPLY_TECHNOLOGY_LIMN = 6    # lithium manganese dioxide
    uint8 POWER_SUPPLY_TECHNOLOGY_TERNARY = 7 # lithium with three further metals
    uint8 POWER_SUPPLY_TECHNOLOGY_VRLA = 8    # sealed lead-acid

    std_msgs/Header  header
    float32 voltage          # V, always given
    float32 temperature      # degrees Celsius
    float32 current          # A, below zero while discharging
    float32 charge           # Ah left
    float32 capacity         # Ah when it was last full
    float32 design_capacity  # Ah when it was new
    float32 percentage       # charge from 0 (empty) to 1 (full)
    uint8   power_supply_status     # one of POWER_SUPPLY_STATUS_...
    uint8   power_supply_health     # one of POWER_SUPPLY_HEALTH_...
    uint8   power_supply_technology # one of POWER_SUPPLY_TECHNOLOGY_...
    bool    present          # is a battery in its slot?

    float32[] cell_voltage   # V of each cell; all NaN if only their number is known
    float32[] cell_temperature # degrees Celsius of each cell; likewise
    string location          # slot or plug
    string serial_number     # as well as it can be told
    """
    POWER_SUPPLY_STATUS_UNKNOWN: Final = 0
    POWER_SUPPLY_STATUS_CHARGING: Final = 1
    POWER_SUPPLY_STATUS_DISCHARGING: Final = 2
    POWER_SUPPLY_STATUS_NOT_CHARGING: Final = 3
    POWER_SUPPLY_STATUS_FULL: Final = 4
    POWER_SUPPLY_HEALTH_UNKNOWN: Final = 0
    POWER_SUPPLY_HEALTH_GOOD: Final = 1
    POWER_SUPPLY_HEALTH_OVERHEAT: Final = 2
    POWER_SUPPLY_HEALTH_DEAD: Final = 3
    POWER_SUPPLY_HEALTH_OVERVOLTAGE: Final = 4
    POWER_SUPPLY_HEALTH_UNSPEC_FAILURE: Final = 5
    POWER_SUPPLY_HEALTH_COLD: Final = 6
    POWER_SUPPLY_HEALTH_WATCHDOG_TIMER_EXPIRE: Final = 7
    POWER_SUPPLY_HEALTH_SAFETY_TIMER_EXPIRE: Final = 8
    POWER_SUPPLY_TECHNOLOGY_UNKNOWN: Final = 0
    POWER_SUPPLY_TECHNOLOGY_NIMH: Final = 1
    POWER_SUPPLY_TECHNOLOGY_LION: Final = 2
    POWER_SUPPLY_TECHNOLOGY_LIPO: Final = 3
    POWER_SUPPLY_TECHNOLOGY_LIFE: Final = 4
    POWER_SUPPLY_TECHNOLOGY_NICD: Final = 5
    POWER_SUPPLY_TECHNOLOGY_LIMN: Final = 6
    POWER_SUPPLY_TECHNOLOGY_TERNARY: Final = 7
    POWER_SUPPLY_TECHNOLOGY_VRLA: Final = 8
    def __init__(self, *, header: std_msgs.msg.Header = ..., voltage: float = ..., temperature: float = ..., current: float = ..., charge: float = ..., capacity: float = ..., design_capacity: float = ..., percentage: float = ..., power_supply_status: int = ..., power_supply_health: int = ..., power_supply_technology: int = ..., present: bool = ..., cell_voltage: Collection[float] = ..., cell_temperature: Collection[float] = ..., location: str = ..., serial_number: str = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    voltage: float
    temperature: float
    current: float
    charge: float
    capacity: float
    design_capacity: float
    percentage: float
    power_supply_status: int
    power_supply_health: int
    power_supply_technology: int
    present: bool
    @property
    def cell_voltage(self) -> array[float]: ...
    @cell_voltage.setter
    def cell_voltage(self, value: Collection[float]) -> None: ...
    @property
    def cell_temperature(self) -> array[float]: ...
    @cell_temperature.setter
    def cell_temperature(self, value: Collection[float]) -> None: ...
    location: str
    serial_number: str

class CameraInfo(Message):
    """sensor_msgs/msg/CameraInfo

    # How a camera maps the world onto its pixels, sent beside each of its images on the topic camera_info.

    # Time of the image and optical frame of the camera: origin in the optical centre,
    # x right, y down, z forward into the scene.
    std_msgs/Header header

    # Calibration: stays the same until the camera is calibrated again.

    # Size in pixels of the images used for the calibration.
    uint32 height
    uint32 width

    # Name of the lens model, for most cameras "plumb_bob" (radial and tangential distortion).
    string distortion_model

    # Parameters of the lens model; for "plumb_bob" the five numbers k1, k2, t1, t2, k3.
    float64[] d

    # Camera matrix of the raw image, row by row: focal lengths fx, fy and image centre cx, cy in pixels.
    #   fx  0 cx
    #    0 fy cy
    #    0  0  1
    # A first element of 0 means that the camera is not calibrated.
    float64[9]  k # 3x3

    # Rotation that brings the two images of a stereo camera into line; identity for a single camera.
    float64[9]  r # 3x3

    # Camera matrix of the rectified image, row by row.
    #   fx'  0 cx' Tx
    #    0 fy' cy' Ty
    #    0   0   1  0
    # A point (X, Y, Z) appears at pixel (u / w, v / w) where (u, v, w) = P (X, Y, Z, 1).
    # Tx and Ty are 0 except in the second camera of a stereo pair; if that is the right one,
    # Tx = -fx' * B with the distance B between the two lenses.
    float64[12] p # 3x4

    # Operation: may change at any time without another calibration.

    # Pixels that the camera joins into one, across and down; 0 counts as 1.
    uint32 binning_x
    uint32 binning_y

    # Part of the sensor that was read, in pixels before joining; all zeros for the whole sensor.
    RegionOfInterest roi
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., height: int = ..., width: int = ..., distortion_model: str = ..., d: Collection[float] = ..., k: Collection[float] = ..., r: Collection[float] = ..., p: Collection[float] = ..., binning_x: int = ..., binning_y: int = ..., roi: sensor_msgs.msg.RegionOfInterest = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    height: int
    width: int
    distortion_model: str
    @property
    def d(self) -> array[float]: ...
    @d.setter
    def d(self, value: Collection[float]) -> None: ...
    @property
    def k(self) -> NDArray[numpy.float64]: ...
    @k.setter
    def k(self, value: Collection[float]) -> None: ...
    @property
    def r(self) -> NDArray[numpy.float64]: ...
    @r.setter
    def r(self, value: Collection[float]) -> None: ...
    @property
    def p(self) -> NDArray[numpy.float64]: ...
    @p.setter
    def p(self, value: Collection[float]) -> None: ...
    binning_x: int
    binning_y: int
    roi: sensor_msgs.msg.RegionOfInterest

class ChannelFloat32(Message):
    """sensor_msgs/msg/ChannelFloat32

    # One extra number for every point of a PointCloud.

    # What the number means: 'intensity', 'distance', 'rgb' (three bytes packed into the lower 24 bits),
    # 'u' and 'v' (row and column in the left stereo image).
    string name

    # One number per point, in the order of the points.
    float32[] values
    """
    def __init__(self, *, name: str = ..., values: Collection[float] = ..., check_fields: bool = ...) -> None: ...
    name: str
    @property
    def values(self) -> array[float]: ...
    @values.setter
    def values(self, value: Collection[float]) -> None: ...

class CompressedImage(Message):
    """sensor_msgs/msg/CompressedImage

    # A picture packed by an image codec such as JPEG or PNG.

    std_msgs/Header header # time of the picture and optical frame of the camera: x right, y down, z forward

    string format                # how data was packed, such as 'jpeg', 'png' or the longer
                                 # 'bgr8; jpeg compressed bgr8': pixels before, codec, pixels inside

    uint8[] data                 # the packed bytes, as they would be in a file
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., format: str = ..., data: Collection[int] = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    format: str
    @property
    def data(self) -> array[int]: ...
    @data.setter
    def data(self, value: Collection[int]) -> None: ...

class FluidPressure(Message):
    """sensor_msgs/msg/FluidPressure

    # Pressure in a gas or liquid, air pressure for instance. Not meant for touch sensors.

    std_msgs/Header header # time of the reading and frame of the sensor

    float64 fluid_pressure       # absolute pressure in Pa

    float64 variance             # Pa^2; 0 if unknown
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., fluid_pressure: float = ..., variance: float = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    fluid_pressure: float
    variance: float

class Illuminance(Message):
    """sensor_msgs/msg/Illuminance

    # Brightness as the human eye sees it. The sensor looks along its x axis.

    std_msgs/Header header # time of the reading and frame of the sensor

    float64 illuminance          # lux, never negative

    float64 variance             # lux^2; 0 if unknown
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., illuminance: float = ..., variance: float = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    illuminance: float
    variance: float

class Image(Message):
    """sensor_msgs/msg/Image

    # A picture, pixel by pixel; row 0 is the top, column 0 the left.

    std_msgs/Header header # time of the picture and optical frame of the camera: x right, y down, z forward

    uint32 height                # rows
    uint32 width                 # pixels per row

    string encoding       # meaning of the bytes of a pixel, such as 'rgb8', 'bgr8', 'mono8' or '16UC1'

    uint8 is_bigendian    # 1 if numbers of several bytes have their highest byte first
    uint32 step           # bytes per row
    uint8[] data          # all rows, one after the other: step * height bytes
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., height: int = ..., width: int = ..., encoding: str = ..., is_bigendian: int = ..., step: int = ..., data: Collection[int] = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    height: int
    width: int
    encoding: str
    is_bigendian: int
    step: int
    @property
    def data(self) -> array[int]: ...
    @data.setter
    def data(self, value: Collection[int]) -> None: ...

class Imu(Message):
    """sensor_msgs/msg/Imu

    # Reading of an inertial measurement unit: how it lies, how it turns and how it speeds up.
    #
    # Each 3x3 covariance belongs to the field before it, row by row over x, y, z. All zeros: unknown.
    # A first element of -1: the sensor does not measure that field, ignore it.

    std_msgs/Header header

    geometry_msgs/Quaternion orientation
    float64[9] orientation_covariance # rad^2

    geometry_msgs/Vector3 angular_velocity # rad/s
    float64[9] angular_velocity_covariance # (rad/s)^2

    geometry_msgs/Vector3 linear_acceleration # m/s^2
    float64[9] linear_acceleration_covariance # (m/s^2)^2
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., orientation: geometry_msgs.msg.Quaternion = ..., orientation_covariance: Collection[float] = ..., angular_velocity: geometry_msgs.msg.Vector3 = ..., angular_velocity_covariance: Collection[float] = ..., linear_acceleration: geometry_msgs.msg.Vector3 = ..., linear_acceleration_covariance: Collection[float] = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    orientation: geometry_msgs.msg.Quaternion
    @property
    def orientation_covariance(self) -> NDArray[numpy.float64]: ...
    @orientation_covariance.setter
    def orientation_covariance(self, value: Collection[float]) -> None: ...
    angular_velocity: geometry_msgs.msg.Vector3
    @property
    def angular_velocity_covariance(self) -> NDArray[numpy.float64]: ...
    @angular_velocity_covariance.setter
    def angular_velocity_covariance(self, value: Collection[float]) -> None: ...
    linear_acceleration: geometry_msgs.msg.Vector3
    @property
    def linear_acceleration_covariance(self) -> NDArray[numpy.float64]: ...
    @linear_acceleration_covariance.setter
    def linear_acceleration_covariance(self, value: Collection[float]) -> None: ...

class JointState(Message):
    """sensor_msgs/msg/JointState

    # Positions, speeds and efforts of a robot's joints at one moment.
    #
    # Entry i of each list belongs to the joint name[i]. A list of something that is not measured stays empty.
    # Turning joints count in rad, rad/s and N*m, sliding joints in m, m/s and N.

    std_msgs/Header header

    string[] name
    float64[] position
    float64[] velocity
    float64[] effort
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., name: Collection[str] = ..., position: Collection[float] = ..., velocity: Collection[float] = ..., effort: Collection[float] = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    @property
    def name(self) -> list[str]: ...
    @name.setter
    def name(self, value: Collection[str]) -> None: ...
    @property
    def position(self) -> array[float]: ...
    @position.setter
    def position(self, value: Collection[float]) -> None: ...
    @property
    def velocity(self) -> array[float]: ...
    @velocity.setter
    def velocity(self, value: Collection[float]) -> None: ...
    @property
    def effort(self) -> array[float]: ...
    @effort.setter
    def effort(self, value: Collection[float]) -> None: ...

class Joy(Message):
    """sensor_msgs/msg/Joy

    # State of a joystick or gamepad.

    # When the state was read.
    std_msgs/Header header

    # Sticks and triggers, each from -1.0 to 1.0.
    float32[] axes

    # Buttons, 1 while pressed.
    int32[] buttons
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., axes: Collection[float] = ..., buttons: Collection[int] = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    @property
    def axes(self) -> array[float]: ...
    @axes.setter
    def axes(self, value: Collection[float]) -> None: ...
    @property
    def buttons(self) -> array[int]: ...
    @buttons.setter
    def buttons(self, value: Collection[int]) -> None: ...

class JoyFeedback(Message):
    """sensor_msgs/msg/JoyFeedback

    # Makes a joystick light up, shake or beep.

    uint8 TYPE_LED    = 0
    uint8 TYPE_RUMBLE = 1
    uint8 TYPE_BUZZER = 2

    uint8 type

    # Which one of that type, counted from 0.
    uint8 id

    # From 0.0 (off) to 1.0 (full); a device that only knows on and off switches at 0.5.
    float32 intensity
    """
    TYPE_LED: Final = 0
    TYPE_RUMBLE: Final = 1
    TYPE_BUZZER: Final = 2
    def __init__(self, *, type: int = ..., id: int = ..., intensity: float = ..., check_fields: bool = ...) -> None: ...
    type: int
    id: int
    intensity: float

class JoyFeedbackArray(Message):
    """sensor_msgs/msg/JoyFeedbackArray

    # Several joystick feedbacks sent together.

    JoyFeedback[] array
    """
    def __init__(self, *, array: Collection[sensor_msgs.msg.JoyFeedback] = ..., check_fields: bool = ...) -> None: ...
    @property
    def array(self) -> list[sensor_msgs.msg.JoyFeedback]: ...
    @array.setter
    def array(self, value: Collection[sensor_msgs.msg.JoyFeedback]) -> None: ...

class LaserEcho(Message):
    """sensor_msgs/msg/LaserEcho

    # All echoes of one laser ray; a part of MultiEchoLaserScan.

    float32[] echoes  # distances in m or intensities
    """
    def __init__(self, *, echoes: Collection[float] = ..., check_fields: bool = ...) -> None: ...
    @property
    def echoes(self) -> array[float]: ...
    @echoes.setter
    def echoes(self, value: Collection[float]) -> None: ...

class LaserScan(Message):
    """sensor_msgs/msg/LaserScan

    # One sweep of a laser scanner: the distance to the nearest obstacle at many angles in a plane.

    std_msgs/Header header # time of the first ray; angles turn counterclockwise about z, 0 is along x

    float32 angle_min            # angle of the first ray [rad]
    float32 angle_max            # angle of the last ray [rad]
    float32 angle_increment      # angle from ray to ray [rad]

    float32 time_increment       # time from ray to ray [s], to correct for a moving scanner
    float32 scan_time            # time from sweep to sweep [s]

    float32 range_min            # shortest distance that can be trusted [m]
    float32 range_max            # longest distance that can be trusted [m]

    float32[] ranges             # a distance per ray [m]; ignore those outside range_min..range_max
    float32[] intensities        # strength of the echo per ray in units of the device, or empty
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., angle_min: float = ..., angle_max: float = ..., angle_increment: float = ..., time_increment: float = ..., scan_time: float = ..., range_min: float = ..., range_max: float = ..., ranges: Collection[float] = ..., intensities: Collection[float] = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    angle_min: float
    angle_max: float
    angle_increment: float
    time_increment: float
    scan_time: float
    range_min: float
    range_max: float
    @property
    def ranges(self) -> array[float]: ...
    @ranges.setter
    def ranges(self, value: Collection[float]) -> None: ...
    @property
    def intensities(self) -> array[float]: ...
    @intensities.setter
    def intensities(self, value: Collection[float]) -> None: ...

class MagneticField(Message):
    """sensor_msgs/msg/MagneticField

    # Reading of a magnetometer, a compass for instance.

    std_msgs/Header header               # time of the reading and frame of the sensor

    geometry_msgs/Vector3 magnetic_field # T; NaN on an axis that is not measured

    float64[9] magnetic_field_covariance       # T^2, 3x3 row by row over x, y, z; all zeros if unknown
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., magnetic_field: geometry_msgs.msg.Vector3 = ..., magnetic_field_covariance: Collection[float] = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    magnetic_field: geometry_msgs.msg.Vector3
    @property
    def magnetic_field_covariance(self) -> NDArray[numpy.float64]: ...
    @magnetic_field_covariance.setter
    def magnetic_field_covariance(self, value: Collection[float]) -> None: ...

class MultiDOFJointState(Message):
    """sensor_msgs/msg/MultiDOFJointState

    # State of joints that move in several directions at once, such as a floating base.
    #
    # Entry i of each list belongs to joint_names[i]; a list that is not measured stays empty.

    std_msgs/Header header

    string[] joint_names
    geometry_msgs/Transform[] transforms # positions
    geometry_msgs/Twist[] twist # speeds
    geometry_msgs/Wrench[] wrench # efforts
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., joint_names: Collection[str] = ..., transforms: Collection[geometry_msgs.msg.Transform] = ..., twist: Collection[geometry_msgs.msg.Twist] = ..., wrench: Collection[geometry_msgs.msg.Wrench] = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    @property
    def joint_names(self) -> list[str]: ...
    @joint_names.setter
    def joint_names(self, value: Collection[str]) -> None: ...
    @property
    def transforms(self) -> list[geometry_msgs.msg.Transform]: ...
    @transforms.setter
    def transforms(self, value: Collection[geometry_msgs.msg.Transform]) -> None: ...
    @property
    def twist(self) -> list[geometry_msgs.msg.Twist]: ...
    @twist.setter
    def twist(self, value: Collection[geometry_msgs.msg.Twist]) -> None: ...
    @property
    def wrench(self) -> list[geometry_msgs.msg.Wrench]: ...
    @wrench.setter
    def wrench(self, value: Collection[geometry_msgs.msg.Wrench]) -> None: ...

class MultiEchoLaserScan(Message):
    """sensor_msgs/msg/MultiEchoLaserScan

    # One sweep of a laser scanner that hears several echoes per ray, through glass or rain for instance.

    std_msgs/Header header # time of the first ray; angles turn counterclockwise about z, 0 is along x

    float32 angle_min            # angle of the first ray [rad]
    float32 angle_max            # angle of the last ray [rad]
    float32 angle_increment      # angle from ray to ray [rad]

    float32 time_increment       # time from ray to ray [s], to correct for a moving scanner
    float32 scan_time            # time from sweep to sweep [s]

    float32 range_min            # shortest distance that can be trusted [m]
    float32 range_max            # longest distance that can be trusted [m]

    LaserEcho[] ranges           # distances per ray [m]; inf: nothing hit, -inf: too close to tell
    LaserEcho[] intensities      # strength of the echoes in units of the device, or empty
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., angle_min: float = ..., angle_max: float = ..., angle_increment: float = ..., time_increment: float = ..., scan_time: float = ..., range_min: float = ..., range_max: float = ..., ranges: Collection[sensor_msgs.msg.LaserEcho] = ..., intensities: Collection[sensor_msgs.msg.LaserEcho] = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    angle_min: float
    angle_max: float
    angle_increment: float
    time_increment: float
    scan_time: float
    range_min: float
    range_max: float
    @property
    def ranges(self) -> list[sensor_msgs.msg.LaserEcho]: ...
    @ranges.setter
    def ranges(self, value: Collection[sensor_msgs.msg.LaserEcho]) -> None: ...
    @property
    def intensities(self) -> list[sensor_msgs.msg.LaserEcho]: ...
    @intensities.setter
    def intensities(self, value: Collection[sensor_msgs.msg.LaserEcho]) -> None: ...

class NavSatFix(Message):
    """sensor_msgs/msg/NavSatFix

    # A position on Earth from GPS or another satellite system, in WGS 84 coordinates.

    # Time of the fix and frame of the antenna.
    std_msgs/Header header

    # How good the fix is.
    NavSatStatus status

    # Degrees, north positive.
    float64 latitude

    # Degrees, east positive.
    float64 longitude

    # m above the WGS 84 ellipsoid (not above the sea); NaN if unknown.
    float64 altitude

    # m^2, 3x3 row by row over east, north, up.
    float64[9] position_covariance

    # How far position_covariance can be trusted: not at all, estimated from the satellite geometry,
    # variances only, or completely.
    uint8 COVARIANCE_TYPE_UNKNOWN = 0
    uint8 COVARIANCE_TYPE_APPROXIMATED = 1
    uint8 COVARIANCE_TYPE_DIAGONAL_KNOWN = 2
    uint8 COVARIANCE_TYPE_KNOWN = 3

    uint8 position_covariance_type
    """
    COVARIANCE_TYPE_UNKNOWN: Final = 0
    COVARIANCE_TYPE_APPROXIMATED: Final = 1
    COVARIANCE_TYPE_DIAGONAL_KNOWN: Final = 2
    COVARIANCE_TYPE_KNOWN: Final = 3
    def __init__(self, *, header: std_msgs.msg.Header = ..., status: sensor_msgs.msg.NavSatStatus = ..., latitude: float = ..., longitude: float = ..., altitude: float = ..., position_covariance: Collection[float] = ..., position_covariance_type: int = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    status: sensor_msgs.msg.NavSatStatus
    latitude: float
    longitude: float
    altitude: float
    @property
    def position_covariance(self) -> NDArray[numpy.float64]: ...
    @position_covariance.setter
    def position_covariance(self, value: Collection[float]) -> None: ...
    position_covariance_type: int

class NavSatStatus(Message):
    """sensor_msgs/msg/NavSatStatus

    # Whether a satellite receiver has a fix (status >= STATUS_FIX) and which systems it listens to.

    int8 STATUS_UNKNOWN = -2        # nothing said yet
    int8 STATUS_NO_FIX =  -1        # position not found
    int8 STATUS_FIX =      0        # position found
    int8 STATUS_SBAS_FIX = 1        # improved by correction satellites
    int8 STATUS_GBAS_FIX = 2        # improved by correction stations on the ground

    int8 status -2 # STATUS_UNKNOWN

    # Systems in use; several are added together.
    uint16 SERVICE_UNKNOWN = 0  # test with ==, as no bit is set
    uint16 SERVICE_GPS =     1
    uint16 SERVICE_GLONASS = 2
    uint16 SERVICE_COMPASS = 4      # and BeiDou
    uint16 SERVICE_GALILEO = 8

    uint16 service
    """
    STATUS_UNKNOWN: Final = -2
    STATUS_NO_FIX: Final = -1
    STATUS_FIX: Final = 0
    STATUS_SBAS_FIX: Final = 1
    STATUS_GBAS_FIX: Final = 2
    SERVICE_UNKNOWN: Final = 0
    SERVICE_GPS: Final = 1
    SERVICE_GLONASS: Final = 2
    SERVICE_COMPASS: Final = 4
    SERVICE_GALILEO: Final = 8
    def __init__(self, *, status: int = ..., service: int = ..., check_fields: bool = ...) -> None: ...
    status: int
    service: int

class PointCloud(Message):
    """sensor_msgs/msg/PointCloud

    # Points in space with extra numbers. Deprecated in ROS 2: new code uses PointCloud2.

    # Time of the measurement and frame of the points.
    std_msgs/Header header

    # The points, in m.
    geometry_msgs/Point32[] points

    # Extra numbers, one list per meaning, each as long as points.
    ChannelFloat32[] channels
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., points: Collection[geometry_msgs.msg.Point32] = ..., channels: Collection[sensor_msgs.msg.ChannelFloat32] = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    @property
    def points(self) -> list[geometry_msgs.msg.Point32]: ...
    @points.setter
    def points(self, value: Collection[geometry_msgs.msg.Point32]) -> None: ...
    @property
    def channels(self) -> list[sensor_msgs.msg.ChannelFloat32]: ...
    @channels.setter
    def channels(self, value: Collection[sensor_msgs.msg.ChannelFloat32]) -> None: ...

class PointCloud2(Message):
    """sensor_msgs/msg/PointCloud2

    # Points in space, packed into bytes: from a 3D laser or a depth camera.

    # Time of the measurement and frame of the points.
    std_msgs/Header header

    # A depth camera delivers rows of points like an image. Otherwise height is 1 and width counts the points.
    uint32 height
    uint32 width

    # What a point consists of and where each number sits in its bytes.
    PointField[] fields

    bool    is_bigendian # true if numbers have their highest byte first
    uint32  point_step   # bytes per point
    uint32  row_step     # bytes per row
    uint8[] data         # all rows, one after the other: row_step * height bytes

    bool is_dense        # true if every point is valid
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., height: int = ..., width: int = ..., fields: Collection[sensor_msgs.msg.PointField] = ..., is_bigendian: bool = ..., point_step: int = ..., row_step: int = ..., data: Collection[int] = ..., is_dense: bool = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    height: int
    width: int
    @property
    def fields(self) -> list[sensor_msgs.msg.PointField]: ...
    @fields.setter
    def fields(self, value: Collection[sensor_msgs.msg.PointField]) -> None: ...
    is_bigendian: bool
    point_step: int
    row_step: int
    @property
    def data(self) -> array[int]: ...
    @data.setter
    def data(self, value: Collection[int]) -> None: ...
    is_dense: bool

class PointField(Message):
    """sensor_msgs/msg/PointField

    # One number of a point in a PointCloud2.

    uint8 INT8    = 1
    uint8 UINT8   = 2
    uint8 INT16   = 3
    uint8 UINT16  = 4
    uint8 INT32   = 5
    uint8 UINT32  = 6
    uint8 FLOAT32 = 7
    uint8 FLOAT64 = 8

    # Usual names: x, y, z, intensity, rgb, rgba
    string name      # its meaning
    uint32 offset    # bytes before it within the point
    uint8  datatype  # one of the constants above
    uint32 count     # how many in a row, usually 1
    """
    INT8: Final = 1
    UINT8: Final = 2
    INT16: Final = 3
    UINT16: Final = 4
    INT32: Final = 5
    UINT32: Final = 6
    FLOAT32: Final = 7
    FLOAT64: Final = 8
    def __init__(self, *, name: str = ..., offset: int = ..., datatype: int = ..., count: int = ..., check_fields: bool = ...) -> None: ...
    name: str
    offset: int
    datatype: int
    count: int

class Range(Message):
    """sensor_msgs/msg/Range

    # A distance from an ultrasonic or infrared sensor that sees a cone, not a single ray.
    #
    # A sensor that only tells "something there" has min_range equal to max_range and
    # reports -inf (something within that distance) or inf (nothing).

    std_msgs/Header header # time of the reading; the sensor looks along x of its frame

    # What the sensor sends out.
    uint8 ULTRASOUND=0
    uint8 INFRARED=1

    uint8 radiation_type    # one of the two above

    float32 field_of_view   # full width of the cone [rad]

    float32 min_range       # shortest distance that can be trusted [m]
    float32 max_range       # longest distance that can be trusted [m]

    float32 range           # distance [m]; ignore it outside min_range..max_range

    float32 variance        # m^2; 0 if unknown
    """
    ULTRASOUND: Final = 0
    INFRARED: Final = 1
    def __init__(self, *, header: std_msgs.msg.Header = ..., radiation_type: int = ..., field_of_view: float = ..., min_range: float = ..., max_range: float = ..., range: float = ..., variance: float = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    radiation_type: int
    field_of_view: float
    min_range: float
    max_range: float
    range: float
    variance: float

class RegionOfInterest(Message):
    """sensor_msgs/msg/RegionOfInterest

    # A rectangle within an image, in pixels. All zeros stand for the whole image.

    uint32 x_offset  # columns left of it
    uint32 y_offset  # rows above it
    uint32 height    # rows in it
    uint32 width     # columns in it

    # True if rectifying the image needs a rectangle of its own: usual once a part was cut out.
    bool do_rectify
    """
    def __init__(self, *, x_offset: int = ..., y_offset: int = ..., height: int = ..., width: int = ..., do_rectify: bool = ..., check_fields: bool = ...) -> None: ...
    x_offset: int
    y_offset: int
    height: int
    width: int
    do_rectify: bool

class RelativeHumidity(Message):
    """sensor_msgs/msg/RelativeHumidity

    # How much water vapour the air holds, compared with the most it could hold.

    std_msgs/Header header # time of the reading and frame of the sensor

    float64 relative_humidity    # 0.0 is dry, 1.0 is saturated

    float64 variance             # 0 if unknown
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., relative_humidity: float = ..., variance: float = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    relative_humidity: float
    variance: float

class Temperature(Message):
    """sensor_msgs/msg/Temperature

    # Reading of a thermometer.

    std_msgs/Header header # time of the reading and frame of the sensor

    float64 temperature          # degrees Celsius

    float64 variance             # (degrees Celsius)^2; 0 if unknown
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., temperature: float = ..., variance: float = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    temperature: float
    variance: float

class TimeReference(Message):
    """sensor_msgs/msg/TimeReference

    # What another clock showed, such as that of a GPS receiver.

    std_msgs/Header header      # our time at that moment; frame_id stays empty

    builtin_interfaces/Time time_ref  # the time the other clock showed
    string source                     # name of the other clock; may be empty
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., time_ref: builtin_interfaces.msg.Time = ..., source: str = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    time_ref: builtin_interfaces.msg.Time
    source: str
