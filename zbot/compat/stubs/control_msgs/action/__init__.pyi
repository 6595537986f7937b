# Written by python -m zbot.interfaces.stubs; do not edit.
from array import array
from collections.abc import Collection
from typing import Final, TypeAlias

import numpy
from numpy.typing import NDArray

import action_msgs.msg
import action_msgs.srv
import builtin_interfaces.msg
import control_msgs.action
import control_msgs.msg
import geometry_msgs.msg
import sensor_msgs.msg
import service_msgs.msg
import std_msgs.msg
import trajectory_msgs.msg
import unique_identifier_msgs.msg
from zbot.interfaces import Action, Message, Service

class ExecuteMotionPrimitiveSequence_Goal(Message):
    """control_msgs/action/ExecuteMotionPrimitiveSequence_Goal

    # Runs motions one after another, such as lines and arcs.

    MotionPrimitiveSequence trajectory
    """
    def __init__(self, *, trajectory: control_msgs.msg.MotionPrimitiveSequence = ..., check_fields: bool = ...) -> None: ...
    trajectory: control_msgs.msg.MotionPrimitiveSequence

class ExecuteMotionPrimitiveSequence_Result(Message):
    """control_msgs/action/ExecuteMotionPrimitiveSequence_Result

    int32 SUCCESSFUL=0
    int32 INVALID_GOAL=-1
    int32 OLD_HEADER_TIMESTAMP=-3
    int32 error_code
    string error_string
    """
    SUCCESSFUL: Final = 0
    INVALID_GOAL: Final = -1
    OLD_HEADER_TIMESTAMP: Final = -3
    def __init__(self, *, error_code: int = ..., error_string: str = ..., check_fields: bool = ...) -> None: ...
    error_code: int
    error_string: str

class ExecuteMotionPrimitiveSequence_Feedback(Message):
    """control_msgs/action/ExecuteMotionPrimitiveSequence_Feedback

    uint8 current_primitive_index  # counts from 0
    """
    def __init__(self, *, current_primitive_index: int = ..., check_fields: bool = ...) -> None: ...
    current_primitive_index: int

class ExecuteMotionPrimitiveSequence_FeedbackMessage(Message):
    """control_msgs/action/ExecuteMotionPrimitiveSequence_FeedbackMessage"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., feedback: control_msgs.action.ExecuteMotionPrimitiveSequence_Feedback = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    feedback: control_msgs.action.ExecuteMotionPrimitiveSequence_Feedback

class ExecuteMotionPrimitiveSequence_SendGoal_Request(Message):
    """control_msgs/action/ExecuteMotionPrimitiveSequence_SendGoal_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., goal: control_msgs.action.ExecuteMotionPrimitiveSequence_Goal = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    goal: control_msgs.action.ExecuteMotionPrimitiveSequence_Goal

class ExecuteMotionPrimitiveSequence_SendGoal_Response(Message):
    """control_msgs/action/ExecuteMotionPrimitiveSequence_SendGoal_Response"""
    def __init__(self, *, accepted: bool = ..., stamp: builtin_interfaces.msg.Time = ..., check_fields: bool = ...) -> None: ...
    accepted: bool
    stamp: builtin_interfaces.msg.Time

class ExecuteMotionPrimitiveSequence_SendGoal_Event(Message):
    """control_msgs/action/ExecuteMotionPrimitiveSequence_SendGoal_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[control_msgs.action.ExecuteMotionPrimitiveSequence_SendGoal_Request] = ..., response: Collection[control_msgs.action.ExecuteMotionPrimitiveSequence_SendGoal_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[control_msgs.action.ExecuteMotionPrimitiveSequence_SendGoal_Request]: ...
    @request.setter
    def request(self, value: Collection[control_msgs.action.ExecuteMotionPrimitiveSequence_SendGoal_Request]) -> None: ...
    @property
    def response(self) -> list[control_msgs.action.ExecuteMotionPrimitiveSequence_SendGoal_Response]: ...
    @response.setter
    def response(self, value: Collection[control_msgs.action.ExecuteMotionPrimitiveSequence_SendGoal_Response]) -> None: ...

class ExecuteMotionPrimitiveSequence_GetResult_Request(Message):
    """control_msgs/action/ExecuteMotionPrimitiveSequence_GetResult_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID

class ExecuteMotionPrimitiveSequence_GetResult_Response(Message):
    """control_msgs/action/ExecuteMotionPrimitiveSequence_GetResult_Response"""
    def __init__(self, *, status: int = ..., result: control_msgs.action.ExecuteMotionPrimitiveSequence_Result = ..., check_fields: bool = ...) -> None: ...
    status: int
    result: control_msgs.action.ExecuteMotionPrimitiveSequence_Result

