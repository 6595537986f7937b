# Written by python -m zbot.interfaces.stubs; do not edit.
from array import array
from collections.abc import Collection
from typing import Final, TypeAlias

import numpy
from numpy.typing import NDArray

import builtin_interfaces.msg
import irobot_create_msgs.msg
import std_msgs.msg
from zbot.interfaces import Action, Message, Service

class AudioNote(Message):
    """irobot_create_msgs/msg/AudioNote

    # A tone.

    uint16 frequency  # Hz
    builtin_interfaces/Duration max_runtime
    """
    def __init__(self, *, frequency: int = ..., max_runtime: builtin_interfaces.msg.Duration = ..., check_fields: bool = ...) -> None: ...
    frequency: int
    max_runtime: builtin_interfaces.msg.Duration

class AudioNoteVector(Message):
    """irobot_create_msgs/msg/AudioNoteVector

    # Tones to play one after another.

    std_msgs/Header header
    irobot_create_msgs/AudioNote[] notes
    bool append  # play them after those that play now
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., notes: Collection[irobot_create_msgs.msg.AudioNote] = ..., append: bool = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    @property
    def notes(self) -> list[irobot_create_msgs.msg.AudioNote]: ...
    @notes.setter
    def notes(self, value: Collection[irobot_create_msgs.msg.AudioNote]) -> None: ...
    append: bool

class Button(Message):
    """irobot_create_msgs/msg/Button

    # State of a button.

    std_msgs/Header header
    bool is_pressed
    builtin_interfaces/Time last_start_pressed_time
    builtin_interfaces/Duration last_pressed_duration
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., is_pressed: bool = ..., last_start_pressed_time: builtin_interfaces.msg.Time = ..., last_pressed_duration: builtin_interfaces.msg.Duration = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    is_pressed: bool
    last_start_pressed_time: builtin_interfaces.msg.Time
    last_pressed_duration: builtin_interfaces.msg.Duration

class DockStatus(Message):
    """irobot_create_msgs/msg/DockStatus

    # Whether the robot sees the dock and stands in it.

    std_msgs/Header header
    bool dock_visible
    bool is_docked
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., dock_visible: bool = ..., is_docked: bool = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    dock_visible: bool
    is_docked: bool

class HazardDetection(Message):
    """irobot_create_msgs/msg/HazardDetection

    # A danger, and the place of the sensor as a frame.

    uint8 BACKUP_LIMIT=0
    uint8 BUMP=1
    uint8 CLIFF=2
    uint8 STALL=3
    uint8 WHEEL_DROP=4
    uint8 OBJECT_PROXIMITY=5
    std_msgs/Header header
    uint8 type
    """
    BACKUP_LIMIT: Final = 0
    BUMP: Final = 1
    CLIFF: Final = 2
    STALL: Final = 3
    WHEEL_DROP: Final = 4
    OBJECT_PROXIMITY: Final = 5
    def __init__(self, *, header: std_msgs.msg.Header = ..., type: int = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    type: int

class HazardDetectionVector(Message):
    """irobot_create_msgs/msg/HazardDetectionVector

    # All dangers now.

    std_msgs/Header header
    irobot_create_msgs/HazardDetection[] detections
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., detections: Collection[irobot_create_msgs.msg.HazardDetection] = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    @property
    def detections(self) -> list[irobot_create_msgs.msg.HazardDetection]: ...
    @detections.setter
    def detections(self, value: Collection[irobot_create_msgs.msg.HazardDetection]) -> None: ...

class InterfaceButtons(Message):
    """irobot_create_msgs/msg/InterfaceButtons

    # States of the three buttons on the robot.

    std_msgs/Header header
    irobot_create_msgs/Button button_1
    irobot_create_msgs/Button button_power
    irobot_create_msgs/Button button_2
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., button_1: irobot_create_msgs.msg.Button = ..., button_power: irobot_create_msgs.msg.Button = ..., button_2: irobot_create_msgs.msg.Button = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    button_1: irobot_create_msgs.msg.Button
    button_power: irobot_create_msgs.msg.Button
    button_2: irobot_create_msgs.msg.Button

class IrIntensity(Message):
    """irobot_create_msgs/msg/IrIntensity

    # Infrared light that an object in front of a sensor reflects.

    std_msgs/Header header
    int16 value
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., value: int = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    value: int

