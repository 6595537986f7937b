# Written by python -m zbot.interfaces.stubs; do not edit.
from array import array
from collections.abc import Collection
from typing import Final, TypeAlias

import numpy
from numpy.typing import NDArray

import action_msgs.msg
import action_msgs.srv
import builtin_interfaces.msg
import service_msgs.msg
import teleop_tools_msgs.action
import unique_identifier_msgs.msg
from zbot.interfaces import Action, Message, Service

class Increment_Goal(Message):
    """teleop_tools_msgs/action/Increment_Goal

    float32[] increment_by
    """
    def __init__(self, *, increment_by: Collection[float] = ..., check_fields: bool = ...) -> None: ...
    @property
    def increment_by(self) -> array[float]: ...
    @increment_by.setter
    def increment_by(self, value: Collection[float]) -> None: ...

class Increment_Result(Message):
    """teleop_tools_msgs/action/Increment_Result"""
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class Increment_Feedback(Message):
    """teleop_tools_msgs/action/Increment_Feedback"""
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class Increment_FeedbackMessage(Message):
    """teleop_tools_msgs/action/Increment_FeedbackMessage"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., feedback: teleop_tools_msgs.action.Increment_Feedback = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    feedback: teleop_tools_msgs.action.Increment_Feedback

class Increment_SendGoal_Request(Message):
    """teleop_tools_msgs/action/Increment_SendGoal_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., goal: teleop_tools_msgs.action.Increment_Goal = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    goal: teleop_tools_msgs.action.Increment_Goal

class Increment_SendGoal_Response(Message):
    """teleop_tools_msgs/action/Increment_SendGoal_Response"""
    def __init__(self, *, accepted: bool = ..., stamp: builtin_interfaces.msg.Time = ..., check_fields: bool = ...) -> None: ...
    accepted: bool
    stamp: builtin_interfaces.msg.Time

class Increment_SendGoal_Event(Message):
    """teleop_tools_msgs/action/Increment_SendGoal_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[teleop_tools_msgs.action.Increment_SendGoal_Request] = ..., response: Collection[teleop_tools_msgs.action.Increment_SendGoal_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[teleop_tools_msgs.action.Increment_SendGoal_Request]: ...
    @request.setter
    def request(self, value: Collection[teleop_tools_msgs.action.Increment_SendGoal_Request]) -> None: ...
    @property
    def response(self) -> list[teleop_tools_msgs.action.Increment_SendGoal_Response]: ...
    @response.setter
    def response(self, value: Collection[teleop_tools_msgs.action.Increment_SendGoal_Response]) -> None: ...

class Increment_GetResult_Request(Message):
    """teleop_tools_msgs/action/Increment_GetResult_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID

class Increment_GetResult_Response(Message):
    """teleop_tools_msgs/action/Increment_GetResult_Response"""
    def __init__(self, *, status: int = ..., result: teleop_tools_msgs.action.Increment_Result = ..., check_fields: bool = ...) -> None: ...
    status: int
    result: teleop_tools_msgs.action.Increment_Result

class Increment_GetResult_Event(Message):
    """teleop_tools_msgs/action/Increment_GetResult_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[teleop_tools_msgs.action.Increment_GetResult_Request] = ..., response: Collection[teleop_tools_msgs.action.Increment_GetResult_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[teleop_tools_msgs.action.Increment_GetResult_Request]: ...
    @request.setter
    def request(self, value: Collection[teleop_tools_msgs.action.Increment_GetResult_Request]) -> None: ...
    @property
    def response(self) -> list[teleop_tools_msgs.action.Increment_GetResult_Response]: ...
    @response.setter
    def response(self, value: Collection[teleop_tools_msgs.action.Increment_GetResult_Response]) -> None: ...

class Increment_SendGoal(Service):
    Request: TypeAlias = Increment_SendGoal_Request
    Response: TypeAlias = Increment_SendGoal_Response
    Event: TypeAlias = Increment_SendGoal_Event

class Increment_GetResult(Service):
    Request: TypeAlias = Increment_GetResult_Request
    Response: TypeAlias = Increment_GetResult_Response
    Event: TypeAlias = Increment_GetResult_Event

class Increment(Action):
    Goal: TypeAlias = Increment_Goal
    Result: TypeAlias = Increment_Result
    Feedback: TypeAlias = Increment_Feedback
    class Impl:
        SendGoalService: TypeAlias = Increment_SendGoal
        GetResultService: TypeAlias = Increment_GetResult
        FeedbackMessage: TypeAlias = Increment_FeedbackMessage
        CancelGoalService: TypeAlias = action_msgs.srv.CancelGoal
        GoalStatusMessage: TypeAlias = action_msgs.msg.GoalStatusArray
