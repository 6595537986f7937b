# Written by python -m zbot.interfaces.stubs; do not edit.
from array import array
from collections.abc import Collection
from typing import Final, TypeAlias

import numpy
from numpy.typing import NDArray

import service_msgs.msg
import type_description_interfaces.msg
import type_description_interfaces.srv
from zbot.interfaces import Action, Message, Service

class GetTypeDescription_Request(Message):
    """type_description_interfaces/srv/GetTypeDescription_Request

    # Asks a node what a type that it uses looks like.

    # Full name, such as 'std_msgs/msg/String'.
    string type_name

    # The type's hash, starting with 'RIHS01_'.
    string type_hash

    # Whether to answer with the original definition texts too.
    bool include_type_sources true
    """
    def __init__(self, *, type_name: str = ..., type_hash: str = ..., include_type_sources: bool = ..., check_fields: bool = ...) -> None: ...
    type_name: str
    type_hash: str
    include_type_sources: bool

class GetTypeDescription_Response(Message):
    """type_description_interfaces/srv/GetTypeDescription_Response

    # False if the node does not know the type; then only failure_reason has a meaning.
    bool successful
    # Why it failed; empty on success.
    string failure_reason

    # The type in a form that programs can read.
    TypeDescription type_description

    # The definition of the type and of each type it refers to; matched by type_name.
    TypeSource[] type_sources

    # Anything else the node wants to tell.
    KeyValue[] extra_information
    """
    def __init__(self, *, successful: bool = ..., failure_reason: str = ..., type_description: type_description_interfaces.msg.TypeDescription = ..., type_sources: Collection[type_description_interfaces.msg.TypeSource] = ..., extra_information: Collection[type_description_interfaces.msg.KeyValue] = ..., check_fields: bool = ...) -> None: ...
    successful: bool
    failure_reason: str
    type_description: type_description_interfaces.msg.TypeDescription
    @property
    def type_sources(self) -> list[type_description_interfaces.msg.TypeSource]: ...
    @type_sources.setter
    def type_sources(self, value: Collection[type_description_interfaces.msg.TypeSource]) -> None: ...
    @property
    def extra_information(self) -> list[type_description_interfaces.msg.KeyValue]: ...
    @extra_information.setter
    def extra_information(self, value: Collection[type_description_interfaces.msg.KeyValue]) -> None: ...

class GetTypeDescription_Event(Message):
    """type_description_interfaces/srv/GetTypeDescription_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[type_description_interfaces.srv.GetTypeDescription_Request] = ..., response: Collection[type_description_interfaces.srv.GetTypeDescription_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[type_description_interfaces.srv.GetTypeDescription_Request]: ...
    @request.setter
    def request(self, value: Collection[type_description_interfaces.srv.GetTypeDescription_Request]) -> None: ...
    @property
    def response(self) -> list[type_description_interfaces.srv.GetTypeDescription_Response]: ...
    @response.setter
    def response(self, value: Collection[type_description_interfaces.srv.GetTypeDescription_Response]) -> None: ...

class GetTypeDescription(Service):
    Request: TypeAlias = GetTypeDescription_Request
    Response: TypeAlias = GetTypeDescription_Response
    Event: TypeAlias = GetTypeDescription_Event
