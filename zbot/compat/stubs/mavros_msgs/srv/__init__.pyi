# Written by python -m zbot.interfaces.stubs; do not edit.
from array import array
from collections.abc import Collection
from typing import Final, TypeAlias

import numpy
from numpy.typing import NDArray

import geometry_msgs.msg
import mavros_msgs.msg
import mavros_msgs.srv
import rcl_interfaces.msg
import service_msgs.msg
import std_msgs.msg
from zbot.interfaces import Action, Message, Service

class CommandAck_Request(Message):
    """mavros_msgs/srv/CommandAck_Request

    uint16 command
    uint8 result
    uint8 progress
    uint32 result_param2
    """
    def __init__(self, *, command: int = ..., result: int = ..., progress: int = ..., result_param2: int = ..., check_fields: bool = ...) -> None: ...
    command: int
    result: int
    progress: int
    result_param2: int

class CommandAck_Response(Message):
    """mavros_msgs/srv/CommandAck_Response

    bool success
    uint8 result
    """
    def __init__(self, *, success: bool = ..., result: int = ..., check_fields: bool = ...) -> None: ...
    success: bool
    result: int

class CommandAck_Event(Message):
    """mavros_msgs/srv/CommandAck_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[mavros_msgs.srv.CommandAck_Request] = ..., response: Collection[mavros_msgs.srv.CommandAck_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[mavros_msgs.srv.CommandAck_Request]: ...
    @request.setter
    def request(self, value: Collection[mavros_msgs.srv.CommandAck_Request]) -> None: ...
    @property
    def response(self) -> list[mavros_msgs.srv.CommandAck_Response]: ...
    @response.setter
    def response(self, value: Collection[mavros_msgs.srv.CommandAck_Response]) -> None: ...

class CommandAck(Service):
    Request: TypeAlias = CommandAck_Request
    Response: TypeAlias = CommandAck_Response
    Event: TypeAlias = CommandAck_Event

class CommandBool_Request(Message):
    """mavros_msgs/srv/CommandBool_Request

    bool value
    """
    def __init__(self, *, value: bool = ..., check_fields: bool = ...) -> None: ...
    value: bool

class CommandBool_Response(Message):
    """mavros_msgs/srv/CommandBool_Response

    bool success
    uint8 result
    """
    def __init__(self, *, success: bool = ..., result: int = ..., check_fields: bool = ...) -> None: ...
    success: bool
    result: int

class CommandBool_Event(Message):
    """mavros_msgs/srv/CommandBool_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[mavros_msgs.srv.CommandBool_Request] = ..., response: Collection[mavros_msgs.srv.CommandBool_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[mavros_msgs.srv.CommandBool_Request]: ...
    @request.setter
    def request(self, value: Collection[mavros_msgs.srv.CommandBool_Request]) -> None: ...
    @property
    def response(self) -> list[mavros_msgs.srv.CommandBool_Response]: ...
    @response.setter
    def response(self, value: Collection[mavros_msgs.srv.CommandBool_Response]) -> None: ...

class CommandBool(Service):
    Request: TypeAlias = CommandBool_Request
    Response: TypeAlias = CommandBool_Response
    Event: TypeAlias = CommandBool_Event

class CommandHome_Request(Message):
    """mavros_msgs/srv/CommandHome_Request

    bool current_gps
    float32 yaw
    float32 latitude
    float32 longitude
    float32 altitude
    """
    def __init__(self, *, current_gps: bool = ..., yaw: float = ..., latitude: float = ..., longitude: float = ..., altitude: float = ..., check_fields: bool = ...) -> None: ...
    current_gps: bool
    yaw: float
    latitude: float
    longitude: float
    altitude: float

class CommandHome_Response(Message):
    """mavros_msgs/srv/CommandHome_Response

    bool success
    uint8 result
    """
    def __init__(self, *, success: bool = ..., result: int = ..., check_fields: bool = ...) -> None: ...
    success: bool
    result: int

class CommandHome_Event(Message):
    """mavros_msgs/srv/CommandHome_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[mavros_msgs.srv.CommandHome_Request] = ..., response: Collection[mavros_msgs.srv.CommandHome_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[mavros_msgs.srv.CommandHome_Request]: ...
    @request.setter
    def request(self, value: Collection[mavros_msgs.srv.CommandHome_Request]) -> None: ...
    @property
    def response(self) -> list[mavros_msgs.srv.CommandHome_Response]: ...
    @response.setter
    def response(self, value: Collection[mavros_msgs.srv.CommandHome_Response]) -> None: ...

class CommandHome(Service):
    Request: TypeAlias = CommandHome_Request
    Response: TypeAlias = CommandHome_Response
    Event: TypeAlias = CommandHome_Event

class CommandInt_Request(Message):
    """mavros_msgs/srv/CommandInt_Request

    bool broadcast
    uint8 frame
    uint16 command
    uint8 current
    uint8 autocontinue
    float32 param1
    float32 param2
    float32 param3
    float32 param4
    int32 x
    int32 y
    float32 z
    """
    def __init__(self, *, broadcast: bool = ..., frame: int = ..., command: int = ..., current: int = ..., autocontinue: int = ..., param1: float = ..., param2: float = ..., param3: float = ..., param4: float = ..., x: int = ..., y: int = ..., z: float = ..., check_fields: bool = ...) -> None: ...
    broadcast: bool
    frame: int
    command: int
    current: int
    autocontinue: int
    param1: float
    param2: float
    param3: float
    param4: float
    x: int
    y: int
    z: float

class CommandInt_Response(Message):
    """mavros_msgs/srv/CommandInt_Response

    bool success
    """
    def __init__(self, *, success: bool = ..., check_fields: bool = ...) -> None: ...
    success: bool

class CommandInt_Event(Message):
    """mavros_msgs/srv/CommandInt_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[mavros_msgs.srv.CommandInt_Request] = ..., response: Collection[mavros_msgs.srv.CommandInt_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[mavros_msgs.srv.CommandInt_Request]: ...
    @request.setter
    def request(self, value: Collection[mavros_msgs.srv.CommandInt_Request]) -> None: ...
    @property
    def response(self) -> list[mavros_msgs.srv.CommandInt_Response]: ...
    @response.setter
    def response(self, value: Collection[mavros_msgs.srv.CommandInt_Response]) -> None: ...

class CommandInt(Service):
    Request: TypeAlias = CommandInt_Request
    Response: TypeAlias = CommandInt_Response
    Event: TypeAlias = CommandInt_Event

class CommandLong_Request(Message):
    """mavros_msgs/srv/CommandLong_Request

    bool broadcast
    uint16 command
    uint8 confirmation
    float32 param1
    float32 param2
    float32 param3
    float32 param4
    float32 param5
    float32 param6
    float32 param7
    """
    def __init__(self, *, broadcast: bool = ..., command: int = ..., confirmation: int = ..., param1: float = ..., param2: float = ..., param3: float = ..., param4: float = ..., param5: float = ..., param6: float = ..., param7: float = ..., check_fields: bool = ...) -> None: ...
    broadcast: bool
    command: int
    confirmation: int
    param1: float
    param2: float
    param3: float
    param4: float
    param5: float
    param6: float
    param7: float

class CommandLong_Response(Message):
    """mavros_msgs/srv/CommandLong_Response

    bool success
    uint8 result
    """
    def __init__(self, *, success: bool = ..., result: int = ..., check_fields: bool = ...) -> None: ...
    success: bool
    result: int

class CommandLong_Event(Message):
    """mavros_msgs/srv/CommandLong_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[mavros_msgs.srv.CommandLong_Request] = ..., response: Collection[mavros_msgs.srv.CommandLong_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[mavros_msgs.srv.CommandLong_Request]: ...
    @request.setter
    def request(self, value: Collection[mavros_msgs.srv.CommandLong_Request]) -> None: ...
    @property
    def response(self) -> list[mavros_msgs.srv.CommandLong_Response]: ...
    @response.setter
    def response(self, value: Collection[mavros_msgs.srv.CommandLong_Response]) -> None: ...

class CommandLong(Service):
    Request: TypeAlias = CommandLong_Request
    Response: TypeAlias = CommandLong_Response
    Event: TypeAlias = CommandLong_Event

class CommandTOL_Request(Message):
    """mavros_msgs/srv/CommandTOL_Request

    float32 min_pitch
    float32 yaw
    float32 latitude
    float32 longitude
    float32 altitude
    """
    def __init__(self, *, min_pitch: float = ..., yaw: float = ..., latitude: float = ..., longitude: float = ..., altitude: float = ..., check_fields: bool = ...) -> None: ...
    min_pitch: float
    yaw: float
    latitude: float
    longitude: float
    altitude: float

class CommandTOL_Response(Message):
    """mavros_msgs/srv/CommandTOL_Response

    bool success
    uint8 result
    """
    def __init__(self, *, success: bool = ..., result: int = ..., check_fields: bool = ...) -> None: ...
    success: bool
    result: int

class CommandTOL_Event(Message):
    """mavros_msgs/srv/CommandTOL_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[mavros_msgs.srv.CommandTOL_Request] = ..., response: Collection[mavros_msgs.srv.CommandTOL_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[mavros_msgs.srv.CommandTOL_Request]: ...
    @request.setter
    def request(self, value: Collection[mavros_msgs.srv.CommandTOL_Request]) -> None: ...
    @property
    def response(self) -> list[mavros_msgs.srv.CommandTOL_Response]: ...
    @response.setter
    def response(self, value: Collection[mavros_msgs.srv.CommandTOL_Response]) -> None: ...

class CommandTOL(Service):
    Request: TypeAlias = CommandTOL_Request
    Response: TypeAlias = CommandTOL_Response
    Event: TypeAlias = CommandTOL_Event

class CommandTOLLocal_Request(Message):
    """mavros_msgs/srv/CommandTOLLocal_Request

    float32 min_pitch
    float32 offset
    float32 rate
    float32 yaw
    geometry_msgs/Vector3 position
    """
    def __init__(self, *, min_pitch: float = ..., offset: float = ..., rate: float = ..., yaw: float = ..., position: geometry_msgs.msg.Vector3 = ..., check_fields: bool = ...) -> None: ...
    min_pitch: float
    offset: float
    rate: float
    yaw: float
    position: geometry_msgs.msg.Vector3

class CommandTOLLocal_Response(Message):
    """mavros_msgs/srv/CommandTOLLocal_Response

    bool success
    uint8 result
    """
    def __init__(self, *, success: bool = ..., result: int = ..., check_fields: bool = ...) -> None: ...
    success: bool
    result: int

class CommandTOLLocal_Event(Message):
    """mavros_msgs/srv/CommandTOLLocal_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[mavros_msgs.srv.CommandTOLLocal_Request] = ..., response: Collection[mavros_msgs.srv.CommandTOLLocal_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[mavros_msgs.srv.CommandTOLLocal_Request]: ...
    @request.setter
    def request(self, value: Collection[mavros_msgs.srv.CommandTOLLocal_Request]) -> None: ...
    @property
    def response(self) -> list[mavros_msgs.srv.CommandTOLLocal_Response]: ...
    @response.setter
    def response(self, value: Collection[mavros_msgs.srv.CommandTOLLocal_Response]) -> None: ...

class CommandTOLLocal(Service):
    Request: TypeAlias = CommandTOLLocal_Request
    Response: TypeAlias = CommandTOLLocal_Response
    Event: TypeAlias = CommandTOLLocal_Event

class CommandTriggerControl_Request(Message):
    """mavros_msgs/srv/CommandTriggerControl_Request

    bool trigger_enable
    bool sequence_reset
    bool trigger_pause
    """
    def __init__(self, *, trigger_enable: bool = ..., sequence_reset: bool = ..., trigger_pause: bool = ..., check_fields: bool = ...) -> None: ...
    trigger_enable: bool
    sequence_reset: bool
    trigger_pause: bool

class CommandTriggerControl_Response(Message):
    """mavros_msgs/srv/CommandTriggerControl_Response

    bool success
    uint8 result
    """
    def __init__(self, *, success: bool = ..., result: int = ..., check_fields: bool = ...) -> None: ...
    success: bool
    result: int

class CommandTriggerControl_Event(Message):
    """mavros_msgs/srv/CommandTriggerControl_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[mavros_msgs.srv.CommandTriggerControl_Request] = ..., response: Collection[mavros_msgs.srv.CommandTriggerControl_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[mavros_msgs.srv.CommandTriggerControl_Request]: ...
    @request.setter
    def request(self, value: Collection[mavros_msgs.srv.CommandTriggerControl_Request]) -> None: ...
    @property
    def response(self) -> list[mavros_msgs.srv.CommandTriggerControl_Response]: ...
    @response.setter
    def response(self, value: Collection[mavros_msgs.srv.CommandTriggerControl_Response]) -> None: ...

class CommandTriggerControl(Service):
    Request: TypeAlias = CommandTriggerControl_Request
    Response: TypeAlias = CommandTriggerControl_Response
    Event: TypeAlias = CommandTriggerControl_Event

class CommandTriggerInterval_Request(Message):
    """mavros_msgs/srv/CommandTriggerInterval_Request

    float32 cycle_time
    float32 integration_time
    """
    def __init__(self, *, cycle_time: float = ..., integration_time: float = ..., check_fields: bool = ...) -> None: ...
    cycle_time: float
    integration_time: float

class CommandTriggerInterval_Response(Message):
    """mavros_msgs/srv/CommandTriggerInterval_Response

    bool success
    uint8 result
    """
    def __init__(self, *, success: bool = ..., result: int = ..., check_fields: bool = ...) -> None: ...
    success: bool
    result: int

class CommandTriggerInterval_Event(Message):
    """mavros_msgs/srv/CommandTriggerInterval_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[mavros_msgs.srv.CommandTriggerInterval_Request] = ..., response: Collection[mavros_msgs.srv.CommandTriggerInterval_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[mavros_msgs.srv.CommandTriggerInterval_Request]: ...
    @request.setter
    def request(self, value: Collection[mavros_msgs.srv.CommandTriggerInterval_Request]) -> None: ...
    @property
    def response(self) -> list[mavros_msgs.srv.CommandTriggerInterval_Response]: ...
    @response.setter
    def response(self, value: Collection[mavros_msgs.srv.CommandTriggerInterval_Response]) -> None: ...

class CommandTriggerInterval(Service):
    Request: TypeAlias = CommandTriggerInterval_Request
    Response: TypeAlias = CommandTriggerInterval_Response
    Event: TypeAlias = CommandTriggerInterval_Event

class CommandVtolTransition_Request(Message):
    """mavros_msgs/srv/CommandVtolTransition_Request

    std_msgs/Header header
    uint8 STATE_MC=3
    uint8 STATE_FW=4
    uint8 state
    """
    STATE_MC: Final = 3
    STATE_FW: Final = 4
    def __init__(self, *, header: std_msgs.msg.Header = ..., state: int = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    state: int

class CommandVtolTransition_Response(Message):
    """mavros_msgs/srv/CommandVtolTransition_Response

    bool success
    uint8 result
    """
    def __init__(self, *, success: bool = ..., result: int = ..., check_fields: bool = ...) -> None: ...
    success: bool
    result: int

class CommandVtolTransition_Event(Message):
    """mavros_msgs/srv/CommandVtolTransition_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[mavros_msgs.srv.CommandVtolTransition_Request] = ..., response: Collection[mavros_msgs.srv.CommandVtolTransition_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[mavros_msgs.srv.CommandVtolTransition_Request]: ...
    @request.setter
    def request(self, value: Collection[mavros_msgs.srv.CommandVtolTransition_Request]) -> None: ...
    @property
    def response(self) -> list[mavros_msgs.srv.CommandVtolTransition_Response]: ...
    @response.setter
    def response(self, value: Collection[mavros_msgs.srv.CommandVtolTransition_Response]) -> None: ...

class CommandVtolTransition(Service):
    Request: TypeAlias = CommandVtolTransition_Request
    Response: TypeAlias = CommandVtolTransition_Response
    Event: TypeAlias = CommandVtolTransition_Event

class EndpointAdd_Request(Message):
    """mavros_msgs/srv/EndpointAdd_Request

    uint8 TYPE_FCU=0
    uint8 TYPE_GCS=1
    uint8 TYPE_UAS=2
    string url
    uint8 type
    """
    TYPE_FCU: Final = 0
    TYPE_GCS: Final = 1
    TYPE_UAS: Final = 2
    def __init__(self, *, url: str = ..., type: int = ..., check_fields: bool = ...) -> None: ...
    url: str
    type: int

class EndpointAdd_Response(Message):
    """mavros_msgs/srv/EndpointAdd_Response

    bool successful
    string reason
    uint32 id
    """
    def __init__(self, *, successful: bool = ..., reason: str = ..., id: int = ..., check_fields: bool = ...) -> None: ...
    successful: bool
    reason: str
    id: int

class EndpointAdd_Event(Message):
    """mavros_msgs/srv/EndpointAdd_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[mavros_msgs.srv.EndpointAdd_Request] = ..., response: Collection[mavros_msgs.srv.EndpointAdd_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[mavros_msgs.srv.EndpointAdd_Request]: ...
    @request.setter
    def request(self, value: Collection[mavros_msgs.srv.EndpointAdd_Request]) -> None: ...
    @property
    def response(self) -> list[mavros_msgs.srv.EndpointAdd_Response]: ...
    @response.setter
    def response(self, value: Collection[mavros_msgs.srv.EndpointAdd_Response]) -> None: ...

class EndpointAdd(Service):
    Request: TypeAlias = EndpointAdd_Request
    Response: TypeAlias = EndpointAdd_Response
    Event: TypeAlias = EndpointAdd_Event

class EndpointDel_Request(Message):
    """mavros_msgs/srv/EndpointDel_Request

    uint8 TYPE_FCU=0
    uint8 TYPE_GCS=1
    uint8 TYPE_UAS=2
    uint32 id
    string url
    uint8 type
    """
    TYPE_FCU: Final = 0
    TYPE_GCS: Final = 1
    TYPE_UAS: Final = 2
    def __init__(self, *, id: int = ..., url: str = ..., type: int = ..., check_fields: bool = ...) -> None: ...
    id: int
    url: str
    type: int

class EndpointDel_Response(Message):
    """mavros_msgs/srv/EndpointDel_Response

    bool successful
    """
    def __init__(self, *, successful: bool = ..., check_fields: bool = ...) -> None: ...
    successful: bool

class EndpointDel_Event(Message):
    """mavros_msgs/srv/EndpointDel_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[mavros_msgs.srv.EndpointDel_Request] = ..., response: Collection[mavros_msgs.srv.EndpointDel_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[mavros_msgs.srv.EndpointDel_Request]: ...
    @request.setter
    def request(self, value: Collection[mavros_msgs.srv.EndpointDel_Request]) -> None: ...
    @property
    def response(self) -> list[mavros_msgs.srv.EndpointDel_Response]: ...
    @response.setter
    def response(self, value: Collection[mavros_msgs.srv.EndpointDel_Response]) -> None: ...

class EndpointDel(Service):
    Request: TypeAlias = EndpointDel_Request
    Response: TypeAlias = EndpointDel_Response
    Event: TypeAlias = EndpointDel_Event

class FileChecksum_Request(Message):
    """mavros_msgs/srv/FileChecksum_Request

    string file_path
    """
    def __init__(self, *, file_path: str = ..., check_fields: bool = ...) -> None: ...
    file_path: str

class FileChecksum_Response(Message):
    """mavros_msgs/srv/FileChecksum_Response

    uint32 crc32
    bool success
    int32 r_errno
    """
    def __init__(self, *, crc32: int = ..., success: bool = ..., r_errno: int = ..., check_fields: bool = ...) -> None: ...
    crc32: int
    success: bool
    r_errno: int

class FileChecksum_Event(Message):
    """mavros_msgs/srv/FileChecksum_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[mavros_msgs.srv.FileChecksum_Request] = ..., response: Collection[mavros_msgs.srv.FileChecksum_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[mavros_msgs.srv.FileChecksum_Request]: ...
    @request.setter
    def request(self, value: Collection[mavros_msgs.srv.FileChecksum_Request]) -> None: ...
    @property
    def response(self) -> list[mavros_msgs.srv.FileChecksum_Response]: ...
    @response.setter
    def response(self, value: Collection[mavros_msgs.srv.FileChecksum_Response]) -> None: ...

class FileChecksum(Service):
    Request: TypeAlias = FileChecksum_Request
    Response: TypeAlias = FileChecksum_Response
    Event: TypeAlias = FileChecksum_Event

class FileClose_Request(Message):
    """mavros_msgs/srv/FileClose_Request

    string file_path
    """
    def __init__(self, *, file_path: str = ..., check_fields: bool = ...) -> None: ...
    file_path: str

class FileClose_Response(Message):
    """mavros_msgs/srv/FileClose_Response

    bool success
    int32 r_errno
    """
    def __init__(self, *, success: bool = ..., r_errno: int = ..., check_fields: bool = ...) -> None: ...
    success: bool
    r_errno: int

class FileClose_Event(Message):
    """mavros_msgs/srv/FileClose_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[mavros_msgs.srv.FileClose_Request] = ..., response: Collection[mavros_msgs.srv.FileClose_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[mavros_msgs.srv.FileClose_Request]: ...
    @request.setter
    def request(self, value: Collection[mavros_msgs.srv.FileClose_Request]) -> None: ...
    @property
    def response(self) -> list[mavros_msgs.srv.FileClose_Response]: ...
    @response.setter
    def response(self, value: Collection[mavros_msgs.srv.FileClose_Response]) -> None: ...

class FileClose(Service):
    Request: TypeAlias = FileClose_Request
    Response: TypeAlias = FileClose_Response
    Event: TypeAlias = FileClose_Event

class FileList_Request(Message):
    """mavros_msgs/srv/FileList_Request

    string dir_path
    """
    def __init__(self, *, dir_path: str = ..., check_fields: bool = ...) -> None: ...
    dir_path: str

class FileList_Response(Message):
    """mavros_msgs/srv/FileList_Response

    mavros_msgs/FileEntry[] list
    bool success
    int32 r_errno
    """
    def __init__(self, *, list: Collection[mavros_msgs.msg.FileEntry] = ..., success: bool = ..., r_errno: int = ..., check_fields: bool = ...) -> None: ...
    @property
    def list(self) -> list[mavros_msgs.msg.FileEntry]: ...
    @list.setter
    def list(self, value: Collection[mavros_msgs.msg.FileEntry]) -> None: ...
    success: bool
    r_errno: int

class FileList_Event(Message):
    """mavros_msgs/srv/FileList_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[mavros_msgs.srv.FileList_Request] = ..., response: Collection[mavros_msgs.srv.FileList_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[mavros_msgs.srv.FileList_Request]: ...
    @request.setter
    def request(self, value: Collection[mavros_msgs.srv.FileList_Request]) -> None: ...
    @property
    def response(self) -> list[mavros_msgs.srv.FileList_Response]: ...
    @response.setter
    def response(self, value: Collection[mavros_msgs.srv.FileList_Response]) -> None: ...

class FileList(Service):
    Request: TypeAlias = FileList_Request
    Response: TypeAlias = FileList_Response
    Event: TypeAlias = FileList_Event

class FileMakeDir_Request(Message):
    """mavros_msgs/srv/FileMakeDir_Request

    string dir_path
    """
    def __init__(self, *, dir_path: str = ..., check_fields: bool = ...) -> None: ...
    dir_path: str

class FileMakeDir_Response(Message):
    """mavros_msgs/srv/FileMakeDir_Response

    bool success
    int32 r_errno
    """
    def __init__(self, *, success: bool = ..., r_errno: int = ..., check_fields: bool = ...) -> None: ...
    success: bool
    r_errno: int

class FileMakeDir_Event(Message):
    """mavros_msgs/srv/FileMakeDir_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[mavros_msgs.srv.FileMakeDir_Request] = ..., response: Collection[mavros_msgs.srv.FileMakeDir_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[mavros_msgs.srv.FileMakeDir_Request]: ...
    @request.setter
    def request(self, value: Collection[mavros_msgs.srv.FileMakeDir_Request]) -> None: ...
    @property
    def response(self) -> list[mavros_msgs.srv.FileMakeDir_Response]: ...
    @response.setter
    def response(self, value: Collection[mavros_msgs.srv.FileMakeDir_Response]) -> None: ...

class FileMakeDir(Service):
    Request: TypeAlias = FileMakeDir_Request
    Response: TypeAlias = FileMakeDir_Response
    Event: TypeAlias = FileMakeDir_Event

class FileOpen_Request(Message):
    """mavros_msgs/srv/FileOpen_Request

    uint8 MODE_READ=0
    uint8 MODE_WRITE=1
    uint8 MODE_CREATE=2
    string file_path
    uint8 mode
    """
    MODE_READ: Final = 0
    MODE_WRITE: Final = 1
    MODE_CREATE: Final = 2
    def __init__(self, *, file_path: str = ..., mode: int = ..., check_fields: bool = ...) -> None: ...
    file_path: str
    mode: int

class FileOpen_Response(Message):
    """mavros_msgs/srv/FileOpen_Response

    uint32 size
    bool success
    int32 r_errno
    """
    def __init__(self, *, size: int = ..., success: bool = ..., r_errno: int = ..., check_fields: bool = ...) -> None: ...
    size: int
    success: bool
    r_errno: int

class FileOpen_Event(Message):
    """mavros_msgs/srv/FileOpen_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[mavros_msgs.srv.FileOpen_Request] = ..., response: Collection[mavros_msgs.srv.FileOpen_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[mavros_msgs.srv.FileOpen_Request]: ...
    @request.setter
    def request(self, value: Collection[mavros_msgs.srv.FileOpen_Request]) -> None: ...
    @property
    def response(self) -> list[mavros_msgs.srv.FileOpen_Response]: ...
    @response.setter
    def response(self, value: Collection[mavros_msgs.srv.FileOpen_Response]) -> None: ...

class FileOpen(Service):
    Request: TypeAlias = FileOpen_Request
    Response: TypeAlias = FileOpen_Response
    Event: TypeAlias = FileOpen_Event

class FileRead_Request(Message):
    """mavros_msgs/srv/FileRead_Request

    string file_path
    uint64 offset
    uint64 size
    """
    def __init__(self, *, file_path: str = ..., offset: int = ..., size: int = ..., check_fields: bool = ...) -> None: ...
    file_path: str
    offset: int
    size: int

class FileRead_Response(Message):
    """mavros_msgs/srv/FileRead_Response

    uint8[] data
    bool success
    int32 r_errno
    """
    def __init__(self, *, data: Collection[int] = ..., success: bool = ..., r_errno: int = ..., check_fields: bool = ...) -> None: ...
    @property
    def data(self) -> array[int]: ...
    @data.setter
    def data(self, value: Collection[int]) -> None: ...
    success: bool
    r_errno: int

class FileRead_Event(Message):
    """mavros_msgs/srv/FileRead_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[mavros_msgs.srv.FileRead_Request] = ..., response: Collection[mavros_msgs.srv.FileRead_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[mavros_msgs.srv.FileRead_Request]: ...
    @request.setter
    def request(self, value: Collection[mavros_msgs.srv.FileRead_Request]) -> None: ...
    @property
    def response(self) -> list[mavros_msgs.srv.FileRead_Response]: ...
    @response.setter
    def response(self, value: Collection[mavros_msgs.srv.FileRead_Response]) -> None: ...

class FileRead(Service):
    Request: TypeAlias = FileRead_Request
    Response: TypeAlias = FileRead_Response
    Event: TypeAlias = FileRead_Event

class FileRemove_Request(Message):
    """mavros_msgs/srv/FileRemove_Request

    string file_path
    """
    def __init__(self, *, file_path: str = ..., check_fields: bool = ...) -> None: ...
    file_path: str

class FileRemove_Response(Message):
    """mavros_msgs/srv/FileRemove_Response

    bool success
    int32 r_errno
    """
    def __init__(self, *, success: bool = ..., r_errno: int = ..., check_fields: bool = ...) -> None: ...
    success: bool
    r_errno: int

class FileRemove_Event(Message):
    """mavros_msgs/srv/FileRemove_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[mavros_msgs.srv.FileRemove_Request] = ..., response: Collection[mavros_msgs.srv.FileRemove_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[mavros_msgs.srv.FileRemove_Request]: ...
    @request.setter
    def request(self, value: Collection[mavros_msgs.srv.FileRemove_Request]) -> None: ...
    @property
    def response(self) -> list[mavros_msgs.srv.FileRemove_Response]: ...
    @response.setter
    def response(self, value: Collection[mavros_msgs.srv.FileRemove_Response]) -> None: ...

class FileRemove(Service):
    Request: TypeAlias = FileRemove_Request
    Response: TypeAlias = FileRemove_Response
    Event: TypeAlias = FileRemove_Event

class FileRemoveDir_Request(Message):
    """mavros_msgs/srv/FileRemoveDir_Request

    string dir_path
    """
    def __init__(self, *, dir_path: str = ..., check_fields: bool = ...) -> None: ...
    dir_path: str

class FileRemoveDir_Response(Message):
    """mavros_msgs/srv/FileRemoveDir_Response

    bool success
    int32 r_errno
    """
    def __init__(self, *, success: bool = ..., r_errno: int = ..., check_fields: bool = ...) -> None: ...
    success: bool
    r_errno: int

class FileRemoveDir_Event(Message):
    """mavros_msgs/srv/FileRemoveDir_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[mavros_msgs.srv.FileRemoveDir_Request] = ..., response: Collection[mavros_msgs.srv.FileRemoveDir_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[mavros_msgs.srv.FileRemoveDir_Request]: ...
    @request.setter
    def request(self, value: Collection[mavros_msgs.srv.FileRemoveDir_Request]) -> None: ...
    @property
    def response(self) -> list[mavros_msgs.srv.FileRemoveDir_Response]: ...
    @response.setter
    def response(self, value: Collection[mavros_msgs.srv.FileRemoveDir_Response]) -> None: ...

class FileRemoveDir(Service):
    Request: TypeAlias = FileRemoveDir_Request
    Response: TypeAlias = FileRemoveDir_Response
    Event: TypeAlias = FileRemoveDir_Event

class FileRename_Request(Message):
    """mavros_msgs/srv/FileRename_Request

    string old_path
    string new_path
    """
    def __init__(self, *, old_path: str = ..., new_path: str = ..., check_fields: bool = ...) -> None: ...
    old_path: str
    new_path: str

class FileRename_Response(Message):
    """mavros_msgs/srv/FileRename_Response

    bool success
    int32 r_errno
    """
    def __init__(self, *, success: bool = ..., r_errno: int = ..., check_fields: bool = ...) -> None: ...
    success: bool
    r_errno: int

class FileRename_Event(Message):
    """mavros_msgs/srv/FileRename_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[mavros_msgs.srv.FileRename_Request] = ..., response: Collection[mavros_msgs.srv.FileRename_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[mavros_msgs.srv.FileRename_Request]: ...
    @request.setter
    def request(self, value: Collection[mavros_msgs.srv.FileRename_Request]) -> None: ...
    @property
    def response(self) -> list[mavros_msgs.srv.FileRename_Response]: ...
    @response.setter
    def response(self, value: Collection[mavros_msgs.srv.FileRename_Response]) -> None: ...

class FileRename(Service):
    Request: TypeAlias = FileRename_Request
    Response: TypeAlias = FileRename_Response
    Event: TypeAlias = FileRename_Event

class FileTruncate_Request(Message):
    """mavros_msgs/srv/FileTruncate_Request

    string file_path
    uint64 length
    """
    def __init__(self, *, file_path: str = ..., length: int = ..., check_fields: bool = ...) -> None: ...
    file_path: str
    length: int

class FileTruncate_Response(Message):
    """mavros_msgs/srv/FileTruncate_Response

    bool success
    int32 r_errno
    """
    def __init__(self, *, success: bool = ..., r_errno: int = ..., check_fields: bool = ...) -> None: ...
    success: bool
    r_errno: int

class FileTruncate_Event(Message):
    """mavros_msgs/srv/FileTruncate_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[mavros_msgs.srv.FileTruncate_Request] = ..., response: Collection[mavros_msgs.srv.FileTruncate_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[mavros_msgs.srv.FileTruncate_Request]: ...
    @request.setter
    def request(self, value: Collection[mavros_msgs.srv.FileTruncate_Request]) -> None: ...
    @property
    def response(self) -> list[mavros_msgs.srv.FileTruncate_Response]: ...
    @response.setter
    def response(self, value: Collection[mavros_msgs.srv.FileTruncate_Response]) -> None: ...

class FileTruncate(Service):
    Request: TypeAlias = FileTruncate_Request
    Response: TypeAlias = FileTruncate_Response
    Event: TypeAlias = FileTruncate_Event

class FileWrite_Request(Message):
    """mavros_msgs/srv/FileWrite_Request

    string file_path
    uint64 offset
    uint8[] data
    """
    def __init__(self, *, file_path: str = ..., offset: int = ..., data: Collection[int] = ..., check_fields: bool = ...) -> None: ...
    file_path: str
    offset: int
    @property
    def data(self) -> array[int]: ...
    @data.setter
    def data(self, value: Collection[int]) -> None: ...

class FileWrite_Response(Message):
    """mavros_msgs/srv/FileWrite_Response

    bool success
    int32 r_errno
    """
    def __init__(self, *, success: bool = ..., r_errno: int = ..., check_fields: bool = ...) -> None: ...
    success: bool
    r_errno: int

class FileWrite_Event(Message):
    """mavros_msgs/srv/FileWrite_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[mavros_msgs.srv.FileWrite_Request] = ..., response: Collection[mavros_msgs.srv.FileWrite_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[mavros_msgs.srv.FileWrite_Request]: ...
    @request.setter
    def request(self, value: Collection[mavros_msgs.srv.FileWrite_Request]) -> None: ...
    @property
    def response(self) -> list[mavros_msgs.srv.FileWrite_Response]: ...
    @response.setter
    def response(self, value: Collection[mavros_msgs.srv.FileWrite_Response]) -> None: ...

class FileWrite(Service):
    Request: TypeAlias = FileWrite_Request
    Response: TypeAlias = FileWrite_Response
    Event: TypeAlias = FileWrite_Event

class GimbalGetInformation_Request(Message):
    """mavros_msgs/srv/GimbalGetInformation_Request"""
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class GimbalGetInformation_Response(Message):
    """mavros_msgs/srv/GimbalGetInformation_Response

    bool success
    uint8 result
    """
    def __init__(self, *, success: bool = ..., result: int = ..., check_fields: bool = ...) -> None: ...
    success: bool
    result: int

class GimbalGetInformation_Event(Message):
    """mavros_msgs/srv/GimbalGetInformation_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[mavros_msgs.srv.GimbalGetInformation_Request] = ..., response: Collection[mavros_msgs.srv.GimbalGetInformation_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[mavros_msgs.srv.GimbalGetInformation_Request]: ...
    @request.setter
    def request(self, value: Collection[mavros_msgs.srv.GimbalGetInformation_Request]) -> None: ...
    @property
    def response(self) -> list[mavros_msgs.srv.GimbalGetInformation_Response]: ...
    @response.setter
    def response(self, value: Collection[mavros_msgs.srv.GimbalGetInformation_Response]) -> None: ...

class GimbalGetInformation(Service):
    Request: TypeAlias = GimbalGetInformation_Request
    Response: TypeAlias = GimbalGetInformation_Response
    Event: TypeAlias = GimbalGetInformation_Event

class GimbalManagerCameraTrack_Request(Message):
    """mavros_msgs/srv/GimbalManagerCameraTrack_Request

    uint8 mode
    uint8 CAMERA_TRACK_MODE_POINT=0
    uint8 CAMERA_TRACK_MODE_RECTANGLE=1
    uint8 CAMERA_TRACK_MODE_STOP_TRACKING=2
    float32 x
    float32 y
    float32 radius
    float32 top_left_x
    float32 top_left_y
    float32 bottom_right_x
    float32 bottom_right_y
    """
    CAMERA_TRACK_MODE_POINT: Final = 0
    CAMERA_TRACK_MODE_RECTANGLE: Final = 1
    CAMERA_TRACK_MODE_STOP_TRACKING: Final = 2
    def __init__(self, *, mode: int = ..., x: float = ..., y: float = ..., radius: float = ..., top_left_x: float = ..., top_left_y: float = ..., bottom_right_x: float = ..., bottom_right_y: float = ..., check_fields: bool = ...) -> None: ...
    mode: int
    x: float
    y: float
    radius: float
    top_left_x: float
    top_left_y: float
    bottom_right_x: float
    bottom_right_y: float

class GimbalManagerCameraTrack_Response(Message):
    """mavros_msgs/srv/GimbalManagerCameraTrack_Response

    bool success
    uint8 result
    """
    def __init__(self, *, success: bool = ..., result: int = ..., check_fields: bool = ...) -> None: ...
    success: bool
    result: int

class GimbalManagerCameraTrack_Event(Message):
    """mavros_msgs/srv/GimbalManagerCameraTrack_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[mavros_msgs.srv.GimbalManagerCameraTrack_Request] = ..., response: Collection[mavros_msgs.srv.GimbalManagerCameraTrack_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[mavros_msgs.srv.GimbalManagerCameraTrack_Request]: ...
    @request.setter
    def request(self, value: Collection[mavros_msgs.srv.GimbalManagerCameraTrack_Request]) -> None: ...
    @property
    def response(self) -> list[mavros_msgs.srv.GimbalManagerCameraTrack_Response]: ...
    @response.setter
    def response(self, value: Collection[mavros_msgs.srv.GimbalManagerCameraTrack_Response]) -> None: ...

class GimbalManagerCameraTrack(Service):
    Request: TypeAlias = GimbalManagerCameraTrack_Request
    Response: TypeAlias = GimbalManagerCameraTrack_Response
    Event: TypeAlias = GimbalManagerCameraTrack_Event

class GimbalManagerConfigure_Request(Message):
    """mavros_msgs/srv/GimbalManagerConfigure_Request

    int16 sysid_primary
    int16 compid_primary
    int16 sysid_secondary
    int16 compid_secondary
    uint8 gimbal_device_id
    """
    def __init__(self, *, sysid_primary: int = ..., compid_primary: int = ..., sysid_secondary: int = ..., compid_secondary: int = ..., gimbal_device_id: int = ..., check_fields: bool = ...) -> None: ...
    sysid_primary: int
    compid_primary: int
    sysid_secondary: int
    compid_secondary: int
    gimbal_device_id: int

class GimbalManagerConfigure_Response(Message):
    """mavros_msgs/srv/GimbalManagerConfigure_Response

    bool success
    uint8 result
    """
    def __init__(self, *, success: bool = ..., result: int = ..., check_fields: bool = ...) -> None: ...
    success: bool
    result: int

class GimbalManagerConfigure_Event(Message):
    """mavros_msgs/srv/GimbalManagerConfigure_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[mavros_msgs.srv.GimbalManagerConfigure_Request] = ..., response: Collection[mavros_msgs.srv.GimbalManagerConfigure_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[mavros_msgs.srv.GimbalManagerConfigure_Request]: ...
    @request.setter
    def request(self, value: Collection[mavros_msgs.srv.GimbalManagerConfigure_Request]) -> None: ...
    @property
    def response(self) -> list[mavros_msgs.srv.GimbalManagerConfigure_Response]: ...
    @response.setter
    def response(self, value: Collection[mavros_msgs.srv.GimbalManagerConfigure_Response]) -> None: ...

class GimbalManagerConfigure(Service):
    Request: TypeAlias = GimbalManagerConfigure_Request
    Response: TypeAlias = GimbalManagerConfigure_Response
    Event: TypeAlias = GimbalManagerConfigure_Event

class GimbalManagerPitchyaw_Request(Message):
    """mavros_msgs/srv/GimbalManagerPitchyaw_Request

    float32 pitch
    float32 yaw
    float32 pitch_rate
    float32 yaw_rate
    uint32 flags
    uint32 GIMBAL_MANAGER_FLAGS_RETRACT=1
    uint32 GIMBAL_MANAGER_FLAGS_NEUTRAL=2
    uint32 GIMBAL_MANAGER_FLAGS_ROLL_LOCK=4
    uint32 GIMBAL_MANAGER_FLAGS_PITCH_LOCK=8
    uint32 GIMBAL_MANAGER_FLAGS_YAW_LOCK=16
    uint8 gimbal_device_id
    """
    GIMBAL_MANAGER_FLAGS_RETRACT: Final = 1
    GIMBAL_MANAGER_FLAGS_NEUTRAL: Final = 2
    GIMBAL_MANAGER_FLAGS_ROLL_LOCK: Final = 4
    GIMBAL_MANAGER_FLAGS_PITCH_LOCK: Final = 8
    GIMBAL_MANAGER_FLAGS_YAW_LOCK: Final = 16
    def __init__(self, *, pitch: float = ..., yaw: float = ..., pitch_rate: float = ..., yaw_rate: float = ..., flags: int = ..., gimbal_device_id: int = ..., check_fields: bool = ...) -> None: ...
    pitch: float
    yaw: float
    pitch_rate: float
    yaw_rate: float
    flags: int
    gimbal_device_id: int

class GimbalManagerPitchyaw_Response(Message):
    """mavros_msgs/srv/GimbalManagerPitchyaw_Response

    bool success
    uint8 result
    """
    def __init__(self, *, success: bool = ..., result: int = ..., check_fields: bool = ...) -> None: ...
    success: bool
    result: int

class GimbalManagerPitchyaw_Event(Message):
    """mavros_msgs/srv/GimbalManagerPitchyaw_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[mavros_msgs.srv.GimbalManagerPitchyaw_Request] = ..., response: Collection[mavros_msgs.srv.GimbalManagerPitchyaw_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[mavros_msgs.srv.GimbalManagerPitchyaw_Request]: ...
    @request.setter
    def request(self, value: Collection[mavros_msgs.srv.GimbalManagerPitchyaw_Request]) -> None: ...
    @property
    def response(self) -> list[mavros_msgs.srv.GimbalManagerPitchyaw_Response]: ...
    @response.setter
    def response(self, value: Collection[mavros_msgs.srv.GimbalManagerPitchyaw_Response]) -> None: ...

class GimbalManagerPitchyaw(Service):
    Request: TypeAlias = GimbalManagerPitchyaw_Request
    Response: TypeAlias = GimbalManagerPitchyaw_Response
    Event: TypeAlias = GimbalManagerPitchyaw_Event

class GimbalManagerSetRoi_Request(Message):
    """mavros_msgs/srv/GimbalManagerSetRoi_Request

    uint8 mode
    uint8 ROI_MODE_LOCATION=0
    uint8 ROI_MODE_WP_NEXT_OFFSET=1
    uint8 ROI_MODE_SYSID=2
    uint8 ROI_MODE_NONE=3
    uint8 gimbal_device_id
    float32 latitude
    float32 longitude
    float32 altitude
    float32 pitch_offset
    float32 roll_offset
    float32 yaw_offset
    uint8 sysid
    """
    ROI_MODE_LOCATION: Final = 0
    ROI_MODE_WP_NEXT_OFFSET: Final = 1
    ROI_MODE_SYSID: Final = 2
    ROI_MODE_NONE: Final = 3
    def __init__(self, *, mode: int = ..., gimbal_device_id: int = ..., latitude: float = ..., longitude: float = ..., altitude: float = ..., pitch_offset: float = ..., roll_offset: float = ..., yaw_offset: float = ..., sysid: int = ..., check_fields: bool = ...) -> None: ...
    mode: int
    gimbal_device_id: int
    latitude: float
    longitude: float
    altitude: float
    pitch_offset: float
    roll_offset: float
    yaw_offset: float
    sysid: int

class GimbalManagerSetRoi_Response(Message):
    """mavros_msgs/srv/GimbalManagerSetRoi_Response

    bool success
    uint8 result
    """
    def __init__(self, *, success: bool = ..., result: int = ..., check_fields: bool = ...) -> None: ...
    success: bool
    result: int

class GimbalManagerSetRoi_Event(Message):
    """mavros_msgs/srv/GimbalManagerSetRoi_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[mavros_msgs.srv.GimbalManagerSetRoi_Request] = ..., response: Collection[mavros_msgs.srv.GimbalManagerSetRoi_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[mavros_msgs.srv.GimbalManagerSetRoi_Request]: ...
    @request.setter
    def request(self, value: Collection[mavros_msgs.srv.GimbalManagerSetRoi_Request]) -> None: ...
    @property
    def response(self) -> list[mavros_msgs.srv.GimbalManagerSetRoi_Response]: ...
    @response.setter
    def response(self, value: Collection[mavros_msgs.srv.GimbalManagerSetRoi_Response]) -> None: ...

class GimbalManagerSetRoi(Service):
    Request: TypeAlias = GimbalManagerSetRoi_Request
    Response: TypeAlias = GimbalManagerSetRoi_Response
    Event: TypeAlias = GimbalManagerSetRoi_Event

class LogRequestData_Request(Message):
    """mavros_msgs/srv/LogRequestData_Request

    uint16 id
    uint32 offset
    uint32 count
    """
    def __init__(self, *, id: int = ..., offset: int = ..., count: int = ..., check_fields: bool = ...) -> None: ...
    id: int
    offset: int
    count: int

class LogRequestData_Response(Message):
    """mavros_msgs/srv/LogRequestData_Response

    bool success
    """
    def __init__(self, *, success: bool = ..., check_fields: bool = ...) -> None: ...
    success: bool

class LogRequestData_Event(Message):
    """mavros_msgs/srv/LogRequestData_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[mavros_msgs.srv.LogRequestData_Request] = ..., response: Collection[mavros_msgs.srv.LogRequestData_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[mavros_msgs.srv.LogRequestData_Request]: ...
    @request.setter
    def request(self, value: Collection[mavros_msgs.srv.LogRequestData_Request]) -> None: ...
    @property
    def response(self) -> list[mavros_msgs.srv.LogRequestData_Response]: ...
    @response.setter
    def response(self, value: Collection[mavros_msgs.srv.LogRequestData_Response]) -> None: ...

class LogRequestData(Service):
    Request: TypeAlias = LogRequestData_Request
    Response: TypeAlias = LogRequestData_Response
    Event: TypeAlias = LogRequestData_Event

class LogRequestEnd_Request(Message):
    """mavros_msgs/srv/LogRequestEnd_Request"""
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class LogRequestEnd_Response(Message):
    """mavros_msgs/srv/LogRequestEnd_Response

    bool success
    """
    def __init__(self, *, success: bool = ..., check_fields: bool = ...) -> None: ...
    success: bool

class LogRequestEnd_Event(Message):
    """mavros_msgs/srv/LogRequestEnd_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[mavros_msgs.srv.LogRequestEnd_Request] = ..., response: Collection[mavros_msgs.srv.LogRequestEnd_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[mavros_msgs.srv.LogRequestEnd_Request]: ...
    @request.setter
    def request(self, value: Collection[mavros_msgs.srv.LogRequestEnd_Request]) -> None: ...
    @property
    def response(self) -> list[mavros_msgs.srv.LogRequestEnd_Response]: ...
    @response.setter
    def response(self, value: Collection[mavros_msgs.srv.LogRequestEnd_Response]) -> None: ...

class LogRequestEnd(Service):
    Request: TypeAlias = LogRequestEnd_Request
    Response: TypeAlias = LogRequestEnd_Response
    Event: TypeAlias = LogRequestEnd_Event

class LogRequestList_Request(Message):
    """mavros_msgs/srv/LogRequestList_Request

    uint16 start
    uint16 end
    """
    def __init__(self, *, start: int = ..., end: int = ..., check_fields: bool = ...) -> None: ...
    start: int
    end: int

class LogRequestList_Response(Message):
    """mavros_msgs/srv/LogRequestList_Response

    bool success
    """
    def __init__(self, *, success: bool = ..., check_fields: bool = ...) -> None: ...
    success: bool

class LogRequestList_Event(Message):
    """mavros_msgs/srv/LogRequestList_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[mavros_msgs.srv.LogRequestList_Request] = ..., response: Collection[mavros_msgs.srv.LogRequestList_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[mavros_msgs.srv.LogRequestList_Request]: ...
    @request.setter
    def request(self, value: Collection[mavros_msgs.srv.LogRequestList_Request]) -> None: ...
    @property
    def response(self) -> list[mavros_msgs.srv.LogRequestList_Response]: ...
    @response.setter
    def response(self, value: Collection[mavros_msgs.srv.LogRequestList_Response]) -> None: ...

class LogRequestList(Service):
    Request: TypeAlias = LogRequestList_Request
    Response: TypeAlias = LogRequestList_Response
    Event: TypeAlias = LogRequestList_Event

class MessageInterval_Request(Message):
    """mavros_msgs/srv/MessageInterval_Request

    uint32 message_id
    float32 message_rate
    """
    def __init__(self, *, message_id: int = ..., message_rate: float = ..., check_fields: bool = ...) -> None: ...
    message_id: int
    message_rate: float

class MessageInterval_Response(Message):
    """mavros_msgs/srv/MessageInterval_Response

    bool success
    """
    def __init__(self, *, success: bool = ..., check_fields: bool = ...) -> None: ...
    success: bool

class MessageInterval_Event(Message):
    """mavros_msgs/srv/MessageInterval_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[mavros_msgs.srv.MessageInterval_Request] = ..., response: Collection[mavros_msgs.srv.MessageInterval_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[mavros_msgs.srv.MessageInterval_Request]: ...
    @request.setter
    def request(self, value: Collection[mavros_msgs.srv.MessageInterval_Request]) -> None: ...
    @property
    def response(self) -> list[mavros_msgs.srv.MessageInterval_Response]: ...
    @response.setter
    def response(self, value: Collection[mavros_msgs.srv.MessageInterval_Response]) -> None: ...

class MessageInterval(Service):
    Request: TypeAlias = MessageInterval_Request
    Response: TypeAlias = MessageInterval_Response
    Event: TypeAlias = MessageInterval_Event

class MountConfigure_Request(Message):
    """mavros_msgs/srv/MountConfigure_Request

    std_msgs/Header header
    uint8 mode
    uint8 MODE_RETRACT=0
    uint8 MODE_NEUTRAL=1
    uint8 MODE_MAVLINK_TARGETING=2
    uint8 MODE_RC_TARGETING=3
    uint8 MODE_GPS_POINT=4
    bool stabilize_roll
    bool stabilize_pitch
    bool stabilize_yaw
    uint8 roll_input
    uint8 pitch_input
    uint8 yaw_input
    uint8 INPUT_ANGLE_BODY_FRAME=0
    uint8 INPUT_ANGULAR_RATE=1
    uint8 INPUT_ANGLE_ABSOLUTE_FRAME=2
    """
    MODE_RETRACT: Final = 0
    MODE_NEUTRAL: Final = 1
    MODE_MAVLINK_TARGETING: Final = 2
    MODE_RC_TARGETING: Final = 3
    MODE_GPS_POINT: Final = 4
    INPUT_ANGLE_BODY_FRAME: Final = 0
    INPUT_ANGULAR_RATE: Final = 1
    INPUT_ANGLE_ABSOLUTE_FRAME: Final = 2
    def __init__(self, *, header: std_msgs.msg.Header = ..., mode: int = ..., stabilize_roll: bool = ..., stabilize_pitch: bool = ..., stabilize_yaw: bool = ..., roll_input: int = ..., pitch_input: int = ..., yaw_input: int = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    mode: int
    stabilize_roll: bool
    stabilize_pitch: bool
    stabilize_yaw: bool
    roll_input: int
    pitch_input: int
    yaw_input: int

class MountConfigure_Response(Message):
    """mavros_msgs/srv/MountConfigure_Response

    bool success
    uint8 result
    """
    def __init__(self, *, success: bool = ..., result: int = ..., check_fields: bool = ...) -> None: ...
    success: bool
    result: int

class MountConfigure_Event(Message):
    """mavros_msgs/srv/MountConfigure_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[mavros_msgs.srv.MountConfigure_Request] = ..., response: Collection[mavros_msgs.srv.MountConfigure_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[mavros_msgs.srv.MountConfigure_Request]: ...
    @request.setter
    def request(self, value: Collection[mavros_msgs.srv.MountConfigure_Request]) -> None: ...
    @property
    def response(self) -> list[mavros_msgs.srv.MountConfigure_Response]: ...
    @response.setter
    def response(self, value: Collection[mavros_msgs.srv.MountConfigure_Response]) -> None: ...

class MountConfigure(Service):
    Request: TypeAlias = MountConfigure_Request
    Response: TypeAlias = MountConfigure_Response
    Event: TypeAlias = MountConfigure_Event

class ParamGet_Request(Message):
    """mavros_msgs/srv/ParamGet_Request

    string param_id
    """
    def __init__(self, *, param_id: str = ..., check_fields: bool = ...) -> None: ...
    param_id: str

class ParamGet_Response(Message):
    """mavros_msgs/srv/ParamGet_Response

    bool success
    ParamValue value
    """
    def __init__(self, *, success: bool = ..., value: mavros_msgs.msg.ParamValue = ..., check_fields: bool = ...) -> None: ...
    success: bool
    value: mavros_msgs.msg.ParamValue

class ParamGet_Event(Message):
    """mavros_msgs/srv/ParamGet_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[mavros_msgs.srv.ParamGet_Request] = ..., response: Collection[mavros_msgs.srv.ParamGet_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[mavros_msgs.srv.ParamGet_Request]: ...
    @request.setter
    def request(self, value: Collection[mavros_msgs.srv.ParamGet_Request]) -> None: ...
    @property
    def response(self) -> list[mavros_msgs.srv.ParamGet_Response]: ...
    @response.setter
    def response(self, value: Collection[mavros_msgs.srv.ParamGet_Response]) -> None: ...

class ParamGet(Service):
    Request: TypeAlias = ParamGet_Request
    Response: TypeAlias = ParamGet_Response
    Event: TypeAlias = ParamGet_Event

class ParamPull_Request(Message):
    """mavros_msgs/srv/ParamPull_Request

    bool force_pull
    """
    def __init__(self, *, force_pull: bool = ..., check_fields: bool = ...) -> None: ...
    force_pull: bool

class ParamPull_Response(Message):
    """mavros_msgs/srv/ParamPull_Response

    bool success
    uint32 param_received
    """
    def __init__(self, *, success: bool = ..., param_received: int = ..., check_fields: bool = ...) -> None: ...
    success: bool
    param_received: int

class ParamPull_Event(Message):
    """mavros_msgs/srv/ParamPull_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[mavros_msgs.srv.ParamPull_Request] = ..., response: Collection[mavros_msgs.srv.ParamPull_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[mavros_msgs.srv.ParamPull_Request]: ...
    @request.setter
    def request(self, value: Collection[mavros_msgs.srv.ParamPull_Request]) -> None: ...
    @property
    def response(self) -> list[mavros_msgs.srv.ParamPull_Response]: ...
    @response.setter
    def response(self, value: Collection[mavros_msgs.srv.ParamPull_Response]) -> None: ...

class ParamPull(Service):
    Request: TypeAlias = ParamPull_Request
    Response: TypeAlias = ParamPull_Response
    Event: TypeAlias = ParamPull_Event

class ParamPush_Request(Message):
    """mavros_msgs/srv/ParamPush_Request"""
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class ParamPush_Response(Message):
    """mavros_msgs/srv/ParamPush_Response

    bool success
    uint32 param_transfered
    """
    def __init__(self, *, success: bool = ..., param_transfered: int = ..., check_fields: bool = ...) -> None: ...
    success: bool
    param_transfered: int

class ParamPush_Event(Message):
    """mavros_msgs/srv/ParamPush_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[mavros_msgs.srv.ParamPush_Request] = ..., response: Collection[mavros_msgs.srv.ParamPush_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[mavros_msgs.srv.ParamPush_Request]: ...
    @request.setter
    def request(self, value: Collection[mavros_msgs.srv.ParamPush_Request]) -> None: ...
    @property
    def response(self) -> list[mavros_msgs.srv.ParamPush_Response]: ...
    @response.setter
    def response(self, value: Collection[mavros_msgs.srv.ParamPush_Response]) -> None: ...

class ParamPush(Service):
    Request: TypeAlias = ParamPush_Request
    Response: TypeAlias = ParamPush_Response
    Event: TypeAlias = ParamPush_Event

class ParamSet_Request(Message):
    """mavros_msgs/srv/ParamSet_Request

    string param_id
    mavros_msgs/ParamValue value
    """
    def __init__(self, *, param_id: str = ..., value: mavros_msgs.msg.ParamValue = ..., check_fields: bool = ...) -> None: ...
    param_id: str
    value: mavros_msgs.msg.ParamValue

class ParamSet_Response(Message):
    """mavros_msgs/srv/ParamSet_Response

    bool success
    mavros_msgs/ParamValue value
    """
    def __init__(self, *, success: bool = ..., value: mavros_msgs.msg.ParamValue = ..., check_fields: bool = ...) -> None: ...
    success: bool
    value: mavros_msgs.msg.ParamValue

class ParamSet_Event(Message):
    """mavros_msgs/srv/ParamSet_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[mavros_msgs.srv.ParamSet_Request] = ..., response: Collection[mavros_msgs.srv.ParamSet_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[mavros_msgs.srv.ParamSet_Request]: ...
    @request.setter
    def request(self, value: Collection[mavros_msgs.srv.ParamSet_Request]) -> None: ...
    @property
    def response(self) -> list[mavros_msgs.srv.ParamSet_Response]: ...
    @response.setter
    def response(self, value: Collection[mavros_msgs.srv.ParamSet_Response]) -> None: ...

class ParamSet(Service):
    Request: TypeAlias = ParamSet_Request
    Response: TypeAlias = ParamSet_Response
    Event: TypeAlias = ParamSet_Event

class ParamSetV2_Request(Message):
    """mavros_msgs/srv/ParamSetV2_Request

    bool force_set
    string param_id
    rcl_interfaces/ParameterValue value
    """
    def __init__(self, *, force_set: bool = ..., param_id: str = ..., value: rcl_interfaces.msg.ParameterValue = ..., check_fields: bool = ...) -> None: ...
    force_set: bool
    param_id: str
    value: rcl_interfaces.msg.ParameterValue

class ParamSetV2_Response(Message):
    """mavros_msgs/srv/ParamSetV2_Response

    bool success
    rcl_interfaces/ParameterValue value
    """
    def __init__(self, *, success: bool = ..., value: rcl_interfaces.msg.ParameterValue = ..., check_fields: bool = ...) -> None: ...
    success: bool
    value: rcl_interfaces.msg.ParameterValue

class ParamSetV2_Event(Message):
    """mavros_msgs/srv/ParamSetV2_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[mavros_msgs.srv.ParamSetV2_Request] = ..., response: Collection[mavros_msgs.srv.ParamSetV2_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[mavros_msgs.srv.ParamSetV2_Request]: ...
    @request.setter
    def request(self, value: Collection[mavros_msgs.srv.ParamSetV2_Request]) -> None: ...
    @property
    def response(self) -> list[mavros_msgs.srv.ParamSetV2_Response]: ...
    @response.setter
    def response(self, value: Collection[mavros_msgs.srv.ParamSetV2_Response]) -> None: ...

class ParamSetV2(Service):
    Request: TypeAlias = ParamSetV2_Request
    Response: TypeAlias = ParamSetV2_Response
    Event: TypeAlias = ParamSetV2_Event

class SetMavFrame_Request(Message):
    """mavros_msgs/srv/SetMavFrame_Request

    uint8 FRAME_GLOBAL=0
    uint8 FRAME_LOCAL_NED=1
    uint8 FRAME_MISSION=2
    uint8 FRAME_GLOBAL_RELATIVE_ALT=3
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
    uint8 mav_frame
    """
    FRAME_GLOBAL: Final = 0
    FRAME_LOCAL_NED: Final = 1
    FRAME_MISSION: Final = 2
    FRAME_GLOBAL_RELATIVE_ALT: Final = 3
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
    def __init__(self, *, mav_frame: int = ..., check_fields: bool = ...) -> None: ...
    mav_frame: int

class SetMavFrame_Response(Message):
    """mavros_msgs/srv/SetMavFrame_Response

    bool success
    """
    def __init__(self, *, success: bool = ..., check_fields: bool = ...) -> None: ...
    success: bool

class SetMavFrame_Event(Message):
    """mavros_msgs/srv/SetMavFrame_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[mavros_msgs.srv.SetMavFrame_Request] = ..., response: Collection[mavros_msgs.srv.SetMavFrame_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[mavros_msgs.srv.SetMavFrame_Request]: ...
    @request.setter
    def request(self, value: Collection[mavros_msgs.srv.SetMavFrame_Request]) -> None: ...
    @property
    def response(self) -> list[mavros_msgs.srv.SetMavFrame_Response]: ...
    @response.setter
    def response(self, value: Collection[mavros_msgs.srv.SetMavFrame_Response]) -> None: ...

class SetMavFrame(Service):
    Request: TypeAlias = SetMavFrame_Request
    Response: TypeAlias = SetMavFrame_Response
    Event: TypeAlias = SetMavFrame_Event

class SetMode_Request(Message):
    """mavros_msgs/srv/SetMode_Request

    uint8 MAV_MODE_PREFLIGHT=0
    uint8 MAV_MODE_STABILIZE_DISARMED=80
    uint8 MAV_MODE_STABILIZE_ARMED=208
    uint8 MAV_MODE_MANUAL_DISARMED=64
    uint8 MAV_MODE_MANUAL_ARMED=192
    uint8 MAV_MODE_GUIDED_DISARMED=88
    uint8 MAV_MODE_GUIDED_ARMED=216
    uint8 MAV_MODE_AUTO_DISARMED=92
    uint8 MAV_MODE_AUTO_ARMED=220
    uint8 MAV_MODE_TEST_DISARMED=66
    uint8 MAV_MODE_TEST_ARMED=194
    uint8 base_mode
    string custom_mode
    """
    MAV_MODE_PREFLIGHT: Final = 0
    MAV_MODE_STABILIZE_DISARMED: Final = 80
    MAV_MODE_STABILIZE_ARMED: Final = 208
    MAV_MODE_MANUAL_DISARMED: Final = 64
    MAV_MODE_MANUAL_ARMED: Final = 192
    MAV_MODE_GUIDED_DISARMED: Final = 88
    MAV_MODE_GUIDED_ARMED: Final = 216
    MAV_MODE_AUTO_DISARMED: Final = 92
    MAV_MODE_AUTO_ARMED: Final = 220
    MAV_MODE_TEST_DISARMED: Final = 66
    MAV_MODE_TEST_ARMED: Final = 194
    def __init__(self, *, base_mode: int = ..., custom_mode: str = ..., check_fields: bool = ...) -> None: ...
    base_mode: int
    custom_mode: str

class SetMode_Response(Message):
    """mavros_msgs/srv/SetMode_Response

    bool mode_sent
    """
    def __init__(self, *, mode_sent: bool = ..., check_fields: bool = ...) -> None: ...
    mode_sent: bool

class SetMode_Event(Message):
    """mavros_msgs/srv/SetMode_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[mavros_msgs.srv.SetMode_Request] = ..., response: Collection[mavros_msgs.srv.SetMode_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[mavros_msgs.srv.SetMode_Request]: ...
    @request.setter
    def request(self, value: Collection[mavros_msgs.srv.SetMode_Request]) -> None: ...
    @property
    def response(self) -> list[mavros_msgs.srv.SetMode_Response]: ...
    @response.setter
    def response(self, value: Collection[mavros_msgs.srv.SetMode_Response]) -> None: ...

class SetMode(Service):
    Request: TypeAlias = SetMode_Request
    Response: TypeAlias = SetMode_Response
    Event: TypeAlias = SetMode_Event

class StreamRate_Request(Message):
    """mavros_msgs/srv/StreamRate_Request

    uint8 STREAM_ALL=0
    uint8 STREAM_RAW_SENSORS=1
    uint8 STREAM_EXTENDED_STATUS=2
    uint8 STREAM_RC_CHANNELS=3
    uint8 STREAM_RAW_CONTROLLER=4
    uint8 STREAM_POSITION=6
    uint8 STREAM_EXTRA1=10
    uint8 STREAM_EXTRA2=11
    uint8 STREAM_EXTRA3=12
    uint8 stream_id
    uint16 message_rate
    bool on_off
    """
    STREAM_ALL: Final = 0
    STREAM_RAW_SENSORS: Final = 1
    STREAM_EXTENDED_STATUS: Final = 2
    STREAM_RC_CHANNELS: Final = 3
    STREAM_RAW_CONTROLLER: Final = 4
    STREAM_POSITION: Final = 6
    STREAM_EXTRA1: Final = 10
    STREAM_EXTRA2: Final = 11
    STREAM_EXTRA3: Final = 12
    def __init__(self, *, stream_id: int = ..., message_rate: int = ..., on_off: bool = ..., check_fields: bool = ...) -> None: ...
    stream_id: int
    message_rate: int
    on_off: bool

class StreamRate_Response(Message):
    """mavros_msgs/srv/StreamRate_Response"""
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class StreamRate_Event(Message):
    """mavros_msgs/srv/StreamRate_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[mavros_msgs.srv.StreamRate_Request] = ..., response: Collection[mavros_msgs.srv.StreamRate_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[mavros_msgs.srv.StreamRate_Request]: ...
    @request.setter
    def request(self, value: Collection[mavros_msgs.srv.StreamRate_Request]) -> None: ...
    @property
    def response(self) -> list[mavros_msgs.srv.StreamRate_Response]: ...
    @response.setter
    def response(self, value: Collection[mavros_msgs.srv.StreamRate_Response]) -> None: ...

class StreamRate(Service):
    Request: TypeAlias = StreamRate_Request
    Response: TypeAlias = StreamRate_Response
    Event: TypeAlias = StreamRate_Event

class VehicleInfoGet_Request(Message):
    """mavros_msgs/srv/VehicleInfoGet_Request

    uint8 GET_MY_SYSID=0
    uint8 GET_MY_COMPID=0
    uint8 sysid
    uint8 compid
    bool get_all
    """
    GET_MY_SYSID: Final = 0
    GET_MY_COMPID: Final = 0
    def __init__(self, *, sysid: int = ..., compid: int = ..., get_all: bool = ..., check_fields: bool = ...) -> None: ...
    sysid: int
    compid: int
    get_all: bool

class VehicleInfoGet_Response(Message):
    """mavros_msgs/srv/VehicleInfoGet_Response

    bool success
    mavros_msgs/VehicleInfo[] vehicles
    """
    def __init__(self, *, success: bool = ..., vehicles: Collection[mavros_msgs.msg.VehicleInfo] = ..., check_fields: bool = ...) -> None: ...
    success: bool
    @property
    def vehicles(self) -> list[mavros_msgs.msg.VehicleInfo]: ...
    @vehicles.setter
    def vehicles(self, value: Collection[mavros_msgs.msg.VehicleInfo]) -> None: ...

class VehicleInfoGet_Event(Message):
    """mavros_msgs/srv/VehicleInfoGet_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[mavros_msgs.srv.VehicleInfoGet_Request] = ..., response: Collection[mavros_msgs.srv.VehicleInfoGet_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[mavros_msgs.srv.VehicleInfoGet_Request]: ...
    @request.setter
    def request(self, value: Collection[mavros_msgs.srv.VehicleInfoGet_Request]) -> None: ...
    @property
    def response(self) -> list[mavros_msgs.srv.VehicleInfoGet_Response]: ...
    @response.setter
    def response(self, value: Collection[mavros_msgs.srv.VehicleInfoGet_Response]) -> None: ...

class VehicleInfoGet(Service):
    Request: TypeAlias = VehicleInfoGet_Request
    Response: TypeAlias = VehicleInfoGet_Response
    Event: TypeAlias = VehicleInfoGet_Event

class WaypointClear_Request(Message):
    """mavros_msgs/srv/WaypointClear_Request"""
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class WaypointClear_Response(Message):
    """mavros_msgs/srv/WaypointClear_Response

    bool success
    """
    def __init__(self, *, success: bool = ..., check_fields: bool = ...) -> None: ...
    success: bool

class WaypointClear_Event(Message):
    """mavros_msgs/srv/WaypointClear_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[mavros_msgs.srv.WaypointClear_Request] = ..., response: Collection[mavros_msgs.srv.WaypointClear_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[mavros_msgs.srv.WaypointClear_Request]: ...
    @request.setter
    def request(self, value: Collection[mavros_msgs.srv.WaypointClear_Request]) -> None: ...
    @property
    def response(self) -> list[mavros_msgs.srv.WaypointClear_Response]: ...
    @response.setter
    def response(self, value: Collection[mavros_msgs.srv.WaypointClear_Response]) -> None: ...

class WaypointClear(Service):
    Request: TypeAlias = WaypointClear_Request
    Response: TypeAlias = WaypointClear_Response
    Event: TypeAlias = WaypointClear_Event

class WaypointPull_Request(Message):
    """mavros_msgs/srv/WaypointPull_Request"""
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class WaypointPull_Response(Message):
    """mavros_msgs/srv/WaypointPull_Response

    bool success
    uint32 wp_received
    """
    def __init__(self, *, success: bool = ..., wp_received: int = ..., check_fields: bool = ...) -> None: ...
    success: bool
    wp_received: int

class WaypointPull_Event(Message):
    """mavros_msgs/srv/WaypointPull_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[mavros_msgs.srv.WaypointPull_Request] = ..., response: Collection[mavros_msgs.srv.WaypointPull_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[mavros_msgs.srv.WaypointPull_Request]: ...
    @request.setter
    def request(self, value: Collection[mavros_msgs.srv.WaypointPull_Request]) -> None: ...
    @property
    def response(self) -> list[mavros_msgs.srv.WaypointPull_Response]: ...
    @response.setter
    def response(self, value: Collection[mavros_msgs.srv.WaypointPull_Response]) -> None: ...

class WaypointPull(Service):
    Request: TypeAlias = WaypointPull_Request
    Response: TypeAlias = WaypointPull_Response
    Event: TypeAlias = WaypointPull_Event

class WaypointPush_Request(Message):
    """mavros_msgs/srv/WaypointPush_Request

    uint16 start_index
    mavros_msgs/Waypoint[] waypoints
    """
    def __init__(self, *, start_index: int = ..., waypoints: Collection[mavros_msgs.msg.Waypoint] = ..., check_fields: bool = ...) -> None: ...
    start_index: int
    @property
    def waypoints(self) -> list[mavros_msgs.msg.Waypoint]: ...
    @waypoints.setter
    def waypoints(self, value: Collection[mavros_msgs.msg.Waypoint]) -> None: ...

class WaypointPush_Response(Message):
    """mavros_msgs/srv/WaypointPush_Response

    bool success
    uint32 wp_transfered
    """
    def __init__(self, *, success: bool = ..., wp_transfered: int = ..., check_fields: bool = ...) -> None: ...
    success: bool
    wp_transfered: int

class WaypointPush_Event(Message):
    """mavros_msgs/srv/WaypointPush_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[mavros_msgs.srv.WaypointPush_Request] = ..., response: Collection[mavros_msgs.srv.WaypointPush_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[mavros_msgs.srv.WaypointPush_Request]: ...
    @request.setter
    def request(self, value: Collection[mavros_msgs.srv.WaypointPush_Request]) -> None: ...
    @property
    def response(self) -> list[mavros_msgs.srv.WaypointPush_Response]: ...
    @response.setter
    def response(self, value: Collection[mavros_msgs.srv.WaypointPush_Response]) -> None: ...

class WaypointPush(Service):
    Request: TypeAlias = WaypointPush_Request
    Response: TypeAlias = WaypointPush_Response
    Event: TypeAlias = WaypointPush_Event

class WaypointSetCurrent_Request(Message):
    """mavros_msgs/srv/WaypointSetCurrent_Request

    uint16 wp_seq
    """
    def __init__(self, *, wp_seq: int = ..., check_fields: bool = ...) -> None: ...
    wp_seq: int

class WaypointSetCurrent_Response(Message):
    """mavros_msgs/srv/WaypointSetCurrent_Response

    bool success
    """
    def __init__(self, *, success: bool = ..., check_fields: bool = ...) -> None: ...
    success: bool

class WaypointSetCurrent_Event(Message):
    """mavros_msgs/srv/WaypointSetCurrent_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[mavros_msgs.srv.WaypointSetCurrent_Request] = ..., response: Collection[mavros_msgs.srv.WaypointSetCurrent_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[mavros_msgs.srv.WaypointSetCurrent_Request]: ...
    @request.setter
    def request(self, value: Collection[mavros_msgs.srv.WaypointSetCurrent_Request]) -> None: ...
    @property
    def response(self) -> list[mavros_msgs.srv.WaypointSetCurrent_Response]: ...
    @response.setter
    def response(self, value: Collection[mavros_msgs.srv.WaypointSetCurrent_Response]) -> None: ...

class WaypointSetCurrent(Service):
    Request: TypeAlias = WaypointSetCurrent_Request
    Response: TypeAlias = WaypointSetCurrent_Response
    Event: TypeAlias = WaypointSetCurrent_Event
