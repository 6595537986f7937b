from __future__ import annotations

from typing import TYPE_CHECKING

import pytest

from zbot.launch import LaunchContext, LaunchDescription
from zbot.launch.actions import DeclareLaunchArgument
from zbot.launch.arguments import declared_arguments, parse_arguments
from zbot.launch.description import LaunchIntrospector
from zbot.launch.errors import LaunchFileError, LaunchUsageError
from zbot.launch.source import AnyLaunchDescriptionSource

if TYPE_CHECKING:
    from pathlib import Path

_XML = """\
<launch>
  <arg name="robot" default="r2" description="its name"><choice value="r2"/></arg>
  <let name="both" value="$(var robot)_x"/>
  <set_env name="A" value="b"/>
  <unset_env name="A"/>
  <push_env/> <reset_env/> <pop_env/>
  <append_env name="A" value="c" prepend="true"/>
  <group scoped="false" if="true"><push-ros-namespace namespace="$(var robot)"/></group>
  <node pkg="p" exec="e" name="n" args="--a $(var robot)" output="screen" respawn="true">
    <param name="x" value="5"/>
    <param name="y"><param name="z" value="1 2" value-sep=" "/></param>
    <remap from="a" to="b"/>
    <env name="E" value="f"/>
  </node>
  <executable cmd="echo hi" shell="true"/>
  <set_parameter name="q" value="1.5" type="float"/>
  <set_remap from="c" to="d"/>
  <timer period="2"><log message="hello" level="error"/></timer>
  <node_container pkg="p" exec="e" name="c" namespace=""><composable_node pkg="a" plugin="b"/>
  </node_container>
  <include file="x.launch.py"><arg name="k" value="v"/></include>
  <shutdown reason="done"/>
</launch>
"""
_YAML = """\
launch:
- arg: {name: robot, default: r2, description: its name, choice: [{value: r2}]}
- let: {name: both, value: $(var robot)_x}
- set_env: {name: A, value: b}
- unset_env: {name: A}
- push_env: {}
- reset_env: {}
- pop_env: {}
- append_env: {name: A, value: c, prepend: true}
- group:
    scoped: false
    if: true
    children:
    - push_ros_namespace: {namespace: $(var robot)}
- node:
    pkg: p
    exec: e
    name: n
    args: --a $(var robot)
    output: screen
    respawn: true
    param:
    - {name: x, value: 5}
    - name: y
      param:
      - {name: z, value: [1, 2]}
    remap: [{from: a, to: b}]
    env: [{name: E, value: f}]
- executable: {cmd: echo hi, shell: true}
- set_parameter: {name: q, value: 1.5, type: float}
- set_remap: {from: c, to: d}
- timer:
    period: 2
    children:
    - log: {message: hello, level: error}
- node_container:
    pkg: p
    exec: e
    name: c
    namespace: ''
    composable_node: [{pkg: a, plugin: b}]
- include:
    file: x.launch.py
    arg: [{name: k, value: v}]
- shutdown: {reason: done}
"""
_TREE = """\
<launch.LaunchDescription>
    DeclareLaunchArgument('robot', default_value='r2', description='its name')
    SetLaunchConfiguration('both', LaunchConfig('robot') + '_x')
    SetEnvironmentVariable('A', 'b')
    UnsetEnvironmentVariable()
    PushEnvironment()
    ResetEnvironment()
    PopEnvironment()
    AppendEnvironmentVariable('A', 'c')
    GroupAction() if IfCondition('true')
        group condition:
            PushROSNamespace()
    Node(package='p', executable='e')
    ExecuteProcess(cmd=['echo', 'hi'])
    SetParameter()
    SetRemap()
    TimerAction()
        after some time:
            Log('hello')
    ComposableNodeContainer('c')
    IncludeLaunchDescription('x.launch.py')
    Shutdown()"""


