"""Tests that use each member of nodes and their parameters."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import rclpy
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.lifecycle import LifecycleNode, State
from rclpy.node import Node
from rclpy.parameter import Parameter
from rclpy.task import Future
from rclpy.waitable import NumberOfEntities, Waitable

from tests.conftest import wait_until
from tests.unit.compat.rclpy_calls.conftest import InUse, ignore, made

from example_interfaces.srv import AddTwoInts
from rcl_interfaces.msg import ParameterDescriptor, SetParametersResult
from std_msgs.msg import String

if TYPE_CHECKING:
    from pathlib import Path

    from rclpy.context import Context

    from tests.conftest import Spin


def accept(*_: object) -> SetParametersResult:
    return SetParametersResult(successful=True)


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
        for managed in (entity, node):
            assert getattr(managed, f"on_{step}")(state).name == "SUCCESS"
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
    assert caller.wait_for_node("/calls/caller", 60)
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
    handle = events.add_parameter_callback("speed", "/other", changes.append)
    every = events.add_parameter_event_callback(changes.append)
    spin(node, other)
    assert client.wait_for_services(60)
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
    events.remove_parameter_callback(handle)
    events.remove_parameter_event_callback(every)
    events.destroy()
