"""Tests of what packages with their own tags use: parsers, entities, derived actions."""

from __future__ import annotations

import io
from typing import TYPE_CHECKING, Any, List  # noqa: UP035 - as extensions write it

import pytest

from zbot.launch import LaunchContext, LaunchDescription, LaunchDescriptionSource
from zbot.launch.actions import (
    DeclareLaunchArgument,
    ExecuteProcess,
    GroupAction,
    IncludeLaunchDescription,
    Log,
    Node,
)
from zbot.launch.actions.executable import Executable
from zbot.launch.errors import (
    AttributeTypeError,
    CoercionError,
    InvalidFrontendLaunchFileError,
    MissingAttributeError,
    UnknownNameError,
)
from zbot.launch.frontend.parser import Parser
from zbot.launch.frontend.registry import expose_action
from zbot.launch.frontend.substitution_text import parse, parse_if_substitutions
from zbot.launch.substitution import perform
from zbot.launch.substitutions import PythonExpression

if TYPE_CHECKING:
    from pathlib import Path

    from zbot.launch.entity import LaunchDescriptionEntity
    from zbot.launch.frontend.entity import Entity

XML = """<launch><executable cmd="ls -l '$(env X y)'" cwd="/" shell="False" emulate_tty="True">
<env name="a" value="b"/></executable></launch>"""
YAML = """launch:
- executable: {cmd: "ls -l '$(env X y)'", cwd: /, shell: false, emulate_tty: true,
               env: [{name: a, value: b}]}"""


def described(text: str) -> LaunchDescriptionEntity:
    root, parser = Parser.load(io.StringIO(text))
    (entity,) = parser.parse_description(root).entities
    return entity


@pytest.mark.parametrize("text", [XML, YAML])
def test_a_parser_reads_open_files_and_paths(text: str, tmp_path: Path) -> None:
    file = tmp_path / "launch_file"
    file.write_text(text, encoding="utf-8")
    root, parser = Parser.load(file)
    from_path = parser.parse_description(root).entities[0]
    context = LaunchContext()
    for source in (from_path, described(text)):
        assert isinstance(source, ExecuteProcess)
        assert [perform(context, word) for word in source.cmd] == ["ls", "-l", "y"]
        assert perform(context, source.cwd or "") == "/"
        (name, value), *_ = source.additional_env or []
        assert (perform(context, name), perform(context, value)) == ("a", "b")
        assert (source.shell, source.emulate_tty, source.env) == (False, True, None)


class Camera(Node):
    @classmethod
    def parse(cls, entity: Entity, parser: Parser) -> Any:
        _, options = super().parse(entity, parser)
        options["arguments"] = cls._parse_cmdline(entity.get_attr("sizes"), parser)
        return cls, options


def test_a_class_adds_to_the_tag_that_it_extends() -> None:
    expose_action("camera")(Camera)
    tag = '<camera pkg="cameras" exec="camera" name="left" sizes="640 $(env X 480)"/>'
    camera = described(f"<launch>{tag}</launch>")
    assert isinstance(camera, Camera)
    context = LaunchContext()
    assert [perform(context, word) for word in camera.arguments] == ["640", "480"]
    assert perform(context, camera.node_executable) == "camera"


def test_attributes_have_types() -> None:
    root, _ = Parser.load(
        io.StringIO('<launch><x a="1;2" a-sep=";" b="on" c="$(var c)"/></launch>')
    )
    (entity,) = root.get_attr("x", data_type=List[type(root)])  # type: ignore[misc]  # noqa: UP006
    assert entity.get_attr("a", data_type=List[int]) == [1, 2]  # noqa: UP006
    assert entity.get_attr("b", data_type=bool) is True
    assert entity.get_attr("b", data_type=None) is True
    assert entity.get_attr("c", data_type=int) == "$(var c)"
    assert entity.get_attr("d", data_type=float, optional=True) is None
    with pytest.raises(AttributeTypeError, match="'c' of `x` must be of type int"):
        entity.get_attr("c", data_type=int, can_be_str=False)
    with pytest.raises(MissingAttributeError):
        entity.get_attr("d")


