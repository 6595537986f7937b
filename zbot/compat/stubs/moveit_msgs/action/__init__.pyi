# Written by python -m zbot.interfaces.stubs; do not edit.
from array import array
from collections.abc import Collection
from typing import Final, TypeAlias

import numpy
from numpy.typing import NDArray

import action_msgs.msg
import action_msgs.srv
import builtin_interfaces.msg
import moveit_msgs.action
import moveit_msgs.msg
import service_msgs.msg
import unique_identifier_msgs.msg
from zbot.interfaces import Action, Message, Service

class ExecuteTrajectory_Goal(Message):
    """moveit_msgs/action/ExecuteTrajectory_Goal

    # Moves the robot along a trajectory.

    RobotTrajectory trajectory
    string[] controller_names  # empty: MoveIt chooses
    """
    def __init__(self, *, trajectory: moveit_msgs.msg.RobotTrajectory = ..., controller_names: Collection[str] = ..., check_fields: bool = ...) -> None: ...
    trajectory: moveit_msgs.msg.RobotTrajectory
    @property
    def controller_names(self) -> list[str]: ...
    @controller_names.setter
    def controller_names(self, value: Collection[str]) -> None: ...

class ExecuteTrajectory_Result(Message):
    """moveit_msgs/action/ExecuteTrajectory_Result

    MoveItErrorCodes error_code
    """
    def __init__(self, *, error_code: moveit_msgs.msg.MoveItErrorCodes = ..., check_fields: bool = ...) -> None: ...
    error_code: moveit_msgs.msg.MoveItErrorCodes

class ExecuteTrajectory_Feedback(Message):
    """moveit_msgs/action/ExecuteTrajectory_Feedback

    string state
    """
    def __init__(self, *, state: str = ..., check_fields: bool = ...) -> None: ...
    state: str

class ExecuteTrajectory_FeedbackMessage(Message):
    """moveit_msgs/action/ExecuteTrajectory_FeedbackMessage"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., feedback: moveit_msgs.action.ExecuteTrajectory_Feedback = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    feedback: moveit_msgs.action.ExecuteTrajectory_Feedback

class ExecuteTrajectory_SendGoal_Request(Message):
    """moveit_msgs/action/ExecuteTrajectory_SendGoal_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., goal: moveit_msgs.action.ExecuteTrajectory_Goal = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    goal: moveit_msgs.action.ExecuteTrajectory_Goal

class ExecuteTrajectory_SendGoal_Response(Message):
    """moveit_msgs/action/ExecuteTrajectory_SendGoal_Response"""
    def __init__(self, *, accepted: bool = ..., stamp: builtin_interfaces.msg.Time = ..., check_fields: bool = ...) -> None: ...
    accepted: bool
    stamp: builtin_interfaces.msg.Time

class ExecuteTrajectory_SendGoal_Event(Message):
    """moveit_msgs/action/ExecuteTrajectory_SendGoal_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[moveit_msgs.action.ExecuteTrajectory_SendGoal_Request] = ..., response: Collection[moveit_msgs.action.ExecuteTrajectory_SendGoal_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[moveit_msgs.action.ExecuteTrajectory_SendGoal_Request]: ...
    @request.setter
    def request(self, value: Collection[moveit_msgs.action.ExecuteTrajectory_SendGoal_Request]) -> None: ...
    @property
    def response(self) -> list[moveit_msgs.action.ExecuteTrajectory_SendGoal_Response]: ...
    @response.setter
    def response(self, value: Collection[moveit_msgs.action.ExecuteTrajectory_SendGoal_Response]) -> None: ...

class ExecuteTrajectory_GetResult_Request(Message):
    """moveit_msgs/action/ExecuteTrajectory_GetResult_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID

class ExecuteTrajectory_GetResult_Response(Message):
    """moveit_msgs/action/ExecuteTrajectory_GetResult_Response"""
    def __init__(self, *, status: int = ..., result: moveit_msgs.action.ExecuteTrajectory_Result = ..., check_fields: bool = ...) -> None: ...
    status: int
    result: moveit_msgs.action.ExecuteTrajectory_Result

class ExecuteTrajectory_GetResult_Event(Message):
    """moveit_msgs/action/ExecuteTrajectory_GetResult_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[moveit_msgs.action.ExecuteTrajectory_GetResult_Request] = ..., response: Collection[moveit_msgs.action.ExecuteTrajectory_GetResult_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[moveit_msgs.action.ExecuteTrajectory_GetResult_Request]: ...
    @request.setter
    def request(self, value: Collection[moveit_msgs.action.ExecuteTrajectory_GetResult_Request]) -> None: ...
    @property
    def response(self) -> list[moveit_msgs.action.ExecuteTrajectory_GetResult_Response]: ...
    @response.setter
    def response(self, value: Collection[moveit_msgs.action.ExecuteTrajectory_GetResult_Response]) -> None: ...

class ExecuteTrajectory_SendGoal(Service):
    Request: TypeAlias = ExecuteTrajectory_SendGoal_Request
    Response: TypeAlias = ExecuteTrajectory_SendGoal_Response
    Event: TypeAlias = ExecuteTrajectory_SendGoal_Event

class ExecuteTrajectory_GetResult(Service):
    Request: TypeAlias = ExecuteTrajectory_GetResult_Request
    Response: TypeAlias = ExecuteTrajectory_GetResult_Response
    Event: TypeAlias = ExecuteTrajectory_GetResult_Event

class ExecuteTrajectory(Action):
    Goal: TypeAlias = ExecuteTrajectory_Goal
    Result: TypeAlias = ExecuteTrajectory_Result
    Feedback: TypeAlias = ExecuteTrajectory_Feedback
    class Impl:
        SendGoalService: TypeAlias = ExecuteTrajectory_SendGoal
        GetResultService: TypeAlias = ExecuteTrajectory_GetResult
        FeedbackMessage: TypeAlias = ExecuteTrajectory_FeedbackMessage
        CancelGoalService: TypeAlias = action_msgs.srv.CancelGoal
        GoalStatusMessage: TypeAlias = action_msgs.msg.GoalStatusArray

class GlobalPlanner_Goal(Message):
    """moveit_msgs/action/GlobalPlanner_Goal

    # Plans the whole motion, for hybrid planning.

    string planning_group
    moveit_msgs/MotionSequenceRequest motion_sequence
    """
    def __init__(self, *, planning_group: str = ..., motion_sequence: moveit_msgs.msg.MotionSequenceRequest = ..., check_fields: bool = ...) -> None: ...
    planning_group: str
    motion_sequence: moveit_msgs.msg.MotionSequenceRequest

class GlobalPlanner_Result(Message):
    """moveit_msgs/action/GlobalPlanner_Result

    moveit_msgs/MotionPlanResponse response
    """
    def __init__(self, *, response: moveit_msgs.msg.MotionPlanResponse = ..., check_fields: bool = ...) -> None: ...
    response: moveit_msgs.msg.MotionPlanResponse

class GlobalPlanner_Feedback(Message):
    """moveit_msgs/action/GlobalPlanner_Feedback

    string feedback
    """
    def __init__(self, *, feedback: str = ..., check_fields: bool = ...) -> None: ...
    feedback: str

class GlobalPlanner_FeedbackMessage(Message):
    """moveit_msgs/action/GlobalPlanner_FeedbackMessage"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., feedback: moveit_msgs.action.GlobalPlanner_Feedback = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    feedback: moveit_msgs.action.GlobalPlanner_Feedback

