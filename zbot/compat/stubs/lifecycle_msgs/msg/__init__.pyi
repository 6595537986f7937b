# Written by python -m zbot.interfaces.stubs; do not edit.
from array import array
from collections.abc import Collection
from typing import Final, TypeAlias

import numpy
from numpy.typing import NDArray

import lifecycle_msgs.msg
from zbot.interfaces import Action, Message, Service

class State(Message):
    """lifecycle_msgs/msg/State

    # A state in the life of a managed node.

    # States in which a node rests until somebody asks for a transition.

    # Not known.
    uint8 PRIMARY_STATE_UNKNOWN = 0

    # Just created, or cleaned up.
    uint8 PRIMARY_STATE_UNCONFIGURED = 1

    # Set up, but not working.
    uint8 PRIMARY_STATE_INACTIVE = 2

    # At work.
    uint8 PRIMARY_STATE_ACTIVE = 3

    # Shut down; all that is left is to be destroyed.
    uint8 PRIMARY_STATE_FINALIZED = 4

    # States a node passes through while the callback of that name runs.

    # on_configure
    uint8 TRANSITION_STATE_CONFIGURING = 10

    # on_cleanup
    uint8 TRANSITION_STATE_CLEANINGUP = 11

    # on_shutdown
    uint8 TRANSITION_STATE_SHUTTINGDOWN = 12

    # on_activate
    uint8 TRANSITION_STATE_ACTIVATING = 13

    # on_deactivate
    uint8 TRANSITION_STATE_DEACTIVATING = 14

    # on_error
    uint8 TRANSITION_STATE_ERRORPROCESSING = 15

    # One of the numbers above.
    uint8 id

    # Its name, such as 'active'.
    string label
    """
    PRIMARY_STATE_UNKNOWN: Final = 0
    PRIMARY_STATE_UNCONFIGURED: Final = 1
    PRIMARY_STATE_INACTIVE: Final = 2
    PRIMARY_STATE_ACTIVE: Final = 3
    PRIMARY_STATE_FINALIZED: Final = 4
    TRANSITION_STATE_CONFIGURING: Final = 10
    TRANSITION_STATE_CLEANINGUP: Final = 11
    TRANSITION_STATE_SHUTTINGDOWN: Final = 12
    TRANSITION_STATE_ACTIVATING: Final = 13
    TRANSITION_STATE_DEACTIVATING: Final = 14
    TRANSITION_STATE_ERRORPROCESSING: Final = 15
    def __init__(self, *, id: int = ..., label: str = ..., check_fields: bool = ...) -> None: ...
    id: int
    label: str

