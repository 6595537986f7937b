"""Tests of `zbot build`: its options and the messages that it prints."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
from typing import TYPE_CHECKING

import pytest

from tests.cli.command import zbot
from tests.cli.conftest import MANIFEST
from zbot_cli.packages.setup_scripts import source_line

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
        f"To use the packages from every folder, type: {source_line()}\n"
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


def test_an_empty_workspace_has_a_script_to_source(
    workspace: Path, zbot_command: Command, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(workspace.parent)
    result = zbot_command("build")
    assert result.code == 0
    assert result.err == "\nhint: put the packages of a workspace into its folder src\n"
    assert (workspace.parent / "install" / "setup.bash").is_file()


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


def test_a_build_outside_of_a_workspace_searches_all_levels(
    tmp_path: Path, zbot_command: Command, monkeypatch: pytest.MonkeyPatch
) -> None:
    folder = tmp_path / "repository" / "drivers" / "arm"
    folder.mkdir(parents=True)
    (folder / "package.xml").write_text(MANIFEST.format(name="arm", more="", build_type="cmake"))
    (folder / "CMakeLists.txt").write_text("project(arm)\n")
    monkeypatch.chdir(tmp_path / "repository")
    assert "Finished <<< arm" in zbot_command("build").out
    assert (tmp_path / "repository" / "install" / "setup.bash").is_file()
    monkeypatch.setenv("ZBOT_WORKSPACE", str(tmp_path / "repository"))
    monkeypatch.chdir(tmp_path)
    assert "arm" in zbot_command("pkg", "list").out.split()


# -- install/setup.bash ----------------------------------------------------------------------------


@pytest.mark.parametrize("shell", ["bash", "sh", "zsh"])
@pytest.mark.parametrize("script", ["setup", "local_setup"])
def test_a_sourced_workspace_is_known_in_every_folder(
    write: Write, zbot_command: Command, workspace: Path, shell: str, script: str
) -> None:
    write("robot")
    assert zbot_command("build").code == 0
    program = shutil.which(shell)
    if program is None:
        pytest.skip(f"there is no {shell}")
    file = workspace.parent / "install" / f"{script}.{shell}"
    lines = f". '{file}'; . '{file}'; cd /; printf %s \"$ZBOT_WORKSPACE\""
    env = {**os.environ, "ZBOT_WORKSPACE": "/other"}
    done = subprocess.run(
        [program, "-euc", lines], env=env, capture_output=True, text=True, check=False
    )
    assert (done.stdout, done.stderr) == (f"{workspace}:/other", "")


def test_a_path_with_an_apostrophe_is_quoted(
    tmp_path: Path, zbot_command: Command, monkeypatch: pytest.MonkeyPatch
) -> None:
    folder = tmp_path / "Ann's robots"
    (folder / "src" / "arm").mkdir(parents=True)
    (folder / "src" / "arm" / "package.xml").write_text("<package><name>arm</name></package>")
    monkeypatch.chdir(folder)
    zbot_command("build")
    done = subprocess.run(
        ["sh", "-c", '. install/setup.sh; printf %s "$ZBOT_WORKSPACE"'],
        capture_output=True,
        text=True,
        check=True,
    )
    assert done.stdout == str(folder / "src")


def test_the_install_folder_of_a_real_colcon_is_left_alone(
    write: Write, zbot_command: Command, workspace: Path
) -> None:
    write("robot")
    install = workspace.parent / "install"
    install.mkdir()
    (install / "setup.bash").write_text("# generated from colcon_bash\n")
    assert "source" not in zbot_command("build").out
    assert [file.name for file in install.iterdir()] == ["setup.bash"]


def test_a_workspace_is_built_where_another_one_is_sourced(
    write: Write, zbot_command: Command, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    write("robot")
    monkeypatch.setenv("ZBOT_WORKSPACE", str(tmp_path / "other"))
    assert "Finished <<< robot" in zbot_command("build").out
    assert "robot" in zbot_command("pkg", "list").out.split()


def test_a_workspace_is_known_after_pkg_create(
    zbot_command: Command, workspace: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(workspace)
    zbot_command("pkg", "create", "arm", "--node-name", "lift")
    monkeypatch.chdir(tmp_path)
    assert f"it is in the workspace {workspace.parent}" in zbot("run", "arm", "lift").err


@pytest.mark.parametrize(
    "words", [["run", "robot", "drive"], ["pkg", "prefix", "robot"], ["launch", "robot", "x.py"]]
)
def test_an_error_names_the_workspace_that_has_the_package(
    write: Write, zbot_command: Command, workspace: Path, tmp_path: Path, words: list[str]
) -> None:
    write("robot", scripts="'drive = robot.drive:main',", **{"robot/drive.py": "def main(): ..."})
    zbot_command("build")
    elsewhere = tmp_path / "elsewhere"
    elsewhere.mkdir()
    result = zbot(*words, cwd=elsewhere)
    assert result.code == 1
    assert f"hint: it is in the workspace {workspace.parent}: go to that folder" in result.err


def test_tests_import_the_packages_of_the_workspace(write: Write) -> None:
    modules = {"src/robot/__init__.py": "", "src/robot/arm.py": "LENGTH = 2"}
    write("robot", **modules)
    test = "from robot.arm import LENGTH\n\ndef test_it(): assert LENGTH == 2\n"
    other = write("other", **{"test/test_arm.py": test})
    done = zbot("test", str(other / "test"), cwd=other.parents[1])
    assert "1 passed" in done.out, done.out


def test_zbot_test_runs_the_tests_of_selected_packages(write: Write) -> None:
    write("robot", **{"test/test_arm.py": "def test_it(): ..."})
    other = write("other", **{"test/test_leg.py": "def test_it(): raise ValueError"})
    done = zbot("test", "--packages-select", "robot", cwd=other.parents[1])
    assert done.code == 0
    assert "1 passed" in done.out
    done = zbot("test", "--packages-select", "robt", cwd=other.parents[1])
    assert (done.code, done.out) == (1, "")
    assert "did you mean 'robot'?" in done.err


def test_an_error_names_the_folder_of_a_package_far_below(tmp_path: Path) -> None:
    folder = tmp_path / "course" / "week" / "arm"
    folder.mkdir(parents=True)
    (folder / "package.xml").write_text("<package><name>arm</name></package>")
    result = zbot("run", "arm", "lift", cwd=tmp_path)
    assert result.code == 1
    assert f"it is in {folder}: go to the folder {folder.parent}" in result.err
