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
import simulation_interfaces.action
import simulation_interfaces.msg
import unique_identifier_msgs.msg
from zbot.interfaces import Action, Message, Service

class SimulateSteps_Goal(Message):
    """simulation_interfaces/action/SimulateSteps_Goal

    uint64 steps
    """
    def __init__(self, *, steps: int = ..., check_fields: bool = ...) -> None: ...
    steps: int

class SimulateSteps_Result(Message):
    """simulation_interfaces/action/SimulateSteps_Result

    Result result
    """
    def __init__(self, *, result: simulation_interfaces.msg.Result = ..., check_fields: bool = ...) -> None: ...
    result: simulation_interfaces.msg.Result

class SimulateSteps_Feedback(Message):
    """simulation_interfaces/action/SimulateSteps_Feedback

    uint64 completed_steps
    uint64 remaining_steps
    """
    def __init__(self, *, completed_steps: int = ..., remaining_steps: int = ..., check_fields: bool = ...) -> None: ...
    completed_steps: int
    remaining_steps: int

class SimulateSteps_FeedbackMessage(Message):
    """simulation_interfaces/action/SimulateSteps_FeedbackMessage"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., feedback: simulation_interfaces.action.SimulateSteps_Feedback = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    feedback: simulation_interfaces.action.SimulateSteps_Feedback

class SimulateSteps_SendGoal_Request(Message):
    """simulation_interfaces/action/SimulateSteps_SendGoal_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., goal: simulation_interfaces.action.SimulateSteps_Goal = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    goal: simulation_interfaces.action.SimulateSteps_Goal

class SimulateSteps_SendGoal_Response(Message):
    """simulation_interfaces/action/SimulateSteps_SendGoal_Response"""
    def __init__(self, *, accepted: bool = ..., stamp: builtin_interfaces.msg.Time = ..., check_fields: bool = ...) -> None: ...
    accepted: bool
    stamp: builtin_interfaces.msg.Time

class SimulateSteps_SendGoal_Event(Message):
    """simulation_interfaces/action/SimulateSteps_SendGoal_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[simulation_interfaces.action.SimulateSteps_SendGoal_Request] = ..., response: Collection[simulation_interfaces.action.SimulateSteps_SendGoal_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[simulation_interfaces.action.SimulateSteps_SendGoal_Request]: ...
    @request.setter
    def request(self, value: Collection[simulation_interfaces.action.SimulateSteps_SendGoal_Request]) -> None: ...
    @property
    def response(self) -> list[simulation_interfaces.action.SimulateSteps_SendGoal_Response]: ...
    @response.setter
    def response(self, value: Collection[simulation_interfaces.action.SimulateSteps_SendGoal_Response]) -> None: ...

class SimulateSteps_GetResult_Request(Message):
    """simulation_interfaces/action/SimulateSteps_GetResult_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID

class SimulateSteps_GetResult_Response(Message):
    """simulation_interfaces/action/SimulateSteps_GetResult_Response"""
    def __init__(self, *, status: int = ..., result: simulation_interfaces.action.SimulateSteps_Result = ..., check_fields: bool = ...) -> None: ...
    status: int
    result: simulation_interfaces.action.SimulateSteps_Result

class SimulateSteps_GetResult_Event(Message):
    """simulation_interfaces/action/SimulateSteps_GetResult_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[simulation_interfaces.action.SimulateSteps_GetResult_Request] = ..., response: Collection[simulation_interfaces.action.SimulateSteps_GetResult_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[simulation_interfaces.action.SimulateSteps_GetResult_Request]: ...
    @request.setter
    def request(self, value: Collection[simulation_interfaces.action.SimulateSteps_GetResult_Request]) -> None: ...
    @property
    def response(self) -> list[simulation_interfaces.action.SimulateSteps_GetResult_Response]: ...
    @response.setter
    def response(self, value: Collection[simulation_interfaces.action.SimulateSteps_GetResult_Response]) -> None: ...

class SimulateSteps_SendGoal(Service):
    Request: TypeAlias = SimulateSteps_SendGoal_Request
    Response: TypeAlias = SimulateSteps_SendGoal_Response
    Event: TypeAlias = SimulateSteps_SendGoal_Event

class SimulateSteps_GetResult(Service):
    Request: TypeAlias = SimulateSteps_GetResult_Request
    Response: TypeAlias = SimulateSteps_GetResult_Response
    Event: TypeAlias = SimulateSteps_GetResult_Event

class SimulateSteps(Action):
    Goal: TypeAlias = SimulateSteps_Goal
    Result: TypeAlias = SimulateSteps_Result
    Feedback: TypeAlias = SimulateSteps_Feedback
    class Impl:
        SendGoalService: TypeAlias = SimulateSteps_SendGoal
        GetResultService: TypeAlias = SimulateSteps_GetResult
        FeedbackMessage: TypeAlias = SimulateSteps_FeedbackMessage
        CancelGoalService: TypeAlias = action_msgs.srv.CancelGoal
        GoalStatusMessage: TypeAlias = action_msgs.msg.GoalStatusArray
