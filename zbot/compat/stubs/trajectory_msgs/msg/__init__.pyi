# Written by python -m zbot.interfaces.stubs; do not edit.
from array import array
from collections.abc import Collection
from typing import Final, TypeAlias

import numpy
from numpy.typing import NDArray

import builtin_interfaces.msg
import geometry_msgs.msg
import std_msgs.msg
import trajectory_msgs.msg
from zbot.interfaces import Action, Message, Service

class JointTrajectory(Message):
    """trajectory_msgs/msg/JointTrajectory

    # How the joints of a robot shall move over time.

    # Start of the motion (zero: at once) and the frame it refers to.
    std_msgs/Header header

    # Which joints, in the order used by the points.
    string[] joint_names

    # Where they shall be and when.
    JointTrajectoryPoint[] points
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., joint_names: Collection[str] = ..., points: Collection[trajectory_msgs.msg.JointTrajectoryPoint] = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    @property
    def joint_names(self) -> list[str]: ...
    @joint_names.setter
    def joint_names(self, value: Collection[str]) -> None: ...
    @property
    def points(self) -> list[trajectory_msgs.msg.JointTrajectoryPoint]: ...
    @points.setter
    def points(self, value: Collection[trajectory_msgs.msg.JointTrajectoryPoint]) -> None: ...

class JointTrajectoryPoint(Message):
    """trajectory_msgs/msg/JointTrajectoryPoint

    # One moment of a JointTrajectory; entry i of each list belongs to the joint joint_names[i].
    # Give positions, and either velocities and perhaps accelerations, or effort.

    # rad for turning joints, m for sliding ones.
    float64[] positions

    # rad/s or m/s.
    float64[] velocities

    # rad/s^2 or m/s^2.
    float64[] accelerations

    # N*m or N.
    float64[] effort

    # When, counted from the start of the motion.
    builtin_interfaces/Duration time_from_start
    """
    def __init__(self, *, positions: Collection[float] = ..., velocities: Collection[float] = ..., accelerations: Collection[float] = ..., effort: Collection[float] = ..., time_from_start: builtin_interfaces.msg.Duration = ..., check_fields: bool = ...) -> None: ...
    @property
    def positions(self) -> array[float]: ...
    @positions.setter
    def positions(self, value: Collection[float]) -> None: ...
    @property
    def velocities(self) -> array[float]: ...
    @velocities.setter
    def velocities(self, value: Collection[float]) -> None: ...
    @property
    def accelerations(self) -> array[float]: ...
    @accelerations.setter
    def accelerations(self, value: Collection[float]) -> None: ...
    @property
    def effort(self) -> array[float]: ...
    @effort.setter
    def effort(self, value: Collection[float]) -> None: ...
    time_from_start: builtin_interfaces.msg.Duration

class MultiDOFJointTrajectory(Message):
    """trajectory_msgs/msg/MultiDOFJointTrajectory

    # How joints that move in several directions at once shall move over time.

    # Start of the motion and the frame it refers to.
    std_msgs/Header header

    # Which joints, in the order used by the points; where they shall be and when.
    string[] joint_names
    MultiDOFJointTrajectoryPoint[] points
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., joint_names: Collection[str] = ..., points: Collection[trajectory_msgs.msg.MultiDOFJointTrajectoryPoint] = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    @property
    def joint_names(self) -> list[str]: ...
    @joint_names.setter
    def joint_names(self, value: Collection[str]) -> None: ...
    @property
    def points(self) -> list[trajectory_msgs.msg.MultiDOFJointTrajectoryPoint]: ...
    @points.setter
    def points(self, value: Collection[trajectory_msgs.msg.MultiDOFJointTrajectoryPoint]) -> None: ...

class MultiDOFJointTrajectoryPoint(Message):
    """trajectory_msgs/msg/MultiDOFJointTrajectoryPoint

    # One moment of a MultiDOFJointTrajectory; entry i of each list belongs to the joint joint_names[i].

    # Place and orientation.
    geometry_msgs/Transform[] transforms

    # m/s and rad/s; may be empty.
    geometry_msgs/Twist[] velocities

    # m/s^2 and rad/s^2; may be empty.
    geometry_msgs/Twist[] accelerations

    # When, counted from the start of the motion.
    builtin_interfaces/Duration time_from_start
    """
    def __init__(self, *, transforms: Collection[geometry_msgs.msg.Transform] = ..., velocities: Collection[geometry_msgs.msg.Twist] = ..., accelerations: Collection[geometry_msgs.msg.Twist] = ..., time_from_start: builtin_interfaces.msg.Duration = ..., check_fields: bool = ...) -> None: ...
    @property
    def transforms(self) -> list[geometry_msgs.msg.Transform]: ...
    @transforms.setter
    def transforms(self, value: Collection[geometry_msgs.msg.Transform]) -> None: ...
    @property
    def velocities(self) -> list[geometry_msgs.msg.Twist]: ...
    @velocities.setter
    def velocities(self, value: Collection[geometry_msgs.msg.Twist]) -> None: ...
    @property
    def accelerations(self) -> list[geometry_msgs.msg.Twist]: ...
    @accelerations.setter
    def accelerations(self, value: Collection[geometry_msgs.msg.Twist]) -> None: ...
    time_from_start: builtin_interfaces.msg.Duration
