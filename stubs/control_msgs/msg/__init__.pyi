# Written by python -m zbot.interfaces.stubs; do not edit.
from array import array
from collections.abc import Collection
from typing import Final, TypeAlias

import numpy
from numpy.typing import NDArray

import control_msgs.msg
import std_msgs.msg
from zbot.interfaces import Action, Message, Service

class DynamicJointState(Message):
    """control_msgs/msg/DynamicJointState

    # Whatever values joints have, each by the name of its interface.

    std_msgs/Header header
    string[] joint_names
    InterfaceValue[] interface_values
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., joint_names: Collection[str] = ..., interface_values: Collection[control_msgs.msg.InterfaceValue] = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    @property
    def joint_names(self) -> list[str]: ...
    @joint_names.setter
    def joint_names(self, value: Collection[str]) -> None: ...
    @property
    def interface_values(self) -> list[control_msgs.msg.InterfaceValue]: ...
    @interface_values.setter
    def interface_values(self, value: Collection[control_msgs.msg.InterfaceValue]) -> None: ...

class GripperCommand(Message):
    """control_msgs/msg/GripperCommand

    # How wide a gripper is to open, and how strongly at most.

    float64 position    # m between the fingers
    float64 max_effort  # N
    """
    def __init__(self, *, position: float = ..., max_effort: float = ..., check_fields: bool = ...) -> None: ...
    position: float
    max_effort: float

class InterfaceValue(Message):
    """control_msgs/msg/InterfaceValue

    # Values of one joint by the names of its interfaces.

    string[] interface_names
    float64[] values
    """
    def __init__(self, *, interface_names: Collection[str] = ..., values: Collection[float] = ..., check_fields: bool = ...) -> None: ...
    @property
    def interface_names(self) -> list[str]: ...
    @interface_names.setter
    def interface_names(self, value: Collection[str]) -> None: ...
    @property
    def values(self) -> array[float]: ...
    @values.setter
    def values(self, value: Collection[float]) -> None: ...

class JointComponentTolerance(Message):
    """control_msgs/msg/JointComponentTolerance

    # How far one part of a joint with several degrees of freedom may be from where it should be.

    uint16 X_AXIS=1
    uint16 Y_AXIS=2
    uint16 Z_AXIS=3
    uint16 TRANSLATION=4  # all axes together
    uint16 ROTATION=5

    string joint_name
    uint16 component
    float64 position
    float64 velocity
    float64 acceleration
    """
    X_AXIS: Final = 1
    Y_AXIS: Final = 2
    Z_AXIS: Final = 3
    TRANSLATION: Final = 4
    ROTATION: Final = 5
    def __init__(self, *, joint_name: str = ..., component: int = ..., position: float = ..., velocity: float = ..., acceleration: float = ..., check_fields: bool = ...) -> None: ...
    joint_name: str
    component: int
    position: float
    velocity: float
    acceleration: float

class JointJog(Message):
    """control_msgs/msg/JointJog

    # Moves joints by a little, or at a speed for a while.

    std_msgs/Header header
    string[] joint_names
    float64[] displacements  # rad or m
    float64[] velocities     # rad/s or m/s
    float64 duration         # s
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., joint_names: Collection[str] = ..., displacements: Collection[float] = ..., velocities: Collection[float] = ..., duration: float = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    @property
    def joint_names(self) -> list[str]: ...
    @joint_names.setter
    def joint_names(self, value: Collection[str]) -> None: ...
    @property
    def displacements(self) -> array[float]: ...
    @displacements.setter
    def displacements(self, value: Collection[float]) -> None: ...
    @property
    def velocities(self) -> array[float]: ...
    @velocities.setter
    def velocities(self, value: Collection[float]) -> None: ...
    duration: float

class JointTolerance(Message):
    """control_msgs/msg/JointTolerance

    # How far a joint may be from where it should be; 0: the default, -1: as far as it likes.

    string name
    float64 position      # rad, or m for a sliding joint
    float64 velocity      # rad/s or m/s
    float64 acceleration  # rad/s^2 or m/s^2
    """
    def __init__(self, *, name: str = ..., position: float = ..., velocity: float = ..., acceleration: float = ..., check_fields: bool = ...) -> None: ...
    name: str
    position: float
    velocity: float
    acceleration: float
