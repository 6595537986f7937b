# Written by python -m zbot.interfaces.stubs; do not edit.
from array import array
from collections.abc import Collection
from typing import Final, TypeAlias

import numpy
from numpy.typing import NDArray

import builtin_interfaces.msg
import geometry_msgs.msg
import moveit_msgs.msg
import object_recognition_msgs.msg
import octomap_msgs.msg
import sensor_msgs.msg
import shape_msgs.msg
import std_msgs.msg
import trajectory_msgs.msg
from zbot.interfaces import Action, Message, Service

class AllowedCollisionEntry(Message):
    """moveit_msgs/msg/AllowedCollisionEntry

    # One row of a table of allowed contacts.

    bool[] enabled
    """
    def __init__(self, *, enabled: Collection[bool] = ..., check_fields: bool = ...) -> None: ...
    @property
    def enabled(self) -> list[bool]: ...
    @enabled.setter
    def enabled(self, value: Collection[bool]) -> None: ...

class AllowedCollisionMatrix(Message):
    """moveit_msgs/msg/AllowedCollisionMatrix

    # Which links and objects may touch each other.

    string[] entry_names
    AllowedCollisionEntry[] entry_values
    string[] default_entry_names
    bool[] default_entry_values
    """
    def __init__(self, *, entry_names: Collection[str] = ..., entry_values: Collection[moveit_msgs.msg.AllowedCollisionEntry] = ..., default_entry_names: Collection[str] = ..., default_entry_values: Collection[bool] = ..., check_fields: bool = ...) -> None: ...
    @property
    def entry_names(self) -> list[str]: ...
    @entry_names.setter
    def entry_names(self, value: Collection[str]) -> None: ...
    @property
    def entry_values(self) -> list[moveit_msgs.msg.AllowedCollisionEntry]: ...
    @entry_values.setter
    def entry_values(self, value: Collection[moveit_msgs.msg.AllowedCollisionEntry]) -> None: ...
    @property
    def default_entry_names(self) -> list[str]: ...
    @default_entry_names.setter
    def default_entry_names(self, value: Collection[str]) -> None: ...
    @property
    def default_entry_values(self) -> list[bool]: ...
    @default_entry_values.setter
    def default_entry_values(self, value: Collection[bool]) -> None: ...

class AttachedCollisionObject(Message):
    """moveit_msgs/msg/AttachedCollisionObject

    # An object that is attached to a link.

    string link_name
    CollisionObject object
    string[] touch_links  # links that it may touch
    trajectory_msgs/JointTrajectory detach_posture  # posture of the gripper that lets it go
    float64 weight  # kg
    """
    def __init__(self, *, link_name: str = ..., object: moveit_msgs.msg.CollisionObject = ..., touch_links: Collection[str] = ..., detach_posture: trajectory_msgs.msg.JointTrajectory = ..., weight: float = ..., check_fields: bool = ...) -> None: ...
    link_name: str
    object: moveit_msgs.msg.CollisionObject
    @property
    def touch_links(self) -> list[str]: ...
    @touch_links.setter
    def touch_links(self, value: Collection[str]) -> None: ...
    detach_posture: trajectory_msgs.msg.JointTrajectory
    weight: float

class BoundingVolume(Message):
    """moveit_msgs/msg/BoundingVolume

    # A volume, made of shapes.

    shape_msgs/SolidPrimitive[] primitives
    geometry_msgs/Pose[] primitive_poses
    shape_msgs/Mesh[] meshes
    geometry_msgs/Pose[] mesh_poses
    """
    def __init__(self, *, primitives: Collection[shape_msgs.msg.SolidPrimitive] = ..., primitive_poses: Collection[geometry_msgs.msg.Pose] = ..., meshes: Collection[shape_msgs.msg.Mesh] = ..., mesh_poses: Collection[geometry_msgs.msg.Pose] = ..., check_fields: bool = ...) -> None: ...
    @property
    def primitives(self) -> list[shape_msgs.msg.SolidPrimitive]: ...
    @primitives.setter
    def primitives(self, value: Collection[shape_msgs.msg.SolidPrimitive]) -> None: ...
    @property
    def primitive_poses(self) -> list[geometry_msgs.msg.Pose]: ...
    @primitive_poses.setter
    def primitive_poses(self, value: Collection[geometry_msgs.msg.Pose]) -> None: ...
    @property
    def meshes(self) -> list[shape_msgs.msg.Mesh]: ...
    @meshes.setter
    def meshes(self, value: Collection[shape_msgs.msg.Mesh]) -> None: ...
    @property
    def mesh_poses(self) -> list[geometry_msgs.msg.Pose]: ...
    @mesh_poses.setter
    def mesh_poses(self, value: Collection[geometry_msgs.msg.Pose]) -> None: ...

class CartesianPoint(Message):
    """moveit_msgs/msg/CartesianPoint

    # Pose, speed and acceleration of a frame.

    geometry_msgs/Pose pose
    geometry_msgs/Twist velocity
    geometry_msgs/Accel acceleration
    """
    def __init__(self, *, pose: geometry_msgs.msg.Pose = ..., velocity: geometry_msgs.msg.Twist = ..., acceleration: geometry_msgs.msg.Accel = ..., check_fields: bool = ...) -> None: ...
    pose: geometry_msgs.msg.Pose
    velocity: geometry_msgs.msg.Twist
    acceleration: geometry_msgs.msg.Accel

