# Written by python -m zbot.interfaces.stubs; do not edit.
from array import array
from collections.abc import Collection
from typing import Final, TypeAlias

import numpy
from numpy.typing import NDArray

import builtin_interfaces.msg
import gazebo_msgs.msg
import gazebo_msgs.srv
import geometry_msgs.msg
import service_msgs.msg
import std_msgs.msg
import trajectory_msgs.msg
from zbot.interfaces import Action, Message, Service

class ApplyBodyWrench_Request(Message):
    """gazebo_msgs/srv/ApplyBodyWrench_Request

    string body_name
    string reference_frame
    geometry_msgs/Point reference_point
    geometry_msgs/Wrench wrench
    builtin_interfaces/Time start_time
    builtin_interfaces/Duration duration
    """
    def __init__(self, *, body_name: str = ..., reference_frame: str = ..., reference_point: geometry_msgs.msg.Point = ..., wrench: geometry_msgs.msg.Wrench = ..., start_time: builtin_interfaces.msg.Time = ..., duration: builtin_interfaces.msg.Duration = ..., check_fields: bool = ...) -> None: ...
    body_name: str
    reference_frame: str
    reference_point: geometry_msgs.msg.Point
    wrench: geometry_msgs.msg.Wrench
    start_time: builtin_interfaces.msg.Time
    duration: builtin_interfaces.msg.Duration

class ApplyBodyWrench_Response(Message):
    """gazebo_msgs/srv/ApplyBodyWrench_Response

    bool success
    string status_message
    """
    def __init__(self, *, success: bool = ..., status_message: str = ..., check_fields: bool = ...) -> None: ...
    success: bool
    status_message: str

