from __future__ import annotations

import threading
from typing import TYPE_CHECKING, Any

import pytest

import zbot
from tests.conftest import wait_until
from zbot.errors import ArgumentTypeError, UnknownQoSKeyError
from zbot.node.parameter_client import AsyncParameterClient
from zbot.node.parameter_event_handler import ParameterEventHandler
from zbot.node.parameter_services import SERVICES
from zbot.parameters.errors import (
    InvalidParameterTypeException,
    InvalidQosOverridesError,
    ParameterListError,
    ParameterNotDeclaredException,
    UnknownCallbackError,
)
from zbot.parameters.parameter import Parameter
from zbot.parameters.qos_overrides import QoSOverridingOptions
from zbot.qos import QoSPolicyKind, QoSProfile, ReliabilityPolicy

from rcl_interfaces.msg import (
    IntegerRange,
    ParameterDescriptor,
    ParameterEvent,
    ParameterValue,
    SetParametersResult,
)
from rcl_interfaces.msg import Parameter as ParameterMsg
from rcl_interfaces.srv import SetParameters
from rosgraph_msgs.msg import Clock
from std_msgs.msg import String

if TYPE_CHECKING:
    from pathlib import Path

    from tests.conftest import MakeContext, Spin

Type = Parameter.Type
SPEED: Any = [Parameter("speed", value=1)]  # rclpy accepts these in place of messages


@pytest.fixture
def node(make_context: MakeContext) -> zbot.Node:
    return zbot.Node("robot", context=make_context(), namespace="lab")


@pytest.fixture
def client(node: zbot.Node, make_context: MakeContext, spin: Spin) -> AsyncParameterClient:
    """Return a client in another context, and spin both."""
    asking = zbot.Node("asking", context=make_context())
    client = AsyncParameterClient(asking, "/lab/robot")
    spin(node)
    spin(asking)
    assert client.wait_for_services(5)
    return client


def answer(future: zbot.Future[Any]) -> Any:
    over = threading.Event()
    future.add_waker(over.set)
    assert over.wait(5)
    return future.result()


# -- on the node -------------------------------------------------------------------------------


def test_every_node_has_its_own_parameters_and_services(node: zbot.Node) -> None:
    assert node.get_parameter("use_sim_time").value is False
    assert node.describe_parameter("start_type_description_service").read_only
    served = dict(node.get_service_names_and_types_by_node("robot", "/lab"))
    assert {f"/lab/robot/{name}": [type_] for name, (type_, _) in SERVICES.items()}.items() <= (
        served.items()
    )


def test_the_services_carry_the_hashes_of_their_types() -> None:
    from zbot.interfaces import get_service, type_hash  # noqa: PLC0415 - only here

    for type_name, hash_text in SERVICES.values():
        assert type_hash(get_service(type_name)) == hash_text


def test_the_services_can_be_left_out(make_context: MakeContext) -> None:
    node = zbot.Node("quiet", context=make_context(), start_parameter_services=False)
    assert [one.service_name for one in node.services] == ["/quiet/get_type_description"]
    assert node.has_parameter("use_sim_time")


def test_parameters_are_declared_read_and_set_as_in_rclpy(node: zbot.Node) -> None:
    node.declare_parameters(
        "drive",
        [
            ("speed", 1.0, ParameterDescriptor(description="m/s")),
            ("gear", Type.INTEGER),
            ("name", "ada"),
        ],
    )
    assert node.describe_parameter("drive.speed").description == "m/s"
    assert node.describe_parameter("drive.speed").name == "drive.speed"
    assert {name: one.value for name, one in node.get_parameters_by_prefix("drive").items()} == {
        "speed": 1.0,
        "gear": None,
        "name": "ada",
    }
    results = node.set_parameters(
        [Parameter("drive.speed", value=2), Parameter("drive.gear", value="first")]
    )
    assert [one.successful for one in results] == [True, False]
    assert node.get_parameters(["drive.speed", "drive.name"])[0].value == 2.0
    assert node.get_parameter_types(["drive.speed", "drive.gear"]) == [Type.DOUBLE, Type.NOT_SET]
    assert node.get_parameter_or("drive.gear", Parameter("other", value=3)).value == 3
    assert node.get_parameter_or("drive.gear").type_ is Type.NOT_SET
    assert node.get_parameter_or("drive.name").value == "ada"
    listed = node.list_parameters(["drive"], 1)
    assert (list(listed.names), list(listed.prefixes)) == (
        ["drive.speed", "drive.gear", "drive.name"],
        ["drive"],
    )
    node.undeclare_parameter("drive.name")
    assert not node.has_parameter("drive.name")