class ExecuteMotionPrimitiveSequence_GetResult_Event(Message):
    """control_msgs/action/ExecuteMotionPrimitiveSequence_GetResult_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[control_msgs.action.ExecuteMotionPrimitiveSequence_GetResult_Request] = ..., response: Collection[control_msgs.action.ExecuteMotionPrimitiveSequence_GetResult_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[control_msgs.action.ExecuteMotionPrimitiveSequence_GetResult_Request]: ...
    @request.setter
    def request(self, value: Collection[control_msgs.action.ExecuteMotionPrimitiveSequence_GetResult_Request]) -> None: ...
    @property
    def response(self) -> list[control_msgs.action.ExecuteMotionPrimitiveSequence_GetResult_Response]: ...
    @response.setter
    def response(self, value: Collection[control_msgs.action.ExecuteMotionPrimitiveSequence_GetResult_Response]) -> None: ...

class ExecuteMotionPrimitiveSequence_SendGoal(Service):
    Request: TypeAlias = ExecuteMotionPrimitiveSequence_SendGoal_Request
    Response: TypeAlias = ExecuteMotionPrimitiveSequence_SendGoal_Response
    Event: TypeAlias = ExecuteMotionPrimitiveSequence_SendGoal_Event

class ExecuteMotionPrimitiveSequence_GetResult(Service):
    Request: TypeAlias = ExecuteMotionPrimitiveSequence_GetResult_Request
    Response: TypeAlias = ExecuteMotionPrimitiveSequence_GetResult_Response
    Event: TypeAlias = ExecuteMotionPrimitiveSequence_GetResult_Event

class ExecuteMotionPrimitiveSequence(Action):
    Goal: TypeAlias = ExecuteMotionPrimitiveSequence_Goal
    Result: TypeAlias = ExecuteMotionPrimitiveSequence_Result
    Feedback: TypeAlias = ExecuteMotionPrimitiveSequence_Feedback
    class Impl:
        SendGoalService: TypeAlias = ExecuteMotionPrimitiveSequence_SendGoal
        GetResultService: TypeAlias = ExecuteMotionPrimitiveSequence_GetResult
        FeedbackMessage: TypeAlias = ExecuteMotionPrimitiveSequence_FeedbackMessage
        CancelGoalService: TypeAlias = action_msgs.srv.CancelGoal
        GoalStatusMessage: TypeAlias = action_msgs.msg.GoalStatusArray

class FollowJointTrajectory_Goal(Message):
    """control_msgs/action/FollowJointTrajectory_Goal

    # Moves the joints of an arm through given positions at given times.

    trajectory_msgs/JointTrajectory trajectory
    trajectory_msgs/MultiDOFJointTrajectory multi_dof_trajectory
    JointTolerance[] path_tolerance  # allowed distance during the motion
    JointComponentTolerance[] component_path_tolerance  # the same for joints with several axes
    JointTolerance[] goal_tolerance  # allowed distance at the end
    JointComponentTolerance[] component_goal_tolerance
    builtin_interfaces/Duration goal_time_tolerance  # how much later the goal may be reached
    """
    def __init__(self, *, trajectory: trajectory_msgs.msg.JointTrajectory = ..., multi_dof_trajectory: trajectory_msgs.msg.MultiDOFJointTrajectory = ..., path_tolerance: Collection[control_msgs.msg.JointTolerance] = ..., component_path_tolerance: Collection[control_msgs.msg.JointComponentTolerance] = ..., goal_tolerance: Collection[control_msgs.msg.JointTolerance] = ..., component_goal_tolerance: Collection[control_msgs.msg.JointComponentTolerance] = ..., goal_time_tolerance: builtin_interfaces.msg.Duration = ..., check_fields: bool = ...) -> None: ...
    trajectory: trajectory_msgs.msg.JointTrajectory
    multi_dof_trajectory: trajectory_msgs.msg.MultiDOFJointTrajectory
    @property
    def path_tolerance(self) -> list[control_msgs.msg.JointTolerance]: ...
    @path_tolerance.setter
    def path_tolerance(self, value: Collection[control_msgs.msg.JointTolerance]) -> None: ...
    @property
    def component_path_tolerance(self) -> list[control_msgs.msg.JointComponentTolerance]: ...
    @component_path_tolerance.setter
    def component_path_tolerance(self, value: Collection[control_msgs.msg.JointComponentTolerance]) -> None: ...
    @property
    def goal_tolerance(self) -> list[control_msgs.msg.JointTolerance]: ...
    @goal_tolerance.setter
    def goal_tolerance(self, value: Collection[control_msgs.msg.JointTolerance]) -> None: ...
    @property
    def component_goal_tolerance(self) -> list[control_msgs.msg.JointComponentTolerance]: ...
    @component_goal_tolerance.setter
    def component_goal_tolerance(self, value: Collection[control_msgs.msg.JointComponentTolerance]) -> None: ...
    goal_time_tolerance: builtin_interfaces.msg.Duration

class FollowJointTrajectory_Result(Message):
    """control_msgs/action/FollowJointTrajectory_Result

    int32 error_code
    int32 SUCCESSFUL=0
    int32 INVALID_GOAL=-1
    int32 INVALID_JOINTS=-2
    int32 OLD_HEADER_TIMESTAMP=-3
    int32 PATH_TOLERANCE_VIOLATED=-4
    int32 GOAL_TOLERANCE_VIOLATED=-5
    string error_string  # for people
    """
    SUCCESSFUL: Final = 0
    INVALID_GOAL: Final = -1
    INVALID_JOINTS: Final = -2
    OLD_HEADER_TIMESTAMP: Final = -3
    PATH_TOLERANCE_VIOLATED: Final = -4
    GOAL_TOLERANCE_VIOLATED: Final = -5
    def __init__(self, *, error_code: int = ..., error_string: str = ..., check_fields: bool = ...) -> None: ...
    error_code: int
    error_string: str

class FollowJointTrajectory_Feedback(Message):
    """control_msgs/action/FollowJointTrajectory_Feedback

    std_msgs/Header header
    string[] joint_names
    trajectory_msgs/JointTrajectoryPoint desired
    trajectory_msgs/JointTrajectoryPoint actual
    trajectory_msgs/JointTrajectoryPoint error
    int32 index  # current point of trajectory.points
    string[] multi_dof_joint_names
    trajectory_msgs/MultiDOFJointTrajectoryPoint multi_dof_desired
    trajectory_msgs/MultiDOFJointTrajectoryPoint multi_dof_actual
    trajectory_msgs/MultiDOFJointTrajectoryPoint multi_dof_error
    int32 multi_dof_index  # current point of multi_dof_trajectory.points
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., joint_names: Collection[str] = ..., desired: trajectory_msgs.msg.JointTrajectoryPoint = ..., actual: trajectory_msgs.msg.JointTrajectoryPoint = ..., error: trajectory_msgs.msg.JointTrajectoryPoint = ..., index: int = ..., multi_dof_joint_names: Collection[str] = ..., multi_dof_desired: trajectory_msgs.msg.MultiDOFJointTrajectoryPoint = ..., multi_dof_actual: trajectory_msgs.msg.MultiDOFJointTrajectoryPoint = ..., multi_dof_error: trajectory_msgs.msg.MultiDOFJointTrajectoryPoint = ..., multi_dof_index: int = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    @property
    def joint_names(self) -> list[str]: ...
    @joint_names.setter
    def joint_names(self, value: Collection[str]) -> None: ...
    desired: trajectory_msgs.msg.JointTrajectoryPoint
    actual: trajectory_msgs.msg.JointTrajectoryPoint
    error: trajectory_msgs.msg.JointTrajectoryPoint
    index: int
    @property
    def multi_dof_joint_names(self) -> list[str]: ...
    @multi_dof_joint_names.setter
    def multi_dof_joint_names(self, value: Collection[str]) -> None: ...
    multi_dof_desired: trajectory_msgs.msg.MultiDOFJointTrajectoryPoint
    multi_dof_actual: trajectory_msgs.msg.MultiDOFJointTrajectoryPoint
    multi_dof_error: trajectory_msgs.msg.MultiDOFJointTrajectoryPoint
    multi_dof_index: int

