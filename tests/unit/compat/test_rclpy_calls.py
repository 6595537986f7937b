"""Tests that use each member of rclpy's classes that docs/rclpy.md calls present."""

from __future__ import annotations

import enum
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest
import rclpy
from rclpy.action import CancelResponse, GoalResponse
from rclpy.callback_groups import (
    CallbackGroup,
    MutuallyExclusiveCallbackGroup,
    ReentrantCallbackGroup,
)
from rclpy.clock import JumpThreshold, ROSClock
from rclpy.context import Context
from rclpy.duration import Duration
from rclpy.executors import MultiThreadedExecutor, SingleThreadedExecutor
from rclpy.lifecycle import LifecycleNode, State
from rclpy.node import Node
from rclpy.parameter import Parameter
from rclpy.qos import QoSProfile
from rclpy.service_introspection import ServiceIntrospectionState
from rclpy.subscription_content_filter_options import ContentFilterOptions
from rclpy.task import Future, Task
from rclpy.time import Time
from rclpy.waitable import NumberOfEntities, Waitable

from tests.conftest import wait_until
from tests.unit.compat.rclpy_table import ANNOTATIONS, NAMES, absent_members, find

from example_interfaces.action import Fibonacci
from example_interfaces.srv import AddTwoInts
from rcl_interfaces.msg import ParameterDescriptor, SetParametersResult
from rosgraph_msgs.msg import Clock as ClockMessage
from std_msgs.msg import String

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    from tests.conftest import Spinner

    Spin = Callable[..., Spinner]

#: Classes whose attributes are only read, without a test of their own.
VALUES: dict[str, Callable[[], Any]] = {
    "rclpy.clock.TimeJump": lambda: rclpy.clock.TimeJump(
        rclpy.clock.ClockChange.ROS_TIME_ACTIVATED, Duration()
    ),
    "rclpy.executors.TimeoutObject": lambda: rclpy.executors.TimeoutObject(1.0),
    "rclpy.impl.rcutils_logger.LoggingFilter": lambda: rclpy.impl.rcutils_logger.LoggingFilter,
    "rclpy.impl.rcutils_logger.Once": lambda: rclpy.impl.rcutils_logger.Once,
    "rclpy.impl.rcutils_logger.SkipFirst": lambda: rclpy.impl.rcutils_logger.SkipFirst,
    "rclpy.impl.rcutils_logger.Throttle": lambda: rclpy.impl.rcutils_logger.Throttle,
    "rclpy.lifecycle.node.LifecycleState": lambda: State("active", 3),
    "rclpy.qos.QoSPolicyEnum": lambda: rclpy.qos.ReliabilityPolicy.RELIABLE,
    "rclpy.qos_overriding_options.QoSOverridingOptions": lambda: (
        rclpy.qos_overriding_options.QoSOverridingOptions([])
    ),
    "rclpy.subscription_content_filter_options.ContentFilterOptions": lambda: ContentFilterOptions(
        "data = 'a'", []
    ),
    "rclpy.topic_endpoint_info.TopicEndpointInfo": rclpy.topic_endpoint_info.TopicEndpointInfo,
    "rclpy.type_hash.TypeHash": rclpy.type_hash.TypeHash,
    "rclpy.waitable.NumberOfEntities": NumberOfEntities,
}


#: The members of each class that the running test has used.
USED: dict[str, set[str]] = {}


class InUse:
    """Proxy that records the used members of an object."""

    def __init__(self, path: str, entity: Any) -> None:
        self.entity = entity
        self._used = USED.setdefault(path, set())

    def __getattr__(self, member: str) -> Any:
        value = getattr(self.entity, member)
        self._used.add(member)
        return value


def made(path: str, *arguments: Any, **options: Any) -> InUse:
    """Return a new object of a class of rclpy, in its proxy."""
    module, _, name = path.rpartition(".")
    return InUse(path, find(module, name)(*arguments, **options))


def present(path: str) -> set[str]:
    """Return the members of a class that the page calls present."""
    module, _, name = path.rpartition(".")
    known = NAMES[module][name] or []
    return set(known) - set(absent_members(find(module, name), known))


@pytest.fixture(autouse=True)
def no_member_is_left_unused() -> Iterator[None]:
    USED.clear()
    yield
    assert {path: present(path) - used for path, used in USED.items() if present(path) - used} == {}