def test_declaring_by_name_alone_warns_as_rclpy_does(node: zbot.Node) -> None:
    with pytest.warns(UserWarning, match="declaring a parameter only providing its name"):
        assert node.declare_parameter("anything").value is None
    assert node.set_parameters([Parameter("anything", value=1)])[0].successful
    assert node.set_parameters([Parameter("anything", value="x")])[0].successful


@pytest.mark.filterwarnings("ignore:when declaring parameter named")
def test_a_list_of_declarations_may_leave_values_to_a_file(make_context: MakeContext) -> None:
    arguments = ["--ros-args", "-p", "arm.speed:=2.5"]
    node = zbot.Node("drive", context=make_context(), cli_args=arguments)
    node.declare_parameters("arm", [("speed", None), ("limits", None)])
    assert node.get_parameter("arm.speed").value == 2.5
    assert node.get_parameter("arm.limits").type_ is Type.NOT_SET


def test_a_descriptor_is_not_shared_by_two_declarations(node: zbot.Node) -> None:
    shared = ParameterDescriptor(description="shared")
    node.declare_parameter("a", 1, shared)
    node.declare_parameter("b", "text", shared)
    assert node.describe_parameters(["a", "b"])[0].type == Type.INTEGER
    assert shared.name == ""


def test_a_declared_value_may_be_a_message(node: zbot.Node) -> None:
    value = ParameterValue(type=3, double_value=2.5)
    assert node.declare_parameter("a", value).value == 2.5
    descriptor = ParameterDescriptor(integer_range=[IntegerRange(from_value=0, to_value=9, step=1)])
    node.declare_parameter("b", 5, descriptor)
    replaced = node.set_descriptor("b", ParameterDescriptor(description="free"))
    assert replaced.integer_value == 5
    assert node.describe_parameter("b").integer_range == []


@pytest.mark.parametrize(
    "parameters", [[("a", 1, None, 2)], [()], ["a"], [(1, 1)], [("a", 1, "no descriptor")]]
)
def test_a_malformed_declaration_is_refused(node: zbot.Node, parameters: Any) -> None:
    with pytest.raises(ParameterListError, match="element 0 of the list must be a tuple"):
        node.declare_parameters("", parameters)


def test_wrong_arguments_are_refused(node: zbot.Node) -> None:
    with pytest.raises(ParameterListError, match="must be a Parameter, not 'speed'"):
        node.set_parameters(["speed"])  # type: ignore[list-item]
    with pytest.raises(ParameterListError, match="must be a name, not 1"):
        node.get_parameters([1])  # type: ignore[list-item]
    with pytest.raises(ArgumentTypeError, match="callback must be a function"):
        node.add_on_set_parameters_callback(None)  # type: ignore[arg-type]
    with pytest.raises(ArgumentTypeError, match="prefixes must be a list"):
        node.list_parameters("drive", 0)  # type: ignore[arg-type]
    with pytest.raises(ArgumentTypeError, match="depth must be an int"):
        node.list_parameters([], None)  # type: ignore[arg-type]
    with pytest.raises(ValueError, match="depth must be 0 or more"):
        node.list_parameters([], -1)
    with pytest.raises(UnknownCallbackError):
        node.remove_post_set_parameters_callback(print)


