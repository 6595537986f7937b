# Written by python -m zbot.interfaces.stubs; do not edit.
from array import array
from collections.abc import Collection
from typing import Final, TypeAlias

import numpy
from numpy.typing import NDArray

import nmea_msgs.msg
import std_msgs.msg
from zbot.interfaces import Action, Message, Service

class Gpgga(Message):
    """nmea_msgs/msg/Gpgga

    # Sentence GGA of a GPS receiver: position and quality.

    std_msgs/Header header
    string message_id  # e.g. $GPGGA
    float64 utc_seconds  # s since midnight
    float64 lat  # degrees
    float64 lon  # degrees
    string lat_dir  # N or S
    string lon_dir  # E or W
    uint32 gps_qual  # 0: no fix, 1: GPS, 2: differential GPS
    uint32 num_sats
    float32 hdop  # horizontal dilution of precision
    float32 alt  # above the sea level, in altitude_units
    string altitude_units
    float32 undulation  # sea level above the ellipsoid, in undulation_units
    string undulation_units
    uint32 diff_age  # s since the last correction
    string station_id
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., message_id: str = ..., utc_seconds: float = ..., lat: float = ..., lon: float = ..., lat_dir: str = ..., lon_dir: str = ..., gps_qual: int = ..., num_sats: int = ..., hdop: float = ..., alt: float = ..., altitude_units: str = ..., undulation: float = ..., undulation_units: str = ..., diff_age: int = ..., station_id: str = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    message_id: str
    utc_seconds: float
    lat: float
    lon: float
    lat_dir: str
    lon_dir: str
    gps_qual: int
    num_sats: int
    hdop: float
    alt: float
    altitude_units: str
    undulation: float
    undulation_units: str
    diff_age: int
    station_id: str

class Gpgsa(Message):
    """nmea_msgs/msg/Gpgsa

    # Sentence GSA of a GPS receiver: satellites in use and precision.

    std_msgs/Header header
    string message_id
    string auto_manual_mode  # A or M
    uint8 fix_mode  # 1: no fix, 2: two dimensions, 3: three dimensions
    uint8[] sv_ids  # numbers of the satellites
    float32 pdop  # dilution of precision
    float32 hdop  # horizontal
    float32 vdop  # vertical
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., message_id: str = ..., auto_manual_mode: str = ..., fix_mode: int = ..., sv_ids: Collection[int] = ..., pdop: float = ..., hdop: float = ..., vdop: float = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    message_id: str
    auto_manual_mode: str
    fix_mode: int
    @property
    def sv_ids(self) -> array[int]: ...
    @sv_ids.setter
    def sv_ids(self, value: Collection[int]) -> None: ...
    pdop: float
    hdop: float
    vdop: float

class Gpgst(Message):
    """nmea_msgs/msg/Gpgst

    # Sentence GST of a GPS receiver: errors of the position.

    std_msgs/Header header
    string message_id
    float64 utc_seconds  # s since midnight
    float32 rms
    float32 semi_major_dev  # m
    float32 semi_minor_dev  # m
    float32 orientation  # degrees from the true north, of the major axis
    float32 lat_dev  # m
    float32 lon_dev  # m
    float32 alt_dev  # m
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., message_id: str = ..., utc_seconds: float = ..., rms: float = ..., semi_major_dev: float = ..., semi_minor_dev: float = ..., orientation: float = ..., lat_dev: float = ..., lon_dev: float = ..., alt_dev: float = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    message_id: str
    utc_seconds: float
    rms: float
    semi_major_dev: float
    semi_minor_dev: float
    orientation: float
    lat_dev: float
    lon_dev: float
    alt_dev: float

class Gpgsv(Message):
    """nmea_msgs/msg/Gpgsv

    # Sentence GSV of a GPS receiver: satellites in view.

    std_msgs/Header header
    string message_id
    uint8 n_msgs  # number of sentences for all satellites
    uint8 msg_number  # counts from 1
    uint8 n_satellites  # in view
    GpgsvSatellite[] satellites  # at most 4 in a sentence
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., message_id: str = ..., n_msgs: int = ..., msg_number: int = ..., n_satellites: int = ..., satellites: Collection[nmea_msgs.msg.GpgsvSatellite] = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    message_id: str
    n_msgs: int
    msg_number: int
    n_satellites: int
    @property
    def satellites(self) -> list[nmea_msgs.msg.GpgsvSatellite]: ...
    @satellites.setter
    def satellites(self, value: Collection[nmea_msgs.msg.GpgsvSatellite]) -> None: ...