@pytest.fixture
def context(make_context: Callable[[], Context]) -> Context:
    return make_context()


@pytest.fixture
def node(context: Context) -> Node:
    return Node("caller", namespace="/calls", context=context)


def ignore(*_: object) -> None:
    return None


def accept(*_: object) -> SetParametersResult:
    return SetParametersResult(successful=True)


def test_publishers_and_subscriptions(node: Node) -> None:
    subscription = InUse(
        "rclpy.subscription.Subscription", node.create_subscription(String, "words", ignore, 10)
    )
    publisher = InUse("rclpy.publisher.Publisher", node.create_publisher(String, "words", 10))
    publisher.publish(String(data="a"))
    publisher.assert_liveliness()
    assert isinstance(publisher.wait_for_all_acked(Duration(seconds=1)), bool)
    assert wait_until(lambda: publisher.get_subscription_count() == 1)
    assert wait_until(lambda: subscription.get_publisher_count() == 1)
    assert publisher.topic_name == subscription.topic_name == "/calls/words"
    assert publisher.logger_name == subscription.logger_name == "calls.caller"
    assert callable(subscription.callback)
    assert not subscription.is_cft_enabled
    subscription.set_content_filter("data = 'b'", [])
    assert subscription.get_content_filter().filter_expression == "data = 'b'"
    assert list(subscription.CallbackType)
    with publisher.handle, subscription.handle:
        pass
    publisher.destroy()
    subscription.destroy()


def test_services_and_clients(node: Node, spin: Spin) -> None:
    def add(request: Any, response: Any) -> Any:
        response.sum = request.a + request.b
        return response

    service = InUse("rclpy.service.Service", node.create_service(AddTwoInts, "add", add))
    client = InUse("rclpy.client.Client", node.create_client(AddTwoInts, "add"))
    spin(node)
    assert client.wait_for_service(5)
    assert client.service_is_ready()
    assert client.call(AddTwoInts.Request(a=1, b=2), timeout_sec=5).sum == 3
    future = client.call_async(AddTwoInts.Request())
    assert wait_until(future.done)
    client.remove_pending_request(future)
    with pytest.raises(KeyError):
        client.get_pending_request(99)
    for end in (service, client):
        off = ServiceIntrospectionState.OFF
        end.configure_introspection(node.get_clock(), QoSProfile(depth=1), off)
    assert client.service_name == service.service_name == "/calls/add"
    assert client.logger_name == service.logger_name == "calls.caller"
    with client.handle, service.handle:
        pass
    assert callable(service.send_response)  # its header comes from a pending request
    client.destroy()
    service.destroy()


def test_actions(node: Node, spin: Spin) -> None:
    held: list[InUse] = []

    def execute(goal: Any) -> Any:
        handle = InUse("rclpy.action.server.ServerGoalHandle", goal)
        held.append(handle)
        handle.publish_feedback(Fibonacci.Feedback(sequence=[0]))
        assert (handle.is_active, handle.is_cancel_requested) == (True, False)
        assert handle.request.order == len(held)
        assert (handle.status, len(handle.goal_id.uuid)) == (2, 16)
        (handle.succeed, handle.abort)[len(held) - 1]()
        return Fibonacci.Result()

    server = made("rclpy.action.server.ActionServer", node, Fibonacci, "count", execute)
    client = made("rclpy.action.client.ActionClient", node, Fibonacci, "count")
    server.register_execute_callback(execute)
    server.register_goal_callback(lambda _: GoalResponse.ACCEPT)
    server.register_cancel_callback(lambda _: CancelResponse.ACCEPT)
    server.register_handle_accepted_callback(lambda goal: goal.execute())
    spin(node, executor=MultiThreadedExecutor(context=node.context))
    assert client.wait_for_server(5)
    assert client.server_is_ready()
    assert client.send_goal(Fibonacci.Goal(order=1)).status == 4
    sent = client.send_goal_async(Fibonacci.Goal(order=2))
    assert wait_until(sent.done)
    handle = InUse("rclpy.action.client.ClientGoalHandle", sent.result())
    assert handle.accepted
    assert handle.get_result().status == 6
    answer = handle.get_result_async()
    assert wait_until(answer.done)
    assert handle.cancel_goal().goals_canceling == []
    assert wait_until(handle.cancel_goal_async().done)
    assert (len(handle.goal_id.uuid), handle.status) == (16, 6)
    assert handle.stamp.sec > 0
    for end in (client, server):
        off = ServiceIntrospectionState.OFF
        end.configure_introspection(node.get_clock(), QoSProfile(depth=1), off)
        end.get_num_entities()
    assert server.action_type is Fibonacci
    assert callable(server.notify_execute)  # `execute()` of a goal's handle calls it
    held[1].execute, held[1].canceled
    held[1].destroy()
    client.destroy()
    server.destroy()


