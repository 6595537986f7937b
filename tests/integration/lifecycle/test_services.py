"""Tests of the services and the topic by which other nodes manage a node."""

from __future__ import annotations

import threading
from typing import TYPE_CHECKING, Any

import pytest

import zbot
from tests.conftest import wait_until
from tests.integration.lifecycle.conftest import Robot
from zbot.lifecycle import TransitionCallbackReturn as Outcome

from lifecycle_msgs.msg import Transition, TransitionEvent
from lifecycle_msgs.srv import ChangeState, GetAvailableStates, GetAvailableTransitions, GetState

if TYPE_CHECKING:
    from tests.conftest import MakeContext, Spin


def call(context: zbot.Context, srv_type: type[Any], name: str, **fields: Any) -> Any:
    node = zbot.Node("caller", context=context, start_parameter_services=False)
    client = node.create_client(srv_type, name)
    assert client.wait_for_service(5)
    response = client.call(srv_type.Request(**fields), timeout_sec=5)
    node.destroy_node()
    return response


def change(context: zbot.Context, *, number: int = 0, label: str = "") -> bool:
    transition = Transition(id=number, label=label)
    done: bool = call(context, ChangeState, "/robot/change_state", transition=transition).success
    return done


def test_services_and_topic_are_those_of_ros2(robot: Robot) -> None:
    services = dict(robot.get_service_names_and_types_by_node("robot", "/"))
    found = {name: types for name, types in services.items() if "lifecycle_msgs" in types[0]}
    assert found == {
        "/robot/change_state": ["lifecycle_msgs/srv/ChangeState"],
        "/robot/get_state": ["lifecycle_msgs/srv/GetState"],
        "/robot/get_available_states": ["lifecycle_msgs/srv/GetAvailableStates"],
        "/robot/get_available_transitions": ["lifecycle_msgs/srv/GetAvailableTransitions"],
        "/robot/get_transition_graph": ["lifecycle_msgs/srv/GetAvailableTransitions"],
    }
    topics = dict(robot.get_publisher_names_and_types_by_node("robot", "/"))
    assert topics["/robot/transition_event"] == ["lifecycle_msgs/msg/TransitionEvent"]


def test_the_state_machine_has_its_services(robot: Robot) -> None:
    service: Any = robot._state_machine.service_change_state
    assert service.service_name == "/robot/change_state"


def test_the_interface_is_enabled_by_a_bool(make_context: MakeContext) -> None:
    wrong: Any = "no"
    with pytest.raises(TypeError, match="must be a bool, not str"):
        Robot(context=make_context(), enable_communication_interface=wrong)


def test_a_node_without_the_interface_has_no_services(make_context: MakeContext) -> None:
    robot = Robot(context=make_context(), enable_communication_interface=False)
    services = robot.get_service_names_and_types_by_node("robot", "/")
    assert not [name for name, types in services if "lifecycle_msgs" in types[0]]
    assert robot._state_machine.service_get_state is None
    assert robot.trigger_configure() is Outcome.SUCCESS


def test_another_node_can_trigger_every_transition(
    robot: Robot, make_context: MakeContext, spin: Spin
) -> None:
    spin(robot)
    context = make_context()

    def state() -> tuple[int, str]:
        current = call(context, GetState, "/robot/get_state").current_state
        return current.id, current.label

    assert state() == (1, "unconfigured")
    assert change(context, number=Transition.TRANSITION_CONFIGURE)
    assert state() == (2, "inactive")
    assert change(context, label="activate")
    assert state() == (3, "active")
    # The label has precedence over the number, as in ROS 2; a wrong label has no effect.
    assert not change(context, number=Transition.TRANSITION_DEACTIVATE, label="activate")
    assert not change(context, number=Transition.TRANSITION_CONFIGURE)
    assert not change(context, label="bogus")
    assert state() == (3, "active")
    assert change(context, label="shutdown")
    assert state() == (4, "finalized")


@pytest.mark.parametrize("planned", [Outcome.FAILURE, Outcome.ERROR, ValueError("broken")])
def test_another_node_is_informed_of_a_failed_callback(
    robot: Robot, make_context: MakeContext, spin: Spin, planned: object
) -> None:
    spinner = spin(robot)
    robot.plan = {"configure": planned}
    assert not change(make_context(), label="configure")
    assert robot.label == "unconfigured"
    assert spinner.error is None


def test_another_node_sees_states_and_transitions(
    robot: Robot, make_context: MakeContext, spin: Spin
) -> None:
    spin(robot)
    context = make_context()
    states = call(context, GetAvailableStates, "/robot/get_available_states").available_states
    assert [state.id for state in states] == [0, 1, 2, 3, 4, 10, 11, 12, 13, 14, 15]
    possible = call(
        context, GetAvailableTransitions, "/robot/get_available_transitions"
    ).available_transitions
    assert [
        (
            description.transition.id,
            description.transition.label,
            description.start_state.label,
            description.goal_state.label,
        )
        for description in possible
    ] == [
        (1, "configure", "unconfigured", "configuring"),
        (5, "shutdown", "unconfigured", "shuttingdown"),
    ]
    graph = call(context, GetAvailableTransitions, "/robot/get_transition_graph")
    assert len(graph.available_transitions) == 25


def test_every_transition_is_published(robot: Robot, make_context: MakeContext, spin: Spin) -> None:
    heard: list[tuple[str, str, str]] = []
    listener = zbot.Node("listener", context=make_context())
    listener.create_subscription(
        TransitionEvent,
        "/robot/transition_event",
        lambda event: heard.append(
            (event.transition.label, event.start_state.label, event.goal_state.label)
        ),
        10,
    )
    spin(listener)
    robot.plan = {"activate": Outcome.ERROR}
    robot.trigger_configure()
    robot.trigger_activate()
    assert wait_until(lambda: len(heard) == 5)
    assert heard == [
        ("configure", "unconfigured", "configuring"),
        ("transition_success", "configuring", "inactive"),
        ("activate", "inactive", "activating"),
        ("transition_error", "activating", "errorprocessing"),
        ("transition_success", "errorprocessing", "unconfigured"),
    ]


def test_one_of_several_callers_changes_the_state(make_context: MakeContext, spin: Spin) -> None:
    robot = Robot(context=make_context())
    spin(robot, executor=zbot.MultiThreadedExecutor(4, context=robot.context))
    contexts = [make_context() for _ in range(3)]
    done: list[bool] = []
    callers = [
        threading.Thread(
            target=lambda context=context: done.append(change(context, label="configure"))
        )
        for context in contexts
    ]
    for caller in callers:
        caller.start()
    for caller in callers:
        caller.join()
    assert sorted(done) == [False, False, True]
    assert robot.label == "inactive"