class CartesianTrajectory(Message):
    """moveit_msgs/msg/CartesianTrajectory

    # Motion of a frame.

    std_msgs/Header header
    string tracked_frame
    CartesianTrajectoryPoint[] points
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., tracked_frame: str = ..., points: Collection[moveit_msgs.msg.CartesianTrajectoryPoint] = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    tracked_frame: str
    @property
    def points(self) -> list[moveit_msgs.msg.CartesianTrajectoryPoint]: ...
    @points.setter
    def points(self, value: Collection[moveit_msgs.msg.CartesianTrajectoryPoint]) -> None: ...

class CartesianTrajectoryPoint(Message):
    """moveit_msgs/msg/CartesianTrajectoryPoint

    # Pose, speed and acceleration of a frame at a time.

    CartesianPoint point
    builtin_interfaces/Duration time_from_start
    """
    def __init__(self, *, point: moveit_msgs.msg.CartesianPoint = ..., time_from_start: builtin_interfaces.msg.Duration = ..., check_fields: bool = ...) -> None: ...
    point: moveit_msgs.msg.CartesianPoint
    time_from_start: builtin_interfaces.msg.Duration

class CollisionObject(Message):
    """moveit_msgs/msg/CollisionObject

    # An object that the robot must not touch.

    std_msgs/Header header
    geometry_msgs/Pose pose  # of the object; other poses are relative to it
    string id
    object_recognition_msgs/ObjectType type
    shape_msgs/SolidPrimitive[] primitives
    geometry_msgs/Pose[] primitive_poses
    shape_msgs/Mesh[] meshes
    geometry_msgs/Pose[] mesh_poses
    shape_msgs/Plane[] planes
    geometry_msgs/Pose[] plane_poses
    string[] subframe_names
    geometry_msgs/Pose[] subframe_poses
    byte ADD=0
    byte REMOVE=1
    byte APPEND=2
    byte MOVE=3
    byte operation
    """
    ADD: Final = b'\x00'
    REMOVE: Final = b'\x01'
    APPEND: Final = b'\x02'
    MOVE: Final = b'\x03'
    def __init__(self, *, header: std_msgs.msg.Header = ..., pose: geometry_msgs.msg.Pose = ..., id: str = ..., type: object_recognition_msgs.msg.ObjectType = ..., primitives: Collection[shape_msgs.msg.SolidPrimitive] = ..., primitive_poses: Collection[geometry_msgs.msg.Pose] = ..., meshes: Collection[shape_msgs.msg.Mesh] = ..., mesh_poses: Collection[geometry_msgs.msg.Pose] = ..., planes: Collection[shape_msgs.msg.Plane] = ..., plane_poses: Collection[geometry_msgs.msg.Pose] = ..., subframe_names: Collection[str] = ..., subframe_poses: Collection[geometry_msgs.msg.Pose] = ..., operation: bytes = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    pose: geometry_msgs.msg.Pose
    id: str
    type: object_recognition_msgs.msg.ObjectType
    @property
    def primitives(self) -> list[shape_msgs.msg.SolidPrimitive]: ...
    @primitives.setter
    def primitives(self, value: Collection[shape_msgs.msg.SolidPrimitive]) -> None: ...
    @property
    def primitive_poses(self) -> list[geometry_msgs.msg.Pose]: ...
    @primitive_poses.setter
    def primitive_poses(self, value: Collection[geometry_msgs.msg.Pose]) -> None: ...
    @property
    def meshes(self) -> list[shape_msgs.msg.Mesh]: ...
    @meshes.setter
    def meshes(self, value: Collection[shape_msgs.msg.Mesh]) -> None: ...
    @property
    def mesh_poses(self) -> list[geometry_msgs.msg.Pose]: ...
    @mesh_poses.setter
    def mesh_poses(self, value: Collection[geometry_msgs.msg.Pose]) -> None: ...
    @property
    def planes(self) -> list[shape_msgs.msg.Plane]: ...
    @planes.setter
    def planes(self, value: Collection[shape_msgs.msg.Plane]) -> None: ...
    @property
    def plane_poses(self) -> list[geometry_msgs.msg.Pose]: ...
    @plane_poses.setter
    def plane_poses(self, value: Collection[geometry_msgs.msg.Pose]) -> None: ...
    @property
    def subframe_names(self) -> list[str]: ...
    @subframe_names.setter
    def subframe_names(self, value: Collection[str]) -> None: ...
    @property
    def subframe_poses(self) -> list[geometry_msgs.msg.Pose]: ...
    @subframe_poses.setter
    def subframe_poses(self, value: Collection[geometry_msgs.msg.Pose]) -> None: ...
    operation: bytes

class ConstraintEvalResult(Message):
    """moveit_msgs/msg/ConstraintEvalResult

    # Whether a constraint is met.

    bool result
    float64 distance  # how far from it
    """
    def __init__(self, *, result: bool = ..., distance: float = ..., check_fields: bool = ...) -> None: ...
    result: bool
    distance: float

class Constraints(Message):
    """moveit_msgs/msg/Constraints

    # What a state of the robot has to meet.

    string name
    JointConstraint[] joint_constraints
    PositionConstraint[] position_constraints
    OrientationConstraint[] orientation_constraints
    VisibilityConstraint[] visibility_constraints
    """
    def __init__(self, *, name: str = ..., joint_constraints: Collection[moveit_msgs.msg.JointConstraint] = ..., position_constraints: Collection[moveit_msgs.msg.PositionConstraint] = ..., orientation_constraints: Collection[moveit_msgs.msg.OrientationConstraint] = ..., visibility_constraints: Collection[moveit_msgs.msg.VisibilityConstraint] = ..., check_fields: bool = ...) -> None: ...
    name: str
    @property
    def joint_constraints(self) -> list[moveit_msgs.msg.JointConstraint]: ...
    @joint_constraints.setter
    def joint_constraints(self, value: Collection[moveit_msgs.msg.JointConstraint]) -> None: ...
    @property
    def position_constraints(self) -> list[moveit_msgs.msg.PositionConstraint]: ...
    @position_constraints.setter
    def position_constraints(self, value: Collection[moveit_msgs.msg.PositionConstraint]) -> None: ...
    @property
    def orientation_constraints(self) -> list[moveit_msgs.msg.OrientationConstraint]: ...
    @orientation_constraints.setter
    def orientation_constraints(self, value: Collection[moveit_msgs.msg.OrientationConstraint]) -> None: ...
    @property
    def visibility_constraints(self) -> list[moveit_msgs.msg.VisibilityConstraint]: ...
    @visibility_constraints.setter
    def visibility_constraints(self, value: Collection[moveit_msgs.msg.VisibilityConstraint]) -> None: ...

class ContactInformation(Message):
    """moveit_msgs/msg/ContactInformation

    # Where two bodies touch.

    std_msgs/Header header
    geometry_msgs/Point position  # m
    geometry_msgs/Vector3 normal
    float64 depth  # m
    string contact_body_1
    uint32 body_type_1
    string contact_body_2
    uint32 body_type_2
    uint32 ROBOT_LINK=0
    uint32 WORLD_OBJECT=1
    uint32 ROBOT_ATTACHED=2
    """
    ROBOT_LINK: Final = 0
    WORLD_OBJECT: Final = 1
    ROBOT_ATTACHED: Final = 2
    def __init__(self, *, header: std_msgs.msg.Header = ..., position: geometry_msgs.msg.Point = ..., normal: geometry_msgs.msg.Vector3 = ..., depth: float = ..., contact_body_1: str = ..., body_type_1: int = ..., contact_body_2: str = ..., body_type_2: int = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    position: geometry_msgs.msg.Point
    normal: geometry_msgs.msg.Vector3
    depth: float
    contact_body_1: str
    body_type_1: int
    contact_body_2: str
    body_type_2: int

class CostSource(Message):
    """moveit_msgs/msg/CostSource

    # A box that costs something to move through.

    float64 cost_density
    geometry_msgs/Vector3 aabb_min  # m
    geometry_msgs/Vector3 aabb_max  # m
    """
    def __init__(self, *, cost_density: float = ..., aabb_min: geometry_msgs.msg.Vector3 = ..., aabb_max: geometry_msgs.msg.Vector3 = ..., check_fields: bool = ...) -> None: ...
    cost_density: float
    aabb_min: geometry_msgs.msg.Vector3
    aabb_max: geometry_msgs.msg.Vector3

class DisplayRobotState(Message):
    """moveit_msgs/msg/DisplayRobotState

    # A state of the robot to show.

    RobotState state
    ObjectColor[] highlight_links
    bool hide
    """
    def __init__(self, *, state: moveit_msgs.msg.RobotState = ..., highlight_links: Collection[moveit_msgs.msg.ObjectColor] = ..., hide: bool = ..., check_fields: bool = ...) -> None: ...
    state: moveit_msgs.msg.RobotState
    @property
    def highlight_links(self) -> list[moveit_msgs.msg.ObjectColor]: ...
    @highlight_links.setter
    def highlight_links(self, value: Collection[moveit_msgs.msg.ObjectColor]) -> None: ...
    hide: bool

class DisplayTrajectory(Message):
    """moveit_msgs/msg/DisplayTrajectory

    # A motion of the robot to show.

    string model_id
    RobotTrajectory[] trajectory
    RobotState trajectory_start
    """
    def __init__(self, *, model_id: str = ..., trajectory: Collection[moveit_msgs.msg.RobotTrajectory] = ..., trajectory_start: moveit_msgs.msg.RobotState = ..., check_fields: bool = ...) -> None: ...
    model_id: str
    @property
    def trajectory(self) -> list[moveit_msgs.msg.RobotTrajectory]: ...
    @trajectory.setter
    def trajectory(self, value: Collection[moveit_msgs.msg.RobotTrajectory]) -> None: ...
    trajectory_start: moveit_msgs.msg.RobotState

class GenericTrajectory(Message):
    """moveit_msgs/msg/GenericTrajectory

    # Motions of joints and of frames.

    std_msgs/Header header
    trajectory_msgs/JointTrajectory[] joint_trajectory
    moveit_msgs/CartesianTrajectory[] cartesian_trajectory
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., joint_trajectory: Collection[trajectory_msgs.msg.JointTrajectory] = ..., cartesian_trajectory: Collection[moveit_msgs.msg.CartesianTrajectory] = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    @property
    def joint_trajectory(self) -> list[trajectory_msgs.msg.JointTrajectory]: ...
    @joint_trajectory.setter
    def joint_trajectory(self, value: Collection[trajectory_msgs.msg.JointTrajectory]) -> None: ...
    @property
    def cartesian_trajectory(self) -> list[moveit_msgs.msg.CartesianTrajectory]: ...
    @cartesian_trajectory.setter
    def cartesian_trajectory(self, value: Collection[moveit_msgs.msg.CartesianTrajectory]) -> None: ...

