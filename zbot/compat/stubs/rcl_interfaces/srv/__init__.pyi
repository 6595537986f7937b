# Written by python -m zbot.interfaces.stubs; do not edit.
from array import array
from collections.abc import Collection
from typing import Final, TypeAlias

import numpy
from numpy.typing import NDArray

import rcl_interfaces.msg
import rcl_interfaces.srv
import service_msgs.msg
from zbot.interfaces import Action, Message, Service

class DescribeParameters_Request(Message):
    """rcl_interfaces/srv/DescribeParameters_Request

    # Asks a node for the descriptors of some of its parameters.

    # Which parameters.
    string[] names
    """
    def __init__(self, *, names: Collection[str] = ..., check_fields: bool = ...) -> None: ...
    @property
    def names(self) -> list[str]: ...
    @names.setter
    def names(self, value: Collection[str]) -> None: ...

class DescribeParameters_Response(Message):
    """rcl_interfaces/srv/DescribeParameters_Response

    # One descriptor for each name, in the same order.
    ParameterDescriptor[] descriptors
    """
    def __init__(self, *, descriptors: Collection[rcl_interfaces.msg.ParameterDescriptor] = ..., check_fields: bool = ...) -> None: ...
    @property
    def descriptors(self) -> list[rcl_interfaces.msg.ParameterDescriptor]: ...
    @descriptors.setter
    def descriptors(self, value: Collection[rcl_interfaces.msg.ParameterDescriptor]) -> None: ...