@pytest.mark.parametrize(
    ("path", "kind"),
    [
        ("rclpy.callback_groups.CallbackGroup", MutuallyExclusiveCallbackGroup),
        ("rclpy.callback_groups.MutuallyExclusiveCallbackGroup", MutuallyExclusiveCallbackGroup),
        ("rclpy.callback_groups.ReentrantCallbackGroup", ReentrantCallbackGroup),
    ],
)
def test_callback_groups(path: str, kind: type[CallbackGroup], node: Node) -> None:
    group = InUse(path, kind())
    timer = node.create_timer(100.0, ignore)
    group.add_entity(timer)
    assert group.has_entity(timer)
    group.can_execute(timer)
    group.beginning_execution(timer)
    group.ending_execution(timer)


def test_clocks(node: Node) -> None:
    clock = InUse("rclpy.clock.Clock", node.get_clock())
    now = clock.now()
    assert clock.sleep_for(Duration(nanoseconds=1), node.context)
    assert clock.sleep_until(now, node.context)
    threshold = JumpThreshold(min_forward=None, min_backward=None, on_clock_change=True)
    jumps: list[object] = []
    made = clock.create_jump_callback(threshold, post_callback=jumps.append)
    handle = InUse("rclpy.clock.JumpHandle", made)
    simulated = InUse("rclpy.clock.ROSClock", ROSClock())
    assert not simulated.ros_time_is_active
    simulated.set_ros_time_override(Time(seconds=5, clock_type=simulated.entity.clock_type))
    handle.unregister()
    assert clock.clock_type.name == "ROS_TIME"
    with clock.handle:
        pass


def test_times_and_durations() -> None:
    time = InUse("rclpy.time.Time", Time(seconds=1, nanoseconds=5))
    assert time.seconds_nanoseconds() == (1, 5)
    assert (time.nanoseconds, time.to_msg().nanosec) == (1_000_000_005, 5)
    assert time.clock_type.name == "SYSTEM_TIME"
    duration = InUse("rclpy.duration.Duration", Duration(seconds=1))
    assert (duration.nanoseconds, duration.to_msg().sec) == (10**9, 1)
    steady = rclpy.clock.ClockType.STEADY_TIME
    times = {"expected_call_time": 5, "actual_call_time": 7}
    info = made("rclpy.timer.TimerInfo", **times, clock_type=steady)
    for name, nanoseconds in times.items():
        assert getattr(info, name) == Time(nanoseconds=nanoseconds, clock_type=steady)


def test_contexts(domain: int) -> None:
    context = InUse("rclpy.context.Context", Context())
    ended: list[int] = []
    context.init([])
    context.on_shutdown(lambda: ended.append(1))
    assert (context.ok(), context.get_domain_id()) == (True, domain)
    with context.handle:
        pass
    context.shutdown()
    context.try_shutdown()
    context.destroy()
    assert ended == [1]


@pytest.mark.parametrize(
    ("path", "kind"),
    [
        ("rclpy.executors.Executor", SingleThreadedExecutor),
        ("rclpy.executors.SingleThreadedExecutor", SingleThreadedExecutor),
        ("rclpy.executors.MultiThreadedExecutor", MultiThreadedExecutor),
    ],
)
def test_executors(path: str, kind: type[SingleThreadedExecutor], node: Node) -> None:
    executor = InUse(path, kind(context=node.context))
    ran: list[int] = []
    node.create_timer(0.001, lambda: ran.append(1))
    assert executor.add_node(node)
    assert executor.get_nodes() == [node]
    assert executor.can_execute(next(iter(node.timers)))
    executor.spin_once(timeout_sec=5)
    done: Future[int] = executor.create_future()
    done.set_result(1)
    executor.spin_once_until_future_complete(done, timeout_sec=5)
    task = executor.create_task(lambda: 7)
    executor.spin_until_future_complete(task, timeout_sec=5)
    assert task.result() == 7
    assert len(executor.wait_for_ready_callbacks(timeout_sec=5)) == 3
    executor.wake()
    executor.create_task(executor.shutdown)
    executor.spin()
    assert executor.context is node.context
    executor.remove_node(node)
    assert ran


