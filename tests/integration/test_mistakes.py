"""Typical mistakes of beginners are refused at the call, in a sentence that says what to write."""

from __future__ import annotations

import re
from decimal import Decimal
from fractions import Fraction
from typing import TYPE_CHECKING, Any

import numpy as np
import pytest

import zbot
from zbot.action import ActionClient, ActionServer
from zbot.action.errors import ActionMessageError
from zbot.errors import NotInitializedError, ZbotError
from zbot.executor.callback_group import ReentrantCallbackGroup
from zbot.executor.multi_threaded_executor import MultiThreadedExecutor
from zbot.executor.single_threaded_executor import SingleThreadedExecutor
from zbot.executor.waitable import Waitable
from zbot.libraries.message_filter import SimpleFilter, Subscriber
from zbot.lifecycle import LifecycleNode
from zbot.node.event_callbacks import PublisherEventCallbacks, SubscriptionEventCallbacks
from zbot.qos import QoSPresetProfiles, QoSProfile, ReliabilityPolicy
from zbot.remote.wait_for_message import wait_for_message
from zbot.tf2 import Buffer, TransformBroadcaster, TransformListener

import std_msgs.msg
from example_interfaces.action import Fibonacci
from std_msgs.msg import String
from std_srvs.srv import SetBool

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator


class Robot(zbot.Node):
    def tick(self) -> None: ...
    def hear(self, message: Any) -> None: ...
    def serve(self, request: Any, response: Any) -> Any: ...


@pytest.fixture(scope="module")
def robot() -> Iterator[Any]:
    context = zbot.Context()
    context.init([], domain_id=44)
    yield Robot("robot", context=context)
    context.shutdown()


def action_server(node: Any, execute: Any = None, **options: Any) -> Any:
    return ActionServer[Any, Any, Any](node, Fibonacci, "fibonacci", execute, **options)


def raised(error: Exception) -> None:
    raise error


