# Written by python -m zbot.interfaces.stubs; do not edit.
from array import array
from collections.abc import Collection
from typing import Final, TypeAlias

import numpy
from numpy.typing import NDArray

import action_msgs.msg
import builtin_interfaces.msg
import unique_identifier_msgs.msg
from zbot.interfaces import Action, Message, Service

class GoalInfo(Message):
    """action_msgs/msg/GoalInfo

    # Names one goal of an action.

    # The goal's identity, chosen by the client.
    unique_identifier_msgs/UUID goal_id

    # When the server accepted the goal.
    builtin_interfaces/Time stamp
    """
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., stamp: builtin_interfaces.msg.Time = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    stamp: builtin_interfaces.msg.Time

class GoalStatus(Message):
    """action_msgs/msg/GoalStatus

    # How far an accepted goal has got.

    # Not known or not yet set.
    int8 STATUS_UNKNOWN   = 0

    # Accepted, waiting to start.
    int8 STATUS_ACCEPTED  = 1

    # Being worked on.
    int8 STATUS_EXECUTING = 2

    # A cancel was accepted; the work is being wound up.
    int8 STATUS_CANCELING = 3

    # Final: reached.
    int8 STATUS_SUCCEEDED = 4

    # Final: stopped because a client asked for it.
    int8 STATUS_CANCELED  = 5

    # Final: given up by the server itself.
    int8 STATUS_ABORTED   = 6

    # Which goal.
    GoalInfo goal_info

    # One of the states above.
    int8 status
    """
    STATUS_UNKNOWN: Final = 0
    STATUS_ACCEPTED: Final = 1
    STATUS_EXECUTING: Final = 2
    STATUS_CANCELING: Final = 3
    STATUS_SUCCEEDED: Final = 4
    STATUS_CANCELED: Final = 5
    STATUS_ABORTED: Final = 6
    def __init__(self, *, goal_info: action_msgs.msg.GoalInfo = ..., status: int = ..., check_fields: bool = ...) -> None: ...
    goal_info: action_msgs.msg.GoalInfo
    status: int

class GoalStatusArray(Message):
    """action_msgs/msg/GoalStatusArray

    # The states of all goals an action server knows about.

    GoalStatus[] status_list
    """
    def __init__(self, *, status_list: Collection[action_msgs.msg.GoalStatus] = ..., check_fields: bool = ...) -> None: ...
    @property
    def status_list(self) -> list[action_msgs.msg.GoalStatus]: ...
    @status_list.setter
    def status_list(self, value: Collection[action_msgs.msg.GoalStatus]) -> None: ...
