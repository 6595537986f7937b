# Written by python -m zbot.interfaces.stubs; do not edit.
from array import array
from collections.abc import Collection
from typing import Final, TypeAlias

import numpy
from numpy.typing import NDArray

import geometry_msgs.msg
import ros_gz_interfaces.msg
import ros_gz_interfaces.srv
import service_msgs.msg
from zbot.interfaces import Action, Message, Service

class ControlWorld_Request(Message):
    """ros_gz_interfaces/srv/ControlWorld_Request

    ros_gz_interfaces/WorldControl world_control
    """
    def __init__(self, *, world_control: ros_gz_interfaces.msg.WorldControl = ..., check_fields: bool = ...) -> None: ...
    world_control: ros_gz_interfaces.msg.WorldControl

class ControlWorld_Response(Message):
    """ros_gz_interfaces/srv/ControlWorld_Response

    bool success
    """
    def __init__(self, *, success: bool = ..., check_fields: bool = ...) -> None: ...
    success: bool

class ControlWorld_Event(Message):
    """ros_gz_interfaces/srv/ControlWorld_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[ros_gz_interfaces.srv.ControlWorld_Request] = ..., response: Collection[ros_gz_interfaces.srv.ControlWorld_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[ros_gz_interfaces.srv.ControlWorld_Request]: ...
    @request.setter
    def request(self, value: Collection[ros_gz_interfaces.srv.ControlWorld_Request]) -> None: ...
    @property
    def response(self) -> list[ros_gz_interfaces.srv.ControlWorld_Response]: ...
    @response.setter
    def response(self, value: Collection[ros_gz_interfaces.srv.ControlWorld_Response]) -> None: ...

class ControlWorld(Service):
    Request: TypeAlias = ControlWorld_Request
    Response: TypeAlias = ControlWorld_Response
    Event: TypeAlias = ControlWorld_Event

class DeleteEntity_Request(Message):
    """ros_gz_interfaces/srv/DeleteEntity_Request

    ros_gz_interfaces/Entity entity
    """
    def __init__(self, *, entity: ros_gz_interfaces.msg.Entity = ..., check_fields: bool = ...) -> None: ...
    entity: ros_gz_interfaces.msg.Entity

class DeleteEntity_Response(Message):
    """ros_gz_interfaces/srv/DeleteEntity_Response

    bool success
    """
    def __init__(self, *, success: bool = ..., check_fields: bool = ...) -> None: ...
    success: bool

class DeleteEntity_Event(Message):
    """ros_gz_interfaces/srv/DeleteEntity_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[ros_gz_interfaces.srv.DeleteEntity_Request] = ..., response: Collection[ros_gz_interfaces.srv.DeleteEntity_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[ros_gz_interfaces.srv.DeleteEntity_Request]: ...
    @request.setter
    def request(self, value: Collection[ros_gz_interfaces.srv.DeleteEntity_Request]) -> None: ...
    @property
    def response(self) -> list[ros_gz_interfaces.srv.DeleteEntity_Response]: ...
    @response.setter
    def response(self, value: Collection[ros_gz_interfaces.srv.DeleteEntity_Response]) -> None: ...

class DeleteEntity(Service):
    Request: TypeAlias = DeleteEntity_Request
    Response: TypeAlias = DeleteEntity_Response
    Event: TypeAlias = DeleteEntity_Event

class SetEntityPose_Request(Message):
    """ros_gz_interfaces/srv/SetEntityPose_Request

    ros_gz_interfaces/Entity entity
    geometry_msgs/Pose pose
    """
    def __init__(self, *, entity: ros_gz_interfaces.msg.Entity = ..., pose: geometry_msgs.msg.Pose = ..., check_fields: bool = ...) -> None: ...
    entity: ros_gz_interfaces.msg.Entity
    pose: geometry_msgs.msg.Pose

class SetEntityPose_Response(Message):
    """ros_gz_interfaces/srv/SetEntityPose_Response

    bool success
    """
    def __init__(self, *, success: bool = ..., check_fields: bool = ...) -> None: ...
    success: bool

class SetEntityPose_Event(Message):
    """ros_gz_interfaces/srv/SetEntityPose_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[ros_gz_interfaces.srv.SetEntityPose_Request] = ..., response: Collection[ros_gz_interfaces.srv.SetEntityPose_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[ros_gz_interfaces.srv.SetEntityPose_Request]: ...
    @request.setter
    def request(self, value: Collection[ros_gz_interfaces.srv.SetEntityPose_Request]) -> None: ...
    @property
    def response(self) -> list[ros_gz_interfaces.srv.SetEntityPose_Response]: ...
    @response.setter
    def response(self, value: Collection[ros_gz_interfaces.srv.SetEntityPose_Response]) -> None: ...

class SetEntityPose(Service):
    Request: TypeAlias = SetEntityPose_Request
    Response: TypeAlias = SetEntityPose_Response
    Event: TypeAlias = SetEntityPose_Event

class SpawnEntity_Request(Message):
    """ros_gz_interfaces/srv/SpawnEntity_Request

    ros_gz_interfaces/EntityFactory entity_factory
    """
    def __init__(self, *, entity_factory: ros_gz_interfaces.msg.EntityFactory = ..., check_fields: bool = ...) -> None: ...
    entity_factory: ros_gz_interfaces.msg.EntityFactory

class SpawnEntity_Response(Message):
    """ros_gz_interfaces/srv/SpawnEntity_Response

    bool success
    """
    def __init__(self, *, success: bool = ..., check_fields: bool = ...) -> None: ...
    success: bool

class SpawnEntity_Event(Message):
    """ros_gz_interfaces/srv/SpawnEntity_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[ros_gz_interfaces.srv.SpawnEntity_Request] = ..., response: Collection[ros_gz_interfaces.srv.SpawnEntity_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[ros_gz_interfaces.srv.SpawnEntity_Request]: ...
    @request.setter
    def request(self, value: Collection[ros_gz_interfaces.srv.SpawnEntity_Request]) -> None: ...
    @property
    def response(self) -> list[ros_gz_interfaces.srv.SpawnEntity_Response]: ...
    @response.setter
    def response(self, value: Collection[ros_gz_interfaces.srv.SpawnEntity_Response]) -> None: ...

class SpawnEntity(Service):
    Request: TypeAlias = SpawnEntity_Request
    Response: TypeAlias = SpawnEntity_Response
    Event: TypeAlias = SpawnEntity_Event
