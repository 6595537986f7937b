"""Tests for the advice about mistakes in Python launch files."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest

from zbot.launch.errors import LaunchFileError
from zbot.launch.python_file import load

if TYPE_CHECKING:
    from pathlib import Path

_RIGHT = """\
from launch import LaunchDescription
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
        ("executable=", "node_executable=", "missing 1 required", "write executable=..."),
        ("'talker')", "'talker', arg=['x'])", "argument 'arg'", "did you mean 'arguments'?"),
        ("'talker')", "'talker', args=['x'])", "argument 'args'", "did you mean 'arguments'?"),
        ("'talker')", "'talker', params=[])", "argument 'params'", "did you mean 'parameters'?"),
        ("'talker')", "'talker', remapping=[])", "'remapping'", "did you mean 'remappings'?"),
        ("'talker')", "'talker', node_name='x')", "'node_name'", "did you mean 'name'?"),
        ("'talker')", "'talker', ns='x')", "argument 'ns'", "did you mean 'namespace'?"),
        ("'talker')", "'talker', respwan=True)", "argument 'respwan'", "did you mean 'respawn'?"),
        ("'talker')", "'talker', qqq=1)", "has no argument 'qqq'", ""),
        ("'talker')", "'talker', condition=True)", "condition must be IfCondition(...)", ""),
        (_IMPORT, "from launch.actions import Node", "cannot import", f"write: {_IMPORT}"),
        (_IMPORT, "", "name 'Node' is not defined", f"write: {_IMPORT}"),
        (
            _IMPORT,
            "from launch_ros.actions import ExecuteProcess",
            "cannot import",
            "write: from launch.actions import ExecuteProcess",
        ),
        (_IMPORT, "from launch_ros.actions import Nod", "cannot import", "did you mean 'Node'?"),
        (_IMPORT, "import launch_ros.action", "did you mean 'launch_ros.actions'?", ""),
        (_IMPORT, "import lauch_ros", "No module", "did you mean 'launch_ros'?"),
        (_IMPORT, "from rclpy.node import Node", "unexpected", f"write: {_IMPORT}"),
        ("LaunchDescription([", "LaunchDescripton([", "not defined", "'LaunchDescription'?"),
        ("_description():", "_descripton():", "no function", "rename generate_launch_descripton()"),
        ("generate_launch_description", "main", "no function", "start it with `zbot run`"),
        ("generate_launch_description", "go", "no function", "def generate_launch_description():"),
        ("_description():", "_description(context):", "missing 1", "def generate_launch_descr"),
        ("return ", "", "returns nothing: end it with `return LaunchDescription", ""),
        (_ALL, f"[{_NODE}]", "returns a list: write `return LaunchDescription([...])`", ""),
        (_ALL, _NODE, "returns a Node: write `return LaunchDescription([...])`", ""),
        (_ALL, "LaunchDescription", "returns the class itself: write `return", ""),
        (_ALL, f"LaunchDescription({_NODE})", "must be given a list, [...], not Node", ""),
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
