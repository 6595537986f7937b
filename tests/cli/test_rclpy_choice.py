"""Tests of `zbot run`, `launch` and `test` in a Python that also has a genuine rclpy."""

from __future__ import annotations

import os
import sys
from pathlib import Path

import pytest

from tests.cli.command import zbot
from zbot.package.rclpy_choice import genuine_rclpy

PROGRAM = "import rclpy; print(getattr(rclpy, 'whose', 'zbot'), flush=True)\n"
LAUNCH = """\
import sys
from launch import LaunchDescription
from launch.actions import ExecuteProcess

def generate_launch_description():
    command = [sys.executable, "program.py"]
    return LaunchDescription([ExecuteProcess(cmd=command, output="screen")])
"""
TEST = "import rclpy\ndef test_whose():\n    assert not hasattr(rclpy, 'whose')\n"


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Return a folder with programs. Python finds another rclpy than zbot's."""
    other = tmp_path / "other" / "rclpy"
    other.mkdir(parents=True)
    (other / "__init__.py").write_text("whose = 'genuine'\n")
    monkeypatch.setenv("PYTHONPATH", os.pathsep.join([str(other.parent), os.environ["PYTHONPATH"]]))
    monkeypatch.delenv("ZBOT_RCLPY", raising=False)
    (tmp_path / "program.py").write_text(PROGRAM)
    (tmp_path / "two.launch.py").write_text(LAUNCH)
    (tmp_path / "test_whose.py").write_text(TEST)
    return tmp_path


def test_a_program_runs_on_zbot_and_one_line_says_so(folder: Path) -> None:
    done = zbot("run", "program.py", cwd=folder)
    assert done.out == "zbot\n"
    assert done.err == (
        "note: programs use zbot's rclpy, not the genuine one in "
        f"{folder / 'other' / 'rclpy'}: `--genuine` chooses that one\n"
    )


def test_the_genuine_one_can_be_chosen(folder: Path) -> None:
    done = zbot("run", "--genuine", "program.py", cwd=folder)
    assert (done.out, done.err) == ("genuine\n", "")


@pytest.mark.parametrize(("options", "whose"), [([], "zbot"), (["--genuine"], "genuine")])
def test_the_processes_of_a_launch_use_the_same(
    folder: Path, options: list[str], whose: str
) -> None:
    done = zbot("launch", *options, "two.launch.py", cwd=folder)
    assert f"[{Path(sys.executable).name.partition('.')[0]}-1] {whose}\n" in done.out
    assert done.err.count("not the genuine one") == int(not options)


def test_tests_run_on_zbot(folder: Path) -> None:
    assert zbot("test", "test_whose.py", cwd=folder).code == 0
    assert zbot("test", "--genuine", "test_whose.py", cwd=folder).code == 1


@pytest.mark.skipif(genuine_rclpy() is not None, reason="this Python has a genuine rclpy")
def test_without_a_genuine_one_the_option_is_an_error(tmp_path: Path) -> None:
    (tmp_path / "program.py").write_text(PROGRAM)
    done = zbot("run", "--genuine", "program.py", cwd=tmp_path)
    assert done.code == 1
    assert done.err.startswith("this Python has no genuine rclpy: ")


def test_bundled_nodes_say_nothing(folder: Path) -> None:
    assert zbot("run", "--where", "sensor", cwd=folder).err == ""


def test_a_launch_inside_a_program_of_a_workspace(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The program's variables name the workspace, so each import may be of one of its packages."""
    monkeypatch.setenv("ZBOT_RCLPY", "zbot")
    monkeypatch.setenv("ZBOT_WORKSPACE", str(folder))
    done = zbot("launch", "two.launch.py", cwd=folder)
    assert "-1] zbot\n" in done.out
    assert "Traceback" not in done.err
