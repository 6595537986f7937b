"""Tests for the advice about mistakes in Python launch files."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest

from zbot.launch import LaunchService
from zbot.launch.errors import LaunchFileError, TemplateError
from zbot.launch.python_file import load
from zbot.launch.source import check_template, load_launch_file

if TYPE_CHECKING:
    from pathlib import Path

_RIGHT = """\
from launch import LaunchDescription, actions, substitutions as subs
from launch_ros.actions import Node

def generate_launch_description():
    return LaunchDescription([Node(package='zbot', executable='talker')])
"""
_NODE = "Node(package='zbot', executable='talker')"
_IMPORT = "from launch_ros.actions import Node"
_ALL = f"LaunchDescription([{_NODE}])"


@pytest.mark.parametrize(
    ("old", "new", "sentence", "hint"),
    [
        ("package=", "pkg=", "Node has no argument 'pkg'", "did you mean 'package'?"),
        ("package=", "pacakge=", "has no argument 'pacakge'", "did you mean 'package'?"),
        ("executable=", "exec=", "missing 1 required", "write executable=..., not exec or type"),
        ("executable=", "node_executable=", "is a name of ROS 2 Foxy", "write executable"),
        ("'talker')", "'talker', arg=['x'])", "argument 'arg'", "did you mean 'arguments'?"),
        ("'talker')", "'talker', args=['x'])", "argument 'args'", "did you mean 'arguments'?"),
        ("'talker')", "'talker', params=[])", "argument 'params'", "did you mean 'parameters'?"),
        ("'talker')", "'talker', remapping=[])", "'remapping'", "did you mean 'remappings'?"),
        ("'talker')", "'talker', node_name='x')", "node_name is a name of ROS 2", "write name"),
        ("'talker')", "'talker', ns='x')", "argument 'ns'", "did you mean 'namespace'?"),
        ("'talker')", "'talker', respwan=True)", "argument 'respwan'", "did you mean 'respawn'?"),
        ("'talker')", "'talker', qqq=1)", "has no argument 'qqq'", ""),
        ("'talker')", "'talker', condition=True)", "condition must be IfCondition(...)", ""),
        (_IMPORT, "from launch.actions import Node", "cannot import", f"write: {_IMPORT}"),
        (_IMPORT, "", "name 'Node' is not defined", f"write: {_IMPORT}"),
        (_IMPORT, "import launch\nNode = launch.actions.Node", "no attribute", f"write: {_IMPORT}"),
        (
            _NODE,
            "Node('zbot', 'talker')",
            "takes 1 positional argument",
            "name the arguments, e.g.",
        ),
        (
            _IMPORT,
            "from launch_ros.actions import ExecuteProcess",
            "cannot import",
            "write: from launch.actions import ExecuteProcess",
        ),
        (_IMPORT, "from launch_ros.actions import Nod", "cannot import", "did you mean 'Node'?"),
        (_IMPORT, "import launch_ros.action", "did you mean 'launch_ros.actions'?", ""),
        (_IMPORT, "import lauch_ros", "No module", "did you mean 'launch_ros'?"),
        (_IMPORT, "import launch_pal.arg_utils", "launch_pal is not here: it is a package of", ""),
        (_IMPORT, "import srdfdom", "srdfdom is not here: it is a package of MoveIt in", ""),
        (_IMPORT, "import urdf_parser_py", "moveit/srdfdom and ros/urdf_parser_py, and type:", ""),
        (_IMPORT, "import launch_mine", "'launch_mine'", "`zbot pkg deps` shows what is missing"),
        (_IMPORT, "from rclpy.node import Node", "unexpected", f"write: {_IMPORT}"),
        ("LaunchDescription([", "LaunchDescripton([", "not defined", "'LaunchDescription'?"),
        ("_description():", "_descripton():", "no function", "rename generate_launch_descripton()"),
        ("generate_launch_description", "main", "no function", "start it with `zbot run`"),
        ("_launch_", "_test_", "no function", "the file is a test: type `zbot test "),
        ("generate_launch_description", "go", "no function", "def generate_launch_description():"),
        ("_description():", "_description(context):", "missing 1", "def generate_launch_descr"),
        (
            _ALL,
            "subs.LaunchConfiguration('a') + 'b'",
            "for +: ",
            "write a list in place of `+`: [Launch",
        ),
        (
            _ALL,
            "'a' + subs.LaunchConfiguration('b')",
            "concatenate",
            "write a list in place of `+`",
        ),
        (
            _ALL,
            "open(subs.LaunchConfiguration('a'))",
            "PathLike",
            "write PathJoinSubstitution([Launch",
        ),
        (
            _ALL,
            "int(subs.LaunchConfiguration('a'))",
            "int() argument",
            "use an OpaqueFunction and its",
        ),
        (_ALL, "__import__('os').environ['NO_X']", "KeyError", "set the environment variable"),
        (
            _ALL,
            "__import__('os').getenv('NO_X').split()",
            "NoneType",
            "set the environment variable",
        ),
        (
            _ALL,
            "'/' + __import__('os').environ.get('NO_X')",
            "NoneType",
            "set the environment variable",
        ),
        (_ALL, "{}['NO_X']", "KeyError: 'NO_X'", ""),
        ("return ", "", "returns nothing: end it with `return LaunchDescription", ""),
        (_ALL, f"[{_NODE}]", "returns a list: write `return LaunchDescription([...])`", ""),
        (_ALL, _NODE, "returns a Node: write `return LaunchDescription([...])`", ""),
        (_ALL, "LaunchDescription", "returns the class itself: write `return", ""),
        (_ALL, f"LaunchDescription({_NODE})", "must be given a list, [...], not Node", ""),
        (
            _ALL,
            f"LaunchDescription([actions.TimerAction(period=1.0, actions={_NODE})])",
            "TimerAction must be given a list, [...], not Node",
            "",
        ),
        (
            _ALL,
            f"LaunchDescription([actions.GroupAction({_NODE})])",
            "GroupAction must be given a list, [...], not Node",
            "",
        ),
        (_ALL, f"LaunchDescription({_NODE}, {_NODE})", "takes from", "put the actions into a list"),
        (_ALL, f"LaunchDescription([[{_NODE}]])", "item 0 of a LaunchDescription must be an", ""),
        (_ALL, "LaunchDescription().add_acton(1)", "no attribute", "did you mean 'add_action'?"),
    ],
)
def test_a_mistake_says_what_to_write(
    tmp_path: Path, old: str, new: str, sentence: str, hint: str
) -> None:
    path = tmp_path / "a.launch.py"
    path.write_text(_RIGHT.replace(old, new))
    with pytest.raises(LaunchFileError) as caught:
        load(path)
    assert sentence in str(caught.value)
    assert hint in caught.value.hint
    assert bool(hint) is bool(caught.value.hint)


def test_the_file_without_a_mistake_is_loaded(tmp_path: Path) -> None:
    path = tmp_path / "a.launch.py"
    path.write_text(_RIGHT)
    assert len(load(path).entities) == 1


@pytest.mark.parametrize(
    ("action", "sentence", "hint"),
    [
        (
            "Node(package='a', node_executable='b', node_name='c', node_namespace='d')",
            "node_executable, node_name and node_namespace are names of ROS 2 Foxy",
            "write executable, name and namespace",
        ),
        (
            "LifecycleNode(package='a', executable='b', node_name='c', node_namespace='d')",
            "node_name and node_namespace are names of ROS 2 Foxy",
            "write name and namespace",
        ),
        (
            "ComposableNode(package='a', node_plugin='b', node_name='c')",
            "node_name and node_plugin are names of ROS 2 Foxy",
            "write name and plugin",
        ),
    ],
)
def test_names_of_ros_2_foxy_are_told_together(
    tmp_path: Path, action: str, sentence: str, hint: str
) -> None:
    path = tmp_path / "a.launch.py"
    imports = "from launch_ros.actions import *\nfrom launch_ros.descriptions import *\n"
    path.write_text(f"{imports}{_RIGHT.replace(_NODE, action)}")
    with pytest.raises(LaunchFileError) as caught:
        load(path)
    assert str(caught.value) == f"{path}:7: {sentence}"
    assert caught.value.hint == hint


def test_a_mistake_in_a_function_is_shown_with_its_own_line(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "a.launch.py"
    path.write_text(
        "from launch import LaunchDescription\n"
        "from launch.actions import OpaqueFunction\n"
        "def set_up(context):\n"
        "    return [Node(package='zbot', executable='talker')]\n"
        "def generate_launch_description():\n"
        "    return LaunchDescription([OpaqueFunction(function=set_up)])\n"
    )
    service = LaunchService()
    service.include_launch_description(load(path))
    assert service.run() == 1
    expected = f"{path}:4: NameError: name 'Node' is not defined (write: {_IMPORT})"
    assert expected in capsys.readouterr().out


@pytest.mark.parametrize("name", ["a.launch.py", "a.launch.xml", "a.launch", "a_launch.yaml"])
def test_a_template_is_no_launch_file(tmp_path: Path, name: str) -> None:
    template = tmp_path / f"{name}.in"
    template.write_text(_RIGHT)
    for path in (tmp_path / name, template):
        with pytest.raises(TemplateError, match=f"{name} does not exist here: CMake makes it"):
            load_launch_file(str(path))
    template.with_suffix("").write_text(_RIGHT.replace("talker", "listener"))
    with pytest.raises(TemplateError):
        load_launch_file(str(template))
    check_template(tmp_path / name)