class Grasp(Message):
    """moveit_msgs/msg/Grasp

    # A way to grasp an object.

    string id
    trajectory_msgs/JointTrajectory pre_grasp_posture
    trajectory_msgs/JointTrajectory grasp_posture
    geometry_msgs/PoseStamped grasp_pose
    float64 grasp_quality  # the higher, the better
    GripperTranslation pre_grasp_approach
    GripperTranslation post_grasp_retreat
    GripperTranslation post_place_retreat
    float32 max_contact_force  # N
    string[] allowed_touch_objects
    """
    def __init__(self, *, id: str = ..., pre_grasp_posture: trajectory_msgs.msg.JointTrajectory = ..., grasp_posture: trajectory_msgs.msg.JointTrajectory = ..., grasp_pose: geometry_msgs.msg.PoseStamped = ..., grasp_quality: float = ..., pre_grasp_approach: moveit_msgs.msg.GripperTranslation = ..., post_grasp_retreat: moveit_msgs.msg.GripperTranslation = ..., post_place_retreat: moveit_msgs.msg.GripperTranslation = ..., max_contact_force: float = ..., allowed_touch_objects: Collection[str] = ..., check_fields: bool = ...) -> None: ...
    id: str
    pre_grasp_posture: trajectory_msgs.msg.JointTrajectory
    grasp_posture: trajectory_msgs.msg.JointTrajectory
    grasp_pose: geometry_msgs.msg.PoseStamped
    grasp_quality: float
    pre_grasp_approach: moveit_msgs.msg.GripperTranslation
    post_grasp_retreat: moveit_msgs.msg.GripperTranslation
    post_place_retreat: moveit_msgs.msg.GripperTranslation
    max_contact_force: float
    @property
    def allowed_touch_objects(self) -> list[str]: ...
    @allowed_touch_objects.setter
    def allowed_touch_objects(self, value: Collection[str]) -> None: ...

class GripperTranslation(Message):
    """moveit_msgs/msg/GripperTranslation

    # A straight motion of the gripper.

    geometry_msgs/Vector3Stamped direction
    float32 desired_distance  # m
    float32 min_distance  # m
    """
    def __init__(self, *, direction: geometry_msgs.msg.Vector3Stamped = ..., desired_distance: float = ..., min_distance: float = ..., check_fields: bool = ...) -> None: ...
    direction: geometry_msgs.msg.Vector3Stamped
    desired_distance: float
    min_distance: float

class JointConstraint(Message):
    """moveit_msgs/msg/JointConstraint

    # Position that a joint has to have.

    string joint_name
    float64 position  # rad or m
    float64 tolerance_above  # rad or m
    float64 tolerance_below  # rad or m
    float64 weight  # 0.0: does not matter
    """
    def __init__(self, *, joint_name: str = ..., position: float = ..., tolerance_above: float = ..., tolerance_below: float = ..., weight: float = ..., check_fields: bool = ...) -> None: ...
    joint_name: str
    position: float
    tolerance_above: float
    tolerance_below: float
    weight: float

