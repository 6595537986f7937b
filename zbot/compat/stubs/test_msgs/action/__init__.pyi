# Written by python -m zbot.interfaces.stubs; do not edit.
from array import array
from collections.abc import Collection
from typing import Final, TypeAlias

import numpy
from numpy.typing import NDArray

import action_msgs.msg
import action_msgs.srv
import builtin_interfaces.msg
import service_msgs.msg
import test_msgs.action
import test_msgs.msg
import unique_identifier_msgs.msg
from zbot.interfaces import Action, Message, Service

class Fibonacci_Goal(Message):
    """test_msgs/action/Fibonacci_Goal

    # The action of the tutorials, for tests.

    int32 order
    """
    def __init__(self, *, order: int = ..., check_fields: bool = ...) -> None: ...
    order: int

class Fibonacci_Result(Message):
    """test_msgs/action/Fibonacci_Result

    int32[] sequence
    """
    def __init__(self, *, sequence: Collection[int] = ..., check_fields: bool = ...) -> None: ...
    @property
    def sequence(self) -> array[int]: ...
    @sequence.setter
    def sequence(self, value: Collection[int]) -> None: ...

class Fibonacci_Feedback(Message):
    """test_msgs/action/Fibonacci_Feedback

    int32[] sequence
    """
    def __init__(self, *, sequence: Collection[int] = ..., check_fields: bool = ...) -> None: ...
    @property
    def sequence(self) -> array[int]: ...
    @sequence.setter
    def sequence(self, value: Collection[int]) -> None: ...

class Fibonacci_FeedbackMessage(Message):
    """test_msgs/action/Fibonacci_FeedbackMessage"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., feedback: test_msgs.action.Fibonacci_Feedback = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    feedback: test_msgs.action.Fibonacci_Feedback

class Fibonacci_SendGoal_Request(Message):
    """test_msgs/action/Fibonacci_SendGoal_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., goal: test_msgs.action.Fibonacci_Goal = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    goal: test_msgs.action.Fibonacci_Goal

class Fibonacci_SendGoal_Response(Message):
    """test_msgs/action/Fibonacci_SendGoal_Response"""
    def __init__(self, *, accepted: bool = ..., stamp: builtin_interfaces.msg.Time = ..., check_fields: bool = ...) -> None: ...
    accepted: bool
    stamp: builtin_interfaces.msg.Time

class Fibonacci_SendGoal_Event(Message):
    """test_msgs/action/Fibonacci_SendGoal_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[test_msgs.action.Fibonacci_SendGoal_Request] = ..., response: Collection[test_msgs.action.Fibonacci_SendGoal_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[test_msgs.action.Fibonacci_SendGoal_Request]: ...
    @request.setter
    def request(self, value: Collection[test_msgs.action.Fibonacci_SendGoal_Request]) -> None: ...
    @property
    def response(self) -> list[test_msgs.action.Fibonacci_SendGoal_Response]: ...
    @response.setter
    def response(self, value: Collection[test_msgs.action.Fibonacci_SendGoal_Response]) -> None: ...

class Fibonacci_GetResult_Request(Message):
    """test_msgs/action/Fibonacci_GetResult_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID

class Fibonacci_GetResult_Response(Message):
    """test_msgs/action/Fibonacci_GetResult_Response"""
    def __init__(self, *, status: int = ..., result: test_msgs.action.Fibonacci_Result = ..., check_fields: bool = ...) -> None: ...
    status: int
    result: test_msgs.action.Fibonacci_Result