def _load(folder: Path, name: str, text: str) -> LaunchDescription:
    path = folder / name
    path.write_text(text, encoding="utf-8")
    description = AnyLaunchDescriptionSource(str(path)).try_get_launch_description_without_context()
    assert description is not None
    return description


@pytest.mark.parametrize(("name", "text"), [("a.launch.xml", _XML), ("a.launch.yaml", _YAML)])
def test_both_formats_make_the_same_actions(tmp_path: Path, name: str, text: str) -> None:
    description = _load(tmp_path, name, text)
    assert LaunchIntrospector().format_launch_description(description) == _TREE
    (argument,) = description.get_launch_arguments()
    assert (argument.name, argument.description) == ("robot", "its name")
    assert argument.choices == ["r2"]


@pytest.mark.parametrize(
    ("name", "text", "expected"),
    [
        ("a.launch.xml", "<launch>\n<node pkg='p'/>\n</launch>", ":2: `node` needs the attr"),
        ("a.launch.xml", "<launch>\n<nod/>\n</launch>", ":2: there is no action `nod`"),
        ("a.launch.xml", "<launch>\n\n<log/ ></launch>", ":3: not well-formed"),
        (
            "a.launch.xml",
            "<launch>\n<log_info message='$(var'/></launch>",
            ":2: '$(var' is not closed",
        ),
        (
            "a.launch.xml",
            "<launch>\n<log_info message='' leve='x'/></launch>",
            "no attribute 'leve'",
        ),
        ("a.launch.xml", "<robot/>", ":1: the outermost tag must be <launch>"),
        ("a.launch.xml", "<launch>\n<log message='' if='1' unless='1'/></launch>", ":2: `log` has"),
        ("a.launch.yaml", "launch:\n- node: {pkg: p}", ":2: `node` needs the attribute 'exec'"),
        ("a.launch.yaml", "launch:\n- a: 1\n  b: 2", ":2: each item of the list must be one"),
        ("a.launch.yaml", "launch:\n- log: hello", ":2: below `log` write"),
        ("a.launch.yaml", "lunch: []", ":1: a launch file in YAML begins with `launch:`"),
        ("a.launch.yaml", "", ":1: a launch file in YAML begins with `launch:`"),
        ("a.launch.yaml", "launch:\n- {", "YAML: "),
        ("a.launch.py", "x = (", ":1: SyntaxError: '(' was never closed"),
        ("a.launch.py", "x = 1", ": the file has no function generate_launch_description()"),
        ("a.launch.py", "\ndef generate_launch_description():\n    1/0", ":3: ZeroDivisionError"),
        ("a.launch.py", "def generate_launch_description():\n    pass", ":1: generate_launch_desc"),
        ("a.launch.py", "import sys\nsys.exit()", ":2: the file ended the launch with exit()"),
        ("a.launch.py", "exit(3)", ":1: the file ended the launch with exit(3)"),
        ("a.launch.py", "raise SystemExit('no map')", ":1: SystemExit: no map"),
        ("a.launch.py", "import no_such_module", ":1: ModuleNotFoundError: No module named"),
        ("a.launch", "", ": the file has no function generate_launch_description()"),
        ("a.launch", "\n<launch>\n<nod/></launch>", ":3: there is no action `nod`"),
        ("a.launch", "launch:\n- nod: {}", ":2: there is no action `nod`"),
        ("a.launch", "def generate_launch_description():\n    1/0", ":2: ZeroDivisionError"),
        (
            "a.launch",
            "launch:\n- {",
            "not a launch file in XML, YAML or Python (YAML: line 2: ",
        ),
    ],
)
def test_a_mistake_is_reported_with_file_and_line(
    tmp_path: Path, name: str, text: str, expected: str
) -> None:
    with pytest.raises(LaunchFileError) as caught:
        _load(tmp_path, name, text)
    sentence = str(caught.value)
    assert sentence.startswith(str(tmp_path / name))
    assert expected in sentence
    assert "\n" not in sentence


