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
import turtlebot3_msgs.action
import unique_identifier_msgs.msg
from zbot.interfaces import Action, Message, Service

class Patrol_Goal(Message):
    """turtlebot3_msgs/action/Patrol_Goal

    # Drives along a shape again and again.

    geometry_msgs/Vector3 goal
    """
    def __init__(self, *, goal: geometry_msgs.msg.Vector3 = ..., check_fields: bool = ...) -> None: ...
    goal: geometry_msgs.msg.Vector3

class Patrol_Result(Message):
    """turtlebot3_msgs/action/Patrol_Result

    string result
    """
    def __init__(self, *, result: str = ..., check_fields: bool = ...) -> None: ...
    result: str

class Patrol_Feedback(Message):
    """turtlebot3_msgs/action/Patrol_Feedback

    string state
    """
    def __init__(self, *, state: str = ..., check_fields: bool = ...) -> None: ...
    state: str

class Patrol_FeedbackMessage(Message):
    """turtlebot3_msgs/action/Patrol_FeedbackMessage"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., feedback: turtlebot3_msgs.action.Patrol_Feedback = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    feedback: turtlebot3_msgs.action.Patrol_Feedback

class Patrol_SendGoal_Request(Message):
    """turtlebot3_msgs/action/Patrol_SendGoal_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., goal: turtlebot3_msgs.action.Patrol_Goal = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    goal: turtlebot3_msgs.action.Patrol_Goal

class Patrol_SendGoal_Response(Message):
    """turtlebot3_msgs/action/Patrol_SendGoal_Response"""
    def __init__(self, *, accepted: bool = ..., stamp: builtin_interfaces.msg.Time = ..., check_fields: bool = ...) -> None: ...
    accepted: bool
    stamp: builtin_interfaces.msg.Time

class Patrol_SendGoal_Event(Message):
    """turtlebot3_msgs/action/Patrol_SendGoal_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[turtlebot3_msgs.action.Patrol_SendGoal_Request] = ..., response: Collection[turtlebot3_msgs.action.Patrol_SendGoal_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[turtlebot3_msgs.action.Patrol_SendGoal_Request]: ...
    @request.setter
    def request(self, value: Collection[turtlebot3_msgs.action.Patrol_SendGoal_Request]) -> None: ...
    @property
    def response(self) -> list[turtlebot3_msgs.action.Patrol_SendGoal_Response]: ...
    @response.setter
    def response(self, value: Collection[turtlebot3_msgs.action.Patrol_SendGoal_Response]) -> None: ...

class Patrol_GetResult_Request(Message):
    """turtlebot3_msgs/action/Patrol_GetResult_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID

class Patrol_GetResult_Response(Message):
    """turtlebot3_msgs/action/Patrol_GetResult_Response"""
    def __init__(self, *, status: int = ..., result: turtlebot3_msgs.action.Patrol_Result = ..., check_fields: bool = ...) -> None: ...
    status: int
    result: turtlebot3_msgs.action.Patrol_Result

class Patrol_GetResult_Event(Message):
    """turtlebot3_msgs/action/Patrol_GetResult_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[turtlebot3_msgs.action.Patrol_GetResult_Request] = ..., response: Collection[turtlebot3_msgs.action.Patrol_GetResult_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[turtlebot3_msgs.action.Patrol_GetResult_Request]: ...
    @request.setter
    def request(self, value: Collection[turtlebot3_msgs.action.Patrol_GetResult_Request]) -> None: ...
    @property
    def response(self) -> list[turtlebot3_msgs.action.Patrol_GetResult_Response]: ...
    @response.setter
    def response(self, value: Collection[turtlebot3_msgs.action.Patrol_GetResult_Response]) -> None: ...

class Patrol_SendGoal(Service):
    Request: TypeAlias = Patrol_SendGoal_Request
    Response: TypeAlias = Patrol_SendGoal_Response
    Event: TypeAlias = Patrol_SendGoal_Event

class Patrol_GetResult(Service):
    Request: TypeAlias = Patrol_GetResult_Request
    Response: TypeAlias = Patrol_GetResult_Response
    Event: TypeAlias = Patrol_GetResult_Event

class Patrol(Action):
    Goal: TypeAlias = Patrol_Goal
    Result: TypeAlias = Patrol_Result
    Feedback: TypeAlias = Patrol_Feedback
    class Impl:
        SendGoalService: TypeAlias = Patrol_SendGoal
        GetResultService: TypeAlias = Patrol_GetResult
        FeedbackMessage: TypeAlias = Patrol_FeedbackMessage
        CancelGoalService: TypeAlias = action_msgs.srv.CancelGoal
        GoalStatusMessage: TypeAlias = action_msgs.msg.GoalStatusArray