class JointLimits(Message):
    """moveit_msgs/msg/JointLimits

    # Limits of a joint.

    string joint_name
    bool has_position_limits
    float64 min_position  # rad or m
    float64 max_position  # rad or m
    bool has_velocity_limits
    float64 max_velocity  # rad/s or m/s
    bool has_acceleration_limits
    float64 max_acceleration  # rad/s^2 or m/s^2
    bool has_jerk_limits
    float64 max_jerk  # rad/s^3 or m/s^3
    """
    def __init__(self, *, joint_name: str = ..., has_position_limits: bool = ..., min_position: float = ..., max_position: float = ..., has_velocity_limits: bool = ..., max_velocity: float = ..., has_acceleration_limits: bool = ..., max_acceleration: float = ..., has_jerk_limits: bool = ..., max_jerk: float = ..., check_fields: bool = ...) -> None: ...
    joint_name: str
    has_position_limits: bool
    min_position: float
    max_position: float
    has_velocity_limits: bool
    max_velocity: float
    has_acceleration_limits: bool
    max_acceleration: float
    has_jerk_limits: bool
    max_jerk: float

class KinematicSolverInfo(Message):
    """moveit_msgs/msg/KinematicSolverInfo

    # Joints and links that a solver of the kinematics uses.

    string[] joint_names
    moveit_msgs/JointLimits[] limits
    string[] link_names
    """
    def __init__(self, *, joint_names: Collection[str] = ..., limits: Collection[moveit_msgs.msg.JointLimits] = ..., link_names: Collection[str] = ..., check_fields: bool = ...) -> None: ...
    @property
    def joint_names(self) -> list[str]: ...
    @joint_names.setter
    def joint_names(self, value: Collection[str]) -> None: ...
    @property
    def limits(self) -> list[moveit_msgs.msg.JointLimits]: ...
    @limits.setter
    def limits(self, value: Collection[moveit_msgs.msg.JointLimits]) -> None: ...
    @property
    def link_names(self) -> list[str]: ...
    @link_names.setter
    def link_names(self, value: Collection[str]) -> None: ...

class LinkPadding(Message):
    """moveit_msgs/msg/LinkPadding

    # Distance to keep around a link.

    string link_name
    float64 padding  # m
    """
    def __init__(self, *, link_name: str = ..., padding: float = ..., check_fields: bool = ...) -> None: ...
    link_name: str
    padding: float

class LinkScale(Message):
    """moveit_msgs/msg/LinkScale

    # Factor to make a link larger for contact tests.

    string link_name
    float64 scale
    """
    def __init__(self, *, link_name: str = ..., scale: float = ..., check_fields: bool = ...) -> None: ...
    link_name: str
    scale: float

class MotionPlanDetailedResponse(Message):
    """moveit_msgs/msg/MotionPlanDetailedResponse

    # A planned motion after each step of planning.

    RobotState trajectory_start
    string group_name
    RobotTrajectory[] trajectory
    string[] description
    float64[] processing_time  # s
    MoveItErrorCodes error_code
    """
    def __init__(self, *, trajectory_start: moveit_msgs.msg.RobotState = ..., group_name: str = ..., trajectory: Collection[moveit_msgs.msg.RobotTrajectory] = ..., description: Collection[str] = ..., processing_time: Collection[float] = ..., error_code: moveit_msgs.msg.MoveItErrorCodes = ..., check_fields: bool = ...) -> None: ...
    trajectory_start: moveit_msgs.msg.RobotState
    group_name: str
    @property
    def trajectory(self) -> list[moveit_msgs.msg.RobotTrajectory]: ...
    @trajectory.setter
    def trajectory(self, value: Collection[moveit_msgs.msg.RobotTrajectory]) -> None: ...
    @property
    def description(self) -> list[str]: ...
    @description.setter
    def description(self, value: Collection[str]) -> None: ...
    @property
    def processing_time(self) -> array[float]: ...
    @processing_time.setter
    def processing_time(self, value: Collection[float]) -> None: ...
    error_code: moveit_msgs.msg.MoveItErrorCodes

class MotionPlanRequest(Message):
    """moveit_msgs/msg/MotionPlanRequest

    # A motion to plan.

    WorkspaceParameters workspace_parameters
    RobotState start_state
    Constraints[] goal_constraints  # one of them has to be met at the end
    Constraints path_constraints  # on the whole way
    TrajectoryConstraints trajectory_constraints
    GenericTrajectory[] reference_trajectories
    string pipeline_id  # e.g. ompl
    string planner_id
    string group_name
    int32 num_planning_attempts
    float64 allowed_planning_time  # s
    float64 max_velocity_scaling_factor  # 0.0 to 1.0
    float64 max_acceleration_scaling_factor  # 0.0 to 1.0
    string cartesian_speed_limited_link
    float64 max_cartesian_speed  # m/s
    """
    def __init__(self, *, workspace_parameters: moveit_msgs.msg.WorkspaceParameters = ..., start_state: moveit_msgs.msg.RobotState = ..., goal_constraints: Collection[moveit_msgs.msg.Constraints] = ..., path_constraints: moveit_msgs.msg.Constraints = ..., trajectory_constraints: moveit_msgs.msg.TrajectoryConstraints = ..., reference_trajectories: Collection[moveit_msgs.msg.GenericTrajectory] = ..., pipeline_id: str = ..., planner_id: str = ..., group_name: str = ..., num_planning_attempts: int = ..., allowed_planning_time: float = ..., max_velocity_scaling_factor: float = ..., max_acceleration_scaling_factor: float = ..., cartesian_speed_limited_link: str = ..., max_cartesian_speed: float = ..., check_fields: bool = ...) -> None: ...
    workspace_parameters: moveit_msgs.msg.WorkspaceParameters
    start_state: moveit_msgs.msg.RobotState
    @property
    def goal_constraints(self) -> list[moveit_msgs.msg.Constraints]: ...
    @goal_constraints.setter
    def goal_constraints(self, value: Collection[moveit_msgs.msg.Constraints]) -> None: ...
    path_constraints: moveit_msgs.msg.Constraints
    trajectory_constraints: moveit_msgs.msg.TrajectoryConstraints
    @property
    def reference_trajectories(self) -> list[moveit_msgs.msg.GenericTrajectory]: ...
    @reference_trajectories.setter
    def reference_trajectories(self, value: Collection[moveit_msgs.msg.GenericTrajectory]) -> None: ...
    pipeline_id: str
    planner_id: str
    group_name: str
    num_planning_attempts: int
    allowed_planning_time: float
    max_velocity_scaling_factor: float
    max_acceleration_scaling_factor: float
    cartesian_speed_limited_link: str
    max_cartesian_speed: float