@pytest.mark.parametrize(
    ("call", "text"),
    [
        # what is not callable
        (lambda n: n.create_timer(0.5, n.tick()), "n.tick: write n.tick without parentheses"),
        (lambda n: n.create_timer(0.5, callback=n.tick()), "write n.tick without parentheses"),
        (lambda n: n.create_timer(0.5, "tick"), "write self.tick or tick without quotes"),
        (lambda n: n.create_subscription(String, "t", None, 10), "create_subscription was given N"),
        (lambda n: n.create_subscription(String, "t", n.hear(1), 10), "or lambda message: n.hear"),
        (lambda n: n.create_service(SetBool, "s", n.serve(1, 2)), "lambda request, response: n.s"),
        (lambda n: n.create_guard_condition(n.tick()), "write n.tick without parentheses"),
        (lambda n: n.add_on_set_parameters_callback(n.hear(1)), "write n.hear without parenthes"),
        (lambda n: n.add_pre_set_parameters_callback("x"), "add_pre_set_parameters_callback was"),
        (lambda n: n.add_post_set_parameters_callback(5), "add_post_set_parameters_callback was"),
        (lambda _: zbot.Future().add_done_callback(5), "add_done_callback was given 5"),  # type: ignore[arg-type]
        (action_server, "ActionServer's execute_callback was given None"),
        (lambda n: action_server(n, n.hear, goal_callback=5), "goal_callback was given 5"),
        (lambda n: action_server(n, n.hear, cancel_callback=""), "cancel_callback was given ''"),
        (lambda _: PublisherEventCallbacks(deadline=5), "deadline was given 5"),  # type: ignore[arg-type]
        (lambda _: SimpleFilter().registerCallback(None), "registerCallback was given None"),  # type: ignore[arg-type]
        (lambda n: SingleThreadedExecutor(context=n.context).create_task(n.tick()), "without par"),
        (
            lambda n: MultiThreadedExecutor([n]),  # type: ignore[arg-type]
            r"a number; add nodes with executor.add_node\(node\)",
        ),
        (
            lambda n: zbot.spin([n, n]),  # type: ignore[arg-type]
            r"for several nodes, write executor = SingleThreadedExecutor",
        ),
        (lambda n: zbot.spin(n, n), r"for several nodes, write executor = SingleThreadedExecutor"),
        (lambda n: n.set_parameters([("a", 1)]), r"write Parameter\('a', value=1\)$"),
        (lambda n: n.get_parameter("a"), r"write self.declare_parameter\('a', VALUE\)$"),
        # a wrong number of parameters
        (lambda n: n.create_timer(0.5, n.serve), r"write def serve\(self\):"),
        (lambda n: n.create_service(SetBool, "s", n.hear), r"def hear\(self, request, response\):"),
        (lambda n: n.create_guard_condition(n.hear), r"write def hear\(self\):"),
        (lambda n: n.add_on_set_parameters_callback(n.tick), r"write def tick\(self, parameters\)"),
        (lambda n: zbot.Future().add_done_callback(n.tick), r"write def tick\(self, future\):"),
        (
            lambda n: (
                n.create_client(SetBool, "s")
                .call_async(SetBool.Request())
                .add_done_callback(n.tick)
            ),
            r"write def tick\(self, future\):",
        ),
        (lambda n: action_server(n, n.tick), r"write def tick\(self, goal_handle\):"),
        (lambda n: SubscriptionEventCallbacks(matched=n.tick), r"write def tick\(self, info\):"),
        (lambda n: n.create_timer(0.5, Robot.tick), "write self.tick"),
        # arguments in the wrong order
        (lambda n: n.create_timer(n.tick, 0.5), r"write create_timer\(0.5, self.tick\)"),
        (lambda n: n.create_publisher("t", String, 10), r"create_publisher\(String, 't', 10\)"),
        (
            lambda n: n.create_subscription(String, "t", 10, n.hear),
            r"write create_subscription\(String, 't', self.hear, 10\)",
        ),
        (lambda n: n.create_service("s", n.serve, SetBool), r"\(SetBool, 's', self.serve\)"),
        (lambda n: n.create_client("s", SetBool), r"write create_client\(SetBool, 's'\)"),
        (
            lambda n: ActionServer[Any, Any, Any](n, "f", Fibonacci, n.hear),  # type: ignore[arg-type]
            r"write ActionServer\(self, Fibonacci, 'f', self.hear\)",
        ),
        (lambda n: ActionClient[Any, Any, Any](Fibonacci, n, "f"), r"\(self, Fibonacci, 'f'\)"),  # type: ignore[arg-type]
        (lambda n: Subscriber(String, n, "t"), r"write Subscriber\(self, String, 't'\)"),  # type: ignore[arg-type]
        (lambda n: wait_for_message(n, String, "t"), r"\(String, self, 't'\)"),  # type: ignore[arg-type]
        (lambda n: TransformListener(n, Buffer()), r"TransformListener\(buffer, self\)"),  # type: ignore[arg-type]
        # an argument of a wrong kind
        (lambda n: n.create_publisher("String", "t", 10), "write String without quotes"),
        (lambda n: n.create_publisher(std_msgs.msg, "t", 10), "is a module; write one of its clas"),
        (lambda n: n.create_publisher(String(), "t", 10), "pass its class, String"),
        (lambda n: n.create_publisher(SetBool, "t", 10), "it is a service, not a message"),
        (lambda n: n.create_client(String, "s"), "it is a message, not a service"),
        (lambda n: n.create_publisher(Fibonacci, "t", 10), "it is an action, not a message"),
        (lambda n: n.create_publisher(String, "t", None), "write the depth, e.g. 10"),
        (
            lambda n: n.create_publisher(String, "t", 10).publish("hi"),
            r"given str: 'hi': write publish\(String\(data='hi'\)\)$",
        ),
        (lambda n: n.create_publisher(String, "t", 10).publish(3), "was given int: 3$"),
        (
            lambda n: n.create_publisher(String, "t", 10).publish(String),
            r"given the class String: write String\(\), with parentheses$",
        ),
        (
            lambda n: n.create_client(SetBool, "s").call_async(SetBool.Request),
            r"write Request\(\), with parentheses$",
        ),
        (
            lambda n: n.create_client(SetBool, "s").call_async(True),
            r"not True; write SetBool.Request\(data=\.\.\.\)$",
        ),
        (
            lambda n: n.set_parameters({"speed": 2.0}),
            r"a Parameter, not \('speed', 2.0\); write Parameter\('speed', value=2.0\)$",
        ),
        (
            lambda n: n.create_timer(zbot.Parameter("rate", value=2.0), n.tick),
            "Parameter.*: write its .value$",
        ),
        (lambda n: n.create_publisher(SetBool.Request, "t", 10).publish([]), r"given list: \[\]$"),
        (
            lambda _: raised(ActionMessageError("/f", Fibonacci.Result, Fibonacci.Result)),
            r"not the class Fibonacci_Result; write Fibonacci.Result\(.*\), with parentheses$",
        ),
        (
            lambda n: n.create_publisher(String, "t", QoSPresetProfiles.SENSOR_DATA),
            "write QoSPresetProfiles.SENSOR_DATA.value$",
        ),
        (lambda n: n.create_publisher(String, "t", QoSProfile), "received the class QoSProfile"),
        (
            lambda n: n.create_timer(1, n.tick, ReentrantCallbackGroup),
            r"ReentrantCallbackGroup\(\)",
        ),
        (lambda n: n.create_timer(1, n.tick, 10), "callback_group must be a callback group, not"),
        (lambda n: n.create_timer(1, n.tick, clock=n.get_clock), r"a clock, e.g. self.get_clock\("),
        (
            lambda n: n.create_subscription(String, "t", n.hear, 1, event_callbacks=n.hear),
            "event_c",
        ),
        (
            lambda n: n.create_timer("0.5", n.tick),
            "must be a positive number of seconds, not '0.5'$",
        ),
        (lambda n: n.create_timer(zbot.Duration(seconds=2), n.tick), r"Duration\(.*\): write 2$"),
        (lambda n: n.create_rate(-1), "a rate's frequency must be a positive number of hertz, not"),
        (lambda n: setattr(n, "executor", 5), "not int: 5; nodes use this name themselves: choose"),
        # what is not a node
        (lambda _: zbot.spin(Robot), r"spin needs a node, .* write Robot\(\) with parentheses"),  # type: ignore[arg-type]
        (lambda _: zbot.spin(None), "spin needs a node, .* but was given None"),  # type: ignore[arg-type]
        (lambda _: zbot.spin_once("robot"), "but was given str: 'robot'"),  # type: ignore[arg-type]
        (lambda n: SingleThreadedExecutor(context=n.context).add_node(Robot), "add_node needs a n"),  # type: ignore[arg-type]
        (
            lambda n: zbot.spin_until_future_complete(zbot.Future(), n),  # type: ignore[arg-type]
            r"write spin_until_future_complete\(self, future\)$",
        ),
        (lambda n: zbot.spin_until_future_complete(n, None), "future must be a future, e.g. the"),  # type: ignore[arg-type]
        (lambda n: zbot.spin_until_future_complete(n, zbot.Future(), 0.1), "timeout_sec=0.1"),  # type: ignore[arg-type]
        (lambda n: zbot.spin_once(n, timeout_sec="1"), "timeout_sec must be a number of seconds"),  # type: ignore[arg-type]
        (lambda _: ActionClient[Any, Any, Any](Robot, Fibonacci, "f"), "ActionClient needs a node"),  # type: ignore[arg-type]
        (lambda _: TransformBroadcaster(Robot), r"a node, e.g. Robot\(\), not the class Robot"),  # type: ignore[arg-type]
    ],
)
def test_a_mistake_is_refused(robot: Any, call: Callable[[Any], Any], text: str) -> None:
    before = len(list(robot.timers)), len(list(robot.subscriptions)), len(list(robot.services))
    with pytest.raises(ZbotError, match=text) as caught:
        call(robot)
    assert not re.search(r"'_\w+'", str(caught.value))
    assert caught.value.__class__ is not ZbotError
    left = len(list(robot.timers)), len(list(robot.subscriptions)), len(list(robot.services))
    assert left == before


