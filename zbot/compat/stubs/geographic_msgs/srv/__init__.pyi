# Written by python -m zbot.interfaces.stubs; do not edit.
from array import array
from collections.abc import Collection
from typing import Final, TypeAlias

import numpy
from numpy.typing import NDArray

import geographic_msgs.msg
import geographic_msgs.srv
import service_msgs.msg
import unique_identifier_msgs.msg
from zbot.interfaces import Action, Message, Service

class GetGeoPath_Request(Message):
    """geographic_msgs/srv/GetGeoPath_Request

    geographic_msgs/GeoPoint start
    geographic_msgs/GeoPoint goal
    """
    def __init__(self, *, start: geographic_msgs.msg.GeoPoint = ..., goal: geographic_msgs.msg.GeoPoint = ..., check_fields: bool = ...) -> None: ...
    start: geographic_msgs.msg.GeoPoint
    goal: geographic_msgs.msg.GeoPoint

class GetGeoPath_Response(Message):
    """geographic_msgs/srv/GetGeoPath_Response

    bool success
    string status
    geographic_msgs/GeoPath plan
    unique_identifier_msgs/UUID network
    unique_identifier_msgs/UUID start_seg
    unique_identifier_msgs/UUID goal_seg
    float64 distance
    """
    def __init__(self, *, success: bool = ..., status: str = ..., plan: geographic_msgs.msg.GeoPath = ..., network: unique_identifier_msgs.msg.UUID = ..., start_seg: unique_identifier_msgs.msg.UUID = ..., goal_seg: unique_identifier_msgs.msg.UUID = ..., distance: float = ..., check_fields: bool = ...) -> None: ...
    success: bool
    status: str
    plan: geographic_msgs.msg.GeoPath
    network: unique_identifier_msgs.msg.UUID
    start_seg: unique_identifier_msgs.msg.UUID
    goal_seg: unique_identifier_msgs.msg.UUID
    distance: float

