# Written by python -m zbot.interfaces.stubs; do not edit.
from array import array
from collections.abc import Collection
from typing import Final, TypeAlias

import numpy
from numpy.typing import NDArray

import action_msgs.msg
import action_msgs.srv
import action_tutorials_interfaces.action
import builtin_interfaces.msg
import service_msgs.msg
import unique_identifier_msgs.msg
from zbot.interfaces import Action, Message, Service

class Fibonacci_Goal(Message):
    """action_tutorials_interfaces/action/Fibonacci_Goal

    # Computes the Fibonacci sequence 0, 1, 1, 2, 3, 5, ... step by step.

    # Goal: how far to compute.
    int32 order
    """
    def __init__(self, *, order: int = ..., check_fields: bool = ...) -> None: ...
    order: int

class Fibonacci_Result(Message):
    """action_tutorials_interfaces/action/Fibonacci_Result

    # Result: the finished sequence.
    int32[] sequence
    """
    def __init__(self, *, sequence: Collection[int] = ..., check_fields: bool = ...) -> None: ...
    @property
    def sequence(self) -> array[int]: ...
    @sequence.setter
    def sequence(self, value: Collection[int]) -> None: ...

class Fibonacci_Feedback(Message):
    """action_tutorials_interfaces/action/Fibonacci_Feedback

    # Feedback: the numbers found so far.
    int32[] partial_sequence
    """
    def __init__(self, *, partial_sequence: Collection[int] = ..., check_fields: bool = ...) -> None: ...
    @property
    def partial_sequence(self) -> array[int]: ...
    @partial_sequence.setter
    def partial_sequence(self, value: Collection[int]) -> None: ...

class Fibonacci_FeedbackMessage(Message):
    """action_tutorials_interfaces/action/Fibonacci_FeedbackMessage"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., feedback: action_tutorials_interfaces.action.Fibonacci_Feedback = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    feedback: action_tutorials_interfaces.action.Fibonacci_Feedback

class Fibonacci_SendGoal_Request(Message):
    """action_tutorials_interfaces/action/Fibonacci_SendGoal_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., goal: action_tutorials_interfaces.action.Fibonacci_Goal = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    goal: action_tutorials_interfaces.action.Fibonacci_Goal

class Fibonacci_SendGoal_Response(Message):
    """action_tutorials_interfaces/action/Fibonacci_SendGoal_Response"""
    def __init__(self, *, accepted: bool = ..., stamp: builtin_interfaces.msg.Time = ..., check_fields: bool = ...) -> None: ...
    accepted: bool
    stamp: builtin_interfaces.msg.Time

class Fibonacci_SendGoal_Event(Message):
    """action_tutorials_interfaces/action/Fibonacci_SendGoal_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[action_tutorials_interfaces.action.Fibonacci_SendGoal_Request] = ..., response: Collection[action_tutorials_interfaces.action.Fibonacci_SendGoal_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[action_tutorials_interfaces.action.Fibonacci_SendGoal_Request]: ...
    @request.setter
    def request(self, value: Collection[action_tutorials_interfaces.action.Fibonacci_SendGoal_Request]) -> None: ...
    @property
    def response(self) -> list[action_tutorials_interfaces.action.Fibonacci_SendGoal_Response]: ...
    @response.setter
    def response(self, value: Collection[action_tutorials_interfaces.action.Fibonacci_SendGoal_Response]) -> None: ...

class Fibonacci_GetResult_Request(Message):
    """action_tutorials_interfaces/action/Fibonacci_GetResult_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID

class Fibonacci_GetResult_Response(Message):
    """action_tutorials_interfaces/action/Fibonacci_GetResult_Response"""
    def __init__(self, *, status: int = ..., result: action_tutorials_interfaces.action.Fibonacci_Result = ..., check_fields: bool = ...) -> None: ...
    status: int
    result: action_tutorials_interfaces.action.Fibonacci_Result

class Fibonacci_GetResult_Event(Message):
    """action_tutorials_interfaces/action/Fibonacci_GetResult_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[action_tutorials_interfaces.action.Fibonacci_GetResult_Request] = ..., response: Collection[action_tutorials_interfaces.action.Fibonacci_GetResult_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[action_tutorials_interfaces.action.Fibonacci_GetResult_Request]: ...
    @request.setter
    def request(self, value: Collection[action_tutorials_interfaces.action.Fibonacci_GetResult_Request]) -> None: ...
    @property
    def response(self) -> list[action_tutorials_interfaces.action.Fibonacci_GetResult_Response]: ...
    @response.setter
    def response(self, value: Collection[action_tutorials_interfaces.action.Fibonacci_GetResult_Response]) -> None: ...

class Fibonacci_SendGoal(Service):
    Request: TypeAlias = Fibonacci_SendGoal_Request
    Response: TypeAlias = Fibonacci_SendGoal_Response
    Event: TypeAlias = Fibonacci_SendGoal_Event

class Fibonacci_GetResult(Service):
    Request: TypeAlias = Fibonacci_GetResult_Request
    Response: TypeAlias = Fibonacci_GetResult_Response
    Event: TypeAlias = Fibonacci_GetResult_Event

class Fibonacci(Action):
    Goal: TypeAlias = Fibonacci_Goal
    Result: TypeAlias = Fibonacci_Result
    Feedback: TypeAlias = Fibonacci_Feedback
    class Impl:
        SendGoalService: TypeAlias = Fibonacci_SendGoal
        GetResultService: TypeAlias = Fibonacci_GetResult
        FeedbackMessage: TypeAlias = Fibonacci_FeedbackMessage
        CancelGoalService: TypeAlias = action_msgs.srv.CancelGoal
        GoalStatusMessage: TypeAlias = action_msgs.msg.GoalStatusArray