class Fibonacci_GetResult_Event(Message):
    """test_msgs/action/Fibonacci_GetResult_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[test_msgs.action.Fibonacci_GetResult_Request] = ..., response: Collection[test_msgs.action.Fibonacci_GetResult_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[test_msgs.action.Fibonacci_GetResult_Request]: ...
    @request.setter
    def request(self, value: Collection[test_msgs.action.Fibonacci_GetResult_Request]) -> None: ...
    @property
    def response(self) -> list[test_msgs.action.Fibonacci_GetResult_Response]: ...
    @response.setter
    def response(self, value: Collection[test_msgs.action.Fibonacci_GetResult_Response]) -> None: ...

class Fibonacci_SendGoal(Service):
    Request: TypeAlias = Fibonacci_SendGoal_Request
    Response: TypeAlias = Fibonacci_SendGoal_Response
    Event: TypeAlias = Fibonacci_SendGoal_Event

class Fibonacci_GetResult(Service):
    Request: TypeAlias = Fibonacci_GetResult_Request
    Response: TypeAlias = Fibonacci_GetResult_Response
    Event: TypeAlias = Fibonacci_GetResult_Event

class Fibonacci(Action):
    Goal: TypeAlias = Fibonacci_Goal
    Result: TypeAlias = Fibonacci_Result
    Feedback: TypeAlias = Fibonacci_Feedback
    class Impl:
        SendGoalService: TypeAlias = Fibonacci_SendGoal
        GetResultService: TypeAlias = Fibonacci_GetResult
        FeedbackMessage: TypeAlias = Fibonacci_FeedbackMessage
        CancelGoalService: TypeAlias = action_msgs.srv.CancelGoal
        GoalStatusMessage: TypeAlias = action_msgs.msg.GoalStatusArray

class NestedMessage_Goal(Message):
    """test_msgs/action/NestedMessage_Goal

    # Messages inside each of the three parts of an action.

    Builtins nested_field_no_pkg
    test_msgs/BasicTypes nested_field
    builtin_interfaces/Time nested_different_pkg
    """
    def __init__(self, *, nested_field_no_pkg: test_msgs.msg.Builtins = ..., nested_field: test_msgs.msg.BasicTypes = ..., nested_different_pkg: builtin_interfaces.msg.Time = ..., check_fields: bool = ...) -> None: ...
    nested_field_no_pkg: test_msgs.msg.Builtins
    nested_field: test_msgs.msg.BasicTypes
    nested_different_pkg: builtin_interfaces.msg.Time

class NestedMessage_Result(Message):
    """test_msgs/action/NestedMessage_Result

    Builtins nested_field_no_pkg
    test_msgs/BasicTypes nested_field
    builtin_interfaces/Time nested_different_pkg
    """
    def __init__(self, *, nested_field_no_pkg: test_msgs.msg.Builtins = ..., nested_field: test_msgs.msg.BasicTypes = ..., nested_different_pkg: builtin_interfaces.msg.Time = ..., check_fields: bool = ...) -> None: ...
    nested_field_no_pkg: test_msgs.msg.Builtins
    nested_field: test_msgs.msg.BasicTypes
    nested_different_pkg: builtin_interfaces.msg.Time

class NestedMessage_Feedback(Message):
    """test_msgs/action/NestedMessage_Feedback

    Builtins nested_field_no_pkg
    test_msgs/BasicTypes nested_field
    builtin_interfaces/Time nested_different_pkg
    """
    def __init__(self, *, nested_field_no_pkg: test_msgs.msg.Builtins = ..., nested_field: test_msgs.msg.BasicTypes = ..., nested_different_pkg: builtin_interfaces.msg.Time = ..., check_fields: bool = ...) -> None: ...
    nested_field_no_pkg: test_msgs.msg.Builtins
    nested_field: test_msgs.msg.BasicTypes
    nested_different_pkg: builtin_interfaces.msg.Time

class NestedMessage_FeedbackMessage(Message):
    """test_msgs/action/NestedMessage_FeedbackMessage"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., feedback: test_msgs.action.NestedMessage_Feedback = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    feedback: test_msgs.action.NestedMessage_Feedback

class NestedMessage_SendGoal_Request(Message):
    """test_msgs/action/NestedMessage_SendGoal_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., goal: test_msgs.action.NestedMessage_Goal = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    goal: test_msgs.action.NestedMessage_Goal

class NestedMessage_SendGoal_Response(Message):
    """test_msgs/action/NestedMessage_SendGoal_Response"""
    def __init__(self, *, accepted: bool = ..., stamp: builtin_interfaces.msg.Time = ..., check_fields: bool = ...) -> None: ...
    accepted: bool
    stamp: builtin_interfaces.msg.Time

class NestedMessage_SendGoal_Event(Message):
    """test_msgs/action/NestedMessage_SendGoal_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[test_msgs.action.NestedMessage_SendGoal_Request] = ..., response: Collection[test_msgs.action.NestedMessage_SendGoal_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[test_msgs.action.NestedMessage_SendGoal_Request]: ...
    @request.setter
    def request(self, value: Collection[test_msgs.action.NestedMessage_SendGoal_Request]) -> None: ...
    @property
    def response(self) -> list[test_msgs.action.NestedMessage_SendGoal_Response]: ...
    @response.setter
    def response(self, value: Collection[test_msgs.action.NestedMessage_SendGoal_Response]) -> None: ...

class NestedMessage_GetResult_Request(Message):
    """test_msgs/action/NestedMessage_GetResult_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID

class NestedMessage_GetResult_Response(Message):
    """test_msgs/action/NestedMessage_GetResult_Response"""
    def __init__(self, *, status: int = ..., result: test_msgs.action.NestedMessage_Result = ..., check_fields: bool = ...) -> None: ...
    status: int
    result: test_msgs.action.NestedMessage_Result

class NestedMessage_GetResult_Event(Message):
    """test_msgs/action/NestedMessage_GetResult_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[test_msgs.action.NestedMessage_GetResult_Request] = ..., response: Collection[test_msgs.action.NestedMessage_GetResult_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[test_msgs.action.NestedMessage_GetResult_Request]: ...
    @request.setter
    def request(self, value: Collection[test_msgs.action.NestedMessage_GetResult_Request]) -> None: ...
    @property
    def response(self) -> list[test_msgs.action.NestedMessage_GetResult_Response]: ...
    @response.setter
    def response(self, value: Collection[test_msgs.action.NestedMessage_GetResult_Response]) -> None: ...

class NestedMessage_SendGoal(Service):
    Request: TypeAlias = NestedMessage_SendGoal_Request
    Response: TypeAlias = NestedMessage_SendGoal_Response
    Event: TypeAlias = NestedMessage_SendGoal_Event

class NestedMessage_GetResult(Service):
    Request: TypeAlias = NestedMessage_GetResult_Request
    Response: TypeAlias = NestedMessage_GetResult_Response
    Event: TypeAlias = NestedMessage_GetResult_Event

class NestedMessage(Action):
    Goal: TypeAlias = NestedMessage_Goal
    Result: TypeAlias = NestedMessage_Result
    Feedback: TypeAlias = NestedMessage_Feedback
    class Impl:
        SendGoalService: TypeAlias = NestedMessage_SendGoal
        GetResultService: TypeAlias = NestedMessage_GetResult
        FeedbackMessage: TypeAlias = NestedMessage_FeedbackMessage
        CancelGoalService: TypeAlias = action_msgs.srv.CancelGoal
        GoalStatusMessage: TypeAlias = action_msgs.msg.GoalStatusArray
