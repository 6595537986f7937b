"""Tests of parameters that a node declares and sets itself."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import pytest

import zbot
from tests.conftest import wait_until
from zbot.errors import ArgumentTypeError
from zbot.node.parameter_services import ParameterServices
from zbot.node.service_types import PARAMETER_SERVICES
from zbot.parameters.errors import ParameterListError, UnknownCallbackError
from zbot.parameters.parameter import InvalidParameterTypeException, Parameter

from rcl_interfaces.msg import (
    IntegerRange,
    ParameterDescriptor,
    ParameterValue,
    SetParametersResult,
)
from rosgraph_msgs.msg import Clock

if TYPE_CHECKING:
    from pathlib import Path

    from tests.conftest import MakeContext, Spin

Type = Parameter.Type


# -- on the node -----------------------------------------------------------------------------------


def test_every_node_has_its_own_parameters_and_services(node: zbot.Node) -> None:
    assert node.get_parameter("use_sim_time").value is False
    assert node.describe_parameter("start_type_description_service").read_only
    served = dict(node.get_service_names_and_types_by_node("robot", "/lab"))
    assert {
        f"/lab/robot/{name}": [type_] for name, (type_, _) in PARAMETER_SERVICES.items()
    }.items() <= (served.items())


def test_the_services_carry_the_hashes_of_their_types() -> None:
    from zbot.interfaces import get_service, type_hash  # noqa: PLC0415 - only here

    for type_name, hash_text in PARAMETER_SERVICES.values():
        assert type_hash(get_service(type_name)) == hash_text


def test_the_services_can_be_left_out(make_context: MakeContext) -> None:
    node = zbot.Node("quiet", context=make_context(), start_parameter_services=False)
    assert [service.service_name for service in node.services] == ["/quiet/get_type_description"]
    assert node.has_parameter("use_sim_time")


def test_a_program_may_make_the_services_itself(make_context: MakeContext) -> None:
    node = zbot.Node("late", context=make_context(), start_parameter_services=False)
    ParameterServices(node)
    served = {service.service_name for service in node.services}
    assert {f"/late/{name}" for name in PARAMETER_SERVICES} <= served


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
    assert {
        name: parameter.value for name, parameter in node.get_parameters_by_prefix("drive").items()
    } == {
        "speed": 1.0,
        "gear": None,
        "name": "ada",
    }
    results = node.set_parameters(
        [Parameter("drive.speed", value=2), Parameter("drive.gear", value="first")]
    )
    assert [result.successful for result in results] == [True, False]
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


def test_the_warning_about_several_names_is_at_the_programs_line(node: zbot.Node) -> None:
    with pytest.warns(UserWarning, match="'other'") as told:
        node.declare_parameters("", [("other",)])
    assert told[0].filename == __file__


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
    with pytest.raises(TypeError, match="callback was given None"):
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
        return [Parameter(parameter.name, value=parameter.value * 2) for parameter in given]

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


# -- use_sim_time ----------------------------------------------------------------------------------


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