def test_callbacks_come_and_go(node: zbot.Node) -> None:
    node.declare_parameter("speed", 1.0)
    announced: list[float] = []

    def double(given: list[Parameter[Any]]) -> list[Parameter[Any]]:
        return [Parameter(one.name, value=one.value * 2) for one in given]

    def refuse(given: list[Parameter[Any]]) -> SetParametersResult:
        return SetParametersResult(successful=given[0].value < 10, reason="too fast")

    def tell(given: list[Parameter[Any]]) -> None:
        announced.append(given[0].value)

    node.add_pre_set_parameters_callback(double)
    node.add_on_set_parameters_callback(refuse)
    node.add_post_set_parameters_callback(tell)
    assert double in node._pre_set_parameters_callbacks
    assert refuse in node._on_set_parameters_callbacks
    assert tell in node._post_set_parameters_callbacks
    faster = [Parameter("speed", value=6.0)]
    assert node.set_parameters_atomically(faster).reason == "too fast"
    node.remove_pre_set_parameters_callback(double)
    assert node.set_parameters_atomically(faster).successful
    node.remove_on_set_parameters_callback(refuse)
    node.remove_post_set_parameters_callback(tell)
    assert node._on_set_parameters_callbacks == []
    assert node.set_parameters_atomically([Parameter("speed", value=99.0)]).successful
    assert announced == [6.0]


def test_a_callback_that_returns_nothing_refuses_with_a_log_line(node: zbot.Node) -> None:
    node.declare_parameter("speed", 1.0)

    def forgetful(_: list[Parameter[Any]]) -> Any:
        return None

    node.add_on_set_parameters_callback(forgetful)
    with pytest.warns(UserWarning, match="forgetful returned None"):
        result = node.set_parameters([Parameter("speed", value=2.0)])[0]
    assert "forgetful returned None" in result.reason


def test_overrides_have_an_order_of_precedence(make_context: MakeContext, tmp_path: Path) -> None:
    path = tmp_path / "p.yaml"
    path.write_text(
        "/**:\n  ros__parameters: {a: 1, b: 1, c: 1, d: 1}\n"
        "/lab/robot:\n  ros__parameters: {b: 2, c: 2, d: 2}\n"
    )
    words = ["--ros-args", "--params-file", str(path), "-p", "c:=3", "-p", "robot:d:=3"]
    node = zbot.Node(
        "robot",
        namespace="/lab",
        context=make_context(),
        cli_args=words,
        parameter_overrides=[Parameter("d", value=4)],
        automatically_declare_parameters_from_overrides=True,
    )
    assert {name: node.get_parameter(name).value for name in "abcd"} == {
        "a": 1,
        "b": 2,
        "c": 3,
        "d": 4,
    }


def test_undeclared_parameters_are_allowed_on_request(make_context: MakeContext) -> None:
    node = zbot.Node("free", context=make_context(), allow_undeclared_parameters=True)
    assert node.get_parameter("x").value is None
    assert node.describe_parameter("x").name == ""
    assert node.set_parameters([Parameter("x", value=1)])[0].successful
    assert node.get_parameter("x").value == 1


def test_a_program_may_use_rclpys_private_names(make_context: MakeContext) -> None:
    class Mine(zbot.Node):
        def __init__(self) -> None:
            super().__init__("mine", context=make_context())
            assert "use_sim_time" in self._parameters
            self._parameters = {"my": "own"}
            self._parameter_overrides = 5
            self.declare_parameter("x", 1)

    mine = Mine()
    assert mine.get_parameter("x").value == 1
    assert mine._parameters == {"my": "own"}


# -- use_sim_time ------------------------------------------------------------------------------


