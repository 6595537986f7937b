# Written by python -m zbot.interfaces.stubs; do not edit.
from array import array
from collections.abc import Collection
from typing import Final, TypeAlias

import numpy
from numpy.typing import NDArray

import geometry_msgs.msg
import moveit_msgs.msg
import moveit_msgs.srv
import sensor_msgs.msg
import service_msgs.msg
import std_msgs.msg
from zbot.interfaces import Action, Message, Service

class ApplyPlanningScene_Request(Message):
    """moveit_msgs/srv/ApplyPlanningScene_Request

    # Changes the scene.

    PlanningScene scene
    """
    def __init__(self, *, scene: moveit_msgs.msg.PlanningScene = ..., check_fields: bool = ...) -> None: ...
    scene: moveit_msgs.msg.PlanningScene

class ApplyPlanningScene_Response(Message):
    """moveit_msgs/srv/ApplyPlanningScene_Response

    bool success
    """
    def __init__(self, *, success: bool = ..., check_fields: bool = ...) -> None: ...
    success: bool

class ApplyPlanningScene_Event(Message):
    """moveit_msgs/srv/ApplyPlanningScene_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[moveit_msgs.srv.ApplyPlanningScene_Request] = ..., response: Collection[moveit_msgs.srv.ApplyPlanningScene_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[moveit_msgs.srv.ApplyPlanningScene_Request]: ...
    @request.setter
    def request(self, value: Collection[moveit_msgs.srv.ApplyPlanningScene_Request]) -> None: ...
    @property
    def response(self) -> list[moveit_msgs.srv.ApplyPlanningScene_Response]: ...
    @response.setter
    def response(self, value: Collection[moveit_msgs.srv.ApplyPlanningScene_Response]) -> None: ...

class ApplyPlanningScene(Service):
    Request: TypeAlias = ApplyPlanningScene_Request
    Response: TypeAlias = ApplyPlanningScene_Response
    Event: TypeAlias = ApplyPlanningScene_Event

class CheckIfRobotStateExistsInWarehouse_Request(Message):
    """moveit_msgs/srv/CheckIfRobotStateExistsInWarehouse_Request

    # Says whether a state is stored.

    string name
    string robot
    """
    def __init__(self, *, name: str = ..., robot: str = ..., check_fields: bool = ...) -> None: ...
    name: str
    robot: str

class CheckIfRobotStateExistsInWarehouse_Response(Message):
    """moveit_msgs/srv/CheckIfRobotStateExistsInWarehouse_Response

    bool exists
    """
    def __init__(self, *, exists: bool = ..., check_fields: bool = ...) -> None: ...
    exists: bool

class CheckIfRobotStateExistsInWarehouse_Event(Message):
    """moveit_msgs/srv/CheckIfRobotStateExistsInWarehouse_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[moveit_msgs.srv.CheckIfRobotStateExistsInWarehouse_Request] = ..., response: Collection[moveit_msgs.srv.CheckIfRobotStateExistsInWarehouse_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[moveit_msgs.srv.CheckIfRobotStateExistsInWarehouse_Request]: ...
    @request.setter
    def request(self, value: Collection[moveit_msgs.srv.CheckIfRobotStateExistsInWarehouse_Request]) -> None: ...
    @property
    def response(self) -> list[moveit_msgs.srv.CheckIfRobotStateExistsInWarehouse_Response]: ...
    @response.setter
    def response(self, value: Collection[moveit_msgs.srv.CheckIfRobotStateExistsInWarehouse_Response]) -> None: ...

class CheckIfRobotStateExistsInWarehouse(Service):
    Request: TypeAlias = CheckIfRobotStateExistsInWarehouse_Request
    Response: TypeAlias = CheckIfRobotStateExistsInWarehouse_Response
    Event: TypeAlias = CheckIfRobotStateExistsInWarehouse_Event

class DeleteRobotStateFromWarehouse_Request(Message):
    """moveit_msgs/srv/DeleteRobotStateFromWarehouse_Request

    # Deletes a stored state.

    string name
    string robot
    """
    def __init__(self, *, name: str = ..., robot: str = ..., check_fields: bool = ...) -> None: ...
    name: str
    robot: str

class DeleteRobotStateFromWarehouse_Response(Message):
    """moveit_msgs/srv/DeleteRobotStateFromWarehouse_Response"""
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class DeleteRobotStateFromWarehouse_Event(Message):
    """moveit_msgs/srv/DeleteRobotStateFromWarehouse_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[moveit_msgs.srv.DeleteRobotStateFromWarehouse_Request] = ..., response: Collection[moveit_msgs.srv.DeleteRobotStateFromWarehouse_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[moveit_msgs.srv.DeleteRobotStateFromWarehouse_Request]: ...
    @request.setter
    def request(self, value: Collection[moveit_msgs.srv.DeleteRobotStateFromWarehouse_Request]) -> None: ...
    @property
    def response(self) -> list[moveit_msgs.srv.DeleteRobotStateFromWarehouse_Response]: ...
    @response.setter
    def response(self, value: Collection[moveit_msgs.srv.DeleteRobotStateFromWarehouse_Response]) -> None: ...

class DeleteRobotStateFromWarehouse(Service):
    Request: TypeAlias = DeleteRobotStateFromWarehouse_Request
    Response: TypeAlias = DeleteRobotStateFromWarehouse_Response
    Event: TypeAlias = DeleteRobotStateFromWarehouse_Event

class GetCartesianPath_Request(Message):
    """moveit_msgs/srv/GetCartesianPath_Request

    # Plans straight lines through poses of a link.

    std_msgs/Header header
    RobotState start_state
    string group_name
    string link_name
    geometry_msgs/Pose[] waypoints
    float64 max_step  # m, between two points of the result
    float64 jump_threshold  # largest jump of the joints, in steps, or 0.0
    float64 prismatic_jump_threshold
    float64 revolute_jump_threshold
    bool avoid_collisions
    Constraints path_constraints
    float64 max_velocity_scaling_factor
    float64 max_acceleration_scaling_factor
    string cartesian_speed_limited_link
    float64 max_cartesian_speed
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., start_state: moveit_msgs.msg.RobotState = ..., group_name: str = ..., link_name: str = ..., waypoints: Collection[geometry_msgs.msg.Pose] = ..., max_step: float = ..., jump_threshold: float = ..., prismatic_jump_threshold: float = ..., revolute_jump_threshold: float = ..., avoid_collisions: bool = ..., path_constraints: moveit_msgs.msg.Constraints = ..., max_velocity_scaling_factor: float = ..., max_acceleration_scaling_factor: float = ..., cartesian_speed_limited_link: str = ..., max_cartesian_speed: float = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    start_state: moveit_msgs.msg.RobotState
    group_name: str
    link_name: str
    @property
    def waypoints(self) -> list[geometry_msgs.msg.Pose]: ...
    @waypoints.setter
    def waypoints(self, value: Collection[geometry_msgs.msg.Pose]) -> None: ...
    max_step: float
    jump_threshold: float
    prismatic_jump_threshold: float
    revolute_jump_threshold: float
    avoid_collisions: bool
    path_constraints: moveit_msgs.msg.Constraints
    max_velocity_scaling_factor: float
    max_acceleration_scaling_factor: float
    cartesian_speed_limited_link: str
    max_cartesian_speed: float

class GetCartesianPath_Response(Message):
    """moveit_msgs/srv/GetCartesianPath_Response

    RobotState start_state
    RobotTrajectory solution
    float64 fraction  # part of the way that was found, 0.0 to 1.0
    MoveItErrorCodes error_code
    """
    def __init__(self, *, start_state: moveit_msgs.msg.RobotState = ..., solution: moveit_msgs.msg.RobotTrajectory = ..., fraction: float = ..., error_code: moveit_msgs.msg.MoveItErrorCodes = ..., check_fields: bool = ...) -> None: ...
    start_state: moveit_msgs.msg.RobotState
    solution: moveit_msgs.msg.RobotTrajectory
    fraction: float
    error_code: moveit_msgs.msg.MoveItErrorCodes

class GetCartesianPath_Event(Message):
    """moveit_msgs/srv/GetCartesianPath_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[moveit_msgs.srv.GetCartesianPath_Request] = ..., response: Collection[moveit_msgs.srv.GetCartesianPath_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[moveit_msgs.srv.GetCartesianPath_Request]: ...
    @request.setter
    def request(self, value: Collection[moveit_msgs.srv.GetCartesianPath_Request]) -> None: ...
    @property
    def response(self) -> list[moveit_msgs.srv.GetCartesianPath_Response]: ...
    @response.setter
    def response(self, value: Collection[moveit_msgs.srv.GetCartesianPath_Response]) -> None: ...

class GetCartesianPath(Service):
    Request: TypeAlias = GetCartesianPath_Request
    Response: TypeAlias = GetCartesianPath_Response
    Event: TypeAlias = GetCartesianPath_Event

class GetGroupUrdf_Request(Message):
    """moveit_msgs/srv/GetGroupUrdf_Request

    # Returns the URDF of a group of joints.

    string group_name
    """
    def __init__(self, *, group_name: str = ..., check_fields: bool = ...) -> None: ...
    group_name: str

class GetGroupUrdf_Response(Message):
    """moveit_msgs/srv/GetGroupUrdf_Response

    MoveItErrorCodes error_code
    string urdf_string
    """
    def __init__(self, *, error_code: moveit_msgs.msg.MoveItErrorCodes = ..., urdf_string: str = ..., check_fields: bool = ...) -> None: ...
    error_code: moveit_msgs.msg.MoveItErrorCodes
    urdf_string: str

class GetGroupUrdf_Event(Message):
    """moveit_msgs/srv/GetGroupUrdf_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[moveit_msgs.srv.GetGroupUrdf_Request] = ..., response: Collection[moveit_msgs.srv.GetGroupUrdf_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[moveit_msgs.srv.GetGroupUrdf_Request]: ...
    @request.setter
    def request(self, value: Collection[moveit_msgs.srv.GetGroupUrdf_Request]) -> None: ...
    @property
    def response(self) -> list[moveit_msgs.srv.GetGroupUrdf_Response]: ...
    @response.setter
    def response(self, value: Collection[moveit_msgs.srv.GetGroupUrdf_Response]) -> None: ...

class GetGroupUrdf(Service):
    Request: TypeAlias = GetGroupUrdf_Request
    Response: TypeAlias = GetGroupUrdf_Response
    Event: TypeAlias = GetGroupUrdf_Event

class GetMotionPlan_Request(Message):
    """moveit_msgs/srv/GetMotionPlan_Request

    # Plans a motion.

    MotionPlanRequest motion_plan_request
    """
    def __init__(self, *, motion_plan_request: moveit_msgs.msg.MotionPlanRequest = ..., check_fields: bool = ...) -> None: ...
    motion_plan_request: moveit_msgs.msg.MotionPlanRequest

class GetMotionPlan_Response(Message):
    """moveit_msgs/srv/GetMotionPlan_Response

    MotionPlanResponse motion_plan_response
    """
    def __init__(self, *, motion_plan_response: moveit_msgs.msg.MotionPlanResponse = ..., check_fields: bool = ...) -> None: ...
    motion_plan_response: moveit_msgs.msg.MotionPlanResponse

class GetMotionPlan_Event(Message):
    """moveit_msgs/srv/GetMotionPlan_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[moveit_msgs.srv.GetMotionPlan_Request] = ..., response: Collection[moveit_msgs.srv.GetMotionPlan_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[moveit_msgs.srv.GetMotionPlan_Request]: ...
    @request.setter
    def request(self, value: Collection[moveit_msgs.srv.GetMotionPlan_Request]) -> None: ...
    @property
    def response(self) -> list[moveit_msgs.srv.GetMotionPlan_Response]: ...
    @response.setter
    def response(self, value: Collection[moveit_msgs.srv.GetMotionPlan_Response]) -> None: ...

class GetMotionPlan(Service):
    Request: TypeAlias = GetMotionPlan_Request
    Response: TypeAlias = GetMotionPlan_Response
    Event: TypeAlias = GetMotionPlan_Event

class GetMotionSequence_Request(Message):
    """moveit_msgs/srv/GetMotionSequence_Request

    # Plans several motions.

    MotionSequenceRequest request
    """
    def __init__(self, *, request: moveit_msgs.msg.MotionSequenceRequest = ..., check_fields: bool = ...) -> None: ...
    request: moveit_msgs.msg.MotionSequenceRequest

class GetMotionSequence_Response(Message):
    """moveit_msgs/srv/GetMotionSequence_Response

    MotionSequenceResponse response
    """
    def __init__(self, *, response: moveit_msgs.msg.MotionSequenceResponse = ..., check_fields: bool = ...) -> None: ...
    response: moveit_msgs.msg.MotionSequenceResponse

class GetMotionSequence_Event(Message):
    """moveit_msgs/srv/GetMotionSequence_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[moveit_msgs.srv.GetMotionSequence_Request] = ..., response: Collection[moveit_msgs.srv.GetMotionSequence_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[moveit_msgs.srv.GetMotionSequence_Request]: ...
    @request.setter
    def request(self, value: Collection[moveit_msgs.srv.GetMotionSequence_Request]) -> None: ...
    @property
    def response(self) -> list[moveit_msgs.srv.GetMotionSequence_Response]: ...
    @response.setter
    def response(self, value: Collection[moveit_msgs.srv.GetMotionSequence_Response]) -> None: ...

class GetMotionSequence(Service):
    Request: TypeAlias = GetMotionSequence_Request
    Response: TypeAlias = GetMotionSequence_Response
    Event: TypeAlias = GetMotionSequence_Event

class GetMultiStateValidity_Request(Message):
    """moveit_msgs/srv/GetMultiStateValidity_Request

    # Says whether all of several states are valid.

    RobotState robot_state
    sensor_msgs/JointState[] joint_states
    string group_name
    Constraints constraints
    """
    def __init__(self, *, robot_state: moveit_msgs.msg.RobotState = ..., joint_states: Collection[sensor_msgs.msg.JointState] = ..., group_name: str = ..., constraints: moveit_msgs.msg.Constraints = ..., check_fields: bool = ...) -> None: ...
    robot_state: moveit_msgs.msg.RobotState
    @property
    def joint_states(self) -> list[sensor_msgs.msg.JointState]: ...
    @joint_states.setter
    def joint_states(self, value: Collection[sensor_msgs.msg.JointState]) -> None: ...
    group_name: str
    constraints: moveit_msgs.msg.Constraints

class GetMultiStateValidity_Response(Message):
    """moveit_msgs/srv/GetMultiStateValidity_Response

    bool valid
    ContactInformation[] contacts
    CostSource[] cost_sources
    ConstraintEvalResult[] constraint_result
    """
    def __init__(self, *, valid: bool = ..., contacts: Collection[moveit_msgs.msg.ContactInformation] = ..., cost_sources: Collection[moveit_msgs.msg.CostSource] = ..., constraint_result: Collection[moveit_msgs.msg.ConstraintEvalResult] = ..., check_fields: bool = ...) -> None: ...
    valid: bool
    @property
    def contacts(self) -> list[moveit_msgs.msg.ContactInformation]: ...
    @contacts.setter
    def contacts(self, value: Collection[moveit_msgs.msg.ContactInformation]) -> None: ...
    @property
    def cost_sources(self) -> list[moveit_msgs.msg.CostSource]: ...
    @cost_sources.setter
    def cost_sources(self, value: Collection[moveit_msgs.msg.CostSource]) -> None: ...
    @property
    def constraint_result(self) -> list[moveit_msgs.msg.ConstraintEvalResult]: ...
    @constraint_result.setter
    def constraint_result(self, value: Collection[moveit_msgs.msg.ConstraintEvalResult]) -> None: ...

class GetMultiStateValidity_Event(Message):
    """moveit_msgs/srv/GetMultiStateValidity_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[moveit_msgs.srv.GetMultiStateValidity_Request] = ..., response: Collection[moveit_msgs.srv.GetMultiStateValidity_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[moveit_msgs.srv.GetMultiStateValidity_Request]: ...
    @request.setter
    def request(self, value: Collection[moveit_msgs.srv.GetMultiStateValidity_Request]) -> None: ...
    @property
    def response(self) -> list[moveit_msgs.srv.GetMultiStateValidity_Response]: ...
    @response.setter
    def response(self, value: Collection[moveit_msgs.srv.GetMultiStateValidity_Response]) -> None: ...

class GetMultiStateValidity(Service):
    Request: TypeAlias = GetMultiStateValidity_Request
    Response: TypeAlias = GetMultiStateValidity_Response
    Event: TypeAlias = GetMultiStateValidity_Event

class GetPlannerParams_Request(Message):
    """moveit_msgs/srv/GetPlannerParams_Request

    # Returns the parameters of a planner.

    string pipeline_id
    string planner_config
    string group
    """
    def __init__(self, *, pipeline_id: str = ..., planner_config: str = ..., group: str = ..., check_fields: bool = ...) -> None: ...
    pipeline_id: str
    planner_config: str
    group: str

class GetPlannerParams_Response(Message):
    """moveit_msgs/srv/GetPlannerParams_Response

    PlannerParams params
    """
    def __init__(self, *, params: moveit_msgs.msg.PlannerParams = ..., check_fields: bool = ...) -> None: ...
    params: moveit_msgs.msg.PlannerParams

class GetPlannerParams_Event(Message):
    """moveit_msgs/srv/GetPlannerParams_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[moveit_msgs.srv.GetPlannerParams_Request] = ..., response: Collection[moveit_msgs.srv.GetPlannerParams_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[moveit_msgs.srv.GetPlannerParams_Request]: ...
    @request.setter
    def request(self, value: Collection[moveit_msgs.srv.GetPlannerParams_Request]) -> None: ...
    @property
    def response(self) -> list[moveit_msgs.srv.GetPlannerParams_Response]: ...
    @response.setter
    def response(self, value: Collection[moveit_msgs.srv.GetPlannerParams_Response]) -> None: ...

class GetPlannerParams(Service):
    Request: TypeAlias = GetPlannerParams_Request
    Response: TypeAlias = GetPlannerParams_Response
    Event: TypeAlias = GetPlannerParams_Event

class GetPlanningScene_Request(Message):
    """moveit_msgs/srv/GetPlanningScene_Request

    # Returns the scene.

    PlanningSceneComponents components
    """
    def __init__(self, *, components: moveit_msgs.msg.PlanningSceneComponents = ..., check_fields: bool = ...) -> None: ...
    components: moveit_msgs.msg.PlanningSceneComponents

class GetPlanningScene_Response(Message):
    """moveit_msgs/srv/GetPlanningScene_Response

    PlanningScene scene
    """
    def __init__(self, *, scene: moveit_msgs.msg.PlanningScene = ..., check_fields: bool = ...) -> None: ...
    scene: moveit_msgs.msg.PlanningScene

class GetPlanningScene_Event(Message):
    """moveit_msgs/srv/GetPlanningScene_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[moveit_msgs.srv.GetPlanningScene_Request] = ..., response: Collection[moveit_msgs.srv.GetPlanningScene_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[moveit_msgs.srv.GetPlanningScene_Request]: ...
    @request.setter
    def request(self, value: Collection[moveit_msgs.srv.GetPlanningScene_Request]) -> None: ...
    @property
    def response(self) -> list[moveit_msgs.srv.GetPlanningScene_Response]: ...
    @response.setter
    def response(self, value: Collection[moveit_msgs.srv.GetPlanningScene_Response]) -> None: ...

class GetPlanningScene(Service):
    Request: TypeAlias = GetPlanningScene_Request
    Response: TypeAlias = GetPlanningScene_Response
    Event: TypeAlias = GetPlanningScene_Event

class GetPositionFK_Request(Message):
    """moveit_msgs/srv/GetPositionFK_Request

    # Returns the poses of links for positions of joints.

    std_msgs/Header header
    string[] fk_link_names
    RobotState robot_state
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., fk_link_names: Collection[str] = ..., robot_state: moveit_msgs.msg.RobotState = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    @property
    def fk_link_names(self) -> list[str]: ...
    @fk_link_names.setter
    def fk_link_names(self, value: Collection[str]) -> None: ...
    robot_state: moveit_msgs.msg.RobotState

class GetPositionFK_Response(Message):
    """moveit_msgs/srv/GetPositionFK_Response

    geometry_msgs/PoseStamped[] pose_stamped
    string[] fk_link_names
    MoveItErrorCodes error_code
    """
    def __init__(self, *, pose_stamped: Collection[geometry_msgs.msg.PoseStamped] = ..., fk_link_names: Collection[str] = ..., error_code: moveit_msgs.msg.MoveItErrorCodes = ..., check_fields: bool = ...) -> None: ...
    @property
    def pose_stamped(self) -> list[geometry_msgs.msg.PoseStamped]: ...
    @pose_stamped.setter
    def pose_stamped(self, value: Collection[geometry_msgs.msg.PoseStamped]) -> None: ...
    @property
    def fk_link_names(self) -> list[str]: ...
    @fk_link_names.setter
    def fk_link_names(self, value: Collection[str]) -> None: ...
    error_code: moveit_msgs.msg.MoveItErrorCodes

class GetPositionFK_Event(Message):
    """moveit_msgs/srv/GetPositionFK_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[moveit_msgs.srv.GetPositionFK_Request] = ..., response: Collection[moveit_msgs.srv.GetPositionFK_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[moveit_msgs.srv.GetPositionFK_Request]: ...
    @request.setter
    def request(self, value: Collection[moveit_msgs.srv.GetPositionFK_Request]) -> None: ...
    @property
    def response(self) -> list[moveit_msgs.srv.GetPositionFK_Response]: ...
    @response.setter
    def response(self, value: Collection[moveit_msgs.srv.GetPositionFK_Response]) -> None: ...

class GetPositionFK(Service):
    Request: TypeAlias = GetPositionFK_Request
    Response: TypeAlias = GetPositionFK_Response
    Event: TypeAlias = GetPositionFK_Event

class GetPositionIK_Request(Message):
    """moveit_msgs/srv/GetPositionIK_Request

    # Returns positions of joints for a pose of a link.

    PositionIKRequest ik_request
    """
    def __init__(self, *, ik_request: moveit_msgs.msg.PositionIKRequest = ..., check_fields: bool = ...) -> None: ...
    ik_request: moveit_msgs.msg.PositionIKRequest

class GetPositionIK_Response(Message):
    """moveit_msgs/srv/GetPositionIK_Response

    RobotState solution
    MoveItErrorCodes error_code
    """
    def __init__(self, *, solution: moveit_msgs.msg.RobotState = ..., error_code: moveit_msgs.msg.MoveItErrorCodes = ..., check_fields: bool = ...) -> None: ...
    solution: moveit_msgs.msg.RobotState
    error_code: moveit_msgs.msg.MoveItErrorCodes

class GetPositionIK_Event(Message):
    """moveit_msgs/srv/GetPositionIK_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[moveit_msgs.srv.GetPositionIK_Request] = ..., response: Collection[moveit_msgs.srv.GetPositionIK_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[moveit_msgs.srv.GetPositionIK_Request]: ...
    @request.setter
    def request(self, value: Collection[moveit_msgs.srv.GetPositionIK_Request]) -> None: ...
    @property
    def response(self) -> list[moveit_msgs.srv.GetPositionIK_Response]: ...
    @response.setter
    def response(self, value: Collection[moveit_msgs.srv.GetPositionIK_Response]) -> None: ...

class GetPositionIK(Service):
    Request: TypeAlias = GetPositionIK_Request
    Response: TypeAlias = GetPositionIK_Response
    Event: TypeAlias = GetPositionIK_Event

class GetRobotStateFromWarehouse_Request(Message):
    """moveit_msgs/srv/GetRobotStateFromWarehouse_Request

    # Returns a stored state.

    string name
    string robot
    """
    def __init__(self, *, name: str = ..., robot: str = ..., check_fields: bool = ...) -> None: ...
    name: str
    robot: str

class GetRobotStateFromWarehouse_Response(Message):
    """moveit_msgs/srv/GetRobotStateFromWarehouse_Response

    moveit_msgs/RobotState state
    """
    def __init__(self, *, state: moveit_msgs.msg.RobotState = ..., check_fields: bool = ...) -> None: ...
    state: moveit_msgs.msg.RobotState

class GetRobotStateFromWarehouse_Event(Message):
    """moveit_msgs/srv/GetRobotStateFromWarehouse_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[moveit_msgs.srv.GetRobotStateFromWarehouse_Request] = ..., response: Collection[moveit_msgs.srv.GetRobotStateFromWarehouse_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[moveit_msgs.srv.GetRobotStateFromWarehouse_Request]: ...
    @request.setter
    def request(self, value: Collection[moveit_msgs.srv.GetRobotStateFromWarehouse_Request]) -> None: ...
    @property
    def response(self) -> list[moveit_msgs.srv.GetRobotStateFromWarehouse_Response]: ...
    @response.setter
    def response(self, value: Collection[moveit_msgs.srv.GetRobotStateFromWarehouse_Response]) -> None: ...

class GetRobotStateFromWarehouse(Service):
    Request: TypeAlias = GetRobotStateFromWarehouse_Request
    Response: TypeAlias = GetRobotStateFromWarehouse_Response
    Event: TypeAlias = GetRobotStateFromWarehouse_Event

class GetStateValidity_Request(Message):
    """moveit_msgs/srv/GetStateValidity_Request

    # Says whether a state is free of contacts and meets constraints.

    RobotState robot_state
    string group_name
    Constraints constraints
    """
    def __init__(self, *, robot_state: moveit_msgs.msg.RobotState = ..., group_name: str = ..., constraints: moveit_msgs.msg.Constraints = ..., check_fields: bool = ...) -> None: ...
    robot_state: moveit_msgs.msg.RobotState
    group_name: str
    constraints: moveit_msgs.msg.Constraints

class GetStateValidity_Response(Message):
    """moveit_msgs/srv/GetStateValidity_Response

    bool valid
    ContactInformation[] contacts
    CostSource[] cost_sources
    ConstraintEvalResult[] constraint_result
    """
    def __init__(self, *, valid: bool = ..., contacts: Collection[moveit_msgs.msg.ContactInformation] = ..., cost_sources: Collection[moveit_msgs.msg.CostSource] = ..., constraint_result: Collection[moveit_msgs.msg.ConstraintEvalResult] = ..., check_fields: bool = ...) -> None: ...
    valid: bool
    @property
    def contacts(self) -> list[moveit_msgs.msg.ContactInformation]: ...
    @contacts.setter
    def contacts(self, value: Collection[moveit_msgs.msg.ContactInformation]) -> None: ...
    @property
    def cost_sources(self) -> list[moveit_msgs.msg.CostSource]: ...
    @cost_sources.setter
    def cost_sources(self, value: Collection[moveit_msgs.msg.CostSource]) -> None: ...
    @property
    def constraint_result(self) -> list[moveit_msgs.msg.ConstraintEvalResult]: ...
    @constraint_result.setter
    def constraint_result(self, value: Collection[moveit_msgs.msg.ConstraintEvalResult]) -> None: ...

class GetStateValidity_Event(Message):
    """moveit_msgs/srv/GetStateValidity_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[moveit_msgs.srv.GetStateValidity_Request] = ..., response: Collection[moveit_msgs.srv.GetStateValidity_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[moveit_msgs.srv.GetStateValidity_Request]: ...
    @request.setter
    def request(self, value: Collection[moveit_msgs.srv.GetStateValidity_Request]) -> None: ...
    @property
    def response(self) -> list[moveit_msgs.srv.GetStateValidity_Response]: ...
    @response.setter
    def response(self, value: Collection[moveit_msgs.srv.GetStateValidity_Response]) -> None: ...

class GetStateValidity(Service):
    Request: TypeAlias = GetStateValidity_Request
    Response: TypeAlias = GetStateValidity_Response
    Event: TypeAlias = GetStateValidity_Event

class GraspPlanning_Request(Message):
    """moveit_msgs/srv/GraspPlanning_Request

    # Returns ways to grasp an object.

    string group_name
    CollisionObject target
    string[] support_surfaces
    Grasp[] candidate_grasps
    CollisionObject[] movable_obstacles
    """
    def __init__(self, *, group_name: str = ..., target: moveit_msgs.msg.CollisionObject = ..., support_surfaces: Collection[str] = ..., candidate_grasps: Collection[moveit_msgs.msg.Grasp] = ..., movable_obstacles: Collection[moveit_msgs.msg.CollisionObject] = ..., check_fields: bool = ...) -> None: ...
    group_name: str
    target: moveit_msgs.msg.CollisionObject
    @property
    def support_surfaces(self) -> list[str]: ...
    @support_surfaces.setter
    def support_surfaces(self, value: Collection[str]) -> None: ...
    @property
    def candidate_grasps(self) -> list[moveit_msgs.msg.Grasp]: ...
    @candidate_grasps.setter
    def candidate_grasps(self, value: Collection[moveit_msgs.msg.Grasp]) -> None: ...
    @property
    def movable_obstacles(self) -> list[moveit_msgs.msg.CollisionObject]: ...
    @movable_obstacles.setter
    def movable_obstacles(self, value: Collection[moveit_msgs.msg.CollisionObject]) -> None: ...

class GraspPlanning_Response(Message):
    """moveit_msgs/srv/GraspPlanning_Response

    Grasp[] grasps
    MoveItErrorCodes error_code
    """
    def __init__(self, *, grasps: Collection[moveit_msgs.msg.Grasp] = ..., error_code: moveit_msgs.msg.MoveItErrorCodes = ..., check_fields: bool = ...) -> None: ...
    @property
    def grasps(self) -> list[moveit_msgs.msg.Grasp]: ...
    @grasps.setter
    def grasps(self, value: Collection[moveit_msgs.msg.Grasp]) -> None: ...
    error_code: moveit_msgs.msg.MoveItErrorCodes

class GraspPlanning_Event(Message):
    """moveit_msgs/srv/GraspPlanning_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[moveit_msgs.srv.GraspPlanning_Request] = ..., response: Collection[moveit_msgs.srv.GraspPlanning_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[moveit_msgs.srv.GraspPlanning_Request]: ...
    @request.setter
    def request(self, value: Collection[moveit_msgs.srv.GraspPlanning_Request]) -> None: ...
    @property
    def response(self) -> list[moveit_msgs.srv.GraspPlanning_Response]: ...
    @response.setter
    def response(self, value: Collection[moveit_msgs.srv.GraspPlanning_Response]) -> None: ...

class GraspPlanning(Service):
    Request: TypeAlias = GraspPlanning_Request
    Response: TypeAlias = GraspPlanning_Response
    Event: TypeAlias = GraspPlanning_Event

class ListRobotStatesInWarehouse_Request(Message):
    """moveit_msgs/srv/ListRobotStatesInWarehouse_Request

    # Lists the stored states.

    string regex
    string robot
    """
    def __init__(self, *, regex: str = ..., robot: str = ..., check_fields: bool = ...) -> None: ...
    regex: str
    robot: str

class ListRobotStatesInWarehouse_Response(Message):
    """moveit_msgs/srv/ListRobotStatesInWarehouse_Response

    string[] states
    """
    def __init__(self, *, states: Collection[str] = ..., check_fields: bool = ...) -> None: ...
    @property
    def states(self) -> list[str]: ...
    @states.setter
    def states(self, value: Collection[str]) -> None: ...

class ListRobotStatesInWarehouse_Event(Message):
    """moveit_msgs/srv/ListRobotStatesInWarehouse_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[moveit_msgs.srv.ListRobotStatesInWarehouse_Request] = ..., response: Collection[moveit_msgs.srv.ListRobotStatesInWarehouse_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[moveit_msgs.srv.ListRobotStatesInWarehouse_Request]: ...
    @request.setter
    def request(self, value: Collection[moveit_msgs.srv.ListRobotStatesInWarehouse_Request]) -> None: ...
    @property
    def response(self) -> list[moveit_msgs.srv.ListRobotStatesInWarehouse_Response]: ...
    @response.setter
    def response(self, value: Collection[moveit_msgs.srv.ListRobotStatesInWarehouse_Response]) -> None: ...

class ListRobotStatesInWarehouse(Service):
    Request: TypeAlias = ListRobotStatesInWarehouse_Request
    Response: TypeAlias = ListRobotStatesInWarehouse_Response
    Event: TypeAlias = ListRobotStatesInWarehouse_Event

class LoadGeometryFromFile_Request(Message):
    """moveit_msgs/srv/LoadGeometryFromFile_Request

    # Adds the objects of a file to the scene.

    string file_path_and_name
    """
    def __init__(self, *, file_path_and_name: str = ..., check_fields: bool = ...) -> None: ...
    file_path_and_name: str

class LoadGeometryFromFile_Response(Message):
    """moveit_msgs/srv/LoadGeometryFromFile_Response

    bool success
    """
    def __init__(self, *, success: bool = ..., check_fields: bool = ...) -> None: ...
    success: bool

class LoadGeometryFromFile_Event(Message):
    """moveit_msgs/srv/LoadGeometryFromFile_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[moveit_msgs.srv.LoadGeometryFromFile_Request] = ..., response: Collection[moveit_msgs.srv.LoadGeometryFromFile_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[moveit_msgs.srv.LoadGeometryFromFile_Request]: ...
    @request.setter
    def request(self, value: Collection[moveit_msgs.srv.LoadGeometryFromFile_Request]) -> None: ...
    @property
    def response(self) -> list[moveit_msgs.srv.LoadGeometryFromFile_Response]: ...
    @response.setter
    def response(self, value: Collection[moveit_msgs.srv.LoadGeometryFromFile_Response]) -> None: ...

class LoadGeometryFromFile(Service):
    Request: TypeAlias = LoadGeometryFromFile_Request
    Response: TypeAlias = LoadGeometryFromFile_Response
    Event: TypeAlias = LoadGeometryFromFile_Event

class LoadMap_Request(Message):
    """moveit_msgs/srv/LoadMap_Request

    # Loads a map from a file.

    string filename
    """
    def __init__(self, *, filename: str = ..., check_fields: bool = ...) -> None: ...
    filename: str

class LoadMap_Response(Message):
    """moveit_msgs/srv/LoadMap_Response

    bool success
    """
    def __init__(self, *, success: bool = ..., check_fields: bool = ...) -> None: ...
    success: bool

class LoadMap_Event(Message):
    """moveit_msgs/srv/LoadMap_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[moveit_msgs.srv.LoadMap_Request] = ..., response: Collection[moveit_msgs.srv.LoadMap_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[moveit_msgs.srv.LoadMap_Request]: ...
    @request.setter
    def request(self, value: Collection[moveit_msgs.srv.LoadMap_Request]) -> None: ...
    @property
    def response(self) -> list[moveit_msgs.srv.LoadMap_Response]: ...
    @response.setter
    def response(self, value: Collection[moveit_msgs.srv.LoadMap_Response]) -> None: ...

class LoadMap(Service):
    Request: TypeAlias = LoadMap_Request
    Response: TypeAlias = LoadMap_Response
    Event: TypeAlias = LoadMap_Event

class QueryPlannerInterfaces_Request(Message):
    """moveit_msgs/srv/QueryPlannerInterfaces_Request

    # Lists the planners.
    """
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class QueryPlannerInterfaces_Response(Message):
    """moveit_msgs/srv/QueryPlannerInterfaces_Response

    PlannerInterfaceDescription[] planner_interfaces
    """
    def __init__(self, *, planner_interfaces: Collection[moveit_msgs.msg.PlannerInterfaceDescription] = ..., check_fields: bool = ...) -> None: ...
    @property
    def planner_interfaces(self) -> list[moveit_msgs.msg.PlannerInterfaceDescription]: ...
    @planner_interfaces.setter
    def planner_interfaces(self, value: Collection[moveit_msgs.msg.PlannerInterfaceDescription]) -> None: ...

class QueryPlannerInterfaces_Event(Message):
    """moveit_msgs/srv/QueryPlannerInterfaces_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[moveit_msgs.srv.QueryPlannerInterfaces_Request] = ..., response: Collection[moveit_msgs.srv.QueryPlannerInterfaces_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[moveit_msgs.srv.QueryPlannerInterfaces_Request]: ...
    @request.setter
    def request(self, value: Collection[moveit_msgs.srv.QueryPlannerInterfaces_Request]) -> None: ...
    @property
    def response(self) -> list[moveit_msgs.srv.QueryPlannerInterfaces_Response]: ...
    @response.setter
    def response(self, value: Collection[moveit_msgs.srv.QueryPlannerInterfaces_Response]) -> None: ...

class QueryPlannerInterfaces(Service):
    Request: TypeAlias = QueryPlannerInterfaces_Request
    Response: TypeAlias = QueryPlannerInterfaces_Response
    Event: TypeAlias = QueryPlannerInterfaces_Event

class RenameRobotStateInWarehouse_Request(Message):
    """moveit_msgs/srv/RenameRobotStateInWarehouse_Request

    # Renames a stored state.

    string old_name
    string new_name
    string robot
    """
    def __init__(self, *, old_name: str = ..., new_name: str = ..., robot: str = ..., check_fields: bool = ...) -> None: ...
    old_name: str
    new_name: str
    robot: str

class RenameRobotStateInWarehouse_Response(Message):
    """moveit_msgs/srv/RenameRobotStateInWarehouse_Response"""
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class RenameRobotStateInWarehouse_Event(Message):
    """moveit_msgs/srv/RenameRobotStateInWarehouse_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[moveit_msgs.srv.RenameRobotStateInWarehouse_Request] = ..., response: Collection[moveit_msgs.srv.RenameRobotStateInWarehouse_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[moveit_msgs.srv.RenameRobotStateInWarehouse_Request]: ...
    @request.setter
    def request(self, value: Collection[moveit_msgs.srv.RenameRobotStateInWarehouse_Request]) -> None: ...
    @property
    def response(self) -> list[moveit_msgs.srv.RenameRobotStateInWarehouse_Response]: ...
    @response.setter
    def response(self, value: Collection[moveit_msgs.srv.RenameRobotStateInWarehouse_Response]) -> None: ...

class RenameRobotStateInWarehouse(Service):
    Request: TypeAlias = RenameRobotStateInWarehouse_Request
    Response: TypeAlias = RenameRobotStateInWarehouse_Response
    Event: TypeAlias = RenameRobotStateInWarehouse_Event

class SaveGeometryToFile_Request(Message):
    """moveit_msgs/srv/SaveGeometryToFile_Request

    # Saves the objects of the scene to a file.

    string file_path_and_name
    """
    def __init__(self, *, file_path_and_name: str = ..., check_fields: bool = ...) -> None: ...
    file_path_and_name: str

class SaveGeometryToFile_Response(Message):
    """moveit_msgs/srv/SaveGeometryToFile_Response

    bool success
    """
    def __init__(self, *, success: bool = ..., check_fields: bool = ...) -> None: ...
    success: bool

class SaveGeometryToFile_Event(Message):
    """moveit_msgs/srv/SaveGeometryToFile_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[moveit_msgs.srv.SaveGeometryToFile_Request] = ..., response: Collection[moveit_msgs.srv.SaveGeometryToFile_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[moveit_msgs.srv.SaveGeometryToFile_Request]: ...
    @request.setter
    def request(self, value: Collection[moveit_msgs.srv.SaveGeometryToFile_Request]) -> None: ...
    @property
    def response(self) -> list[moveit_msgs.srv.SaveGeometryToFile_Response]: ...
    @response.setter
    def response(self, value: Collection[moveit_msgs.srv.SaveGeometryToFile_Response]) -> None: ...

class SaveGeometryToFile(Service):
    Request: TypeAlias = SaveGeometryToFile_Request
    Response: TypeAlias = SaveGeometryToFile_Response
    Event: TypeAlias = SaveGeometryToFile_Event

class SaveMap_Request(Message):
    """moveit_msgs/srv/SaveMap_Request

    # Saves the map to a file.

    string filename
    """
    def __init__(self, *, filename: str = ..., check_fields: bool = ...) -> None: ...
    filename: str

class SaveMap_Response(Message):
    """moveit_msgs/srv/SaveMap_Response

    bool success
    """
    def __init__(self, *, success: bool = ..., check_fields: bool = ...) -> None: ...
    success: bool

class SaveMap_Event(Message):
    """moveit_msgs/srv/SaveMap_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[moveit_msgs.srv.SaveMap_Request] = ..., response: Collection[moveit_msgs.srv.SaveMap_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[moveit_msgs.srv.SaveMap_Request]: ...
    @request.setter
    def request(self, value: Collection[moveit_msgs.srv.SaveMap_Request]) -> None: ...
    @property
    def response(self) -> list[moveit_msgs.srv.SaveMap_Response]: ...
    @response.setter
    def response(self, value: Collection[moveit_msgs.srv.SaveMap_Response]) -> None: ...

class SaveMap(Service):
    Request: TypeAlias = SaveMap_Request
    Response: TypeAlias = SaveMap_Response
    Event: TypeAlias = SaveMap_Event

class SaveRobotStateToWarehouse_Request(Message):
    """moveit_msgs/srv/SaveRobotStateToWarehouse_Request

    # Stores a state.

    string name
    string robot
    moveit_msgs/RobotState state
    """
    def __init__(self, *, name: str = ..., robot: str = ..., state: moveit_msgs.msg.RobotState = ..., check_fields: bool = ...) -> None: ...
    name: str
    robot: str
    state: moveit_msgs.msg.RobotState

class SaveRobotStateToWarehouse_Response(Message):
    """moveit_msgs/srv/SaveRobotStateToWarehouse_Response

    bool success
    """
    def __init__(self, *, success: bool = ..., check_fields: bool = ...) -> None: ...
    success: bool

class SaveRobotStateToWarehouse_Event(Message):
    """moveit_msgs/srv/SaveRobotStateToWarehouse_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[moveit_msgs.srv.SaveRobotStateToWarehouse_Request] = ..., response: Collection[moveit_msgs.srv.SaveRobotStateToWarehouse_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[moveit_msgs.srv.SaveRobotStateToWarehouse_Request]: ...
    @request.setter
    def request(self, value: Collection[moveit_msgs.srv.SaveRobotStateToWarehouse_Request]) -> None: ...
    @property
    def response(self) -> list[moveit_msgs.srv.SaveRobotStateToWarehouse_Response]: ...
    @response.setter
    def response(self, value: Collection[moveit_msgs.srv.SaveRobotStateToWarehouse_Response]) -> None: ...

class SaveRobotStateToWarehouse(Service):
    Request: TypeAlias = SaveRobotStateToWarehouse_Request
    Response: TypeAlias = SaveRobotStateToWarehouse_Response
    Event: TypeAlias = SaveRobotStateToWarehouse_Event

class ServoCommandType_Request(Message):
    """moveit_msgs/srv/ServoCommandType_Request

    # Sets the kind of commands for MoveIt Servo.

    int8 JOINT_JOG=0
    int8 TWIST=1
    int8 POSE=2
    int8 command_type
    """
    JOINT_JOG: Final = 0
    TWIST: Final = 1
    POSE: Final = 2
    def __init__(self, *, command_type: int = ..., check_fields: bool = ...) -> None: ...
    command_type: int

class ServoCommandType_Response(Message):
    """moveit_msgs/srv/ServoCommandType_Response

    bool success
    """
    def __init__(self, *, success: bool = ..., check_fields: bool = ...) -> None: ...
    success: bool

class ServoCommandType_Event(Message):
    """moveit_msgs/srv/ServoCommandType_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[moveit_msgs.srv.ServoCommandType_Request] = ..., response: Collection[moveit_msgs.srv.ServoCommandType_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[moveit_msgs.srv.ServoCommandType_Request]: ...
    @request.setter
    def request(self, value: Collection[moveit_msgs.srv.ServoCommandType_Request]) -> None: ...
    @property
    def response(self) -> list[moveit_msgs.srv.ServoCommandType_Response]: ...
    @response.setter
    def response(self, value: Collection[moveit_msgs.srv.ServoCommandType_Response]) -> None: ...

class ServoCommandType(Service):
    Request: TypeAlias = ServoCommandType_Request
    Response: TypeAlias = ServoCommandType_Response
    Event: TypeAlias = ServoCommandType_Event

class SetPlannerParams_Request(Message):
    """moveit_msgs/srv/SetPlannerParams_Request

    # Sets the parameters of a planner.

    string pipeline_id
    string planner_config
    string group
    PlannerParams params
    bool replace  # remove all other parameters
    """
    def __init__(self, *, pipeline_id: str = ..., planner_config: str = ..., group: str = ..., params: moveit_msgs.msg.PlannerParams = ..., replace: bool = ..., check_fields: bool = ...) -> None: ...
    pipeline_id: str
    planner_config: str
    group: str
    params: moveit_msgs.msg.PlannerParams
    replace: bool

class SetPlannerParams_Response(Message):
    """moveit_msgs/srv/SetPlannerParams_Response"""
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class SetPlannerParams_Event(Message):
    """moveit_msgs/srv/SetPlannerParams_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[moveit_msgs.srv.SetPlannerParams_Request] = ..., response: Collection[moveit_msgs.srv.SetPlannerParams_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[moveit_msgs.srv.SetPlannerParams_Request]: ...
    @request.setter
    def request(self, value: Collection[moveit_msgs.srv.SetPlannerParams_Request]) -> None: ...
    @property
    def response(self) -> list[moveit_msgs.srv.SetPlannerParams_Response]: ...
    @response.setter
    def response(self, value: Collection[moveit_msgs.srv.SetPlannerParams_Response]) -> None: ...

class SetPlannerParams(Service):
    Request: TypeAlias = SetPlannerParams_Request
    Response: TypeAlias = SetPlannerParams_Response
    Event: TypeAlias = SetPlannerParams_Event

class UpdatePointcloudOctomap_Request(Message):
    """moveit_msgs/srv/UpdatePointcloudOctomap_Request

    # Adds points to the map of the scene.

    sensor_msgs/PointCloud2 cloud
    """
    def __init__(self, *, cloud: sensor_msgs.msg.PointCloud2 = ..., check_fields: bool = ...) -> None: ...
    cloud: sensor_msgs.msg.PointCloud2

class UpdatePointcloudOctomap_Response(Message):
    """moveit_msgs/srv/UpdatePointcloudOctomap_Response

    bool success
    """
    def __init__(self, *, success: bool = ..., check_fields: bool = ...) -> None: ...
    success: bool

class UpdatePointcloudOctomap_Event(Message):
    """moveit_msgs/srv/UpdatePointcloudOctomap_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[moveit_msgs.srv.UpdatePointcloudOctomap_Request] = ..., response: Collection[moveit_msgs.srv.UpdatePointcloudOctomap_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[moveit_msgs.srv.UpdatePointcloudOctomap_Request]: ...
    @request.setter
    def request(self, value: Collection[moveit_msgs.srv.UpdatePointcloudOctomap_Request]) -> None: ...
    @property
    def response(self) -> list[moveit_msgs.srv.UpdatePointcloudOctomap_Response]: ...
    @response.setter
    def response(self, value: Collection[moveit_msgs.srv.UpdatePointcloudOctomap_Response]) -> None: ...

class UpdatePointcloudOctomap(Service):
    Request: TypeAlias = UpdatePointcloudOctomap_Request
    Response: TypeAlias = UpdatePointcloudOctomap_Response
    Event: TypeAlias = UpdatePointcloudOctomap_Event