def test_guard_conditions(node: Node) -> None:
    guard = InUse("rclpy.guard_condition.GuardCondition", node.create_guard_condition(ignore))
    guard.trigger()
    with guard.handle:
        pass
    guard.destroy()
    made("rclpy.signals.SignalHandlerGuardCondition", node.context).destroy()


def test_loggers(node: Node) -> None:
    logger = InUse("rclpy.impl.rcutils_logger.RcutilsLogger", node.get_logger().get_child("calls"))
    logger.set_level(rclpy.logging.LoggingSeverity.FATAL)
    for write in (logger.debug, logger.info, logger.warn, logger.warning, logger.error):
        assert not write("below the level")
    assert logger.fatal("at the level")
    assert logger.log("at the level", rclpy.logging.LoggingSeverity.FATAL)
    assert logger.is_enabled_for(rclpy.logging.LoggingSeverity.FATAL)
    assert logger.get_effective_level() == rclpy.logging.LoggingSeverity.FATAL
    assert logger.get_child("more").name.endswith(".calls.more")


def test_managed_nodes(context: Context) -> None:
    node = InUse(
        "rclpy.lifecycle.node.LifecycleNodeMixin", LifecycleNode("managed", context=context)
    )
    publisher = InUse(
        "rclpy.lifecycle.publisher.LifecyclePublisher",
        node.create_lifecycle_publisher(String, "words", 10),
    )
    state = State("unconfigured", 1)
    simple = made("rclpy.lifecycle.managed_entity.SimpleManagedEntity")
    entity = made("rclpy.lifecycle.managed_entity.ManagedEntity")
    simple.on_activate(state)
    assert simple.is_activated
    simple.on_deactivate(state)
    node.add_managed_entity(simple.entity)
    for step in ("configure", "activate", "deactivate", "cleanup", "shutdown"):
        for one in (entity, node):
            assert getattr(one, f"on_{step}")(state).name == "SUCCESS"
    entity.on_error(state)
    node.on_error(state)
    node.trigger_configure()
    node.trigger_activate()
    publisher.publish(String())
    for step in ("deactivate", "cleanup", "shutdown"):
        getattr(node, f"trigger_{step}")()
    node.destroy_lifecycle_publisher(publisher.entity)


def use_entities(caller: InUse) -> None:
    publisher = caller.create_publisher(String, "words", 1)
    subscription = caller.create_subscription(String, "words", ignore, 1)
    client = caller.create_client(AddTwoInts, "add")
    service = caller.create_service(AddTwoInts, "add", ignore)
    timer, rate = caller.create_timer(100.0, ignore), caller.create_rate(1.0)
    guard, waitable = caller.create_guard_condition(ignore), OwnWork(ReentrantCallbackGroup())
    caller.add_waitable(waitable)
    assert publisher in caller.publishers
    assert subscription in caller.subscriptions
    assert client in caller.clients
    assert service in caller.services
    assert timer in caller.timers
    assert guard in caller.guards
    assert len(list(caller.waitables)) == 1
    assert wait_until(lambda: caller.count_publishers("words") == 1)
    assert wait_until(lambda: caller.count_subscribers("words") == 1)
    assert wait_until(lambda: caller.count_services("add") == 1)
    assert wait_until(lambda: caller.count_clients("add") == 1)
    assert len(caller.get_publishers_info_by_topic("words")) == 1
    assert len(caller.get_subscriptions_info_by_topic("words")) == 1
    for kind in ("publisher", "subscriber", "service", "client"):
        assert getattr(caller, f"get_{kind}_names_and_types_by_node")("caller", "/calls")
    assert ("/calls/words", ["std_msgs/msg/String"]) in caller.get_topic_names_and_types()
    assert ("/calls/add", ["example_interfaces/srv/AddTwoInts"]) in (
        caller.get_service_names_and_types()
    )
    caller.remove_waitable(waitable)
    assert caller.destroy_publisher(publisher)
    assert caller.destroy_subscription(subscription)
    assert caller.destroy_client(client)
    assert caller.destroy_service(service)
    assert caller.destroy_timer(timer)
    assert caller.destroy_rate(rate)
    assert caller.destroy_guard_condition(guard)


