"""Tests of `zbot build`: its options and the messages that it prints."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

import pytest

if TYPE_CHECKING:
    from pathlib import Path

    from tests.cli.conftest import Command, Write


def test_a_correct_workspace_builds(write: Write, zbot_command: Command) -> None:
    write("robot", scripts="'drive = robot.drive:main',", **{"robot/drive.py": "def main(): ..."})
    write("arm", more="<depend>robot</depend>")
    result = zbot_command("build")
    assert (result.code, result.err) == (0, "")
    assert re.sub(r"\d\.\d\d", "0.10", result.out) == (
        "Starting >>> robot\nFinished <<< robot [0.10s]\n"
        "Starting >>> arm\nFinished <<< arm [0.10s]\n\n"
        "Summary: 2 packages finished [0.10s]\n\n"
        "Nothing needs building: zbot runs packages as they are in their folders.\n"
    )


def test_a_package_with_an_error_fails(write: Write, zbot_command: Command) -> None:
    write("robot", scripts="'drive = robot.drive:main',")
    write("arm", **{"arm/lift.py": "import std_msgs"})
    result = zbot_command("build")
    assert result.code == 1
    assert "Failed   <<< robot [0." in result.out
    assert "s, exited with code 1]\n" in result.out
    assert result.out.endswith(
        "  1 package failed: robot\n  2 packages had stderr output: arm robot\n"
    )
    assert result.err == (
        "--- stderr: arm\n"
        "src/arm/arm/lift.py:1: warning: imports std_msgs: add <depend>std_msgs</depend> to "
        "package.xml\n"
        "---\n"
        "--- stderr: robot\n"
        "src/robot/setup.py:13: 'drive' names the module robot.drive, which does not exist\n"
        "---\n"
    )


@pytest.mark.parametrize(
    "words",
    [
        ["--packages-select", "robot"],
        ["--symlink-install", "--packages-select", "robot"],
        ["--packages-select", "robot", "--symlink-install", "--merge-install"],
        ["--packages-select=robot", "--parallel-workers", "2", "--event-handlers", "a+", "b-"],
        ["--cmake-args", "-DCMAKE_BUILD_TYPE=Release", "-G", "Ninja", "--packages-select", "robot"],
        ["--packages-skip", "arm", "other"],
        ["--packages-up-to", "robot"],
        ["--base-paths", "src/robot", "--install-base=/tmp/x", "--executor", "sequential"],
    ],
)
def test_options_of_colcon_are_accepted(
    write: Write, zbot_command: Command, words: list[str]
) -> None:
    for name in ("robot", "arm", "other"):
        write(name)
    result = zbot_command("build", *words)
    assert (result.code, result.err) == (0, "")
    assert re.findall(">>> (.*)", result.out) == ["robot"]


def test_dependencies_are_built_first(write: Write, zbot_command: Command) -> None:
    write("a", more="<depend>c</depend><exec_depend>std_msgs</exec_depend>")
    write("b")
    write("c", more="<test_depend>d</test_depend>")
    write("d")
    result = zbot_command("build", "--packages-up-to", "a", "b", "--packages-skip", "b")
    assert re.findall(">>> (.*)", result.out) == ["d", "c", "a"]


def test_an_empty_workspace_is_reported(workspace: Path, zbot_command: Command) -> None:
    result = zbot_command("build")
    assert result.code == 0
    assert result.out.startswith("\nSummary: 0 packages finished [0.")
    assert result.err == "\nhint: put the packages of a workspace into its folder src\n"
    assert list(workspace.iterdir()) == []


@pytest.mark.parametrize(
    ("words", "code", "text"),
    [
        (["--packages-select", "nope"], 1, "unknown package 'nope' in --packages-select\n"),
        (["--packages-up-to", "robt", "x"], 1, "unknown packages 'robt', 'x' in --packages-up-to"),
        (["--packages-select", "robt"], 1, "hint: did you mean 'robot'?"),
        (["--packages-selct", "robot"], 2, "No such option: --packages-selct"),
        (["robot"], 2, "unexpected extra argument"),
    ],
)
def test_mistakes_are_refused_with_a_sentence(
    write: Write, zbot_command: Command, words: list[str], code: int, text: str
) -> None:
    write()
    result = zbot_command("build", *words)
    assert (result.code, result.out) == (code, "")
    assert text in result.err


def test_packages_of_the_same_name_are_refused(write: Write, zbot_command: Command) -> None:
    first = write()
    second = write("copy", **{"package.xml": (first / "package.xml").read_text()})
    result = zbot_command("build")
    assert (result.code, result.out) == (1, "")
    assert result.err == (
        f"Duplicate package names not supported:\n- robot:\n  - {second}\n  - {first}\n"
    )


def test_circular_dependencies_are_refused(write: Write, zbot_command: Command) -> None:
    write("a", more="<depend>b</depend>")
    write("b", more="<depend>a</depend>")
    result = zbot_command("build")
    assert result.code == 1
    assert result.err == "packages depend on each other in a circle: a -> b -> a\n"


def test_ignored_folders_are_not_searched(write: Write, zbot_command: Command) -> None:
    (write("a") / "COLCON_IGNORE").touch()
    (write("b") / "AMENT_IGNORE").touch()
    assert "Summary: 0 packages" in zbot_command("build").out


def test_a_repository_folder_is_not_a_package(write: Write, zbot_command: Command) -> None:
    folder = write("repository/robot")
    (folder.parent / "pyproject.toml").write_text("[tool.ruff]\n")
    (folder.parent / "setup.cfg").write_text("[flake8]\n")
    assert ">>> repository/robot\n" not in zbot_command("build").out
    assert "1 package" in zbot_command("build").out
