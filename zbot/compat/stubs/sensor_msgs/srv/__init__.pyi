# Written by python -m zbot.interfaces.stubs; do not edit.
from array import array
from collections.abc import Collection
from typing import Final, TypeAlias

import numpy
from numpy.typing import NDArray

import sensor_msgs.msg
import sensor_msgs.srv
import service_msgs.msg
from zbot.interfaces import Action, Message, Service

class SetCameraInfo_Request(Message):
    """sensor_msgs/srv/SetCameraInfo_Request

    # Stores a calibration in a camera. Size and region must match what the camera delivers now.

    sensor_msgs/CameraInfo camera_info # the calibration
    """
    def __init__(self, *, camera_info: sensor_msgs.msg.CameraInfo = ..., check_fields: bool = ...) -> None: ...
    camera_info: sensor_msgs.msg.CameraInfo

class SetCameraInfo_Response(Message):
    """sensor_msgs/srv/SetCameraInfo_Response

    bool success                             # did it work?
    string status_message                    # details for people
    """
    def __init__(self, *, success: bool = ..., status_message: str = ..., check_fields: bool = ...) -> None: ...
    success: bool
    status_message: str

class SetCameraInfo_Event(Message):
    """sensor_msgs/srv/SetCameraInfo_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[sensor_msgs.srv.SetCameraInfo_Request] = ..., response: Collection[sensor_msgs.srv.SetCameraInfo_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[sensor_msgs.srv.SetCameraInfo_Request]: ...
    @request.setter
    def request(self, value: Collection[sensor_msgs.srv.SetCameraInfo_Request]) -> None: ...
    @property
    def response(self) -> list[sensor_msgs.srv.SetCameraInfo_Response]: ...
    @response.setter
    def response(self, value: Collection[sensor_msgs.srv.SetCameraInfo_Response]) -> None: ...

class SetCameraInfo(Service):
    Request: TypeAlias = SetCameraInfo_Request
    Response: TypeAlias = SetCameraInfo_Response
    Event: TypeAlias = SetCameraInfo_Event