@pytest.mark.parametrize(
    ("tag", "error"),
    [
        ('<executable cmd="ls"><what/></executable>', "`what` is not allowed inside `executable`"),
        ('<executable cmd="ls" shell="perhaps"/>', "'shell' of `executable` must be of type bool"),
        ('<group scoped="perhaps"/>', "'scoped' of `group` must be of type bool"),
    ],
)
def test_an_invalid_tag_is_refused(tag: str, error: str) -> None:
    with pytest.raises(InvalidFrontendLaunchFileError, match=error):
        described(f"<launch>{tag}</launch>")


def test_a_group_keeps_its_named_configurations() -> None:
    group = described(
        '<launch><group forwarding="false"><keep name="a" value="b"/></group></launch>'
    )
    assert isinstance(group, GroupAction)


def test_texts_without_substitutions_stay_texts() -> None:
    assert parse_if_substitutions("plain") == "plain"
    assert parse_if_substitutions(1) == 1
    first, second = parse_if_substitutions(["$(env X a)", "b"])
    assert (perform(LaunchContext(), first), second) == ("a", "b")
    with pytest.raises(CoercionError):
        parse_if_substitutions(["$(env X a)", 1, 1.0])


def test_quotes_between_quotes_are_text() -> None:
    text = """$(env X "$(env Y 'b')")"""
    assert perform(LaunchContext(), parse(text)) == "'b'"


def test_an_expression_reports_an_undefined_name() -> None:
    with pytest.raises(UnknownNameError, match="name 'ceil' is not defined"):
        PythonExpression("ceil(1.5)", python_modules=[""]).perform(LaunchContext())


def test_an_executable_has_its_command_line_in_a_launch() -> None:
    executable = Executable(cmd=["ls", '"a b"'], cwd="/", additional_env={"A": "b"})
    assert executable.final_cmd is None
    executable.apply_context(LaunchContext())
    assert executable.final_cmd == ["ls", '"a b"']
    assert executable.final_env is not None
    assert executable.final_env["A"] == "b"
    assert (executable.final_name, executable.final_cwd) == ("ls", "/")


def texts(entity: LaunchDescriptionEntity, context: LaunchContext) -> list[str]:
    """Return the texts of the `log` tags inside of an entity, in order."""
    if isinstance(entity, Log):
        return [perform(context, entity.msg)]
    found: list[str] = []
    for inner in entity.visit(context) or ():
        found += texts(inner, context)
    return found


@pytest.mark.parametrize(
    ("loop", "expected"),
    [
        ('<for len="2" name="i"><log_info message="n$(index i)"/></for>', ["n0", "n1"]),
        (
            """<for_each values="{a: x};{a: y, b: z}">
            <group><log_info message="$(for-var a)$(for-var b -)"/></group></for_each>""",
            ["x-", "yz"],
        ),
        ('<for len="0" name="i"><log_info message="$(index i)"/></for>', []),
    ],
)
def test_loops_have_values(loop: str, expected: list[str]) -> None:
    assert texts(described(f"<launch>{loop}</launch>"), LaunchContext()) == expected


def test_a_loop_value_outside_of_a_loop_is_an_error() -> None:
    with pytest.raises(RuntimeError, match="no enclosing loop has a value 'i'"):
        perform(LaunchContext(), parse("$(index i)"))


def test_the_environment_is_replaced() -> None:
    context = LaunchContext()
    described('<launch><rep_env><env name="A" value="b"/></rep_env></launch>').visit(context)
    assert context.environment == {"A": "b"}


def test_texts_are_joined() -> None:
    assert perform(LaunchContext(), parse("$(string-join . a $(env X b))")) == "a.b"


def test_an_include_must_pass_required_arguments() -> None:
    context = LaunchContext()
    context.launch_configurations["robot"] = "not given by the include"
    included = LaunchDescriptionSource(LaunchDescription([DeclareLaunchArgument("robot")]))
    with pytest.raises(RuntimeError, match='missing required argument "robot", given: \\[speed\\]'):
        IncludeLaunchDescription(included, launch_arguments={"speed": "1"}).visit(context)
    IncludeLaunchDescription(included, launch_arguments={"robot": "1"}).visit(context)
