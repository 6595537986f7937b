# Written by python -m zbot.interfaces.stubs; do not edit.
from array import array
from collections.abc import Collection
from typing import Final, TypeAlias

import numpy
from numpy.typing import NDArray

import gps_msgs.msg
import std_msgs.msg
from zbot.interfaces import Action, Message, Service

class GPSFix(Message):
    """gps_msgs/msg/GPSFix

    std_msgs/Header header
    GPSStatus status
    float64 latitude
    float64 longitude
    float64 altitude
    float64 track
    float64 speed
    float64 climb
    float64 pitch
    float64 roll
    float64 dip
    float64 time
    float64 gdop
    float64 pdop
    float64 hdop
    float64 vdop
    float64 tdop
    float64 err
    float64 err_horz
    float64 err_vert
    float64 err_track
    float64 err_speed
    float64 err_climb
    float64 err_time
    float64 err_pitch
    float64 err_roll
    float64 err_dip
    float64[9] position_covariance
    uint8 COVARIANCE_TYPE_UNKNOWN=0
    uint8 COVARIANCE_TYPE_APPROXIMATED=1
    uint8 COVARIANCE_TYPE_DIAGONAL_KNOWN=2
    uint8 COVARIANCE_TYPE_KNOWN=3
    uint8 position_covariance_type
    """
    COVARIANCE_TYPE_UNKNOWN: Final = 0
    COVARIANCE_TYPE_APPROXIMATED: Final = 1
    COVARIANCE_TYPE_DIAGONAL_KNOWN: Final = 2
    COVARIANCE_TYPE_KNOWN: Final = 3
    def __init__(self, *, header: std_msgs.msg.Header = ..., status: gps_msgs.msg.GPSStatus = ..., latitude: float = ..., longitude: float = ..., altitude: float = ..., track: float = ..., speed: float = ..., climb: float = ..., pitch: float = ..., roll: float = ..., dip: float = ..., time: float = ..., gdop: float = ..., pdop: float = ..., hdop: float = ..., vdop: float = ..., tdop: float = ..., err: float = ..., err_horz: float = ..., err_vert: float = ..., err_track: float = ..., err_speed: float = ..., err_climb: float = ..., err_time: float = ..., err_pitch: float = ..., err_roll: float = ..., err_dip: float = ..., position_covariance: Collection[float] = ..., position_covariance_type: int = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    status: gps_msgs.msg.GPSStatus
    latitude: float
    longitude: float
    altitude: float
    track: float
    speed: float
    climb: float
    pitch: float
    roll: float
    dip: float
    time: float
    gdop: float
    pdop: float
    hdop: float
    vdop: float
    tdop: float
    err: float
    err_horz: float
    err_vert: float
    err_track: float
    err_speed: float
    err_climb: float
    err_time: float
    err_pitch: float
    err_roll: float
    err_dip: float
    @property
    def position_covariance(self) -> NDArray[numpy.float64]: ...
    @position_covariance.setter
    def position_covariance(self, value: Collection[float]) -> None: ...
    position_covariance_type: int

class GPSStatus(Message):
    """gps_msgs/msg/GPSStatus

    std_msgs/Header header
    uint16 satellites_used
    int32[] satellite_used_prn
    uint16 satellites_visible
    int32[] satellite_visible_prn
    int32[] satellite_visible_z
    int32[] satellite_visible_azimuth
    int32[] satellite_visible_snr
    int16 STATUS_NO_FIX=-1
    int16 STATUS_FIX=0
    int16 STATUS_SBAS_FIX=1
    int16 STATUS_GBAS_FIX=2
    int16 STATUS_DGPS_FIX=18
    int16 STATUS_RTK_FIX=19
    int16 STATUS_RTK_FLOAT=20
    int16 STATUS_WAAS_FIX=33
    int16 status
    uint16 SOURCE_NONE=0
    uint16 SOURCE_GPS=1
    uint16 SOURCE_POINTS=2
    uint16 SOURCE_DOPPLER=4
    uint16 SOURCE_ALTIMETER=8
    uint16 SOURCE_MAGNETIC=16
    uint16 SOURCE_GYRO=32
    uint16 SOURCE_ACCEL=64
    uint16 motion_source
    uint16 orientation_source
    uint16 position_source
    """
    STATUS_NO_FIX: Final = -1
    STATUS_FIX: Final = 0
    STATUS_SBAS_FIX: Final = 1
    STATUS_GBAS_FIX: Final = 2
    STATUS_DGPS_FIX: Final = 18
    STATUS_RTK_FIX: Final = 19
    STATUS_RTK_FLOAT: Final = 20
    STATUS_WAAS_FIX: Final = 33
    SOURCE_NONE: Final = 0
    SOURCE_GPS: Final = 1
    SOURCE_POINTS: Final = 2
    SOURCE_DOPPLER: Final = 4
    SOURCE_ALTIMETER: Final = 8
    SOURCE_MAGNETIC: Final = 16
    SOURCE_GYRO: Final = 32
    SOURCE_ACCEL: Final = 64
    def __init__(self, *, header: std_msgs.msg.Header = ..., satellites_used: int = ..., satellite_used_prn: Collection[int] = ..., satellites_visible: int = ..., satellite_visible_prn: Collection[int] = ..., satellite_visible_z: Collection[int] = ..., satellite_visible_azimuth: Collection[int] = ..., satellite_visible_snr: Collection[int] = ..., status: int = ..., motion_source: int = ..., orientation_source: int = ..., position_source: int = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    satellites_used: int
    @property
    def satellite_used_prn(self) -> array[int]: ...
    @satellite_used_prn.setter
    def satellite_used_prn(self, value: Collection[int]) -> None: ...
    satellites_visible: int
    @property
    def satellite_visible_prn(self) -> array[int]: ...
    @satellite_visible_prn.setter
    def satellite_visible_prn(self, value: Collection[int]) -> None: ...
    @property
    def satellite_visible_z(self) -> array[int]: ...
    @satellite_visible_z.setter
    def satellite_visible_z(self, value: Collection[int]) -> None: ...
    @property
    def satellite_visible_azimuth(self) -> array[int]: ...
    @satellite_visible_azimuth.setter
    def satellite_visible_azimuth(self, value: Collection[int]) -> None: ...
    @property
    def satellite_visible_snr(self) -> array[int]: ...
    @satellite_visible_snr.setter
    def satellite_visible_snr(self, value: Collection[int]) -> None: ...
    status: int
    motion_source: int
    orientation_source: int
    position_source: int
