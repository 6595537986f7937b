"""Tests of the parameters that the server for Foxglove reads and writes."""

from __future__ import annotations

from contextlib import nullcontext
from types import SimpleNamespace
from typing import TYPE_CHECKING, Any

import pytest

pytest.importorskip("foxglove", reason="foxglove-sdk is not installed")

from foxglove import Parameter as SdkParameter

from zbot.interfaces import get_service
from zbot.parameters.parameter import Parameter
from zbot.web.foxglove.parameters import Parameters

from rcl_interfaces.msg import SetParametersResult

if TYPE_CHECKING:
    from collections.abc import Callable


class RosNode:
    """Node of ROS 2: it gives no value at all if it lacks one of the parameters."""

    def __init__(self, **values: Any) -> None:
        self.values = values

    def call(self, request: Any, timeout_sec: float) -> Any:
        del timeout_sec
        if hasattr(request, "parameters"):
            return SimpleNamespace(results=[SetParametersResult(successful=True)])
        if not all(name in self.values for name in request.names):
            return SimpleNamespace(values=[])
        found = (Parameter(name, value=self.values[name]) for name in request.names)
        return SimpleNamespace(values=[one.to_parameter_msg().value for one in found])


@pytest.fixture
def parameters() -> Callable[[RosNode], Parameters]:
    def make(node: RosNode) -> Parameters:
        reference = SimpleNamespace(entity=node)
        system: Any = SimpleNamespace(
            interface=get_service, reader=lambda *_: nullcontext(reference)
        )
        return Parameters(system)

    return make


def test_a_node_that_lacks_a_parameter_gives_no_value(
    parameters: Callable[[RosNode], Parameters],
) -> None:
    made = parameters(RosNode(rate=5))
    assert made.read(["/node.rate", "/node.lost"]) == []
    assert [one.get_value() for one in made.read(["/node.rate"])] == [5]


def test_a_parameter_that_a_node_lacks_can_be_set(
    parameters: Callable[[RosNode], Parameters],
) -> None:
    assert parameters(RosNode()).write([SdkParameter("/node.new", value=1)]) == []