def test_use_sim_time_moves_the_clock_at_run_time(node: zbot.Node, spin: Spin) -> None:
    publisher = node.create_publisher(Clock, "/clock", 1)
    spin(node)
    assert node.set_parameters([Parameter("use_sim_time", value=True)])[0].successful
    message = Clock()
    message.clock.sec = 42

    def is_simulated() -> bool:
        publisher.publish(message)
        return node.get_clock().now().nanoseconds == 42 * 10**9

    assert wait_until(is_simulated)
    node.set_parameters([Parameter("use_sim_time", value=False)])
    assert node.get_clock().now().nanoseconds > 10**18


def test_use_sim_time_has_to_be_a_bool(make_context: MakeContext) -> None:
    with pytest.raises(InvalidParameterTypeException, match="expecting type 'BOOL'"):
        zbot.Node("x", context=make_context(), cli_args=["--ros-args", "-p", "use_sim_time:=yess"])


# -- from another node -------------------------------------------------------------------------


def test_another_node_lists_reads_and_describes(
    node: zbot.Node, client: AsyncParameterClient
) -> None:
    limits = [IntegerRange(from_value=0, to_value=9, step=3)]
    node.declare_parameter("a.b", 3, ParameterDescriptor(integer_range=limits))
    node.declare_parameter("a.c", ["x", "y"])
    assert answer(client.list_parameters(["a"])).result.names == ["a.b", "a.c"]
    assert answer(client.list_parameters(depth=1)).result.names == [
        "use_sim_time",
        "start_type_description_service",
    ]
    values = answer(client.get_parameters(["a.b", "a.c"])).values
    assert values[0].integer_value == 3
    assert values[1].string_array_value == ["x", "y"]
    assert list(answer(client.get_parameter_types(["a.b", "a.c"])).types) == [2, 9]
    assert answer(client.describe_parameters(["a.b"])).descriptors[0].integer_range == limits
    assert answer(client.get_parameters(["a.b", "nope"])).values == []
    assert list(answer(client.get_parameter_types(["nope"])).types) == []
    assert answer(client.describe_parameters(["nope"])).descriptors == []


def test_another_node_sets_and_deletes(node: zbot.Node, client: AsyncParameterClient) -> None:
    node.declare_parameter("speed", 1.0)
    node.declare_parameter("free", None, ParameterDescriptor(dynamic_typing=True))
    wanted: list[Any] = [
        Parameter("speed", value=2),
        Parameter("free", value="x").to_parameter_msg(),
        Parameter("nope", value=1),
        Parameter("speed", value="fast"),
        ParameterMsg(name="free", value=ParameterValue(type=42)),
    ]
    responses: list[Any] = []
    results = answer(client.set_parameters(wanted, responses.append)).results
    assert [one.successful for one in results] == [True, True, False, False, False]
    assert "'nope'" in results[2].reason
    assert "expected 'double' got 'string'" in results[3].reason
    assert "unexpected parameter type 42" in results[4].reason
    assert wait_until(lambda: len(responses) == 1)
    assert node.get_parameter("speed").value == 2.0
    both = [Parameter("speed", value=3.0), Parameter("nope", value=1)]
    assert not answer(client.set_parameters_atomically(both)).result.successful
    assert node.get_parameter("speed").value == 2.0
    deleted = answer(client.delete_parameters(["free", "speed"])).results
    assert [one.successful for one in deleted] == [True, False]
    with pytest.raises(ParameterNotDeclaredException):
        node.get_parameter("free")


def test_another_node_loads_a_file(
    node: zbot.Node, client: AsyncParameterClient, tmp_path: Path
) -> None:
    node.declare_parameter("speed", 1.0)
    node.declare_parameter("gains", [1.0])
    path = tmp_path / "p.yaml"
    path.write_text(
        "/**:\n  ros__parameters: {speed: 5}\n/lab/robot:\n  ros__parameters: {gains: []}"
    )
    assert all(
        one.successful for one in answer(client.load_parameter_file(str(path), True)).results
    )
    assert (node.get_parameter("speed").value, node.get_parameter("gains").value) == (5.0, [])
    path.write_text("/lab/robot:\n  ros__parameters: {speed: 6, gains: [1, 2.5]}")
    assert answer(client.load_parameter_file_atomically(str(path))).result.successful
    assert node.get_parameter("gains").value == [1.0, 2.5]


