# Written by python -m zbot.interfaces.stubs; do not edit.
from array import array
from collections.abc import Collection
from typing import Final, TypeAlias

import numpy
from numpy.typing import NDArray

import geometry_msgs.msg
import octomap_msgs.msg
import octomap_msgs.srv
import service_msgs.msg
from zbot.interfaces import Action, Message, Service

class BoundingBoxQuery_Request(Message):
    """octomap_msgs/srv/BoundingBoxQuery_Request

    # Marks all cells in a box.

    geometry_msgs/Point min  # m
    geometry_msgs/Point max  # m
    """
    def __init__(self, *, min: geometry_msgs.msg.Point = ..., max: geometry_msgs.msg.Point = ..., check_fields: bool = ...) -> None: ...
    min: geometry_msgs.msg.Point
    max: geometry_msgs.msg.Point

class BoundingBoxQuery_Response(Message):
    """octomap_msgs/srv/BoundingBoxQuery_Response"""
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class BoundingBoxQuery_Event(Message):
    """octomap_msgs/srv/BoundingBoxQuery_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[octomap_msgs.srv.BoundingBoxQuery_Request] = ..., response: Collection[octomap_msgs.srv.BoundingBoxQuery_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[octomap_msgs.srv.BoundingBoxQuery_Request]: ...
    @request.setter
    def request(self, value: Collection[octomap_msgs.srv.BoundingBoxQuery_Request]) -> None: ...
    @property
    def response(self) -> list[octomap_msgs.srv.BoundingBoxQuery_Response]: ...
    @response.setter
    def response(self, value: Collection[octomap_msgs.srv.BoundingBoxQuery_Response]) -> None: ...

class BoundingBoxQuery(Service):
    Request: TypeAlias = BoundingBoxQuery_Request
    Response: TypeAlias = BoundingBoxQuery_Response
    Event: TypeAlias = BoundingBoxQuery_Event

class GetOctomap_Request(Message):
    """octomap_msgs/srv/GetOctomap_Request

    # Returns the map.
    """
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class GetOctomap_Response(Message):
    """octomap_msgs/srv/GetOctomap_Response

    octomap_msgs/Octomap map
    """
    def __init__(self, *, map: octomap_msgs.msg.Octomap = ..., check_fields: bool = ...) -> None: ...
    map: octomap_msgs.msg.Octomap

class GetOctomap_Event(Message):
    """octomap_msgs/srv/GetOctomap_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[octomap_msgs.srv.GetOctomap_Request] = ..., response: Collection[octomap_msgs.srv.GetOctomap_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[octomap_msgs.srv.GetOctomap_Request]: ...
    @request.setter
    def request(self, value: Collection[octomap_msgs.srv.GetOctomap_Request]) -> None: ...
    @property
    def response(self) -> list[octomap_msgs.srv.GetOctomap_Response]: ...
    @response.setter
    def response(self, value: Collection[octomap_msgs.srv.GetOctomap_Response]) -> None: ...

class GetOctomap(Service):
    Request: TypeAlias = GetOctomap_Request
    Response: TypeAlias = GetOctomap_Response
    Event: TypeAlias = GetOctomap_Event