class FollowJointTrajectory_FeedbackMessage(Message):
    """control_msgs/action/FollowJointTrajectory_FeedbackMessage"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., feedback: control_msgs.action.FollowJointTrajectory_Feedback = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    feedback: control_msgs.action.FollowJointTrajectory_Feedback

class FollowJointTrajectory_SendGoal_Request(Message):
    """control_msgs/action/FollowJointTrajectory_SendGoal_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., goal: control_msgs.action.FollowJointTrajectory_Goal = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    goal: control_msgs.action.FollowJointTrajectory_Goal

class FollowJointTrajectory_SendGoal_Response(Message):
    """control_msgs/action/FollowJointTrajectory_SendGoal_Response"""
    def __init__(self, *, accepted: bool = ..., stamp: builtin_interfaces.msg.Time = ..., check_fields: bool = ...) -> None: ...
    accepted: bool
    stamp: builtin_interfaces.msg.Time

class FollowJointTrajectory_SendGoal_Event(Message):
    """control_msgs/action/FollowJointTrajectory_SendGoal_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[control_msgs.action.FollowJointTrajectory_SendGoal_Request] = ..., response: Collection[control_msgs.action.FollowJointTrajectory_SendGoal_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[control_msgs.action.FollowJointTrajectory_SendGoal_Request]: ...
    @request.setter
    def request(self, value: Collection[control_msgs.action.FollowJointTrajectory_SendGoal_Request]) -> None: ...
    @property
    def response(self) -> list[control_msgs.action.FollowJointTrajectory_SendGoal_Response]: ...
    @response.setter
    def response(self, value: Collection[control_msgs.action.FollowJointTrajectory_SendGoal_Response]) -> None: ...

class FollowJointTrajectory_GetResult_Request(Message):
    """control_msgs/action/FollowJointTrajectory_GetResult_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID

class FollowJointTrajectory_GetResult_Response(Message):
    """control_msgs/action/FollowJointTrajectory_GetResult_Response"""
    def __init__(self, *, status: int = ..., result: control_msgs.action.FollowJointTrajectory_Result = ..., check_fields: bool = ...) -> None: ...
    status: int
    result: control_msgs.action.FollowJointTrajectory_Result

class FollowJointTrajectory_GetResult_Event(Message):
    """control_msgs/action/FollowJointTrajectory_GetResult_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[control_msgs.action.FollowJointTrajectory_GetResult_Request] = ..., response: Collection[control_msgs.action.FollowJointTrajectory_GetResult_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[control_msgs.action.FollowJointTrajectory_GetResult_Request]: ...
    @request.setter
    def request(self, value: Collection[control_msgs.action.FollowJointTrajectory_GetResult_Request]) -> None: ...
    @property
    def response(self) -> list[control_msgs.action.FollowJointTrajectory_GetResult_Response]: ...
    @response.setter
    def response(self, value: Collection[control_msgs.action.FollowJointTrajectory_GetResult_Response]) -> None: ...

class FollowJointTrajectory_SendGoal(Service):
    Request: TypeAlias = FollowJointTrajectory_SendGoal_Request
    Response: TypeAlias = FollowJointTrajectory_SendGoal_Response
    Event: TypeAlias = FollowJointTrajectory_SendGoal_Event

class FollowJointTrajectory_GetResult(Service):
    Request: TypeAlias = FollowJointTrajectory_GetResult_Request
    Response: TypeAlias = FollowJointTrajectory_GetResult_Response
    Event: TypeAlias = FollowJointTrajectory_GetResult_Event

class FollowJointTrajectory(Action):
    Goal: TypeAlias = FollowJointTrajectory_Goal
    Result: TypeAlias = FollowJointTrajectory_Result
    Feedback: TypeAlias = FollowJointTrajectory_Feedback
    class Impl:
        SendGoalService: TypeAlias = FollowJointTrajectory_SendGoal
        GetResultService: TypeAlias = FollowJointTrajectory_GetResult
        FeedbackMessage: TypeAlias = FollowJointTrajectory_FeedbackMessage
        CancelGoalService: TypeAlias = action_msgs.srv.CancelGoal
        GoalStatusMessage: TypeAlias = action_msgs.msg.GoalStatusArray

class FollowJointWrenchTrajectory_Goal(Message):
    """control_msgs/action/FollowJointWrenchTrajectory_Goal

    # Moves joints through given positions and applies given wrenches.

    control_msgs/JointWrenchTrajectory trajectory
    control_msgs/JointTolerance[] path_tolerance  # allowed distance during the motion
    control_msgs/JointTolerance[] goal_tolerance  # allowed distance at the end
    builtin_interfaces/Duration goal_time_tolerance  # how much later the goal may be reached
    """
    def __init__(self, *, trajectory: control_msgs.msg.JointWrenchTrajectory = ..., path_tolerance: Collection[control_msgs.msg.JointTolerance] = ..., goal_tolerance: Collection[control_msgs.msg.JointTolerance] = ..., goal_time_tolerance: builtin_interfaces.msg.Duration = ..., check_fields: bool = ...) -> None: ...
    trajectory: control_msgs.msg.JointWrenchTrajectory
    @property
    def path_tolerance(self) -> list[control_msgs.msg.JointTolerance]: ...
    @path_tolerance.setter
    def path_tolerance(self, value: Collection[control_msgs.msg.JointTolerance]) -> None: ...
    @property
    def goal_tolerance(self) -> list[control_msgs.msg.JointTolerance]: ...
    @goal_tolerance.setter
    def goal_tolerance(self, value: Collection[control_msgs.msg.JointTolerance]) -> None: ...
    goal_time_tolerance: builtin_interfaces.msg.Duration

class FollowJointWrenchTrajectory_Result(Message):
    """control_msgs/action/FollowJointWrenchTrajectory_Result

    int32 error_code
    int32 SUCCESSFUL=0
    int32 INVALID_GOAL=-1
    int32 INVALID_JOINTS=-2
    int32 OLD_HEADER_TIMESTAMP=-3
    int32 PATH_TOLERANCE_VIOLATED=-4
    int32 GOAL_TOLERANCE_VIOLATED=-5
    int32 TRAJECTORY_ABORTED=-6
    string error_string  # for people
    """
    SUCCESSFUL: Final = 0
    INVALID_GOAL: Final = -1
    INVALID_JOINTS: Final = -2
    OLD_HEADER_TIMESTAMP: Final = -3
    PATH_TOLERANCE_VIOLATED: Final = -4
    GOAL_TOLERANCE_VIOLATED: Final = -5
    TRAJECTORY_ABORTED: Final = -6
    def __init__(self, *, error_code: int = ..., error_string: str = ..., check_fields: bool = ...) -> None: ...
    error_code: int
    error_string: str

class FollowJointWrenchTrajectory_Feedback(Message):
    """control_msgs/action/FollowJointWrenchTrajectory_Feedback

    std_msgs/Header header
    string[] joint_names
    control_msgs/JointWrenchTrajectoryPoint desired
    control_msgs/JointWrenchTrajectoryPoint actual
    control_msgs/JointWrenchTrajectoryPoint error
    int32 index  # current point of trajectory.points
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., joint_names: Collection[str] = ..., desired: control_msgs.msg.JointWrenchTrajectoryPoint = ..., actual: control_msgs.msg.JointWrenchTrajectoryPoint = ..., error: control_msgs.msg.JointWrenchTrajectoryPoint = ..., index: int = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    @property
    def joint_names(self) -> list[str]: ...
    @joint_names.setter
    def joint_names(self, value: Collection[str]) -> None: ...
    desired: control_msgs.msg.JointWrenchTrajectoryPoint
    actual: control_msgs.msg.JointWrenchTrajectoryPoint
    error: control_msgs.msg.JointWrenchTrajectoryPoint
    index: int

