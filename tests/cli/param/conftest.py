"""Nodes with the parameters that the tests use."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest

import zbot as library
from zbot.parameters.parameter import Parameter

from rcl_interfaces.msg import (  # isort: skip
    FloatingPointRange,
    IntegerRange,
    ParameterDescriptor,
)

if TYPE_CHECKING:
    from tests.conftest import MakeContext, Spin

SERVICE = "/minimal_service"


@pytest.fixture
def node(make_context: MakeContext, spin: Spin) -> library.Node:
    """Return the node of the recordings: /minimal_service with `my_parameter` and `rate`."""
    node = library.Node("minimal_service", context=make_context())
    node.declare_parameter("my_parameter", "world")
    node.declare_parameter("rate", 2.5)
    spin(node)
    return node


@pytest.fixture
def rich(make_context: MakeContext, spin: Spin) -> library.Node:
    """Return a node with parameters of every type."""
    node = library.Node("rich", context=make_context(), namespace="lab")
    level = IntegerRange(from_value=0, to_value=255, step=5)
    node.declare_parameter(
        "level",
        50,
        ParameterDescriptor(
            description="How much", additional_constraints="even on Sundays", integer_range=[level]
        ),
    )
    share = FloatingPointRange(from_value=0.0, to_value=1.0, step=0.25)
    node.declare_parameter(
        "share", 0.5, ParameterDescriptor(read_only=True, floating_point_range=[share])
    )
    node.declare_parameter("free", None, ParameterDescriptor(dynamic_typing=True))
    node.declare_parameter("group.flags", [True, False])
    node.declare_parameter("group.numbers", [1, 2])
    node.declare_parameter("group.gains", [0.5, 1e-7])
    node.declare_parameter("group.words", ["a", "it's", "1e3", "true", ""])
    node.declare_parameter("group.bytes", [b"\x01", b"\xff"])
    node.declare_parameter("group", "also a value")
    node.declare_parameter("port", Parameter.Type.INTEGER)
    spin(node)
    return node