class GetGeoPath_Event(Message):
    """geographic_msgs/srv/GetGeoPath_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[geographic_msgs.srv.GetGeoPath_Request] = ..., response: Collection[geographic_msgs.srv.GetGeoPath_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[geographic_msgs.srv.GetGeoPath_Request]: ...
    @request.setter
    def request(self, value: Collection[geographic_msgs.srv.GetGeoPath_Request]) -> None: ...
    @property
    def response(self) -> list[geographic_msgs.srv.GetGeoPath_Response]: ...
    @response.setter
    def response(self, value: Collection[geographic_msgs.srv.GetGeoPath_Response]) -> None: ...

class GetGeoPath(Service):
    Request: TypeAlias = GetGeoPath_Request
    Response: TypeAlias = GetGeoPath_Response
    Event: TypeAlias = GetGeoPath_Event

class GetGeographicMap_Request(Message):
    """geographic_msgs/srv/GetGeographicMap_Request

    string url
    BoundingBox bounds
    """
    def __init__(self, *, url: str = ..., bounds: geographic_msgs.msg.BoundingBox = ..., check_fields: bool = ...) -> None: ...
    url: str
    bounds: geographic_msgs.msg.BoundingBox

class GetGeographicMap_Response(Message):
    """geographic_msgs/srv/GetGeographicMap_Response

    bool success
    string status
    GeographicMap map
    """
    def __init__(self, *, success: bool = ..., status: str = ..., map: geographic_msgs.msg.GeographicMap = ..., check_fields: bool = ...) -> None: ...
    success: bool
    status: str
    map: geographic_msgs.msg.GeographicMap

class GetGeographicMap_Event(Message):
    """geographic_msgs/srv/GetGeographicMap_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[geographic_msgs.srv.GetGeographicMap_Request] = ..., response: Collection[geographic_msgs.srv.GetGeographicMap_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[geographic_msgs.srv.GetGeographicMap_Request]: ...
    @request.setter
    def request(self, value: Collection[geographic_msgs.srv.GetGeographicMap_Request]) -> None: ...
    @property
    def response(self) -> list[geographic_msgs.srv.GetGeographicMap_Response]: ...
    @response.setter
    def response(self, value: Collection[geographic_msgs.srv.GetGeographicMap_Response]) -> None: ...

class GetGeographicMap(Service):
    Request: TypeAlias = GetGeographicMap_Request
    Response: TypeAlias = GetGeographicMap_Response
    Event: TypeAlias = GetGeographicMap_Event

class GetRoutePlan_Request(Message):
    """geographic_msgs/srv/GetRoutePlan_Request

    unique_identifier_msgs/UUID network
    unique_identifier_msgs/UUID start
    unique_identifier_msgs/UUID goal
    """
    def __init__(self, *, network: unique_identifier_msgs.msg.UUID = ..., start: unique_identifier_msgs.msg.UUID = ..., goal: unique_identifier_msgs.msg.UUID = ..., check_fields: bool = ...) -> None: ...
    network: unique_identifier_msgs.msg.UUID
    start: unique_identifier_msgs.msg.UUID
    goal: unique_identifier_msgs.msg.UUID

class GetRoutePlan_Response(Message):
    """geographic_msgs/srv/GetRoutePlan_Response

    bool success
    string status
    RoutePath plan
    """
    def __init__(self, *, success: bool = ..., status: str = ..., plan: geographic_msgs.msg.RoutePath = ..., check_fields: bool = ...) -> None: ...
    success: bool
    status: str
    plan: geographic_msgs.msg.RoutePath

class GetRoutePlan_Event(Message):
    """geographic_msgs/srv/GetRoutePlan_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[geographic_msgs.srv.GetRoutePlan_Request] = ..., response: Collection[geographic_msgs.srv.GetRoutePlan_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[geographic_msgs.srv.GetRoutePlan_Request]: ...
    @request.setter
    def request(self, value: Collection[geographic_msgs.srv.GetRoutePlan_Request]) -> None: ...
    @property
    def response(self) -> list[geographic_msgs.srv.GetRoutePlan_Response]: ...
    @response.setter
    def response(self, value: Collection[geographic_msgs.srv.GetRoutePlan_Response]) -> None: ...

class GetRoutePlan(Service):
    Request: TypeAlias = GetRoutePlan_Request
    Response: TypeAlias = GetRoutePlan_Response
    Event: TypeAlias = GetRoutePlan_Event

class UpdateGeographicMap_Request(Message):
    """geographic_msgs/srv/UpdateGeographicMap_Request

    GeographicMapChanges updates
    """
    def __init__(self, *, updates: geographic_msgs.msg.GeographicMapChanges = ..., check_fields: bool = ...) -> None: ...
    updates: geographic_msgs.msg.GeographicMapChanges

class UpdateGeographicMap_Response(Message):
    """geographic_msgs/srv/UpdateGeographicMap_Response

    bool success
    string status
    """
    def __init__(self, *, success: bool = ..., status: str = ..., check_fields: bool = ...) -> None: ...
    success: bool
    status: str

class UpdateGeographicMap_Event(Message):
    """geographic_msgs/srv/UpdateGeographicMap_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[geographic_msgs.srv.UpdateGeographicMap_Request] = ..., response: Collection[geographic_msgs.srv.UpdateGeographicMap_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[geographic_msgs.srv.UpdateGeographicMap_Request]: ...
    @request.setter
    def request(self, value: Collection[geographic_msgs.srv.UpdateGeographicMap_Request]) -> None: ...
    @property
    def response(self) -> list[geographic_msgs.srv.UpdateGeographicMap_Response]: ...
    @response.setter
    def response(self, value: Collection[geographic_msgs.srv.UpdateGeographicMap_Response]) -> None: ...

class UpdateGeographicMap(Service):
    Request: TypeAlias = UpdateGeographicMap_Request
    Response: TypeAlias = UpdateGeographicMap_Response
    Event: TypeAlias = UpdateGeographicMap_Event
