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
import turtlesim_msgs.action
import unique_identifier_msgs.msg
from zbot.interfaces import Action, Message, Service

class RotateAbsolute_Goal(Message):
    """turtlesim_msgs/action/RotateAbsolute_Goal

    # Turns a turtle to a heading.

    # Goal: the heading in rad, 0 is right, counterclockwise is positive.
    float32 theta
    """
    def __init__(self, *, theta: float = ..., check_fields: bool = ...) -> None: ...
    theta: float

class RotateAbsolute_Result(Message):
    """turtlesim_msgs/action/RotateAbsolute_Result

    # Result: rad from the final heading back to the first one.
    float32 delta
    """
    def __init__(self, *, delta: float = ..., check_fields: bool = ...) -> None: ...
    delta: float

class RotateAbsolute_Feedback(Message):
    """turtlesim_msgs/action/RotateAbsolute_Feedback

    # Feedback: rad still to turn.
    float32 remaining
    """
    def __init__(self, *, remaining: float = ..., check_fields: bool = ...) -> None: ...
    remaining: float

class RotateAbsolute_FeedbackMessage(Message):
    """turtlesim_msgs/action/RotateAbsolute_FeedbackMessage"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., feedback: turtlesim_msgs.action.RotateAbsolute_Feedback = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    feedback: turtlesim_msgs.action.RotateAbsolute_Feedback

class RotateAbsolute_SendGoal_Request(Message):
    """turtlesim_msgs/action/RotateAbsolute_SendGoal_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., goal: turtlesim_msgs.action.RotateAbsolute_Goal = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    goal: turtlesim_msgs.action.RotateAbsolute_Goal

class RotateAbsolute_SendGoal_Response(Message):
    """turtlesim_msgs/action/RotateAbsolute_SendGoal_Response"""
    def __init__(self, *, accepted: bool = ..., stamp: builtin_interfaces.msg.Time = ..., check_fields: bool = ...) -> None: ...
    accepted: bool
    stamp: builtin_interfaces.msg.Time

class RotateAbsolute_SendGoal_Event(Message):
    """turtlesim_msgs/action/RotateAbsolute_SendGoal_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[turtlesim_msgs.action.RotateAbsolute_SendGoal_Request] = ..., response: Collection[turtlesim_msgs.action.RotateAbsolute_SendGoal_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[turtlesim_msgs.action.RotateAbsolute_SendGoal_Request]: ...
    @request.setter
    def request(self, value: Collection[turtlesim_msgs.action.RotateAbsolute_SendGoal_Request]) -> None: ...
    @property
    def response(self) -> list[turtlesim_msgs.action.RotateAbsolute_SendGoal_Response]: ...
    @response.setter
    def response(self, value: Collection[turtlesim_msgs.action.RotateAbsolute_SendGoal_Response]) -> None: ...

class RotateAbsolute_GetResult_Request(Message):
    """turtlesim_msgs/action/RotateAbsolute_GetResult_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID

class RotateAbsolute_GetResult_Response(Message):
    """turtlesim_msgs/action/RotateAbsolute_GetResult_Response"""
    def __init__(self, *, status: int = ..., result: turtlesim_msgs.action.RotateAbsolute_Result = ..., check_fields: bool = ...) -> None: ...
    status: int
    result: turtlesim_msgs.action.RotateAbsolute_Result

class RotateAbsolute_GetResult_Event(Message):
    """turtlesim_msgs/action/RotateAbsolute_GetResult_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[turtlesim_msgs.action.RotateAbsolute_GetResult_Request] = ..., response: Collection[turtlesim_msgs.action.RotateAbsolute_GetResult_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[turtlesim_msgs.action.RotateAbsolute_GetResult_Request]: ...
    @request.setter
    def request(self, value: Collection[turtlesim_msgs.action.RotateAbsolute_GetResult_Request]) -> None: ...
    @property
    def response(self) -> list[turtlesim_msgs.action.RotateAbsolute_GetResult_Response]: ...
    @response.setter
    def response(self, value: Collection[turtlesim_msgs.action.RotateAbsolute_GetResult_Response]) -> None: ...

class RotateAbsolute_SendGoal(Service):
    Request: TypeAlias = RotateAbsolute_SendGoal_Request
    Response: TypeAlias = RotateAbsolute_SendGoal_Response
    Event: TypeAlias = RotateAbsolute_SendGoal_Event

class RotateAbsolute_GetResult(Service):
    Request: TypeAlias = RotateAbsolute_GetResult_Request
    Response: TypeAlias = RotateAbsolute_GetResult_Response
    Event: TypeAlias = RotateAbsolute_GetResult_Event

class RotateAbsolute(Action):
    Goal: TypeAlias = RotateAbsolute_Goal
    Result: TypeAlias = RotateAbsolute_Result
    Feedback: TypeAlias = RotateAbsolute_Feedback
    class Impl:
        SendGoalService: TypeAlias = RotateAbsolute_SendGoal
        GetResultService: TypeAlias = RotateAbsolute_GetResult
        FeedbackMessage: TypeAlias = RotateAbsolute_FeedbackMessage
        CancelGoalService: TypeAlias = action_msgs.srv.CancelGoal
        GoalStatusMessage: TypeAlias = action_msgs.msg.GoalStatusArray
