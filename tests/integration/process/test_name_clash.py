"""A file of the program that has the name of a module is named in one sentence."""

from __future__ import annotations

import subprocess
import sys
from typing import TYPE_CHECKING

import pytest

if TYPE_CHECKING:
    from pathlib import Path

PROGRAM = "import rclpy.node\nfrom std_msgs.msg import String\nprint(rclpy.ok(), String.__name__)\n"


def run(program: Path) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, program.name]
    return subprocess.run(
        command, cwd=program.parent, capture_output=True, text=True, timeout=30, check=False
    )


@pytest.mark.parametrize("name", ["queue", "typing", "rclpy", "std_msgs", "zbot", "zenoh"])
def test_a_program_with_the_name_of_a_module_runs(tmp_path: Path, name: str) -> None:
    program = tmp_path / f"{name}.py"
    program.write_text(PROGRAM)
    done = run(program)
    assert (done.returncode, done.stdout) == (0, "False String\n"), done.stderr
    assert done.stderr.startswith(f"the file {program} hides ")
    assert done.stderr.endswith(f" {name}: rename it\n")
    assert done.stderr.count("\n") == 1


@pytest.mark.parametrize("name", ["queue", "threading", "rclpy", "std_msgs", "msgpack"])
def test_a_file_with_the_name_of_a_module_is_named_first(tmp_path: Path, name: str) -> None:
    program = tmp_path / "program.py"
    program.write_text(PROGRAM)
    (tmp_path / f"{name}.py").write_text("")
    done = run(program)
    first = done.stderr.partition("\n")[0]
    assert first.startswith(f"the file {tmp_path / name}.py hides ")
    assert first.endswith(f" {name}: rename it")


def test_a_file_that_was_imported_before_is_named(tmp_path: Path) -> None:
    (tmp_path / "colorsys.py").write_text("")
    program = tmp_path / "program.py"
    program.write_text(f"import colorsys\n{PROGRAM}")
    hides = f"the file {tmp_path / 'colorsys.py'} hides Python's module colorsys: rename it\n"
    done = run(program)
    assert (done.returncode, done.stderr) == (0, hides)


@pytest.mark.parametrize("line", ["import json", "import rclpy"])
def test_files_that_nobody_imports_are_not_named(tmp_path: Path, line: str) -> None:
    for name in ("colorsys.py", "turtle.py", "test.py", "launch", "my_msgs.py"):
        (tmp_path / name).touch()
    program = tmp_path / "program.py"
    program.write_text(line)
    done = run(program)
    assert (done.returncode, done.stderr) == (0, "")


def test_a_program_without_zbot_is_left_alone(tmp_path: Path) -> None:
    (tmp_path / "colorsys.py").write_text("")
    program = tmp_path / "program.py"
    program.write_text("import colorsys")
    assert run(program).stderr == ""
