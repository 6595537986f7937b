# Written by python -m zbot.interfaces.stubs; do not edit.
from array import array
from collections.abc import Collection
from typing import Final, TypeAlias

import numpy
from numpy.typing import NDArray

import action_msgs.msg
import action_msgs.srv
import builtin_interfaces.msg
import geographic_msgs.msg
import geometry_msgs.msg
import nav2_msgs.action
import nav2_msgs.msg
import nav_msgs.msg
import service_msgs.msg
import std_msgs.msg
import unique_identifier_msgs.msg
from zbot.interfaces import Action, Message, Service

class AssistedTeleop_Goal(Message):
    """nav2_msgs/action/AssistedTeleop_Goal

    # Lets a person drive, and keeps the robot off obstacles meanwhile.

    builtin_interfaces/Duration time_allowance
    """
    def __init__(self, *, time_allowance: builtin_interfaces.msg.Duration = ..., check_fields: bool = ...) -> None: ...
    time_allowance: builtin_interfaces.msg.Duration

class AssistedTeleop_Result(Message):
    """nav2_msgs/action/AssistedTeleop_Result

    uint16 NONE=0
    uint16 GOAL_REJECTED=1
    uint16 SEND_GOAL_FAILURE=2
    uint16 UNKNOWN=730
    uint16 TIMEOUT=731
    uint16 TF_ERROR=732
    builtin_interfaces/Duration total_elapsed_time
    uint16 error_code
    string error_msg
    """
    NONE: Final = 0
    GOAL_REJECTED: Final = 1
    SEND_GOAL_FAILURE: Final = 2
    UNKNOWN: Final = 730
    TIMEOUT: Final = 731
    TF_ERROR: Final = 732
    def __init__(self, *, total_elapsed_time: builtin_interfaces.msg.Duration = ..., error_code: int = ..., error_msg: str = ..., check_fields: bool = ...) -> None: ...
    total_elapsed_time: builtin_interfaces.msg.Duration
    error_code: int
    error_msg: str

class AssistedTeleop_Feedback(Message):
    """nav2_msgs/action/AssistedTeleop_Feedback

    builtin_interfaces/Duration current_teleop_duration
    """
    def __init__(self, *, current_teleop_duration: builtin_interfaces.msg.Duration = ..., check_fields: bool = ...) -> None: ...
    current_teleop_duration: builtin_interfaces.msg.Duration

class AssistedTeleop_FeedbackMessage(Message):
    """nav2_msgs/action/AssistedTeleop_FeedbackMessage"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., feedback: nav2_msgs.action.AssistedTeleop_Feedback = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    feedback: nav2_msgs.action.AssistedTeleop_Feedback

class AssistedTeleop_SendGoal_Request(Message):
    """nav2_msgs/action/AssistedTeleop_SendGoal_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., goal: nav2_msgs.action.AssistedTeleop_Goal = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    goal: nav2_msgs.action.AssistedTeleop_Goal

class AssistedTeleop_SendGoal_Response(Message):
    """nav2_msgs/action/AssistedTeleop_SendGoal_Response"""
    def __init__(self, *, accepted: bool = ..., stamp: builtin_interfaces.msg.Time = ..., check_fields: bool = ...) -> None: ...
    accepted: bool
    stamp: builtin_interfaces.msg.Time

class AssistedTeleop_SendGoal_Event(Message):
    """nav2_msgs/action/AssistedTeleop_SendGoal_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[nav2_msgs.action.AssistedTeleop_SendGoal_Request] = ..., response: Collection[nav2_msgs.action.AssistedTeleop_SendGoal_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[nav2_msgs.action.AssistedTeleop_SendGoal_Request]: ...
    @request.setter
    def request(self, value: Collection[nav2_msgs.action.AssistedTeleop_SendGoal_Request]) -> None: ...
    @property
    def response(self) -> list[nav2_msgs.action.AssistedTeleop_SendGoal_Response]: ...
    @response.setter
    def response(self, value: Collection[nav2_msgs.action.AssistedTeleop_SendGoal_Response]) -> None: ...

class AssistedTeleop_GetResult_Request(Message):
    """nav2_msgs/action/AssistedTeleop_GetResult_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID

class AssistedTeleop_GetResult_Response(Message):
    """nav2_msgs/action/AssistedTeleop_GetResult_Response"""
    def __init__(self, *, status: int = ..., result: nav2_msgs.action.AssistedTeleop_Result = ..., check_fields: bool = ...) -> None: ...
    status: int
    result: nav2_msgs.action.AssistedTeleop_Result

class AssistedTeleop_GetResult_Event(Message):
    """nav2_msgs/action/AssistedTeleop_GetResult_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[nav2_msgs.action.AssistedTeleop_GetResult_Request] = ..., response: Collection[nav2_msgs.action.AssistedTeleop_GetResult_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[nav2_msgs.action.AssistedTeleop_GetResult_Request]: ...
    @request.setter
    def request(self, value: Collection[nav2_msgs.action.AssistedTeleop_GetResult_Request]) -> None: ...
    @property
    def response(self) -> list[nav2_msgs.action.AssistedTeleop_GetResult_Response]: ...
    @response.setter
    def response(self, value: Collection[nav2_msgs.action.AssistedTeleop_GetResult_Response]) -> None: ...

class AssistedTeleop_SendGoal(Service):
    Request: TypeAlias = AssistedTeleop_SendGoal_Request
    Response: TypeAlias = AssistedTeleop_SendGoal_Response
    Event: TypeAlias = AssistedTeleop_SendGoal_Event

class AssistedTeleop_GetResult(Service):
    Request: TypeAlias = AssistedTeleop_GetResult_Request
    Response: TypeAlias = AssistedTeleop_GetResult_Response
    Event: TypeAlias = AssistedTeleop_GetResult_Event

class AssistedTeleop(Action):
    Goal: TypeAlias = AssistedTeleop_Goal
    Result: TypeAlias = AssistedTeleop_Result
    Feedback: TypeAlias = AssistedTeleop_Feedback
    class Impl:
        SendGoalService: TypeAlias = AssistedTeleop_SendGoal
        GetResultService: TypeAlias = AssistedTeleop_GetResult
        FeedbackMessage: TypeAlias = AssistedTeleop_FeedbackMessage
        CancelGoalService: TypeAlias = action_msgs.srv.CancelGoal
        GoalStatusMessage: TypeAlias = action_msgs.msg.GoalStatusArray

class BackUp_Goal(Message):
    """nav2_msgs/action/BackUp_Goal

    # Drives a robot straight back.

    geometry_msgs/Point target  # m, from where it is now; x counts
    float32 speed  # m/s
    builtin_interfaces/Duration time_allowance
    bool disable_collision_checks False
    """
    def __init__(self, *, target: geometry_msgs.msg.Point = ..., speed: float = ..., time_allowance: builtin_interfaces.msg.Duration = ..., disable_collision_checks: bool = ..., check_fields: bool = ...) -> None: ...
    target: geometry_msgs.msg.Point
    speed: float
    time_allowance: builtin_interfaces.msg.Duration
    disable_collision_checks: bool

class BackUp_Result(Message):
    """nav2_msgs/action/BackUp_Result

    uint16 NONE=0
    uint16 GOAL_REJECTED=1
    uint16 SEND_GOAL_FAILURE=2
    uint16 UNKNOWN=710
    uint16 TIMEOUT=711
    uint16 TF_ERROR=712
    uint16 INVALID_INPUT=713
    uint16 COLLISION_AHEAD=714
    builtin_interfaces/Duration total_elapsed_time
    uint16 error_code
    string error_msg
    """
    NONE: Final = 0
    GOAL_REJECTED: Final = 1
    SEND_GOAL_FAILURE: Final = 2
    UNKNOWN: Final = 710
    TIMEOUT: Final = 711
    TF_ERROR: Final = 712
    INVALID_INPUT: Final = 713
    COLLISION_AHEAD: Final = 714
    def __init__(self, *, total_elapsed_time: builtin_interfaces.msg.Duration = ..., error_code: int = ..., error_msg: str = ..., check_fields: bool = ...) -> None: ...
    total_elapsed_time: builtin_interfaces.msg.Duration
    error_code: int
    error_msg: str

class BackUp_Feedback(Message):
    """nav2_msgs/action/BackUp_Feedback

    float32 distance_traveled  # m
    """
    def __init__(self, *, distance_traveled: float = ..., check_fields: bool = ...) -> None: ...
    distance_traveled: float

class BackUp_FeedbackMessage(Message):
    """nav2_msgs/action/BackUp_FeedbackMessage"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., feedback: nav2_msgs.action.BackUp_Feedback = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    feedback: nav2_msgs.action.BackUp_Feedback