class FollowJointWrenchTrajectory_FeedbackMessage(Message):
    """control_msgs/action/FollowJointWrenchTrajectory_FeedbackMessage"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., feedback: control_msgs.action.FollowJointWrenchTrajectory_Feedback = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    feedback: control_msgs.action.FollowJointWrenchTrajectory_Feedback

class FollowJointWrenchTrajectory_SendGoal_Request(Message):
    """control_msgs/action/FollowJointWrenchTrajectory_SendGoal_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., goal: control_msgs.action.FollowJointWrenchTrajectory_Goal = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    goal: control_msgs.action.FollowJointWrenchTrajectory_Goal

class FollowJointWrenchTrajectory_SendGoal_Response(Message):
    """control_msgs/action/FollowJointWrenchTrajectory_SendGoal_Response"""
    def __init__(self, *, accepted: bool = ..., stamp: builtin_interfaces.msg.Time = ..., check_fields: bool = ...) -> None: ...
    accepted: bool
    stamp: builtin_interfaces.msg.Time

class FollowJointWrenchTrajectory_SendGoal_Event(Message):
    """control_msgs/action/FollowJointWrenchTrajectory_SendGoal_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[control_msgs.action.FollowJointWrenchTrajectory_SendGoal_Request] = ..., response: Collection[control_msgs.action.FollowJointWrenchTrajectory_SendGoal_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[control_msgs.action.FollowJointWrenchTrajectory_SendGoal_Request]: ...
    @request.setter
    def request(self, value: Collection[control_msgs.action.FollowJointWrenchTrajectory_SendGoal_Request]) -> None: ...
    @property
    def response(self) -> list[control_msgs.action.FollowJointWrenchTrajectory_SendGoal_Response]: ...
    @response.setter
    def response(self, value: Collection[control_msgs.action.FollowJointWrenchTrajectory_SendGoal_Response]) -> None: ...

class FollowJointWrenchTrajectory_GetResult_Request(Message):
    """control_msgs/action/FollowJointWrenchTrajectory_GetResult_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID

class FollowJointWrenchTrajectory_GetResult_Response(Message):
    """control_msgs/action/FollowJointWrenchTrajectory_GetResult_Response"""
    def __init__(self, *, status: int = ..., result: control_msgs.action.FollowJointWrenchTrajectory_Result = ..., check_fields: bool = ...) -> None: ...
    status: int
    result: control_msgs.action.FollowJointWrenchTrajectory_Result

