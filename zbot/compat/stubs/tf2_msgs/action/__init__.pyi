# Written by python -m zbot.interfaces.stubs; do not edit.
from array import array
from collections.abc import Collection
from typing import Final, TypeAlias

import numpy
from numpy.typing import NDArray

import action_msgs.msg
import action_msgs.srv
import builtin_interfaces.msg
import geometry_msgs.msg
import service_msgs.msg
import tf2_msgs.action
import tf2_msgs.msg
import unique_identifier_msgs.msg
from zbot.interfaces import Action, Message, Service

class LookupTransform_Goal(Message):
    """tf2_msgs/action/LookupTransform_Goal

    # Waits for the transform from one coordinate frame to another.

    # Simple question: express source_frame in target_frame, both at source_time.
    string target_frame
    string source_frame
    builtin_interfaces/Time source_time
    builtin_interfaces/Duration timeout # how long to wait

    # Advanced question: the target at another time, with fixed_frame standing still in between.
    builtin_interfaces/Time target_time
    string fixed_frame

    # True to ask the advanced question.
    bool advanced
    """
    def __init__(self, *, target_frame: str = ..., source_frame: str = ..., source_time: builtin_interfaces.msg.Time = ..., timeout: builtin_interfaces.msg.Duration = ..., target_time: builtin_interfaces.msg.Time = ..., fixed_frame: str = ..., advanced: bool = ..., check_fields: bool = ...) -> None: ...
    target_frame: str
    source_frame: str
    source_time: builtin_interfaces.msg.Time
    timeout: builtin_interfaces.msg.Duration
    target_time: builtin_interfaces.msg.Time
    fixed_frame: str
    advanced: bool

class LookupTransform_Result(Message):
    """tf2_msgs/action/LookupTransform_Result

    geometry_msgs/TransformStamped transform
    tf2_msgs/TF2Error error
    """
    def __init__(self, *, transform: geometry_msgs.msg.TransformStamped = ..., error: tf2_msgs.msg.TF2Error = ..., check_fields: bool = ...) -> None: ...
    transform: geometry_msgs.msg.TransformStamped
    error: tf2_msgs.msg.TF2Error

class LookupTransform_Feedback(Message):
    """tf2_msgs/action/LookupTransform_Feedback"""
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class LookupTransform_FeedbackMessage(Message):
    """tf2_msgs/action/LookupTransform_FeedbackMessage"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., feedback: tf2_msgs.action.LookupTransform_Feedback = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    feedback: tf2_msgs.action.LookupTransform_Feedback

class LookupTransform_SendGoal_Request(Message):
    """tf2_msgs/action/LookupTransform_SendGoal_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., goal: tf2_msgs.action.LookupTransform_Goal = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    goal: tf2_msgs.action.LookupTransform_Goal

class LookupTransform_SendGoal_Response(Message):
    """tf2_msgs/action/LookupTransform_SendGoal_Response"""
    def __init__(self, *, accepted: bool = ..., stamp: builtin_interfaces.msg.Time = ..., check_fields: bool = ...) -> None: ...
    accepted: bool
    stamp: builtin_interfaces.msg.Time

class LookupTransform_SendGoal_Event(Message):
    """tf2_msgs/action/LookupTransform_SendGoal_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[tf2_msgs.action.LookupTransform_SendGoal_Request] = ..., response: Collection[tf2_msgs.action.LookupTransform_SendGoal_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[tf2_msgs.action.LookupTransform_SendGoal_Request]: ...
    @request.setter
    def request(self, value: Collection[tf2_msgs.action.LookupTransform_SendGoal_Request]) -> None: ...
    @property
    def response(self) -> list[tf2_msgs.action.LookupTransform_SendGoal_Response]: ...
    @response.setter
    def response(self, value: Collection[tf2_msgs.action.LookupTransform_SendGoal_Response]) -> None: ...

class LookupTransform_GetResult_Request(Message):
    """tf2_msgs/action/LookupTransform_GetResult_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID

class LookupTransform_GetResult_Response(Message):
    """tf2_msgs/action/LookupTransform_GetResult_Response"""
    def __init__(self, *, status: int = ..., result: tf2_msgs.action.LookupTransform_Result = ..., check_fields: bool = ...) -> None: ...
    status: int
    result: tf2_msgs.action.LookupTransform_Result

class LookupTransform_GetResult_Event(Message):
    """tf2_msgs/action/LookupTransform_GetResult_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[tf2_msgs.action.LookupTransform_GetResult_Request] = ..., response: Collection[tf2_msgs.action.LookupTransform_GetResult_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[tf2_msgs.action.LookupTransform_GetResult_Request]: ...
    @request.setter
    def request(self, value: Collection[tf2_msgs.action.LookupTransform_GetResult_Request]) -> None: ...
    @property
    def response(self) -> list[tf2_msgs.action.LookupTransform_GetResult_Response]: ...
    @response.setter
    def response(self, value: Collection[tf2_msgs.action.LookupTransform_GetResult_Response]) -> None: ...

class LookupTransform_SendGoal(Service):
    Request: TypeAlias = LookupTransform_SendGoal_Request
    Response: TypeAlias = LookupTransform_SendGoal_Response
    Event: TypeAlias = LookupTransform_SendGoal_Event

class LookupTransform_GetResult(Service):
    Request: TypeAlias = LookupTransform_GetResult_Request
    Response: TypeAlias = LookupTransform_GetResult_Response
    Event: TypeAlias = LookupTransform_GetResult_Event

class LookupTransform(Action):
    Goal: TypeAlias = LookupTransform_Goal
    Result: TypeAlias = LookupTransform_Result
    Feedback: TypeAlias = LookupTransform_Feedback
    class Impl:
        SendGoalService: TypeAlias = LookupTransform_SendGoal
        GetResultService: TypeAlias = LookupTransform_GetResult
        FeedbackMessage: TypeAlias = LookupTransform_FeedbackMessage
        CancelGoalService: TypeAlias = action_msgs.srv.CancelGoal
        GoalStatusMessage: TypeAlias = action_msgs.msg.GoalStatusArray