class MotionPlanResponse(Message):
    """moveit_msgs/msg/MotionPlanResponse

    # A planned motion.

    RobotState trajectory_start
    string group_name
    RobotTrajectory trajectory
    float64 planning_time  # s
    MoveItErrorCodes error_code
    """
    def __init__(self, *, trajectory_start: moveit_msgs.msg.RobotState = ..., group_name: str = ..., trajectory: moveit_msgs.msg.RobotTrajectory = ..., planning_time: float = ..., error_code: moveit_msgs.msg.MoveItErrorCodes = ..., check_fields: bool = ...) -> None: ...
    trajectory_start: moveit_msgs.msg.RobotState
    group_name: str
    trajectory: moveit_msgs.msg.RobotTrajectory
    planning_time: float
    error_code: moveit_msgs.msg.MoveItErrorCodes

class MotionSequenceItem(Message):
    """moveit_msgs/msg/MotionSequenceItem

    # One motion of several.

    MotionPlanRequest req
    float64 blend_radius  # m, how early the next motion may begin
    """
    def __init__(self, *, req: moveit_msgs.msg.MotionPlanRequest = ..., blend_radius: float = ..., check_fields: bool = ...) -> None: ...
    req: moveit_msgs.msg.MotionPlanRequest
    blend_radius: float

class MotionSequenceRequest(Message):
    """moveit_msgs/msg/MotionSequenceRequest

    # Several motions to plan.

    MotionSequenceItem[] items
    """
    def __init__(self, *, items: Collection[moveit_msgs.msg.MotionSequenceItem] = ..., check_fields: bool = ...) -> None: ...
    @property
    def items(self) -> list[moveit_msgs.msg.MotionSequenceItem]: ...
    @items.setter
    def items(self, value: Collection[moveit_msgs.msg.MotionSequenceItem]) -> None: ...

class MotionSequenceResponse(Message):
    """moveit_msgs/msg/MotionSequenceResponse

    # Several planned motions.

    MoveItErrorCodes error_code
    RobotState sequence_start
    RobotTrajectory[] planned_trajectories
    float64 planning_time  # s
    """
    def __init__(self, *, error_code: moveit_msgs.msg.MoveItErrorCodes = ..., sequence_start: moveit_msgs.msg.RobotState = ..., planned_trajectories: Collection[moveit_msgs.msg.RobotTrajectory] = ..., planning_time: float = ..., check_fields: bool = ...) -> None: ...
    error_code: moveit_msgs.msg.MoveItErrorCodes
    sequence_start: moveit_msgs.msg.RobotState
    @property
    def planned_trajectories(self) -> list[moveit_msgs.msg.RobotTrajectory]: ...
    @planned_trajectories.setter
    def planned_trajectories(self, value: Collection[moveit_msgs.msg.RobotTrajectory]) -> None: ...
    planning_time: float

class MoveItErrorCodes(Message):
    """moveit_msgs/msg/MoveItErrorCodes

    # What came of a request to MoveIt.

    int32 val  # one of the constants
    int32 SUCCESS=1
    int32 UNDEFINED=0
    int32 FAILURE=99999
    int32 PLANNING_FAILED=-1
    int32 INVALID_MOTION_PLAN=-2
    int32 MOTION_PLAN_INVALIDATED_BY_ENVIRONMENT_CHANGE=-3
    int32 CONTROL_FAILED=-4
    int32 UNABLE_TO_AQUIRE_SENSOR_DATA=-5
    int32 TIMED_OUT=-6
    int32 PREEMPTED=-7
    int32 START_STATE_IN_COLLISION=-10
    int32 START_STATE_VIOLATES_PATH_CONSTRAINTS=-11
    int32 START_STATE_INVALID=-26
    int32 GOAL_IN_COLLISION=-12
    int32 GOAL_VIOLATES_PATH_CONSTRAINTS=-13
    int32 GOAL_CONSTRAINTS_VIOLATED=-14
    int32 GOAL_STATE_INVALID=-27
    int32 UNRECOGNIZED_GOAL_TYPE=-28
    int32 INVALID_GROUP_NAME=-15
    int32 INVALID_GOAL_CONSTRAINTS=-16
    int32 INVALID_ROBOT_STATE=-17
    int32 INVALID_LINK_NAME=-18
    int32 INVALID_OBJECT_NAME=-19
    int32 FRAME_TRANSFORM_FAILURE=-21
    int32 COLLISION_CHECKING_UNAVAILABLE=-22
    int32 ROBOT_STATE_STALE=-23
    int32 SENSOR_INFO_STALE=-24
    int32 COMMUNICATION_FAILURE=-25
    int32 CRASH=-29
    int32 ABORT=-30
    int32 NO_IK_SOLUTION=-31
    string message
    string source
    """
    SUCCESS: Final = 1
    UNDEFINED: Final = 0
    FAILURE: Final = 99999
    PLANNING_FAILED: Final = -1
    INVALID_MOTION_PLAN: Final = -2
    MOTION_PLAN_INVALIDATED_BY_ENVIRONMENT_CHANGE: Final = -3
    CONTROL_FAILED: Final = -4
    UNABLE_TO_AQUIRE_SENSOR_DATA: Final = -5
    TIMED_OUT: Final = -6
    PREEMPTED: Final = -7
    START_STATE_IN_COLLISION: Final = -10
    START_STATE_VIOLATES_PATH_CONSTRAINTS: Final = -11
    START_STATE_INVALID: Final = -26
    GOAL_IN_COLLISION: Final = -12
    GOAL_VIOLATES_PATH_CONSTRAINTS: Final = -13
    GOAL_CONSTRAINTS_VIOLATED: Final = -14
    GOAL_STATE_INVALID: Final = -27
    UNRECOGNIZED_GOAL_TYPE: Final = -28
    INVALID_GROUP_NAME: Final = -15
    INVALID_GOAL_CONSTRAINTS: Final = -16
    INVALID_ROBOT_STATE: Final = -17
    INVALID_LINK_NAME: Final = -18
    INVALID_OBJECT_NAME: Final = -19
    FRAME_TRANSFORM_FAILURE: Final = -21
    COLLISION_CHECKING_UNAVAILABLE: Final = -22
    ROBOT_STATE_STALE: Final = -23
    SENSOR_INFO_STALE: Final = -24
    COMMUNICATION_FAILURE: Final = -25
    CRASH: Final = -29
    ABORT: Final = -30
    NO_IK_SOLUTION: Final = -31
    def __init__(self, *, val: int = ..., message: str = ..., source: str = ..., check_fields: bool = ...) -> None: ...
    val: int
    message: str
    source: str