def test_an_absent_node_is_not_waited_for(make_context: MakeContext) -> None:
    client = AsyncParameterClient(zbot.Node("asking", context=make_context()), "nobody")
    assert not client.services_are_ready()
    assert not client.wait_for_services(0.01)


def test_a_node_may_call_its_own_services_from_a_callback(node: zbot.Node, spin: Spin) -> None:
    node.declare_parameter("speed", 1.0)
    own = node.create_client(SetParameters, "robot/set_parameters")
    done: list[Any] = []

    def set_it() -> None:
        timer.cancel()
        faster = Parameter("speed", value=2.0).to_parameter_msg()
        done.append(own.call(SetParameters.Request(parameters=[faster]), timeout_sec=5))

    timer = node.create_timer(0.0, set_it)
    spin(node)
    assert wait_until(lambda: len(done) == 1)
    assert node.get_parameter("speed").value == 2.0


# -- events ------------------------------------------------------------------------------------


def test_every_change_is_published(node: zbot.Node, client: AsyncParameterClient) -> None:
    events: list[ParameterEvent] = []
    subscription = client.on_parameter_event(events.append)
    assert wait_until(lambda: node.count_subscribers("/parameter_events") == 1)
    node.declare_parameter("speed", 1.0)
    node.set_parameters([Parameter("speed", value=2.0)])
    node.undeclare_parameter("speed")
    assert wait_until(lambda: len(events) == 3)
    assert [one.node for one in events] == ["/lab/robot"] * 3
    assert [one.name for one in events[0].new_parameters] == ["speed"]
    assert [one.value.double_value for one in events[1].changed_parameters] == [2.0]
    assert [one.value.type for one in events[2].deleted_parameters] == [0]
    assert events[0].stamp.sec > 0
    assert subscription.topic_name == "/parameter_events"


def test_a_handler_calls_the_callbacks_of_the_changed_parameter(
    node: zbot.Node, make_context: MakeContext, spin: Spin
) -> None:
    watcher = zbot.Node("watcher", context=make_context(), namespace="lab")
    handler = ParameterEventHandler(watcher)
    heard: list[Any] = []
    of_speed = handler.add_parameter_callback(
        "speed", "robot", lambda one: heard.append(("speed", one.value.double_value))
    )
    handler.add_parameter_callback("speed", "/other", lambda _: heard.append("wrong node"))
    handler.add_parameter_callback("use_sim_time", "", lambda _: heard.append("own"))
    of_all = handler.add_parameter_event_callback(lambda event: heard.append(event.node))
    spin(watcher)
    assert wait_until(lambda: node.count_subscribers("/parameter_events") == 1)
    node.declare_parameter("speed", 1.0)
    assert wait_until(lambda: len(heard) == 2)
    assert heard == [("speed", 1.0), "/lab/robot"]
    watcher.set_parameters([Parameter("use_sim_time", value=False)])
    assert wait_until(lambda: "own" in heard)
    handler.remove_parameter_callback(of_speed)
    handler.remove_parameter_event_callback(of_all)
    with pytest.raises(UnknownCallbackError):
        handler.remove_parameter_callback(of_speed)
    handler.destroy()
    assert not list(watcher.subscriptions)