class DescribeParameters_Event(Message):
    """rcl_interfaces/srv/DescribeParameters_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[rcl_interfaces.srv.DescribeParameters_Request] = ..., response: Collection[rcl_interfaces.srv.DescribeParameters_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[rcl_interfaces.srv.DescribeParameters_Request]: ...
    @request.setter
    def request(self, value: Collection[rcl_interfaces.srv.DescribeParameters_Request]) -> None: ...
    @property
    def response(self) -> list[rcl_interfaces.srv.DescribeParameters_Response]: ...
    @response.setter
    def response(self, value: Collection[rcl_interfaces.srv.DescribeParameters_Response]) -> None: ...

class DescribeParameters(Service):
    Request: TypeAlias = DescribeParameters_Request
    Response: TypeAlias = DescribeParameters_Response
    Event: TypeAlias = DescribeParameters_Event

class GetLoggerLevels_Request(Message):
    """rcl_interfaces/srv/GetLoggerLevels_Request

    # Asks a node for the levels of loggers.

    # Which loggers.
    string[] names
    """
    def __init__(self, *, names: Collection[str] = ..., check_fields: bool = ...) -> None: ...
    @property
    def names(self) -> list[str]: ...
    @names.setter
    def names(self, value: Collection[str]) -> None: ...

class GetLoggerLevels_Response(Message):
    """rcl_interfaces/srv/GetLoggerLevels_Response

    # One level for each name, in the same order; LOG_LEVEL_UNKNOWN where none was set.
    LoggerLevel[] levels
    """
    def __init__(self, *, levels: Collection[rcl_interfaces.msg.LoggerLevel] = ..., check_fields: bool = ...) -> None: ...
    @property
    def levels(self) -> list[rcl_interfaces.msg.LoggerLevel]: ...
    @levels.setter
    def levels(self, value: Collection[rcl_interfaces.msg.LoggerLevel]) -> None: ...

class GetLoggerLevels_Event(Message):
    """rcl_interfaces/srv/GetLoggerLevels_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[rcl_interfaces.srv.GetLoggerLevels_Request] = ..., response: Collection[rcl_interfaces.srv.GetLoggerLevels_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[rcl_interfaces.srv.GetLoggerLevels_Request]: ...
    @request.setter
    def request(self, value: Collection[rcl_interfaces.srv.GetLoggerLevels_Request]) -> None: ...
    @property
    def response(self) -> list[rcl_interfaces.srv.GetLoggerLevels_Response]: ...
    @response.setter
    def response(self, value: Collection[rcl_interfaces.srv.GetLoggerLevels_Response]) -> None: ...

class GetLoggerLevels(Service):
    Request: TypeAlias = GetLoggerLevels_Request
    Response: TypeAlias = GetLoggerLevels_Response
    Event: TypeAlias = GetLoggerLevels_Event

class GetParameterTypes_Request(Message):
    """rcl_interfaces/srv/GetParameterTypes_Request

    # Asks a node which kinds of value some of its parameters hold.

    # Which parameters.
    string[] names
    """
    def __init__(self, *, names: Collection[str] = ..., check_fields: bool = ...) -> None: ...
    @property
    def names(self) -> list[str]: ...
    @names.setter
    def names(self, value: Collection[str]) -> None: ...

class GetParameterTypes_Response(Message):
    """rcl_interfaces/srv/GetParameterTypes_Response

    # One constant of ParameterType for each name, in the same order.
    uint8[] types
    """
    def __init__(self, *, types: Collection[int] = ..., check_fields: bool = ...) -> None: ...
    @property
    def types(self) -> array[int]: ...
    @types.setter
    def types(self, value: Collection[int]) -> None: ...

class GetParameterTypes_Event(Message):
    """rcl_interfaces/srv/GetParameterTypes_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[rcl_interfaces.srv.GetParameterTypes_Request] = ..., response: Collection[rcl_interfaces.srv.GetParameterTypes_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[rcl_interfaces.srv.GetParameterTypes_Request]: ...
    @request.setter
    def request(self, value: Collection[rcl_interfaces.srv.GetParameterTypes_Request]) -> None: ...
    @property
    def response(self) -> list[rcl_interfaces.srv.GetParameterTypes_Response]: ...
    @response.setter
    def response(self, value: Collection[rcl_interfaces.srv.GetParameterTypes_Response]) -> None: ...

class GetParameterTypes(Service):
    Request: TypeAlias = GetParameterTypes_Request
    Response: TypeAlias = GetParameterTypes_Response
    Event: TypeAlias = GetParameterTypes_Event

class GetParameters_Request(Message):
    """rcl_interfaces/srv/GetParameters_Request

    # Asks a node for the values of some of its parameters.

    # Which parameters.
    string[] names
    """
    def __init__(self, *, names: Collection[str] = ..., check_fields: bool = ...) -> None: ...
    @property
    def names(self) -> list[str]: ...
    @names.setter
    def names(self, value: Collection[str]) -> None: ...

class GetParameters_Response(Message):
    """rcl_interfaces/srv/GetParameters_Response

    # One value for each name, in the same order; of type PARAMETER_NOT_SET where there is none.
    ParameterValue[] values
    """
    def __init__(self, *, values: Collection[rcl_interfaces.msg.ParameterValue] = ..., check_fields: bool = ...) -> None: ...
    @property
    def values(self) -> list[rcl_interfaces.msg.ParameterValue]: ...
    @values.setter
    def values(self, value: Collection[rcl_interfaces.msg.ParameterValue]) -> None: ...

class GetParameters_Event(Message):
    """rcl_interfaces/srv/GetParameters_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[rcl_interfaces.srv.GetParameters_Request] = ..., response: Collection[rcl_interfaces.srv.GetParameters_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[rcl_interfaces.srv.GetParameters_Request]: ...
    @request.setter
    def request(self, value: Collection[rcl_interfaces.srv.GetParameters_Request]) -> None: ...
    @property
    def response(self) -> list[rcl_interfaces.srv.GetParameters_Response]: ...
    @response.setter
    def response(self, value: Collection[rcl_interfaces.srv.GetParameters_Response]) -> None: ...

class GetParameters(Service):
    Request: TypeAlias = GetParameters_Request
    Response: TypeAlias = GetParameters_Response
    Event: TypeAlias = GetParameters_Event

class ListParameters_Request(Message):
    """rcl_interfaces/srv/ListParameters_Request

    # Asks a node for the names of its parameters.

    # Stands for "however deep the names are nested".
    uint64 DEPTH_RECURSIVE=0

    # Groups to look into, such as 'camera'; none means all parameters.
    string[] prefixes

    # How many levels below the groups to go, or DEPTH_RECURSIVE.
    uint64 depth
    """
    DEPTH_RECURSIVE: Final = 0
    def __init__(self, *, prefixes: Collection[str] = ..., depth: int = ..., check_fields: bool = ...) -> None: ...
    @property
    def prefixes(self) -> list[str]: ...
    @prefixes.setter
    def prefixes(self, value: Collection[str]) -> None: ...
    depth: int

class ListParameters_Response(Message):
    """rcl_interfaces/srv/ListParameters_Response

    # What was found.
    ListParametersResult result
    """
    def __init__(self, *, result: rcl_interfaces.msg.ListParametersResult = ..., check_fields: bool = ...) -> None: ...
    result: rcl_interfaces.msg.ListParametersResult

class ListParameters_Event(Message):
    """rcl_interfaces/srv/ListParameters_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[rcl_interfaces.srv.ListParameters_Request] = ..., response: Collection[rcl_interfaces.srv.ListParameters_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[rcl_interfaces.srv.ListParameters_Request]: ...
    @request.setter
    def request(self, value: Collection[rcl_interfaces.srv.ListParameters_Request]) -> None: ...
    @property
    def response(self) -> list[rcl_interfaces.srv.ListParameters_Response]: ...
    @response.setter
    def response(self, value: Collection[rcl_interfaces.srv.ListParameters_Response]) -> None: ...

class ListParameters(Service):
    Request: TypeAlias = ListParameters_Request
    Response: TypeAlias = ListParameters_Response
    Event: TypeAlias = ListParameters_Event

class SetLoggerLevels_Request(Message):
    """rcl_interfaces/srv/SetLoggerLevels_Request

    # Sets the levels of loggers.

    # Loggers with their new levels.
    LoggerLevel[] levels
    """
    def __init__(self, *, levels: Collection[rcl_interfaces.msg.LoggerLevel] = ..., check_fields: bool = ...) -> None: ...
    @property
    def levels(self) -> list[rcl_interfaces.msg.LoggerLevel]: ...
    @levels.setter
    def levels(self, value: Collection[rcl_interfaces.msg.LoggerLevel]) -> None: ...

class SetLoggerLevels_Response(Message):
    """rcl_interfaces/srv/SetLoggerLevels_Response

    # One result for each logger, in the same order.
    SetLoggerLevelsResult[] results
    """
    def __init__(self, *, results: Collection[rcl_interfaces.msg.SetLoggerLevelsResult] = ..., check_fields: bool = ...) -> None: ...
    @property
    def results(self) -> list[rcl_interfaces.msg.SetLoggerLevelsResult]: ...
    @results.setter
    def results(self, value: Collection[rcl_interfaces.msg.SetLoggerLevelsResult]) -> None: ...

class SetLoggerLevels_Event(Message):
    """rcl_interfaces/srv/SetLoggerLevels_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[rcl_interfaces.srv.SetLoggerLevels_Request] = ..., response: Collection[rcl_interfaces.srv.SetLoggerLevels_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[rcl_interfaces.srv.SetLoggerLevels_Request]: ...
    @request.setter
    def request(self, value: Collection[rcl_interfaces.srv.SetLoggerLevels_Request]) -> None: ...
    @property
    def response(self) -> list[rcl_interfaces.srv.SetLoggerLevels_Response]: ...
    @response.setter
    def response(self, value: Collection[rcl_interfaces.srv.SetLoggerLevels_Response]) -> None: ...

class SetLoggerLevels(Service):
    Request: TypeAlias = SetLoggerLevels_Request
    Response: TypeAlias = SetLoggerLevels_Response
    Event: TypeAlias = SetLoggerLevels_Event

class SetParameters_Request(Message):
    """rcl_interfaces/srv/SetParameters_Request

    # Sets parameters one by one; some may be refused while others are taken.

    # Parameters with their new values.
    Parameter[] parameters
    """
    def __init__(self, *, parameters: Collection[rcl_interfaces.msg.Parameter] = ..., check_fields: bool = ...) -> None: ...
    @property
    def parameters(self) -> list[rcl_interfaces.msg.Parameter]: ...
    @parameters.setter
    def parameters(self, value: Collection[rcl_interfaces.msg.Parameter]) -> None: ...

class SetParameters_Response(Message):
    """rcl_interfaces/srv/SetParameters_Response

    # One result for each parameter, in the same order.
    SetParametersResult[] results
    """
    def __init__(self, *, results: Collection[rcl_interfaces.msg.SetParametersResult] = ..., check_fields: bool = ...) -> None: ...
    @property
    def results(self) -> list[rcl_interfaces.msg.SetParametersResult]: ...
    @results.setter
    def results(self, value: Collection[rcl_interfaces.msg.SetParametersResult]) -> None: ...

class SetParameters_Event(Message):
    """rcl_interfaces/srv/SetParameters_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[rcl_interfaces.srv.SetParameters_Request] = ..., response: Collection[rcl_interfaces.srv.SetParameters_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[rcl_interfaces.srv.SetParameters_Request]: ...
    @request.setter
    def request(self, value: Collection[rcl_interfaces.srv.SetParameters_Request]) -> None: ...
    @property
    def response(self) -> list[rcl_interfaces.srv.SetParameters_Response]: ...
    @response.setter
    def response(self, value: Collection[rcl_interfaces.srv.SetParameters_Response]) -> None: ...

class SetParameters(Service):
    Request: TypeAlias = SetParameters_Request
    Response: TypeAlias = SetParameters_Response
    Event: TypeAlias = SetParameters_Event

class SetParametersAtomically_Request(Message):
    """rcl_interfaces/srv/SetParametersAtomically_Request

    # Sets parameters together: one refusal and none of them changes.

    # Parameters with their new values.
    Parameter[] parameters
    """
    def __init__(self, *, parameters: Collection[rcl_interfaces.msg.Parameter] = ..., check_fields: bool = ...) -> None: ...
    @property
    def parameters(self) -> list[rcl_interfaces.msg.Parameter]: ...
    @parameters.setter
    def parameters(self, value: Collection[rcl_interfaces.msg.Parameter]) -> None: ...

class SetParametersAtomically_Response(Message):
    """rcl_interfaces/srv/SetParametersAtomically_Response

    # A single result for the whole change.
    SetParametersResult result
    """
    def __init__(self, *, result: rcl_interfaces.msg.SetParametersResult = ..., check_fields: bool = ...) -> None: ...
    result: rcl_interfaces.msg.SetParametersResult

class SetParametersAtomically_Event(Message):
    """rcl_interfaces/srv/SetParametersAtomically_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[rcl_interfaces.srv.SetParametersAtomically_Request] = ..., response: Collection[rcl_interfaces.srv.SetParametersAtomically_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[rcl_interfaces.srv.SetParametersAtomically_Request]: ...
    @request.setter
    def request(self, value: Collection[rcl_interfaces.srv.SetParametersAtomically_Request]) -> None: ...
    @property
    def response(self) -> list[rcl_interfaces.srv.SetParametersAtomically_Response]: ...
    @response.setter
    def response(self, value: Collection[rcl_interfaces.srv.SetParametersAtomically_Response]) -> None: ...

class SetParametersAtomically(Service):
    Request: TypeAlias = SetParametersAtomically_Request
    Response: TypeAlias = SetParametersAtomically_Response
    Event: TypeAlias = SetParametersAtomically_Event
