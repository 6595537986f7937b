# Written by python -m zbot.interfaces.stubs; do not edit.
from array import array
from collections.abc import Collection
from typing import Final, TypeAlias

import numpy
from numpy.typing import NDArray

import builtin_interfaces.msg
import rosbag2_interfaces.srv
import service_msgs.msg
from zbot.interfaces import Action, Message, Service

class Burst_Request(Message):
    """rosbag2_interfaces/srv/Burst_Request

    # Publishes the next messages of a paused player as fast as possible.

    # Number of messages. 0 means all.
    uint64 num_messages
    """
    def __init__(self, *, num_messages: int = ..., check_fields: bool = ...) -> None: ...
    num_messages: int

class Burst_Response(Message):
    """rosbag2_interfaces/srv/Burst_Response

    # Number of messages that were published.
    uint64 actually_burst
    """
    def __init__(self, *, actually_burst: int = ..., check_fields: bool = ...) -> None: ...
    actually_burst: int

class Burst_Event(Message):
    """rosbag2_interfaces/srv/Burst_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[rosbag2_interfaces.srv.Burst_Request] = ..., response: Collection[rosbag2_interfaces.srv.Burst_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[rosbag2_interfaces.srv.Burst_Request]: ...
    @request.setter
    def request(self, value: Collection[rosbag2_interfaces.srv.Burst_Request]) -> None: ...
    @property
    def response(self) -> list[rosbag2_interfaces.srv.Burst_Response]: ...
    @response.setter
    def response(self, value: Collection[rosbag2_interfaces.srv.Burst_Response]) -> None: ...

class Burst(Service):
    Request: TypeAlias = Burst_Request
    Response: TypeAlias = Burst_Response
    Event: TypeAlias = Burst_Event

class GetRate_Request(Message):
    """rosbag2_interfaces/srv/GetRate_Request

    # Asks for the speed of a player.
    """
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class GetRate_Response(Message):
    """rosbag2_interfaces/srv/GetRate_Response

    float64 rate
    """
    def __init__(self, *, rate: float = ..., check_fields: bool = ...) -> None: ...
    rate: float

class GetRate_Event(Message):
    """rosbag2_interfaces/srv/GetRate_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[rosbag2_interfaces.srv.GetRate_Request] = ..., response: Collection[rosbag2_interfaces.srv.GetRate_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[rosbag2_interfaces.srv.GetRate_Request]: ...
    @request.setter
    def request(self, value: Collection[rosbag2_interfaces.srv.GetRate_Request]) -> None: ...
    @property
    def response(self) -> list[rosbag2_interfaces.srv.GetRate_Response]: ...
    @response.setter
    def response(self, value: Collection[rosbag2_interfaces.srv.GetRate_Response]) -> None: ...

class GetRate(Service):
    Request: TypeAlias = GetRate_Request
    Response: TypeAlias = GetRate_Response
    Event: TypeAlias = GetRate_Event

class IsPaused_Request(Message):
    """rosbag2_interfaces/srv/IsPaused_Request

    # Asks a player or a recorder whether it is paused.
    """
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class IsPaused_Response(Message):
    """rosbag2_interfaces/srv/IsPaused_Response

    bool paused
    """
    def __init__(self, *, paused: bool = ..., check_fields: bool = ...) -> None: ...
    paused: bool

class IsPaused_Event(Message):
    """rosbag2_interfaces/srv/IsPaused_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[rosbag2_interfaces.srv.IsPaused_Request] = ..., response: Collection[rosbag2_interfaces.srv.IsPaused_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[rosbag2_interfaces.srv.IsPaused_Request]: ...
    @request.setter
    def request(self, value: Collection[rosbag2_interfaces.srv.IsPaused_Request]) -> None: ...
    @property
    def response(self) -> list[rosbag2_interfaces.srv.IsPaused_Response]: ...
    @response.setter
    def response(self, value: Collection[rosbag2_interfaces.srv.IsPaused_Response]) -> None: ...

class IsPaused(Service):
    Request: TypeAlias = IsPaused_Request
    Response: TypeAlias = IsPaused_Response
    Event: TypeAlias = IsPaused_Event

class Pause_Request(Message):
    """rosbag2_interfaces/srv/Pause_Request

    # Pauses a player or a recorder.
    """
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class Pause_Response(Message):
    """rosbag2_interfaces/srv/Pause_Response"""
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class Pause_Event(Message):
    """rosbag2_interfaces/srv/Pause_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[rosbag2_interfaces.srv.Pause_Request] = ..., response: Collection[rosbag2_interfaces.srv.Pause_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[rosbag2_interfaces.srv.Pause_Request]: ...
    @request.setter
    def request(self, value: Collection[rosbag2_interfaces.srv.Pause_Request]) -> None: ...
    @property
    def response(self) -> list[rosbag2_interfaces.srv.Pause_Response]: ...
    @response.setter
    def response(self, value: Collection[rosbag2_interfaces.srv.Pause_Response]) -> None: ...

class Pause(Service):
    Request: TypeAlias = Pause_Request
    Response: TypeAlias = Pause_Response
    Event: TypeAlias = Pause_Event

class Play_Request(Message):
    """rosbag2_interfaces/srv/Play_Request

    # Starts a playback.

    # Time from the start of the recording.
    builtin_interfaces/Time start_offset

    # How long to play. Below 0 means all.
    builtin_interfaces/Duration playback_duration

    # Last time. Below 0 means all.
    builtin_interfaces/Time playback_until_timestamp
    """
    def __init__(self, *, start_offset: builtin_interfaces.msg.Time = ..., playback_duration: builtin_interfaces.msg.Duration = ..., playback_until_timestamp: builtin_interfaces.msg.Time = ..., check_fields: bool = ...) -> None: ...
    start_offset: builtin_interfaces.msg.Time
    playback_duration: builtin_interfaces.msg.Duration
    playback_until_timestamp: builtin_interfaces.msg.Time

class Play_Response(Message):
    """rosbag2_interfaces/srv/Play_Response

    # False if a playback is running already.
    bool success
    """
    def __init__(self, *, success: bool = ..., check_fields: bool = ...) -> None: ...
    success: bool

class Play_Event(Message):
    """rosbag2_interfaces/srv/Play_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[rosbag2_interfaces.srv.Play_Request] = ..., response: Collection[rosbag2_interfaces.srv.Play_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[rosbag2_interfaces.srv.Play_Request]: ...
    @request.setter
    def request(self, value: Collection[rosbag2_interfaces.srv.Play_Request]) -> None: ...
    @property
    def response(self) -> list[rosbag2_interfaces.srv.Play_Response]: ...
    @response.setter
    def response(self, value: Collection[rosbag2_interfaces.srv.Play_Response]) -> None: ...

class Play(Service):
    Request: TypeAlias = Play_Request
    Response: TypeAlias = Play_Response
    Event: TypeAlias = Play_Event

class PlayNext_Request(Message):
    """rosbag2_interfaces/srv/PlayNext_Request

    # Publishes the next message of a paused player.
    """
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class PlayNext_Response(Message):
    """rosbag2_interfaces/srv/PlayNext_Response

    # False if the player is not paused.
    bool success
    """
    def __init__(self, *, success: bool = ..., check_fields: bool = ...) -> None: ...
    success: bool

class PlayNext_Event(Message):
    """rosbag2_interfaces/srv/PlayNext_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[rosbag2_interfaces.srv.PlayNext_Request] = ..., response: Collection[rosbag2_interfaces.srv.PlayNext_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[rosbag2_interfaces.srv.PlayNext_Request]: ...
    @request.setter
    def request(self, value: Collection[rosbag2_interfaces.srv.PlayNext_Request]) -> None: ...
    @property
    def response(self) -> list[rosbag2_interfaces.srv.PlayNext_Response]: ...
    @response.setter
    def response(self, value: Collection[rosbag2_interfaces.srv.PlayNext_Response]) -> None: ...

class PlayNext(Service):
    Request: TypeAlias = PlayNext_Request
    Response: TypeAlias = PlayNext_Response
    Event: TypeAlias = PlayNext_Event

class Resume_Request(Message):
    """rosbag2_interfaces/srv/Resume_Request

    # Ends the pause of a player or a recorder.
    """
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class Resume_Response(Message):
    """rosbag2_interfaces/srv/Resume_Response"""
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class Resume_Event(Message):
    """rosbag2_interfaces/srv/Resume_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[rosbag2_interfaces.srv.Resume_Request] = ..., response: Collection[rosbag2_interfaces.srv.Resume_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[rosbag2_interfaces.srv.Resume_Request]: ...
    @request.setter
    def request(self, value: Collection[rosbag2_interfaces.srv.Resume_Request]) -> None: ...
    @property
    def response(self) -> list[rosbag2_interfaces.srv.Resume_Response]: ...
    @response.setter
    def response(self, value: Collection[rosbag2_interfaces.srv.Resume_Response]) -> None: ...

class Resume(Service):
    Request: TypeAlias = Resume_Request
    Response: TypeAlias = Resume_Response
    Event: TypeAlias = Resume_Event

class Seek_Request(Message):
    """rosbag2_interfaces/srv/Seek_Request

    # Continues a playback from another time.

    # Time in the recording.
    builtin_interfaces/Time time
    """
    def __init__(self, *, time: builtin_interfaces.msg.Time = ..., check_fields: bool = ...) -> None: ...
    time: builtin_interfaces.msg.Time

class Seek_Response(Message):
    """rosbag2_interfaces/srv/Seek_Response

    # False if the time is not in the recording.
    bool success
    """
    def __init__(self, *, success: bool = ..., check_fields: bool = ...) -> None: ...
    success: bool

class Seek_Event(Message):
    """rosbag2_interfaces/srv/Seek_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[rosbag2_interfaces.srv.Seek_Request] = ..., response: Collection[rosbag2_interfaces.srv.Seek_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[rosbag2_interfaces.srv.Seek_Request]: ...
    @request.setter
    def request(self, value: Collection[rosbag2_interfaces.srv.Seek_Request]) -> None: ...
    @property
    def response(self) -> list[rosbag2_interfaces.srv.Seek_Response]: ...
    @response.setter
    def response(self, value: Collection[rosbag2_interfaces.srv.Seek_Response]) -> None: ...

class Seek(Service):
    Request: TypeAlias = Seek_Request
    Response: TypeAlias = Seek_Response
    Event: TypeAlias = Seek_Event

class SetRate_Request(Message):
    """rosbag2_interfaces/srv/SetRate_Request

    # Sets the speed of a player.

    # Seconds of the recording in a second, above 0.
    float64 rate
    """
    def __init__(self, *, rate: float = ..., check_fields: bool = ...) -> None: ...
    rate: float

class SetRate_Response(Message):
    """rosbag2_interfaces/srv/SetRate_Response

    bool success
    """
    def __init__(self, *, success: bool = ..., check_fields: bool = ...) -> None: ...
    success: bool

class SetRate_Event(Message):
    """rosbag2_interfaces/srv/SetRate_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[rosbag2_interfaces.srv.SetRate_Request] = ..., response: Collection[rosbag2_interfaces.srv.SetRate_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[rosbag2_interfaces.srv.SetRate_Request]: ...
    @request.setter
    def request(self, value: Collection[rosbag2_interfaces.srv.SetRate_Request]) -> None: ...
    @property
    def response(self) -> list[rosbag2_interfaces.srv.SetRate_Response]: ...
    @response.setter
    def response(self, value: Collection[rosbag2_interfaces.srv.SetRate_Response]) -> None: ...

class SetRate(Service):
    Request: TypeAlias = SetRate_Request
    Response: TypeAlias = SetRate_Response
    Event: TypeAlias = SetRate_Event

class Snapshot_Request(Message):
    """rosbag2_interfaces/srv/Snapshot_Request

    # Writes the messages that a recorder in snapshot mode keeps in memory.
    """
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class Snapshot_Response(Message):
    """rosbag2_interfaces/srv/Snapshot_Response

    bool success
    """
    def __init__(self, *, success: bool = ..., check_fields: bool = ...) -> None: ...
    success: bool

class Snapshot_Event(Message):
    """rosbag2_interfaces/srv/Snapshot_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[rosbag2_interfaces.srv.Snapshot_Request] = ..., response: Collection[rosbag2_interfaces.srv.Snapshot_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[rosbag2_interfaces.srv.Snapshot_Request]: ...
    @request.setter
    def request(self, value: Collection[rosbag2_interfaces.srv.Snapshot_Request]) -> None: ...
    @property
    def response(self) -> list[rosbag2_interfaces.srv.Snapshot_Response]: ...
    @response.setter
    def response(self, value: Collection[rosbag2_interfaces.srv.Snapshot_Response]) -> None: ...

class Snapshot(Service):
    Request: TypeAlias = Snapshot_Request
    Response: TypeAlias = Snapshot_Response
    Event: TypeAlias = Snapshot_Event

class SplitBagfile_Request(Message):
    """rosbag2_interfaces/srv/SplitBagfile_Request

    # Begins the next file of a recording.
    """
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class SplitBagfile_Response(Message):
    """rosbag2_interfaces/srv/SplitBagfile_Response"""
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class SplitBagfile_Event(Message):
    """rosbag2_interfaces/srv/SplitBagfile_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[rosbag2_interfaces.srv.SplitBagfile_Request] = ..., response: Collection[rosbag2_interfaces.srv.SplitBagfile_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[rosbag2_interfaces.srv.SplitBagfile_Request]: ...
    @request.setter
    def request(self, value: Collection[rosbag2_interfaces.srv.SplitBagfile_Request]) -> None: ...
    @property
    def response(self) -> list[rosbag2_interfaces.srv.SplitBagfile_Response]: ...
    @response.setter
    def response(self, value: Collection[rosbag2_interfaces.srv.SplitBagfile_Response]) -> None: ...

class SplitBagfile(Service):
    Request: TypeAlias = SplitBagfile_Request
    Response: TypeAlias = SplitBagfile_Response
    Event: TypeAlias = SplitBagfile_Event

class Stop_Request(Message):
    """rosbag2_interfaces/srv/Stop_Request

    # Ends a playback.
    """
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class Stop_Response(Message):
    """rosbag2_interfaces/srv/Stop_Response"""
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class Stop_Event(Message):
    """rosbag2_interfaces/srv/Stop_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[rosbag2_interfaces.srv.Stop_Request] = ..., response: Collection[rosbag2_interfaces.srv.Stop_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[rosbag2_interfaces.srv.Stop_Request]: ...
    @request.setter
    def request(self, value: Collection[rosbag2_interfaces.srv.Stop_Request]) -> None: ...
    @property
    def response(self) -> list[rosbag2_interfaces.srv.Stop_Response]: ...
    @response.setter
    def response(self, value: Collection[rosbag2_interfaces.srv.Stop_Response]) -> None: ...

class Stop(Service):
    Request: TypeAlias = Stop_Request
    Response: TypeAlias = Stop_Response
    Event: TypeAlias = Stop_Event

class TogglePaused_Request(Message):
    """rosbag2_interfaces/srv/TogglePaused_Request

    # Pauses a player, or ends its pause.
    """
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class TogglePaused_Response(Message):
    """rosbag2_interfaces/srv/TogglePaused_Response"""
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class TogglePaused_Event(Message):
    """rosbag2_interfaces/srv/TogglePaused_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[rosbag2_interfaces.srv.TogglePaused_Request] = ..., response: Collection[rosbag2_interfaces.srv.TogglePaused_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[rosbag2_interfaces.srv.TogglePaused_Request]: ...
    @request.setter
    def request(self, value: Collection[rosbag2_interfaces.srv.TogglePaused_Request]) -> None: ...
    @property
    def response(self) -> list[rosbag2_interfaces.srv.TogglePaused_Response]: ...
    @response.setter
    def response(self, value: Collection[rosbag2_interfaces.srv.TogglePaused_Response]) -> None: ...

class TogglePaused(Service):
    Request: TypeAlias = TogglePaused_Request
    Response: TypeAlias = TogglePaused_Response
    Event: TypeAlias = TogglePaused_Event
