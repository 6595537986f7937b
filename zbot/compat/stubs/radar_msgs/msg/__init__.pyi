# Written by python -m zbot.interfaces.stubs; do not edit.
from array import array
from collections.abc import Collection
from typing import Final, TypeAlias

import numpy
from numpy.typing import NDArray

import geometry_msgs.msg
import radar_msgs.msg
import std_msgs.msg
import unique_identifier_msgs.msg
from zbot.interfaces import Action, Message, Service

class RadarReturn(Message):
    """radar_msgs/msg/RadarReturn

    # One reflection that a radar received.

    float32 range  # m
    float32 azimuth  # rad, counter-clockwise from the x axis
    float32 elevation  # rad
    float32 doppler_velocity  # m/s, away from the radar
    float32 amplitude  # dB
    """
    def __init__(self, *, range: float = ..., azimuth: float = ..., elevation: float = ..., doppler_velocity: float = ..., amplitude: float = ..., check_fields: bool = ...) -> None: ...
    range: float
    azimuth: float
    elevation: float
    doppler_velocity: float
    amplitude: float

class RadarScan(Message):
    """radar_msgs/msg/RadarScan

    # Reflections that a radar received in one scan.

    std_msgs/Header header
    radar_msgs/RadarReturn[] returns
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., returns: Collection[radar_msgs.msg.RadarReturn] = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    @property
    def returns(self) -> list[radar_msgs.msg.RadarReturn]: ...
    @returns.setter
    def returns(self, value: Collection[radar_msgs.msg.RadarReturn]) -> None: ...

class RadarTrack(Message):
    """radar_msgs/msg/RadarTrack

    # An object that a radar follows.

    uint16 NO_CLASSIFICATION=0
    uint16 STATIC=1
    uint16 DYNAMIC=2
    unique_identifier_msgs/UUID uuid
    geometry_msgs/Point position  # m
    geometry_msgs/Vector3 velocity  # m/s
    geometry_msgs/Vector3 acceleration  # m/s^2
    geometry_msgs/Vector3 size  # m
    uint16 classification  # a constant above, or 32000 and more for a maker's own
    float32[6] position_covariance  # xx, xy, xz, yy, yz, zz
    float32[6] velocity_covariance
    float32[6] acceleration_covariance
    float32[6] size_covariance
    """
    NO_CLASSIFICATION: Final = 0
    STATIC: Final = 1
    DYNAMIC: Final = 2
    def __init__(self, *, uuid: unique_identifier_msgs.msg.UUID = ..., position: geometry_msgs.msg.Point = ..., velocity: geometry_msgs.msg.Vector3 = ..., acceleration: geometry_msgs.msg.Vector3 = ..., size: geometry_msgs.msg.Vector3 = ..., classification: int = ..., position_covariance: Collection[float] = ..., velocity_covariance: Collection[float] = ..., acceleration_covariance: Collection[float] = ..., size_covariance: Collection[float] = ..., check_fields: bool = ...) -> None: ...
    uuid: unique_identifier_msgs.msg.UUID
    position: geometry_msgs.msg.Point
    velocity: geometry_msgs.msg.Vector3
    acceleration: geometry_msgs.msg.Vector3
    size: geometry_msgs.msg.Vector3
    classification: int
    @property
    def position_covariance(self) -> NDArray[numpy.float32]: ...
    @position_covariance.setter
    def position_covariance(self, value: Collection[float]) -> None: ...
    @property
    def velocity_covariance(self) -> NDArray[numpy.float32]: ...
    @velocity_covariance.setter
    def velocity_covariance(self, value: Collection[float]) -> None: ...
    @property
    def acceleration_covariance(self) -> NDArray[numpy.float32]: ...
    @acceleration_covariance.setter
    def acceleration_covariance(self, value: Collection[float]) -> None: ...
    @property
    def size_covariance(self) -> NDArray[numpy.float32]: ...
    @size_covariance.setter
    def size_covariance(self, value: Collection[float]) -> None: ...

class RadarTracks(Message):
    """radar_msgs/msg/RadarTracks

    # Objects that a radar follows.

    std_msgs/Header header
    radar_msgs/RadarTrack[] tracks
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., tracks: Collection[radar_msgs.msg.RadarTrack] = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    @property
    def tracks(self) -> list[radar_msgs.msg.RadarTrack]: ...
    @tracks.setter
    def tracks(self, value: Collection[radar_msgs.msg.RadarTrack]) -> None: ...
