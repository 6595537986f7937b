# Written by python -m zbot.interfaces.stubs; do not edit.
from array import array
from collections.abc import Collection
from typing import Final, TypeAlias

import numpy
from numpy.typing import NDArray

import composition_interfaces.srv
import rcl_interfaces.msg
import service_msgs.msg
from zbot.interfaces import Action, Message, Service

class ListNodes_Request(Message):
    """composition_interfaces/srv/ListNodes_Request

    # Asks a container which nodes run inside it.
    """
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class ListNodes_Response(Message):
    """composition_interfaces/srv/ListNodes_Response

    # Their full names, with namespaces.
    string[] full_node_names
    # Their numbers, in the same order.
    uint64[] unique_ids
    """
    def __init__(self, *, full_node_names: Collection[str] = ..., unique_ids: Collection[int] = ..., check_fields: bool = ...) -> None: ...
    @property
    def full_node_names(self) -> list[str]: ...
    @full_node_names.setter
    def full_node_names(self, value: Collection[str]) -> None: ...
    @property
    def unique_ids(self) -> array[int]: ...
    @unique_ids.setter
    def unique_ids(self, value: Collection[int]) -> None: ...

class ListNodes_Event(Message):
    """composition_interfaces/srv/ListNodes_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[composition_interfaces.srv.ListNodes_Request] = ..., response: Collection[composition_interfaces.srv.ListNodes_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[composition_interfaces.srv.ListNodes_Request]: ...
    @request.setter
    def request(self, value: Collection[composition_interfaces.srv.ListNodes_Request]) -> None: ...
    @property
    def response(self) -> list[composition_interfaces.srv.ListNodes_Response]: ...
    @response.setter
    def response(self, value: Collection[composition_interfaces.srv.ListNodes_Response]) -> None: ...

class ListNodes(Service):
    Request: TypeAlias = ListNodes_Request
    Response: TypeAlias = ListNodes_Response
    Event: TypeAlias = ListNodes_Event

class LoadNode_Request(Message):
    """composition_interfaces/srv/LoadNode_Request

    # Makes a container start a node inside its own process.

    # The package of the node.
    string package_name
    # Which node of that package, such as 'demo::Talker'.
    string plugin_name

    # A name instead of the usual one; may be empty.
    string node_name
    # A namespace instead of the usual one; may be empty.
    string node_namespace
    # One of the levels in rcl_interfaces/Log.
    uint8 log_level
    # Remappings, such as 'chatter:=talk'.
    string[] remap_rules
    # Parameters to start with.
    rcl_interfaces/Parameter[] parameters

    # Further settings that this kind of container understands.
    rcl_interfaces/Parameter[] extra_arguments
    """
    def __init__(self, *, package_name: str = ..., plugin_name: str = ..., node_name: str = ..., node_namespace: str = ..., log_level: int = ..., remap_rules: Collection[str] = ..., parameters: Collection[rcl_interfaces.msg.Parameter] = ..., extra_arguments: Collection[rcl_interfaces.msg.Parameter] = ..., check_fields: bool = ...) -> None: ...
    package_name: str
    plugin_name: str
    node_name: str
    node_namespace: str
    log_level: int
    @property
    def remap_rules(self) -> list[str]: ...
    @remap_rules.setter
    def remap_rules(self, value: Collection[str]) -> None: ...
    @property
    def parameters(self) -> list[rcl_interfaces.msg.Parameter]: ...
    @parameters.setter
    def parameters(self, value: Collection[rcl_interfaces.msg.Parameter]) -> None: ...
    @property
    def extra_arguments(self) -> list[rcl_interfaces.msg.Parameter]: ...
    @extra_arguments.setter
    def extra_arguments(self, value: Collection[rcl_interfaces.msg.Parameter]) -> None: ...

class LoadNode_Response(Message):
    """composition_interfaces/srv/LoadNode_Response

    # Does the node run?
    bool success
    # Why not; empty on success.
    string error_message
    # Its full name, with namespace.
    string full_node_name
    # Its number, needed to unload it.
    uint64 unique_id
    """
    def __init__(self, *, success: bool = ..., error_message: str = ..., full_node_name: str = ..., unique_id: int = ..., check_fields: bool = ...) -> None: ...
    success: bool
    error_message: str
    full_node_name: str
    unique_id: int

class LoadNode_Event(Message):
    """composition_interfaces/srv/LoadNode_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[composition_interfaces.srv.LoadNode_Request] = ..., response: Collection[composition_interfaces.srv.LoadNode_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[composition_interfaces.srv.LoadNode_Request]: ...
    @request.setter
    def request(self, value: Collection[composition_interfaces.srv.LoadNode_Request]) -> None: ...
    @property
    def response(self) -> list[composition_interfaces.srv.LoadNode_Response]: ...
    @response.setter
    def response(self, value: Collection[composition_interfaces.srv.LoadNode_Response]) -> None: ...

class LoadNode(Service):
    Request: TypeAlias = LoadNode_Request
    Response: TypeAlias = LoadNode_Response
    Event: TypeAlias = LoadNode_Event

class UnloadNode_Request(Message):
    """composition_interfaces/srv/UnloadNode_Request

    # Makes a container stop one of its nodes.

    # Its number, from LoadNode or ListNodes.
    uint64 unique_id
    """
    def __init__(self, *, unique_id: int = ..., check_fields: bool = ...) -> None: ...
    unique_id: int

class UnloadNode_Response(Message):
    """composition_interfaces/srv/UnloadNode_Response

    # False if there is no such node.
    bool success
    # Why not; empty on success.
    string error_message
    """
    def __init__(self, *, success: bool = ..., error_message: str = ..., check_fields: bool = ...) -> None: ...
    success: bool
    error_message: str

class UnloadNode_Event(Message):
    """composition_interfaces/srv/UnloadNode_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[composition_interfaces.srv.UnloadNode_Request] = ..., response: Collection[composition_interfaces.srv.UnloadNode_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[composition_interfaces.srv.UnloadNode_Request]: ...
    @request.setter
    def request(self, value: Collection[composition_interfaces.srv.UnloadNode_Request]) -> None: ...
    @property
    def response(self) -> list[composition_interfaces.srv.UnloadNode_Response]: ...
    @response.setter
    def response(self, value: Collection[composition_interfaces.srv.UnloadNode_Response]) -> None: ...

class UnloadNode(Service):
    Request: TypeAlias = UnloadNode_Request
    Response: TypeAlias = UnloadNode_Response
    Event: TypeAlias = UnloadNode_Event