class ObjectColor(Message):
    """moveit_msgs/msg/ObjectColor

    # The color of an object.

    string id
    std_msgs/ColorRGBA color
    """
    def __init__(self, *, id: str = ..., color: std_msgs.msg.ColorRGBA = ..., check_fields: bool = ...) -> None: ...
    id: str
    color: std_msgs.msg.ColorRGBA

class OrientationConstraint(Message):
    """moveit_msgs/msg/OrientationConstraint

    # Orientation that a link has to have.

    std_msgs/Header header
    geometry_msgs/Quaternion orientation
    string link_name
    float64 absolute_x_axis_tolerance  # rad
    float64 absolute_y_axis_tolerance  # rad
    float64 absolute_z_axis_tolerance  # rad
    uint8 parameterization  # XYZ_EULER_ANGLES or ROTATION_VECTOR
    uint8 XYZ_EULER_ANGLES=0
    uint8 ROTATION_VECTOR=1
    float64 weight
    """
    XYZ_EULER_ANGLES: Final = 0
    ROTATION_VECTOR: Final = 1
    def __init__(self, *, header: std_msgs.msg.Header = ..., orientation: geometry_msgs.msg.Quaternion = ..., link_name: str = ..., absolute_x_axis_tolerance: float = ..., absolute_y_axis_tolerance: float = ..., absolute_z_axis_tolerance: float = ..., parameterization: int = ..., weight: float = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    orientation: geometry_msgs.msg.Quaternion
    link_name: str
    absolute_x_axis_tolerance: float
    absolute_y_axis_tolerance: float
    absolute_z_axis_tolerance: float
    parameterization: int
    weight: float

class OrientedBoundingBox(Message):
    """moveit_msgs/msg/OrientedBoundingBox

    # A box.

    geometry_msgs/Pose pose
    geometry_msgs/Point32 extents  # m
    """
    def __init__(self, *, pose: geometry_msgs.msg.Pose = ..., extents: geometry_msgs.msg.Point32 = ..., check_fields: bool = ...) -> None: ...
    pose: geometry_msgs.msg.Pose
    extents: geometry_msgs.msg.Point32

class PipelineState(Message):
    """moveit_msgs/msg/PipelineState

    # A motion after one step of planning.

    MotionPlanRequest request
    MotionPlanResponse response
    string pipeline_stage
    """
    def __init__(self, *, request: moveit_msgs.msg.MotionPlanRequest = ..., response: moveit_msgs.msg.MotionPlanResponse = ..., pipeline_stage: str = ..., check_fields: bool = ...) -> None: ...
    request: moveit_msgs.msg.MotionPlanRequest
    response: moveit_msgs.msg.MotionPlanResponse
    pipeline_stage: str

class PlaceLocation(Message):
    """moveit_msgs/msg/PlaceLocation

    # A place to put an object down.

    string id
    trajectory_msgs/JointTrajectory post_place_posture
    geometry_msgs/PoseStamped place_pose
    float64 quality
    GripperTranslation pre_place_approach
    GripperTranslation post_place_retreat
    string[] allowed_touch_objects
    """
    def __init__(self, *, id: str = ..., post_place_posture: trajectory_msgs.msg.JointTrajectory = ..., place_pose: geometry_msgs.msg.PoseStamped = ..., quality: float = ..., pre_place_approach: moveit_msgs.msg.GripperTranslation = ..., post_place_retreat: moveit_msgs.msg.GripperTranslation = ..., allowed_touch_objects: Collection[str] = ..., check_fields: bool = ...) -> None: ...
    id: str
    post_place_posture: trajectory_msgs.msg.JointTrajectory
    place_pose: geometry_msgs.msg.PoseStamped
    quality: float
    pre_place_approach: moveit_msgs.msg.GripperTranslation
    post_place_retreat: moveit_msgs.msg.GripperTranslation
    @property
    def allowed_touch_objects(self) -> list[str]: ...
    @allowed_touch_objects.setter
    def allowed_touch_objects(self, value: Collection[str]) -> None: ...

class PlannerInterfaceDescription(Message):
    """moveit_msgs/msg/PlannerInterfaceDescription

    # A plugin of planners.

    string name
    string pipeline_id
    string[] planner_ids
    """
    def __init__(self, *, name: str = ..., pipeline_id: str = ..., planner_ids: Collection[str] = ..., check_fields: bool = ...) -> None: ...
    name: str
    pipeline_id: str
    @property
    def planner_ids(self) -> list[str]: ...
    @planner_ids.setter
    def planner_ids(self, value: Collection[str]) -> None: ...

class PlannerParams(Message):
    """moveit_msgs/msg/PlannerParams

    # Parameters of a planner.

    string[] keys
    string[] values
    string[] descriptions
    """
    def __init__(self, *, keys: Collection[str] = ..., values: Collection[str] = ..., descriptions: Collection[str] = ..., check_fields: bool = ...) -> None: ...
    @property
    def keys(self) -> list[str]: ...
    @keys.setter
    def keys(self, value: Collection[str]) -> None: ...
    @property
    def values(self) -> list[str]: ...
    @values.setter
    def values(self, value: Collection[str]) -> None: ...
    @property
    def descriptions(self) -> list[str]: ...
    @descriptions.setter
    def descriptions(self, value: Collection[str]) -> None: ...

class PlanningOptions(Message):
    """moveit_msgs/msg/PlanningOptions

    # How to plan and to move.

    PlanningScene planning_scene_diff
    bool plan_only  # do not move
    bool look_around
    int32 look_around_attempts
    float64 max_safe_execution_cost
    bool replan
    int32 replan_attempts
    float64 replan_delay  # s
    """
    def __init__(self, *, planning_scene_diff: moveit_msgs.msg.PlanningScene = ..., plan_only: bool = ..., look_around: bool = ..., look_around_attempts: int = ..., max_safe_execution_cost: float = ..., replan: bool = ..., replan_attempts: int = ..., replan_delay: float = ..., check_fields: bool = ...) -> None: ...
    planning_scene_diff: moveit_msgs.msg.PlanningScene
    plan_only: bool
    look_around: bool
    look_around_attempts: int
    max_safe_execution_cost: float
    replan: bool
    replan_attempts: int
    replan_delay: float

class PlanningScene(Message):
    """moveit_msgs/msg/PlanningScene

    # The robot and the world around it.

    string name
    RobotState robot_state
    string robot_model_name
    geometry_msgs/TransformStamped[] fixed_frame_transforms
    AllowedCollisionMatrix allowed_collision_matrix
    LinkPadding[] link_padding
    LinkScale[] link_scale
    ObjectColor[] object_colors
    PlanningSceneWorld world
    bool is_diff  # only what changes
    """
    def __init__(self, *, name: str = ..., robot_state: moveit_msgs.msg.RobotState = ..., robot_model_name: str = ..., fixed_frame_transforms: Collection[geometry_msgs.msg.TransformStamped] = ..., allowed_collision_matrix: moveit_msgs.msg.AllowedCollisionMatrix = ..., link_padding: Collection[moveit_msgs.msg.LinkPadding] = ..., link_scale: Collection[moveit_msgs.msg.LinkScale] = ..., object_colors: Collection[moveit_msgs.msg.ObjectColor] = ..., world: moveit_msgs.msg.PlanningSceneWorld = ..., is_diff: bool = ..., check_fields: bool = ...) -> None: ...
    name: str
    robot_state: moveit_msgs.msg.RobotState
    robot_model_name: str
    @property
    def fixed_frame_transforms(self) -> list[geometry_msgs.msg.TransformStamped]: ...
    @fixed_frame_transforms.setter
    def fixed_frame_transforms(self, value: Collection[geometry_msgs.msg.TransformStamped]) -> None: ...
    allowed_collision_matrix: moveit_msgs.msg.AllowedCollisionMatrix
    @property
    def link_padding(self) -> list[moveit_msgs.msg.LinkPadding]: ...
    @link_padding.setter
    def link_padding(self, value: Collection[moveit_msgs.msg.LinkPadding]) -> None: ...
    @property
    def link_scale(self) -> list[moveit_msgs.msg.LinkScale]: ...
    @link_scale.setter
    def link_scale(self, value: Collection[moveit_msgs.msg.LinkScale]) -> None: ...
    @property
    def object_colors(self) -> list[moveit_msgs.msg.ObjectColor]: ...
    @object_colors.setter
    def object_colors(self, value: Collection[moveit_msgs.msg.ObjectColor]) -> None: ...
    world: moveit_msgs.msg.PlanningSceneWorld
    is_diff: bool

class PlanningSceneComponents(Message):
    """moveit_msgs/msg/PlanningSceneComponents

    # Parts of the scene to return.

    uint32 SCENE_SETTINGS=1
    uint32 ROBOT_STATE=2
    uint32 ROBOT_STATE_ATTACHED_OBJECTS=4
    uint32 WORLD_OBJECT_NAMES=8
    uint32 WORLD_OBJECT_GEOMETRY=16
    uint32 OCTOMAP=32
    uint32 TRANSFORMS=64
    uint32 ALLOWED_COLLISION_MATRIX=128
    uint32 LINK_PADDING_AND_SCALING=256
    uint32 OBJECT_COLORS=512
    uint32 components  # sum of constants
    """
    SCENE_SETTINGS: Final = 1
    ROBOT_STATE: Final = 2
    ROBOT_STATE_ATTACHED_OBJECTS: Final = 4
    WORLD_OBJECT_NAMES: Final = 8
    WORLD_OBJECT_GEOMETRY: Final = 16
    OCTOMAP: Final = 32
    TRANSFORMS: Final = 64
    ALLOWED_COLLISION_MATRIX: Final = 128
    LINK_PADDING_AND_SCALING: Final = 256
    OBJECT_COLORS: Final = 512
    def __init__(self, *, components: int = ..., check_fields: bool = ...) -> None: ...
    components: int

class PlanningSceneWorld(Message):
    """moveit_msgs/msg/PlanningSceneWorld

    # The objects and the map of the world.

    CollisionObject[] collision_objects
    octomap_msgs/OctomapWithPose octomap
    """
    def __init__(self, *, collision_objects: Collection[moveit_msgs.msg.CollisionObject] = ..., octomap: octomap_msgs.msg.OctomapWithPose = ..., check_fields: bool = ...) -> None: ...
    @property
    def collision_objects(self) -> list[moveit_msgs.msg.CollisionObject]: ...
    @collision_objects.setter
    def collision_objects(self, value: Collection[moveit_msgs.msg.CollisionObject]) -> None: ...
    octomap: octomap_msgs.msg.OctomapWithPose

class PositionConstraint(Message):
    """moveit_msgs/msg/PositionConstraint

    # Region that a point of a link has to be in.

    std_msgs/Header header
    string link_name
    geometry_msgs/Vector3 target_point_offset  # m, in the frame of the link
    BoundingVolume constraint_region
    float64 weight
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., link_name: str = ..., target_point_offset: geometry_msgs.msg.Vector3 = ..., constraint_region: moveit_msgs.msg.BoundingVolume = ..., weight: float = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    link_name: str
    target_point_offset: geometry_msgs.msg.Vector3
    constraint_region: moveit_msgs.msg.BoundingVolume
    weight: float

class PositionIKRequest(Message):
    """moveit_msgs/msg/PositionIKRequest

    # A pose of a link to find joint positions for.

    string group_name
    moveit_msgs/RobotState robot_state
    Constraints constraints
    bool avoid_collisions
    string ik_link_name  # empty: the last link of the group
    geometry_msgs/PoseStamped pose_stamped
    string[] ik_link_names
    geometry_msgs/PoseStamped[] pose_stamped_vector
    builtin_interfaces/Duration timeout
    """
    def __init__(self, *, group_name: str = ..., robot_state: moveit_msgs.msg.RobotState = ..., constraints: moveit_msgs.msg.Constraints = ..., avoid_collisions: bool = ..., ik_link_name: str = ..., pose_stamped: geometry_msgs.msg.PoseStamped = ..., ik_link_names: Collection[str] = ..., pose_stamped_vector: Collection[geometry_msgs.msg.PoseStamped] = ..., timeout: builtin_interfaces.msg.Duration = ..., check_fields: bool = ...) -> None: ...
    group_name: str
    robot_state: moveit_msgs.msg.RobotState
    constraints: moveit_msgs.msg.Constraints
    avoid_collisions: bool
    ik_link_name: str
    pose_stamped: geometry_msgs.msg.PoseStamped
    @property
    def ik_link_names(self) -> list[str]: ...
    @ik_link_names.setter
    def ik_link_names(self, value: Collection[str]) -> None: ...
    @property
    def pose_stamped_vector(self) -> list[geometry_msgs.msg.PoseStamped]: ...
    @pose_stamped_vector.setter
    def pose_stamped_vector(self, value: Collection[geometry_msgs.msg.PoseStamped]) -> None: ...
    timeout: builtin_interfaces.msg.Duration

class RobotState(Message):
    """moveit_msgs/msg/RobotState

    # Positions of all joints, and what is attached.

    sensor_msgs/JointState joint_state
    sensor_msgs/MultiDOFJointState multi_dof_joint_state
    AttachedCollisionObject[] attached_collision_objects
    bool is_diff  # only what changes
    """
    def __init__(self, *, joint_state: sensor_msgs.msg.JointState = ..., multi_dof_joint_state: sensor_msgs.msg.MultiDOFJointState = ..., attached_collision_objects: Collection[moveit_msgs.msg.AttachedCollisionObject] = ..., is_diff: bool = ..., check_fields: bool = ...) -> None: ...
    joint_state: sensor_msgs.msg.JointState
    multi_dof_joint_state: sensor_msgs.msg.MultiDOFJointState
    @property
    def attached_collision_objects(self) -> list[moveit_msgs.msg.AttachedCollisionObject]: ...
    @attached_collision_objects.setter
    def attached_collision_objects(self, value: Collection[moveit_msgs.msg.AttachedCollisionObject]) -> None: ...
    is_diff: bool

class RobotTrajectory(Message):
    """moveit_msgs/msg/RobotTrajectory

    # Positions of joints over time.

    trajectory_msgs/JointTrajectory joint_trajectory
    trajectory_msgs/MultiDOFJointTrajectory multi_dof_joint_trajectory
    """
    def __init__(self, *, joint_trajectory: trajectory_msgs.msg.JointTrajectory = ..., multi_dof_joint_trajectory: trajectory_msgs.msg.MultiDOFJointTrajectory = ..., check_fields: bool = ...) -> None: ...
    joint_trajectory: trajectory_msgs.msg.JointTrajectory
    multi_dof_joint_trajectory: trajectory_msgs.msg.MultiDOFJointTrajectory

class ServoStatus(Message):
    """moveit_msgs/msg/ServoStatus

    # State of MoveIt Servo.

    int8 code  # one of the constants
    string message
    int8 INVALID=-1
    int8 NO_WARNING=0
    int8 DECELERATE_FOR_APPROACHING_SINGULARITY=1
    int8 HALT_FOR_SINGULARITY=2
    int8 DECELERATE_FOR_LEAVING_SINGULARITY=3
    int8 DECELERATE_FOR_COLLISION=4
    int8 HALT_FOR_COLLISION=5
    int8 JOINT_BOUND=6
    """
    INVALID: Final = -1
    NO_WARNING: Final = 0
    DECELERATE_FOR_APPROACHING_SINGULARITY: Final = 1
    HALT_FOR_SINGULARITY: Final = 2
    DECELERATE_FOR_LEAVING_SINGULARITY: Final = 3
    DECELERATE_FOR_COLLISION: Final = 4
    HALT_FOR_COLLISION: Final = 5
    JOINT_BOUND: Final = 6
    def __init__(self, *, code: int = ..., message: str = ..., check_fields: bool = ...) -> None: ...
    code: int
    message: str

class TrajectoryConstraints(Message):
    """moveit_msgs/msg/TrajectoryConstraints

    # Constraints along a motion.

    Constraints[] constraints
    """
    def __init__(self, *, constraints: Collection[moveit_msgs.msg.Constraints] = ..., check_fields: bool = ...) -> None: ...
    @property
    def constraints(self) -> list[moveit_msgs.msg.Constraints]: ...
    @constraints.setter
    def constraints(self, value: Collection[moveit_msgs.msg.Constraints]) -> None: ...

class VisibilityConstraint(Message):
    """moveit_msgs/msg/VisibilityConstraint

    # A sensor has to see a target.

    float64 target_radius  # m
    geometry_msgs/PoseStamped target_pose
    int32 cone_sides  # at least 3
    geometry_msgs/PoseStamped sensor_pose
    float64 max_view_angle  # rad, or 0.0
    float64 max_range_angle  # rad, or 0.0
    uint8 SENSOR_Z=0
    uint8 SENSOR_Y=1
    uint8 SENSOR_X=2
    uint8 sensor_view_direction
    float64 weight
    """
    SENSOR_Z: Final = 0
    SENSOR_Y: Final = 1
    SENSOR_X: Final = 2
    def __init__(self, *, target_radius: float = ..., target_pose: geometry_msgs.msg.PoseStamped = ..., cone_sides: int = ..., sensor_pose: geometry_msgs.msg.PoseStamped = ..., max_view_angle: float = ..., max_range_angle: float = ..., sensor_view_direction: int = ..., weight: float = ..., check_fields: bool = ...) -> None: ...
    target_radius: float
    target_pose: geometry_msgs.msg.PoseStamped
    cone_sides: int
    sensor_pose: geometry_msgs.msg.PoseStamped
    max_view_angle: float
    max_range_angle: float
    sensor_view_direction: int
    weight: float

class WorkspaceParameters(Message):
    """moveit_msgs/msg/WorkspaceParameters

    # Box that the robot may move in.

    std_msgs/Header header
    geometry_msgs/Vector3 min_corner  # m
    geometry_msgs/Vector3 max_corner  # m
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., min_corner: geometry_msgs.msg.Vector3 = ..., max_corner: geometry_msgs.msg.Vector3 = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    min_corner: geometry_msgs.msg.Vector3
    max_corner: geometry_msgs.msg.Vector3
