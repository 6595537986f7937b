"""Tests of the parameters that the server for Foxglove reads and writes."""

from __future__ import annotations

from types import SimpleNamespace
from typing import TYPE_CHECKING, Any

import pytest

pytest.importorskip("foxglove", reason="foxglove-sdk is not installed")

from foxglove import Parameter as SdkParameter

from tests.unit.remote.fake_calls import FakeCalls, FakeNode
from zbot.web.foxglove import parameters as module
from zbot.web.foxglove.parameters import Parameters

if TYPE_CHECKING:
    from collections.abc import Callable


@pytest.fixture
def parameters(monkeypatch: pytest.MonkeyPatch) -> Callable[[FakeNode], Parameters]:
    def make(node: FakeNode) -> Parameters:
        calls = FakeCalls(node=node)
        monkeypatch.setattr(module, "ServiceCalls", lambda *_, **__: calls)
        system: Any = SimpleNamespace(node=None)
        return Parameters(system)

    return make


def test_a_node_that_lacks_a_parameter_gives_no_value(
    parameters: Callable[[FakeNode], Parameters],
) -> None:
    made = parameters(FakeNode(rate=5))
    assert made.read(["/node.rate", "/node.lost"]) == []
    assert [parameter.get_value() for parameter in made.read(["/node.rate"])] == [5]


def test_a_parameter_that_a_node_lacks_can_be_set(
    parameters: Callable[[FakeNode], Parameters],
) -> None:
    assert parameters(FakeNode()).write([SdkParameter("/node.new", value=1)]) != []
