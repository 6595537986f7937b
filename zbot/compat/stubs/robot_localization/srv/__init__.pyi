# Written by python -m zbot.interfaces.stubs; do not edit.
from array import array
from collections.abc import Collection
from typing import Final, TypeAlias

import numpy
from numpy.typing import NDArray

import builtin_interfaces.msg
import geographic_msgs.msg
import geometry_msgs.msg
import robot_localization.srv
import service_msgs.msg
from zbot.interfaces import Action, Message, Service

class FromLL_Request(Message):
    """robot_localization/srv/FromLL_Request

    # Returns the position in the map of a place of the earth.

    geographic_msgs/GeoPoint ll_point
    """
    def __init__(self, *, ll_point: geographic_msgs.msg.GeoPoint = ..., check_fields: bool = ...) -> None: ...
    ll_point: geographic_msgs.msg.GeoPoint

class FromLL_Response(Message):
    """robot_localization/srv/FromLL_Response

    geometry_msgs/Point map_point  # m
    """
    def __init__(self, *, map_point: geometry_msgs.msg.Point = ..., check_fields: bool = ...) -> None: ...
    map_point: geometry_msgs.msg.Point

class FromLL_Event(Message):
    """robot_localization/srv/FromLL_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[robot_localization.srv.FromLL_Request] = ..., response: Collection[robot_localization.srv.FromLL_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[robot_localization.srv.FromLL_Request]: ...
    @request.setter
    def request(self, value: Collection[robot_localization.srv.FromLL_Request]) -> None: ...
    @property
    def response(self) -> list[robot_localization.srv.FromLL_Response]: ...
    @response.setter
    def response(self, value: Collection[robot_localization.srv.FromLL_Response]) -> None: ...

class FromLL(Service):
    Request: TypeAlias = FromLL_Request
    Response: TypeAlias = FromLL_Response
    Event: TypeAlias = FromLL_Event

class FromLLArray_Request(Message):
    """robot_localization/srv/FromLLArray_Request

    # Returns the positions in the map of places of the earth.

    geographic_msgs/GeoPoint[] ll_points
    """
    def __init__(self, *, ll_points: Collection[geographic_msgs.msg.GeoPoint] = ..., check_fields: bool = ...) -> None: ...
    @property
    def ll_points(self) -> list[geographic_msgs.msg.GeoPoint]: ...
    @ll_points.setter
    def ll_points(self, value: Collection[geographic_msgs.msg.GeoPoint]) -> None: ...

class FromLLArray_Response(Message):
    """robot_localization/srv/FromLLArray_Response

    geometry_msgs/Point[] map_points  # m
    """
    def __init__(self, *, map_points: Collection[geometry_msgs.msg.Point] = ..., check_fields: bool = ...) -> None: ...
    @property
    def map_points(self) -> list[geometry_msgs.msg.Point]: ...
    @map_points.setter
    def map_points(self, value: Collection[geometry_msgs.msg.Point]) -> None: ...

class FromLLArray_Event(Message):
    """robot_localization/srv/FromLLArray_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[robot_localization.srv.FromLLArray_Request] = ..., response: Collection[robot_localization.srv.FromLLArray_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[robot_localization.srv.FromLLArray_Request]: ...
    @request.setter
    def request(self, value: Collection[robot_localization.srv.FromLLArray_Request]) -> None: ...
    @property
    def response(self) -> list[robot_localization.srv.FromLLArray_Response]: ...
    @response.setter
    def response(self, value: Collection[robot_localization.srv.FromLLArray_Response]) -> None: ...

class FromLLArray(Service):
    Request: TypeAlias = FromLLArray_Request
    Response: TypeAlias = FromLLArray_Response
    Event: TypeAlias = FromLLArray_Event

class GetState_Request(Message):
    """robot_localization/srv/GetState_Request

    # Returns the state of the filter at a time.

    builtin_interfaces/Time time_stamp
    string frame_id
    """
    def __init__(self, *, time_stamp: builtin_interfaces.msg.Time = ..., frame_id: str = ..., check_fields: bool = ...) -> None: ...
    time_stamp: builtin_interfaces.msg.Time
    frame_id: str

class GetState_Response(Message):
    """robot_localization/srv/GetState_Response

    float64[15] state  # x, y, z, roll, pitch, yaw, their speeds, and the accelerations of x, y and z
    float64[225] covariance
    """
    def __init__(self, *, state: Collection[float] = ..., covariance: Collection[float] = ..., check_fields: bool = ...) -> None: ...
    @property
    def state(self) -> NDArray[numpy.float64]: ...
    @state.setter
    def state(self, value: Collection[float]) -> None: ...
    @property
    def covariance(self) -> NDArray[numpy.float64]: ...
    @covariance.setter
    def covariance(self, value: Collection[float]) -> None: ...

class GetState_Event(Message):
    """robot_localization/srv/GetState_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[robot_localization.srv.GetState_Request] = ..., response: Collection[robot_localization.srv.GetState_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[robot_localization.srv.GetState_Request]: ...
    @request.setter
    def request(self, value: Collection[robot_localization.srv.GetState_Request]) -> None: ...
    @property
    def response(self) -> list[robot_localization.srv.GetState_Response]: ...
    @response.setter
    def response(self, value: Collection[robot_localization.srv.GetState_Response]) -> None: ...

class GetState(Service):
    Request: TypeAlias = GetState_Request
    Response: TypeAlias = GetState_Response
    Event: TypeAlias = GetState_Event

class SetDatum_Request(Message):
    """robot_localization/srv/SetDatum_Request

    # Sets the place of the earth that is the origin.

    geographic_msgs/GeoPose geo_pose
    """
    def __init__(self, *, geo_pose: geographic_msgs.msg.GeoPose = ..., check_fields: bool = ...) -> None: ...
    geo_pose: geographic_msgs.msg.GeoPose

class SetDatum_Response(Message):
    """robot_localization/srv/SetDatum_Response"""
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class SetDatum_Event(Message):
    """robot_localization/srv/SetDatum_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[robot_localization.srv.SetDatum_Request] = ..., response: Collection[robot_localization.srv.SetDatum_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[robot_localization.srv.SetDatum_Request]: ...
    @request.setter
    def request(self, value: Collection[robot_localization.srv.SetDatum_Request]) -> None: ...
    @property
    def response(self) -> list[robot_localization.srv.SetDatum_Response]: ...
    @response.setter
    def response(self, value: Collection[robot_localization.srv.SetDatum_Response]) -> None: ...

class SetDatum(Service):
    Request: TypeAlias = SetDatum_Request
    Response: TypeAlias = SetDatum_Response
    Event: TypeAlias = SetDatum_Event

class SetPose_Request(Message):
    """robot_localization/srv/SetPose_Request

    # Sets the pose that the filter continues from.

    geometry_msgs/PoseWithCovarianceStamped pose
    """
    def __init__(self, *, pose: geometry_msgs.msg.PoseWithCovarianceStamped = ..., check_fields: bool = ...) -> None: ...
    pose: geometry_msgs.msg.PoseWithCovarianceStamped

class SetPose_Response(Message):
    """robot_localization/srv/SetPose_Response"""
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class SetPose_Event(Message):
    """robot_localization/srv/SetPose_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[robot_localization.srv.SetPose_Request] = ..., response: Collection[robot_localization.srv.SetPose_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[robot_localization.srv.SetPose_Request]: ...
    @request.setter
    def request(self, value: Collection[robot_localization.srv.SetPose_Request]) -> None: ...
    @property
    def response(self) -> list[robot_localization.srv.SetPose_Response]: ...
    @response.setter
    def response(self, value: Collection[robot_localization.srv.SetPose_Response]) -> None: ...

class SetPose(Service):
    Request: TypeAlias = SetPose_Request
    Response: TypeAlias = SetPose_Response
    Event: TypeAlias = SetPose_Event

class SetUTMZone_Request(Message):
    """robot_localization/srv/SetUTMZone_Request

    # Sets the zone of the UTM grid.

    string utm_zone  # e.g. 32U
    """
    def __init__(self, *, utm_zone: str = ..., check_fields: bool = ...) -> None: ...
    utm_zone: str

class SetUTMZone_Response(Message):
    """robot_localization/srv/SetUTMZone_Response"""
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class SetUTMZone_Event(Message):
    """robot_localization/srv/SetUTMZone_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[robot_localization.srv.SetUTMZone_Request] = ..., response: Collection[robot_localization.srv.SetUTMZone_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[robot_localization.srv.SetUTMZone_Request]: ...
    @request.setter
    def request(self, value: Collection[robot_localization.srv.SetUTMZone_Request]) -> None: ...
    @property
    def response(self) -> list[robot_localization.srv.SetUTMZone_Response]: ...
    @response.setter
    def response(self, value: Collection[robot_localization.srv.SetUTMZone_Response]) -> None: ...

class SetUTMZone(Service):
    Request: TypeAlias = SetUTMZone_Request
    Response: TypeAlias = SetUTMZone_Response
    Event: TypeAlias = SetUTMZone_Event

class ToLL_Request(Message):
    """robot_localization/srv/ToLL_Request

    # Returns the place of the earth of a position in the map.

    geometry_msgs/Point map_point  # m
    """
    def __init__(self, *, map_point: geometry_msgs.msg.Point = ..., check_fields: bool = ...) -> None: ...
    map_point: geometry_msgs.msg.Point

class ToLL_Response(Message):
    """robot_localization/srv/ToLL_Response

    geographic_msgs/GeoPoint ll_point
    """
    def __init__(self, *, ll_point: geographic_msgs.msg.GeoPoint = ..., check_fields: bool = ...) -> None: ...
    ll_point: geographic_msgs.msg.GeoPoint

class ToLL_Event(Message):
    """robot_localization/srv/ToLL_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[robot_localization.srv.ToLL_Request] = ..., response: Collection[robot_localization.srv.ToLL_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[robot_localization.srv.ToLL_Request]: ...
    @request.setter
    def request(self, value: Collection[robot_localization.srv.ToLL_Request]) -> None: ...
    @property
    def response(self) -> list[robot_localization.srv.ToLL_Response]: ...
    @response.setter
    def response(self, value: Collection[robot_localization.srv.ToLL_Response]) -> None: ...

class ToLL(Service):
    Request: TypeAlias = ToLL_Request
    Response: TypeAlias = ToLL_Response
    Event: TypeAlias = ToLL_Event

class ToggleFilterProcessing_Request(Message):
    """robot_localization/srv/ToggleFilterProcessing_Request

    # Switches the filter on or off.

    bool on
    """
    def __init__(self, *, on: bool = ..., check_fields: bool = ...) -> None: ...
    on: bool

class ToggleFilterProcessing_Response(Message):
    """robot_localization/srv/ToggleFilterProcessing_Response

    bool status
    """
    def __init__(self, *, status: bool = ..., check_fields: bool = ...) -> None: ...
    status: bool

class ToggleFilterProcessing_Event(Message):
    """robot_localization/srv/ToggleFilterProcessing_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[robot_localization.srv.ToggleFilterProcessing_Request] = ..., response: Collection[robot_localization.srv.ToggleFilterProcessing_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[robot_localization.srv.ToggleFilterProcessing_Request]: ...
    @request.setter
    def request(self, value: Collection[robot_localization.srv.ToggleFilterProcessing_Request]) -> None: ...
    @property
    def response(self) -> list[robot_localization.srv.ToggleFilterProcessing_Response]: ...
    @response.setter
    def response(self, value: Collection[robot_localization.srv.ToggleFilterProcessing_Response]) -> None: ...

class ToggleFilterProcessing(Service):
    Request: TypeAlias = ToggleFilterProcessing_Request
    Response: TypeAlias = ToggleFilterProcessing_Response
    Event: TypeAlias = ToggleFilterProcessing_Event