class ApplyBodyWrench_Event(Message):
    """gazebo_msgs/srv/ApplyBodyWrench_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[gazebo_msgs.srv.ApplyBodyWrench_Request] = ..., response: Collection[gazebo_msgs.srv.ApplyBodyWrench_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[gazebo_msgs.srv.ApplyBodyWrench_Request]: ...
    @request.setter
    def request(self, value: Collection[gazebo_msgs.srv.ApplyBodyWrench_Request]) -> None: ...
    @property
    def response(self) -> list[gazebo_msgs.srv.ApplyBodyWrench_Response]: ...
    @response.setter
    def response(self, value: Collection[gazebo_msgs.srv.ApplyBodyWrench_Response]) -> None: ...

class ApplyBodyWrench(Service):
    Request: TypeAlias = ApplyBodyWrench_Request
    Response: TypeAlias = ApplyBodyWrench_Response
    Event: TypeAlias = ApplyBodyWrench_Event

class ApplyJointEffort_Request(Message):
    """gazebo_msgs/srv/ApplyJointEffort_Request

    string joint_name
    float64 effort
    builtin_interfaces/Time start_time
    builtin_interfaces/Duration duration
    """
    def __init__(self, *, joint_name: str = ..., effort: float = ..., start_time: builtin_interfaces.msg.Time = ..., duration: builtin_interfaces.msg.Duration = ..., check_fields: bool = ...) -> None: ...
    joint_name: str
    effort: float
    start_time: builtin_interfaces.msg.Time
    duration: builtin_interfaces.msg.Duration

class ApplyJointEffort_Response(Message):
    """gazebo_msgs/srv/ApplyJointEffort_Response

    bool success
    string status_message
    """
    def __init__(self, *, success: bool = ..., status_message: str = ..., check_fields: bool = ...) -> None: ...
    success: bool
    status_message: str

class ApplyJointEffort_Event(Message):
    """gazebo_msgs/srv/ApplyJointEffort_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[gazebo_msgs.srv.ApplyJointEffort_Request] = ..., response: Collection[gazebo_msgs.srv.ApplyJointEffort_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[gazebo_msgs.srv.ApplyJointEffort_Request]: ...
    @request.setter
    def request(self, value: Collection[gazebo_msgs.srv.ApplyJointEffort_Request]) -> None: ...
    @property
    def response(self) -> list[gazebo_msgs.srv.ApplyJointEffort_Response]: ...
    @response.setter
    def response(self, value: Collection[gazebo_msgs.srv.ApplyJointEffort_Response]) -> None: ...

class ApplyJointEffort(Service):
    Request: TypeAlias = ApplyJointEffort_Request
    Response: TypeAlias = ApplyJointEffort_Response
    Event: TypeAlias = ApplyJointEffort_Event

class ApplyLinkWrench_Request(Message):
    """gazebo_msgs/srv/ApplyLinkWrench_Request

    string link_name
    string reference_frame
    geometry_msgs/Point reference_point
    geometry_msgs/Wrench wrench
    builtin_interfaces/Time start_time
    builtin_interfaces/Duration duration
    """
    def __init__(self, *, link_name: str = ..., reference_frame: str = ..., reference_point: geometry_msgs.msg.Point = ..., wrench: geometry_msgs.msg.Wrench = ..., start_time: builtin_interfaces.msg.Time = ..., duration: builtin_interfaces.msg.Duration = ..., check_fields: bool = ...) -> None: ...
    link_name: str
    reference_frame: str
    reference_point: geometry_msgs.msg.Point
    wrench: geometry_msgs.msg.Wrench
    start_time: builtin_interfaces.msg.Time
    duration: builtin_interfaces.msg.Duration

class ApplyLinkWrench_Response(Message):
    """gazebo_msgs/srv/ApplyLinkWrench_Response

    bool success
    string status_message
    """
    def __init__(self, *, success: bool = ..., status_message: str = ..., check_fields: bool = ...) -> None: ...
    success: bool
    status_message: str

class ApplyLinkWrench_Event(Message):
    """gazebo_msgs/srv/ApplyLinkWrench_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[gazebo_msgs.srv.ApplyLinkWrench_Request] = ..., response: Collection[gazebo_msgs.srv.ApplyLinkWrench_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[gazebo_msgs.srv.ApplyLinkWrench_Request]: ...
    @request.setter
    def request(self, value: Collection[gazebo_msgs.srv.ApplyLinkWrench_Request]) -> None: ...
    @property
    def response(self) -> list[gazebo_msgs.srv.ApplyLinkWrench_Response]: ...
    @response.setter
    def response(self, value: Collection[gazebo_msgs.srv.ApplyLinkWrench_Response]) -> None: ...

class ApplyLinkWrench(Service):
    Request: TypeAlias = ApplyLinkWrench_Request
    Response: TypeAlias = ApplyLinkWrench_Response
    Event: TypeAlias = ApplyLinkWrench_Event

class BodyRequest_Request(Message):
    """gazebo_msgs/srv/BodyRequest_Request

    string body_name
    """
    def __init__(self, *, body_name: str = ..., check_fields: bool = ...) -> None: ...
    body_name: str

class BodyRequest_Response(Message):
    """gazebo_msgs/srv/BodyRequest_Response"""
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class BodyRequest_Event(Message):
    """gazebo_msgs/srv/BodyRequest_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[gazebo_msgs.srv.BodyRequest_Request] = ..., response: Collection[gazebo_msgs.srv.BodyRequest_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[gazebo_msgs.srv.BodyRequest_Request]: ...
    @request.setter
    def request(self, value: Collection[gazebo_msgs.srv.BodyRequest_Request]) -> None: ...
    @property
    def response(self) -> list[gazebo_msgs.srv.BodyRequest_Response]: ...
    @response.setter
    def response(self, value: Collection[gazebo_msgs.srv.BodyRequest_Response]) -> None: ...

class BodyRequest(Service):
    Request: TypeAlias = BodyRequest_Request
    Response: TypeAlias = BodyRequest_Response
    Event: TypeAlias = BodyRequest_Event

class DeleteEntity_Request(Message):
    """gazebo_msgs/srv/DeleteEntity_Request

    string name
    """
    def __init__(self, *, name: str = ..., check_fields: bool = ...) -> None: ...
    name: str

class DeleteEntity_Response(Message):
    """gazebo_msgs/srv/DeleteEntity_Response

    bool success
    string status_message
    """
    def __init__(self, *, success: bool = ..., status_message: str = ..., check_fields: bool = ...) -> None: ...
    success: bool
    status_message: str

class DeleteEntity_Event(Message):
    """gazebo_msgs/srv/DeleteEntity_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[gazebo_msgs.srv.DeleteEntity_Request] = ..., response: Collection[gazebo_msgs.srv.DeleteEntity_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[gazebo_msgs.srv.DeleteEntity_Request]: ...
    @request.setter
    def request(self, value: Collection[gazebo_msgs.srv.DeleteEntity_Request]) -> None: ...
    @property
    def response(self) -> list[gazebo_msgs.srv.DeleteEntity_Response]: ...
    @response.setter
    def response(self, value: Collection[gazebo_msgs.srv.DeleteEntity_Response]) -> None: ...

class DeleteEntity(Service):
    Request: TypeAlias = DeleteEntity_Request
    Response: TypeAlias = DeleteEntity_Response
    Event: TypeAlias = DeleteEntity_Event

class DeleteLight_Request(Message):
    """gazebo_msgs/srv/DeleteLight_Request

    string light_name
    """
    def __init__(self, *, light_name: str = ..., check_fields: bool = ...) -> None: ...
    light_name: str

class DeleteLight_Response(Message):
    """gazebo_msgs/srv/DeleteLight_Response

    bool success
    string status_message
    """
    def __init__(self, *, success: bool = ..., status_message: str = ..., check_fields: bool = ...) -> None: ...
    success: bool
    status_message: str

class DeleteLight_Event(Message):
    """gazebo_msgs/srv/DeleteLight_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[gazebo_msgs.srv.DeleteLight_Request] = ..., response: Collection[gazebo_msgs.srv.DeleteLight_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[gazebo_msgs.srv.DeleteLight_Request]: ...
    @request.setter
    def request(self, value: Collection[gazebo_msgs.srv.DeleteLight_Request]) -> None: ...
    @property
    def response(self) -> list[gazebo_msgs.srv.DeleteLight_Response]: ...
    @response.setter
    def response(self, value: Collection[gazebo_msgs.srv.DeleteLight_Response]) -> None: ...

class DeleteLight(Service):
    Request: TypeAlias = DeleteLight_Request
    Response: TypeAlias = DeleteLight_Response
    Event: TypeAlias = DeleteLight_Event

class DeleteModel_Request(Message):
    """gazebo_msgs/srv/DeleteModel_Request

    string model_name
    """
    def __init__(self, *, model_name: str = ..., check_fields: bool = ...) -> None: ...
    model_name: str

class DeleteModel_Response(Message):
    """gazebo_msgs/srv/DeleteModel_Response

    bool success
    string status_message
    """
    def __init__(self, *, success: bool = ..., status_message: str = ..., check_fields: bool = ...) -> None: ...
    success: bool
    status_message: str

class DeleteModel_Event(Message):
    """gazebo_msgs/srv/DeleteModel_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[gazebo_msgs.srv.DeleteModel_Request] = ..., response: Collection[gazebo_msgs.srv.DeleteModel_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[gazebo_msgs.srv.DeleteModel_Request]: ...
    @request.setter
    def request(self, value: Collection[gazebo_msgs.srv.DeleteModel_Request]) -> None: ...
    @property
    def response(self) -> list[gazebo_msgs.srv.DeleteModel_Response]: ...
    @response.setter
    def response(self, value: Collection[gazebo_msgs.srv.DeleteModel_Response]) -> None: ...

class DeleteModel(Service):
    Request: TypeAlias = DeleteModel_Request
    Response: TypeAlias = DeleteModel_Response
    Event: TypeAlias = DeleteModel_Event

class GetEntityState_Request(Message):
    """gazebo_msgs/srv/GetEntityState_Request

    string name
    string reference_frame
    """
    def __init__(self, *, name: str = ..., reference_frame: str = ..., check_fields: bool = ...) -> None: ...
    name: str
    reference_frame: str

class GetEntityState_Response(Message):
    """gazebo_msgs/srv/GetEntityState_Response

    std_msgs/Header header
    gazebo_msgs/EntityState state
    bool success
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., state: gazebo_msgs.msg.EntityState = ..., success: bool = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    state: gazebo_msgs.msg.EntityState
    success: bool

class GetEntityState_Event(Message):
    """gazebo_msgs/srv/GetEntityState_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[gazebo_msgs.srv.GetEntityState_Request] = ..., response: Collection[gazebo_msgs.srv.GetEntityState_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[gazebo_msgs.srv.GetEntityState_Request]: ...
    @request.setter
    def request(self, value: Collection[gazebo_msgs.srv.GetEntityState_Request]) -> None: ...
    @property
    def response(self) -> list[gazebo_msgs.srv.GetEntityState_Response]: ...
    @response.setter
    def response(self, value: Collection[gazebo_msgs.srv.GetEntityState_Response]) -> None: ...

class GetEntityState(Service):
    Request: TypeAlias = GetEntityState_Request
    Response: TypeAlias = GetEntityState_Response
    Event: TypeAlias = GetEntityState_Event

class GetJointProperties_Request(Message):
    """gazebo_msgs/srv/GetJointProperties_Request

    string joint_name
    """
    def __init__(self, *, joint_name: str = ..., check_fields: bool = ...) -> None: ...
    joint_name: str

class GetJointProperties_Response(Message):
    """gazebo_msgs/srv/GetJointProperties_Response

    uint8 type
    uint8 REVOLUTE=0
    uint8 CONTINUOUS=1
    uint8 PRISMATIC=2
    uint8 FIXED=3
    uint8 BALL=4
    uint8 UNIVERSAL=5
    float64[] damping
    float64[] position
    float64[] rate
    bool success
    string status_message
    """
    REVOLUTE: Final = 0
    CONTINUOUS: Final = 1
    PRISMATIC: Final = 2
    FIXED: Final = 3
    BALL: Final = 4
    UNIVERSAL: Final = 5
    def __init__(self, *, type: int = ..., damping: Collection[float] = ..., position: Collection[float] = ..., rate: Collection[float] = ..., success: bool = ..., status_message: str = ..., check_fields: bool = ...) -> None: ...
    type: int
    @property
    def damping(self) -> array[float]: ...
    @damping.setter
    def damping(self, value: Collection[float]) -> None: ...
    @property
    def position(self) -> array[float]: ...
    @position.setter
    def position(self, value: Collection[float]) -> None: ...
    @property
    def rate(self) -> array[float]: ...
    @rate.setter
    def rate(self, value: Collection[float]) -> None: ...
    success: bool
    status_message: str

class GetJointProperties_Event(Message):
    """gazebo_msgs/srv/GetJointProperties_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[gazebo_msgs.srv.GetJointProperties_Request] = ..., response: Collection[gazebo_msgs.srv.GetJointProperties_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[gazebo_msgs.srv.GetJointProperties_Request]: ...
    @request.setter
    def request(self, value: Collection[gazebo_msgs.srv.GetJointProperties_Request]) -> None: ...
    @property
    def response(self) -> list[gazebo_msgs.srv.GetJointProperties_Response]: ...
    @response.setter
    def response(self, value: Collection[gazebo_msgs.srv.GetJointProperties_Response]) -> None: ...

class GetJointProperties(Service):
    Request: TypeAlias = GetJointProperties_Request
    Response: TypeAlias = GetJointProperties_Response
    Event: TypeAlias = GetJointProperties_Event

class GetLightProperties_Request(Message):
    """gazebo_msgs/srv/GetLightProperties_Request

    string light_name
    """
    def __init__(self, *, light_name: str = ..., check_fields: bool = ...) -> None: ...
    light_name: str

class GetLightProperties_Response(Message):
    """gazebo_msgs/srv/GetLightProperties_Response

    std_msgs/ColorRGBA diffuse
    float64 attenuation_constant
    float64 attenuation_linear
    float64 attenuation_quadratic
    bool success
    string status_message
    """
    def __init__(self, *, diffuse: std_msgs.msg.ColorRGBA = ..., attenuation_constant: float = ..., attenuation_linear: float = ..., attenuation_quadratic: float = ..., success: bool = ..., status_message: str = ..., check_fields: bool = ...) -> None: ...
    diffuse: std_msgs.msg.ColorRGBA
    attenuation_constant: float
    attenuation_linear: float
    attenuation_quadratic: float
    success: bool
    status_message: str

class GetLightProperties_Event(Message):
    """gazebo_msgs/srv/GetLightProperties_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[gazebo_msgs.srv.GetLightProperties_Request] = ..., response: Collection[gazebo_msgs.srv.GetLightProperties_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[gazebo_msgs.srv.GetLightProperties_Request]: ...
    @request.setter
    def request(self, value: Collection[gazebo_msgs.srv.GetLightProperties_Request]) -> None: ...
    @property
    def response(self) -> list[gazebo_msgs.srv.GetLightProperties_Response]: ...
    @response.setter
    def response(self, value: Collection[gazebo_msgs.srv.GetLightProperties_Response]) -> None: ...

class GetLightProperties(Service):
    Request: TypeAlias = GetLightProperties_Request
    Response: TypeAlias = GetLightProperties_Response
    Event: TypeAlias = GetLightProperties_Event

class GetLinkProperties_Request(Message):
    """gazebo_msgs/srv/GetLinkProperties_Request

    string link_name
    """
    def __init__(self, *, link_name: str = ..., check_fields: bool = ...) -> None: ...
    link_name: str

class GetLinkProperties_Response(Message):
    """gazebo_msgs/srv/GetLinkProperties_Response

    geometry_msgs/Pose com
    bool gravity_mode
    float64 mass
    float64 ixx
    float64 ixy
    float64 ixz
    float64 iyy
    float64 iyz
    float64 izz
    bool success
    string status_message
    """
    def __init__(self, *, com: geometry_msgs.msg.Pose = ..., gravity_mode: bool = ..., mass: float = ..., ixx: float = ..., ixy: float = ..., ixz: float = ..., iyy: float = ..., iyz: float = ..., izz: float = ..., success: bool = ..., status_message: str = ..., check_fields: bool = ...) -> None: ...
    com: geometry_msgs.msg.Pose
    gravity_mode: bool
    mass: float
    ixx: float
    ixy: float
    ixz: float
    iyy: float
    iyz: float
    izz: float
    success: bool
    status_message: str

class GetLinkProperties_Event(Message):
    """gazebo_msgs/srv/GetLinkProperties_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[gazebo_msgs.srv.GetLinkProperties_Request] = ..., response: Collection[gazebo_msgs.srv.GetLinkProperties_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[gazebo_msgs.srv.GetLinkProperties_Request]: ...
    @request.setter
    def request(self, value: Collection[gazebo_msgs.srv.GetLinkProperties_Request]) -> None: ...
    @property
    def response(self) -> list[gazebo_msgs.srv.GetLinkProperties_Response]: ...
    @response.setter
    def response(self, value: Collection[gazebo_msgs.srv.GetLinkProperties_Response]) -> None: ...

class GetLinkProperties(Service):
    Request: TypeAlias = GetLinkProperties_Request
    Response: TypeAlias = GetLinkProperties_Response
    Event: TypeAlias = GetLinkProperties_Event

class GetLinkState_Request(Message):
    """gazebo_msgs/srv/GetLinkState_Request

    string link_name
    string reference_frame
    """
    def __init__(self, *, link_name: str = ..., reference_frame: str = ..., check_fields: bool = ...) -> None: ...
    link_name: str
    reference_frame: str

class GetLinkState_Response(Message):
    """gazebo_msgs/srv/GetLinkState_Response

    gazebo_msgs/LinkState link_state
    bool success
    string status_message
    """
    def __init__(self, *, link_state: gazebo_msgs.msg.LinkState = ..., success: bool = ..., status_message: str = ..., check_fields: bool = ...) -> None: ...
    link_state: gazebo_msgs.msg.LinkState
    success: bool
    status_message: str

class GetLinkState_Event(Message):
    """gazebo_msgs/srv/GetLinkState_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[gazebo_msgs.srv.GetLinkState_Request] = ..., response: Collection[gazebo_msgs.srv.GetLinkState_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[gazebo_msgs.srv.GetLinkState_Request]: ...
    @request.setter
    def request(self, value: Collection[gazebo_msgs.srv.GetLinkState_Request]) -> None: ...
    @property
    def response(self) -> list[gazebo_msgs.srv.GetLinkState_Response]: ...
    @response.setter
    def response(self, value: Collection[gazebo_msgs.srv.GetLinkState_Response]) -> None: ...

class GetLinkState(Service):
    Request: TypeAlias = GetLinkState_Request
    Response: TypeAlias = GetLinkState_Response
    Event: TypeAlias = GetLinkState_Event

class GetModelList_Request(Message):
    """gazebo_msgs/srv/GetModelList_Request"""
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class GetModelList_Response(Message):
    """gazebo_msgs/srv/GetModelList_Response

    std_msgs/Header header
    string[] model_names
    bool success
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., model_names: Collection[str] = ..., success: bool = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    @property
    def model_names(self) -> list[str]: ...
    @model_names.setter
    def model_names(self, value: Collection[str]) -> None: ...
    success: bool

class GetModelList_Event(Message):
    """gazebo_msgs/srv/GetModelList_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[gazebo_msgs.srv.GetModelList_Request] = ..., response: Collection[gazebo_msgs.srv.GetModelList_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[gazebo_msgs.srv.GetModelList_Request]: ...
    @request.setter
    def request(self, value: Collection[gazebo_msgs.srv.GetModelList_Request]) -> None: ...
    @property
    def response(self) -> list[gazebo_msgs.srv.GetModelList_Response]: ...
    @response.setter
    def response(self, value: Collection[gazebo_msgs.srv.GetModelList_Response]) -> None: ...

class GetModelList(Service):
    Request: TypeAlias = GetModelList_Request
    Response: TypeAlias = GetModelList_Response
    Event: TypeAlias = GetModelList_Event

class GetModelProperties_Request(Message):
    """gazebo_msgs/srv/GetModelProperties_Request

    string model_name
    """
    def __init__(self, *, model_name: str = ..., check_fields: bool = ...) -> None: ...
    model_name: str

class GetModelProperties_Response(Message):
    """gazebo_msgs/srv/GetModelProperties_Response

    string parent_model_name
    string canonical_body_name
    string[] body_names
    string[] geom_names
    string[] joint_names
    string[] child_model_names
    bool is_static
    bool success
    string status_message
    """
    def __init__(self, *, parent_model_name: str = ..., canonical_body_name: str = ..., body_names: Collection[str] = ..., geom_names: Collection[str] = ..., joint_names: Collection[str] = ..., child_model_names: Collection[str] = ..., is_static: bool = ..., success: bool = ..., status_message: str = ..., check_fields: bool = ...) -> None: ...
    parent_model_name: str
    canonical_body_name: str
    @property
    def body_names(self) -> list[str]: ...
    @body_names.setter
    def body_names(self, value: Collection[str]) -> None: ...
    @property
    def geom_names(self) -> list[str]: ...
    @geom_names.setter
    def geom_names(self, value: Collection[str]) -> None: ...
    @property
    def joint_names(self) -> list[str]: ...
    @joint_names.setter
    def joint_names(self, value: Collection[str]) -> None: ...
    @property
    def child_model_names(self) -> list[str]: ...
    @child_model_names.setter
    def child_model_names(self, value: Collection[str]) -> None: ...
    is_static: bool
    success: bool
    status_message: str

class GetModelProperties_Event(Message):
    """gazebo_msgs/srv/GetModelProperties_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[gazebo_msgs.srv.GetModelProperties_Request] = ..., response: Collection[gazebo_msgs.srv.GetModelProperties_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[gazebo_msgs.srv.GetModelProperties_Request]: ...
    @request.setter
    def request(self, value: Collection[gazebo_msgs.srv.GetModelProperties_Request]) -> None: ...
    @property
    def response(self) -> list[gazebo_msgs.srv.GetModelProperties_Response]: ...
    @response.setter
    def response(self, value: Collection[gazebo_msgs.srv.GetModelProperties_Response]) -> None: ...

class GetModelProperties(Service):
    Request: TypeAlias = GetModelProperties_Request
    Response: TypeAlias = GetModelProperties_Response
    Event: TypeAlias = GetModelProperties_Event

class GetModelState_Request(Message):
    """gazebo_msgs/srv/GetModelState_Request

    string model_name
    string relative_entity_name
    """
    def __init__(self, *, model_name: str = ..., relative_entity_name: str = ..., check_fields: bool = ...) -> None: ...
    model_name: str
    relative_entity_name: str

class GetModelState_Response(Message):
    """gazebo_msgs/srv/GetModelState_Response

    std_msgs/Header header
    geometry_msgs/Pose pose
    geometry_msgs/Twist twist
    bool success
    string status_message
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., pose: geometry_msgs.msg.Pose = ..., twist: geometry_msgs.msg.Twist = ..., success: bool = ..., status_message: str = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    pose: geometry_msgs.msg.Pose
    twist: geometry_msgs.msg.Twist
    success: bool
    status_message: str

class GetModelState_Event(Message):
    """gazebo_msgs/srv/GetModelState_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[gazebo_msgs.srv.GetModelState_Request] = ..., response: Collection[gazebo_msgs.srv.GetModelState_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[gazebo_msgs.srv.GetModelState_Request]: ...
    @request.setter
    def request(self, value: Collection[gazebo_msgs.srv.GetModelState_Request]) -> None: ...
    @property
    def response(self) -> list[gazebo_msgs.srv.GetModelState_Response]: ...
    @response.setter
    def response(self, value: Collection[gazebo_msgs.srv.GetModelState_Response]) -> None: ...

class GetModelState(Service):
    Request: TypeAlias = GetModelState_Request
    Response: TypeAlias = GetModelState_Response
    Event: TypeAlias = GetModelState_Event

class GetPhysicsProperties_Request(Message):
    """gazebo_msgs/srv/GetPhysicsProperties_Request"""
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class GetPhysicsProperties_Response(Message):
    """gazebo_msgs/srv/GetPhysicsProperties_Response

    float64 time_step
    bool pause
    float64 max_update_rate
    geometry_msgs/Vector3 gravity
    gazebo_msgs/ODEPhysics ode_config
    bool success
    string status_message
    """
    def __init__(self, *, time_step: float = ..., pause: bool = ..., max_update_rate: float = ..., gravity: geometry_msgs.msg.Vector3 = ..., ode_config: gazebo_msgs.msg.ODEPhysics = ..., success: bool = ..., status_message: str = ..., check_fields: bool = ...) -> None: ...
    time_step: float
    pause: bool
    max_update_rate: float
    gravity: geometry_msgs.msg.Vector3
    ode_config: gazebo_msgs.msg.ODEPhysics
    success: bool
    status_message: str

class GetPhysicsProperties_Event(Message):
    """gazebo_msgs/srv/GetPhysicsProperties_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[gazebo_msgs.srv.GetPhysicsProperties_Request] = ..., response: Collection[gazebo_msgs.srv.GetPhysicsProperties_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[gazebo_msgs.srv.GetPhysicsProperties_Request]: ...
    @request.setter
    def request(self, value: Collection[gazebo_msgs.srv.GetPhysicsProperties_Request]) -> None: ...
    @property
    def response(self) -> list[gazebo_msgs.srv.GetPhysicsProperties_Response]: ...
    @response.setter
    def response(self, value: Collection[gazebo_msgs.srv.GetPhysicsProperties_Response]) -> None: ...

class GetPhysicsProperties(Service):
    Request: TypeAlias = GetPhysicsProperties_Request
    Response: TypeAlias = GetPhysicsProperties_Response
    Event: TypeAlias = GetPhysicsProperties_Event

class GetWorldProperties_Request(Message):
    """gazebo_msgs/srv/GetWorldProperties_Request"""
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class GetWorldProperties_Response(Message):
    """gazebo_msgs/srv/GetWorldProperties_Response

    float64 sim_time
    string[] model_names
    bool rendering_enabled
    bool success
    string status_message
    """
    def __init__(self, *, sim_time: float = ..., model_names: Collection[str] = ..., rendering_enabled: bool = ..., success: bool = ..., status_message: str = ..., check_fields: bool = ...) -> None: ...
    sim_time: float
    @property
    def model_names(self) -> list[str]: ...
    @model_names.setter
    def model_names(self, value: Collection[str]) -> None: ...
    rendering_enabled: bool
    success: bool
    status_message: str

class GetWorldProperties_Event(Message):
    """gazebo_msgs/srv/GetWorldProperties_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[gazebo_msgs.srv.GetWorldProperties_Request] = ..., response: Collection[gazebo_msgs.srv.GetWorldProperties_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[gazebo_msgs.srv.GetWorldProperties_Request]: ...
    @request.setter
    def request(self, value: Collection[gazebo_msgs.srv.GetWorldProperties_Request]) -> None: ...
    @property
    def response(self) -> list[gazebo_msgs.srv.GetWorldProperties_Response]: ...
    @response.setter
    def response(self, value: Collection[gazebo_msgs.srv.GetWorldProperties_Response]) -> None: ...

class GetWorldProperties(Service):
    Request: TypeAlias = GetWorldProperties_Request
    Response: TypeAlias = GetWorldProperties_Response
    Event: TypeAlias = GetWorldProperties_Event

class JointRequest_Request(Message):
    """gazebo_msgs/srv/JointRequest_Request

    string joint_name
    """
    def __init__(self, *, joint_name: str = ..., check_fields: bool = ...) -> None: ...
    joint_name: str

class JointRequest_Response(Message):
    """gazebo_msgs/srv/JointRequest_Response"""
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class JointRequest_Event(Message):
    """gazebo_msgs/srv/JointRequest_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[gazebo_msgs.srv.JointRequest_Request] = ..., response: Collection[gazebo_msgs.srv.JointRequest_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[gazebo_msgs.srv.JointRequest_Request]: ...
    @request.setter
    def request(self, value: Collection[gazebo_msgs.srv.JointRequest_Request]) -> None: ...
    @property
    def response(self) -> list[gazebo_msgs.srv.JointRequest_Response]: ...
    @response.setter
    def response(self, value: Collection[gazebo_msgs.srv.JointRequest_Response]) -> None: ...

class JointRequest(Service):
    Request: TypeAlias = JointRequest_Request
    Response: TypeAlias = JointRequest_Response
    Event: TypeAlias = JointRequest_Event

class LinkRequest_Request(Message):
    """gazebo_msgs/srv/LinkRequest_Request

    string link_name
    """
    def __init__(self, *, link_name: str = ..., check_fields: bool = ...) -> None: ...
    link_name: str

class LinkRequest_Response(Message):
    """gazebo_msgs/srv/LinkRequest_Response"""
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class LinkRequest_Event(Message):
    """gazebo_msgs/srv/LinkRequest_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[gazebo_msgs.srv.LinkRequest_Request] = ..., response: Collection[gazebo_msgs.srv.LinkRequest_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[gazebo_msgs.srv.LinkRequest_Request]: ...
    @request.setter
    def request(self, value: Collection[gazebo_msgs.srv.LinkRequest_Request]) -> None: ...
    @property
    def response(self) -> list[gazebo_msgs.srv.LinkRequest_Response]: ...
    @response.setter
    def response(self, value: Collection[gazebo_msgs.srv.LinkRequest_Response]) -> None: ...

class LinkRequest(Service):
    Request: TypeAlias = LinkRequest_Request
    Response: TypeAlias = LinkRequest_Response
    Event: TypeAlias = LinkRequest_Event

class SetEntityState_Request(Message):
    """gazebo_msgs/srv/SetEntityState_Request

    gazebo_msgs/EntityState state
    """
    def __init__(self, *, state: gazebo_msgs.msg.EntityState = ..., check_fields: bool = ...) -> None: ...
    state: gazebo_msgs.msg.EntityState

class SetEntityState_Response(Message):
    """gazebo_msgs/srv/SetEntityState_Response

    bool success
    """
    def __init__(self, *, success: bool = ..., check_fields: bool = ...) -> None: ...
    success: bool

class SetEntityState_Event(Message):
    """gazebo_msgs/srv/SetEntityState_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[gazebo_msgs.srv.SetEntityState_Request] = ..., response: Collection[gazebo_msgs.srv.SetEntityState_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[gazebo_msgs.srv.SetEntityState_Request]: ...
    @request.setter
    def request(self, value: Collection[gazebo_msgs.srv.SetEntityState_Request]) -> None: ...
    @property
    def response(self) -> list[gazebo_msgs.srv.SetEntityState_Response]: ...
    @response.setter
    def response(self, value: Collection[gazebo_msgs.srv.SetEntityState_Response]) -> None: ...

class SetEntityState(Service):
    Request: TypeAlias = SetEntityState_Request
    Response: TypeAlias = SetEntityState_Response
    Event: TypeAlias = SetEntityState_Event

class SetJointProperties_Request(Message):
    """gazebo_msgs/srv/SetJointProperties_Request

    string joint_name
    gazebo_msgs/ODEJointProperties ode_joint_config
    """
    def __init__(self, *, joint_name: str = ..., ode_joint_config: gazebo_msgs.msg.ODEJointProperties = ..., check_fields: bool = ...) -> None: ...
    joint_name: str
    ode_joint_config: gazebo_msgs.msg.ODEJointProperties

class SetJointProperties_Response(Message):
    """gazebo_msgs/srv/SetJointProperties_Response

    bool success
    string status_message
    """
    def __init__(self, *, success: bool = ..., status_message: str = ..., check_fields: bool = ...) -> None: ...
    success: bool
    status_message: str

class SetJointProperties_Event(Message):
    """gazebo_msgs/srv/SetJointProperties_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[gazebo_msgs.srv.SetJointProperties_Request] = ..., response: Collection[gazebo_msgs.srv.SetJointProperties_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[gazebo_msgs.srv.SetJointProperties_Request]: ...
    @request.setter
    def request(self, value: Collection[gazebo_msgs.srv.SetJointProperties_Request]) -> None: ...
    @property
    def response(self) -> list[gazebo_msgs.srv.SetJointProperties_Response]: ...
    @response.setter
    def response(self, value: Collection[gazebo_msgs.srv.SetJointProperties_Response]) -> None: ...

class SetJointProperties(Service):
    Request: TypeAlias = SetJointProperties_Request
    Response: TypeAlias = SetJointProperties_Response
    Event: TypeAlias = SetJointProperties_Event

class SetJointTrajectory_Request(Message):
    """gazebo_msgs/srv/SetJointTrajectory_Request

    string model_name
    trajectory_msgs/JointTrajectory joint_trajectory
    geometry_msgs/Pose model_pose
    bool set_model_pose
    bool disable_physics_updates
    """
    def __init__(self, *, model_name: str = ..., joint_trajectory: trajectory_msgs.msg.JointTrajectory = ..., model_pose: geometry_msgs.msg.Pose = ..., set_model_pose: bool = ..., disable_physics_updates: bool = ..., check_fields: bool = ...) -> None: ...
    model_name: str
    joint_trajectory: trajectory_msgs.msg.JointTrajectory
    model_pose: geometry_msgs.msg.Pose
    set_model_pose: bool
    disable_physics_updates: bool

class SetJointTrajectory_Response(Message):
    """gazebo_msgs/srv/SetJointTrajectory_Response

    bool success
    string status_message
    """
    def __init__(self, *, success: bool = ..., status_message: str = ..., check_fields: bool = ...) -> None: ...
    success: bool
    status_message: str

class SetJointTrajectory_Event(Message):
    """gazebo_msgs/srv/SetJointTrajectory_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[gazebo_msgs.srv.SetJointTrajectory_Request] = ..., response: Collection[gazebo_msgs.srv.SetJointTrajectory_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[gazebo_msgs.srv.SetJointTrajectory_Request]: ...
    @request.setter
    def request(self, value: Collection[gazebo_msgs.srv.SetJointTrajectory_Request]) -> None: ...
    @property
    def response(self) -> list[gazebo_msgs.srv.SetJointTrajectory_Response]: ...
    @response.setter
    def response(self, value: Collection[gazebo_msgs.srv.SetJointTrajectory_Response]) -> None: ...

class SetJointTrajectory(Service):
    Request: TypeAlias = SetJointTrajectory_Request
    Response: TypeAlias = SetJointTrajectory_Response
    Event: TypeAlias = SetJointTrajectory_Event

class SetLightProperties_Request(Message):
    """gazebo_msgs/srv/SetLightProperties_Request

    string light_name
    std_msgs/ColorRGBA diffuse
    float64 attenuation_constant
    float64 attenuation_linear
    float64 attenuation_quadratic
    """
    def __init__(self, *, light_name: str = ..., diffuse: std_msgs.msg.ColorRGBA = ..., attenuation_constant: float = ..., attenuation_linear: float = ..., attenuation_quadratic: float = ..., check_fields: bool = ...) -> None: ...
    light_name: str
    diffuse: std_msgs.msg.ColorRGBA
    attenuation_constant: float
    attenuation_linear: float
    attenuation_quadratic: float

class SetLightProperties_Response(Message):
    """gazebo_msgs/srv/SetLightProperties_Response

    bool success
    string status_message
    """
    def __init__(self, *, success: bool = ..., status_message: str = ..., check_fields: bool = ...) -> None: ...
    success: bool
    status_message: str

class SetLightProperties_Event(Message):
    """gazebo_msgs/srv/SetLightProperties_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[gazebo_msgs.srv.SetLightProperties_Request] = ..., response: Collection[gazebo_msgs.srv.SetLightProperties_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[gazebo_msgs.srv.SetLightProperties_Request]: ...
    @request.setter
    def request(self, value: Collection[gazebo_msgs.srv.SetLightProperties_Request]) -> None: ...
    @property
    def response(self) -> list[gazebo_msgs.srv.SetLightProperties_Response]: ...
    @response.setter
    def response(self, value: Collection[gazebo_msgs.srv.SetLightProperties_Response]) -> None: ...

class SetLightProperties(Service):
    Request: TypeAlias = SetLightProperties_Request
    Response: TypeAlias = SetLightProperties_Response
    Event: TypeAlias = SetLightProperties_Event

class SetLinkProperties_Request(Message):
    """gazebo_msgs/srv/SetLinkProperties_Request

    string link_name
    geometry_msgs/Pose com
    bool gravity_mode
    float64 mass
    float64 ixx
    float64 ixy
    float64 ixz
    float64 iyy
    float64 iyz
    float64 izz
    """
    def __init__(self, *, link_name: str = ..., com: geometry_msgs.msg.Pose = ..., gravity_mode: bool = ..., mass: float = ..., ixx: float = ..., ixy: float = ..., ixz: float = ..., iyy: float = ..., iyz: float = ..., izz: float = ..., check_fields: bool = ...) -> None: ...
    link_name: str
    com: geometry_msgs.msg.Pose
    gravity_mode: bool
    mass: float
    ixx: float
    ixy: float
    ixz: float
    iyy: float
    iyz: float
    izz: float

class SetLinkProperties_Response(Message):
    """gazebo_msgs/srv/SetLinkProperties_Response

    bool success
    string status_message
    """
    def __init__(self, *, success: bool = ..., status_message: str = ..., check_fields: bool = ...) -> None: ...
    success: bool
    status_message: str

class SetLinkProperties_Event(Message):
    """gazebo_msgs/srv/SetLinkProperties_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[gazebo_msgs.srv.SetLinkProperties_Request] = ..., response: Collection[gazebo_msgs.srv.SetLinkProperties_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[gazebo_msgs.srv.SetLinkProperties_Request]: ...
    @request.setter
    def request(self, value: Collection[gazebo_msgs.srv.SetLinkProperties_Request]) -> None: ...
    @property
    def response(self) -> list[gazebo_msgs.srv.SetLinkProperties_Response]: ...
    @response.setter
    def response(self, value: Collection[gazebo_msgs.srv.SetLinkProperties_Response]) -> None: ...

class SetLinkProperties(Service):
    Request: TypeAlias = SetLinkProperties_Request
    Response: TypeAlias = SetLinkProperties_Response
    Event: TypeAlias = SetLinkProperties_Event

class SetLinkState_Request(Message):
    """gazebo_msgs/srv/SetLinkState_Request

    gazebo_msgs/LinkState link_state
    """
    def __init__(self, *, link_state: gazebo_msgs.msg.LinkState = ..., check_fields: bool = ...) -> None: ...
    link_state: gazebo_msgs.msg.LinkState

class SetLinkState_Response(Message):
    """gazebo_msgs/srv/SetLinkState_Response

    bool success
    string status_message
    """
    def __init__(self, *, success: bool = ..., status_message: str = ..., check_fields: bool = ...) -> None: ...
    success: bool
    status_message: str

class SetLinkState_Event(Message):
    """gazebo_msgs/srv/SetLinkState_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[gazebo_msgs.srv.SetLinkState_Request] = ..., response: Collection[gazebo_msgs.srv.SetLinkState_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[gazebo_msgs.srv.SetLinkState_Request]: ...
    @request.setter
    def request(self, value: Collection[gazebo_msgs.srv.SetLinkState_Request]) -> None: ...
    @property
    def response(self) -> list[gazebo_msgs.srv.SetLinkState_Response]: ...
    @response.setter
    def response(self, value: Collection[gazebo_msgs.srv.SetLinkState_Response]) -> None: ...

class SetLinkState(Service):
    Request: TypeAlias = SetLinkState_Request
    Response: TypeAlias = SetLinkState_Response
    Event: TypeAlias = SetLinkState_Event

class SetModelConfiguration_Request(Message):
    """gazebo_msgs/srv/SetModelConfiguration_Request

    string model_name
    string urdf_param_name
    string[] joint_names
    float64[] joint_positions
    """
    def __init__(self, *, model_name: str = ..., urdf_param_name: str = ..., joint_names: Collection[str] = ..., joint_positions: Collection[float] = ..., check_fields: bool = ...) -> None: ...
    model_name: str
    urdf_param_name: str
    @property
    def joint_names(self) -> list[str]: ...
    @joint_names.setter
    def joint_names(self, value: Collection[str]) -> None: ...
    @property
    def joint_positions(self) -> array[float]: ...
    @joint_positions.setter
    def joint_positions(self, value: Collection[float]) -> None: ...

class SetModelConfiguration_Response(Message):
    """gazebo_msgs/srv/SetModelConfiguration_Response

    bool success
    string status_message
    """
    def __init__(self, *, success: bool = ..., status_message: str = ..., check_fields: bool = ...) -> None: ...
    success: bool
    status_message: str

class SetModelConfiguration_Event(Message):
    """gazebo_msgs/srv/SetModelConfiguration_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[gazebo_msgs.srv.SetModelConfiguration_Request] = ..., response: Collection[gazebo_msgs.srv.SetModelConfiguration_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[gazebo_msgs.srv.SetModelConfiguration_Request]: ...
    @request.setter
    def request(self, value: Collection[gazebo_msgs.srv.SetModelConfiguration_Request]) -> None: ...
    @property
    def response(self) -> list[gazebo_msgs.srv.SetModelConfiguration_Response]: ...
    @response.setter
    def response(self, value: Collection[gazebo_msgs.srv.SetModelConfiguration_Response]) -> None: ...

class SetModelConfiguration(Service):
    Request: TypeAlias = SetModelConfiguration_Request
    Response: TypeAlias = SetModelConfiguration_Response
    Event: TypeAlias = SetModelConfiguration_Event

class SetModelState_Request(Message):
    """gazebo_msgs/srv/SetModelState_Request

    gazebo_msgs/ModelState model_state
    """
    def __init__(self, *, model_state: gazebo_msgs.msg.ModelState = ..., check_fields: bool = ...) -> None: ...
    model_state: gazebo_msgs.msg.ModelState

class SetModelState_Response(Message):
    """gazebo_msgs/srv/SetModelState_Response

    bool success
    string status_message
    """
    def __init__(self, *, success: bool = ..., status_message: str = ..., check_fields: bool = ...) -> None: ...
    success: bool
    status_message: str

class SetModelState_Event(Message):
    """gazebo_msgs/srv/SetModelState_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[gazebo_msgs.srv.SetModelState_Request] = ..., response: Collection[gazebo_msgs.srv.SetModelState_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[gazebo_msgs.srv.SetModelState_Request]: ...
    @request.setter
    def request(self, value: Collection[gazebo_msgs.srv.SetModelState_Request]) -> None: ...
    @property
    def response(self) -> list[gazebo_msgs.srv.SetModelState_Response]: ...
    @response.setter
    def response(self, value: Collection[gazebo_msgs.srv.SetModelState_Response]) -> None: ...

class SetModelState(Service):
    Request: TypeAlias = SetModelState_Request
    Response: TypeAlias = SetModelState_Response
    Event: TypeAlias = SetModelState_Event

class SetPhysicsProperties_Request(Message):
    """gazebo_msgs/srv/SetPhysicsProperties_Request

    float64 time_step
    float64 max_update_rate
    geometry_msgs/Vector3 gravity
    gazebo_msgs/ODEPhysics ode_config
    """
    def __init__(self, *, time_step: float = ..., max_update_rate: float = ..., gravity: geometry_msgs.msg.Vector3 = ..., ode_config: gazebo_msgs.msg.ODEPhysics = ..., check_fields: bool = ...) -> None: ...
    time_step: float
    max_update_rate: float
    gravity: geometry_msgs.msg.Vector3
    ode_config: gazebo_msgs.msg.ODEPhysics

class SetPhysicsProperties_Response(Message):
    """gazebo_msgs/srv/SetPhysicsProperties_Response

    bool success
    string status_message
    """
    def __init__(self, *, success: bool = ..., status_message: str = ..., check_fields: bool = ...) -> None: ...
    success: bool
    status_message: str

class SetPhysicsProperties_Event(Message):
    """gazebo_msgs/srv/SetPhysicsProperties_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[gazebo_msgs.srv.SetPhysicsProperties_Request] = ..., response: Collection[gazebo_msgs.srv.SetPhysicsProperties_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[gazebo_msgs.srv.SetPhysicsProperties_Request]: ...
    @request.setter
    def request(self, value: Collection[gazebo_msgs.srv.SetPhysicsProperties_Request]) -> None: ...
    @property
    def response(self) -> list[gazebo_msgs.srv.SetPhysicsProperties_Response]: ...
    @response.setter
    def response(self, value: Collection[gazebo_msgs.srv.SetPhysicsProperties_Response]) -> None: ...

class SetPhysicsProperties(Service):
    Request: TypeAlias = SetPhysicsProperties_Request
    Response: TypeAlias = SetPhysicsProperties_Response
    Event: TypeAlias = SetPhysicsProperties_Event

class SpawnEntity_Request(Message):
    """gazebo_msgs/srv/SpawnEntity_Request

    string name
    string xml
    string robot_namespace
    geometry_msgs/Pose initial_pose
    string reference_frame
    """
    def __init__(self, *, name: str = ..., xml: str = ..., robot_namespace: str = ..., initial_pose: geometry_msgs.msg.Pose = ..., reference_frame: str = ..., check_fields: bool = ...) -> None: ...
    name: str
    xml: str
    robot_namespace: str
    initial_pose: geometry_msgs.msg.Pose
    reference_frame: str

class SpawnEntity_Response(Message):
    """gazebo_msgs/srv/SpawnEntity_Response

    bool success
    string status_message
    """
    def __init__(self, *, success: bool = ..., status_message: str = ..., check_fields: bool = ...) -> None: ...
    success: bool
    status_message: str

class SpawnEntity_Event(Message):
    """gazebo_msgs/srv/SpawnEntity_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[gazebo_msgs.srv.SpawnEntity_Request] = ..., response: Collection[gazebo_msgs.srv.SpawnEntity_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[gazebo_msgs.srv.SpawnEntity_Request]: ...
    @request.setter
    def request(self, value: Collection[gazebo_msgs.srv.SpawnEntity_Request]) -> None: ...
    @property
    def response(self) -> list[gazebo_msgs.srv.SpawnEntity_Response]: ...
    @response.setter
    def response(self, value: Collection[gazebo_msgs.srv.SpawnEntity_Response]) -> None: ...

class SpawnEntity(Service):
    Request: TypeAlias = SpawnEntity_Request
    Response: TypeAlias = SpawnEntity_Response
    Event: TypeAlias = SpawnEntity_Event

class SpawnModel_Request(Message):
    """gazebo_msgs/srv/SpawnModel_Request

    string model_name
    string model_xml
    string robot_namespace
    geometry_msgs/Pose initial_pose
    string reference_frame
    """
    def __init__(self, *, model_name: str = ..., model_xml: str = ..., robot_namespace: str = ..., initial_pose: geometry_msgs.msg.Pose = ..., reference_frame: str = ..., check_fields: bool = ...) -> None: ...
    model_name: str
    model_xml: str
    robot_namespace: str
    initial_pose: geometry_msgs.msg.Pose
    reference_frame: str

class SpawnModel_Response(Message):
    """gazebo_msgs/srv/SpawnModel_Response

    bool success
    string status_message
    """
    def __init__(self, *, success: bool = ..., status_message: str = ..., check_fields: bool = ...) -> None: ...
    success: bool
    status_message: str

class SpawnModel_Event(Message):
    """gazebo_msgs/srv/SpawnModel_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[gazebo_msgs.srv.SpawnModel_Request] = ..., response: Collection[gazebo_msgs.srv.SpawnModel_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[gazebo_msgs.srv.SpawnModel_Request]: ...
    @request.setter
    def request(self, value: Collection[gazebo_msgs.srv.SpawnModel_Request]) -> None: ...
    @property
    def response(self) -> list[gazebo_msgs.srv.SpawnModel_Response]: ...
    @response.setter
    def response(self, value: Collection[gazebo_msgs.srv.SpawnModel_Response]) -> None: ...

class SpawnModel(Service):
    Request: TypeAlias = SpawnModel_Request
    Response: TypeAlias = SpawnModel_Response
    Event: TypeAlias = SpawnModel_Event
