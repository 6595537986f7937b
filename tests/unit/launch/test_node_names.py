"""Tests of the names of nodes in a launch and of arguments that nodes refuse."""

from __future__ import annotations

from typing import Any

import pytest

from zbot.launch import LaunchContext
from zbot.launch.actions import LifecycleNode, Node, PushROSNamespace, SetRemap
from zbot.launch.actions.composable import ComposableNode, ComposableNodeContainer
from zbot.launch.parameters import evaluate_parameters, normalize_parameters
from zbot.launch.substitution import TextSubstitution
from zbot.package.errors import NotRunnableError
from zbot.package.unavailable import Unavailable

UNKNOWN = Node.UNSPECIFIED_NODE_NAMESPACE


def text(value: str) -> TextSubstitution:
    return TextSubstitution(text=value)


@pytest.mark.parametrize(
    ("pushed", "own", "expected"),
    [
        ([], None, UNKNOWN),
        ([], "", "/"),
        ([""], None, "/"),
        (["a"], None, "/a"),
        (["a", "b"], "c", "/a/b/c"),
        (["a", "/b"], "c", "/b/c"),
        (["a"], "/", "/"),
    ],
)
def test_a_node_knows_its_namespace(pushed: list[str], own: str | None, expected: str) -> None:
    context = LaunchContext()
    for namespace in pushed:
        PushROSNamespace(namespace).visit(context)
    node = Node(executable="talker", name="t", namespace=own)
    assert not node.is_node_name_fully_specified()
    words = node.prepare(context).words
    assert node.expanded_node_namespace == expected
    assert node.node_name == f"{expected.rstrip('/')}/t"
    assert node.is_node_name_fully_specified() is (expected != UNKNOWN)
    assert (f"__ns:={expected}" in words) is (expected != UNKNOWN)


def test_remaps_of_the_launch_come_before_those_of_the_node() -> None:
    context = LaunchContext()
    SetRemap("a", "b").visit(context)
    node = Node(executable="talker", remappings=[("c", [text("d"), "e"])])
    node.prepare(context)
    assert node.expanded_remapping_rules == [("a", "b"), ("c", "de")]


def test_nodes_get_the_names_of_those_that_are_left_out() -> None:
    context = LaunchContext()

    def refuse(package: str, executable: str) -> None:
        raise NotRunnableError(f"{package} {executable}", Unavailable("a driver", "none"))

    node = Node(executable="talker")
    assert "ZBOT_LEFT_OUT" not in node.prepare(context).env
    context.find_program = refuse
    PushROSNamespace("robot").visit(context)
    for name, namespace in (("lidar", None), (None, "a")):
        left_out = Node(package="urg_node", executable="urg", name=name, namespace=namespace)
        with pytest.raises(NotRunnableError):
            left_out.visit(context)
    imu = ComposableNode(package="imu", plugin="imu::Node", name="imu", namespace="/")
    container = ComposableNodeContainer(name="c", composable_node_descriptions=[imu])
    container.visit(context)
    names = node.prepare(context).env["ZBOT_LEFT_OUT"]
    assert names == "/robot/lidar /robot/a/urg /imu"


@pytest.mark.parametrize(
    "options",
    [
        {"remappings": {"a": "b"}},
        {"remappings": [{"a": "b"}]},
        {"parameters": "file.yaml"},
        {"parameters": {"a": 5}},
        {"parameters": [5.0]},
        {"parameters": [{5: "a"}]},
        {"parameters": [{"a": {"b": [1, [2, 3]]}}]},
        {"parameters": [{"a": {1, 2}}]},
    ],
)
def test_a_node_refuses_invalid_arguments(options: Any) -> None:
    with pytest.raises(TypeError):
        Node(executable="talker", **options)


def test_a_managed_node_needs_a_namespace() -> None:
    with pytest.raises(TypeError, match="namespace"):
        LifecycleNode(executable="talker", name="t")  # type: ignore[call-arg]  # pyright: ignore[reportCallIssue]


@pytest.mark.parametrize(
    "value",
    [
        [True, 1],
        [[text("a")], True],
        text("{a: 3}"),
        [[text("[a, b]")], [text("[c]")]],
    ],
)
def test_values_of_impossible_types_are_refused(value: Any) -> None:
    parameters = normalize_parameters([{"a": value}])
    with pytest.raises(TypeError):
        evaluate_parameters(LaunchContext(), parameters)


def test_lists_are_tuples_and_paths_may_have_parts() -> None:
    given = normalize_parameters([{"a": [1, 2.5]}, (text("/a"), text("/b"))])
    values, path = evaluate_parameters(LaunchContext(), given)
    assert values == {"a": (1.0, 2.5)}
    assert str(path) == "/a/b"
