# Written by python -m zbot.interfaces.stubs; do not edit.
from array import array
from collections.abc import Collection
from typing import Final, TypeAlias

import numpy
from numpy.typing import NDArray

import lifecycle_msgs.msg
import lifecycle_msgs.srv
import service_msgs.msg
from zbot.interfaces import Action, Message, Service

class ChangeState_Request(Message):
    """lifecycle_msgs/srv/ChangeState_Request

    # Asks a managed node to make a transition.

    # Which one: by its label if that is filled in, else by its id.
    Transition transition
    """
    def __init__(self, *, transition: lifecycle_msgs.msg.Transition = ..., check_fields: bool = ...) -> None: ...
    transition: lifecycle_msgs.msg.Transition

class ChangeState_Response(Message):
    """lifecycle_msgs/srv/ChangeState_Response


    # False if the node refused or the transition failed.
    bool success
    """
    def __init__(self, *, success: bool = ..., check_fields: bool = ...) -> None: ...
    success: bool

class ChangeState_Event(Message):
    """lifecycle_msgs/srv/ChangeState_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[lifecycle_msgs.srv.ChangeState_Request] = ..., response: Collection[lifecycle_msgs.srv.ChangeState_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[lifecycle_msgs.srv.ChangeState_Request]: ...
    @request.setter
    def request(self, value: Collection[lifecycle_msgs.srv.ChangeState_Request]) -> None: ...
    @property
    def response(self) -> list[lifecycle_msgs.srv.ChangeState_Response]: ...
    @response.setter
    def response(self, value: Collection[lifecycle_msgs.srv.ChangeState_Response]) -> None: ...

class ChangeState(Service):
    Request: TypeAlias = ChangeState_Request
    Response: TypeAlias = ChangeState_Response
    Event: TypeAlias = ChangeState_Event

class GetAvailableStates_Request(Message):
    """lifecycle_msgs/srv/GetAvailableStates_Request

    # Asks a managed node for all states it knows.
    """
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class GetAvailableStates_Response(Message):
    """lifecycle_msgs/srv/GetAvailableStates_Response

    # Those states.
    State[] available_states
    """
    def __init__(self, *, available_states: Collection[lifecycle_msgs.msg.State] = ..., check_fields: bool = ...) -> None: ...
    @property
    def available_states(self) -> list[lifecycle_msgs.msg.State]: ...
    @available_states.setter
    def available_states(self, value: Collection[lifecycle_msgs.msg.State]) -> None: ...

class GetAvailableStates_Event(Message):
    """lifecycle_msgs/srv/GetAvailableStates_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[lifecycle_msgs.srv.GetAvailableStates_Request] = ..., response: Collection[lifecycle_msgs.srv.GetAvailableStates_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[lifecycle_msgs.srv.GetAvailableStates_Request]: ...
    @request.setter
    def request(self, value: Collection[lifecycle_msgs.srv.GetAvailableStates_Request]) -> None: ...
    @property
    def response(self) -> list[lifecycle_msgs.srv.GetAvailableStates_Response]: ...
    @response.setter
    def response(self, value: Collection[lifecycle_msgs.srv.GetAvailableStates_Response]) -> None: ...

class GetAvailableStates(Service):
    Request: TypeAlias = GetAvailableStates_Request
    Response: TypeAlias = GetAvailableStates_Response
    Event: TypeAlias = GetAvailableStates_Event

class GetAvailableTransitions_Request(Message):
    """lifecycle_msgs/srv/GetAvailableTransitions_Request

    # Asks a managed node for transitions with the states they connect.
    """
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class GetAvailableTransitions_Response(Message):
    """lifecycle_msgs/srv/GetAvailableTransitions_Response

    # Those transitions.
    TransitionDescription[] available_transitions
    """
    def __init__(self, *, available_transitions: Collection[lifecycle_msgs.msg.TransitionDescription] = ..., check_fields: bool = ...) -> None: ...
    @property
    def available_transitions(self) -> list[lifecycle_msgs.msg.TransitionDescription]: ...
    @available_transitions.setter
    def available_transitions(self, value: Collection[lifecycle_msgs.msg.TransitionDescription]) -> None: ...

class GetAvailableTransitions_Event(Message):
    """lifecycle_msgs/srv/GetAvailableTransitions_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[lifecycle_msgs.srv.GetAvailableTransitions_Request] = ..., response: Collection[lifecycle_msgs.srv.GetAvailableTransitions_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[lifecycle_msgs.srv.GetAvailableTransitions_Request]: ...
    @request.setter
    def request(self, value: Collection[lifecycle_msgs.srv.GetAvailableTransitions_Request]) -> None: ...
    @property
    def response(self) -> list[lifecycle_msgs.srv.GetAvailableTransitions_Response]: ...
    @response.setter
    def response(self, value: Collection[lifecycle_msgs.srv.GetAvailableTransitions_Response]) -> None: ...

class GetAvailableTransitions(Service):
    Request: TypeAlias = GetAvailableTransitions_Request
    Response: TypeAlias = GetAvailableTransitions_Response
    Event: TypeAlias = GetAvailableTransitions_Event

class GetState_Request(Message):
    """lifecycle_msgs/srv/GetState_Request

    # Asks a managed node for the state it is in.
    """
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class GetState_Response(Message):
    """lifecycle_msgs/srv/GetState_Response

    # That state.
    State current_state
    """
    def __init__(self, *, current_state: lifecycle_msgs.msg.State = ..., check_fields: bool = ...) -> None: ...
    current_state: lifecycle_msgs.msg.State

class GetState_Event(Message):
    """lifecycle_msgs/srv/GetState_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[lifecycle_msgs.srv.GetState_Request] = ..., response: Collection[lifecycle_msgs.srv.GetState_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[lifecycle_msgs.srv.GetState_Request]: ...
    @request.setter
    def request(self, value: Collection[lifecycle_msgs.srv.GetState_Request]) -> None: ...
    @property
    def response(self) -> list[lifecycle_msgs.srv.GetState_Response]: ...
    @response.setter
    def response(self, value: Collection[lifecycle_msgs.srv.GetState_Response]) -> None: ...

class GetState(Service):
    Request: TypeAlias = GetState_Request
    Response: TypeAlias = GetState_Response
    Event: TypeAlias = GetState_Event
