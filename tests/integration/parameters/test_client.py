"""Tests of parameters that another node reads and sets."""

from __future__ import annotations

import threading
from typing import TYPE_CHECKING, Any

import pytest

import zbot
from tests.conftest import allowed, wait_until
from zbot.parameters.errors import ParameterNotDeclaredException
from zbot.parameters.parameter import Parameter
from zbot.remote.parameter_client import AsyncParameterClient

from rcl_interfaces.msg import IntegerRange, ParameterDescriptor, ParameterValue
from rcl_interfaces.msg import Parameter as ParameterMsg
from rcl_interfaces.srv import SetParameters

if TYPE_CHECKING:
    from pathlib import Path

    from tests.conftest import MakeContext, Spin


def answer(future: zbot.Future[Any]) -> Any:
    over = threading.Event()
    future.add_waker(over.set)
    assert over.wait(allowed(5))
    return future.result()


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
    assert [result.successful for result in results] == [True, True, False, False, False]
    assert "'nope'" in results[2].reason
    assert "expected 'double' got 'string'" in results[3].reason
    assert "unexpected parameter type 42" in results[4].reason
    assert wait_until(lambda: len(responses) == 1)
    assert node.get_parameter("speed").value == 2.0
    both = [Parameter("speed", value=3.0), Parameter("nope", value=1)]
    assert not answer(client.set_parameters_atomically(both)).result.successful
    assert node.get_parameter("speed").value == 2.0
    deleted = answer(client.delete_parameters(["free", "speed"])).results
    assert [result.successful for result in deleted] == [True, False]
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
        result.successful for result in answer(client.load_parameter_file(str(path), True)).results
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