class FollowJointWrenchTrajectory_GetResult_Event(Message):
    """control_msgs/action/FollowJointWrenchTrajectory_GetResult_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[control_msgs.action.FollowJointWrenchTrajectory_GetResult_Request] = ..., response: Collection[control_msgs.action.FollowJointWrenchTrajectory_GetResult_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[control_msgs.action.FollowJointWrenchTrajectory_GetResult_Request]: ...
    @request.setter
    def request(self, value: Collection[control_msgs.action.FollowJointWrenchTrajectory_GetResult_Request]) -> None: ...
    @property
    def response(self) -> list[control_msgs.action.FollowJointWrenchTrajectory_GetResult_Response]: ...
    @response.setter
    def response(self, value: Collection[control_msgs.action.FollowJointWrenchTrajectory_GetResult_Response]) -> None: ...

class FollowJointWrenchTrajectory_SendGoal(Service):
    Request: TypeAlias = FollowJointWrenchTrajectory_SendGoal_Request
    Response: TypeAlias = FollowJointWrenchTrajectory_SendGoal_Response
    Event: TypeAlias = FollowJointWrenchTrajectory_SendGoal_Event

class FollowJointWrenchTrajectory_GetResult(Service):
    Request: TypeAlias = FollowJointWrenchTrajectory_GetResult_Request
    Response: TypeAlias = FollowJointWrenchTrajectory_GetResult_Response
    Event: TypeAlias = FollowJointWrenchTrajectory_GetResult_Event

class FollowJointWrenchTrajectory(Action):
    Goal: TypeAlias = FollowJointWrenchTrajectory_Goal
    Result: TypeAlias = FollowJointWrenchTrajectory_Result
    Feedback: TypeAlias = FollowJointWrenchTrajectory_Feedback
    class Impl:
        SendGoalService: TypeAlias = FollowJointWrenchTrajectory_SendGoal
        GetResultService: TypeAlias = FollowJointWrenchTrajectory_GetResult
        FeedbackMessage: TypeAlias = FollowJointWrenchTrajectory_FeedbackMessage
        CancelGoalService: TypeAlias = action_msgs.srv.CancelGoal
        GoalStatusMessage: TypeAlias = action_msgs.msg.GoalStatusArray

class GripperCommand_Goal(Message):
    """control_msgs/action/GripperCommand_Goal

    # Opens or closes a gripper.

    GripperCommand command
    """
    def __init__(self, *, command: control_msgs.msg.GripperCommand = ..., check_fields: bool = ...) -> None: ...
    command: control_msgs.msg.GripperCommand

class GripperCommand_Result(Message):
    """control_msgs/action/GripperCommand_Result

    float64 position    # m between the fingers
    float64 effort      # N
    bool stalled        # it pushes as strongly as it may, and does not move
    bool reached_goal
    """
    def __init__(self, *, position: float = ..., effort: float = ..., stalled: bool = ..., reached_goal: bool = ..., check_fields: bool = ...) -> None: ...
    position: float
    effort: float
    stalled: bool
    reached_goal: bool

class GripperCommand_Feedback(Message):
    """control_msgs/action/GripperCommand_Feedback

    float64 position    # m between the fingers
    float64 effort      # N
    bool stalled        # it pushes as strongly as it may, and does not move
    bool reached_goal
    """
    def __init__(self, *, position: float = ..., effort: float = ..., stalled: bool = ..., reached_goal: bool = ..., check_fields: bool = ...) -> None: ...
    position: float
    effort: float
    stalled: bool
    reached_goal: bool

class GripperCommand_FeedbackMessage(Message):
    """control_msgs/action/GripperCommand_FeedbackMessage"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., feedback: control_msgs.action.GripperCommand_Feedback = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    feedback: control_msgs.action.GripperCommand_Feedback

