"""Tests of managed entities of a node, such as managed publishers."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import pytest

import zbot
from tests.conftest import wait_until
from tests.integration.lifecycle.conftest import Motor, Robot
from zbot.lifecycle import (
    LifecycleNode,
    LifecycleState,
    ManagedEntity,
    NotAManagedEntityError,
    SimpleManagedEntity,
)
from zbot.lifecycle import TransitionCallbackReturn as Outcome

from std_msgs.msg import String

if TYPE_CHECKING:
    from tests.conftest import MakeContext, Spin
    from zbot.log.record import Record

UNCONFIGURED = LifecycleState("unconfigured", 1)


class Recorder(ManagedEntity):
    def __init__(self, outcome: Any = Outcome.SUCCESS) -> None:
        self.outcome = outcome
        self.states: list[LifecycleState] = []

    def on_configure(self, state: LifecycleState) -> Outcome:
        self.states.append(state)
        return self.outcome  # type: ignore[no-any-return]


def test_entities_are_called_in_order_until_one_fails(make_context: MakeContext) -> None:
    node = LifecycleNode("plain", context=make_context())
    first, second, third = Recorder(), Recorder(Outcome.FAILURE), Recorder()
    for entity in (first, first, second, third):
        node.add_managed_entity(entity)
    assert node.trigger_configure() is Outcome.FAILURE
    assert (first.states, second.states, third.states) == ([UNCONFIGURED], [UNCONFIGURED], [])


def test_an_entity_callback_that_returns_nothing_is_reported(
    make_context: MakeContext, logged: list[Record]
) -> None:
    node = LifecycleNode("plain", context=make_context())
    node.add_managed_entity(Recorder(None))
    assert node.trigger_configure() is Outcome.ERROR
    assert "Recorder.on_configure() must return" in logged[-1].message


def test_only_managed_entities_can_be_managed(robot: Robot) -> None:
    with pytest.raises(NotAManagedEntityError, match=r"^42 cannot be managed"):
        robot.add_managed_entity(42)  # type: ignore[arg-type]


def test_a_simple_entity_works_while_its_node_is_active(robot: Robot) -> None:
    class Horn(SimpleManagedEntity):
        @SimpleManagedEntity.when_enabled(when_not_enabled=lambda: "no")
        def beep(self) -> str:
            return "beep"

    motor, horn = Motor(), Horn()
    robot.add_managed_entity(motor)
    robot.add_managed_entity(horn)
    assert (motor.turn(1), horn.beep()) == (None, "no")
    assert (motor.turns, motor.is_activated) == (0, False)
    robot.trigger_configure()
    robot.trigger_activate()
    assert (motor.turn(2), horn.beep()) == (2, "beep")
    assert (motor.turns, motor.is_activated) == (2, True)


@pytest.mark.parametrize("ending", ["deactivate", "shutdown", "failed deactivation", "error"])
def test_entities_of_an_inactive_node_do_nothing(robot: Robot, ending: str) -> None:
    motor = Motor()
    robot.add_managed_entity(motor)
    robot.trigger_configure()
    robot.trigger_activate()
    if ending == "shutdown":
        robot.trigger_shutdown()
    else:
        # Robot's own on_deactivate does not call its entities.
        robot.plan = {"deactivate": Outcome.ERROR if ending == "error" else Outcome.SUCCESS}
        if ending == "failed deactivation":
            robot.plan = {"deactivate": Outcome.FAILURE}
        robot.trigger_deactivate()
    assert motor.is_activated == (ending == "failed deactivation")


def test_a_failed_activation_activates_nothing(robot: Robot) -> None:
    motor = Motor()
    robot.add_managed_entity(motor)
    robot.plan = {"activate": Outcome.FAILURE}
    robot.trigger_configure()
    robot.trigger_activate()
    assert not motor.is_activated


def test_a_managed_publisher_publishes_while_active_and_warns_once(
    robot: Robot, make_context: MakeContext, spin: Spin, logged: list[Record]
) -> None:
    heard: list[str] = []
    listener = zbot.Node("listener", context=make_context())
    listener.create_subscription(String, "chatter", lambda msg: heard.append(msg.data), 10)
    spin(listener)
    publisher = robot.create_lifecycle_publisher(String, "chatter", 10)
    robot.trigger_configure()
    for word in ("one", "two"):
        publisher.publish(String(data=word))
    robot.trigger_activate()
    publisher.publish(String(data="three"))
    robot.trigger_deactivate()
    publisher.publish(String(data="four"))
    robot.trigger_activate()
    publisher.publish(String(data="five"))
    assert wait_until(lambda: heard == ["three", "five"])
    warnings = [
        record.message
        for record in logged
        if record.name == "robot" and "dropped" in record.message
    ]
    assert len(warnings) == 2
    assert warnings[0] == (
        "a message on /chatter was dropped: the node is not active "
        "(no more warnings come until the node is active)"
    )
    assert robot.destroy_lifecycle_publisher(publisher)
    assert not robot.destroy_lifecycle_publisher(publisher)