def test_a_missing_argument_is_said_of_the_class_that_users_know(robot: Any) -> None:
    with pytest.raises(TypeError, match=r"^Node.create_subscription\(\) missing .* 'qos_profile'$"):
        robot.create_subscription(String, "t", print)


def without_init(base: Any) -> Any:
    return type("Own", (base,), {"__init__": lambda _: None})()


@pytest.mark.parametrize(
    ("base", "use"),
    [
        (zbot.Node, lambda n: n.create_publisher(String, "t", 10)),
        (zbot.Node, lambda n: n.create_timer(0.5, print)),
        (zbot.Node, lambda n: n.get_logger()),
        (zbot.Node, lambda n: n.declare_parameter("rate", 1)),
        (zbot.Node, lambda n: n.get_name()),
        (zbot.Node, lambda n: list(n.timers)),
        (zbot.Node, lambda n: n.destroy_node()),
        (zbot.Node, zbot.spin),
        (LifecycleNode, lambda n: n.trigger_configure()),
        (LifecycleNode, lambda n: n.create_lifecycle_publisher(String, "t", 10)),
        (SingleThreadedExecutor, lambda executor: executor.spin()),
        (SingleThreadedExecutor, lambda executor: executor.spin_once(timeout_sec=0)),
        (SingleThreadedExecutor, lambda executor: executor.shutdown()),
        (ActionClient, lambda client: client.send_goal_async(Fibonacci.Goal())),
        (ActionServer, lambda server: server.destroy()),
        (ReentrantCallbackGroup, lambda group: group.add_entity(group)),
        (SimpleFilter, lambda filter_: filter_.registerCallback(print)),
        (Waitable, lambda waitable: waitable.callback_group),
    ],
)
def test_a_forgotten_super_init_is_named(base: Any, use: Callable[[Any], Any]) -> None:
    text = r"^Own has not called \w+.__init__ yet: begin Own.__init__ with super\(\).__init__\("
    with pytest.raises(AttributeError, match=text) as caught:
        use(without_init(base))
    # Python suggests a similar name only for an error with a name.
    assert not getattr(caught.value, "name", None)


