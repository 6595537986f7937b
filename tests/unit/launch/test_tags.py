"""Tests of the actions that tags of XML and YAML become."""

from __future__ import annotations

import io
from typing import TYPE_CHECKING, Any

import pytest

from zbot.launch import LaunchContext
from zbot.launch.actions import AppendEnvironmentVariable, ForEach, ForLoop, OpaqueFunction
from zbot.launch.actions.timer import TimerAction
from zbot.launch.errors import AttributeTypeError
from zbot.launch.frontend import xml_file, yaml_file
from zbot.launch.frontend.parser import Parser
from zbot.launch.frontend.ros_tags import node_options
from zbot.launch.parameters import to_words
from zbot.launch.substitution import perform
from zbot.parameters.ros_args import Arguments

if TYPE_CHECKING:
    from zbot.launch.entity import LaunchDescriptionEntity


def described(text: str) -> LaunchDescriptionEntity:
    root, parser = Parser.load(io.StringIO(text))
    (entity,) = parser.parse_description(root).entities
    return entity


@pytest.mark.parametrize("tag", ["timer", "ros_timer"])
@pytest.mark.parametrize(
    "text",
    ['<launch><{} period="5"><shutdown/></{}></launch>', "launch:\n- {}: {{period: 5}}"],
)
def test_a_period_is_a_number(tag: str, text: str) -> None:
    timer = described(text.format(tag, tag))
    assert isinstance(timer, TimerAction)
    assert timer.period == 5.0
    assert isinstance(timer.period, float)


def test_a_period_may_be_a_substitution_and_must_be_a_number() -> None:
    timer = described('<launch><timer period="$(env X 2)"/></launch>')
    assert isinstance(timer, TimerAction)
    assert perform(LaunchContext(), timer.period) == "2"
    with pytest.raises(AttributeTypeError, match="'period' of `timer` must be of type float"):
        described('<launch><timer period="soon"/></launch>')


@pytest.mark.parametrize("prepend", [True, False])
def test_prepend_stays_a_bool(prepend: bool) -> None:
    text = f'<launch><append_env name="A" value="b" prepend="{prepend}" separator=";"/></launch>'
    action = described(text)
    assert isinstance(action, AppendEnvironmentVariable)
    assert action.prepend is prepend
    context = LaunchContext()
    context.environment["A"] = "a"
    action.visit(context)
    assert context.environment["A"] == ("b;a" if prepend else "a;b")


def test_prepend_may_be_a_substitution() -> None:
    context = LaunchContext()
    context.environment = {"A": "a", "FIRST": "true"}
    from_env = Parser().parse_substitution("$(env FIRST)")
    AppendEnvironmentVariable("A", "b", prepend=from_env, separator=";").visit(context)
    assert context.environment["A"] == "b;a"


def test_an_iteration_of_a_loop_has_its_own_scope() -> None:
    loop = described('<launch><for len="2" name="i"><shutdown reason="$(index i)"/></for></launch>')
    assert isinstance(loop, ForLoop)
    context = LaunchContext()
    (each,) = loop.execute(context)
    assert isinstance(each, ForEach)
    steps = each.execute(context)
    assert [isinstance(step, OpaqueFunction) for step in steps] == [True, True, False, True] * 2
    for step in steps:
        step.visit(context)
    assert context.locals_depth == 0


def test_a_log_tag_without_a_level_is_deprecated() -> None:
    with pytest.warns(DeprecationWarning, match="write `log_info`"):
        described('<launch><log message="hello"/></launch>')


def words_of(kind: str, parameter: str) -> dict[str, Any]:
    """Return the parameters that a node of a launch file in XML or YAML gets."""
    if kind == "xml":
        text = f"<launch><node pkg='a' exec='b'><param name='x' {parameter}/></node></launch>"
        root = xml_file.parse(text, "a.launch.xml")
    else:
        lines = ["launch:", "- node:", "    pkg: a", "    exec: b", "    param:", "    - name: x"]
        lines += [f"      {line}" for line in parameter.split("\n")]
        root = yaml_file.parse("\n".join(lines), "a.launch.yaml")
    options = node_options(root.children[0], Parser())
    words = to_words(LaunchContext(), options["parameters"])
    return Arguments.parse(["program", "--ros-args", *words]).parameters_for("/n")


@pytest.mark.parametrize(
    ("kind", "parameter", "expected"),
    [
        ("xml", "value='a: b # c' type='str'", "a: b # c"),
        ("xml", "value='010' type='str'", "010"),
        ("xml", "value='' type='str'", ""),
        ("xml", "value='[1.10, y]' type='list_of_str'", ["1.10", "y"]),
        ("xml", "value='[1, 2]' type='list_of_float'", [1.0, 2.0]),
        ("xml", "value='1e3'", 1000.0),
        ("yaml", "value: 'a: b # c'\ntype: str", "a: b # c"),
        ("yaml", "value: 010\ntype: str", "010"),
        ("yaml", "value: 2020-01-01\ntype: str", "2020-01-01"),
        ("yaml", "value: [1.10, on]\ntype: list_of_str", ["1.10", "on"]),
        ("yaml", "value: [1, 2]\ntype: list_of_float", [1.0, 2.0]),
        ("yaml", "value: |\n  <!-- a: b -->\n  <c/>\ntype: str", "<!-- a: b -->\n<c/>\n"),
        ("yaml", "value: 010", 8),
    ],
)
def test_the_type_of_a_parameter_decides_how_its_text_is_read(
    kind: str, parameter: str, expected: Any
) -> None:
    assert words_of(kind, parameter) == {"x": expected}


def test_a_name_in_yaml_stays_as_it_is_written() -> None:
    text = (
        "launch:\n- node: {pkg: a, exec: b, param: [{name: on, value: 1}, {name: 1.10, value: 2}]}"
    )
    options = node_options(yaml_file.parse(text, "a.yaml").children[0], Parser())
    words = to_words(LaunchContext(), options["parameters"])
    arguments = Arguments.parse(["program", "--ros-args", *words])
    assert arguments.parameters_for("/n") == {"on": 1, "1.10": 2}