@pytest.mark.parametrize(
    ("inner", "hint"),
    [
        ("<node pkg='p' executable='e'/>", "write exec, not executable"),
        ("<node pkg='p' type='e'/>", "write exec, not type"),
        ("<node package='p' exec='e'/>", "did you mean 'pkg'?"),
        ("<node pkg='p' exec='e' ns='n'/>", "did you mean 'namespace'?"),
        ("<node pkg='p' exec='e' arguments='a'/>", "did you mean 'args'?"),
        ("<node pkg='p' exec='e'><parameters name='a' value='1'/></node>", "did you mean 'param'?"),
        ("<node pkg='p' exec='e'><remap form='a' to='b'/></node>", "write from, not form"),
        ("<arg name='a' value='1'/>", "did you mean 'default'?"),
        ("<nod/>", "did you mean 'node'?"),
        ("<node pkg='p'/>", ""),
    ],
)
def test_a_wrong_name_of_a_tag_or_attribute_is_named(tmp_path: Path, inner: str, hint: str) -> None:
    with pytest.raises(LaunchFileError) as caught:
        _load(tmp_path, "a.launch.xml", f"<launch>{inner}</launch>")
    assert caught.value.hint == hint


@pytest.mark.parametrize(
    "text",
    [
        "<?xml version='1.0'?>\n<launch><arg name='speed'/></launch>",
        "\ufeff<launch><arg name='speed'/></launch>",
        "# a comment\nlaunch:\n- arg: {name: speed}",
        (
            "import launch, launch.actions as actions\n"
            "def generate_launch_description():\n"
            "    return launch.LaunchDescription([actions.DeclareLaunchArgument('speed')])"
        ),
    ],
    ids=["XML", "XML with a mark", "YAML", "Python"],
)
@pytest.mark.parametrize("name", ["a.launch", "a"])
def test_the_content_tells_the_format_if_the_suffix_does_not(
    tmp_path: Path, name: str, text: str
) -> None:
    description = _load(tmp_path, name, text)
    assert [argument.action.name for argument in declared_arguments(description)] == ["speed"]


def test_arguments_of_included_files_are_found(tmp_path: Path) -> None:
    _load(tmp_path, "b.launch.xml", "<launch><arg name='b' default='1'/><arg name='c'/></launch>")
    included = tmp_path / "b.launch.xml"
    description = _load(
        tmp_path,
        "a.launch.xml",
        f"<launch><arg name='a'/><include file='{included}' if='true'>"
        "<arg name='c' value='2'/></include></launch>",
    )
    found = [
        (argument.action.name, argument.conditional) for argument in declared_arguments(description)
    ]
    assert found == [("a", False), ("b", True)]


def test_words_of_the_command_line_are_arguments() -> None:
    assert parse_arguments(["a:=1", "b:=x:=y", "a:=2"]) == {"a": "2", "b": "x:=y"}
    for word in ("a", "a=1", ":=1", "a:="):
        with pytest.raises(LaunchUsageError, match=f"malformed launch argument '{word}'"):
            parse_arguments([word])


@pytest.mark.parametrize(
    ("word", "hint"),
    [
        ("rate=1.5", "write rate:=1.5"),
        ("rate:", "write rate:=VALUE"),
        ("rate:=", "write rate:=VALUE"),
        ("rate", "write rate:=VALUE"),
        (":=1", ""),
    ],
)
def test_a_malformed_argument_says_how_to_write_it(word: str, hint: str) -> None:
    with pytest.raises(LaunchUsageError) as caught:
        parse_arguments([word])
    assert caught.value.hint == hint


def test_a_missing_default_is_reported() -> None:
    argument = DeclareLaunchArgument("speed", description="how fast")
    with pytest.raises(LaunchUsageError, match='"speed" \\(description: "how fast"\\)'):
        argument.execute(LaunchContext())
