# Written by python -m zbot.interfaces.stubs; do not edit.
from array import array
from collections.abc import Collection
from typing import Final, TypeAlias

import numpy
from numpy.typing import NDArray

import geometry_msgs.msg
import marine_acoustic_msgs.msg
import std_msgs.msg
from zbot.interfaces import Action, Message, Service

class DetectionFlag(Message):
    """marine_acoustic_msgs/msg/DetectionFlag

    uint8 DETECT_OK=0
    uint8 DETECT_BAD_SONAR=1
    uint8 DETECT_BAD_FILTER=2
    uint8 DETECT_BAD_USER=4
    uint8 flag
    """
    DETECT_OK: Final = 0
    DETECT_BAD_SONAR: Final = 1
    DETECT_BAD_FILTER: Final = 2
    DETECT_BAD_USER: Final = 4
    def __init__(self, *, flag: int = ..., check_fields: bool = ...) -> None: ...
    flag: int

class Dvl(Message):
    """marine_acoustic_msgs/msg/Dvl

    uint8 DVL_MODE_BOTTOM=1
    uint8 DVL_MODE_WATER=2
    uint8 DVL_TYPE_PISTON=0
    uint8 DVL_TYPE_PHASED_ARRAY=1
    std_msgs/Header header
    uint8 velocity_mode
    uint8 dvl_type
    geometry_msgs/Vector3 velocity
    float64[9] velocity_covar
    float64 altitude
    float64 course_gnd
    float64 speed_gnd
    uint8 num_good_beams
    float32 sound_speed
    bool beam_ranges_valid
    bool beam_velocities_valid
    geometry_msgs/Vector3[4] beam_unit_vec
    float64[4] range
    float32[4] range_covar
    float32[4] beam_quality
    float32[4] beam_velocity
    float32[4] beam_velocity_covar
    """
    DVL_MODE_BOTTOM: Final = 1
    DVL_MODE_WATER: Final = 2
    DVL_TYPE_PISTON: Final = 0
    DVL_TYPE_PHASED_ARRAY: Final = 1
    def __init__(self, *, header: std_msgs.msg.Header = ..., velocity_mode: int = ..., dvl_type: int = ..., velocity: geometry_msgs.msg.Vector3 = ..., velocity_covar: Collection[float] = ..., altitude: float = ..., course_gnd: float = ..., speed_gnd: float = ..., num_good_beams: int = ..., sound_speed: float = ..., beam_ranges_valid: bool = ..., beam_velocities_valid: bool = ..., beam_unit_vec: Collection[geometry_msgs.msg.Vector3] = ..., range: Collection[float] = ..., range_covar: Collection[float] = ..., beam_quality: Collection[float] = ..., beam_velocity: Collection[float] = ..., beam_velocity_covar: Collection[float] = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    velocity_mode: int
    dvl_type: int
    velocity: geometry_msgs.msg.Vector3
    @property
    def velocity_covar(self) -> NDArray[numpy.float64]: ...
    @velocity_covar.setter
    def velocity_covar(self, value: Collection[float]) -> None: ...
    altitude: float
    course_gnd: float
    speed_gnd: float
    num_good_beams: int
    sound_speed: float
    beam_ranges_valid: bool
    beam_velocities_valid: bool
    @property
    def beam_unit_vec(self) -> list[geometry_msgs.msg.Vector3]: ...
    @beam_unit_vec.setter
    def beam_unit_vec(self, value: Collection[geometry_msgs.msg.Vector3]) -> None: ...
    @property
    def range(self) -> NDArray[numpy.float64]: ...
    @range.setter
    def range(self, value: Collection[float]) -> None: ...
    @property
    def range_covar(self) -> NDArray[numpy.float32]: ...
    @range_covar.setter
    def range_covar(self, value: Collection[float]) -> None: ...
    @property
    def beam_quality(self) -> NDArray[numpy.float32]: ...
    @beam_quality.setter
    def beam_quality(self, value: Collection[float]) -> None: ...
    @property
    def beam_velocity(self) -> NDArray[numpy.float32]: ...
    @beam_velocity.setter
    def beam_velocity(self, value: Collection[float]) -> None: ...
    @property
    def beam_velocity_covar(self) -> NDArray[numpy.float32]: ...
    @beam_velocity_covar.setter
    def beam_velocity_covar(self, value: Collection[float]) -> None: ...

class PingInfo(Message):
    """marine_acoustic_msgs/msg/PingInfo

    float32 frequency
    float32 sound_speed
    float32[] tx_beamwidths
    float32[] rx_beamwidths
    """
    def __init__(self, *, frequency: float = ..., sound_speed: float = ..., tx_beamwidths: Collection[float] = ..., rx_beamwidths: Collection[float] = ..., check_fields: bool = ...) -> None: ...
    frequency: float
    sound_speed: float
    @property
    def tx_beamwidths(self) -> array[float]: ...
    @tx_beamwidths.setter
    def tx_beamwidths(self, value: Collection[float]) -> None: ...
    @property
    def rx_beamwidths(self) -> array[float]: ...
    @rx_beamwidths.setter
    def rx_beamwidths(self, value: Collection[float]) -> None: ...

class ProjectedSonarImage(Message):
    """marine_acoustic_msgs/msg/ProjectedSonarImage

    std_msgs/Header header
    PingInfo ping_info
    geometry_msgs/Vector3[] beam_directions
    float32[] ranges
    SonarImageData image
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., ping_info: marine_acoustic_msgs.msg.PingInfo = ..., beam_directions: Collection[geometry_msgs.msg.Vector3] = ..., ranges: Collection[float] = ..., image: marine_acoustic_msgs.msg.SonarImageData = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    ping_info: marine_acoustic_msgs.msg.PingInfo
    @property
    def beam_directions(self) -> list[geometry_msgs.msg.Vector3]: ...
    @beam_directions.setter
    def beam_directions(self, value: Collection[geometry_msgs.msg.Vector3]) -> None: ...
    @property
    def ranges(self) -> array[float]: ...
    @ranges.setter
    def ranges(self, value: Collection[float]) -> None: ...
    image: marine_acoustic_msgs.msg.SonarImageData

class RawSonarImage(Message):
    """marine_acoustic_msgs/msg/RawSonarImage

    std_msgs/Header header
    PingInfo ping_info
    float32 sample_rate
    uint32 samples_per_beam
    uint32 sample0
    float32[] tx_delays
    float32[] tx_angles
    float32[] rx_angles
    SonarImageData image
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., ping_info: marine_acoustic_msgs.msg.PingInfo = ..., sample_rate: float = ..., samples_per_beam: int = ..., sample0: int = ..., tx_delays: Collection[float] = ..., tx_angles: Collection[float] = ..., rx_angles: Collection[float] = ..., image: marine_acoustic_msgs.msg.SonarImageData = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    ping_info: marine_acoustic_msgs.msg.PingInfo
    sample_rate: float
    samples_per_beam: int
    sample0: int
    @property
    def tx_delays(self) -> array[float]: ...
    @tx_delays.setter
    def tx_delays(self, value: Collection[float]) -> None: ...
    @property
    def tx_angles(self) -> array[float]: ...
    @tx_angles.setter
    def tx_angles(self, value: Collection[float]) -> None: ...
    @property
    def rx_angles(self) -> array[float]: ...
    @rx_angles.setter
    def rx_angles(self, value: Collection[float]) -> None: ...
    image: marine_acoustic_msgs.msg.SonarImageData

class SonarDetections(Message):
    """marine_acoustic_msgs/msg/SonarDetections

    std_msgs/Header header
    PingInfo ping_info
    DetectionFlag[] flags
    float32[] two_way_travel_times
    float32[] tx_delays
    float32[] intensities
    float32[] tx_angles
    float32[] rx_angles
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., ping_info: marine_acoustic_msgs.msg.PingInfo = ..., flags: Collection[marine_acoustic_msgs.msg.DetectionFlag] = ..., two_way_travel_times: Collection[float] = ..., tx_delays: Collection[float] = ..., intensities: Collection[float] = ..., tx_angles: Collection[float] = ..., rx_angles: Collection[float] = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    ping_info: marine_acoustic_msgs.msg.PingInfo
    @property
    def flags(self) -> list[marine_acoustic_msgs.msg.DetectionFlag]: ...
    @flags.setter
    def flags(self, value: Collection[marine_acoustic_msgs.msg.DetectionFlag]) -> None: ...
    @property
    def two_way_travel_times(self) -> array[float]: ...
    @two_way_travel_times.setter
    def two_way_travel_times(self, value: Collection[float]) -> None: ...
    @property
    def tx_delays(self) -> array[float]: ...
    @tx_delays.setter
    def tx_delays(self, value: Collection[float]) -> None: ...
    @property
    def intensities(self) -> array[float]: ...
    @intensities.setter
    def intensities(self, value: Collection[float]) -> None: ...
    @property
    def tx_angles(self) -> array[float]: ...
    @tx_angles.setter
    def tx_angles(self, value: Collection[float]) -> None: ...
    @property
    def rx_angles(self) -> array[float]: ...
    @rx_angles.setter
    def rx_angles(self, value: Collection[float]) -> None: ...

class SonarImageData(Message):
    """marine_acoustic_msgs/msg/SonarImageData

    bool is_bigendian
    uint32 DTYPE_UINT8=0
    uint32 DTYPE_INT8=1
    uint32 DTYPE_UINT16=2
    uint32 DTYPE_INT16=3
    uint32 DTYPE_UINT32=4
    uint32 DTYPE_INT32=5
    uint32 DTYPE_UINT64=6
    uint32 DTYPE_INT64=7
    uint32 DTYPE_FLOAT32=8
    uint32 DTYPE_FLOAT64=9
    uint32 dtype
    uint32 beam_count
    uint8[] data
    """
    DTYPE_UINT8: Final = 0
    DTYPE_INT8: Final = 1
    DTYPE_UINT16: Final = 2
    DTYPE_INT16: Final = 3
    DTYPE_UINT32: Final = 4
    DTYPE_INT32: Final = 5
    DTYPE_UINT64: Final = 6
    DTYPE_INT64: Final = 7
    DTYPE_FLOAT32: Final = 8
    DTYPE_FLOAT64: Final = 9
    def __init__(self, *, is_bigendian: bool = ..., dtype: int = ..., beam_count: int = ..., data: Collection[int] = ..., check_fields: bool = ...) -> None: ...
    is_bigendian: bool
    dtype: int
    beam_count: int
    @property
    def data(self) -> array[int]: ...
    @data.setter
    def data(self, value: Collection[int]) -> None: ...

class SonarRanges(Message):
    """marine_acoustic_msgs/msg/SonarRanges

    std_msgs/Header header
    PingInfo ping_info
    DetectionFlag[] flags
    float32[] transmit_delays
    float32[] intensities
    geometry_msgs/Vector3[] beam_unit_vec
    float32[] ranges
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., ping_info: marine_acoustic_msgs.msg.PingInfo = ..., flags: Collection[marine_acoustic_msgs.msg.DetectionFlag] = ..., transmit_delays: Collection[float] = ..., intensities: Collection[float] = ..., beam_unit_vec: Collection[geometry_msgs.msg.Vector3] = ..., ranges: Collection[float] = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    ping_info: marine_acoustic_msgs.msg.PingInfo
    @property
    def flags(self) -> list[marine_acoustic_msgs.msg.DetectionFlag]: ...
    @flags.setter
    def flags(self, value: Collection[marine_acoustic_msgs.msg.DetectionFlag]) -> None: ...
    @property
    def transmit_delays(self) -> array[float]: ...
    @transmit_delays.setter
    def transmit_delays(self, value: Collection[float]) -> None: ...
    @property
    def intensities(self) -> array[float]: ...
    @intensities.setter
    def intensities(self, value: Collection[float]) -> None: ...
    @property
    def beam_unit_vec(self) -> list[geometry_msgs.msg.Vector3]: ...
    @beam_unit_vec.setter
    def beam_unit_vec(self, value: Collection[geometry_msgs.msg.Vector3]) -> None: ...
    @property
    def ranges(self) -> array[float]: ...
    @ranges.setter
    def ranges(self, value: Collection[float]) -> None: ...
