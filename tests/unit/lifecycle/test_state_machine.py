"""State machine of a managed node, compared with the table of the design document."""

from __future__ import annotations

import threading

import pytest
from hypothesis import strategies as st
from hypothesis.stateful import RuleBasedStateMachine, invariant, rule

from tests.conftest import in_threads
from zbot.lifecycle.state_machine import (
    ERROR_PROCESSING,
    FINALIZED,
    INACTIVE,
    STATES,
    TRANSITIONS,
    UNCONFIGURED,
    LifecycleState,
    StateMachine,
    TransitionCallbackReturn,
    TransitionNotPossibleError,
    transitions_from,
)

from lifecycle_msgs.msg import State, Transition

# State, label, number, next state: https://design.ros2.org/articles/node_lifecycle.html with the
# numbers of lifecycle_msgs.
DOCUMENTED = {
    ("unconfigured", "configure"): (1, "configuring"),
    ("unconfigured", "shutdown"): (5, "shuttingdown"),
    ("inactive", "cleanup"): (2, "cleaningup"),
    ("inactive", "activate"): (3, "activating"),
    ("inactive", "shutdown"): (6, "shuttingdown"),
    ("active", "deactivate"): (4, "deactivating"),
    ("active", "shutdown"): (7, "shuttingdown"),
    ("configuring", "transition_success"): (10, "inactive"),
    ("configuring", "transition_failure"): (11, "unconfigured"),
    ("configuring", "transition_error"): (12, "errorprocessing"),
    ("cleaningup", "transition_success"): (20, "unconfigured"),
    ("cleaningup", "transition_failure"): (21, "inactive"),
    ("cleaningup", "transition_error"): (22, "errorprocessing"),
    ("activating", "transition_success"): (30, "active"),
    ("activating", "transition_failure"): (31, "inactive"),
    ("activating", "transition_error"): (32, "errorprocessing"),
    ("deactivating", "transition_success"): (40, "inactive"),
    ("deactivating", "transition_failure"): (41, "active"),
    ("deactivating", "transition_error"): (42, "errorprocessing"),
    ("shuttingdown", "transition_success"): (50, "finalized"),
    ("shuttingdown", "transition_failure"): (51, "finalized"),
    ("shuttingdown", "transition_error"): (52, "errorprocessing"),
    ("errorprocessing", "transition_success"): (60, "unconfigured"),
    ("errorprocessing", "transition_failure"): (61, "finalized"),
    ("errorprocessing", "transition_error"): (62, "finalized"),
}
LABELS = sorted({label for _, label in DOCUMENTED} | {"create", "destroy", "bogus", ""})
NUMBERS = range(256)


def machine_in(state: LifecycleState) -> StateMachine:
    machine = StateMachine()
    machine._state = state
    return machine


def test_the_transitions_are_those_of_the_table() -> None:
    assert {
        (transition.start.label, transition.label): (
            transition.transition_id,
            transition.goal.label,
        )
        for transition in TRANSITIONS
    } == DOCUMENTED
    assert len(TRANSITIONS) == len(DOCUMENTED)


@pytest.mark.parametrize("state", STATES)
@pytest.mark.parametrize("label", LABELS)
def test_a_label_follows_the_table_or_is_refused(state: LifecycleState, label: str) -> None:
    machine = machine_in(state)
    expected = DOCUMENTED.get((state.label, label))
    if expected is None:
        with pytest.raises(TransitionNotPossibleError, match=state.label) as refused:
            machine.trigger(label)
        assert (refused.value.wanted, refused.value.state) == (label, state)
        assert machine.state == state
    else:
        done = machine.trigger(label)
        assert (done.transition_id, machine.state.label) == expected
        assert done.start == state


@pytest.mark.parametrize("state", STATES)
def test_a_number_follows_the_table_or_is_refused(state: LifecycleState) -> None:
    possible = {
        number: goal for (start, _), (number, goal) in DOCUMENTED.items() if start == state[0]
    }
    for number in NUMBERS:
        machine = machine_in(state)
        if number in possible:
            assert machine.trigger(number).goal.label == possible[number]
        else:
            with pytest.raises(TransitionNotPossibleError):
                machine.trigger(number)
            assert machine.state == state


def test_states_have_the_numbers_of_lifecycle_msgs() -> None:
    constants = {
        **{name: value for name, value in vars(State).items() if name.startswith("PRIMARY_STATE_")},
        **{name: value for name, value in vars(State).items() if "TRANSITION_STATE_" in name},
    }
    by_label = {name.rpartition("STATE_")[2].lower(): value for name, value in constants.items()}
    assert {state.label: state.state_id for state in STATES} == by_label


