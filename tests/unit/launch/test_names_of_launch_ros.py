"""Tests of names that launch_ros's own tests and packages that extend launch_ros use."""

from __future__ import annotations

import io
import sys
from typing import TYPE_CHECKING, Any

import pytest

from zbot.launch import LaunchContext, LaunchDescription, LaunchService
from zbot.launch.actions import LifecycleTransition, Node, SetROSLogDir
from zbot.launch.actions.node import get_node_name_count
from zbot.launch.actions.ros_names import (
    is_namespace_absolute,
    is_root_namespace,
    prefix_namespace,
)
from zbot.launch.errors import EntityTypeError
from zbot.launch.frontend.parser import Parser
from zbot.launch.parameters import Parameter, ParameterFile, evaluate_parameters
from zbot.launch.substitution import TextSubstitution

if TYPE_CHECKING:
    from collections.abc import Mapping
    from pathlib import Path


@pytest.mark.parametrize(
    ("base", "inner", "expected"),
    [
        (None, None, None),
        ("a", None, "a"),
        (None, "/", "/"),
        ("a", "b/", "a/b"),
        ("a", "/b/", "/b"),
        ("/", "b", "/b"),
        ("a", "", "a"),
    ],
)
def test_namespaces_are_joined(base: str | None, inner: str | None, expected: str | None) -> None:
    assert prefix_namespace(base, inner) == expected


def test_absolute_and_relative_namespaces_are_recognized() -> None:
    assert [is_namespace_absolute(namespace) for namespace in ("/", "/a", "", "a")] == [
        True,
        True,
        False,
        False,
    ]
    assert [is_root_namespace(namespace) for namespace in ("/", "/a", "")] == [True, False, False]


def _node(**names: Any) -> Node:
    return Node(executable=sys.executable, arguments=["-c", "pass"], **names)


@pytest.mark.parametrize(
    ("names", "counted"),
    [
        ({"name": "arm", "namespace": "/left"}, {"/left/arm": 1}),
        ({"name": "arm"}, {"/arm": 1, "/left/arm": 0}),
        ({"namespace": "/left"}, {"/left/arm": 0}),
    ],
)
def test_nodes_are_counted_by_name(names: dict[str, str], counted: Mapping[str, int]) -> None:
    service = LaunchService()
    service.include_launch_description(LaunchDescription([_node(**names)]))
    assert service.run() == 0
    assert {name: get_node_name_count(service.context, name) for name in counted} == counted


def test_a_second_node_of_a_name_causes_a_warning(capsys: pytest.CaptureFixture[str]) -> None:
    service = LaunchService()
    service.include_launch_description(LaunchDescription([_node(name="a"), _node(name="a")]))
    assert service.run() == 0
    assert "there are now at least 2 nodes with the name /a created" in capsys.readouterr().out


def test_a_relative_log_folder_is_inside_the_current_one(tmp_path: Path) -> None:
    context = LaunchContext()
    context.environment["ROS_LOG_DIR"] = str(tmp_path)
    SetROSLogDir("arm").visit(context)
    assert context.environment["ROS_LOG_DIR"] == str(tmp_path / "arm")
    SetROSLogDir(str(tmp_path / "other")).visit(context)
    assert context.environment["ROS_LOG_DIR"] == str(tmp_path / "other")


def test_a_parameter_has_a_plain_name_once_it_is_evaluated() -> None:
    parameter = Parameter("speed", TextSubstitution(text="1.5"))
    assert parameter.name[0].text == "speed"
    assert parameter.evaluate(LaunchContext()) == ("speed", 1.5)
    assert parameter.name == "speed"
    with pytest.raises(EntityTypeError):
        Parameter("speeds", TextSubstitution(text="[1, fast]")).evaluate(LaunchContext())


def test_a_parameter_file_has_its_evaluated_path(tmp_path: Path) -> None:
    path = tmp_path / "a.yaml"
    path.write_text("/**: {ros__parameters: {home: $(env HOME x)}}")
    context = LaunchContext()
    file = ParameterFile(str(path), allow_substs=True)
    assert file.evaluate(context) == file.param_file != path
    plain = ParameterFile(str(path))
    assert plain.evaluate(context) == plain.param_file == path
    context.close()


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("2, 5", (2, 5)),
        ("2., 5.", (2.0, 5.0)),
        ("'2', '5'", ("2", "5")),
        (r"\'2\', \'5\'", ("'2'", "'5'")),
        ("''2'', ''5''", ("'2'", "'5'")),
        ("a: b:, c", ("a: b:", "c")),
    ],
)
def test_texts_of_parameters_are_read_as_yaml_or_stay_texts(text: str, expected: Any) -> None:
    parameter = f'<param name="p" value="{text}" value-sep=", "/>'
    xml = f'<launch><node exec="x">{parameter}</node></launch>'
    entity, parser = Parser.load(io.StringIO(xml))
    node: Any = parser.parse_description(entity).entities[0]
    [values] = evaluate_parameters(LaunchContext(), node._Node__parameters)
    assert values == {"p": expected}


def test_transitions_have_labels_or_numbers() -> None:
    for transition in (3, "3", "activate"):
        assert LifecycleTransition(["talker"], [transition])._labels == ["activate"]
    with pytest.raises(EntityTypeError):
        LifecycleTransition([], [1])
    with pytest.raises(EntityTypeError):
        LifecycleTransition(["talker"], [])


def test_a_shell_reads_parameters_as_they_are(capfd: pytest.CaptureFixture[str]) -> None:
    service = LaunchService()
    node = Node(
        executable=f"{sys.executable} -c 'import sys; print(sys.argv[1:])'",
        arguments=["$((1 + 1))"],
        shell=True,
        name="a",
        parameters=[{"text": "two <words> 'of' \"$HOME\"", "list": ["a", "b c"]}],
    )
    service.include_launch_description(LaunchDescription([node]))
    assert service.run() == 0
    said = capfd.readouterr().out
    assert "['2', '--ros-args', '-r', '__node:=a', '-p', " in said
    assert "'text:=two <words> \\'of\\' \"$HOME\"', '-p', 'list:=[a, b c]']" in said
