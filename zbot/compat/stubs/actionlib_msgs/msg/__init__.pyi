# Written by python -m zbot.interfaces.stubs; do not edit.
from array import array
from collections.abc import Collection
from typing import Final, TypeAlias

import numpy
from numpy.typing import NDArray

import actionlib_msgs.msg
import builtin_interfaces.msg
import std_msgs.msg
from zbot.interfaces import Action, Message, Service

class GoalID(Message):
    """actionlib_msgs/msg/GoalID

    # Names a goal of a ROS 1 action; ROS 2 actions use action_msgs.

    # When the goal was requested; a cancel can mean all goals before a time.
    builtin_interfaces/Time stamp

    # A text that no other goal has.
    string id
    """
    def __init__(self, *, stamp: builtin_interfaces.msg.Time = ..., id: str = ..., check_fields: bool = ...) -> None: ...
    stamp: builtin_interfaces.msg.Time
    id: str

class GoalStatus(Message):
    """actionlib_msgs/msg/GoalStatus

    # How far a goal of a ROS 1 action has got; ROS 2 actions use action_msgs.

    GoalID goal_id
    uint8 status
    uint8 PENDING         = 0   # waiting
    uint8 ACTIVE          = 1   # being worked on
    uint8 PREEMPTED       = 2   # final: canceled while it was worked on
    uint8 SUCCEEDED       = 3   # final: reached
    uint8 ABORTED         = 4   # final: failed while it was worked on
    uint8 REJECTED        = 5   # final: refused without trying
    uint8 PREEMPTING      = 6   # cancel requested while it was worked on
    uint8 RECALLING       = 7   # cancel requested while it was waiting
    uint8 RECALLED        = 8   # final: canceled while it was waiting
    uint8 LOST            = 9   # a client's own conclusion, never sent by a server

    # Remarks for people.
    string text
    """
    PENDING: Final = 0
    ACTIVE: Final = 1
    PREEMPTED: Final = 2
    SUCCEEDED: Final = 3
    ABORTED: Final = 4
    REJECTED: Final = 5
    PREEMPTING: Final = 6
    RECALLING: Final = 7
    RECALLED: Final = 8
    LOST: Final = 9
    def __init__(self, *, goal_id: actionlib_msgs.msg.GoalID = ..., status: int = ..., text: str = ..., check_fields: bool = ...) -> None: ...
    goal_id: actionlib_msgs.msg.GoalID
    status: int
    text: str

class GoalStatusArray(Message):
    """actionlib_msgs/msg/GoalStatusArray

    # States of all goals that a ROS 1 action server follows.

    std_msgs/Header header
    GoalStatus[] status_list
    """
    def __init__(self, *, header: std_msgs.msg.Header = ..., status_list: Collection[actionlib_msgs.msg.GoalStatus] = ..., check_fields: bool = ...) -> None: ...
    header: std_msgs.msg.Header
    @property
    def status_list(self) -> list[actionlib_msgs.msg.GoalStatus]: ...
    @status_list.setter
    def status_list(self, value: Collection[actionlib_msgs.msg.GoalStatus]) -> None: ...
