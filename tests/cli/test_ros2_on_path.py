"""Tests of the command `ros2` in programs that zbot has started: it is zbot."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING

import pytest

from tests.cli.command import zbot
from zbot.package import zbot_command
from zbot.package.ros_variables import set_ros_variables

if TYPE_CHECKING:
    from pathlib import Path

CALL = "import os, subprocess, sys\nsubprocess.run('ros2 --help', shell=True, check=True)\n"
CALLS = {
    "shell": CALL,
    "system": "import os\nos.system('ros2 --help')\n",
    "words": "import subprocess\nsubprocess.run(['ros2', '--help'], check=True)\n",
}
LAUNCH = """
import os
from launch import LaunchDescription
from launch.actions import ExecuteProcess, OpaqueFunction
def call(context):
    os.system("ros2 --help")
def generate_launch_description():
    return LaunchDescription([ACTION])
"""
ACTIONS = {
    "words": "ExecuteProcess(cmd=['ros2', '--help'], output='screen')",
    "shell": "ExecuteProcess(cmd=['ros2 --help'], shell=True, output='screen')",
    "function": "OpaqueFunction(function=call)",
    "script": "ExecuteProcess(cmd=['python3', 'call.py'], output='screen')",
}


@pytest.mark.parametrize("name", CALLS)
def test_a_program_finds_ros2(tmp_path: Path, name: str) -> None:
    (tmp_path / "call.py").write_text(CALLS[name])
    result = zbot("run", "call.py", cwd=tmp_path)
    assert result.code == 0, result.err
    assert "Usage: zbot" in result.out


@pytest.mark.parametrize("name", ACTIONS)
def test_a_launch_file_finds_ros2(tmp_path: Path, name: str) -> None:
    (tmp_path / "call.py").write_text(CALL)
    (tmp_path / "a.launch.py").write_text(LAUNCH.replace("ACTION", ACTIONS[name]))
    result = zbot("launch", "a.launch.py", cwd=tmp_path)
    assert result.code == 0, result.err
    assert "Usage: zbot" in result.out


def test_a_test_finds_ros2(tmp_path: Path) -> None:
    (tmp_path / "test_call.py").write_text(
        f"def test_call():\n    {CALL}".replace("\nsub", "\n    sub")
    )
    result = zbot("test", "test_call.py", cwd=tmp_path)
    assert result.code == 0, result.out


def test_an_installed_ros2_stays(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    for name in ("ros2", "zbot", "xacro"):
        (tmp_path / name).touch(mode=0o755)
    monkeypatch.setenv("PATH", str(tmp_path))
    set_ros_variables()
    assert zbot_command.find_on_path("ros2", {"PATH": str(tmp_path)}) == str(tmp_path / "ros2")


def test_a_folder_that_cannot_be_written_is_no_error(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "file").touch()
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "file"))
    monkeypatch.setenv("LOCALAPPDATA", str(tmp_path / "file"))
    monkeypatch.setattr(zbot_command, "cache_folder", lambda: tmp_path / "file")
    monkeypatch.setenv("PATH", str(tmp_path))
    set_ros_variables()


def test_the_folders_of_gazebo_can_be_extended(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("GZ_SIM_RESOURCE_PATH", raising=False)
    monkeypatch.setenv("GAZEBO_MODEL_PATH", "/models")
    set_ros_variables()
    assert os.environ["GZ_SIM_RESOURCE_PATH"] == ""
    assert os.environ["GAZEBO_MODEL_PATH"] == "/models"
