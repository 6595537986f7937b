"""Tests of the transitions of managed nodes, started by their own methods."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

import zbot
from tests.integration.lifecycle.conftest import Motor, Robot
from zbot.lifecycle import (
    LifecycleNode,
    LifecycleNodeMixin,
    NotANodeError,
    TransitionNotPossibleError,
)
from zbot.lifecycle import TransitionCallbackReturn as Outcome

if TYPE_CHECKING:
    from tests.conftest import MakeContext
    from zbot.log.record import Record


@pytest.fixture
def lone_context(make_context: MakeContext) -> zbot.Context:
    return make_context()


def test_a_node_passes_through_all_states(robot: Robot) -> None:
    assert robot.label == "unconfigured"
    for trigger, label in (
        (robot.trigger_configure, "inactive"),
        (robot.trigger_activate, "active"),
        (robot.trigger_deactivate, "inactive"),
        (robot.trigger_cleanup, "unconfigured"),
        (robot.trigger_configure, "inactive"),
        (robot.trigger_shutdown, "finalized"),
    ):
        assert trigger() is Outcome.SUCCESS
        assert robot.label == label
    assert robot.calls == [
        ("configure", "unconfigured"),
        ("activate", "inactive"),
        ("deactivate", "active"),
        ("cleanup", "inactive"),
        ("configure", "unconfigured"),
        ("shutdown", "inactive"),
    ]


@pytest.mark.parametrize("state", ["unconfigured", "inactive", "active"])
def test_shutdown_works_from_every_state(robot: Robot, state: str) -> None:
    for trigger in (robot.trigger_configure, robot.trigger_activate):
        if robot.label != state:
            trigger()
    assert robot.trigger_shutdown() is Outcome.SUCCESS
    assert robot.calls[-1] == ("shutdown", state)
    assert robot.label == "finalized"
    with pytest.raises(TransitionNotPossibleError, match="'shutdown' from the state finalized"):
        robot.trigger_shutdown()


def test_a_failure_returns_to_the_previous_state(robot: Robot) -> None:
    robot.plan = {"configure": Outcome.FAILURE}
    assert robot.trigger_configure() is Outcome.FAILURE
    assert robot.label == "unconfigured"
    robot.plan = {"activate": Outcome.FAILURE, "cleanup": Outcome.FAILURE}
    robot.trigger_configure()
    assert robot.trigger_activate() is Outcome.FAILURE
    assert robot.trigger_cleanup() is Outcome.FAILURE
    assert robot.label == "inactive"
    robot.plan = {"deactivate": Outcome.FAILURE, "shutdown": Outcome.FAILURE}
    robot.trigger_activate()
    assert robot.trigger_deactivate() is Outcome.FAILURE
    assert robot.label == "active"
    assert robot.trigger_shutdown() is Outcome.FAILURE
    assert robot.label == "finalized"


@pytest.mark.parametrize(
    ("handled", "label"),
    [
        (Outcome.SUCCESS, "unconfigured"),
        (Outcome.FAILURE, "finalized"),
        (Outcome.ERROR, "finalized"),
        (ValueError("the handler fails too"), "finalized"),
    ],
)
def test_an_error_is_handled_by_on_error(robot: Robot, handled: object, label: str) -> None:
    robot.plan = {"activate": Outcome.ERROR, "error": handled}
    robot.trigger_configure()
    assert robot.trigger_activate() is Outcome.ERROR
    assert robot.calls[-1] == ("error", "inactive")
    assert robot.label == label


def test_an_exception_is_an_error_logged_with_its_line(robot: Robot, logged: list[Record]) -> None:
    robot.plan = {"configure": ValueError("no camera")}
    assert robot.trigger_configure() is Outcome.ERROR
    assert robot.label == "unconfigured"
    (record,) = [record for record in logged if record.name == "robot"]
    lines = record.message.splitlines()
    assert lines[0] == "on_configure() failed in the transition from unconfigured:"
    assert "conftest.py" in lines[2]
    assert lines[-1] == "ValueError: no camera"


async def never() -> None:
    """A coroutine that is never awaited."""


@pytest.mark.parametrize("returned", [None, True, 97, never])
def test_another_return_value_is_an_error(
    robot: Robot, logged: list[Record], returned: object
) -> None:
    robot.plan = {"configure": returned}
    assert robot.trigger_configure() is Outcome.ERROR
    assert robot.label == "unconfigured"
    assert (
        "Robot.on_configure() must return TransitionCallbackReturn.SUCCESS, FAILURE or ERROR, not"
        in logged[-1].message
    )


def test_a_callback_without_a_state_is_told_what_to_write(
    robot: Robot, logged: list[Record], monkeypatch: pytest.MonkeyPatch
) -> None:
    def on_configure(self: Robot) -> None:
        """Take no state."""

    monkeypatch.setattr(Robot, "on_configure", on_configure)
    assert robot.trigger_configure() is Outcome.ERROR
    assert "write def on_configure(self, state)" in logged[-1].message


def test_an_impossible_transition_is_refused_and_logged(robot: Robot, logged: list[Record]) -> None:
    assert robot.trigger_activate() is Outcome.ERROR
    assert robot.calls == []
    assert logged[-1].message == (
        "no transition 'activate' from the state unconfigured: "
        "possible transitions: configure [1], shutdown [5]"
    )


def test_a_transition_within_a_transition_is_refused(robot: Robot) -> None:
    inner: list[Outcome] = []

    def activate_too() -> Outcome:
        inner.append(robot.trigger_activate())
        return Outcome.SUCCESS

    robot.plan = {"configure": activate_too}
    assert robot.trigger_configure() is Outcome.SUCCESS
    assert inner == [Outcome.ERROR]
    assert robot.label == "inactive"


def test_a_callback_may_destroy_its_node(robot: Robot) -> None:
    def leave() -> Outcome:
        robot.destroy_node()
        return Outcome.SUCCESS

    robot.plan = {"shutdown": leave}
    assert robot.trigger_shutdown() is Outcome.SUCCESS
    assert robot.label == "finalized"


def test_a_shutdown_of_the_context_ends_a_callback(robot: Robot) -> None:
    robot.plan = {"configure": zbot.ExternalShutdownException()}
    with pytest.raises(zbot.ExternalShutdownException):
        robot.trigger_configure()


def test_a_derived_class_may_use_common_attribute_names(make_context: MakeContext) -> None:
    class Student(LifecycleNode):
        def __init__(self) -> None:
            super().__init__("student", context=make_context())
            self.state = self._state = self.machine = "mine"
            self.services_ready = self.entities = self.life = "mine"
            setattr(self, "_state_machine", "mine")  # noqa: B010 - a checker would object

    assert Student().trigger_configure() is Outcome.SUCCESS


def test_the_mixin_needs_a_node() -> None:
    class MixinWithoutNode(LifecycleNodeMixin):
        pass

    with pytest.raises(NotANodeError, match=r"^MixinWithoutNode is not a node"):
        MixinWithoutNode()


def test_the_mixin_makes_any_node_a_managed_node(make_context: MakeContext) -> None:
    class Talker(LifecycleNodeMixin, zbot.Node):
        def __init__(self) -> None:
            zbot.Node.__init__(self, "talker", context=make_context())
            LifecycleNodeMixin.__init__(self, callback_group=zbot.ReentrantCallbackGroup())

    assert Talker().trigger_configure() is Outcome.SUCCESS


# The possible next states of each callback by its outcome; on_error handles the first error.
GOALS = {
    ("unconfigured", "configure"): {"SUCCESS": "inactive", "FAILURE": "unconfigured"},
    ("inactive", "activate"): {"SUCCESS": "active", "FAILURE": "inactive"},
    ("active", "deactivate"): {"SUCCESS": "inactive", "FAILURE": "active"},
    ("inactive", "cleanup"): {"SUCCESS": "unconfigured", "FAILURE": "inactive"},
    ("unconfigured", "shutdown"): {"SUCCESS": "finalized", "FAILURE": "finalized"},
    ("inactive", "shutdown"): {"SUCCESS": "finalized", "FAILURE": "finalized"},
    ("active", "shutdown"): {"SUCCESS": "finalized", "FAILURE": "finalized"},
}
STEPS = st.tuples(
    st.sampled_from(sorted({trigger for _, trigger in GOALS})),
    st.sampled_from(Outcome),
    st.sampled_from(Outcome),
)


@settings(max_examples=40, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(st.lists(STEPS, max_size=8))
def test_any_order_of_triggers_and_outcomes_follows_the_table(
    lone_context: zbot.Context, steps: list[tuple[str, Outcome, Outcome]]
) -> None:
    with Robot(context=lone_context, enable_communication_interface=False) as robot:
        motor = Motor()
        robot.add_managed_entity(motor)
        for trigger, outcome, handled in steps:
            before, calls_before = robot.label, len(robot.calls)
            robot.plan = {trigger: outcome, "error": handled}
            goals = GOALS.get((before, trigger))
            if goals is None and trigger == "shutdown":
                with pytest.raises(TransitionNotPossibleError):
                    robot.trigger_shutdown()
                continue
            returned = getattr(robot, f"trigger_{trigger}")()
            if goals is None:
                assert (returned, robot.label, len(robot.calls)) == (
                    Outcome.ERROR,
                    before,
                    calls_before,
                )
            elif outcome is Outcome.ERROR:
                assert robot.calls[calls_before:] == [(trigger, before), ("error", before)]
                rescued = handled is Outcome.SUCCESS
                assert robot.label == ("unconfigured" if rescued else "finalized")
            else:
                assert robot.calls[calls_before:] == [(trigger, before)]
                assert (returned, robot.label) == (outcome, goals[outcome.name])
            assert motor.is_activated == (robot.label == "active")
