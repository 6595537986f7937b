"""States of a goal, compared with the table of the action design document."""

from __future__ import annotations

import pytest
from hypothesis import strategies as st
from hypothesis.stateful import RuleBasedStateMachine, invariant, rule

from zbot.action.goal_state import (
    GoalEvent,
    GoalState,
    GoalTransitionError,
    events_of,
    next_state,
)

from action_msgs.msg import GoalStatus

# State, event, next state: as documented in https://design.ros2.org/articles/actions.html.
DOCUMENTED = {
    ("ACCEPTED", "EXECUTE"): "EXECUTING",
    ("ACCEPTED", "CANCEL_GOAL"): "CANCELING",
    ("EXECUTING", "CANCEL_GOAL"): "CANCELING",
    ("EXECUTING", "SUCCEED"): "SUCCEEDED",
    ("EXECUTING", "ABORT"): "ABORTED",
    ("CANCELING", "CANCELED"): "CANCELED",
    ("CANCELING", "SUCCEED"): "SUCCEEDED",
    ("CANCELING", "ABORT"): "ABORTED",
}


@pytest.mark.parametrize("state", GoalState)
@pytest.mark.parametrize("event", GoalEvent)
def test_every_event_follows_the_table_or_is_refused(state: GoalState, event: GoalEvent) -> None:
    expected = DOCUMENTED.get((state.name, event.name))
    if expected is None:
        with pytest.raises(GoalTransitionError, match=state.name) as refused:
            next_state(state, event)
        assert (refused.value.state, refused.value.event) == (state, event)
    else:
        assert next_state(state, event) is GoalState[expected]


@pytest.mark.parametrize("state", GoalState)
def test_a_state_has_its_events(state: GoalState) -> None:
    events = {event.name for event in events_of(state)}
    assert events == {event for known, event in DOCUMENTED if known == state.name}
    assert state.is_cancelable == ("CANCEL_GOAL" in events)
    assert state.is_active == bool(events)


def test_states_have_the_numbers_of_goal_status() -> None:
    for state in GoalState:
        assert getattr(GoalStatus, f"STATUS_{state.name}") == state.value


@pytest.mark.parametrize(
    ("state", "event", "text"),
    [
        (
            GoalState.SUCCEEDED,
            GoalEvent.SUCCEED,
            "a goal that is SUCCEEDED cannot succeed: it has ended",
        ),
        (
            GoalState.ACCEPTED,
            GoalEvent.ABORT,
            "a goal that is ACCEPTED cannot abort: possible now: execute()",
        ),
        (
            GoalState.EXECUTING,
            GoalEvent.CANCELED,
            "a goal that is EXECUTING cannot be canceled: possible now: succeed(), abort()",
        ),
        (
            GoalState.CANCELING,
            GoalEvent.CANCEL_GOAL,
            (
                "a goal that is CANCELING cannot be asked to cancel: possible now: succeed(), "
                "abort(), canceled()"
            ),
        ),
    ],
)
def test_an_error_lists_the_possible_steps(state: GoalState, event: GoalEvent, text: str) -> None:
    with pytest.raises(GoalTransitionError) as refused:
        next_state(state, event)
    assert str(refused.value) == text


class GoalLife(RuleBasedStateMachine):
    """Any sequence of events: a refused event changes nothing, and no event follows the end."""

    def __init__(self) -> None:
        super().__init__()
        self.state = GoalState.ACCEPTED
        self.history = [self.state]

    @rule(event=st.sampled_from(GoalEvent))
    def happen(self, event: GoalEvent) -> None:
        expected = DOCUMENTED.get((self.state.name, event.name))
        try:
            self.state = next_state(self.state, event)
        except GoalTransitionError:
            assert expected is None
        else:
            assert self.state.name == expected
            self.history.append(self.state)

    @invariant()
    def states_follow_each_other_upwards(self) -> None:
        assert self.history == sorted(set(self.history))

    @invariant()
    def only_what_was_asked_to_cancel_is_canceled(self) -> None:
        if self.state is GoalState.CANCELED:
            assert self.history[-2] is GoalState.CANCELING

    @invariant()
    def it_is_either_active_or_at_its_end(self) -> None:
        assert self.state.is_active != self.state.is_terminal


TestGoalLife = GoalLife.TestCase