def test_callbacks_of_a_handler_are_kept_under_rclpys_names(node: zbot.Node) -> None:
    handler, heard = ParameterEventHandler(node), list[Any]()
    first = handler.add_parameter_callback("speed", "arm", lambda _: heard.append("first"))
    last = handler.add_parameter_callback("speed", "arm", lambda _: heard.append("last"))
    of_all = handler.add_parameter_event_callback(heard.append)
    callbacks = handler._callbacks
    assert callbacks.parameter_callbacks == {("speed", "/lab/arm"): [last, first]}
    assert callbacks.event_callbacks == [of_all]
    event = ParameterEvent(node="/lab/arm", changed_parameters=SPEED)
    callbacks.event_callback(event)
    assert heard == ["last", "first", event]
    handler.remove_parameter_callback(first)
    handler.remove_parameter_callback(last)
    assert not callbacks.parameter_callbacks


def test_an_event_with_parameters_instead_of_messages_is_refused(node: zbot.Node) -> None:
    publisher = node.create_publisher(ParameterEvent, "events", 1)
    with pytest.raises(zbot.ZbotError, match="new_parameters"):
        publisher.publish(ParameterEvent(new_parameters=SPEED))


def test_a_handler_can_be_limited_to_some_nodes(
    node: zbot.Node, make_context: MakeContext, spin: Spin
) -> None:
    watcher = zbot.Node("watcher", context=make_context(), namespace="lab")
    handler = ParameterEventHandler(watcher)
    heard: list[str] = []
    handler.add_parameter_event_callback(lambda event: heard.append(event.node))
    assert handler.configure_nodes_filter(["robot", "/elsewhere"])
    spin(watcher)
    assert wait_until(lambda: node.count_subscribers("/parameter_events") == 1)
    watcher.declare_parameter("speed", 1.0)
    node.declare_parameter("speed", 1.0)
    assert wait_until(lambda: heard == ["/lab/robot"])
    assert handler.configure_nodes_filter()
    watcher.declare_parameter("force", 1.0)
    assert wait_until(lambda: heard == ["/lab/robot", "/lab/watcher"])


# -- quality of service ------------------------------------------------------------------------


def test_parameters_override_quality_of_service(make_context: MakeContext) -> None:
    node = zbot.Node(
        "tuned",
        context=make_context(),
        parameter_overrides=[
            Parameter("qos_overrides./scan.publisher.depth", value=3),
            Parameter("qos_overrides./scan.subscription_left.reliability", value="best_effort"),
        ],
    )
    asked = QoSProfile(depth=10)
    publisher = node.create_publisher(
        String, "scan", asked, qos_overriding_options=QoSOverridingOptions.with_default_policies()
    )
    subscription = node.create_subscription(
        String,
        "scan",
        print,
        asked,
        qos_overriding_options=QoSOverridingOptions(
            [QoSPolicyKind.RELIABILITY, QoSPolicyKind.LIFESPAN, QoSPolicyKind.DEADLINE],
            entity_id="left",
        ),
    )
    assert (publisher.qos_profile.depth, asked.depth) == (3, 10)
    assert subscription.qos_profile.reliability is ReliabilityPolicy.BEST_EFFORT
    names = sorted(node.get_parameters_by_prefix("qos_overrides"))
    assert names == [
        "/scan.publisher.depth",
        "/scan.publisher.history",
        "/scan.publisher.reliability",
        "/scan.subscription_left.deadline",
        "/scan.subscription_left.reliability",
    ]
    assert node.describe_parameter("qos_overrides./scan.publisher.depth").read_only


def test_invalid_quality_of_service_is_refused(make_context: MakeContext) -> None:
    wrong = [Parameter("qos_overrides./scan.publisher.reliability", value="relaible")]
    node = zbot.Node("tuned", context=make_context(), parameter_overrides=wrong)
    with pytest.raises(UnknownQoSKeyError, match="relaible"):
        node.create_publisher(
            String, "scan", 10, qos_overriding_options=QoSOverridingOptions.with_default_policies()
        )
    options = QoSOverridingOptions.with_default_policies(
        callback=lambda _: SetParametersResult(successful=False, reason="too deep")
    )
    with pytest.raises(InvalidQosOverridesError, match=r"subscription of /scan .*too deep"):
        node.create_subscription(String, "scan", print, 10, qos_overriding_options=options)
