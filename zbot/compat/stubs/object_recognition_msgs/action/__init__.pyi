# Written by python -m zbot.interfaces.stubs; do not edit.
from array import array
from collections.abc import Collection
from typing import Final, TypeAlias

import numpy
from numpy.typing import NDArray

import action_msgs.msg
import action_msgs.srv
import builtin_interfaces.msg
import object_recognition_msgs.action
import object_recognition_msgs.msg
import service_msgs.msg
import unique_identifier_msgs.msg
from zbot.interfaces import Action, Message, Service

class ObjectRecognition_Goal(Message):
    """object_recognition_msgs/action/ObjectRecognition_Goal

    # Looks for known objects in what the sensors see.

    bool use_roi  # look only inside filter_limits
    float32[] filter_limits  # m: x min, x max, y min, y max, z min, z max
    """
    def __init__(self, *, use_roi: bool = ..., filter_limits: Collection[float] = ..., check_fields: bool = ...) -> None: ...
    use_roi: bool
    @property
    def filter_limits(self) -> array[float]: ...
    @filter_limits.setter
    def filter_limits(self, value: Collection[float]) -> None: ...

class ObjectRecognition_Result(Message):
    """object_recognition_msgs/action/ObjectRecognition_Result

    object_recognition_msgs/RecognizedObjectArray recognized_objects
    """
    def __init__(self, *, recognized_objects: object_recognition_msgs.msg.RecognizedObjectArray = ..., check_fields: bool = ...) -> None: ...
    recognized_objects: object_recognition_msgs.msg.RecognizedObjectArray

class ObjectRecognition_Feedback(Message):
    """object_recognition_msgs/action/ObjectRecognition_Feedback"""
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class ObjectRecognition_FeedbackMessage(Message):
    """object_recognition_msgs/action/ObjectRecognition_FeedbackMessage"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., feedback: object_recognition_msgs.action.ObjectRecognition_Feedback = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    feedback: object_recognition_msgs.action.ObjectRecognition_Feedback

class ObjectRecognition_SendGoal_Request(Message):
    """object_recognition_msgs/action/ObjectRecognition_SendGoal_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., goal: object_recognition_msgs.action.ObjectRecognition_Goal = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    goal: object_recognition_msgs.action.ObjectRecognition_Goal

class ObjectRecognition_SendGoal_Response(Message):
    """object_recognition_msgs/action/ObjectRecognition_SendGoal_Response"""
    def __init__(self, *, accepted: bool = ..., stamp: builtin_interfaces.msg.Time = ..., check_fields: bool = ...) -> None: ...
    accepted: bool
    stamp: builtin_interfaces.msg.Time

class ObjectRecognition_SendGoal_Event(Message):
    """object_recognition_msgs/action/ObjectRecognition_SendGoal_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[object_recognition_msgs.action.ObjectRecognition_SendGoal_Request] = ..., response: Collection[object_recognition_msgs.action.ObjectRecognition_SendGoal_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[object_recognition_msgs.action.ObjectRecognition_SendGoal_Request]: ...
    @request.setter
    def request(self, value: Collection[object_recognition_msgs.action.ObjectRecognition_SendGoal_Request]) -> None: ...
    @property
    def response(self) -> list[object_recognition_msgs.action.ObjectRecognition_SendGoal_Response]: ...
    @response.setter
    def response(self, value: Collection[object_recognition_msgs.action.ObjectRecognition_SendGoal_Response]) -> None: ...

class ObjectRecognition_GetResult_Request(Message):
    """object_recognition_msgs/action/ObjectRecognition_GetResult_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID

class ObjectRecognition_GetResult_Response(Message):
    """object_recognition_msgs/action/ObjectRecognition_GetResult_Response"""
    def __init__(self, *, status: int = ..., result: object_recognition_msgs.action.ObjectRecognition_Result = ..., check_fields: bool = ...) -> None: ...
    status: int
    result: object_recognition_msgs.action.ObjectRecognition_Result

class ObjectRecognition_GetResult_Event(Message):
    """object_recognition_msgs/action/ObjectRecognition_GetResult_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[object_recognition_msgs.action.ObjectRecognition_GetResult_Request] = ..., response: Collection[object_recognition_msgs.action.ObjectRecognition_GetResult_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[object_recognition_msgs.action.ObjectRecognition_GetResult_Request]: ...
    @request.setter
    def request(self, value: Collection[object_recognition_msgs.action.ObjectRecognition_GetResult_Request]) -> None: ...
    @property
    def response(self) -> list[object_recognition_msgs.action.ObjectRecognition_GetResult_Response]: ...
    @response.setter
    def response(self, value: Collection[object_recognition_msgs.action.ObjectRecognition_GetResult_Response]) -> None: ...

class ObjectRecognition_SendGoal(Service):
    Request: TypeAlias = ObjectRecognition_SendGoal_Request
    Response: TypeAlias = ObjectRecognition_SendGoal_Response
    Event: TypeAlias = ObjectRecognition_SendGoal_Event

class ObjectRecognition_GetResult(Service):
    Request: TypeAlias = ObjectRecognition_GetResult_Request
    Response: TypeAlias = ObjectRecognition_GetResult_Response
    Event: TypeAlias = ObjectRecognition_GetResult_Event

class ObjectRecognition(Action):
    Goal: TypeAlias = ObjectRecognition_Goal
    Result: TypeAlias = ObjectRecognition_Result
    Feedback: TypeAlias = ObjectRecognition_Feedback
    class Impl:
        SendGoalService: TypeAlias = ObjectRecognition_SendGoal
        GetResultService: TypeAlias = ObjectRecognition_GetResult
        FeedbackMessage: TypeAlias = ObjectRecognition_FeedbackMessage
        CancelGoalService: TypeAlias = action_msgs.srv.CancelGoal
        GoalStatusMessage: TypeAlias = action_msgs.msg.GoalStatusArray