class GpgsvSatellite(Message):
    """nmea_msgs/msg/GpgsvSatellite

    # A satellite in view.

    uint8 prn  # number of the satellite
    uint8 elevation  # degrees, at most 90
    uint16 azimuth  # degrees from the true north
    int8 snr  # dB, or -1 if it is not tracked
    """
    def __init__(self, *, prn: int = ..., elevation: int = ..., azimuth: int = ..., snr: int = ..., check_fields: bool = ...) -> None: ...
    prn: int
    elevation: int
    azimuth: int
    snr: int

class Gprmc(Message):
    """nmea_msgs/msg/Gprmc

    # Sentence RMC of a GPS receiver: the least a navigator needs.

    std_msgs/Header header
    string message_id
    float64 utc_seconds  # s since midnight
    string position_status  # A: valid, V: not valid
    float64 lat  # degrees
    float64 lon  # degrees
    string lat_dir  # N or S
    string lon_dir  # E or W
    float32 speed  # knots
    float32 track  # degrees
    string date  # DDMMYY
    float32 mag_var  # degrees
    string mag_var_direction  # E or W
    string mode_indicator
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., message_id: str = ..., utc_seconds: float = ..., position_status: str = ..., lat: float = ..., lon: float = ..., lat_dir: str = ..., lon_dir: str = ..., speed: float = ..., track: float = ..., date: str = ..., mag_var: float = ..., mag_var_direction: str = ..., mode_indicator: str = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    message_id: str
    utc_seconds: float
    position_status: str
    lat: float
    lon: float
    lat_dir: str
    lon_dir: str
    speed: float
    track: float
    date: str
    mag_var: float
    mag_var_direction: str
    mode_indicator: str

class Gpvtg(Message):
    """nmea_msgs/msg/Gpvtg

    # Sentence VTG of a GPS receiver: course and speed.

    std_msgs/Header header
    string message_id
    float32 track_t  # degrees from the true north
    string track_t_ref
    float32 track_m  # degrees from the magnetic north
    string track_m_ref
    float32 speed_n  # knots
    string speed_n_unit
    float32 speed_k  # km/h
    string speed_k_unit
    string mode_indicator
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., message_id: str = ..., track_t: float = ..., track_t_ref: str = ..., track_m: float = ..., track_m_ref: str = ..., speed_n: float = ..., speed_n_unit: str = ..., speed_k: float = ..., speed_k_unit: str = ..., mode_indicator: str = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    message_id: str
    track_t: float
    track_t_ref: str
    track_m: float
    track_m_ref: str
    speed_n: float
    speed_n_unit: str
    speed_k: float
    speed_k_unit: str
    mode_indicator: str

class Gpzda(Message):
    """nmea_msgs/msg/Gpzda

    # Sentence ZDA of a GPS receiver: date and time.

    std_msgs/Header header
    string message_id
    uint32 utc_seconds  # s since midnight
    uint8 day
    uint8 month
    uint16 year
    int8 hour_offset_gmt
    uint8 minute_offset_gmt
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., message_id: str = ..., utc_seconds: int = ..., day: int = ..., month: int = ..., year: int = ..., hour_offset_gmt: int = ..., minute_offset_gmt: int = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    message_id: str
    utc_seconds: int
    day: int
    month: int
    year: int
    hour_offset_gmt: int
    minute_offset_gmt: int

class Sentence(Message):
    """nmea_msgs/msg/Sentence

    # A sentence of a GPS receiver, as it was sent.

    std_msgs/Header header
    string sentence
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., sentence: str = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    sentence: str