class BackUp_SendGoal_Request(Message):
    """nav2_msgs/action/BackUp_SendGoal_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., goal: nav2_msgs.action.BackUp_Goal = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    goal: nav2_msgs.action.BackUp_Goal

class BackUp_SendGoal_Response(Message):
    """nav2_msgs/action/BackUp_SendGoal_Response"""
    def __init__(self, *, accepted: bool = ..., stamp: builtin_interfaces.msg.Time = ..., check_fields: bool = ...) -> None: ...
    accepted: bool
    stamp: builtin_interfaces.msg.Time

class BackUp_SendGoal_Event(Message):
    """nav2_msgs/action/BackUp_SendGoal_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[nav2_msgs.action.BackUp_SendGoal_Request] = ..., response: Collection[nav2_msgs.action.BackUp_SendGoal_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[nav2_msgs.action.BackUp_SendGoal_Request]: ...
    @request.setter
    def request(self, value: Collection[nav2_msgs.action.BackUp_SendGoal_Request]) -> None: ...
    @property
    def response(self) -> list[nav2_msgs.action.BackUp_SendGoal_Response]: ...
    @response.setter
    def response(self, value: Collection[nav2_msgs.action.BackUp_SendGoal_Response]) -> None: ...

class BackUp_GetResult_Request(Message):
    """nav2_msgs/action/BackUp_GetResult_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID

class BackUp_GetResult_Response(Message):
    """nav2_msgs/action/BackUp_GetResult_Response"""
    def __init__(self, *, status: int = ..., result: nav2_msgs.action.BackUp_Result = ..., check_fields: bool = ...) -> None: ...
    status: int
    result: nav2_msgs.action.BackUp_Result

class BackUp_GetResult_Event(Message):
    """nav2_msgs/action/BackUp_GetResult_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[nav2_msgs.action.BackUp_GetResult_Request] = ..., response: Collection[nav2_msgs.action.BackUp_GetResult_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[nav2_msgs.action.BackUp_GetResult_Request]: ...
    @request.setter
    def request(self, value: Collection[nav2_msgs.action.BackUp_GetResult_Request]) -> None: ...
    @property
    def response(self) -> list[nav2_msgs.action.BackUp_GetResult_Response]: ...
    @response.setter
    def response(self, value: Collection[nav2_msgs.action.BackUp_GetResult_Response]) -> None: ...

class BackUp_SendGoal(Service):
    Request: TypeAlias = BackUp_SendGoal_Request
    Response: TypeAlias = BackUp_SendGoal_Response
    Event: TypeAlias = BackUp_SendGoal_Event

class BackUp_GetResult(Service):
    Request: TypeAlias = BackUp_GetResult_Request
    Response: TypeAlias = BackUp_GetResult_Response
    Event: TypeAlias = BackUp_GetResult_Event

class BackUp(Action):
    Goal: TypeAlias = BackUp_Goal
    Result: TypeAlias = BackUp_Result
    Feedback: TypeAlias = BackUp_Feedback
    class Impl:
        SendGoalService: TypeAlias = BackUp_SendGoal
        GetResultService: TypeAlias = BackUp_GetResult
        FeedbackMessage: TypeAlias = BackUp_FeedbackMessage
        CancelGoalService: TypeAlias = action_msgs.srv.CancelGoal
        GoalStatusMessage: TypeAlias = action_msgs.msg.GoalStatusArray

class ComputeAndTrackRoute_Goal(Message):
    """nav2_msgs/action/ComputeAndTrackRoute_Goal

    # Looks for a way through a graph of places, and tells how far along it the robot is.

    uint16 start_id
    geometry_msgs/PoseStamped start
    uint16 goal_id
    geometry_msgs/PoseStamped goal
    bool use_start  # false: from where the robot is
    bool use_poses  # false: the two ids count
    """
    def __init__(self, *, start_id: int = ..., start: geometry_msgs.msg.PoseStamped = ..., goal_id: int = ..., goal: geometry_msgs.msg.PoseStamped = ..., use_start: bool = ..., use_poses: bool = ..., check_fields: bool = ...) -> None: ...
    start_id: int
    start: geometry_msgs.msg.PoseStamped
    goal_id: int
    goal: geometry_msgs.msg.PoseStamped
    use_start: bool
    use_poses: bool

class ComputeAndTrackRoute_Result(Message):
    """nav2_msgs/action/ComputeAndTrackRoute_Result

    uint16 NONE=0
    uint16 GOAL_REJECTED=1
    uint16 SEND_GOAL_FAILURE=2
    uint16 UNKNOWN=400
    uint16 TF_ERROR=401
    uint16 NO_VALID_GRAPH=402
    uint16 INDETERMINANT_NODES_ON_GRAPH=403
    uint16 TIMEOUT=404
    uint16 NO_VALID_ROUTE=405
    uint16 OPERATION_FAILED=406
    uint16 INVALID_EDGE_SCORER_USE=407
    builtin_interfaces/Duration execution_duration
    uint16 error_code 0
    string error_msg
    """
    NONE: Final = 0
    GOAL_REJECTED: Final = 1
    SEND_GOAL_FAILURE: Final = 2
    UNKNOWN: Final = 400
    TF_ERROR: Final = 401
    NO_VALID_GRAPH: Final = 402
    INDETERMINANT_NODES_ON_GRAPH: Final = 403
    TIMEOUT: Final = 404
    NO_VALID_ROUTE: Final = 405
    OPERATION_FAILED: Final = 406
    INVALID_EDGE_SCORER_USE: Final = 407
    def __init__(self, *, execution_duration: builtin_interfaces.msg.Duration = ..., error_code: int = ..., error_msg: str = ..., check_fields: bool = ...) -> None: ...
    execution_duration: builtin_interfaces.msg.Duration
    error_code: int
    error_msg: str

class ComputeAndTrackRoute_Feedback(Message):
    """nav2_msgs/action/ComputeAndTrackRoute_Feedback

    uint16 last_node_id
    uint16 next_node_id
    uint16 current_edge_id
    Route route
    nav_msgs/Path path
    string[] operations_triggered
    bool rerouted
    """
    def __init__(self, *, last_node_id: int = ..., next_node_id: int = ..., current_edge_id: int = ..., route: nav2_msgs.msg.Route = ..., path: nav_msgs.msg.Path = ..., operations_triggered: Collection[str] = ..., rerouted: bool = ..., check_fields: bool = ...) -> None: ...
    last_node_id: int
    next_node_id: int
    current_edge_id: int
    route: nav2_msgs.msg.Route
    path: nav_msgs.msg.Path
    @property
    def operations_triggered(self) -> list[str]: ...
    @operations_triggered.setter
    def operations_triggered(self, value: Collection[str]) -> None: ...
    rerouted: bool

class ComputeAndTrackRoute_FeedbackMessage(Message):
    """nav2_msgs/action/ComputeAndTrackRoute_FeedbackMessage"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., feedback: nav2_msgs.action.ComputeAndTrackRoute_Feedback = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    feedback: nav2_msgs.action.ComputeAndTrackRoute_Feedback

class ComputeAndTrackRoute_SendGoal_Request(Message):
    """nav2_msgs/action/ComputeAndTrackRoute_SendGoal_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., goal: nav2_msgs.action.ComputeAndTrackRoute_Goal = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    goal: nav2_msgs.action.ComputeAndTrackRoute_Goal

class ComputeAndTrackRoute_SendGoal_Response(Message):
    """nav2_msgs/action/ComputeAndTrackRoute_SendGoal_Response"""
    def __init__(self, *, accepted: bool = ..., stamp: builtin_interfaces.msg.Time = ..., check_fields: bool = ...) -> None: ...
    accepted: bool
    stamp: builtin_interfaces.msg.Time

class ComputeAndTrackRoute_SendGoal_Event(Message):
    """nav2_msgs/action/ComputeAndTrackRoute_SendGoal_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[nav2_msgs.action.ComputeAndTrackRoute_SendGoal_Request] = ..., response: Collection[nav2_msgs.action.ComputeAndTrackRoute_SendGoal_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[nav2_msgs.action.ComputeAndTrackRoute_SendGoal_Request]: ...
    @request.setter
    def request(self, value: Collection[nav2_msgs.action.ComputeAndTrackRoute_SendGoal_Request]) -> None: ...
    @property
    def response(self) -> list[nav2_msgs.action.ComputeAndTrackRoute_SendGoal_Response]: ...
    @response.setter
    def response(self, value: Collection[nav2_msgs.action.ComputeAndTrackRoute_SendGoal_Response]) -> None: ...

class ComputeAndTrackRoute_GetResult_Request(Message):
    """nav2_msgs/action/ComputeAndTrackRoute_GetResult_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID

class ComputeAndTrackRoute_GetResult_Response(Message):
    """nav2_msgs/action/ComputeAndTrackRoute_GetResult_Response"""
    def __init__(self, *, status: int = ..., result: nav2_msgs.action.ComputeAndTrackRoute_Result = ..., check_fields: bool = ...) -> None: ...
    status: int
    result: nav2_msgs.action.ComputeAndTrackRoute_Result

class ComputeAndTrackRoute_GetResult_Event(Message):
    """nav2_msgs/action/ComputeAndTrackRoute_GetResult_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[nav2_msgs.action.ComputeAndTrackRoute_GetResult_Request] = ..., response: Collection[nav2_msgs.action.ComputeAndTrackRoute_GetResult_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[nav2_msgs.action.ComputeAndTrackRoute_GetResult_Request]: ...
    @request.setter
    def request(self, value: Collection[nav2_msgs.action.ComputeAndTrackRoute_GetResult_Request]) -> None: ...
    @property
    def response(self) -> list[nav2_msgs.action.ComputeAndTrackRoute_GetResult_Response]: ...
    @response.setter
    def response(self, value: Collection[nav2_msgs.action.ComputeAndTrackRoute_GetResult_Response]) -> None: ...

class ComputeAndTrackRoute_SendGoal(Service):
    Request: TypeAlias = ComputeAndTrackRoute_SendGoal_Request
    Response: TypeAlias = ComputeAndTrackRoute_SendGoal_Response
    Event: TypeAlias = ComputeAndTrackRoute_SendGoal_Event

class ComputeAndTrackRoute_GetResult(Service):
    Request: TypeAlias = ComputeAndTrackRoute_GetResult_Request
    Response: TypeAlias = ComputeAndTrackRoute_GetResult_Response
    Event: TypeAlias = ComputeAndTrackRoute_GetResult_Event

class ComputeAndTrackRoute(Action):
    Goal: TypeAlias = ComputeAndTrackRoute_Goal
    Result: TypeAlias = ComputeAndTrackRoute_Result
    Feedback: TypeAlias = ComputeAndTrackRoute_Feedback
    class Impl:
        SendGoalService: TypeAlias = ComputeAndTrackRoute_SendGoal
        GetResultService: TypeAlias = ComputeAndTrackRoute_GetResult
        FeedbackMessage: TypeAlias = ComputeAndTrackRoute_FeedbackMessage
        CancelGoalService: TypeAlias = action_msgs.srv.CancelGoal
        GoalStatusMessage: TypeAlias = action_msgs.msg.GoalStatusArray

class ComputePathThroughPoses_Goal(Message):
    """nav2_msgs/action/ComputePathThroughPoses_Goal

    # Finds a way through places to the last of them.

    nav_msgs/Goals goals
    geometry_msgs/PoseStamped start  # where the robot is unless use_start is set
    string planner_id
    bool use_start
    """
    def __init__(self, *, goals: nav_msgs.msg.Goals = ..., start: geometry_msgs.msg.PoseStamped = ..., planner_id: str = ..., use_start: bool = ..., check_fields: bool = ...) -> None: ...
    goals: nav_msgs.msg.Goals
    start: geometry_msgs.msg.PoseStamped
    planner_id: str
    use_start: bool

class ComputePathThroughPoses_Result(Message):
    """nav2_msgs/action/ComputePathThroughPoses_Result

    int16 ALL_GOALS=-1
    uint16 NONE=0
    uint16 GOAL_REJECTED=1
    uint16 SEND_GOAL_FAILURE=2
    uint16 UNKNOWN=300
    uint16 INVALID_PLANNER=301
    uint16 TF_ERROR=302
    uint16 START_OUTSIDE_MAP=303
    uint16 GOAL_OUTSIDE_MAP=304
    uint16 START_OCCUPIED=305
    uint16 GOAL_OCCUPIED=306
    uint16 TIMEOUT=307
    uint16 NO_VALID_PATH=308
    uint16 NO_VIAPOINTS_GIVEN=309
    nav_msgs/Path path
    int16 last_reached_index -1
    builtin_interfaces/Duration planning_time
    uint16 error_code
    string error_msg
    """
    ALL_GOALS: Final = -1
    NONE: Final = 0
    GOAL_REJECTED: Final = 1
    SEND_GOAL_FAILURE: Final = 2
    UNKNOWN: Final = 300
    INVALID_PLANNER: Final = 301
    TF_ERROR: Final = 302
    START_OUTSIDE_MAP: Final = 303
    GOAL_OUTSIDE_MAP: Final = 304
    START_OCCUPIED: Final = 305
    GOAL_OCCUPIED: Final = 306
    TIMEOUT: Final = 307
    NO_VALID_PATH: Final = 308
    NO_VIAPOINTS_GIVEN: Final = 309
    def __init__(self, *, path: nav_msgs.msg.Path = ..., last_reached_index: int = ..., planning_time: builtin_interfaces.msg.Duration = ..., error_code: int = ..., error_msg: str = ..., check_fields: bool = ...) -> None: ...
    path: nav_msgs.msg.Path
    last_reached_index: int
    planning_time: builtin_interfaces.msg.Duration
    error_code: int
    error_msg: str

class ComputePathThroughPoses_Feedback(Message):
    """nav2_msgs/action/ComputePathThroughPoses_Feedback"""
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class ComputePathThroughPoses_FeedbackMessage(Message):
    """nav2_msgs/action/ComputePathThroughPoses_FeedbackMessage"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., feedback: nav2_msgs.action.ComputePathThroughPoses_Feedback = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    feedback: nav2_msgs.action.ComputePathThroughPoses_Feedback

class ComputePathThroughPoses_SendGoal_Request(Message):
    """nav2_msgs/action/ComputePathThroughPoses_SendGoal_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., goal: nav2_msgs.action.ComputePathThroughPoses_Goal = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    goal: nav2_msgs.action.ComputePathThroughPoses_Goal

class ComputePathThroughPoses_SendGoal_Response(Message):
    """nav2_msgs/action/ComputePathThroughPoses_SendGoal_Response"""
    def __init__(self, *, accepted: bool = ..., stamp: builtin_interfaces.msg.Time = ..., check_fields: bool = ...) -> None: ...
    accepted: bool
    stamp: builtin_interfaces.msg.Time

class ComputePathThroughPoses_SendGoal_Event(Message):
    """nav2_msgs/action/ComputePathThroughPoses_SendGoal_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[nav2_msgs.action.ComputePathThroughPoses_SendGoal_Request] = ..., response: Collection[nav2_msgs.action.ComputePathThroughPoses_SendGoal_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[nav2_msgs.action.ComputePathThroughPoses_SendGoal_Request]: ...
    @request.setter
    def request(self, value: Collection[nav2_msgs.action.ComputePathThroughPoses_SendGoal_Request]) -> None: ...
    @property
    def response(self) -> list[nav2_msgs.action.ComputePathThroughPoses_SendGoal_Response]: ...
    @response.setter
    def response(self, value: Collection[nav2_msgs.action.ComputePathThroughPoses_SendGoal_Response]) -> None: ...

class ComputePathThroughPoses_GetResult_Request(Message):
    """nav2_msgs/action/ComputePathThroughPoses_GetResult_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID

class ComputePathThroughPoses_GetResult_Response(Message):
    """nav2_msgs/action/ComputePathThroughPoses_GetResult_Response"""
    def __init__(self, *, status: int = ..., result: nav2_msgs.action.ComputePathThroughPoses_Result = ..., check_fields: bool = ...) -> None: ...
    status: int
    result: nav2_msgs.action.ComputePathThroughPoses_Result

class ComputePathThroughPoses_GetResult_Event(Message):
    """nav2_msgs/action/ComputePathThroughPoses_GetResult_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[nav2_msgs.action.ComputePathThroughPoses_GetResult_Request] = ..., response: Collection[nav2_msgs.action.ComputePathThroughPoses_GetResult_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[nav2_msgs.action.ComputePathThroughPoses_GetResult_Request]: ...
    @request.setter
    def request(self, value: Collection[nav2_msgs.action.ComputePathThroughPoses_GetResult_Request]) -> None: ...
    @property
    def response(self) -> list[nav2_msgs.action.ComputePathThroughPoses_GetResult_Response]: ...
    @response.setter
    def response(self, value: Collection[nav2_msgs.action.ComputePathThroughPoses_GetResult_Response]) -> None: ...

class ComputePathThroughPoses_SendGoal(Service):
    Request: TypeAlias = ComputePathThroughPoses_SendGoal_Request
    Response: TypeAlias = ComputePathThroughPoses_SendGoal_Response
    Event: TypeAlias = ComputePathThroughPoses_SendGoal_Event

class ComputePathThroughPoses_GetResult(Service):
    Request: TypeAlias = ComputePathThroughPoses_GetResult_Request
    Response: TypeAlias = ComputePathThroughPoses_GetResult_Response
    Event: TypeAlias = ComputePathThroughPoses_GetResult_Event

class ComputePathThroughPoses(Action):
    Goal: TypeAlias = ComputePathThroughPoses_Goal
    Result: TypeAlias = ComputePathThroughPoses_Result
    Feedback: TypeAlias = ComputePathThroughPoses_Feedback
    class Impl:
        SendGoalService: TypeAlias = ComputePathThroughPoses_SendGoal
        GetResultService: TypeAlias = ComputePathThroughPoses_GetResult
        FeedbackMessage: TypeAlias = ComputePathThroughPoses_FeedbackMessage
        CancelGoalService: TypeAlias = action_msgs.srv.CancelGoal
        GoalStatusMessage: TypeAlias = action_msgs.msg.GoalStatusArray

class ComputePathToPose_Goal(Message):
    """nav2_msgs/action/ComputePathToPose_Goal

    # Finds a way to a place.

    geometry_msgs/PoseStamped goal
    geometry_msgs/PoseStamped start  # where the robot is unless use_start is set
    geometry_msgs/PoseStamped[] viapoints
    string planner_id
    bool use_start
    """
    def __init__(self, *, goal: geometry_msgs.msg.PoseStamped = ..., start: geometry_msgs.msg.PoseStamped = ..., viapoints: Collection[geometry_msgs.msg.PoseStamped] = ..., planner_id: str = ..., use_start: bool = ..., check_fields: bool = ...) -> None: ...
    goal: geometry_msgs.msg.PoseStamped
    start: geometry_msgs.msg.PoseStamped
    @property
    def viapoints(self) -> list[geometry_msgs.msg.PoseStamped]: ...
    @viapoints.setter
    def viapoints(self, value: Collection[geometry_msgs.msg.PoseStamped]) -> None: ...
    planner_id: str
    use_start: bool

class ComputePathToPose_Result(Message):
    """nav2_msgs/action/ComputePathToPose_Result

    uint16 NONE=0
    uint16 GOAL_REJECTED=1
    uint16 SEND_GOAL_FAILURE=2
    uint16 UNKNOWN=200
    uint16 INVALID_PLANNER=201
    uint16 TF_ERROR=202
    uint16 START_OUTSIDE_MAP=203
    uint16 GOAL_OUTSIDE_MAP=204
    uint16 START_OCCUPIED=205
    uint16 GOAL_OCCUPIED=206
    uint16 TIMEOUT=207
    uint16 NO_VALID_PATH=208
    nav_msgs/Path path
    builtin_interfaces/Duration planning_time
    uint16 error_code
    string error_msg
    """
    NONE: Final = 0
    GOAL_REJECTED: Final = 1
    SEND_GOAL_FAILURE: Final = 2
    UNKNOWN: Final = 200
    INVALID_PLANNER: Final = 201
    TF_ERROR: Final = 202
    START_OUTSIDE_MAP: Final = 203
    GOAL_OUTSIDE_MAP: Final = 204
    START_OCCUPIED: Final = 205
    GOAL_OCCUPIED: Final = 206
    TIMEOUT: Final = 207
    NO_VALID_PATH: Final = 208
    def __init__(self, *, path: nav_msgs.msg.Path = ..., planning_time: builtin_interfaces.msg.Duration = ..., error_code: int = ..., error_msg: str = ..., check_fields: bool = ...) -> None: ...
    path: nav_msgs.msg.Path
    planning_time: builtin_interfaces.msg.Duration
    error_code: int
    error_msg: str

class ComputePathToPose_Feedback(Message):
    """nav2_msgs/action/ComputePathToPose_Feedback"""
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class ComputePathToPose_FeedbackMessage(Message):
    """nav2_msgs/action/ComputePathToPose_FeedbackMessage"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., feedback: nav2_msgs.action.ComputePathToPose_Feedback = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    feedback: nav2_msgs.action.ComputePathToPose_Feedback

class ComputePathToPose_SendGoal_Request(Message):
    """nav2_msgs/action/ComputePathToPose_SendGoal_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., goal: nav2_msgs.action.ComputePathToPose_Goal = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    goal: nav2_msgs.action.ComputePathToPose_Goal

class ComputePathToPose_SendGoal_Response(Message):
    """nav2_msgs/action/ComputePathToPose_SendGoal_Response"""
    def __init__(self, *, accepted: bool = ..., stamp: builtin_interfaces.msg.Time = ..., check_fields: bool = ...) -> None: ...
    accepted: bool
    stamp: builtin_interfaces.msg.Time

class ComputePathToPose_SendGoal_Event(Message):
    """nav2_msgs/action/ComputePathToPose_SendGoal_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[nav2_msgs.action.ComputePathToPose_SendGoal_Request] = ..., response: Collection[nav2_msgs.action.ComputePathToPose_SendGoal_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[nav2_msgs.action.ComputePathToPose_SendGoal_Request]: ...
    @request.setter
    def request(self, value: Collection[nav2_msgs.action.ComputePathToPose_SendGoal_Request]) -> None: ...
    @property
    def response(self) -> list[nav2_msgs.action.ComputePathToPose_SendGoal_Response]: ...
    @response.setter
    def response(self, value: Collection[nav2_msgs.action.ComputePathToPose_SendGoal_Response]) -> None: ...

class ComputePathToPose_GetResult_Request(Message):
    """nav2_msgs/action/ComputePathToPose_GetResult_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID

class ComputePathToPose_GetResult_Response(Message):
    """nav2_msgs/action/ComputePathToPose_GetResult_Response"""
    def __init__(self, *, status: int = ..., result: nav2_msgs.action.ComputePathToPose_Result = ..., check_fields: bool = ...) -> None: ...
    status: int
    result: nav2_msgs.action.ComputePathToPose_Result

class ComputePathToPose_GetResult_Event(Message):
    """nav2_msgs/action/ComputePathToPose_GetResult_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[nav2_msgs.action.ComputePathToPose_GetResult_Request] = ..., response: Collection[nav2_msgs.action.ComputePathToPose_GetResult_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[nav2_msgs.action.ComputePathToPose_GetResult_Request]: ...
    @request.setter
    def request(self, value: Collection[nav2_msgs.action.ComputePathToPose_GetResult_Request]) -> None: ...
    @property
    def response(self) -> list[nav2_msgs.action.ComputePathToPose_GetResult_Response]: ...
    @response.setter
    def response(self, value: Collection[nav2_msgs.action.ComputePathToPose_GetResult_Response]) -> None: ...

class ComputePathToPose_SendGoal(Service):
    Request: TypeAlias = ComputePathToPose_SendGoal_Request
    Response: TypeAlias = ComputePathToPose_SendGoal_Response
    Event: TypeAlias = ComputePathToPose_SendGoal_Event

class ComputePathToPose_GetResult(Service):
    Request: TypeAlias = ComputePathToPose_GetResult_Request
    Response: TypeAlias = ComputePathToPose_GetResult_Response
    Event: TypeAlias = ComputePathToPose_GetResult_Event

class ComputePathToPose(Action):
    Goal: TypeAlias = ComputePathToPose_Goal
    Result: TypeAlias = ComputePathToPose_Result
    Feedback: TypeAlias = ComputePathToPose_Feedback
    class Impl:
        SendGoalService: TypeAlias = ComputePathToPose_SendGoal
        GetResultService: TypeAlias = ComputePathToPose_GetResult
        FeedbackMessage: TypeAlias = ComputePathToPose_FeedbackMessage
        CancelGoalService: TypeAlias = action_msgs.srv.CancelGoal
        GoalStatusMessage: TypeAlias = action_msgs.msg.GoalStatusArray

class ComputeRoute_Goal(Message):
    """nav2_msgs/action/ComputeRoute_Goal

    # Looks for a way through a graph of places.

    uint16 start_id
    geometry_msgs/PoseStamped start
    uint16 goal_id
    geometry_msgs/PoseStamped goal
    bool use_start  # false: from where the robot is
    bool use_poses  # false: the two ids count
    """
    def __init__(self, *, start_id: int = ..., start: geometry_msgs.msg.PoseStamped = ..., goal_id: int = ..., goal: geometry_msgs.msg.PoseStamped = ..., use_start: bool = ..., use_poses: bool = ..., check_fields: bool = ...) -> None: ...
    start_id: int
    start: geometry_msgs.msg.PoseStamped
    goal_id: int
    goal: geometry_msgs.msg.PoseStamped
    use_start: bool
    use_poses: bool

class ComputeRoute_Result(Message):
    """nav2_msgs/action/ComputeRoute_Result

    uint16 NONE=0
    uint16 GOAL_REJECTED=1
    uint16 SEND_GOAL_FAILURE=2
    uint16 UNKNOWN=400
    uint16 TF_ERROR=401
    uint16 NO_VALID_GRAPH=402
    uint16 INDETERMINANT_NODES_ON_GRAPH=403
    uint16 TIMEOUT=404
    uint16 NO_VALID_ROUTE=405
    uint16 INVALID_EDGE_SCORER_USE=407
    builtin_interfaces/Duration planning_time
    nav_msgs/Path path
    Route route
    uint16 error_code 0
    string error_msg
    """
    NONE: Final = 0
    GOAL_REJECTED: Final = 1
    SEND_GOAL_FAILURE: Final = 2
    UNKNOWN: Final = 400
    TF_ERROR: Final = 401
    NO_VALID_GRAPH: Final = 402
    INDETERMINANT_NODES_ON_GRAPH: Final = 403
    TIMEOUT: Final = 404
    NO_VALID_ROUTE: Final = 405
    INVALID_EDGE_SCORER_USE: Final = 407
    def __init__(self, *, planning_time: builtin_interfaces.msg.Duration = ..., path: nav_msgs.msg.Path = ..., route: nav2_msgs.msg.Route = ..., error_code: int = ..., error_msg: str = ..., check_fields: bool = ...) -> None: ...
    planning_time: builtin_interfaces.msg.Duration
    path: nav_msgs.msg.Path
    route: nav2_msgs.msg.Route
    error_code: int
    error_msg: str

class ComputeRoute_Feedback(Message):
    """nav2_msgs/action/ComputeRoute_Feedback"""
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class ComputeRoute_FeedbackMessage(Message):
    """nav2_msgs/action/ComputeRoute_FeedbackMessage"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., feedback: nav2_msgs.action.ComputeRoute_Feedback = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    feedback: nav2_msgs.action.ComputeRoute_Feedback

class ComputeRoute_SendGoal_Request(Message):
    """nav2_msgs/action/ComputeRoute_SendGoal_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., goal: nav2_msgs.action.ComputeRoute_Goal = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    goal: nav2_msgs.action.ComputeRoute_Goal

class ComputeRoute_SendGoal_Response(Message):
    """nav2_msgs/action/ComputeRoute_SendGoal_Response"""
    def __init__(self, *, accepted: bool = ..., stamp: builtin_interfaces.msg.Time = ..., check_fields: bool = ...) -> None: ...
    accepted: bool
    stamp: builtin_interfaces.msg.Time

class ComputeRoute_SendGoal_Event(Message):
    """nav2_msgs/action/ComputeRoute_SendGoal_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[nav2_msgs.action.ComputeRoute_SendGoal_Request] = ..., response: Collection[nav2_msgs.action.ComputeRoute_SendGoal_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[nav2_msgs.action.ComputeRoute_SendGoal_Request]: ...
    @request.setter
    def request(self, value: Collection[nav2_msgs.action.ComputeRoute_SendGoal_Request]) -> None: ...
    @property
    def response(self) -> list[nav2_msgs.action.ComputeRoute_SendGoal_Response]: ...
    @response.setter
    def response(self, value: Collection[nav2_msgs.action.ComputeRoute_SendGoal_Response]) -> None: ...

class ComputeRoute_GetResult_Request(Message):
    """nav2_msgs/action/ComputeRoute_GetResult_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID

class ComputeRoute_GetResult_Response(Message):
    """nav2_msgs/action/ComputeRoute_GetResult_Response"""
    def __init__(self, *, status: int = ..., result: nav2_msgs.action.ComputeRoute_Result = ..., check_fields: bool = ...) -> None: ...
    status: int
    result: nav2_msgs.action.ComputeRoute_Result

class ComputeRoute_GetResult_Event(Message):
    """nav2_msgs/action/ComputeRoute_GetResult_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[nav2_msgs.action.ComputeRoute_GetResult_Request] = ..., response: Collection[nav2_msgs.action.ComputeRoute_GetResult_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[nav2_msgs.action.ComputeRoute_GetResult_Request]: ...
    @request.setter
    def request(self, value: Collection[nav2_msgs.action.ComputeRoute_GetResult_Request]) -> None: ...
    @property
    def response(self) -> list[nav2_msgs.action.ComputeRoute_GetResult_Response]: ...
    @response.setter
    def response(self, value: Collection[nav2_msgs.action.ComputeRoute_GetResult_Response]) -> None: ...

class ComputeRoute_SendGoal(Service):
    Request: TypeAlias = ComputeRoute_SendGoal_Request
    Response: TypeAlias = ComputeRoute_SendGoal_Response
    Event: TypeAlias = ComputeRoute_SendGoal_Event

class ComputeRoute_GetResult(Service):
    Request: TypeAlias = ComputeRoute_GetResult_Request
    Response: TypeAlias = ComputeRoute_GetResult_Response
    Event: TypeAlias = ComputeRoute_GetResult_Event

class ComputeRoute(Action):
    Goal: TypeAlias = ComputeRoute_Goal
    Result: TypeAlias = ComputeRoute_Result
    Feedback: TypeAlias = ComputeRoute_Feedback
    class Impl:
        SendGoalService: TypeAlias = ComputeRoute_SendGoal
        GetResultService: TypeAlias = ComputeRoute_GetResult
        FeedbackMessage: TypeAlias = ComputeRoute_FeedbackMessage
        CancelGoalService: TypeAlias = action_msgs.srv.CancelGoal
        GoalStatusMessage: TypeAlias = action_msgs.msg.GoalStatusArray

class DockRobot_Goal(Message):
    """nav2_msgs/action/DockRobot_Goal

    # Drives a robot into its dock.

    bool use_dock_id True  # false: dock_pose and dock_type count
    string dock_id
    geometry_msgs/PoseStamped dock_pose
    string dock_type
    float32 max_staging_time 1000.0  # s, to get in front of the dock
    bool navigate_to_staging_pose True  # false: it is there already
    """
    def __init__(self, *, use_dock_id: bool = ..., dock_id: str = ..., dock_pose: geometry_msgs.msg.PoseStamped = ..., dock_type: str = ..., max_staging_time: float = ..., navigate_to_staging_pose: bool = ..., check_fields: bool = ...) -> None: ...
    use_dock_id: bool
    dock_id: str
    dock_pose: geometry_msgs.msg.PoseStamped
    dock_type: str
    max_staging_time: float
    navigate_to_staging_pose: bool

class DockRobot_Result(Message):
    """nav2_msgs/action/DockRobot_Result

    uint16 NONE=0
    uint16 GOAL_REJECTED=1
    uint16 SEND_GOAL_FAILURE=2
    uint16 DOCK_NOT_IN_DB=901
    uint16 DOCK_NOT_VALID=902
    uint16 FAILED_TO_STAGE=903
    uint16 FAILED_TO_DETECT_DOCK=904
    uint16 FAILED_TO_CONTROL=905
    uint16 FAILED_TO_CHARGE=906
    uint16 TIMEOUT=907
    uint16 UNKNOWN=999
    bool success True
    uint16 error_code 0
    uint16 num_retries 0
    string error_msg
    """
    NONE: Final = 0
    GOAL_REJECTED: Final = 1
    SEND_GOAL_FAILURE: Final = 2
    DOCK_NOT_IN_DB: Final = 901
    DOCK_NOT_VALID: Final = 902
    FAILED_TO_STAGE: Final = 903
    FAILED_TO_DETECT_DOCK: Final = 904
    FAILED_TO_CONTROL: Final = 905
    FAILED_TO_CHARGE: Final = 906
    TIMEOUT: Final = 907
    UNKNOWN: Final = 999
    def __init__(self, *, success: bool = ..., error_code: int = ..., num_retries: int = ..., error_msg: str = ..., check_fields: bool = ...) -> None: ...
    success: bool
    error_code: int
    num_retries: int
    error_msg: str

class DockRobot_Feedback(Message):
    """nav2_msgs/action/DockRobot_Feedback

    uint16 NONE=0
    uint16 NAV_TO_STAGING_POSE=1
    uint16 INITIAL_PERCEPTION=2
    uint16 CONTROLLING=3
    uint16 WAIT_FOR_CHARGE=4
    uint16 RETRY=5
    uint16 state
    builtin_interfaces/Duration docking_time
    uint16 num_retries 0
    """
    NONE: Final = 0
    NAV_TO_STAGING_POSE: Final = 1
    INITIAL_PERCEPTION: Final = 2
    CONTROLLING: Final = 3
    WAIT_FOR_CHARGE: Final = 4
    RETRY: Final = 5
    def __init__(self, *, state: int = ..., docking_time: builtin_interfaces.msg.Duration = ..., num_retries: int = ..., check_fields: bool = ...) -> None: ...
    state: int
    docking_time: builtin_interfaces.msg.Duration
    num_retries: int

class DockRobot_FeedbackMessage(Message):
    """nav2_msgs/action/DockRobot_FeedbackMessage"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., feedback: nav2_msgs.action.DockRobot_Feedback = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    feedback: nav2_msgs.action.DockRobot_Feedback

class DockRobot_SendGoal_Request(Message):
    """nav2_msgs/action/DockRobot_SendGoal_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., goal: nav2_msgs.action.DockRobot_Goal = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    goal: nav2_msgs.action.DockRobot_Goal

class DockRobot_SendGoal_Response(Message):
    """nav2_msgs/action/DockRobot_SendGoal_Response"""
    def __init__(self, *, accepted: bool = ..., stamp: builtin_interfaces.msg.Time = ..., check_fields: bool = ...) -> None: ...
    accepted: bool
    stamp: builtin_interfaces.msg.Time

class DockRobot_SendGoal_Event(Message):
    """nav2_msgs/action/DockRobot_SendGoal_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[nav2_msgs.action.DockRobot_SendGoal_Request] = ..., response: Collection[nav2_msgs.action.DockRobot_SendGoal_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[nav2_msgs.action.DockRobot_SendGoal_Request]: ...
    @request.setter
    def request(self, value: Collection[nav2_msgs.action.DockRobot_SendGoal_Request]) -> None: ...
    @property
    def response(self) -> list[nav2_msgs.action.DockRobot_SendGoal_Response]: ...
    @response.setter
    def response(self, value: Collection[nav2_msgs.action.DockRobot_SendGoal_Response]) -> None: ...

class DockRobot_GetResult_Request(Message):
    """nav2_msgs/action/DockRobot_GetResult_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID

class DockRobot_GetResult_Response(Message):
    """nav2_msgs/action/DockRobot_GetResult_Response"""
    def __init__(self, *, status: int = ..., result: nav2_msgs.action.DockRobot_Result = ..., check_fields: bool = ...) -> None: ...
    status: int
    result: nav2_msgs.action.DockRobot_Result

class DockRobot_GetResult_Event(Message):
    """nav2_msgs/action/DockRobot_GetResult_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[nav2_msgs.action.DockRobot_GetResult_Request] = ..., response: Collection[nav2_msgs.action.DockRobot_GetResult_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[nav2_msgs.action.DockRobot_GetResult_Request]: ...
    @request.setter
    def request(self, value: Collection[nav2_msgs.action.DockRobot_GetResult_Request]) -> None: ...
    @property
    def response(self) -> list[nav2_msgs.action.DockRobot_GetResult_Response]: ...
    @response.setter
    def response(self, value: Collection[nav2_msgs.action.DockRobot_GetResult_Response]) -> None: ...

class DockRobot_SendGoal(Service):
    Request: TypeAlias = DockRobot_SendGoal_Request
    Response: TypeAlias = DockRobot_SendGoal_Response
    Event: TypeAlias = DockRobot_SendGoal_Event

class DockRobot_GetResult(Service):
    Request: TypeAlias = DockRobot_GetResult_Request
    Response: TypeAlias = DockRobot_GetResult_Response
    Event: TypeAlias = DockRobot_GetResult_Event

class DockRobot(Action):
    Goal: TypeAlias = DockRobot_Goal
    Result: TypeAlias = DockRobot_Result
    Feedback: TypeAlias = DockRobot_Feedback
    class Impl:
        SendGoalService: TypeAlias = DockRobot_SendGoal
        GetResultService: TypeAlias = DockRobot_GetResult
        FeedbackMessage: TypeAlias = DockRobot_FeedbackMessage
        CancelGoalService: TypeAlias = action_msgs.srv.CancelGoal
        GoalStatusMessage: TypeAlias = action_msgs.msg.GoalStatusArray

class DriveOnHeading_Goal(Message):
    """nav2_msgs/action/DriveOnHeading_Goal

    # Drives a robot straight ahead.

    geometry_msgs/Point target  # m, from where it is now; x counts
    float32 speed  # m/s
    builtin_interfaces/Duration time_allowance
    bool disable_collision_checks False
    """
    def __init__(self, *, target: geometry_msgs.msg.Point = ..., speed: float = ..., time_allowance: builtin_interfaces.msg.Duration = ..., disable_collision_checks: bool = ..., check_fields: bool = ...) -> None: ...
    target: geometry_msgs.msg.Point
    speed: float
    time_allowance: builtin_interfaces.msg.Duration
    disable_collision_checks: bool

class DriveOnHeading_Result(Message):
    """nav2_msgs/action/DriveOnHeading_Result

    uint16 NONE=0
    uint16 GOAL_REJECTED=1
    uint16 SEND_GOAL_FAILURE=2
    uint16 UNKNOWN=720
    uint16 TIMEOUT=721
    uint16 TF_ERROR=722
    uint16 COLLISION_AHEAD=723
    uint16 INVALID_INPUT=724
    builtin_interfaces/Duration total_elapsed_time
    uint16 error_code
    string error_msg
    """
    NONE: Final = 0
    GOAL_REJECTED: Final = 1
    SEND_GOAL_FAILURE: Final = 2
    UNKNOWN: Final = 720
    TIMEOUT: Final = 721
    TF_ERROR: Final = 722
    COLLISION_AHEAD: Final = 723
    INVALID_INPUT: Final = 724
    def __init__(self, *, total_elapsed_time: builtin_interfaces.msg.Duration = ..., error_code: int = ..., error_msg: str = ..., check_fields: bool = ...) -> None: ...
    total_elapsed_time: builtin_interfaces.msg.Duration
    error_code: int
    error_msg: str

class DriveOnHeading_Feedback(Message):
    """nav2_msgs/action/DriveOnHeading_Feedback

    float32 distance_traveled  # m
    """
    def __init__(self, *, distance_traveled: float = ..., check_fields: bool = ...) -> None: ...
    distance_traveled: float

class DriveOnHeading_FeedbackMessage(Message):
    """nav2_msgs/action/DriveOnHeading_FeedbackMessage"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., feedback: nav2_msgs.action.DriveOnHeading_Feedback = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    feedback: nav2_msgs.action.DriveOnHeading_Feedback

class DriveOnHeading_SendGoal_Request(Message):
    """nav2_msgs/action/DriveOnHeading_SendGoal_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., goal: nav2_msgs.action.DriveOnHeading_Goal = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    goal: nav2_msgs.action.DriveOnHeading_Goal

class DriveOnHeading_SendGoal_Response(Message):
    """nav2_msgs/action/DriveOnHeading_SendGoal_Response"""
    def __init__(self, *, accepted: bool = ..., stamp: builtin_interfaces.msg.Time = ..., check_fields: bool = ...) -> None: ...
    accepted: bool
    stamp: builtin_interfaces.msg.Time

class DriveOnHeading_SendGoal_Event(Message):
    """nav2_msgs/action/DriveOnHeading_SendGoal_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[nav2_msgs.action.DriveOnHeading_SendGoal_Request] = ..., response: Collection[nav2_msgs.action.DriveOnHeading_SendGoal_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[nav2_msgs.action.DriveOnHeading_SendGoal_Request]: ...
    @request.setter
    def request(self, value: Collection[nav2_msgs.action.DriveOnHeading_SendGoal_Request]) -> None: ...
    @property
    def response(self) -> list[nav2_msgs.action.DriveOnHeading_SendGoal_Response]: ...
    @response.setter
    def response(self, value: Collection[nav2_msgs.action.DriveOnHeading_SendGoal_Response]) -> None: ...

class DriveOnHeading_GetResult_Request(Message):
    """nav2_msgs/action/DriveOnHeading_GetResult_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID

class DriveOnHeading_GetResult_Response(Message):
    """nav2_msgs/action/DriveOnHeading_GetResult_Response"""
    def __init__(self, *, status: int = ..., result: nav2_msgs.action.DriveOnHeading_Result = ..., check_fields: bool = ...) -> None: ...
    status: int
    result: nav2_msgs.action.DriveOnHeading_Result

class DriveOnHeading_GetResult_Event(Message):
    """nav2_msgs/action/DriveOnHeading_GetResult_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[nav2_msgs.action.DriveOnHeading_GetResult_Request] = ..., response: Collection[nav2_msgs.action.DriveOnHeading_GetResult_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[nav2_msgs.action.DriveOnHeading_GetResult_Request]: ...
    @request.setter
    def request(self, value: Collection[nav2_msgs.action.DriveOnHeading_GetResult_Request]) -> None: ...
    @property
    def response(self) -> list[nav2_msgs.action.DriveOnHeading_GetResult_Response]: ...
    @response.setter
    def response(self, value: Collection[nav2_msgs.action.DriveOnHeading_GetResult_Response]) -> None: ...

class DriveOnHeading_SendGoal(Service):
    Request: TypeAlias = DriveOnHeading_SendGoal_Request
    Response: TypeAlias = DriveOnHeading_SendGoal_Response
    Event: TypeAlias = DriveOnHeading_SendGoal_Event

class DriveOnHeading_GetResult(Service):
    Request: TypeAlias = DriveOnHeading_GetResult_Request
    Response: TypeAlias = DriveOnHeading_GetResult_Response
    Event: TypeAlias = DriveOnHeading_GetResult_Event

class DriveOnHeading(Action):
    Goal: TypeAlias = DriveOnHeading_Goal
    Result: TypeAlias = DriveOnHeading_Result
    Feedback: TypeAlias = DriveOnHeading_Feedback
    class Impl:
        SendGoalService: TypeAlias = DriveOnHeading_SendGoal
        GetResultService: TypeAlias = DriveOnHeading_GetResult
        FeedbackMessage: TypeAlias = DriveOnHeading_FeedbackMessage
        CancelGoalService: TypeAlias = action_msgs.srv.CancelGoal
        GoalStatusMessage: TypeAlias = action_msgs.msg.GoalStatusArray

class DummyBehavior_Goal(Message):
    """nav2_msgs/action/DummyBehavior_Goal

    # Does nothing but what a test of behaviors tells it to.

    std_msgs/String command
    """
    def __init__(self, *, command: std_msgs.msg.String = ..., check_fields: bool = ...) -> None: ...
    command: std_msgs.msg.String

class DummyBehavior_Result(Message):
    """nav2_msgs/action/DummyBehavior_Result

    builtin_interfaces/Duration total_elapsed_time
    uint16 error_code
    string error_msg
    """
    def __init__(self, *, total_elapsed_time: builtin_interfaces.msg.Duration = ..., error_code: int = ..., error_msg: str = ..., check_fields: bool = ...) -> None: ...
    total_elapsed_time: builtin_interfaces.msg.Duration
    error_code: int
    error_msg: str

class DummyBehavior_Feedback(Message):
    """nav2_msgs/action/DummyBehavior_Feedback"""
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class DummyBehavior_FeedbackMessage(Message):
    """nav2_msgs/action/DummyBehavior_FeedbackMessage"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., feedback: nav2_msgs.action.DummyBehavior_Feedback = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    feedback: nav2_msgs.action.DummyBehavior_Feedback

class DummyBehavior_SendGoal_Request(Message):
    """nav2_msgs/action/DummyBehavior_SendGoal_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., goal: nav2_msgs.action.DummyBehavior_Goal = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    goal: nav2_msgs.action.DummyBehavior_Goal

class DummyBehavior_SendGoal_Response(Message):
    """nav2_msgs/action/DummyBehavior_SendGoal_Response"""
    def __init__(self, *, accepted: bool = ..., stamp: builtin_interfaces.msg.Time = ..., check_fields: bool = ...) -> None: ...
    accepted: bool
    stamp: builtin_interfaces.msg.Time

class DummyBehavior_SendGoal_Event(Message):
    """nav2_msgs/action/DummyBehavior_SendGoal_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[nav2_msgs.action.DummyBehavior_SendGoal_Request] = ..., response: Collection[nav2_msgs.action.DummyBehavior_SendGoal_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[nav2_msgs.action.DummyBehavior_SendGoal_Request]: ...
    @request.setter
    def request(self, value: Collection[nav2_msgs.action.DummyBehavior_SendGoal_Request]) -> None: ...
    @property
    def response(self) -> list[nav2_msgs.action.DummyBehavior_SendGoal_Response]: ...
    @response.setter
    def response(self, value: Collection[nav2_msgs.action.DummyBehavior_SendGoal_Response]) -> None: ...

class DummyBehavior_GetResult_Request(Message):
    """nav2_msgs/action/DummyBehavior_GetResult_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID

class DummyBehavior_GetResult_Response(Message):
    """nav2_msgs/action/DummyBehavior_GetResult_Response"""
    def __init__(self, *, status: int = ..., result: nav2_msgs.action.DummyBehavior_Result = ..., check_fields: bool = ...) -> None: ...
    status: int
    result: nav2_msgs.action.DummyBehavior_Result

class DummyBehavior_GetResult_Event(Message):
    """nav2_msgs/action/DummyBehavior_GetResult_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[nav2_msgs.action.DummyBehavior_GetResult_Request] = ..., response: Collection[nav2_msgs.action.DummyBehavior_GetResult_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[nav2_msgs.action.DummyBehavior_GetResult_Request]: ...
    @request.setter
    def request(self, value: Collection[nav2_msgs.action.DummyBehavior_GetResult_Request]) -> None: ...
    @property
    def response(self) -> list[nav2_msgs.action.DummyBehavior_GetResult_Response]: ...
    @response.setter
    def response(self, value: Collection[nav2_msgs.action.DummyBehavior_GetResult_Response]) -> None: ...

class DummyBehavior_SendGoal(Service):
    Request: TypeAlias = DummyBehavior_SendGoal_Request
    Response: TypeAlias = DummyBehavior_SendGoal_Response
    Event: TypeAlias = DummyBehavior_SendGoal_Event

class DummyBehavior_GetResult(Service):
    Request: TypeAlias = DummyBehavior_GetResult_Request
    Response: TypeAlias = DummyBehavior_GetResult_Response
    Event: TypeAlias = DummyBehavior_GetResult_Event

class DummyBehavior(Action):
    Goal: TypeAlias = DummyBehavior_Goal
    Result: TypeAlias = DummyBehavior_Result
    Feedback: TypeAlias = DummyBehavior_Feedback
    class Impl:
        SendGoalService: TypeAlias = DummyBehavior_SendGoal
        GetResultService: TypeAlias = DummyBehavior_GetResult
        FeedbackMessage: TypeAlias = DummyBehavior_FeedbackMessage
        CancelGoalService: TypeAlias = action_msgs.srv.CancelGoal
        GoalStatusMessage: TypeAlias = action_msgs.msg.GoalStatusArray

class FollowGPSWaypoints_Goal(Message):
    """nav2_msgs/action/FollowGPSWaypoints_Goal

    # Drives a robot to one place of the earth after the other, with something to do at each.

    uint32 number_of_loops
    uint32 goal_index 0  # where to begin
    geographic_msgs/GeoPose[] gps_poses
    """
    def __init__(self, *, number_of_loops: int = ..., goal_index: int = ..., gps_poses: Collection[geographic_msgs.msg.GeoPose] = ..., check_fields: bool = ...) -> None: ...
    number_of_loops: int
    goal_index: int
    @property
    def gps_poses(self) -> list[geographic_msgs.msg.GeoPose]: ...
    @gps_poses.setter
    def gps_poses(self, value: Collection[geographic_msgs.msg.GeoPose]) -> None: ...

class FollowGPSWaypoints_Result(Message):
    """nav2_msgs/action/FollowGPSWaypoints_Result

    uint16 NONE=0
    uint16 UNKNOWN=600
    uint16 TASK_EXECUTOR_FAILED=601
    uint16 NO_WAYPOINTS_GIVEN=602
    uint16 STOP_ON_MISSED_WAYPOINT=603
    WaypointStatus[] missed_waypoints
    int16 error_code
    string error_msg
    """
    NONE: Final = 0
    UNKNOWN: Final = 600
    TASK_EXECUTOR_FAILED: Final = 601
    NO_WAYPOINTS_GIVEN: Final = 602
    STOP_ON_MISSED_WAYPOINT: Final = 603
    def __init__(self, *, missed_waypoints: Collection[nav2_msgs.msg.WaypointStatus] = ..., error_code: int = ..., error_msg: str = ..., check_fields: bool = ...) -> None: ...
    @property
    def missed_waypoints(self) -> list[nav2_msgs.msg.WaypointStatus]: ...
    @missed_waypoints.setter
    def missed_waypoints(self, value: Collection[nav2_msgs.msg.WaypointStatus]) -> None: ...
    error_code: int
    error_msg: str

class FollowGPSWaypoints_Feedback(Message):
    """nav2_msgs/action/FollowGPSWaypoints_Feedback

    uint32 current_waypoint
    """
    def __init__(self, *, current_waypoint: int = ..., check_fields: bool = ...) -> None: ...
    current_waypoint: int

class FollowGPSWaypoints_FeedbackMessage(Message):
    """nav2_msgs/action/FollowGPSWaypoints_FeedbackMessage"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., feedback: nav2_msgs.action.FollowGPSWaypoints_Feedback = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    feedback: nav2_msgs.action.FollowGPSWaypoints_Feedback

class FollowGPSWaypoints_SendGoal_Request(Message):
    """nav2_msgs/action/FollowGPSWaypoints_SendGoal_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., goal: nav2_msgs.action.FollowGPSWaypoints_Goal = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    goal: nav2_msgs.action.FollowGPSWaypoints_Goal

class FollowGPSWaypoints_SendGoal_Response(Message):
    """nav2_msgs/action/FollowGPSWaypoints_SendGoal_Response"""
    def __init__(self, *, accepted: bool = ..., stamp: builtin_interfaces.msg.Time = ..., check_fields: bool = ...) -> None: ...
    accepted: bool
    stamp: builtin_interfaces.msg.Time

class FollowGPSWaypoints_SendGoal_Event(Message):
    """nav2_msgs/action/FollowGPSWaypoints_SendGoal_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[nav2_msgs.action.FollowGPSWaypoints_SendGoal_Request] = ..., response: Collection[nav2_msgs.action.FollowGPSWaypoints_SendGoal_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[nav2_msgs.action.FollowGPSWaypoints_SendGoal_Request]: ...
    @request.setter
    def request(self, value: Collection[nav2_msgs.action.FollowGPSWaypoints_SendGoal_Request]) -> None: ...
    @property
    def response(self) -> list[nav2_msgs.action.FollowGPSWaypoints_SendGoal_Response]: ...
    @response.setter
    def response(self, value: Collection[nav2_msgs.action.FollowGPSWaypoints_SendGoal_Response]) -> None: ...

class FollowGPSWaypoints_GetResult_Request(Message):
    """nav2_msgs/action/FollowGPSWaypoints_GetResult_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID

class FollowGPSWaypoints_GetResult_Response(Message):
    """nav2_msgs/action/FollowGPSWaypoints_GetResult_Response"""
    def __init__(self, *, status: int = ..., result: nav2_msgs.action.FollowGPSWaypoints_Result = ..., check_fields: bool = ...) -> None: ...
    status: int
    result: nav2_msgs.action.FollowGPSWaypoints_Result

class FollowGPSWaypoints_GetResult_Event(Message):
    """nav2_msgs/action/FollowGPSWaypoints_GetResult_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[nav2_msgs.action.FollowGPSWaypoints_GetResult_Request] = ..., response: Collection[nav2_msgs.action.FollowGPSWaypoints_GetResult_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[nav2_msgs.action.FollowGPSWaypoints_GetResult_Request]: ...
    @request.setter
    def request(self, value: Collection[nav2_msgs.action.FollowGPSWaypoints_GetResult_Request]) -> None: ...
    @property
    def response(self) -> list[nav2_msgs.action.FollowGPSWaypoints_GetResult_Response]: ...
    @response.setter
    def response(self, value: Collection[nav2_msgs.action.FollowGPSWaypoints_GetResult_Response]) -> None: ...

class FollowGPSWaypoints_SendGoal(Service):
    Request: TypeAlias = FollowGPSWaypoints_SendGoal_Request
    Response: TypeAlias = FollowGPSWaypoints_SendGoal_Response
    Event: TypeAlias = FollowGPSWaypoints_SendGoal_Event

class FollowGPSWaypoints_GetResult(Service):
    Request: TypeAlias = FollowGPSWaypoints_GetResult_Request
    Response: TypeAlias = FollowGPSWaypoints_GetResult_Response
    Event: TypeAlias = FollowGPSWaypoints_GetResult_Event

class FollowGPSWaypoints(Action):
    Goal: TypeAlias = FollowGPSWaypoints_Goal
    Result: TypeAlias = FollowGPSWaypoints_Result
    Feedback: TypeAlias = FollowGPSWaypoints_Feedback
    class Impl:
        SendGoalService: TypeAlias = FollowGPSWaypoints_SendGoal
        GetResultService: TypeAlias = FollowGPSWaypoints_GetResult
        FeedbackMessage: TypeAlias = FollowGPSWaypoints_FeedbackMessage
        CancelGoalService: TypeAlias = action_msgs.srv.CancelGoal
        GoalStatusMessage: TypeAlias = action_msgs.msg.GoalStatusArray

class FollowObject_Goal(Message):
    """nav2_msgs/action/FollowObject_Goal

    string pose_topic
    string tracked_frame
    builtin_interfaces/Duration max_duration
    """
    def __init__(self, *, pose_topic: str = ..., tracked_frame: str = ..., max_duration: builtin_interfaces.msg.Duration = ..., check_fields: bool = ...) -> None: ...
    pose_topic: str
    tracked_frame: str
    max_duration: builtin_interfaces.msg.Duration

class FollowObject_Result(Message):
    """nav2_msgs/action/FollowObject_Result

    uint16 NONE=0
    uint16 GOAL_REJECTED=1
    uint16 SEND_GOAL_FAILURE=2
    uint16 TF_ERROR=901
    uint16 FAILED_TO_DETECT_OBJECT=902
    uint16 FAILED_TO_CONTROL=903
    uint16 TIMEOUT=904
    uint16 UNKNOWN=999
    builtin_interfaces/Duration total_elapsed_time
    uint16 error_code 0
    uint16 num_retries 0
    string error_msg
    """
    NONE: Final = 0
    GOAL_REJECTED: Final = 1
    SEND_GOAL_FAILURE: Final = 2
    TF_ERROR: Final = 901
    FAILED_TO_DETECT_OBJECT: Final = 902
    FAILED_TO_CONTROL: Final = 903
    TIMEOUT: Final = 904
    UNKNOWN: Final = 999
    def __init__(self, *, total_elapsed_time: builtin_interfaces.msg.Duration = ..., error_code: int = ..., num_retries: int = ..., error_msg: str = ..., check_fields: bool = ...) -> None: ...
    total_elapsed_time: builtin_interfaces.msg.Duration
    error_code: int
    num_retries: int
    error_msg: str

class FollowObject_Feedback(Message):
    """nav2_msgs/action/FollowObject_Feedback

    uint16 NONE=0
    uint16 INITIAL_PERCEPTION=1
    uint16 CONTROLLING=2
    uint16 STOPPING=3
    uint16 RETRY=4
    uint16 state
    builtin_interfaces/Duration following_time
    uint16 num_retries 0
    """
    NONE: Final = 0
    INITIAL_PERCEPTION: Final = 1
    CONTROLLING: Final = 2
    STOPPING: Final = 3
    RETRY: Final = 4
    def __init__(self, *, state: int = ..., following_time: builtin_interfaces.msg.Duration = ..., num_retries: int = ..., check_fields: bool = ...) -> None: ...
    state: int
    following_time: builtin_interfaces.msg.Duration
    num_retries: int

class FollowObject_FeedbackMessage(Message):
    """nav2_msgs/action/FollowObject_FeedbackMessage"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., feedback: nav2_msgs.action.FollowObject_Feedback = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    feedback: nav2_msgs.action.FollowObject_Feedback

class FollowObject_SendGoal_Request(Message):
    """nav2_msgs/action/FollowObject_SendGoal_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., goal: nav2_msgs.action.FollowObject_Goal = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    goal: nav2_msgs.action.FollowObject_Goal

class FollowObject_SendGoal_Response(Message):
    """nav2_msgs/action/FollowObject_SendGoal_Response"""
    def __init__(self, *, accepted: bool = ..., stamp: builtin_interfaces.msg.Time = ..., check_fields: bool = ...) -> None: ...
    accepted: bool
    stamp: builtin_interfaces.msg.Time

class FollowObject_SendGoal_Event(Message):
    """nav2_msgs/action/FollowObject_SendGoal_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[nav2_msgs.action.FollowObject_SendGoal_Request] = ..., response: Collection[nav2_msgs.action.FollowObject_SendGoal_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[nav2_msgs.action.FollowObject_SendGoal_Request]: ...
    @request.setter
    def request(self, value: Collection[nav2_msgs.action.FollowObject_SendGoal_Request]) -> None: ...
    @property
    def response(self) -> list[nav2_msgs.action.FollowObject_SendGoal_Response]: ...
    @response.setter
    def response(self, value: Collection[nav2_msgs.action.FollowObject_SendGoal_Response]) -> None: ...

class FollowObject_GetResult_Request(Message):
    """nav2_msgs/action/FollowObject_GetResult_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID

class FollowObject_GetResult_Response(Message):
    """nav2_msgs/action/FollowObject_GetResult_Response"""
    def __init__(self, *, status: int = ..., result: nav2_msgs.action.FollowObject_Result = ..., check_fields: bool = ...) -> None: ...
    status: int
    result: nav2_msgs.action.FollowObject_Result

class FollowObject_GetResult_Event(Message):
    """nav2_msgs/action/FollowObject_GetResult_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[nav2_msgs.action.FollowObject_GetResult_Request] = ..., response: Collection[nav2_msgs.action.FollowObject_GetResult_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[nav2_msgs.action.FollowObject_GetResult_Request]: ...
    @request.setter
    def request(self, value: Collection[nav2_msgs.action.FollowObject_GetResult_Request]) -> None: ...
    @property
    def response(self) -> list[nav2_msgs.action.FollowObject_GetResult_Response]: ...
    @response.setter
    def response(self, value: Collection[nav2_msgs.action.FollowObject_GetResult_Response]) -> None: ...

class FollowObject_SendGoal(Service):
    Request: TypeAlias = FollowObject_SendGoal_Request
    Response: TypeAlias = FollowObject_SendGoal_Response
    Event: TypeAlias = FollowObject_SendGoal_Event

class FollowObject_GetResult(Service):
    Request: TypeAlias = FollowObject_GetResult_Request
    Response: TypeAlias = FollowObject_GetResult_Response
    Event: TypeAlias = FollowObject_GetResult_Event

class FollowObject(Action):
    Goal: TypeAlias = FollowObject_Goal
    Result: TypeAlias = FollowObject_Result
    Feedback: TypeAlias = FollowObject_Feedback
    class Impl:
        SendGoalService: TypeAlias = FollowObject_SendGoal
        GetResultService: TypeAlias = FollowObject_GetResult
        FeedbackMessage: TypeAlias = FollowObject_FeedbackMessage
        CancelGoalService: TypeAlias = action_msgs.srv.CancelGoal
        GoalStatusMessage: TypeAlias = action_msgs.msg.GoalStatusArray

class FollowPath_Goal(Message):
    """nav2_msgs/action/FollowPath_Goal

    # Drives a robot along a path.

    nav_msgs/Path path
    string controller_id
    string goal_checker_id
    string progress_checker_id
    string path_handler_id
    """
    def __init__(self, *, path: nav_msgs.msg.Path = ..., controller_id: str = ..., goal_checker_id: str = ..., progress_checker_id: str = ..., path_handler_id: str = ..., check_fields: bool = ...) -> None: ...
    path: nav_msgs.msg.Path
    controller_id: str
    goal_checker_id: str
    progress_checker_id: str
    path_handler_id: str

class FollowPath_Result(Message):
    """nav2_msgs/action/FollowPath_Result

    uint16 NONE=0
    uint16 GOAL_REJECTED=1
    uint16 SEND_GOAL_FAILURE=2
    uint16 UNKNOWN=100
    uint16 INVALID_CONTROLLER=101
    uint16 TF_ERROR=102
    uint16 INVALID_PATH=103
    uint16 PATIENCE_EXCEEDED=104
    uint16 FAILED_TO_MAKE_PROGRESS=105
    uint16 NO_VALID_CONTROL=106
    uint16 CONTROLLER_TIMED_OUT=107
    uint16 TIMEOUT=108
    std_msgs/Empty result
    uint16 error_code
    string error_msg
    """
    NONE: Final = 0
    GOAL_REJECTED: Final = 1
    SEND_GOAL_FAILURE: Final = 2
    UNKNOWN: Final = 100
    INVALID_CONTROLLER: Final = 101
    TF_ERROR: Final = 102
    INVALID_PATH: Final = 103
    PATIENCE_EXCEEDED: Final = 104
    FAILED_TO_MAKE_PROGRESS: Final = 105
    NO_VALID_CONTROL: Final = 106
    CONTROLLER_TIMED_OUT: Final = 107
    TIMEOUT: Final = 108
    def __init__(self, *, result: std_msgs.msg.Empty = ..., error_code: int = ..., error_msg: str = ..., check_fields: bool = ...) -> None: ...
    result: std_msgs.msg.Empty
    error_code: int
    error_msg: str

class FollowPath_Feedback(Message):
    """nav2_msgs/action/FollowPath_Feedback

    nav2_msgs/TrackingFeedback tracking_feedback
    """
    def __init__(self, *, tracking_feedback: nav2_msgs.msg.TrackingFeedback = ..., check_fields: bool = ...) -> None: ...
    tracking_feedback: nav2_msgs.msg.TrackingFeedback

class FollowPath_FeedbackMessage(Message):
    """nav2_msgs/action/FollowPath_FeedbackMessage"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., feedback: nav2_msgs.action.FollowPath_Feedback = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    feedback: nav2_msgs.action.FollowPath_Feedback

class FollowPath_SendGoal_Request(Message):
    """nav2_msgs/action/FollowPath_SendGoal_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., goal: nav2_msgs.action.FollowPath_Goal = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    goal: nav2_msgs.action.FollowPath_Goal

class FollowPath_SendGoal_Response(Message):
    """nav2_msgs/action/FollowPath_SendGoal_Response"""
    def __init__(self, *, accepted: bool = ..., stamp: builtin_interfaces.msg.Time = ..., check_fields: bool = ...) -> None: ...
    accepted: bool
    stamp: builtin_interfaces.msg.Time

class FollowPath_SendGoal_Event(Message):
    """nav2_msgs/action/FollowPath_SendGoal_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[nav2_msgs.action.FollowPath_SendGoal_Request] = ..., response: Collection[nav2_msgs.action.FollowPath_SendGoal_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[nav2_msgs.action.FollowPath_SendGoal_Request]: ...
    @request.setter
    def request(self, value: Collection[nav2_msgs.action.FollowPath_SendGoal_Request]) -> None: ...
    @property
    def response(self) -> list[nav2_msgs.action.FollowPath_SendGoal_Response]: ...
    @response.setter
    def response(self, value: Collection[nav2_msgs.action.FollowPath_SendGoal_Response]) -> None: ...

class FollowPath_GetResult_Request(Message):
    """nav2_msgs/action/FollowPath_GetResult_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID

class FollowPath_GetResult_Response(Message):
    """nav2_msgs/action/FollowPath_GetResult_Response"""
    def __init__(self, *, status: int = ..., result: nav2_msgs.action.FollowPath_Result = ..., check_fields: bool = ...) -> None: ...
    status: int
    result: nav2_msgs.action.FollowPath_Result

class FollowPath_GetResult_Event(Message):
    """nav2_msgs/action/FollowPath_GetResult_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[nav2_msgs.action.FollowPath_GetResult_Request] = ..., response: Collection[nav2_msgs.action.FollowPath_GetResult_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[nav2_msgs.action.FollowPath_GetResult_Request]: ...
    @request.setter
    def request(self, value: Collection[nav2_msgs.action.FollowPath_GetResult_Request]) -> None: ...
    @property
    def response(self) -> list[nav2_msgs.action.FollowPath_GetResult_Response]: ...
    @response.setter
    def response(self, value: Collection[nav2_msgs.action.FollowPath_GetResult_Response]) -> None: ...

class FollowPath_SendGoal(Service):
    Request: TypeAlias = FollowPath_SendGoal_Request
    Response: TypeAlias = FollowPath_SendGoal_Response
    Event: TypeAlias = FollowPath_SendGoal_Event

class FollowPath_GetResult(Service):
    Request: TypeAlias = FollowPath_GetResult_Request
    Response: TypeAlias = FollowPath_GetResult_Response
    Event: TypeAlias = FollowPath_GetResult_Event

class FollowPath(Action):
    Goal: TypeAlias = FollowPath_Goal
    Result: TypeAlias = FollowPath_Result
    Feedback: TypeAlias = FollowPath_Feedback
    class Impl:
        SendGoalService: TypeAlias = FollowPath_SendGoal
        GetResultService: TypeAlias = FollowPath_GetResult
        FeedbackMessage: TypeAlias = FollowPath_FeedbackMessage
        CancelGoalService: TypeAlias = action_msgs.srv.CancelGoal
        GoalStatusMessage: TypeAlias = action_msgs.msg.GoalStatusArray

class FollowWaypoints_Goal(Message):
    """nav2_msgs/action/FollowWaypoints_Goal

    # Drives a robot to one place after the other, with something to do at each.

    uint32 number_of_loops
    uint32 goal_index 0  # where to begin
    geometry_msgs/PoseStamped[] poses
    """
    def __init__(self, *, number_of_loops: int = ..., goal_index: int = ..., poses: Collection[geometry_msgs.msg.PoseStamped] = ..., check_fields: bool = ...) -> None: ...
    number_of_loops: int
    goal_index: int
    @property
    def poses(self) -> list[geometry_msgs.msg.PoseStamped]: ...
    @poses.setter
    def poses(self, value: Collection[geometry_msgs.msg.PoseStamped]) -> None: ...

class FollowWaypoints_Result(Message):
    """nav2_msgs/action/FollowWaypoints_Result

    uint16 NONE=0
    uint16 UNKNOWN=600
    uint16 TASK_EXECUTOR_FAILED=601
    uint16 NO_VALID_WAYPOINTS=602
    uint16 STOP_ON_MISSED_WAYPOINT=603
    WaypointStatus[] missed_waypoints
    uint16 error_code
    string error_msg
    """
    NONE: Final = 0
    UNKNOWN: Final = 600
    TASK_EXECUTOR_FAILED: Final = 601
    NO_VALID_WAYPOINTS: Final = 602
    STOP_ON_MISSED_WAYPOINT: Final = 603
    def __init__(self, *, missed_waypoints: Collection[nav2_msgs.msg.WaypointStatus] = ..., error_code: int = ..., error_msg: str = ..., check_fields: bool = ...) -> None: ...
    @property
    def missed_waypoints(self) -> list[nav2_msgs.msg.WaypointStatus]: ...
    @missed_waypoints.setter
    def missed_waypoints(self, value: Collection[nav2_msgs.msg.WaypointStatus]) -> None: ...
    error_code: int
    error_msg: str

class FollowWaypoints_Feedback(Message):
    """nav2_msgs/action/FollowWaypoints_Feedback

    uint32 current_waypoint
    """
    def __init__(self, *, current_waypoint: int = ..., check_fields: bool = ...) -> None: ...
    current_waypoint: int

class FollowWaypoints_FeedbackMessage(Message):
    """nav2_msgs/action/FollowWaypoints_FeedbackMessage"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., feedback: nav2_msgs.action.FollowWaypoints_Feedback = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    feedback: nav2_msgs.action.FollowWaypoints_Feedback

class FollowWaypoints_SendGoal_Request(Message):
    """nav2_msgs/action/FollowWaypoints_SendGoal_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., goal: nav2_msgs.action.FollowWaypoints_Goal = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    goal: nav2_msgs.action.FollowWaypoints_Goal

class FollowWaypoints_SendGoal_Response(Message):
    """nav2_msgs/action/FollowWaypoints_SendGoal_Response"""
    def __init__(self, *, accepted: bool = ..., stamp: builtin_interfaces.msg.Time = ..., check_fields: bool = ...) -> None: ...
    accepted: bool
    stamp: builtin_interfaces.msg.Time

class FollowWaypoints_SendGoal_Event(Message):
    """nav2_msgs/action/FollowWaypoints_SendGoal_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[nav2_msgs.action.FollowWaypoints_SendGoal_Request] = ..., response: Collection[nav2_msgs.action.FollowWaypoints_SendGoal_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[nav2_msgs.action.FollowWaypoints_SendGoal_Request]: ...
    @request.setter
    def request(self, value: Collection[nav2_msgs.action.FollowWaypoints_SendGoal_Request]) -> None: ...
    @property
    def response(self) -> list[nav2_msgs.action.FollowWaypoints_SendGoal_Response]: ...
    @response.setter
    def response(self, value: Collection[nav2_msgs.action.FollowWaypoints_SendGoal_Response]) -> None: ...

class FollowWaypoints_GetResult_Request(Message):
    """nav2_msgs/action/FollowWaypoints_GetResult_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID

class FollowWaypoints_GetResult_Response(Message):
    """nav2_msgs/action/FollowWaypoints_GetResult_Response"""
    def __init__(self, *, status: int = ..., result: nav2_msgs.action.FollowWaypoints_Result = ..., check_fields: bool = ...) -> None: ...
    status: int
    result: nav2_msgs.action.FollowWaypoints_Result

class FollowWaypoints_GetResult_Event(Message):
    """nav2_msgs/action/FollowWaypoints_GetResult_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[nav2_msgs.action.FollowWaypoints_GetResult_Request] = ..., response: Collection[nav2_msgs.action.FollowWaypoints_GetResult_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[nav2_msgs.action.FollowWaypoints_GetResult_Request]: ...
    @request.setter
    def request(self, value: Collection[nav2_msgs.action.FollowWaypoints_GetResult_Request]) -> None: ...
    @property
    def response(self) -> list[nav2_msgs.action.FollowWaypoints_GetResult_Response]: ...
    @response.setter
    def response(self, value: Collection[nav2_msgs.action.FollowWaypoints_GetResult_Response]) -> None: ...

class FollowWaypoints_SendGoal(Service):
    Request: TypeAlias = FollowWaypoints_SendGoal_Request
    Response: TypeAlias = FollowWaypoints_SendGoal_Response
    Event: TypeAlias = FollowWaypoints_SendGoal_Event

class FollowWaypoints_GetResult(Service):
    Request: TypeAlias = FollowWaypoints_GetResult_Request
    Response: TypeAlias = FollowWaypoints_GetResult_Response
    Event: TypeAlias = FollowWaypoints_GetResult_Event

class FollowWaypoints(Action):
    Goal: TypeAlias = FollowWaypoints_Goal
    Result: TypeAlias = FollowWaypoints_Result
    Feedback: TypeAlias = FollowWaypoints_Feedback
    class Impl:
        SendGoalService: TypeAlias = FollowWaypoints_SendGoal
        GetResultService: TypeAlias = FollowWaypoints_GetResult
        FeedbackMessage: TypeAlias = FollowWaypoints_FeedbackMessage
        CancelGoalService: TypeAlias = action_msgs.srv.CancelGoal
        GoalStatusMessage: TypeAlias = action_msgs.msg.GoalStatusArray

class NavigateThroughPoses_Goal(Message):
    """nav2_msgs/action/NavigateThroughPoses_Goal

    # Drives a robot through places to the last of them.

    nav_msgs/Goals poses
    string behavior_tree  # a file; empty: the default
    """
    def __init__(self, *, poses: nav_msgs.msg.Goals = ..., behavior_tree: str = ..., check_fields: bool = ...) -> None: ...
    poses: nav_msgs.msg.Goals
    behavior_tree: str

class NavigateThroughPoses_Result(Message):
    """nav2_msgs/action/NavigateThroughPoses_Result

    uint16 NONE=0
    uint16 GOAL_REJECTED=1
    uint16 SEND_GOAL_FAILURE=2
    uint16 UNKNOWN=9100
    uint16 FAILED_TO_LOAD_BEHAVIOR_TREE=9101
    uint16 TF_ERROR=9102
    uint16 TIMEOUT=9103
    uint16 error_code
    string error_msg
    WaypointStatus[] waypoint_statuses
    """
    NONE: Final = 0
    GOAL_REJECTED: Final = 1
    SEND_GOAL_FAILURE: Final = 2
    UNKNOWN: Final = 9100
    FAILED_TO_LOAD_BEHAVIOR_TREE: Final = 9101
    TF_ERROR: Final = 9102
    TIMEOUT: Final = 9103
    def __init__(self, *, error_code: int = ..., error_msg: str = ..., waypoint_statuses: Collection[nav2_msgs.msg.WaypointStatus] = ..., check_fields: bool = ...) -> None: ...
    error_code: int
    error_msg: str
    @property
    def waypoint_statuses(self) -> list[nav2_msgs.msg.WaypointStatus]: ...
    @waypoint_statuses.setter
    def waypoint_statuses(self, value: Collection[nav2_msgs.msg.WaypointStatus]) -> None: ...

class NavigateThroughPoses_Feedback(Message):
    """nav2_msgs/action/NavigateThroughPoses_Feedback

    geometry_msgs/PoseStamped current_pose
    builtin_interfaces/Duration navigation_time
    builtin_interfaces/Duration estimated_time_remaining
    int16 number_of_recoveries
    float32 distance_remaining  # m
    float32 position_tracking_error
    float32 heading_tracking_error
    int16 number_of_poses_remaining
    WaypointStatus[] waypoint_statuses
    """
    def __init__(self, *, current_pose: geometry_msgs.msg.PoseStamped = ..., navigation_time: builtin_interfaces.msg.Duration = ..., estimated_time_remaining: builtin_interfaces.msg.Duration = ..., number_of_recoveries: int = ..., distance_remaining: float = ..., position_tracking_error: float = ..., heading_tracking_error: float = ..., number_of_poses_remaining: int = ..., waypoint_statuses: Collection[nav2_msgs.msg.WaypointStatus] = ..., check_fields: bool = ...) -> None: ...
    current_pose: geometry_msgs.msg.PoseStamped
    navigation_time: builtin_interfaces.msg.Duration
    estimated_time_remaining: builtin_interfaces.msg.Duration
    number_of_recoveries: int
    distance_remaining: float
    position_tracking_error: float
    heading_tracking_error: float
    number_of_poses_remaining: int
    @property
    def waypoint_statuses(self) -> list[nav2_msgs.msg.WaypointStatus]: ...
    @waypoint_statuses.setter
    def waypoint_statuses(self, value: Collection[nav2_msgs.msg.WaypointStatus]) -> None: ...

class NavigateThroughPoses_FeedbackMessage(Message):
    """nav2_msgs/action/NavigateThroughPoses_FeedbackMessage"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., feedback: nav2_msgs.action.NavigateThroughPoses_Feedback = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    feedback: nav2_msgs.action.NavigateThroughPoses_Feedback

class NavigateThroughPoses_SendGoal_Request(Message):
    """nav2_msgs/action/NavigateThroughPoses_SendGoal_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., goal: nav2_msgs.action.NavigateThroughPoses_Goal = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    goal: nav2_msgs.action.NavigateThroughPoses_Goal

class NavigateThroughPoses_SendGoal_Response(Message):
    """nav2_msgs/action/NavigateThroughPoses_SendGoal_Response"""
    def __init__(self, *, accepted: bool = ..., stamp: builtin_interfaces.msg.Time = ..., check_fields: bool = ...) -> None: ...
    accepted: bool
    stamp: builtin_interfaces.msg.Time

class NavigateThroughPoses_SendGoal_Event(Message):
    """nav2_msgs/action/NavigateThroughPoses_SendGoal_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[nav2_msgs.action.NavigateThroughPoses_SendGoal_Request] = ..., response: Collection[nav2_msgs.action.NavigateThroughPoses_SendGoal_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[nav2_msgs.action.NavigateThroughPoses_SendGoal_Request]: ...
    @request.setter
    def request(self, value: Collection[nav2_msgs.action.NavigateThroughPoses_SendGoal_Request]) -> None: ...
    @property
    def response(self) -> list[nav2_msgs.action.NavigateThroughPoses_SendGoal_Response]: ...
    @response.setter
    def response(self, value: Collection[nav2_msgs.action.NavigateThroughPoses_SendGoal_Response]) -> None: ...

class NavigateThroughPoses_GetResult_Request(Message):
    """nav2_msgs/action/NavigateThroughPoses_GetResult_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID

class NavigateThroughPoses_GetResult_Response(Message):
    """nav2_msgs/action/NavigateThroughPoses_GetResult_Response"""
    def __init__(self, *, status: int = ..., result: nav2_msgs.action.NavigateThroughPoses_Result = ..., check_fields: bool = ...) -> None: ...
    status: int
    result: nav2_msgs.action.NavigateThroughPoses_Result

class NavigateThroughPoses_GetResult_Event(Message):
    """nav2_msgs/action/NavigateThroughPoses_GetResult_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[nav2_msgs.action.NavigateThroughPoses_GetResult_Request] = ..., response: Collection[nav2_msgs.action.NavigateThroughPoses_GetResult_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[nav2_msgs.action.NavigateThroughPoses_GetResult_Request]: ...
    @request.setter
    def request(self, value: Collection[nav2_msgs.action.NavigateThroughPoses_GetResult_Request]) -> None: ...
    @property
    def response(self) -> list[nav2_msgs.action.NavigateThroughPoses_GetResult_Response]: ...
    @response.setter
    def response(self, value: Collection[nav2_msgs.action.NavigateThroughPoses_GetResult_Response]) -> None: ...

class NavigateThroughPoses_SendGoal(Service):
    Request: TypeAlias = NavigateThroughPoses_SendGoal_Request
    Response: TypeAlias = NavigateThroughPoses_SendGoal_Response
    Event: TypeAlias = NavigateThroughPoses_SendGoal_Event

class NavigateThroughPoses_GetResult(Service):
    Request: TypeAlias = NavigateThroughPoses_GetResult_Request
    Response: TypeAlias = NavigateThroughPoses_GetResult_Response
    Event: TypeAlias = NavigateThroughPoses_GetResult_Event

class NavigateThroughPoses(Action):
    Goal: TypeAlias = NavigateThroughPoses_Goal
    Result: TypeAlias = NavigateThroughPoses_Result
    Feedback: TypeAlias = NavigateThroughPoses_Feedback
    class Impl:
        SendGoalService: TypeAlias = NavigateThroughPoses_SendGoal
        GetResultService: TypeAlias = NavigateThroughPoses_GetResult
        FeedbackMessage: TypeAlias = NavigateThroughPoses_FeedbackMessage
        CancelGoalService: TypeAlias = action_msgs.srv.CancelGoal
        GoalStatusMessage: TypeAlias = action_msgs.msg.GoalStatusArray

class NavigateToPose_Goal(Message):
    """nav2_msgs/action/NavigateToPose_Goal

    # Drives a robot to a place.

    geometry_msgs/PoseStamped pose
    string behavior_tree  # a file; empty: the default
    """
    def __init__(self, *, pose: geometry_msgs.msg.PoseStamped = ..., behavior_tree: str = ..., check_fields: bool = ...) -> None: ...
    pose: geometry_msgs.msg.PoseStamped
    behavior_tree: str

class NavigateToPose_Result(Message):
    """nav2_msgs/action/NavigateToPose_Result

    uint16 NONE=0
    uint16 GOAL_REJECTED=1
    uint16 SEND_GOAL_FAILURE=2
    uint16 UNKNOWN=9000
    uint16 FAILED_TO_LOAD_BEHAVIOR_TREE=9001
    uint16 TF_ERROR=9002
    uint16 TIMEOUT=9003
    uint16 error_code
    string error_msg
    """
    NONE: Final = 0
    GOAL_REJECTED: Final = 1
    SEND_GOAL_FAILURE: Final = 2
    UNKNOWN: Final = 9000
    FAILED_TO_LOAD_BEHAVIOR_TREE: Final = 9001
    TF_ERROR: Final = 9002
    TIMEOUT: Final = 9003
    def __init__(self, *, error_code: int = ..., error_msg: str = ..., check_fields: bool = ...) -> None: ...
    error_code: int
    error_msg: str

class NavigateToPose_Feedback(Message):
    """nav2_msgs/action/NavigateToPose_Feedback

    geometry_msgs/PoseStamped current_pose
    builtin_interfaces/Duration navigation_time
    builtin_interfaces/Duration estimated_time_remaining
    int16 number_of_recoveries
    float32 distance_remaining  # m
    float32 position_tracking_error
    float32 heading_tracking_error
    """
    def __init__(self, *, current_pose: geometry_msgs.msg.PoseStamped = ..., navigation_time: builtin_interfaces.msg.Duration = ..., estimated_time_remaining: builtin_interfaces.msg.Duration = ..., number_of_recoveries: int = ..., distance_remaining: float = ..., position_tracking_error: float = ..., heading_tracking_error: float = ..., check_fields: bool = ...) -> None: ...
    current_pose: geometry_msgs.msg.PoseStamped
    navigation_time: builtin_interfaces.msg.Duration
    estimated_time_remaining: builtin_interfaces.msg.Duration
    number_of_recoveries: int
    distance_remaining: float
    position_tracking_error: float
    heading_tracking_error: float

class NavigateToPose_FeedbackMessage(Message):
    """nav2_msgs/action/NavigateToPose_FeedbackMessage"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., feedback: nav2_msgs.action.NavigateToPose_Feedback = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    feedback: nav2_msgs.action.NavigateToPose_Feedback

class NavigateToPose_SendGoal_Request(Message):
    """nav2_msgs/action/NavigateToPose_SendGoal_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., goal: nav2_msgs.action.NavigateToPose_Goal = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    goal: nav2_msgs.action.NavigateToPose_Goal

class NavigateToPose_SendGoal_Response(Message):
    """nav2_msgs/action/NavigateToPose_SendGoal_Response"""
    def __init__(self, *, accepted: bool = ..., stamp: builtin_interfaces.msg.Time = ..., check_fields: bool = ...) -> None: ...
    accepted: bool
    stamp: builtin_interfaces.msg.Time

class NavigateToPose_SendGoal_Event(Message):
    """nav2_msgs/action/NavigateToPose_SendGoal_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[nav2_msgs.action.NavigateToPose_SendGoal_Request] = ..., response: Collection[nav2_msgs.action.NavigateToPose_SendGoal_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[nav2_msgs.action.NavigateToPose_SendGoal_Request]: ...
    @request.setter
    def request(self, value: Collection[nav2_msgs.action.NavigateToPose_SendGoal_Request]) -> None: ...
    @property
    def response(self) -> list[nav2_msgs.action.NavigateToPose_SendGoal_Response]: ...
    @response.setter
    def response(self, value: Collection[nav2_msgs.action.NavigateToPose_SendGoal_Response]) -> None: ...

class NavigateToPose_GetResult_Request(Message):
    """nav2_msgs/action/NavigateToPose_GetResult_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID

class NavigateToPose_GetResult_Response(Message):
    """nav2_msgs/action/NavigateToPose_GetResult_Response"""
    def __init__(self, *, status: int = ..., result: nav2_msgs.action.NavigateToPose_Result = ..., check_fields: bool = ...) -> None: ...
    status: int
    result: nav2_msgs.action.NavigateToPose_Result

class NavigateToPose_GetResult_Event(Message):
    """nav2_msgs/action/NavigateToPose_GetResult_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[nav2_msgs.action.NavigateToPose_GetResult_Request] = ..., response: Collection[nav2_msgs.action.NavigateToPose_GetResult_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[nav2_msgs.action.NavigateToPose_GetResult_Request]: ...
    @request.setter
    def request(self, value: Collection[nav2_msgs.action.NavigateToPose_GetResult_Request]) -> None: ...
    @property
    def response(self) -> list[nav2_msgs.action.NavigateToPose_GetResult_Response]: ...
    @response.setter
    def response(self, value: Collection[nav2_msgs.action.NavigateToPose_GetResult_Response]) -> None: ...

class NavigateToPose_SendGoal(Service):
    Request: TypeAlias = NavigateToPose_SendGoal_Request
    Response: TypeAlias = NavigateToPose_SendGoal_Response
    Event: TypeAlias = NavigateToPose_SendGoal_Event

class NavigateToPose_GetResult(Service):
    Request: TypeAlias = NavigateToPose_GetResult_Request
    Response: TypeAlias = NavigateToPose_GetResult_Response
    Event: TypeAlias = NavigateToPose_GetResult_Event

class NavigateToPose(Action):
    Goal: TypeAlias = NavigateToPose_Goal
    Result: TypeAlias = NavigateToPose_Result
    Feedback: TypeAlias = NavigateToPose_Feedback
    class Impl:
        SendGoalService: TypeAlias = NavigateToPose_SendGoal
        GetResultService: TypeAlias = NavigateToPose_GetResult
        FeedbackMessage: TypeAlias = NavigateToPose_FeedbackMessage
        CancelGoalService: TypeAlias = action_msgs.srv.CancelGoal
        GoalStatusMessage: TypeAlias = action_msgs.msg.GoalStatusArray

class SmoothPath_Goal(Message):
    """nav2_msgs/action/SmoothPath_Goal

    # Takes the corners off a path.

    nav_msgs/Path path
    string smoother_id
    builtin_interfaces/Duration max_smoothing_duration
    bool check_for_collisions
    """
    def __init__(self, *, path: nav_msgs.msg.Path = ..., smoother_id: str = ..., max_smoothing_duration: builtin_interfaces.msg.Duration = ..., check_for_collisions: bool = ..., check_fields: bool = ...) -> None: ...
    path: nav_msgs.msg.Path
    smoother_id: str
    max_smoothing_duration: builtin_interfaces.msg.Duration
    check_for_collisions: bool

class SmoothPath_Result(Message):
    """nav2_msgs/action/SmoothPath_Result

    uint16 NONE=0
    uint16 GOAL_REJECTED=1
    uint16 SEND_GOAL_FAILURE=2
    uint16 UNKNOWN=500
    uint16 INVALID_SMOOTHER=501
    uint16 TIMEOUT=502
    uint16 SMOOTHED_PATH_IN_COLLISION=503
    uint16 FAILED_TO_SMOOTH_PATH=504
    uint16 INVALID_PATH=505
    nav_msgs/Path path
    builtin_interfaces/Duration smoothing_duration
    bool was_completed
    uint16 error_code
    string error_msg
    """
    NONE: Final = 0
    GOAL_REJECTED: Final = 1
    SEND_GOAL_FAILURE: Final = 2
    UNKNOWN: Final = 500
    INVALID_SMOOTHER: Final = 501
    TIMEOUT: Final = 502
    SMOOTHED_PATH_IN_COLLISION: Final = 503
    FAILED_TO_SMOOTH_PATH: Final = 504
    INVALID_PATH: Final = 505
    def __init__(self, *, path: nav_msgs.msg.Path = ..., smoothing_duration: builtin_interfaces.msg.Duration = ..., was_completed: bool = ..., error_code: int = ..., error_msg: str = ..., check_fields: bool = ...) -> None: ...
    path: nav_msgs.msg.Path
    smoothing_duration: builtin_interfaces.msg.Duration
    was_completed: bool
    error_code: int
    error_msg: str

class SmoothPath_Feedback(Message):
    """nav2_msgs/action/SmoothPath_Feedback"""
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class SmoothPath_FeedbackMessage(Message):
    """nav2_msgs/action/SmoothPath_FeedbackMessage"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., feedback: nav2_msgs.action.SmoothPath_Feedback = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    feedback: nav2_msgs.action.SmoothPath_Feedback

class SmoothPath_SendGoal_Request(Message):
    """nav2_msgs/action/SmoothPath_SendGoal_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., goal: nav2_msgs.action.SmoothPath_Goal = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    goal: nav2_msgs.action.SmoothPath_Goal

class SmoothPath_SendGoal_Response(Message):
    """nav2_msgs/action/SmoothPath_SendGoal_Response"""
    def __init__(self, *, accepted: bool = ..., stamp: builtin_interfaces.msg.Time = ..., check_fields: bool = ...) -> None: ...
    accepted: bool
    stamp: builtin_interfaces.msg.Time

class SmoothPath_SendGoal_Event(Message):
    """nav2_msgs/action/SmoothPath_SendGoal_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[nav2_msgs.action.SmoothPath_SendGoal_Request] = ..., response: Collection[nav2_msgs.action.SmoothPath_SendGoal_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[nav2_msgs.action.SmoothPath_SendGoal_Request]: ...
    @request.setter
    def request(self, value: Collection[nav2_msgs.action.SmoothPath_SendGoal_Request]) -> None: ...
    @property
    def response(self) -> list[nav2_msgs.action.SmoothPath_SendGoal_Response]: ...
    @response.setter
    def response(self, value: Collection[nav2_msgs.action.SmoothPath_SendGoal_Response]) -> None: ...

class SmoothPath_GetResult_Request(Message):
    """nav2_msgs/action/SmoothPath_GetResult_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID

class SmoothPath_GetResult_Response(Message):
    """nav2_msgs/action/SmoothPath_GetResult_Response"""
    def __init__(self, *, status: int = ..., result: nav2_msgs.action.SmoothPath_Result = ..., check_fields: bool = ...) -> None: ...
    status: int
    result: nav2_msgs.action.SmoothPath_Result

class SmoothPath_GetResult_Event(Message):
    """nav2_msgs/action/SmoothPath_GetResult_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[nav2_msgs.action.SmoothPath_GetResult_Request] = ..., response: Collection[nav2_msgs.action.SmoothPath_GetResult_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[nav2_msgs.action.SmoothPath_GetResult_Request]: ...
    @request.setter
    def request(self, value: Collection[nav2_msgs.action.SmoothPath_GetResult_Request]) -> None: ...
    @property
    def response(self) -> list[nav2_msgs.action.SmoothPath_GetResult_Response]: ...
    @response.setter
    def response(self, value: Collection[nav2_msgs.action.SmoothPath_GetResult_Response]) -> None: ...

class SmoothPath_SendGoal(Service):
    Request: TypeAlias = SmoothPath_SendGoal_Request
    Response: TypeAlias = SmoothPath_SendGoal_Response
    Event: TypeAlias = SmoothPath_SendGoal_Event

class SmoothPath_GetResult(Service):
    Request: TypeAlias = SmoothPath_GetResult_Request
    Response: TypeAlias = SmoothPath_GetResult_Response
    Event: TypeAlias = SmoothPath_GetResult_Event

class SmoothPath(Action):
    Goal: TypeAlias = SmoothPath_Goal
    Result: TypeAlias = SmoothPath_Result
    Feedback: TypeAlias = SmoothPath_Feedback
    class Impl:
        SendGoalService: TypeAlias = SmoothPath_SendGoal
        GetResultService: TypeAlias = SmoothPath_GetResult
        FeedbackMessage: TypeAlias = SmoothPath_FeedbackMessage
        CancelGoalService: TypeAlias = action_msgs.srv.CancelGoal
        GoalStatusMessage: TypeAlias = action_msgs.msg.GoalStatusArray

class Spin_Goal(Message):
    """nav2_msgs/action/Spin_Goal

    # Turns a robot on the spot.

    float32 target_yaw  # rad, from where it points now
    builtin_interfaces/Duration time_allowance
    bool disable_collision_checks False
    """
    def __init__(self, *, target_yaw: float = ..., time_allowance: builtin_interfaces.msg.Duration = ..., disable_collision_checks: bool = ..., check_fields: bool = ...) -> None: ...
    target_yaw: float
    time_allowance: builtin_interfaces.msg.Duration
    disable_collision_checks: bool

class Spin_Result(Message):
    """nav2_msgs/action/Spin_Result

    uint16 NONE=0
    uint16 GOAL_REJECTED=1
    uint16 SEND_GOAL_FAILURE=2
    uint16 UNKNOWN=700
    uint16 TIMEOUT=701
    uint16 TF_ERROR=702
    uint16 COLLISION_AHEAD=703
    builtin_interfaces/Duration total_elapsed_time
    uint16 error_code
    string error_msg
    """
    NONE: Final = 0
    GOAL_REJECTED: Final = 1
    SEND_GOAL_FAILURE: Final = 2
    UNKNOWN: Final = 700
    TIMEOUT: Final = 701
    TF_ERROR: Final = 702
    COLLISION_AHEAD: Final = 703
    def __init__(self, *, total_elapsed_time: builtin_interfaces.msg.Duration = ..., error_code: int = ..., error_msg: str = ..., check_fields: bool = ...) -> None: ...
    total_elapsed_time: builtin_interfaces.msg.Duration
    error_code: int
    error_msg: str

class Spin_Feedback(Message):
    """nav2_msgs/action/Spin_Feedback

    float32 angular_distance_traveled  # rad
    """
    def __init__(self, *, angular_distance_traveled: float = ..., check_fields: bool = ...) -> None: ...
    angular_distance_traveled: float

class Spin_FeedbackMessage(Message):
    """nav2_msgs/action/Spin_FeedbackMessage"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., feedback: nav2_msgs.action.Spin_Feedback = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    feedback: nav2_msgs.action.Spin_Feedback

class Spin_SendGoal_Request(Message):
    """nav2_msgs/action/Spin_SendGoal_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., goal: nav2_msgs.action.Spin_Goal = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    goal: nav2_msgs.action.Spin_Goal

class Spin_SendGoal_Response(Message):
    """nav2_msgs/action/Spin_SendGoal_Response"""
    def __init__(self, *, accepted: bool = ..., stamp: builtin_interfaces.msg.Time = ..., check_fields: bool = ...) -> None: ...
    accepted: bool
    stamp: builtin_interfaces.msg.Time

class Spin_SendGoal_Event(Message):
    """nav2_msgs/action/Spin_SendGoal_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[nav2_msgs.action.Spin_SendGoal_Request] = ..., response: Collection[nav2_msgs.action.Spin_SendGoal_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[nav2_msgs.action.Spin_SendGoal_Request]: ...
    @request.setter
    def request(self, value: Collection[nav2_msgs.action.Spin_SendGoal_Request]) -> None: ...
    @property
    def response(self) -> list[nav2_msgs.action.Spin_SendGoal_Response]: ...
    @response.setter
    def response(self, value: Collection[nav2_msgs.action.Spin_SendGoal_Response]) -> None: ...

class Spin_GetResult_Request(Message):
    """nav2_msgs/action/Spin_GetResult_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID

class Spin_GetResult_Response(Message):
    """nav2_msgs/action/Spin_GetResult_Response"""
    def __init__(self, *, status: int = ..., result: nav2_msgs.action.Spin_Result = ..., check_fields: bool = ...) -> None: ...
    status: int
    result: nav2_msgs.action.Spin_Result

class Spin_GetResult_Event(Message):
    """nav2_msgs/action/Spin_GetResult_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[nav2_msgs.action.Spin_GetResult_Request] = ..., response: Collection[nav2_msgs.action.Spin_GetResult_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[nav2_msgs.action.Spin_GetResult_Request]: ...
    @request.setter
    def request(self, value: Collection[nav2_msgs.action.Spin_GetResult_Request]) -> None: ...
    @property
    def response(self) -> list[nav2_msgs.action.Spin_GetResult_Response]: ...
    @response.setter
    def response(self, value: Collection[nav2_msgs.action.Spin_GetResult_Response]) -> None: ...

class Spin_SendGoal(Service):
    Request: TypeAlias = Spin_SendGoal_Request
    Response: TypeAlias = Spin_SendGoal_Response
    Event: TypeAlias = Spin_SendGoal_Event

class Spin_GetResult(Service):
    Request: TypeAlias = Spin_GetResult_Request
    Response: TypeAlias = Spin_GetResult_Response
    Event: TypeAlias = Spin_GetResult_Event

class Spin(Action):
    Goal: TypeAlias = Spin_Goal
    Result: TypeAlias = Spin_Result
    Feedback: TypeAlias = Spin_Feedback
    class Impl:
        SendGoalService: TypeAlias = Spin_SendGoal
        GetResultService: TypeAlias = Spin_GetResult
        FeedbackMessage: TypeAlias = Spin_FeedbackMessage
        CancelGoalService: TypeAlias = action_msgs.srv.CancelGoal
        GoalStatusMessage: TypeAlias = action_msgs.msg.GoalStatusArray

class UndockRobot_Goal(Message):
    """nav2_msgs/action/UndockRobot_Goal

    # Drives a robot out of its dock.

    string dock_type  # empty: that of the last docking
    float32 max_undocking_time 30.0  # s
    """
    def __init__(self, *, dock_type: str = ..., max_undocking_time: float = ..., check_fields: bool = ...) -> None: ...
    dock_type: str
    max_undocking_time: float

class UndockRobot_Result(Message):
    """nav2_msgs/action/UndockRobot_Result

    uint16 NONE=0
    uint16 GOAL_REJECTED=1
    uint16 SEND_GOAL_FAILURE=2
    uint16 DOCK_NOT_VALID=902
    uint16 FAILED_TO_CONTROL=905
    uint16 TIMEOUT=907
    uint16 UNKNOWN=999
    bool success True
    uint16 error_code 0
    string error_msg
    """
    NONE: Final = 0
    GOAL_REJECTED: Final = 1
    SEND_GOAL_FAILURE: Final = 2
    DOCK_NOT_VALID: Final = 902
    FAILED_TO_CONTROL: Final = 905
    TIMEOUT: Final = 907
    UNKNOWN: Final = 999
    def __init__(self, *, success: bool = ..., error_code: int = ..., error_msg: str = ..., check_fields: bool = ...) -> None: ...
    success: bool
    error_code: int
    error_msg: str

class UndockRobot_Feedback(Message):
    """nav2_msgs/action/UndockRobot_Feedback"""
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class UndockRobot_FeedbackMessage(Message):
    """nav2_msgs/action/UndockRobot_FeedbackMessage"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., feedback: nav2_msgs.action.UndockRobot_Feedback = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    feedback: nav2_msgs.action.UndockRobot_Feedback

class UndockRobot_SendGoal_Request(Message):
    """nav2_msgs/action/UndockRobot_SendGoal_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., goal: nav2_msgs.action.UndockRobot_Goal = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    goal: nav2_msgs.action.UndockRobot_Goal

class UndockRobot_SendGoal_Response(Message):
    """nav2_msgs/action/UndockRobot_SendGoal_Response"""
    def __init__(self, *, accepted: bool = ..., stamp: builtin_interfaces.msg.Time = ..., check_fields: bool = ...) -> None: ...
    accepted: bool
    stamp: builtin_interfaces.msg.Time

class UndockRobot_SendGoal_Event(Message):
    """nav2_msgs/action/UndockRobot_SendGoal_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[nav2_msgs.action.UndockRobot_SendGoal_Request] = ..., response: Collection[nav2_msgs.action.UndockRobot_SendGoal_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[nav2_msgs.action.UndockRobot_SendGoal_Request]: ...
    @request.setter
    def request(self, value: Collection[nav2_msgs.action.UndockRobot_SendGoal_Request]) -> None: ...
    @property
    def response(self) -> list[nav2_msgs.action.UndockRobot_SendGoal_Response]: ...
    @response.setter
    def response(self, value: Collection[nav2_msgs.action.UndockRobot_SendGoal_Response]) -> None: ...

class UndockRobot_GetResult_Request(Message):
    """nav2_msgs/action/UndockRobot_GetResult_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID

class UndockRobot_GetResult_Response(Message):
    """nav2_msgs/action/UndockRobot_GetResult_Response"""
    def __init__(self, *, status: int = ..., result: nav2_msgs.action.UndockRobot_Result = ..., check_fields: bool = ...) -> None: ...
    status: int
    result: nav2_msgs.action.UndockRobot_Result

class UndockRobot_GetResult_Event(Message):
    """nav2_msgs/action/UndockRobot_GetResult_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[nav2_msgs.action.UndockRobot_GetResult_Request] = ..., response: Collection[nav2_msgs.action.UndockRobot_GetResult_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[nav2_msgs.action.UndockRobot_GetResult_Request]: ...
    @request.setter
    def request(self, value: Collection[nav2_msgs.action.UndockRobot_GetResult_Request]) -> None: ...
    @property
    def response(self) -> list[nav2_msgs.action.UndockRobot_GetResult_Response]: ...
    @response.setter
    def response(self, value: Collection[nav2_msgs.action.UndockRobot_GetResult_Response]) -> None: ...

class UndockRobot_SendGoal(Service):
    Request: TypeAlias = UndockRobot_SendGoal_Request
    Response: TypeAlias = UndockRobot_SendGoal_Response
    Event: TypeAlias = UndockRobot_SendGoal_Event

class UndockRobot_GetResult(Service):
    Request: TypeAlias = UndockRobot_GetResult_Request
    Response: TypeAlias = UndockRobot_GetResult_Response
    Event: TypeAlias = UndockRobot_GetResult_Event

class UndockRobot(Action):
    Goal: TypeAlias = UndockRobot_Goal
    Result: TypeAlias = UndockRobot_Result
    Feedback: TypeAlias = UndockRobot_Feedback
    class Impl:
        SendGoalService: TypeAlias = UndockRobot_SendGoal
        GetResultService: TypeAlias = UndockRobot_GetResult
        FeedbackMessage: TypeAlias = UndockRobot_FeedbackMessage
        CancelGoalService: TypeAlias = action_msgs.srv.CancelGoal
        GoalStatusMessage: TypeAlias = action_msgs.msg.GoalStatusArray

class Wait_Goal(Message):
    """nav2_msgs/action/Wait_Goal

    # Lets a robot stand for a while.

    builtin_interfaces/Duration time
    """
    def __init__(self, *, time: builtin_interfaces.msg.Duration = ..., check_fields: bool = ...) -> None: ...
    time: builtin_interfaces.msg.Duration

class Wait_Result(Message):
    """nav2_msgs/action/Wait_Result

    builtin_interfaces/Duration total_elapsed_time
    uint16 error_code
    string error_msg
    uint16 NONE=0
    uint16 GOAL_REJECTED=1
    uint16 SEND_GOAL_FAILURE=2
    uint16 UNKNOWN=740
    uint16 TIMEOUT=741
    """
    NONE: Final = 0
    GOAL_REJECTED: Final = 1
    SEND_GOAL_FAILURE: Final = 2
    UNKNOWN: Final = 740
    TIMEOUT: Final = 741
    def __init__(self, *, total_elapsed_time: builtin_interfaces.msg.Duration = ..., error_code: int = ..., error_msg: str = ..., check_fields: bool = ...) -> None: ...
    total_elapsed_time: builtin_interfaces.msg.Duration
    error_code: int
    error_msg: str

class Wait_Feedback(Message):
    """nav2_msgs/action/Wait_Feedback

    builtin_interfaces/Duration time_left
    """
    def __init__(self, *, time_left: builtin_interfaces.msg.Duration = ..., check_fields: bool = ...) -> None: ...
    time_left: builtin_interfaces.msg.Duration

class Wait_FeedbackMessage(Message):
    """nav2_msgs/action/Wait_FeedbackMessage"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., feedback: nav2_msgs.action.Wait_Feedback = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    feedback: nav2_msgs.action.Wait_Feedback

class Wait_SendGoal_Request(Message):
    """nav2_msgs/action/Wait_SendGoal_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., goal: nav2_msgs.action.Wait_Goal = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    goal: nav2_msgs.action.Wait_Goal

class Wait_SendGoal_Response(Message):
    """nav2_msgs/action/Wait_SendGoal_Response"""
    def __init__(self, *, accepted: bool = ..., stamp: builtin_interfaces.msg.Time = ..., check_fields: bool = ...) -> None: ...
    accepted: bool
    stamp: builtin_interfaces.msg.Time

class Wait_SendGoal_Event(Message):
    """nav2_msgs/action/Wait_SendGoal_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[nav2_msgs.action.Wait_SendGoal_Request] = ..., response: Collection[nav2_msgs.action.Wait_SendGoal_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[nav2_msgs.action.Wait_SendGoal_Request]: ...
    @request.setter
    def request(self, value: Collection[nav2_msgs.action.Wait_SendGoal_Request]) -> None: ...
    @property
    def response(self) -> list[nav2_msgs.action.Wait_SendGoal_Response]: ...
    @response.setter
    def response(self, value: Collection[nav2_msgs.action.Wait_SendGoal_Response]) -> None: ...

class Wait_GetResult_Request(Message):
    """nav2_msgs/action/Wait_GetResult_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID

class Wait_GetResult_Response(Message):
    """nav2_msgs/action/Wait_GetResult_Response"""
    def __init__(self, *, status: int = ..., result: nav2_msgs.action.Wait_Result = ..., check_fields: bool = ...) -> None: ...
    status: int
    result: nav2_msgs.action.Wait_Result

class Wait_GetResult_Event(Message):
    """nav2_msgs/action/Wait_GetResult_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[nav2_msgs.action.Wait_GetResult_Request] = ..., response: Collection[nav2_msgs.action.Wait_GetResult_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[nav2_msgs.action.Wait_GetResult_Request]: ...
    @request.setter
    def request(self, value: Collection[nav2_msgs.action.Wait_GetResult_Request]) -> None: ...
    @property
    def response(self) -> list[nav2_msgs.action.Wait_GetResult_Response]: ...
    @response.setter
    def response(self, value: Collection[nav2_msgs.action.Wait_GetResult_Response]) -> None: ...

class Wait_SendGoal(Service):
    Request: TypeAlias = Wait_SendGoal_Request
    Response: TypeAlias = Wait_SendGoal_Response
    Event: TypeAlias = Wait_SendGoal_Event

class Wait_GetResult(Service):
    Request: TypeAlias = Wait_GetResult_Request
    Response: TypeAlias = Wait_GetResult_Response
    Event: TypeAlias = Wait_GetResult_Event

class Wait(Action):
    Goal: TypeAlias = Wait_Goal
    Result: TypeAlias = Wait_Result
    Feedback: TypeAlias = Wait_Feedback
    class Impl:
        SendGoalService: TypeAlias = Wait_SendGoal
        GetResultService: TypeAlias = Wait_GetResult
        FeedbackMessage: TypeAlias = Wait_FeedbackMessage
        CancelGoalService: TypeAlias = action_msgs.srv.CancelGoal
        GoalStatusMessage: TypeAlias = action_msgs.msg.GoalStatusArray