def test_transitions_have_the_numbers_of_lifecycle_msgs() -> None:
    outcomes = {
        name.removeprefix("TRANSITION_ON_"): value
        for name, value in vars(Transition).items()
        if name.startswith("TRANSITION_ON_")
    }
    assert sorted(outcomes.values()) == [n for n, _ in sorted(DOCUMENTED.values()) if n >= 10]
    for name in ("CONFIGURE", "CLEANUP", "ACTIVATE", "DEACTIVATE"):
        number = getattr(Transition, f"TRANSITION_{name}")
        assert [
            transition.label for transition in TRANSITIONS if transition.transition_id == number
        ] == [name.lower()]
    for name in ("UNCONFIGURED", "INACTIVE", "ACTIVE"):
        number = getattr(Transition, f"TRANSITION_{name}_SHUTDOWN")
        (found,) = [transition for transition in TRANSITIONS if transition.transition_id == number]
        assert (found.start.label, found.label) == (name.lower(), "shutdown")


def test_outcomes_have_the_numbers_of_lifecycle_msgs() -> None:
    for outcome in TransitionCallbackReturn:
        assert getattr(Transition, f"TRANSITION_CALLBACK_{outcome.name}") == int(outcome)
        assert outcome.to_label() == f"transition_{outcome.name.lower()}"


def test_the_present_state_has_rclpys_form_too() -> None:
    assert StateMachine().current_state == (1, "unconfigured")


def test_an_error_lists_the_possible_steps() -> None:
    machine = StateMachine()
    with pytest.raises(TransitionNotPossibleError) as refused:
        machine.trigger("activate")
    assert str(refused.value) == (
        "no transition 'activate' from the state unconfigured: "
        "possible transitions: configure [1], shutdown [5]"
    )
    with pytest.raises(TransitionNotPossibleError, match=r"the node is finalized$"):
        machine_in(FINALIZED).find("configure")


def test_of_threads_that_leave_a_state_one_succeeds() -> None:
    for _ in range(50):
        machine = machine_in(INACTIVE)
        refusals: list[TransitionNotPossibleError] = []
        barrier = threading.Barrier(4)

        def leave(
            _: int,
            machine: StateMachine = machine,
            barrier: threading.Barrier = barrier,
            refusals: list[TransitionNotPossibleError] = refusals,
        ) -> None:
            barrier.wait()
            try:
                machine.trigger("activate")
            except TransitionNotPossibleError as error:
                refusals.append(error)

        in_threads(leave, 4)
        assert len(refusals) == 3


class RandomRequests(RuleBasedStateMachine):
    """Any sequence of requests leads to the state in the documented table."""

    def __init__(self) -> None:
        super().__init__()
        self.machine = StateMachine()
        self.state = "unconfigured"

    @rule(label=st.sampled_from(LABELS))
    def ask_by_label(self, label: str) -> None:
        self._ask(label, DOCUMENTED.get((self.state, label)))

    @rule(number=st.sampled_from([number for number, _ in DOCUMENTED.values()]) | st.integers())
    def ask_by_number(self, number: int) -> None:
        goals = {
            n: (n, goal) for (start, _), (n, goal) in DOCUMENTED.items() if start == self.state
        }
        self._ask(number, goals.get(number))

    @rule(outcome=st.sampled_from(TransitionCallbackReturn))
    def end_a_callback(self, outcome: TransitionCallbackReturn) -> None:
        label = outcome.to_label()
        self._ask(label, DOCUMENTED.get((self.state, label)))

    def _ask(self, wanted: str | int, expected: tuple[int, str] | None) -> None:
        try:
            number = self.machine.trigger(wanted).transition_id
        except TransitionNotPossibleError:
            assert expected is None
        else:
            assert expected is not None
            assert number == expected[0]
            self.state = expected[1]

    @invariant()
    def is_where_the_table_says(self) -> None:
        assert self.machine.state.label == self.state
        labels = {transition.label for transition in transitions_from(self.machine.state)}
        assert labels == {label for start, label in DOCUMENTED if start == self.state}

    @invariant()
    def the_end_is_final(self) -> None:
        assert bool(transitions_from(self.machine.state)) == (self.state != "finalized")


TestLife = RandomRequests.TestCase


def test_an_error_leads_to_unconfigured_or_finalized() -> None:
    goals = [transition.goal for transition in transitions_from(ERROR_PROCESSING)]
    assert goals == [UNCONFIGURED, FINALIZED, FINALIZED]