class IrIntensityVector(Message):
    """irobot_create_msgs/msg/IrIntensityVector

    # Readings of all infrared sensors.

    std_msgs/Header header
    irobot_create_msgs/IrIntensity[] readings
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., readings: Collection[irobot_create_msgs.msg.IrIntensity] = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    @property
    def readings(self) -> list[irobot_create_msgs.msg.IrIntensity]: ...
    @readings.setter
    def readings(self, value: Collection[irobot_create_msgs.msg.IrIntensity]) -> None: ...

class IrOpcode(Message):
    """irobot_create_msgs/msg/IrOpcode

    # A code that a dock or a virtual wall sends by infrared light.

    uint8 CODE_IR_FORCE_FIELD=161
    uint8 CODE_IR_VIRTUAL_WALL=162
    uint8 CODE_IR_BUOY_GREEN=164
    uint8 CODE_IR_BUOY_RED=168
    uint8 CODE_IR_BUOY_BOTH=172
    uint8 CODE_IR_EVAC_GREEN_FIELD=244
    uint8 CODE_IR_EVAC_RED_FIELD=248
    uint8 CODE_IR_EVAC_BOTH_FIELD=252
    uint8 SENSOR_OMNI=0
    uint8 SENSOR_DIRECTIONAL_FRONT=1
    std_msgs/Header header
    uint8 opcode  # one of CODE_IR_...
    uint8 sensor  # one of SENSOR_...
    """
    CODE_IR_FORCE_FIELD: Final = 161
    CODE_IR_VIRTUAL_WALL: Final = 162
    CODE_IR_BUOY_GREEN: Final = 164
    CODE_IR_BUOY_RED: Final = 168
    CODE_IR_BUOY_BOTH: Final = 172
    CODE_IR_EVAC_GREEN_FIELD: Final = 244
    CODE_IR_EVAC_RED_FIELD: Final = 248
    CODE_IR_EVAC_BOTH_FIELD: Final = 252
    SENSOR_OMNI: Final = 0
    SENSOR_DIRECTIONAL_FRONT: Final = 1
    def __init__(self, *, header: std_msgs.msg.Header = ..., opcode: int = ..., sensor: int = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    opcode: int
    sensor: int

class KidnapStatus(Message):
    """irobot_create_msgs/msg/KidnapStatus

    # Whether the robot was lifted.

    std_msgs/Header header
    bool is_kidnapped
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., is_kidnapped: bool = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    is_kidnapped: bool

class LedColor(Message):
    """irobot_create_msgs/msg/LedColor

    # A color of a light, 0 to 255.

    uint8 red
    uint8 green
    uint8 blue
    """
    def __init__(self, *, red: int = ..., green: int = ..., blue: int = ..., check_fields: bool = ...) -> None: ...
    red: int
    green: int
    blue: int

class LightringLeds(Message):
    """irobot_create_msgs/msg/LightringLeds

    # Colors of the six lights of the ring.

    std_msgs/Header header
    irobot_create_msgs/LedColor[6] leds
    bool override_system  # use these colors in place of those of the robot
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., leds: Collection[irobot_create_msgs.msg.LedColor] = ..., override_system: bool = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    @property
    def leds(self) -> list[irobot_create_msgs.msg.LedColor]: ...
    @leds.setter
    def leds(self, value: Collection[irobot_create_msgs.msg.LedColor]) -> None: ...
    override_system: bool

class Mouse(Message):
    """irobot_create_msgs/msg/Mouse

    # Motion over the floor, from an optical sensor.

    std_msgs/Header header
    float32 integrated_x  # m since the start
    float32 integrated_y  # m
    uint32 frame_id
    uint8 last_squal  # quality of the last image
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., integrated_x: float = ..., integrated_y: float = ..., frame_id: int = ..., last_squal: int = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    integrated_x: float
    integrated_y: float
    frame_id: int
    last_squal: int

class SlipStatus(Message):
    """irobot_create_msgs/msg/SlipStatus

    # Whether the wheels slip.

    std_msgs/Header header
    bool is_slipping
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., is_slipping: bool = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    is_slipping: bool

class StopStatus(Message):
    """irobot_create_msgs/msg/StopStatus

    # Whether the robot stands still.

    std_msgs/Header header
    bool is_stopped
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., is_stopped: bool = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    is_stopped: bool

class WheelStatus(Message):
    """irobot_create_msgs/msg/WheelStatus

    # Currents of the wheel motors.

    std_msgs/Header header
    int16 current_ma_left  # mA
    int16 current_ma_right  # mA
    int16 pwm_left  # part of the full power, in 1/32767
    int16 pwm_right
    bool wheels_enabled  # false: the motors are off
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., current_ma_left: int = ..., current_ma_right: int = ..., pwm_left: int = ..., pwm_right: int = ..., wheels_enabled: bool = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    current_ma_left: int
    current_ma_right: int
    pwm_left: int
    pwm_right: int
    wheels_enabled: bool

class WheelTicks(Message):
    """irobot_create_msgs/msg/WheelTicks

    # Counts of the wheel encoders.

    std_msgs/Header header
    int32 ticks_left
    int32 ticks_right
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., ticks_left: int = ..., ticks_right: int = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    ticks_left: int
    ticks_right: int

class WheelVels(Message):
    """irobot_create_msgs/msg/WheelVels

    # Speeds of the wheels.

    std_msgs/Header header
    float32 velocity_left  # rad/s
    float32 velocity_right  # rad/s
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., velocity_left: float = ..., velocity_right: float = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    velocity_left: float
    velocity_right: float