class Transition(Message):
    """lifecycle_msgs/msg/Transition

    # A change from one state to another in the life of a managed node.

    # 0 to 9: may be asked for.

    # Nothing -> unconfigured
    uint8 TRANSITION_CREATE = 0

    # Unconfigured -> inactive
    uint8 TRANSITION_CONFIGURE = 1

    # Inactive -> unconfigured
    uint8 TRANSITION_CLEANUP = 2

    # Inactive -> active
    uint8 TRANSITION_ACTIVATE = 3

    # Active -> inactive
    uint8 TRANSITION_DEACTIVATE = 4

    # Unconfigured -> finalized
    uint8 TRANSITION_UNCONFIGURED_SHUTDOWN  = 5

    # Inactive -> finalized
    uint8 TRANSITION_INACTIVE_SHUTDOWN = 6

    # Active -> finalized
    uint8 TRANSITION_ACTIVE_SHUTDOWN = 7

    # Finalized -> gone
    uint8 TRANSITION_DESTROY = 8

    # 10 to 69: follow by themselves, depending on how a callback went.
    uint8 TRANSITION_ON_CONFIGURE_SUCCESS = 10
    uint8 TRANSITION_ON_CONFIGURE_FAILURE = 11
    uint8 TRANSITION_ON_CONFIGURE_ERROR = 12

    uint8 TRANSITION_ON_CLEANUP_SUCCESS = 20
    uint8 TRANSITION_ON_CLEANUP_FAILURE = 21
    uint8 TRANSITION_ON_CLEANUP_ERROR = 22

    uint8 TRANSITION_ON_ACTIVATE_SUCCESS = 30
    uint8 TRANSITION_ON_ACTIVATE_FAILURE = 31
    uint8 TRANSITION_ON_ACTIVATE_ERROR = 32

    uint8 TRANSITION_ON_DEACTIVATE_SUCCESS = 40
    uint8 TRANSITION_ON_DEACTIVATE_FAILURE = 41
    uint8 TRANSITION_ON_DEACTIVATE_ERROR = 42

    uint8 TRANSITION_ON_SHUTDOWN_SUCCESS = 50
    uint8 TRANSITION_ON_SHUTDOWN_FAILURE = 51
    uint8 TRANSITION_ON_SHUTDOWN_ERROR = 52

    uint8 TRANSITION_ON_ERROR_SUCCESS = 60
    uint8 TRANSITION_ON_ERROR_FAILURE = 61
    uint8 TRANSITION_ON_ERROR_ERROR = 62

    # 90 to 99: what a callback returns.

    # It worked: go on to the new state.
    uint8 TRANSITION_CALLBACK_SUCCESS = 97

    # It did not work: go back to the old state.
    uint8 TRANSITION_CALLBACK_FAILURE = 98

    # It broke something: run on_error.
    uint8 TRANSITION_CALLBACK_ERROR = 99

    # One of the transitions above.
    uint8 id

    # Its name, such as 'activate'.
    string label
    """
    TRANSITION_CREATE: Final = 0
    TRANSITION_CONFIGURE: Final = 1
    TRANSITION_CLEANUP: Final = 2
    TRANSITION_ACTIVATE: Final = 3
    TRANSITION_DEACTIVATE: Final = 4
    TRANSITION_UNCONFIGURED_SHUTDOWN: Final = 5
    TRANSITION_INACTIVE_SHUTDOWN: Final = 6
    TRANSITION_ACTIVE_SHUTDOWN: Final = 7
    TRANSITION_DESTROY: Final = 8
    TRANSITION_ON_CONFIGURE_SUCCESS: Final = 10
    TRANSITION_ON_CONFIGURE_FAILURE: Final = 11
    TRANSITION_ON_CONFIGURE_ERROR: Final = 12
    TRANSITION_ON_CLEANUP_SUCCESS: Final = 20
    TRANSITION_ON_CLEANUP_FAILURE: Final = 21
    TRANSITION_ON_CLEANUP_ERROR: Final = 22
    TRANSITION_ON_ACTIVATE_SUCCESS: Final = 30
    TRANSITION_ON_ACTIVATE_FAILURE: Final = 31
    TRANSITION_ON_ACTIVATE_ERROR: Final = 32
    TRANSITION_ON_DEACTIVATE_SUCCESS: Final = 40
    TRANSITION_ON_DEACTIVATE_FAILURE: Final = 41
    TRANSITION_ON_DEACTIVATE_ERROR: Final = 42
    TRANSITION_ON_SHUTDOWN_SUCCESS: Final = 50
    TRANSITION_ON_SHUTDOWN_FAILURE: Final = 51
    TRANSITION_ON_SHUTDOWN_ERROR: Final = 52
    TRANSITION_ON_ERROR_SUCCESS: Final = 60
    TRANSITION_ON_ERROR_FAILURE: Final = 61
    TRANSITION_ON_ERROR_ERROR: Final = 62
    TRANSITION_CALLBACK_SUCCESS: Final = 97
    TRANSITION_CALLBACK_FAILURE: Final = 98
    TRANSITION_CALLBACK_ERROR: Final = 99
    def __init__(self, *, id: int = ..., label: str = ..., check_fields: bool = ...) -> None: ...
    id: int
    label: str

class TransitionDescription(Message):
    """lifecycle_msgs/msg/TransitionDescription

    # A transition with the states it connects.

    # Which transition.
    Transition transition

    # State before it.
    State start_state

    # State after it.
    State goal_state
    """
    def __init__(self, *, transition: lifecycle_msgs.msg.Transition = ..., start_state: lifecycle_msgs.msg.State = ..., goal_state: lifecycle_msgs.msg.State = ..., check_fields: bool = ...) -> None: ...
    transition: lifecycle_msgs.msg.Transition
    start_state: lifecycle_msgs.msg.State
    goal_state: lifecycle_msgs.msg.State

class TransitionEvent(Message):
    """lifecycle_msgs/msg/TransitionEvent

    # Tells that a managed node went from one state to another.

    # When, in ns.
    uint64 timestamp

    # Which transition.
    Transition transition

    # State before it.
    State start_state

    # State after it.
    State goal_state
    """
    def __init__(self, *, timestamp: int = ..., transition: lifecycle_msgs.msg.Transition = ..., start_state: lifecycle_msgs.msg.State = ..., goal_state: lifecycle_msgs.msg.State = ..., check_fields: bool = ...) -> None: ...
    timestamp: int
    transition: lifecycle_msgs.msg.Transition
    start_state: lifecycle_msgs.msg.State
    goal_state: lifecycle_msgs.msg.State