class GlobalPlanner_SendGoal_Request(Message):
    """moveit_msgs/action/GlobalPlanner_SendGoal_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., goal: moveit_msgs.action.GlobalPlanner_Goal = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    goal: moveit_msgs.action.GlobalPlanner_Goal

class GlobalPlanner_SendGoal_Response(Message):
    """moveit_msgs/action/GlobalPlanner_SendGoal_Response"""
    def __init__(self, *, accepted: bool = ..., stamp: builtin_interfaces.msg.Time = ..., check_fields: bool = ...) -> None: ...
    accepted: bool
    stamp: builtin_interfaces.msg.Time

class GlobalPlanner_SendGoal_Event(Message):
    """moveit_msgs/action/GlobalPlanner_SendGoal_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[moveit_msgs.action.GlobalPlanner_SendGoal_Request] = ..., response: Collection[moveit_msgs.action.GlobalPlanner_SendGoal_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[moveit_msgs.action.GlobalPlanner_SendGoal_Request]: ...
    @request.setter
    def request(self, value: Collection[moveit_msgs.action.GlobalPlanner_SendGoal_Request]) -> None: ...
    @property
    def response(self) -> list[moveit_msgs.action.GlobalPlanner_SendGoal_Response]: ...
    @response.setter
    def response(self, value: Collection[moveit_msgs.action.GlobalPlanner_SendGoal_Response]) -> None: ...

class GlobalPlanner_GetResult_Request(Message):
    """moveit_msgs/action/GlobalPlanner_GetResult_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID

class GlobalPlanner_GetResult_Response(Message):
    """moveit_msgs/action/GlobalPlanner_GetResult_Response"""
    def __init__(self, *, status: int = ..., result: moveit_msgs.action.GlobalPlanner_Result = ..., check_fields: bool = ...) -> None: ...
    status: int
    result: moveit_msgs.action.GlobalPlanner_Result

class GlobalPlanner_GetResult_Event(Message):
    """moveit_msgs/action/GlobalPlanner_GetResult_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[moveit_msgs.action.GlobalPlanner_GetResult_Request] = ..., response: Collection[moveit_msgs.action.GlobalPlanner_GetResult_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[moveit_msgs.action.GlobalPlanner_GetResult_Request]: ...
    @request.setter
    def request(self, value: Collection[moveit_msgs.action.GlobalPlanner_GetResult_Request]) -> None: ...
    @property
    def response(self) -> list[moveit_msgs.action.GlobalPlanner_GetResult_Response]: ...
    @response.setter
    def response(self, value: Collection[moveit_msgs.action.GlobalPlanner_GetResult_Response]) -> None: ...

class GlobalPlanner_SendGoal(Service):
    Request: TypeAlias = GlobalPlanner_SendGoal_Request
    Response: TypeAlias = GlobalPlanner_SendGoal_Response
    Event: TypeAlias = GlobalPlanner_SendGoal_Event

class GlobalPlanner_GetResult(Service):
    Request: TypeAlias = GlobalPlanner_GetResult_Request
    Response: TypeAlias = GlobalPlanner_GetResult_Response
    Event: TypeAlias = GlobalPlanner_GetResult_Event

class GlobalPlanner(Action):
    Goal: TypeAlias = GlobalPlanner_Goal
    Result: TypeAlias = GlobalPlanner_Result
    Feedback: TypeAlias = GlobalPlanner_Feedback
    class Impl:
        SendGoalService: TypeAlias = GlobalPlanner_SendGoal
        GetResultService: TypeAlias = GlobalPlanner_GetResult
        FeedbackMessage: TypeAlias = GlobalPlanner_FeedbackMessage
        CancelGoalService: TypeAlias = action_msgs.srv.CancelGoal
        GoalStatusMessage: TypeAlias = action_msgs.msg.GoalStatusArray

class HybridPlanner_Goal(Message):
    """moveit_msgs/action/HybridPlanner_Goal

    # Plans a motion and moves, and reacts to changes on the way.

    string planning_group
    moveit_msgs/MotionSequenceRequest motion_sequence
    """
    def __init__(self, *, planning_group: str = ..., motion_sequence: moveit_msgs.msg.MotionSequenceRequest = ..., check_fields: bool = ...) -> None: ...
    planning_group: str
    motion_sequence: moveit_msgs.msg.MotionSequenceRequest

class HybridPlanner_Result(Message):
    """moveit_msgs/action/HybridPlanner_Result

    moveit_msgs/MoveItErrorCodes error_code
    string error_message
    """
    def __init__(self, *, error_code: moveit_msgs.msg.MoveItErrorCodes = ..., error_message: str = ..., check_fields: bool = ...) -> None: ...
    error_code: moveit_msgs.msg.MoveItErrorCodes
    error_message: str

class HybridPlanner_Feedback(Message):
    """moveit_msgs/action/HybridPlanner_Feedback

    string feedback
    """
    def __init__(self, *, feedback: str = ..., check_fields: bool = ...) -> None: ...
    feedback: str

class HybridPlanner_FeedbackMessage(Message):
    """moveit_msgs/action/HybridPlanner_FeedbackMessage"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., feedback: moveit_msgs.action.HybridPlanner_Feedback = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    feedback: moveit_msgs.action.HybridPlanner_Feedback

class HybridPlanner_SendGoal_Request(Message):
    """moveit_msgs/action/HybridPlanner_SendGoal_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., goal: moveit_msgs.action.HybridPlanner_Goal = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    goal: moveit_msgs.action.HybridPlanner_Goal

class HybridPlanner_SendGoal_Response(Message):
    """moveit_msgs/action/HybridPlanner_SendGoal_Response"""
    def __init__(self, *, accepted: bool = ..., stamp: builtin_interfaces.msg.Time = ..., check_fields: bool = ...) -> None: ...
    accepted: bool
    stamp: builtin_interfaces.msg.Time

class HybridPlanner_SendGoal_Event(Message):
    """moveit_msgs/action/HybridPlanner_SendGoal_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[moveit_msgs.action.HybridPlanner_SendGoal_Request] = ..., response: Collection[moveit_msgs.action.HybridPlanner_SendGoal_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[moveit_msgs.action.HybridPlanner_SendGoal_Request]: ...
    @request.setter
    def request(self, value: Collection[moveit_msgs.action.HybridPlanner_SendGoal_Request]) -> None: ...
    @property
    def response(self) -> list[moveit_msgs.action.HybridPlanner_SendGoal_Response]: ...
    @response.setter
    def response(self, value: Collection[moveit_msgs.action.HybridPlanner_SendGoal_Response]) -> None: ...

class HybridPlanner_GetResult_Request(Message):
    """moveit_msgs/action/HybridPlanner_GetResult_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID

class HybridPlanner_GetResult_Response(Message):
    """moveit_msgs/action/HybridPlanner_GetResult_Response"""
    def __init__(self, *, status: int = ..., result: moveit_msgs.action.HybridPlanner_Result = ..., check_fields: bool = ...) -> None: ...
    status: int
    result: moveit_msgs.action.HybridPlanner_Result

class HybridPlanner_GetResult_Event(Message):
    """moveit_msgs/action/HybridPlanner_GetResult_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[moveit_msgs.action.HybridPlanner_GetResult_Request] = ..., response: Collection[moveit_msgs.action.HybridPlanner_GetResult_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[moveit_msgs.action.HybridPlanner_GetResult_Request]: ...
    @request.setter
    def request(self, value: Collection[moveit_msgs.action.HybridPlanner_GetResult_Request]) -> None: ...
    @property
    def response(self) -> list[moveit_msgs.action.HybridPlanner_GetResult_Response]: ...
    @response.setter
    def response(self, value: Collection[moveit_msgs.action.HybridPlanner_GetResult_Response]) -> None: ...

class HybridPlanner_SendGoal(Service):
    Request: TypeAlias = HybridPlanner_SendGoal_Request
    Response: TypeAlias = HybridPlanner_SendGoal_Response
    Event: TypeAlias = HybridPlanner_SendGoal_Event

class HybridPlanner_GetResult(Service):
    Request: TypeAlias = HybridPlanner_GetResult_Request
    Response: TypeAlias = HybridPlanner_GetResult_Response
    Event: TypeAlias = HybridPlanner_GetResult_Event

class HybridPlanner(Action):
    Goal: TypeAlias = HybridPlanner_Goal
    Result: TypeAlias = HybridPlanner_Result
    Feedback: TypeAlias = HybridPlanner_Feedback
    class Impl:
        SendGoalService: TypeAlias = HybridPlanner_SendGoal
        GetResultService: TypeAlias = HybridPlanner_GetResult
        FeedbackMessage: TypeAlias = HybridPlanner_FeedbackMessage
        CancelGoalService: TypeAlias = action_msgs.srv.CancelGoal
        GoalStatusMessage: TypeAlias = action_msgs.msg.GoalStatusArray

class LocalPlanner_Goal(Message):
    """moveit_msgs/action/LocalPlanner_Goal

    # Follows the planned motion and reacts to changes.

    Constraints[] local_constraints
    """
    def __init__(self, *, local_constraints: Collection[moveit_msgs.msg.Constraints] = ..., check_fields: bool = ...) -> None: ...
    @property
    def local_constraints(self) -> list[moveit_msgs.msg.Constraints]: ...
    @local_constraints.setter
    def local_constraints(self, value: Collection[moveit_msgs.msg.Constraints]) -> None: ...

class LocalPlanner_Result(Message):
    """moveit_msgs/action/LocalPlanner_Result

    moveit_msgs/MoveItErrorCodes error_code
    string error_message
    """
    def __init__(self, *, error_code: moveit_msgs.msg.MoveItErrorCodes = ..., error_message: str = ..., check_fields: bool = ...) -> None: ...
    error_code: moveit_msgs.msg.MoveItErrorCodes
    error_message: str

class LocalPlanner_Feedback(Message):
    """moveit_msgs/action/LocalPlanner_Feedback

    string feedback
    """
    def __init__(self, *, feedback: str = ..., check_fields: bool = ...) -> None: ...
    feedback: str

class LocalPlanner_FeedbackMessage(Message):
    """moveit_msgs/action/LocalPlanner_FeedbackMessage"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., feedback: moveit_msgs.action.LocalPlanner_Feedback = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    feedback: moveit_msgs.action.LocalPlanner_Feedback

class LocalPlanner_SendGoal_Request(Message):
    """moveit_msgs/action/LocalPlanner_SendGoal_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., goal: moveit_msgs.action.LocalPlanner_Goal = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    goal: moveit_msgs.action.LocalPlanner_Goal

class LocalPlanner_SendGoal_Response(Message):
    """moveit_msgs/action/LocalPlanner_SendGoal_Response"""
    def __init__(self, *, accepted: bool = ..., stamp: builtin_interfaces.msg.Time = ..., check_fields: bool = ...) -> None: ...
    accepted: bool
    stamp: builtin_interfaces.msg.Time

class LocalPlanner_SendGoal_Event(Message):
    """moveit_msgs/action/LocalPlanner_SendGoal_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[moveit_msgs.action.LocalPlanner_SendGoal_Request] = ..., response: Collection[moveit_msgs.action.LocalPlanner_SendGoal_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[moveit_msgs.action.LocalPlanner_SendGoal_Request]: ...
    @request.setter
    def request(self, value: Collection[moveit_msgs.action.LocalPlanner_SendGoal_Request]) -> None: ...
    @property
    def response(self) -> list[moveit_msgs.action.LocalPlanner_SendGoal_Response]: ...
    @response.setter
    def response(self, value: Collection[moveit_msgs.action.LocalPlanner_SendGoal_Response]) -> None: ...

class LocalPlanner_GetResult_Request(Message):
    """moveit_msgs/action/LocalPlanner_GetResult_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID

class LocalPlanner_GetResult_Response(Message):
    """moveit_msgs/action/LocalPlanner_GetResult_Response"""
    def __init__(self, *, status: int = ..., result: moveit_msgs.action.LocalPlanner_Result = ..., check_fields: bool = ...) -> None: ...
    status: int
    result: moveit_msgs.action.LocalPlanner_Result

class LocalPlanner_GetResult_Event(Message):
    """moveit_msgs/action/LocalPlanner_GetResult_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[moveit_msgs.action.LocalPlanner_GetResult_Request] = ..., response: Collection[moveit_msgs.action.LocalPlanner_GetResult_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[moveit_msgs.action.LocalPlanner_GetResult_Request]: ...
    @request.setter
    def request(self, value: Collection[moveit_msgs.action.LocalPlanner_GetResult_Request]) -> None: ...
    @property
    def response(self) -> list[moveit_msgs.action.LocalPlanner_GetResult_Response]: ...
    @response.setter
    def response(self, value: Collection[moveit_msgs.action.LocalPlanner_GetResult_Response]) -> None: ...

class LocalPlanner_SendGoal(Service):
    Request: TypeAlias = LocalPlanner_SendGoal_Request
    Response: TypeAlias = LocalPlanner_SendGoal_Response
    Event: TypeAlias = LocalPlanner_SendGoal_Event

class LocalPlanner_GetResult(Service):
    Request: TypeAlias = LocalPlanner_GetResult_Request
    Response: TypeAlias = LocalPlanner_GetResult_Response
    Event: TypeAlias = LocalPlanner_GetResult_Event

class LocalPlanner(Action):
    Goal: TypeAlias = LocalPlanner_Goal
    Result: TypeAlias = LocalPlanner_Result
    Feedback: TypeAlias = LocalPlanner_Feedback
    class Impl:
        SendGoalService: TypeAlias = LocalPlanner_SendGoal
        GetResultService: TypeAlias = LocalPlanner_GetResult
        FeedbackMessage: TypeAlias = LocalPlanner_FeedbackMessage
        CancelGoalService: TypeAlias = action_msgs.srv.CancelGoal
        GoalStatusMessage: TypeAlias = action_msgs.msg.GoalStatusArray

class MoveGroup_Goal(Message):
    """moveit_msgs/action/MoveGroup_Goal

    # Plans a motion of a group of joints and moves.

    MotionPlanRequest request
    PlanningOptions planning_options
    """
    def __init__(self, *, request: moveit_msgs.msg.MotionPlanRequest = ..., planning_options: moveit_msgs.msg.PlanningOptions = ..., check_fields: bool = ...) -> None: ...
    request: moveit_msgs.msg.MotionPlanRequest
    planning_options: moveit_msgs.msg.PlanningOptions

class MoveGroup_Result(Message):
    """moveit_msgs/action/MoveGroup_Result

    MoveItErrorCodes error_code
    moveit_msgs/RobotState trajectory_start
    moveit_msgs/RobotTrajectory planned_trajectory
    moveit_msgs/RobotTrajectory executed_trajectory
    float64 planning_time  # s
    """
    def __init__(self, *, error_code: moveit_msgs.msg.MoveItErrorCodes = ..., trajectory_start: moveit_msgs.msg.RobotState = ..., planned_trajectory: moveit_msgs.msg.RobotTrajectory = ..., executed_trajectory: moveit_msgs.msg.RobotTrajectory = ..., planning_time: float = ..., check_fields: bool = ...) -> None: ...
    error_code: moveit_msgs.msg.MoveItErrorCodes
    trajectory_start: moveit_msgs.msg.RobotState
    planned_trajectory: moveit_msgs.msg.RobotTrajectory
    executed_trajectory: moveit_msgs.msg.RobotTrajectory
    planning_time: float

class MoveGroup_Feedback(Message):
    """moveit_msgs/action/MoveGroup_Feedback

    string state
    """
    def __init__(self, *, state: str = ..., check_fields: bool = ...) -> None: ...
    state: str

class MoveGroup_FeedbackMessage(Message):
    """moveit_msgs/action/MoveGroup_FeedbackMessage"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., feedback: moveit_msgs.action.MoveGroup_Feedback = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    feedback: moveit_msgs.action.MoveGroup_Feedback

class MoveGroup_SendGoal_Request(Message):
    """moveit_msgs/action/MoveGroup_SendGoal_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., goal: moveit_msgs.action.MoveGroup_Goal = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    goal: moveit_msgs.action.MoveGroup_Goal

class MoveGroup_SendGoal_Response(Message):
    """moveit_msgs/action/MoveGroup_SendGoal_Response"""
    def __init__(self, *, accepted: bool = ..., stamp: builtin_interfaces.msg.Time = ..., check_fields: bool = ...) -> None: ...
    accepted: bool
    stamp: builtin_interfaces.msg.Time

class MoveGroup_SendGoal_Event(Message):
    """moveit_msgs/action/MoveGroup_SendGoal_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[moveit_msgs.action.MoveGroup_SendGoal_Request] = ..., response: Collection[moveit_msgs.action.MoveGroup_SendGoal_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[moveit_msgs.action.MoveGroup_SendGoal_Request]: ...
    @request.setter
    def request(self, value: Collection[moveit_msgs.action.MoveGroup_SendGoal_Request]) -> None: ...
    @property
    def response(self) -> list[moveit_msgs.action.MoveGroup_SendGoal_Response]: ...
    @response.setter
    def response(self, value: Collection[moveit_msgs.action.MoveGroup_SendGoal_Response]) -> None: ...

class MoveGroup_GetResult_Request(Message):
    """moveit_msgs/action/MoveGroup_GetResult_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID

class MoveGroup_GetResult_Response(Message):
    """moveit_msgs/action/MoveGroup_GetResult_Response"""
    def __init__(self, *, status: int = ..., result: moveit_msgs.action.MoveGroup_Result = ..., check_fields: bool = ...) -> None: ...
    status: int
    result: moveit_msgs.action.MoveGroup_Result

class MoveGroup_GetResult_Event(Message):
    """moveit_msgs/action/MoveGroup_GetResult_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[moveit_msgs.action.MoveGroup_GetResult_Request] = ..., response: Collection[moveit_msgs.action.MoveGroup_GetResult_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[moveit_msgs.action.MoveGroup_GetResult_Request]: ...
    @request.setter
    def request(self, value: Collection[moveit_msgs.action.MoveGroup_GetResult_Request]) -> None: ...
    @property
    def response(self) -> list[moveit_msgs.action.MoveGroup_GetResult_Response]: ...
    @response.setter
    def response(self, value: Collection[moveit_msgs.action.MoveGroup_GetResult_Response]) -> None: ...

class MoveGroup_SendGoal(Service):
    Request: TypeAlias = MoveGroup_SendGoal_Request
    Response: TypeAlias = MoveGroup_SendGoal_Response
    Event: TypeAlias = MoveGroup_SendGoal_Event

class MoveGroup_GetResult(Service):
    Request: TypeAlias = MoveGroup_GetResult_Request
    Response: TypeAlias = MoveGroup_GetResult_Response
    Event: TypeAlias = MoveGroup_GetResult_Event

class MoveGroup(Action):
    Goal: TypeAlias = MoveGroup_Goal
    Result: TypeAlias = MoveGroup_Result
    Feedback: TypeAlias = MoveGroup_Feedback
    class Impl:
        SendGoalService: TypeAlias = MoveGroup_SendGoal
        GetResultService: TypeAlias = MoveGroup_GetResult
        FeedbackMessage: TypeAlias = MoveGroup_FeedbackMessage
        CancelGoalService: TypeAlias = action_msgs.srv.CancelGoal
        GoalStatusMessage: TypeAlias = action_msgs.msg.GoalStatusArray

class MoveGroupSequence_Goal(Message):
    """moveit_msgs/action/MoveGroupSequence_Goal

    # Plans several motions and moves.

    MotionSequenceRequest request
    PlanningOptions planning_options
    """
    def __init__(self, *, request: moveit_msgs.msg.MotionSequenceRequest = ..., planning_options: moveit_msgs.msg.PlanningOptions = ..., check_fields: bool = ...) -> None: ...
    request: moveit_msgs.msg.MotionSequenceRequest
    planning_options: moveit_msgs.msg.PlanningOptions

class MoveGroupSequence_Result(Message):
    """moveit_msgs/action/MoveGroupSequence_Result

    MotionSequenceResponse response
    """
    def __init__(self, *, response: moveit_msgs.msg.MotionSequenceResponse = ..., check_fields: bool = ...) -> None: ...
    response: moveit_msgs.msg.MotionSequenceResponse

class MoveGroupSequence_Feedback(Message):
    """moveit_msgs/action/MoveGroupSequence_Feedback

    string state
    """
    def __init__(self, *, state: str = ..., check_fields: bool = ...) -> None: ...
    state: str

class MoveGroupSequence_FeedbackMessage(Message):
    """moveit_msgs/action/MoveGroupSequence_FeedbackMessage"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., feedback: moveit_msgs.action.MoveGroupSequence_Feedback = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    feedback: moveit_msgs.action.MoveGroupSequence_Feedback

class MoveGroupSequence_SendGoal_Request(Message):
    """moveit_msgs/action/MoveGroupSequence_SendGoal_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., goal: moveit_msgs.action.MoveGroupSequence_Goal = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    goal: moveit_msgs.action.MoveGroupSequence_Goal

class MoveGroupSequence_SendGoal_Response(Message):
    """moveit_msgs/action/MoveGroupSequence_SendGoal_Response"""
    def __init__(self, *, accepted: bool = ..., stamp: builtin_interfaces.msg.Time = ..., check_fields: bool = ...) -> None: ...
    accepted: bool
    stamp: builtin_interfaces.msg.Time

class MoveGroupSequence_SendGoal_Event(Message):
    """moveit_msgs/action/MoveGroupSequence_SendGoal_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[moveit_msgs.action.MoveGroupSequence_SendGoal_Request] = ..., response: Collection[moveit_msgs.action.MoveGroupSequence_SendGoal_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[moveit_msgs.action.MoveGroupSequence_SendGoal_Request]: ...
    @request.setter
    def request(self, value: Collection[moveit_msgs.action.MoveGroupSequence_SendGoal_Request]) -> None: ...
    @property
    def response(self) -> list[moveit_msgs.action.MoveGroupSequence_SendGoal_Response]: ...
    @response.setter
    def response(self, value: Collection[moveit_msgs.action.MoveGroupSequence_SendGoal_Response]) -> None: ...

class MoveGroupSequence_GetResult_Request(Message):
    """moveit_msgs/action/MoveGroupSequence_GetResult_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID

class MoveGroupSequence_GetResult_Response(Message):
    """moveit_msgs/action/MoveGroupSequence_GetResult_Response"""
    def __init__(self, *, status: int = ..., result: moveit_msgs.action.MoveGroupSequence_Result = ..., check_fields: bool = ...) -> None: ...
    status: int
    result: moveit_msgs.action.MoveGroupSequence_Result

class MoveGroupSequence_GetResult_Event(Message):
    """moveit_msgs/action/MoveGroupSequence_GetResult_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[moveit_msgs.action.MoveGroupSequence_GetResult_Request] = ..., response: Collection[moveit_msgs.action.MoveGroupSequence_GetResult_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[moveit_msgs.action.MoveGroupSequence_GetResult_Request]: ...
    @request.setter
    def request(self, value: Collection[moveit_msgs.action.MoveGroupSequence_GetResult_Request]) -> None: ...
    @property
    def response(self) -> list[moveit_msgs.action.MoveGroupSequence_GetResult_Response]: ...
    @response.setter
    def response(self, value: Collection[moveit_msgs.action.MoveGroupSequence_GetResult_Response]) -> None: ...

class MoveGroupSequence_SendGoal(Service):
    Request: TypeAlias = MoveGroupSequence_SendGoal_Request
    Response: TypeAlias = MoveGroupSequence_SendGoal_Response
    Event: TypeAlias = MoveGroupSequence_SendGoal_Event

class MoveGroupSequence_GetResult(Service):
    Request: TypeAlias = MoveGroupSequence_GetResult_Request
    Response: TypeAlias = MoveGroupSequence_GetResult_Response
    Event: TypeAlias = MoveGroupSequence_GetResult_Event

class MoveGroupSequence(Action):
    Goal: TypeAlias = MoveGroupSequence_Goal
    Result: TypeAlias = MoveGroupSequence_Result
    Feedback: TypeAlias = MoveGroupSequence_Feedback
    class Impl:
        SendGoalService: TypeAlias = MoveGroupSequence_SendGoal
        GetResultService: TypeAlias = MoveGroupSequence_GetResult
        FeedbackMessage: TypeAlias = MoveGroupSequence_FeedbackMessage
        CancelGoalService: TypeAlias = action_msgs.srv.CancelGoal
        GoalStatusMessage: TypeAlias = action_msgs.msg.GoalStatusArray

class Pickup_Goal(Message):
    """moveit_msgs/action/Pickup_Goal

    # Picks up an object.

    string target_name
    string group_name
    string end_effector
    Grasp[] possible_grasps
    string support_surface_name
    bool allow_gripper_support_collision
    string[] attached_object_touch_links  # links that the object may touch afterwards
    bool minimize_object_distance
    Constraints path_constraints
    string planner_id
    string[] allowed_touch_objects
    float64 allowed_planning_time  # s
    PlanningOptions planning_options
    """
    def __init__(self, *, target_name: str = ..., group_name: str = ..., end_effector: str = ..., possible_grasps: Collection[moveit_msgs.msg.Grasp] = ..., support_surface_name: str = ..., allow_gripper_support_collision: bool = ..., attached_object_touch_links: Collection[str] = ..., minimize_object_distance: bool = ..., path_constraints: moveit_msgs.msg.Constraints = ..., planner_id: str = ..., allowed_touch_objects: Collection[str] = ..., allowed_planning_time: float = ..., planning_options: moveit_msgs.msg.PlanningOptions = ..., check_fields: bool = ...) -> None: ...
    target_name: str
    group_name: str
    end_effector: str
    @property
    def possible_grasps(self) -> list[moveit_msgs.msg.Grasp]: ...
    @possible_grasps.setter
    def possible_grasps(self, value: Collection[moveit_msgs.msg.Grasp]) -> None: ...
    support_surface_name: str
    allow_gripper_support_collision: bool
    @property
    def attached_object_touch_links(self) -> list[str]: ...
    @attached_object_touch_links.setter
    def attached_object_touch_links(self, value: Collection[str]) -> None: ...
    minimize_object_distance: bool
    path_constraints: moveit_msgs.msg.Constraints
    planner_id: str
    @property
    def allowed_touch_objects(self) -> list[str]: ...
    @allowed_touch_objects.setter
    def allowed_touch_objects(self, value: Collection[str]) -> None: ...
    allowed_planning_time: float
    planning_options: moveit_msgs.msg.PlanningOptions

class Pickup_Result(Message):
    """moveit_msgs/action/Pickup_Result

    MoveItErrorCodes error_code
    RobotState trajectory_start
    RobotTrajectory[] trajectory_stages
    string[] trajectory_descriptions
    Grasp grasp
    float64 planning_time  # s
    """
    def __init__(self, *, error_code: moveit_msgs.msg.MoveItErrorCodes = ..., trajectory_start: moveit_msgs.msg.RobotState = ..., trajectory_stages: Collection[moveit_msgs.msg.RobotTrajectory] = ..., trajectory_descriptions: Collection[str] = ..., grasp: moveit_msgs.msg.Grasp = ..., planning_time: float = ..., check_fields: bool = ...) -> None: ...
    error_code: moveit_msgs.msg.MoveItErrorCodes
    trajectory_start: moveit_msgs.msg.RobotState
    @property
    def trajectory_stages(self) -> list[moveit_msgs.msg.RobotTrajectory]: ...
    @trajectory_stages.setter
    def trajectory_stages(self, value: Collection[moveit_msgs.msg.RobotTrajectory]) -> None: ...
    @property
    def trajectory_descriptions(self) -> list[str]: ...
    @trajectory_descriptions.setter
    def trajectory_descriptions(self, value: Collection[str]) -> None: ...
    grasp: moveit_msgs.msg.Grasp
    planning_time: float

class Pickup_Feedback(Message):
    """moveit_msgs/action/Pickup_Feedback

    string state
    """
    def __init__(self, *, state: str = ..., check_fields: bool = ...) -> None: ...
    state: str

class Pickup_FeedbackMessage(Message):
    """moveit_msgs/action/Pickup_FeedbackMessage"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., feedback: moveit_msgs.action.Pickup_Feedback = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    feedback: moveit_msgs.action.Pickup_Feedback

class Pickup_SendGoal_Request(Message):
    """moveit_msgs/action/Pickup_SendGoal_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., goal: moveit_msgs.action.Pickup_Goal = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    goal: moveit_msgs.action.Pickup_Goal

class Pickup_SendGoal_Response(Message):
    """moveit_msgs/action/Pickup_SendGoal_Response"""
    def __init__(self, *, accepted: bool = ..., stamp: builtin_interfaces.msg.Time = ..., check_fields: bool = ...) -> None: ...
    accepted: bool
    stamp: builtin_interfaces.msg.Time

class Pickup_SendGoal_Event(Message):
    """moveit_msgs/action/Pickup_SendGoal_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[moveit_msgs.action.Pickup_SendGoal_Request] = ..., response: Collection[moveit_msgs.action.Pickup_SendGoal_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[moveit_msgs.action.Pickup_SendGoal_Request]: ...
    @request.setter
    def request(self, value: Collection[moveit_msgs.action.Pickup_SendGoal_Request]) -> None: ...
    @property
    def response(self) -> list[moveit_msgs.action.Pickup_SendGoal_Response]: ...
    @response.setter
    def response(self, value: Collection[moveit_msgs.action.Pickup_SendGoal_Response]) -> None: ...

class Pickup_GetResult_Request(Message):
    """moveit_msgs/action/Pickup_GetResult_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID

class Pickup_GetResult_Response(Message):
    """moveit_msgs/action/Pickup_GetResult_Response"""
    def __init__(self, *, status: int = ..., result: moveit_msgs.action.Pickup_Result = ..., check_fields: bool = ...) -> None: ...
    status: int
    result: moveit_msgs.action.Pickup_Result

class Pickup_GetResult_Event(Message):
    """moveit_msgs/action/Pickup_GetResult_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[moveit_msgs.action.Pickup_GetResult_Request] = ..., response: Collection[moveit_msgs.action.Pickup_GetResult_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[moveit_msgs.action.Pickup_GetResult_Request]: ...
    @request.setter
    def request(self, value: Collection[moveit_msgs.action.Pickup_GetResult_Request]) -> None: ...
    @property
    def response(self) -> list[moveit_msgs.action.Pickup_GetResult_Response]: ...
    @response.setter
    def response(self, value: Collection[moveit_msgs.action.Pickup_GetResult_Response]) -> None: ...

class Pickup_SendGoal(Service):
    Request: TypeAlias = Pickup_SendGoal_Request
    Response: TypeAlias = Pickup_SendGoal_Response
    Event: TypeAlias = Pickup_SendGoal_Event

class Pickup_GetResult(Service):
    Request: TypeAlias = Pickup_GetResult_Request
    Response: TypeAlias = Pickup_GetResult_Response
    Event: TypeAlias = Pickup_GetResult_Event

class Pickup(Action):
    Goal: TypeAlias = Pickup_Goal
    Result: TypeAlias = Pickup_Result
    Feedback: TypeAlias = Pickup_Feedback
    class Impl:
        SendGoalService: TypeAlias = Pickup_SendGoal
        GetResultService: TypeAlias = Pickup_GetResult
        FeedbackMessage: TypeAlias = Pickup_FeedbackMessage
        CancelGoalService: TypeAlias = action_msgs.srv.CancelGoal
        GoalStatusMessage: TypeAlias = action_msgs.msg.GoalStatusArray

class Place_Goal(Message):
    """moveit_msgs/action/Place_Goal

    # Puts an object down.

    string group_name
    string attached_object_name
    PlaceLocation[] place_locations
    bool place_eef  # place_locations are poses of the end effector
    string support_surface_name
    bool allow_gripper_support_collision
    Constraints path_constraints
    string planner_id
    string[] allowed_touch_objects
    float64 allowed_planning_time  # s
    PlanningOptions planning_options
    """
    def __init__(self, *, group_name: str = ..., attached_object_name: str = ..., place_locations: Collection[moveit_msgs.msg.PlaceLocation] = ..., place_eef: bool = ..., support_surface_name: str = ..., allow_gripper_support_collision: bool = ..., path_constraints: moveit_msgs.msg.Constraints = ..., planner_id: str = ..., allowed_touch_objects: Collection[str] = ..., allowed_planning_time: float = ..., planning_options: moveit_msgs.msg.PlanningOptions = ..., check_fields: bool = ...) -> None: ...
    group_name: str
    attached_object_name: str
    @property
    def place_locations(self) -> list[moveit_msgs.msg.PlaceLocation]: ...
    @place_locations.setter
    def place_locations(self, value: Collection[moveit_msgs.msg.PlaceLocation]) -> None: ...
    place_eef: bool
    support_surface_name: str
    allow_gripper_support_collision: bool
    path_constraints: moveit_msgs.msg.Constraints
    planner_id: str
    @property
    def allowed_touch_objects(self) -> list[str]: ...
    @allowed_touch_objects.setter
    def allowed_touch_objects(self, value: Collection[str]) -> None: ...
    allowed_planning_time: float
    planning_options: moveit_msgs.msg.PlanningOptions

class Place_Result(Message):
    """moveit_msgs/action/Place_Result

    MoveItErrorCodes error_code
    RobotState trajectory_start
    RobotTrajectory[] trajectory_stages
    string[] trajectory_descriptions
    PlaceLocation place_location
    float64 planning_time  # s
    """
    def __init__(self, *, error_code: moveit_msgs.msg.MoveItErrorCodes = ..., trajectory_start: moveit_msgs.msg.RobotState = ..., trajectory_stages: Collection[moveit_msgs.msg.RobotTrajectory] = ..., trajectory_descriptions: Collection[str] = ..., place_location: moveit_msgs.msg.PlaceLocation = ..., planning_time: float = ..., check_fields: bool = ...) -> None: ...
    error_code: moveit_msgs.msg.MoveItErrorCodes
    trajectory_start: moveit_msgs.msg.RobotState
    @property
    def trajectory_stages(self) -> list[moveit_msgs.msg.RobotTrajectory]: ...
    @trajectory_stages.setter
    def trajectory_stages(self, value: Collection[moveit_msgs.msg.RobotTrajectory]) -> None: ...
    @property
    def trajectory_descriptions(self) -> list[str]: ...
    @trajectory_descriptions.setter
    def trajectory_descriptions(self, value: Collection[str]) -> None: ...
    place_location: moveit_msgs.msg.PlaceLocation
    planning_time: float

class Place_Feedback(Message):
    """moveit_msgs/action/Place_Feedback

    string state
    """
    def __init__(self, *, state: str = ..., check_fields: bool = ...) -> None: ...
    state: str

class Place_FeedbackMessage(Message):
    """moveit_msgs/action/Place_FeedbackMessage"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., feedback: moveit_msgs.action.Place_Feedback = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    feedback: moveit_msgs.action.Place_Feedback

class Place_SendGoal_Request(Message):
    """moveit_msgs/action/Place_SendGoal_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., goal: moveit_msgs.action.Place_Goal = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    goal: moveit_msgs.action.Place_Goal

class Place_SendGoal_Response(Message):
    """moveit_msgs/action/Place_SendGoal_Response"""
    def __init__(self, *, accepted: bool = ..., stamp: builtin_interfaces.msg.Time = ..., check_fields: bool = ...) -> None: ...
    accepted: bool
    stamp: builtin_interfaces.msg.Time

class Place_SendGoal_Event(Message):
    """moveit_msgs/action/Place_SendGoal_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[moveit_msgs.action.Place_SendGoal_Request] = ..., response: Collection[moveit_msgs.action.Place_SendGoal_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[moveit_msgs.action.Place_SendGoal_Request]: ...
    @request.setter
    def request(self, value: Collection[moveit_msgs.action.Place_SendGoal_Request]) -> None: ...
    @property
    def response(self) -> list[moveit_msgs.action.Place_SendGoal_Response]: ...
    @response.setter
    def response(self, value: Collection[moveit_msgs.action.Place_SendGoal_Response]) -> None: ...

class Place_GetResult_Request(Message):
    """moveit_msgs/action/Place_GetResult_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID

class Place_GetResult_Response(Message):
    """moveit_msgs/action/Place_GetResult_Response"""
    def __init__(self, *, status: int = ..., result: moveit_msgs.action.Place_Result = ..., check_fields: bool = ...) -> None: ...
    status: int
    result: moveit_msgs.action.Place_Result

class Place_GetResult_Event(Message):
    """moveit_msgs/action/Place_GetResult_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[moveit_msgs.action.Place_GetResult_Request] = ..., response: Collection[moveit_msgs.action.Place_GetResult_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[moveit_msgs.action.Place_GetResult_Request]: ...
    @request.setter
    def request(self, value: Collection[moveit_msgs.action.Place_GetResult_Request]) -> None: ...
    @property
    def response(self) -> list[moveit_msgs.action.Place_GetResult_Response]: ...
    @response.setter
    def response(self, value: Collection[moveit_msgs.action.Place_GetResult_Response]) -> None: ...

class Place_SendGoal(Service):
    Request: TypeAlias = Place_SendGoal_Request
    Response: TypeAlias = Place_SendGoal_Response
    Event: TypeAlias = Place_SendGoal_Event

class Place_GetResult(Service):
    Request: TypeAlias = Place_GetResult_Request
    Response: TypeAlias = Place_GetResult_Response
    Event: TypeAlias = Place_GetResult_Event

class Place(Action):
    Goal: TypeAlias = Place_Goal
    Result: TypeAlias = Place_Result
    Feedback: TypeAlias = Place_Feedback
    class Impl:
        SendGoalService: TypeAlias = Place_SendGoal
        GetResultService: TypeAlias = Place_GetResult
        FeedbackMessage: TypeAlias = Place_FeedbackMessage
        CancelGoalService: TypeAlias = action_msgs.srv.CancelGoal
        GoalStatusMessage: TypeAlias = action_msgs.msg.GoalStatusArray
