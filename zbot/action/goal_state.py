"""State machine of a goal: its states, and the events that change the state.

Each line shows a state, and its events with the next states:

    ACCEPTED:  EXECUTE -> EXECUTING, CANCEL_GOAL -> CANCELING
    EXECUTING: SUCCEED -> SUCCEEDED, ABORT -> ABORTED, CANCEL_GOAL -> CANCELING
    CANCELING: CANCELED -> CANCELED, SUCCEED -> SUCCEEDED, ABORT -> ABORTED
"""

from __future__ import annotations

from enum import Enum, IntEnum

from zbot.errors import ZbotError


class GoalState(IntEnum):
    """States of a goal, with the numbers of `action_msgs/msg/GoalStatus`."""

    UNKNOWN = 0
    ACCEPTED = 1
    EXECUTING = 2
    CANCELING = 3
    SUCCEEDED = 4
    CANCELED = 5
    ABORTED = 6

    @property
    def is_active(self) -> bool:
        """Whether the goal has not ended."""
        return self in _TRANSITIONS

    @property
    def is_terminal(self) -> bool:
        """Whether the goal has ended. It has a result, or will soon have a result."""
        return self >= GoalState.SUCCEEDED

    @property
    def is_cancelable(self) -> bool:
        """Whether the goal can be canceled."""
        return GoalEvent.CANCEL_GOAL in _TRANSITIONS.get(self, {})


class GoalEvent(Enum):
    """Events that change a goal's state."""

    EXECUTE = "execute"
    CANCEL_GOAL = "cancel_goal"
    SUCCEED = "succeed"
    ABORT = "abort"
    CANCELED = "canceled"


# The table of rcl_action's goal state machine.
_TRANSITIONS: dict[GoalState, dict[GoalEvent, GoalState]] = {
    GoalState.ACCEPTED: {
        GoalEvent.EXECUTE: GoalState.EXECUTING,
        GoalEvent.CANCEL_GOAL: GoalState.CANCELING,
    },
    GoalState.EXECUTING: {
        GoalEvent.CANCEL_GOAL: GoalState.CANCELING,
        GoalEvent.SUCCEED: GoalState.SUCCEEDED,
        GoalEvent.ABORT: GoalState.ABORTED,
    },
    GoalState.CANCELING: {
        GoalEvent.SUCCEED: GoalState.SUCCEEDED,
        GoalEvent.ABORT: GoalState.ABORTED,
        GoalEvent.CANCELED: GoalState.CANCELED,
    },
}


class GoalTransitionError(ZbotError, RuntimeError):
    """A goal's state does not allow an event, for example a second `succeed()`."""

    def __init__(self, state: GoalState, event: GoalEvent) -> None:
        self.state, self.event = state, event
        possible = [f"{event.value}()" for event in events_of(state) if event in _METHODS]
        hint = f"possible now: {', '.join(possible)}" if possible else "it has ended"
        super().__init__(f"a goal that is {state.name} cannot {_phrase(event)}: {hint}")


_METHODS = {GoalEvent.EXECUTE, GoalEvent.SUCCEED, GoalEvent.ABORT, GoalEvent.CANCELED}


def _phrase(event: GoalEvent) -> str:
    return {GoalEvent.CANCEL_GOAL: "be asked to cancel", GoalEvent.CANCELED: "be canceled"}.get(
        event, event.value
    )


def events_of(state: GoalState) -> list[GoalEvent]:
    """Return the events that a state allows."""
    return list(_TRANSITIONS.get(state, ()))


def next_state(state: GoalState, event: GoalEvent) -> GoalState:
    """Return the state after an event.

    Raises:
        GoalTransitionError: The state does not allow the event.
    """
    try:
        return _TRANSITIONS[state][event]
    except KeyError:
        raise GoalTransitionError(state, event) from None
