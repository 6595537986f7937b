# Written by python -m zbot.interfaces.stubs; do not edit.
from array import array
from collections.abc import Collection
from typing import Final, TypeAlias

import numpy
from numpy.typing import NDArray

import service_msgs.msg
import topic_tools_interfaces.srv
from zbot.interfaces import Action, Message, Service

class DemuxAdd_Request(Message):
    """topic_tools_interfaces/srv/DemuxAdd_Request

    # Adds a topic to those that can be chosen as the goal.

    string topic
    """
    def __init__(self, *, topic: str = ..., check_fields: bool = ...) -> None: ...
    topic: str

class DemuxAdd_Response(Message):
    """topic_tools_interfaces/srv/DemuxAdd_Response

    bool success
    """
    def __init__(self, *, success: bool = ..., check_fields: bool = ...) -> None: ...
    success: bool

class DemuxAdd_Event(Message):
    """topic_tools_interfaces/srv/DemuxAdd_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[topic_tools_interfaces.srv.DemuxAdd_Request] = ..., response: Collection[topic_tools_interfaces.srv.DemuxAdd_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[topic_tools_interfaces.srv.DemuxAdd_Request]: ...
    @request.setter
    def request(self, value: Collection[topic_tools_interfaces.srv.DemuxAdd_Request]) -> None: ...
    @property
    def response(self) -> list[topic_tools_interfaces.srv.DemuxAdd_Response]: ...
    @response.setter
    def response(self, value: Collection[topic_tools_interfaces.srv.DemuxAdd_Response]) -> None: ...

class DemuxAdd(Service):
    Request: TypeAlias = DemuxAdd_Request
    Response: TypeAlias = DemuxAdd_Response
    Event: TypeAlias = DemuxAdd_Event

class DemuxDelete_Request(Message):
    """topic_tools_interfaces/srv/DemuxDelete_Request

    # Removes a topic from those that can be chosen as the goal.

    string topic
    """
    def __init__(self, *, topic: str = ..., check_fields: bool = ...) -> None: ...
    topic: str

class DemuxDelete_Response(Message):
    """topic_tools_interfaces/srv/DemuxDelete_Response

    bool success
    """
    def __init__(self, *, success: bool = ..., check_fields: bool = ...) -> None: ...
    success: bool

class DemuxDelete_Event(Message):
    """topic_tools_interfaces/srv/DemuxDelete_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[topic_tools_interfaces.srv.DemuxDelete_Request] = ..., response: Collection[topic_tools_interfaces.srv.DemuxDelete_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[topic_tools_interfaces.srv.DemuxDelete_Request]: ...
    @request.setter
    def request(self, value: Collection[topic_tools_interfaces.srv.DemuxDelete_Request]) -> None: ...
    @property
    def response(self) -> list[topic_tools_interfaces.srv.DemuxDelete_Response]: ...
    @response.setter
    def response(self, value: Collection[topic_tools_interfaces.srv.DemuxDelete_Response]) -> None: ...

class DemuxDelete(Service):
    Request: TypeAlias = DemuxDelete_Request
    Response: TypeAlias = DemuxDelete_Response
    Event: TypeAlias = DemuxDelete_Event

class DemuxList_Request(Message):
    """topic_tools_interfaces/srv/DemuxList_Request

    # Lists the topics that can be chosen as the goal.
    """
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class DemuxList_Response(Message):
    """topic_tools_interfaces/srv/DemuxList_Response

    string[] topics
    """
    def __init__(self, *, topics: Collection[str] = ..., check_fields: bool = ...) -> None: ...
    @property
    def topics(self) -> list[str]: ...
    @topics.setter
    def topics(self, value: Collection[str]) -> None: ...

class DemuxList_Event(Message):
    """topic_tools_interfaces/srv/DemuxList_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[topic_tools_interfaces.srv.DemuxList_Request] = ..., response: Collection[topic_tools_interfaces.srv.DemuxList_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[topic_tools_interfaces.srv.DemuxList_Request]: ...
    @request.setter
    def request(self, value: Collection[topic_tools_interfaces.srv.DemuxList_Request]) -> None: ...
    @property
    def response(self) -> list[topic_tools_interfaces.srv.DemuxList_Response]: ...
    @response.setter
    def response(self, value: Collection[topic_tools_interfaces.srv.DemuxList_Response]) -> None: ...

class DemuxList(Service):
    Request: TypeAlias = DemuxList_Request
    Response: TypeAlias = DemuxList_Response
    Event: TypeAlias = DemuxList_Event

class DemuxSelect_Request(Message):
    """topic_tools_interfaces/srv/DemuxSelect_Request

    # Chooses the goal. "__none" chooses none.

    string topic
    """
    def __init__(self, *, topic: str = ..., check_fields: bool = ...) -> None: ...
    topic: str

class DemuxSelect_Response(Message):
    """topic_tools_interfaces/srv/DemuxSelect_Response

    string prev_topic  # the topic before
    bool success
    """
    def __init__(self, *, prev_topic: str = ..., success: bool = ..., check_fields: bool = ...) -> None: ...
    prev_topic: str
    success: bool

class DemuxSelect_Event(Message):
    """topic_tools_interfaces/srv/DemuxSelect_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[topic_tools_interfaces.srv.DemuxSelect_Request] = ..., response: Collection[topic_tools_interfaces.srv.DemuxSelect_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[topic_tools_interfaces.srv.DemuxSelect_Request]: ...
    @request.setter
    def request(self, value: Collection[topic_tools_interfaces.srv.DemuxSelect_Request]) -> None: ...
    @property
    def response(self) -> list[topic_tools_interfaces.srv.DemuxSelect_Response]: ...
    @response.setter
    def response(self, value: Collection[topic_tools_interfaces.srv.DemuxSelect_Response]) -> None: ...

class DemuxSelect(Service):
    Request: TypeAlias = DemuxSelect_Request
    Response: TypeAlias = DemuxSelect_Response
    Event: TypeAlias = DemuxSelect_Event

class MuxAdd_Request(Message):
    """topic_tools_interfaces/srv/MuxAdd_Request

    # Adds a topic to those that can be chosen as the source.

    string topic
    """
    def __init__(self, *, topic: str = ..., check_fields: bool = ...) -> None: ...
    topic: str

class MuxAdd_Response(Message):
    """topic_tools_interfaces/srv/MuxAdd_Response

    bool success
    """
    def __init__(self, *, success: bool = ..., check_fields: bool = ...) -> None: ...
    success: bool

class MuxAdd_Event(Message):
    """topic_tools_interfaces/srv/MuxAdd_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[topic_tools_interfaces.srv.MuxAdd_Request] = ..., response: Collection[topic_tools_interfaces.srv.MuxAdd_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[topic_tools_interfaces.srv.MuxAdd_Request]: ...
    @request.setter
    def request(self, value: Collection[topic_tools_interfaces.srv.MuxAdd_Request]) -> None: ...
    @property
    def response(self) -> list[topic_tools_interfaces.srv.MuxAdd_Response]: ...
    @response.setter
    def response(self, value: Collection[topic_tools_interfaces.srv.MuxAdd_Response]) -> None: ...

class MuxAdd(Service):
    Request: TypeAlias = MuxAdd_Request
    Response: TypeAlias = MuxAdd_Response
    Event: TypeAlias = MuxAdd_Event

class MuxDelete_Request(Message):
    """topic_tools_interfaces/srv/MuxDelete_Request

    # Removes a topic from those that can be chosen as the source.

    string topic
    """
    def __init__(self, *, topic: str = ..., check_fields: bool = ...) -> None: ...
    topic: str

class MuxDelete_Response(Message):
    """topic_tools_interfaces/srv/MuxDelete_Response

    bool success
    """
    def __init__(self, *, success: bool = ..., check_fields: bool = ...) -> None: ...
    success: bool

class MuxDelete_Event(Message):
    """topic_tools_interfaces/srv/MuxDelete_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[topic_tools_interfaces.srv.MuxDelete_Request] = ..., response: Collection[topic_tools_interfaces.srv.MuxDelete_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[topic_tools_interfaces.srv.MuxDelete_Request]: ...
    @request.setter
    def request(self, value: Collection[topic_tools_interfaces.srv.MuxDelete_Request]) -> None: ...
    @property
    def response(self) -> list[topic_tools_interfaces.srv.MuxDelete_Response]: ...
    @response.setter
    def response(self, value: Collection[topic_tools_interfaces.srv.MuxDelete_Response]) -> None: ...

class MuxDelete(Service):
    Request: TypeAlias = MuxDelete_Request
    Response: TypeAlias = MuxDelete_Response
    Event: TypeAlias = MuxDelete_Event

class MuxList_Request(Message):
    """topic_tools_interfaces/srv/MuxList_Request

    # Lists the topics that can be chosen as the source.
    """
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class MuxList_Response(Message):
    """topic_tools_interfaces/srv/MuxList_Response

    string[] topics
    """
    def __init__(self, *, topics: Collection[str] = ..., check_fields: bool = ...) -> None: ...
    @property
    def topics(self) -> list[str]: ...
    @topics.setter
    def topics(self, value: Collection[str]) -> None: ...

class MuxList_Event(Message):
    """topic_tools_interfaces/srv/MuxList_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[topic_tools_interfaces.srv.MuxList_Request] = ..., response: Collection[topic_tools_interfaces.srv.MuxList_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[topic_tools_interfaces.srv.MuxList_Request]: ...
    @request.setter
    def request(self, value: Collection[topic_tools_interfaces.srv.MuxList_Request]) -> None: ...
    @property
    def response(self) -> list[topic_tools_interfaces.srv.MuxList_Response]: ...
    @response.setter
    def response(self, value: Collection[topic_tools_interfaces.srv.MuxList_Response]) -> None: ...

class MuxList(Service):
    Request: TypeAlias = MuxList_Request
    Response: TypeAlias = MuxList_Response
    Event: TypeAlias = MuxList_Event

class MuxSelect_Request(Message):
    """topic_tools_interfaces/srv/MuxSelect_Request

    # Chooses the source. "__none" chooses none.

    string topic
    """
    def __init__(self, *, topic: str = ..., check_fields: bool = ...) -> None: ...
    topic: str

class MuxSelect_Response(Message):
    """topic_tools_interfaces/srv/MuxSelect_Response

    string prev_topic  # the topic before
    bool success
    """
    def __init__(self, *, prev_topic: str = ..., success: bool = ..., check_fields: bool = ...) -> None: ...
    prev_topic: str
    success: bool

class MuxSelect_Event(Message):
    """topic_tools_interfaces/srv/MuxSelect_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[topic_tools_interfaces.srv.MuxSelect_Request] = ..., response: Collection[topic_tools_interfaces.srv.MuxSelect_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[topic_tools_interfaces.srv.MuxSelect_Request]: ...
    @request.setter
    def request(self, value: Collection[topic_tools_interfaces.srv.MuxSelect_Request]) -> None: ...
    @property
    def response(self) -> list[topic_tools_interfaces.srv.MuxSelect_Response]: ...
    @response.setter
    def response(self, value: Collection[topic_tools_interfaces.srv.MuxSelect_Response]) -> None: ...

class MuxSelect(Service):
    Request: TypeAlias = MuxSelect_Request
    Response: TypeAlias = MuxSelect_Response
    Event: TypeAlias = MuxSelect_Event
