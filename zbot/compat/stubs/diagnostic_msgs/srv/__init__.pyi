# Written by python -m zbot.interfaces.stubs; do not edit.
from array import array
from collections.abc import Collection
from typing import Final, TypeAlias

import numpy
from numpy.typing import NDArray

import diagnostic_msgs.msg
import diagnostic_msgs.srv
import service_msgs.msg
from zbot.interfaces import Action, Message, Service

class AddDiagnostics_Request(Message):
    """diagnostic_msgs/srv/AddDiagnostics_Request

    # Adds analyzers to a running diagnostic aggregator; called by loader programs.

    # Where the analyzers' parameters have been loaded: a full name such as '/robot/arm'.
    string load_namespace
    """
    def __init__(self, *, load_namespace: str = ..., check_fields: bool = ...) -> None: ...
    load_namespace: str

class AddDiagnostics_Response(Message):
    """diagnostic_msgs/srv/AddDiagnostics_Response


    # False if the namespace is in use already or an analyzer could not start.
    bool success

    # Details for people.
    string message
    """
    def __init__(self, *, success: bool = ..., message: str = ..., check_fields: bool = ...) -> None: ...
    success: bool
    message: str

class AddDiagnostics_Event(Message):
    """diagnostic_msgs/srv/AddDiagnostics_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[diagnostic_msgs.srv.AddDiagnostics_Request] = ..., response: Collection[diagnostic_msgs.srv.AddDiagnostics_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[diagnostic_msgs.srv.AddDiagnostics_Request]: ...
    @request.setter
    def request(self, value: Collection[diagnostic_msgs.srv.AddDiagnostics_Request]) -> None: ...
    @property
    def response(self) -> list[diagnostic_msgs.srv.AddDiagnostics_Response]: ...
    @response.setter
    def response(self, value: Collection[diagnostic_msgs.srv.AddDiagnostics_Response]) -> None: ...

class AddDiagnostics(Service):
    Request: TypeAlias = AddDiagnostics_Request
    Response: TypeAlias = AddDiagnostics_Response
    Event: TypeAlias = AddDiagnostics_Event

class SelfTest_Request(Message):
    """diagnostic_msgs/srv/SelfTest_Request

    # Makes a device test itself.
    """
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class SelfTest_Response(Message):
    """diagnostic_msgs/srv/SelfTest_Response

    string id # identity of the device
    byte passed # 1 if every test passed
    DiagnosticStatus[] status # one report per test
    """
    def __init__(self, *, id: str = ..., passed: bytes = ..., status: Collection[diagnostic_msgs.msg.DiagnosticStatus] = ..., check_fields: bool = ...) -> None: ...
    id: str
    passed: bytes
    @property
    def status(self) -> list[diagnostic_msgs.msg.DiagnosticStatus]: ...
    @status.setter
    def status(self, value: Collection[diagnostic_msgs.msg.DiagnosticStatus]) -> None: ...

class SelfTest_Event(Message):
    """diagnostic_msgs/srv/SelfTest_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[diagnostic_msgs.srv.SelfTest_Request] = ..., response: Collection[diagnostic_msgs.srv.SelfTest_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[diagnostic_msgs.srv.SelfTest_Request]: ...
    @request.setter
    def request(self, value: Collection[diagnostic_msgs.srv.SelfTest_Request]) -> None: ...
    @property
    def response(self) -> list[diagnostic_msgs.srv.SelfTest_Response]: ...
    @response.setter
    def response(self, value: Collection[diagnostic_msgs.srv.SelfTest_Response]) -> None: ...

class SelfTest(Service):
    Request: TypeAlias = SelfTest_Request
    Response: TypeAlias = SelfTest_Response
    Event: TypeAlias = SelfTest_Event