class GripperCommand_SendGoal_Request(Message):
    """control_msgs/action/GripperCommand_SendGoal_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., goal: control_msgs.action.GripperCommand_Goal = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    goal: control_msgs.action.GripperCommand_Goal

class GripperCommand_SendGoal_Response(Message):
    """control_msgs/action/GripperCommand_SendGoal_Response"""
    def __init__(self, *, accepted: bool = ..., stamp: builtin_interfaces.msg.Time = ..., check_fields: bool = ...) -> None: ...
    accepted: bool
    stamp: builtin_interfaces.msg.Time

class GripperCommand_SendGoal_Event(Message):
    """control_msgs/action/GripperCommand_SendGoal_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[control_msgs.action.GripperCommand_SendGoal_Request] = ..., response: Collection[control_msgs.action.GripperCommand_SendGoal_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[control_msgs.action.GripperCommand_SendGoal_Request]: ...
    @request.setter
    def request(self, value: Collection[control_msgs.action.GripperCommand_SendGoal_Request]) -> None: ...
    @property
    def response(self) -> list[control_msgs.action.GripperCommand_SendGoal_Response]: ...
    @response.setter
    def response(self, value: Collection[control_msgs.action.GripperCommand_SendGoal_Response]) -> None: ...

class GripperCommand_GetResult_Request(Message):
    """control_msgs/action/GripperCommand_GetResult_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID

class GripperCommand_GetResult_Response(Message):
    """control_msgs/action/GripperCommand_GetResult_Response"""
    def __init__(self, *, status: int = ..., result: control_msgs.action.GripperCommand_Result = ..., check_fields: bool = ...) -> None: ...
    status: int
    result: control_msgs.action.GripperCommand_Result

class GripperCommand_GetResult_Event(Message):
    """control_msgs/action/GripperCommand_GetResult_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[control_msgs.action.GripperCommand_GetResult_Request] = ..., response: Collection[control_msgs.action.GripperCommand_GetResult_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[control_msgs.action.GripperCommand_GetResult_Request]: ...
    @request.setter
    def request(self, value: Collection[control_msgs.action.GripperCommand_GetResult_Request]) -> None: ...
    @property
    def response(self) -> list[control_msgs.action.GripperCommand_GetResult_Response]: ...
    @response.setter
    def response(self, value: Collection[control_msgs.action.GripperCommand_GetResult_Response]) -> None: ...

class GripperCommand_SendGoal(Service):
    Request: TypeAlias = GripperCommand_SendGoal_Request
    Response: TypeAlias = GripperCommand_SendGoal_Response
    Event: TypeAlias = GripperCommand_SendGoal_Event

class GripperCommand_GetResult(Service):
    Request: TypeAlias = GripperCommand_GetResult_Request
    Response: TypeAlias = GripperCommand_GetResult_Response
    Event: TypeAlias = GripperCommand_GetResult_Event

class GripperCommand(Action):
    Goal: TypeAlias = GripperCommand_Goal
    Result: TypeAlias = GripperCommand_Result
    Feedback: TypeAlias = GripperCommand_Feedback
    class Impl:
        SendGoalService: TypeAlias = GripperCommand_SendGoal
        GetResultService: TypeAlias = GripperCommand_GetResult
        FeedbackMessage: TypeAlias = GripperCommand_FeedbackMessage
        CancelGoalService: TypeAlias = action_msgs.srv.CancelGoal
        GoalStatusMessage: TypeAlias = action_msgs.msg.GoalStatusArray

class JointTrajectory_Goal(Message):
    """control_msgs/action/JointTrajectory_Goal

    # Moves joints through given places, with no word of how it goes.

    trajectory_msgs/JointTrajectory trajectory
    """
    def __init__(self, *, trajectory: trajectory_msgs.msg.JointTrajectory = ..., check_fields: bool = ...) -> None: ...
    trajectory: trajectory_msgs.msg.JointTrajectory

class JointTrajectory_Result(Message):
    """control_msgs/action/JointTrajectory_Result"""
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class JointTrajectory_Feedback(Message):
    """control_msgs/action/JointTrajectory_Feedback"""
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class JointTrajectory_FeedbackMessage(Message):
    """control_msgs/action/JointTrajectory_FeedbackMessage"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., feedback: control_msgs.action.JointTrajectory_Feedback = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    feedback: control_msgs.action.JointTrajectory_Feedback

class JointTrajectory_SendGoal_Request(Message):
    """control_msgs/action/JointTrajectory_SendGoal_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., goal: control_msgs.action.JointTrajectory_Goal = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    goal: control_msgs.action.JointTrajectory_Goal

class JointTrajectory_SendGoal_Response(Message):
    """control_msgs/action/JointTrajectory_SendGoal_Response"""
    def __init__(self, *, accepted: bool = ..., stamp: builtin_interfaces.msg.Time = ..., check_fields: bool = ...) -> None: ...
    accepted: bool
    stamp: builtin_interfaces.msg.Time

class JointTrajectory_SendGoal_Event(Message):
    """control_msgs/action/JointTrajectory_SendGoal_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[control_msgs.action.JointTrajectory_SendGoal_Request] = ..., response: Collection[control_msgs.action.JointTrajectory_SendGoal_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[control_msgs.action.JointTrajectory_SendGoal_Request]: ...
    @request.setter
    def request(self, value: Collection[control_msgs.action.JointTrajectory_SendGoal_Request]) -> None: ...
    @property
    def response(self) -> list[control_msgs.action.JointTrajectory_SendGoal_Response]: ...
    @response.setter
    def response(self, value: Collection[control_msgs.action.JointTrajectory_SendGoal_Response]) -> None: ...

class JointTrajectory_GetResult_Request(Message):
    """control_msgs/action/JointTrajectory_GetResult_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID

class JointTrajectory_GetResult_Response(Message):
    """control_msgs/action/JointTrajectory_GetResult_Response"""
    def __init__(self, *, status: int = ..., result: control_msgs.action.JointTrajectory_Result = ..., check_fields: bool = ...) -> None: ...
    status: int
    result: control_msgs.action.JointTrajectory_Result

class JointTrajectory_GetResult_Event(Message):
    """control_msgs/action/JointTrajectory_GetResult_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[control_msgs.action.JointTrajectory_GetResult_Request] = ..., response: Collection[control_msgs.action.JointTrajectory_GetResult_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[control_msgs.action.JointTrajectory_GetResult_Request]: ...
    @request.setter
    def request(self, value: Collection[control_msgs.action.JointTrajectory_GetResult_Request]) -> None: ...
    @property
    def response(self) -> list[control_msgs.action.JointTrajectory_GetResult_Response]: ...
    @response.setter
    def response(self, value: Collection[control_msgs.action.JointTrajectory_GetResult_Response]) -> None: ...

class JointTrajectory_SendGoal(Service):
    Request: TypeAlias = JointTrajectory_SendGoal_Request
    Response: TypeAlias = JointTrajectory_SendGoal_Response
    Event: TypeAlias = JointTrajectory_SendGoal_Event

class JointTrajectory_GetResult(Service):
    Request: TypeAlias = JointTrajectory_GetResult_Request
    Response: TypeAlias = JointTrajectory_GetResult_Response
    Event: TypeAlias = JointTrajectory_GetResult_Event

class JointTrajectory(Action):
    Goal: TypeAlias = JointTrajectory_Goal
    Result: TypeAlias = JointTrajectory_Result
    Feedback: TypeAlias = JointTrajectory_Feedback
    class Impl:
        SendGoalService: TypeAlias = JointTrajectory_SendGoal
        GetResultService: TypeAlias = JointTrajectory_GetResult
        FeedbackMessage: TypeAlias = JointTrajectory_FeedbackMessage
        CancelGoalService: TypeAlias = action_msgs.srv.CancelGoal
        GoalStatusMessage: TypeAlias = action_msgs.msg.GoalStatusArray

class ParallelGripperCommand_Goal(Message):
    """control_msgs/action/ParallelGripperCommand_Goal

    # Opens or closes a gripper whose fingers move towards each other; speeds and efforts are limits.

    sensor_msgs/JointState command
    """
    def __init__(self, *, command: sensor_msgs.msg.JointState = ..., check_fields: bool = ...) -> None: ...
    command: sensor_msgs.msg.JointState

class ParallelGripperCommand_Result(Message):
    """control_msgs/action/ParallelGripperCommand_Result

    sensor_msgs/JointState state
    bool stalled       # it pushes as strongly as it may, and does not move
    bool reached_goal
    """
    def __init__(self, *, state: sensor_msgs.msg.JointState = ..., stalled: bool = ..., reached_goal: bool = ..., check_fields: bool = ...) -> None: ...
    state: sensor_msgs.msg.JointState
    stalled: bool
    reached_goal: bool

class ParallelGripperCommand_Feedback(Message):
    """control_msgs/action/ParallelGripperCommand_Feedback

    sensor_msgs/JointState state
    """
    def __init__(self, *, state: sensor_msgs.msg.JointState = ..., check_fields: bool = ...) -> None: ...
    state: sensor_msgs.msg.JointState

class ParallelGripperCommand_FeedbackMessage(Message):
    """control_msgs/action/ParallelGripperCommand_FeedbackMessage"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., feedback: control_msgs.action.ParallelGripperCommand_Feedback = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    feedback: control_msgs.action.ParallelGripperCommand_Feedback

class ParallelGripperCommand_SendGoal_Request(Message):
    """control_msgs/action/ParallelGripperCommand_SendGoal_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., goal: control_msgs.action.ParallelGripperCommand_Goal = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    goal: control_msgs.action.ParallelGripperCommand_Goal

class ParallelGripperCommand_SendGoal_Response(Message):
    """control_msgs/action/ParallelGripperCommand_SendGoal_Response"""
    def __init__(self, *, accepted: bool = ..., stamp: builtin_interfaces.msg.Time = ..., check_fields: bool = ...) -> None: ...
    accepted: bool
    stamp: builtin_interfaces.msg.Time

class ParallelGripperCommand_SendGoal_Event(Message):
    """control_msgs/action/ParallelGripperCommand_SendGoal_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[control_msgs.action.ParallelGripperCommand_SendGoal_Request] = ..., response: Collection[control_msgs.action.ParallelGripperCommand_SendGoal_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[control_msgs.action.ParallelGripperCommand_SendGoal_Request]: ...
    @request.setter
    def request(self, value: Collection[control_msgs.action.ParallelGripperCommand_SendGoal_Request]) -> None: ...
    @property
    def response(self) -> list[control_msgs.action.ParallelGripperCommand_SendGoal_Response]: ...
    @response.setter
    def response(self, value: Collection[control_msgs.action.ParallelGripperCommand_SendGoal_Response]) -> None: ...

class ParallelGripperCommand_GetResult_Request(Message):
    """control_msgs/action/ParallelGripperCommand_GetResult_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID

class ParallelGripperCommand_GetResult_Response(Message):
    """control_msgs/action/ParallelGripperCommand_GetResult_Response"""
    def __init__(self, *, status: int = ..., result: control_msgs.action.ParallelGripperCommand_Result = ..., check_fields: bool = ...) -> None: ...
    status: int
    result: control_msgs.action.ParallelGripperCommand_Result

class ParallelGripperCommand_GetResult_Event(Message):
    """control_msgs/action/ParallelGripperCommand_GetResult_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[control_msgs.action.ParallelGripperCommand_GetResult_Request] = ..., response: Collection[control_msgs.action.ParallelGripperCommand_GetResult_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[control_msgs.action.ParallelGripperCommand_GetResult_Request]: ...
    @request.setter
    def request(self, value: Collection[control_msgs.action.ParallelGripperCommand_GetResult_Request]) -> None: ...
    @property
    def response(self) -> list[control_msgs.action.ParallelGripperCommand_GetResult_Response]: ...
    @response.setter
    def response(self, value: Collection[control_msgs.action.ParallelGripperCommand_GetResult_Response]) -> None: ...

class ParallelGripperCommand_SendGoal(Service):
    Request: TypeAlias = ParallelGripperCommand_SendGoal_Request
    Response: TypeAlias = ParallelGripperCommand_SendGoal_Response
    Event: TypeAlias = ParallelGripperCommand_SendGoal_Event

class ParallelGripperCommand_GetResult(Service):
    Request: TypeAlias = ParallelGripperCommand_GetResult_Request
    Response: TypeAlias = ParallelGripperCommand_GetResult_Response
    Event: TypeAlias = ParallelGripperCommand_GetResult_Event

class ParallelGripperCommand(Action):
    Goal: TypeAlias = ParallelGripperCommand_Goal
    Result: TypeAlias = ParallelGripperCommand_Result
    Feedback: TypeAlias = ParallelGripperCommand_Feedback
    class Impl:
        SendGoalService: TypeAlias = ParallelGripperCommand_SendGoal
        GetResultService: TypeAlias = ParallelGripperCommand_GetResult
        FeedbackMessage: TypeAlias = ParallelGripperCommand_FeedbackMessage
        CancelGoalService: TypeAlias = action_msgs.srv.CancelGoal
        GoalStatusMessage: TypeAlias = action_msgs.msg.GoalStatusArray

class PointHead_Goal(Message):
    """control_msgs/action/PointHead_Goal

    # Turns a head until an axis of it points to a place.

    geometry_msgs/PointStamped target
    geometry_msgs/Vector3 pointing_axis  # in the frame that follows
    string pointing_frame
    builtin_interfaces/Duration min_duration
    float64 max_velocity  # rad/s
    """
    def __init__(self, *, target: geometry_msgs.msg.PointStamped = ..., pointing_axis: geometry_msgs.msg.Vector3 = ..., pointing_frame: str = ..., min_duration: builtin_interfaces.msg.Duration = ..., max_velocity: float = ..., check_fields: bool = ...) -> None: ...
    target: geometry_msgs.msg.PointStamped
    pointing_axis: geometry_msgs.msg.Vector3
    pointing_frame: str
    min_duration: builtin_interfaces.msg.Duration
    max_velocity: float

class PointHead_Result(Message):
    """control_msgs/action/PointHead_Result"""
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class PointHead_Feedback(Message):
    """control_msgs/action/PointHead_Feedback

    float64 pointing_angle_error  # rad
    """
    def __init__(self, *, pointing_angle_error: float = ..., check_fields: bool = ...) -> None: ...
    pointing_angle_error: float

class PointHead_FeedbackMessage(Message):
    """control_msgs/action/PointHead_FeedbackMessage"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., feedback: control_msgs.action.PointHead_Feedback = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    feedback: control_msgs.action.PointHead_Feedback

class PointHead_SendGoal_Request(Message):
    """control_msgs/action/PointHead_SendGoal_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., goal: control_msgs.action.PointHead_Goal = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    goal: control_msgs.action.PointHead_Goal

class PointHead_SendGoal_Response(Message):
    """control_msgs/action/PointHead_SendGoal_Response"""
    def __init__(self, *, accepted: bool = ..., stamp: builtin_interfaces.msg.Time = ..., check_fields: bool = ...) -> None: ...
    accepted: bool
    stamp: builtin_interfaces.msg.Time

class PointHead_SendGoal_Event(Message):
    """control_msgs/action/PointHead_SendGoal_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[control_msgs.action.PointHead_SendGoal_Request] = ..., response: Collection[control_msgs.action.PointHead_SendGoal_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[control_msgs.action.PointHead_SendGoal_Request]: ...
    @request.setter
    def request(self, value: Collection[control_msgs.action.PointHead_SendGoal_Request]) -> None: ...
    @property
    def response(self) -> list[control_msgs.action.PointHead_SendGoal_Response]: ...
    @response.setter
    def response(self, value: Collection[control_msgs.action.PointHead_SendGoal_Response]) -> None: ...

class PointHead_GetResult_Request(Message):
    """control_msgs/action/PointHead_GetResult_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID

class PointHead_GetResult_Response(Message):
    """control_msgs/action/PointHead_GetResult_Response"""
    def __init__(self, *, status: int = ..., result: control_msgs.action.PointHead_Result = ..., check_fields: bool = ...) -> None: ...
    status: int
    result: control_msgs.action.PointHead_Result

class PointHead_GetResult_Event(Message):
    """control_msgs/action/PointHead_GetResult_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[control_msgs.action.PointHead_GetResult_Request] = ..., response: Collection[control_msgs.action.PointHead_GetResult_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[control_msgs.action.PointHead_GetResult_Request]: ...
    @request.setter
    def request(self, value: Collection[control_msgs.action.PointHead_GetResult_Request]) -> None: ...
    @property
    def response(self) -> list[control_msgs.action.PointHead_GetResult_Response]: ...
    @response.setter
    def response(self, value: Collection[control_msgs.action.PointHead_GetResult_Response]) -> None: ...

class PointHead_SendGoal(Service):
    Request: TypeAlias = PointHead_SendGoal_Request
    Response: TypeAlias = PointHead_SendGoal_Response
    Event: TypeAlias = PointHead_SendGoal_Event

class PointHead_GetResult(Service):
    Request: TypeAlias = PointHead_GetResult_Request
    Response: TypeAlias = PointHead_GetResult_Response
    Event: TypeAlias = PointHead_GetResult_Event

class PointHead(Action):
    Goal: TypeAlias = PointHead_Goal
    Result: TypeAlias = PointHead_Result
    Feedback: TypeAlias = PointHead_Feedback
    class Impl:
        SendGoalService: TypeAlias = PointHead_SendGoal
        GetResultService: TypeAlias = PointHead_GetResult
        FeedbackMessage: TypeAlias = PointHead_FeedbackMessage
        CancelGoalService: TypeAlias = action_msgs.srv.CancelGoal
        GoalStatusMessage: TypeAlias = action_msgs.msg.GoalStatusArray

class SingleJointPosition_Goal(Message):
    """control_msgs/action/SingleJointPosition_Goal

    # Moves one joint.

    float64 position
    builtin_interfaces/Duration min_duration
    float64 max_velocity
    """
    def __init__(self, *, position: float = ..., min_duration: builtin_interfaces.msg.Duration = ..., max_velocity: float = ..., check_fields: bool = ...) -> None: ...
    position: float
    min_duration: builtin_interfaces.msg.Duration
    max_velocity: float

class SingleJointPosition_Result(Message):
    """control_msgs/action/SingleJointPosition_Result"""
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class SingleJointPosition_Feedback(Message):
    """control_msgs/action/SingleJointPosition_Feedback

    std_msgs/Header header
    float64 position
    float64 velocity
    float64 error
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., position: float = ..., velocity: float = ..., error: float = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    position: float
    velocity: float
    error: float

class SingleJointPosition_FeedbackMessage(Message):
    """control_msgs/action/SingleJointPosition_FeedbackMessage"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., feedback: control_msgs.action.SingleJointPosition_Feedback = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    feedback: control_msgs.action.SingleJointPosition_Feedback

class SingleJointPosition_SendGoal_Request(Message):
    """control_msgs/action/SingleJointPosition_SendGoal_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., goal: control_msgs.action.SingleJointPosition_Goal = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    goal: control_msgs.action.SingleJointPosition_Goal

class SingleJointPosition_SendGoal_Response(Message):
    """control_msgs/action/SingleJointPosition_SendGoal_Response"""
    def __init__(self, *, accepted: bool = ..., stamp: builtin_interfaces.msg.Time = ..., check_fields: bool = ...) -> None: ...
    accepted: bool
    stamp: builtin_interfaces.msg.Time

class SingleJointPosition_SendGoal_Event(Message):
    """control_msgs/action/SingleJointPosition_SendGoal_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[control_msgs.action.SingleJointPosition_SendGoal_Request] = ..., response: Collection[control_msgs.action.SingleJointPosition_SendGoal_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[control_msgs.action.SingleJointPosition_SendGoal_Request]: ...
    @request.setter
    def request(self, value: Collection[control_msgs.action.SingleJointPosition_SendGoal_Request]) -> None: ...
    @property
    def response(self) -> list[control_msgs.action.SingleJointPosition_SendGoal_Response]: ...
    @response.setter
    def response(self, value: Collection[control_msgs.action.SingleJointPosition_SendGoal_Response]) -> None: ...

class SingleJointPosition_GetResult_Request(Message):
    """control_msgs/action/SingleJointPosition_GetResult_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID

class SingleJointPosition_GetResult_Response(Message):
    """control_msgs/action/SingleJointPosition_GetResult_Response"""
    def __init__(self, *, status: int = ..., result: control_msgs.action.SingleJointPosition_Result = ..., check_fields: bool = ...) -> None: ...
    status: int
    result: control_msgs.action.SingleJointPosition_Result

class SingleJointPosition_GetResult_Event(Message):
    """control_msgs/action/SingleJointPosition_GetResult_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[control_msgs.action.SingleJointPosition_GetResult_Request] = ..., response: Collection[control_msgs.action.SingleJointPosition_GetResult_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[control_msgs.action.SingleJointPosition_GetResult_Request]: ...
    @request.setter
    def request(self, value: Collection[control_msgs.action.SingleJointPosition_GetResult_Request]) -> None: ...
    @property
    def response(self) -> list[control_msgs.action.SingleJointPosition_GetResult_Response]: ...
    @response.setter
    def response(self, value: Collection[control_msgs.action.SingleJointPosition_GetResult_Response]) -> None: ...

class SingleJointPosition_SendGoal(Service):
    Request: TypeAlias = SingleJointPosition_SendGoal_Request
    Response: TypeAlias = SingleJointPosition_SendGoal_Response
    Event: TypeAlias = SingleJointPosition_SendGoal_Event

class SingleJointPosition_GetResult(Service):
    Request: TypeAlias = SingleJointPosition_GetResult_Request
    Response: TypeAlias = SingleJointPosition_GetResult_Response
    Event: TypeAlias = SingleJointPosition_GetResult_Event

class SingleJointPosition(Action):
    Goal: TypeAlias = SingleJointPosition_Goal
    Result: TypeAlias = SingleJointPosition_Result
    Feedback: TypeAlias = SingleJointPosition_Feedback
    class Impl:
        SendGoalService: TypeAlias = SingleJointPosition_SendGoal
        GetResultService: TypeAlias = SingleJointPosition_GetResult
        FeedbackMessage: TypeAlias = SingleJointPosition_FeedbackMessage
        CancelGoalService: TypeAlias = action_msgs.srv.CancelGoal
        GoalStatusMessage: TypeAlias = action_msgs.msg.GoalStatusArray
