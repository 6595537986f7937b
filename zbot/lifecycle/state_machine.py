"""State machine of a managed node: its states, and the transitions between them.

unconfigured --configure--> inactive --activate--> active
             <---cleanup---          <-deactivate-
each of the three --shutdown--> finalized

Between two of these states is a transition state (`configuring`, `activating` ...), in which the
node's callback runs. The next state depends on the callback's return value. After an error, the
next state is `errorprocessing`. The state after that is `unconfigured` if `on_error` succeeds, else
`finalized`.
"""

from __future__ import annotations

import threading
from enum import Enum
from typing import NamedTuple

from zbot.errors import ZbotError


class LifecycleState(NamedTuple):
    """A state. Its label and number are defined in `lifecycle_msgs/msg/State`."""

    label: str
    state_id: int


class Transition(NamedTuple):
    """A change from one state to another, numbered as in `lifecycle_msgs/msg/Transition`."""

    transition_id: int
    label: str
    start: LifecycleState
    goal: LifecycleState


class TransitionCallbackReturn(Enum):
    """Return value of a managed node's callback."""

    SUCCESS = 97
    FAILURE = 98  #: back to the previous state, or to `finalized` after `on_shutdown` or `on_error`
    ERROR = 99  #: `on_error` runs next

    def __int__(self) -> int:
        return self.value

    def to_label(self) -> str:
        """Return the label of the transition after the callback."""
        return f"transition_{self.name.lower()}"


UNKNOWN = LifecycleState("unknown", 0)
UNCONFIGURED = LifecycleState("unconfigured", 1)
INACTIVE = LifecycleState("inactive", 2)
ACTIVE = LifecycleState("active", 3)
FINALIZED = LifecycleState("finalized", 4)
CONFIGURING = LifecycleState("configuring", 10)
CLEANING_UP = LifecycleState("cleaningup", 11)
SHUTTING_DOWN = LifecycleState("shuttingdown", 12)
ACTIVATING = LifecycleState("activating", 13)
DEACTIVATING = LifecycleState("deactivating", 14)
ERROR_PROCESSING = LifecycleState("errorprocessing", 15)

#: Every state, in the order of the numbers.
STATES = (
    UNKNOWN,
    UNCONFIGURED,
    INACTIVE,
    ACTIVE,
    FINALIZED,
    CONFIGURING,
    CLEANING_UP,
    SHUTTING_DOWN,
    ACTIVATING,
    DEACTIVATING,
    ERROR_PROCESSING,
)


def _outcomes(
    first_id: int,
    start: LifecycleState,
    success: LifecycleState,
    failure: LifecycleState,
    error: LifecycleState = ERROR_PROCESSING,
) -> tuple[Transition, ...]:
    goals = zip(TransitionCallbackReturn, (success, failure, error), strict=True)
    return tuple(
        Transition(first_id + offset, how.to_label(), start, goal)
        for offset, (how, goal) in enumerate(goals)
    )


#: Every transition, in the order in which ROS 2 lists them (rcl_lifecycle's default machine).
TRANSITIONS = (
    Transition(1, "configure", UNCONFIGURED, CONFIGURING),
    *_outcomes(10, CONFIGURING, INACTIVE, UNCONFIGURED),
    Transition(2, "cleanup", INACTIVE, CLEANING_UP),
    *_outcomes(20, CLEANING_UP, UNCONFIGURED, INACTIVE),
    Transition(3, "activate", INACTIVE, ACTIVATING),
    *_outcomes(30, ACTIVATING, ACTIVE, INACTIVE),
    Transition(4, "deactivate", ACTIVE, DEACTIVATING),
    *_outcomes(40, DEACTIVATING, INACTIVE, ACTIVE),
    Transition(5, "shutdown", UNCONFIGURED, SHUTTING_DOWN),
    Transition(6, "shutdown", INACTIVE, SHUTTING_DOWN),
    Transition(7, "shutdown", ACTIVE, SHUTTING_DOWN),
    *_outcomes(50, SHUTTING_DOWN, FINALIZED, FINALIZED),
    *_outcomes(60, ERROR_PROCESSING, UNCONFIGURED, FINALIZED, FINALIZED),
)


def transitions_from(state: LifecycleState) -> tuple[Transition, ...]:
    """Return the transitions that are possible in a state."""
    return tuple(transition for transition in TRANSITIONS if transition.start == state)


class TransitionNotPossibleError(ZbotError, RuntimeError):
    """A managed node's state does not allow a transition."""

    def __init__(self, wanted: str | int, state: LifecycleState) -> None:
        self.wanted, self.state = wanted, state
        possible = ", ".join(
            f"{transition.label} [{transition.transition_id}]"
            for transition in transitions_from(state)
        )
        super().__init__(
            f"no transition {wanted!r} from the state {state.label}: "
            + (f"possible transitions: {possible}" if possible else "the node is finalized")
        )


class StateMachine:
    """State machine of one node. Any thread may read and change the state."""

    # rclpy's names of the services. They are `None` if the node has no services.
    service_change_state: object | None = None
    service_get_state: object | None = None
    service_get_available_states: object | None = None
    service_get_available_transitions: object | None = None
    service_get_transition_graph: object | None = None

    def __init__(self) -> None:
        self._state = UNCONFIGURED
        self._lock = threading.Lock()

    @property
    def state(self) -> LifecycleState:
        """The present state."""
        return self._state

    @property
    def current_state(self) -> tuple[int, str]:
        """Number and label of the present state, as in rclpy's state machine."""
        return self._state.state_id, self._state.label

    def find(self, wanted: str | int) -> Transition:
        """Return the transition that has this label or number and starts at the present state.

        Raises:
            TransitionNotPossibleError: The present state does not allow the transition.
        """
        state = self._state
        for transition in transitions_from(state):
            if wanted in {transition.label, transition.transition_id}:
                return transition
        raise TransitionNotPossibleError(wanted, state)

    def trigger(self, wanted: str | int) -> Transition:
        """Make the transition that has this label or number, and return it.

        Raises:
            TransitionNotPossibleError: The present state does not allow the transition.
        """
        with self._lock:  # if two threads want to leave a state, only one of them can
            transition = self.find(wanted)
            self._state = transition.goal
        return transition
