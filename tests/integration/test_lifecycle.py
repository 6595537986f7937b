"""Tests of managed nodes, driven by their own methods and by other nodes."""

from __future__ import annotations

import threading
from typing import TYPE_CHECKING, Any, cast

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

import zbot
from tests.conftest import wait_until
from zbot import lifecycle
from zbot.lifecycle import (
    LifecycleNode,
    LifecycleNodeMixin,
    LifecycleState,
    ManagedEntity,
    NotAManagedEntityError,
    NotANodeError,
    SimpleManagedEntity,
    TransitionNotPossibleError,
)
from zbot.lifecycle import TransitionCallbackReturn as Outcome

from lifecycle_msgs.msg import Transition, TransitionEvent
from lifecycle_msgs.srv import ChangeState, GetAvailableStates, GetAvailableTransitions, GetState
from std_msgs.msg import String

if TYPE_CHECKING:
    from tests.conftest import MakeContext, Spin
    from zbot.log.record import Record

UNCONFIGURED = LifecycleState("unconfigured", 1)
INACTIVE = LifecycleState("inactive", 2)
ACTIVE = LifecycleState("active", 3)


class Robot(LifecycleNode):
    """Managed node whose callbacks run functions of the test, or else the default."""

    def __init__(self, **options: Any) -> None:
        super().__init__("robot", **options)
        self.plan: dict[str, Any] = {}
        self.calls: list[tuple[str, str]] = []

    def _do(self, name: str, state: LifecycleState) -> Outcome:
        self.calls.append((name, state.label))
        planned = self.plan.get(name, Outcome.SUCCESS)
        if isinstance(planned, Exception):
            raise planned
        return cast("Outcome", planned() if callable(planned) else planned)

    def on_configure(self, state: LifecycleState) -> Outcome:
        super().on_configure(state)
        return self._do("configure", state)

    def on_activate(self, state: LifecycleState) -> Outcome:
        super().on_activate(state)
        return self._do("activate", state)

    def on_deactivate(self, state: LifecycleState) -> Outcome:
        return self._do("deactivate", state)

    def on_cleanup(self, state: LifecycleState) -> Outcome:
        return self._do("cleanup", state)

    def on_shutdown(self, state: LifecycleState) -> Outcome:
        return self._do("shutdown", state)

    def on_error(self, state: LifecycleState) -> Outcome:
        return self._do("error", state)

    @property
    def label(self) -> str:
        return self._state_machine.current_state[1]


@pytest.fixture
def robot(make_context: MakeContext) -> Robot:
    return Robot(context=make_context())


@pytest.fixture
def lone_context(make_context: MakeContext) -> zbot.Context:
    return make_context()


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


# -- by its own methods ------------------------------------------------------------------------


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
    (record,) = [one for one in logged if one.name == "robot"]
    lines = record.message.splitlines()
    assert lines[0] == "on_configure() failed in the transition from unconfigured:"
    assert "test_lifecycle.py" in lines[2]
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


# -- managed entities --------------------------------------------------------------------------


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


class Motor(SimpleManagedEntity):
    def __init__(self) -> None:
        super().__init__()
        self.turns = 0
        self.refusals = 0

    @SimpleManagedEntity.when_enabled
    def turn(self, count: int) -> int:
        self.turns += count
        return self.turns


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
    warnings = [one.message for one in logged if one.name == "robot" and "dropped" in one.message]
    assert len(warnings) == 2
    assert warnings[0] == (
        "a message on /chatter was dropped: the node is not active (this is said once until it is)"
    )
    assert robot.destroy_lifecycle_publisher(publisher)
    assert not robot.destroy_lifecycle_publisher(publisher)


# -- by other nodes ----------------------------------------------------------------------------


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
        (one.transition.id, one.transition.label, one.start_state.label, one.goal_state.label)
        for one in possible
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
        threading.Thread(target=lambda one=one: done.append(change(one, label="configure")))
        for one in contexts
    ]
    for caller in callers:
        caller.start()
    for caller in callers:
        caller.join()
    assert sorted(done) == [False, False, True]
    assert robot.label == "inactive"


def test_rclpys_short_names_are_importable() -> None:
    assert lifecycle.Node is lifecycle.LifecycleNode
    assert lifecycle.NodeMixin is lifecycle.LifecycleNodeMixin
    assert lifecycle.State is lifecycle.LifecycleState
    assert lifecycle.Publisher is lifecycle.LifecyclePublisher
    assert tuple(ACTIVE) == ("active", 3)
    assert (INACTIVE.label, INACTIVE.state_id) == ("inactive", 2)