def test_nodes(node: Node) -> None:
    caller = InUse("rclpy.node.Node", node)
    assert caller.get_fully_qualified_name() == "/calls/caller"
    assert (caller.get_name(), caller.get_namespace()) == ("caller", "/calls")
    assert wait_until(lambda: "caller" in caller.get_node_names())
    assert "/calls/caller" in caller.get_fully_qualified_node_names()
    assert ("caller", "/calls") in caller.get_node_names_and_namespaces()
    assert ("caller", "/calls", "/") in caller.get_node_names_and_namespaces_with_enclaves()
    assert caller.wait_for_node("/calls/caller", 5)
    assert caller.resolve_topic_name("words") == caller.resolve_service_name("words")
    assert caller.executor is None
    assert caller.default_callback_group.has_entity
    assert caller.context.ok()
    assert (caller.get_clock().clock_type.name, caller.get_logger().name) == (
        "ROS_TIME",
        "calls.caller",
    )
    with caller.handle:
        pass
    caller.declare_parameter("speed", 1.0)
    caller.declare_parameters("", [("size", 2), ("limits.low", 3)])
    for when in ("pre", "on", "post"):
        callback = {"pre": lambda given: given, "on": accept, "post": ignore}[when]
        getattr(caller, f"add_{when}_set_parameters_callback")(callback)
        getattr(caller, f"remove_{when}_set_parameters_callback")(callback)
    assert caller.set_parameters([Parameter("speed", value=2.0)])[0].successful
    assert caller.set_parameters_atomically([Parameter("size", value=3)]).successful
    assert caller.get_parameter("speed").value == 2.0
    assert caller.get_parameter_or("none", Parameter("none", value=9)).value == 9
    assert caller.get_parameter_type("size") == caller.get_parameter_types(["size"])[0]
    assert caller.get_parameters(["size"])[0].value == 3
    assert caller.get_parameters_by_prefix("limits")["low"].value == 3
    assert caller.has_parameter("size")
    assert "size" in caller.list_parameters([], 0).names
    caller.set_descriptor("size", ParameterDescriptor(description="how many"))
    assert caller.describe_parameter("size").description == "how many"
    assert caller.describe_parameters(["size"])[0].name == "size"
    assert caller.PARAM_REL_TOL > 0
    caller.undeclare_parameter("size")
    use_entities(caller)
    caller.destroy_node()


class OwnWork(Waitable[Any]):
    """Waitable that is never ready."""

    def is_ready(self, wait_set: Any) -> bool:  # noqa: ARG002 - rclpy's signature
        return False

    def take_data(self) -> Any:
        return None

    async def execute(self, taken_data: Any) -> None:  # noqa: ARG002 - rclpy's signature
        return None

    def get_num_entities(self) -> NumberOfEntities:
        return NumberOfEntities()

    def add_to_wait_set(self, wait_set: Any) -> None:
        """Add nothing."""


def test_waitables() -> None:
    work = InUse("rclpy.waitable.Waitable", OwnWork(ReentrantCallbackGroup()))
    future: Future[Any] = Future()
    work.add_future(future)
    work.remove_future(future)
    work.add_to_wait_set(None)
    assert not work.is_ready(None)
    assert work.take_data() is None
    work.execute(None).close()
    assert work.get_num_entities().num_timers == 0


def test_parameters() -> None:
    parameter = InUse("rclpy.parameter.Parameter", Parameter("speed", value=1.5))
    assert (parameter.name, parameter.value) == ("speed", 1.5)
    assert parameter.type_ is parameter.Type.DOUBLE
    assert parameter.get_parameter_value().double_value == 1.5
    assert parameter.to_parameter_msg().name == "speed"


