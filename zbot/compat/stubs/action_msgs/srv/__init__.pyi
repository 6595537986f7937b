# Written by python -m zbot.interfaces.stubs; do not edit.
from array import array
from collections.abc import Collection
from typing import Final, TypeAlias

import numpy
from numpy.typing import NDArray

import action_msgs.msg
import action_msgs.srv
import service_msgs.msg
from zbot.interfaces import Action, Message, Service

class CancelGoal_Request(Message):
    """action_msgs/srv/CancelGoal_Request

    # Asks an action server to cancel goals. The two parts of goal_info choose which:
    #   no id, no stamp      every goal
    #   no id, a stamp       every goal accepted up to that time
    #   an id, no stamp      that one goal
    #   an id and a stamp    that goal, and every goal accepted up to that time
    # An id or stamp of zeros counts as none.

    # Which goals, as above.
    GoalInfo goal_info
    """
    def __init__(self, *, goal_info: action_msgs.msg.GoalInfo = ..., check_fields: bool = ...) -> None: ...
    goal_info: action_msgs.msg.GoalInfo

class CancelGoal_Response(Message):
    """action_msgs/srv/CancelGoal_Response

    # At least one goal is being canceled.
    int8 ERROR_NONE=0

    # The server refused; nothing changes.
    int8 ERROR_REJECTED=1

    # The server has no goal of that id.
    int8 ERROR_UNKNOWN_GOAL_ID=2

    # The goal had ended already.
    int8 ERROR_GOAL_TERMINATED=3

    # One of the codes above.
    int8 return_code

    # Goals that are now being canceled; empty on any error.
    GoalInfo[] goals_canceling
    """
    ERROR_NONE: Final = 0
    ERROR_REJECTED: Final = 1
    ERROR_UNKNOWN_GOAL_ID: Final = 2
    ERROR_GOAL_TERMINATED: Final = 3
    def __init__(self, *, return_code: int = ..., goals_canceling: Collection[action_msgs.msg.GoalInfo] = ..., check_fields: bool = ...) -> None: ...
    return_code: int
    @property
    def goals_canceling(self) -> list[action_msgs.msg.GoalInfo]: ...
    @goals_canceling.setter
    def goals_canceling(self, value: Collection[action_msgs.msg.GoalInfo]) -> None: ...

class CancelGoal_Event(Message):
    """action_msgs/srv/CancelGoal_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[action_msgs.srv.CancelGoal_Request] = ..., response: Collection[action_msgs.srv.CancelGoal_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[action_msgs.srv.CancelGoal_Request]: ...
    @request.setter
    def request(self, value: Collection[action_msgs.srv.CancelGoal_Request]) -> None: ...
    @property
    def response(self) -> list[action_msgs.srv.CancelGoal_Response]: ...
    @response.setter
    def response(self, value: Collection[action_msgs.srv.CancelGoal_Response]) -> None: ...

class CancelGoal(Service):
    Request: TypeAlias = CancelGoal_Request
    Response: TypeAlias = CancelGoal_Response
    Event: TypeAlias = CancelGoal_Event