def test_an_object_without_super_init_has_no_attributes() -> None:
    assert not hasattr(without_init(zbot.Node), "executor")


@pytest.mark.parametrize("period", [Fraction(1, 2), Decimal("0.5"), np.float32(0.5)])
def test_any_number_can_be_a_period(robot: Any, period: Any) -> None:
    timer = robot.create_timer(period, robot.tick)
    assert timer.timer_period_ns == 500_000_000
    robot.destroy_timer(timer)


@pytest.mark.parametrize(
    "use",
    [
        lambda n: n.create_timer(0.5, n.tick),
        lambda n: n.create_guard_condition(n.tick),
        lambda n: n.create_rate(1.0),
        lambda n: n.create_publisher(String, "t", 10),
        zbot.spin,
        lambda n: zbot.spin_once(n, timeout_sec=0),
        lambda n: zbot.spin_until_future_complete(n, zbot.Future(), timeout_sec=0),
    ],
)
def test_a_node_cannot_be_used_after_shutdown(use: Callable[[Any], Any]) -> None:
    context = zbot.Context()
    context.init([], domain_id=44)
    late = Robot("late", context=context)
    context.shutdown()
    with pytest.raises(NotInitializedError, match=r"\(and no shutdown\(\) after it\)"):
        use(late)


def test_a_warning_of_a_wrong_policy_shows_the_line_of_the_program(robot: Any) -> None:
    with pytest.warns(UserWarning, match="counts as the depth 2") as caught:
        robot.create_publisher(String, "t", ReliabilityPolicy.BEST_EFFORT)
    assert caught[0].filename == __file__