def test_parameters_of_other_nodes(node: Node, spin: Spin, tmp_path: Path) -> None:
    other = Node("other", context=node.context)
    other.declare_parameter("speed", 1.0)
    other.declare_parameter("any", 1, ParameterDescriptor(dynamic_typing=True))
    (tmp_path / "new.yaml").write_text("other: {ros__parameters: {speed: 3.0}}", encoding="utf-8")
    client = made("rclpy.parameter_client.AsyncParameterClient", node, "/other")
    changes: list[object] = []
    client.on_parameter_event(changes.append)
    events = made("rclpy.parameter_event_handler.ParameterEventHandler", node)
    one = events.add_parameter_callback("speed", "/other", changes.append)
    every = events.add_parameter_event_callback(changes.append)
    spin(node, other)
    assert client.wait_for_services(5)
    assert client.services_are_ready()
    path = str(tmp_path / "new.yaml")
    for future in (
        client.get_parameters(["speed"]),
        client.get_parameter_types(["speed"]),
        client.describe_parameters(["speed"]),
        client.list_parameters(),
        client.set_parameters([Parameter("speed", value=2.0)]),
        client.set_parameters_atomically([Parameter("speed", value=4.0)]),
        client.load_parameter_file(path),
        client.load_parameter_file_atomically(path),
        client.delete_parameters(["any"]),
    ):
        assert wait_until(future.done)
        assert future.exception() is None
    assert wait_until(lambda: len(changes) >= 3)
    events.remove_parameter_callback(one)
    events.remove_parameter_event_callback(every)
    events.destroy()


def test_quality_of_service() -> None:
    profile = InUse("rclpy.qos.QoSProfile", QoSProfile(depth=3))
    assert profile.depth == 3
    assert profile.get_c_qos_profile() is not None
    for policy in ("history", "reliability", "durability", "liveliness"):
        assert isinstance(getattr(profile, policy), enum.Enum)
    for span in ("deadline", "lifespan", "liveliness_lease_duration"):
        assert isinstance(getattr(profile, span), Duration)
    assert not profile.avoid_ros_namespace_conventions


def test_events_of_quality_of_service(node: Node) -> None:
    publisher = node.create_publisher(
        String, "words", 1, event_callbacks=rclpy.event_handler.PublisherEventCallbacks()
    )
    handler = InUse("rclpy.event_handler.EventHandler", publisher.event_handlers[0])
    handler.destroy()
    assert callable(handler.execute)


def test_futures_and_tasks() -> None:
    future = InUse("rclpy.task.Future", Future())
    seen: list[object] = []
    future.add_done_callback(seen.append)
    future.add_done_callback(ignore)
    future.remove_done_callback(ignore)
    assert not future.done()
    future.set_result(5)
    assert (future.result(), future.exception(), future.cancelled()) == (5, None, False)
    failed: Future[int] = Future()
    InUse("rclpy.task.Future", failed).set_exception(ValueError())
    future.cancel()
    assert seen
    task = InUse("rclpy.task.Task", Task(lambda: 1))
    assert not task.executing()
    task.cancel()


def test_timers_and_rates(node: Node, spin: Spin) -> None:
    timer = InUse("rclpy.timer.Timer", node.create_timer(100.0, ignore))
    assert not timer.is_ready()
    assert timer.time_until_next_call() > 0
    assert timer.time_since_last_call() >= 0
    assert timer.timer_period_ns == 100 * 10**9
    assert timer.clock.clock_type.name
    timer.cancel()
    assert timer.is_canceled()
    timer.reset()
    with timer.handle:
        pass
    timer.destroy()
    spin(node)
    rate = InUse("rclpy.timer.Rate", node.create_rate(1000.0))
    rate.sleep()
    rate.destroy()


def test_time_sources(node: Node) -> None:
    source = made("rclpy.time_source.TimeSource")
    source.attach_node(node)
    source.attach_clock(ROSClock())
    source.clock_callback(ClockMessage())
    assert not source.ros_time_is_active
    source.detach_node()
    made("rclpy.type_description_service.TypeDescriptionService", node).destroy()


@pytest.mark.parametrize("path", VALUES)
def test_values(path: str) -> None:
    value = VALUES[path]()
    for member in present(path):
        getattr(value, member)


def test_no_class_with_members_is_left_out() -> None:
    source = Path(__file__).read_text(encoding="utf-8")
    classes = {
        f"{module}.{name}"
        for module, names in NAMES.items()
        for name in names
        if isinstance(find(module, name), type)
        and not isinstance(find(module, name), enum.EnumMeta)  # the page itself says their values
        and present(f"{module}.{name}")
    }
    assert {path for path in classes - ANNOTATIONS if f'"{path}"' not in source} == set()
