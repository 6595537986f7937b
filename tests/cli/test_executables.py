"""Tests of the executables that `zbot run` finds, and of its messages when it finds none."""

from __future__ import annotations

import importlib.metadata
import os
from typing import TYPE_CHECKING

import pytest

from tests.cli.conftest import write_package
from zbot.errors import ZbotError
from zbot.package.setup_file import declared_scripts
from zbot_cli.commands.run.executable_search import find, find_in_package
from zbot_cli.errors import CommandError
from zbot_cli.packages import executables
from zbot_cli.packages.executables import all_packages, bundled_packages, note_of_others

if TYPE_CHECKING:
    from pathlib import Path

    from tests.cli.conftest import Command

DEMO_NODES = "add_two_ints_client, add_two_ints_server, listener, talker"
ENTRY = "entry_points={'console_scripts': ['wave = r.w:main']}"
LESSONS = {"listener", "monitor", "sensor", "student_publisher", "student_subscriber", "talker"}


# -- finding -------------------------------------------------------------------------------------


def test_the_bundled_nodes_are_the_entry_points() -> None:
    points = importlib.metadata.entry_points(group="zbot.nodes")
    declared = {point.name: point.value for point in points}
    found = {executable.name: executable.target for executable in bundled_packages()[0].executables}
    assert found == declared
    assert set(found) >= LESSONS


@pytest.mark.parametrize(
    "words", [["talker"], ["zbot_nodes", "talker"], ["zbot", "talker"], ["demo_nodes_py", "talker"]]
)
@pytest.mark.usefixtures("workspace")
def test_a_bundled_node_has_several_names(words: list[str]) -> None:
    executable, arguments = find([*words, "--ros-args", "-r", "a:=b"])
    assert executable.target == "zbot_nodes.talker:main"
    assert arguments == ["--ros-args", "-r", "a:=b"]


@pytest.mark.usefixtures("workspace")
def test_a_node_without_a_package_may_have_arguments() -> None:
    assert find(["sensor", "fast", "5"])[1] == ["fast", "5"]


def test_a_package_of_the_workspace_is_found_from_inside_it(
    workspace: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    folder = write_package(workspace, "my_robot", drive="my_robot.drive:main")
    monkeypatch.chdir(folder / "my_robot")
    executable, arguments = find(["my_robot", "drive", "x"])
    assert (executable.target, arguments) == ("my_robot.drive:main", ["x"])
    assert executable.folders[0] == str(folder)
    assert find(["drive"])[0] == executable


def test_the_workspace_can_be_named_by_a_variable(
    workspace: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    write_package(workspace, "my_robot", drive="my_robot.drive:main")
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("ZBOT_WORKSPACE", f"{tmp_path / 'nowhere'}{os.pathsep}{workspace}")
    assert find(["drive"])[0].package == "my_robot"


def test_packages_of_a_workspace_can_import_each_other(workspace: Path) -> None:
    first = write_package(workspace, "first", one="first.one:main")
    second = write_package(workspace, "second")
    assert find(["one"])[0].folders == (str(first), str(second))


@pytest.mark.parametrize(
    ("package", "name", "expected"),
    [("second", "two", ["second"]), ("zbot", "talker", []), ("demo_nodes_py", "talker", [])],
)
def test_only_the_build_files_of_the_named_package_are_read(
    workspace: Path,
    monkeypatch: pytest.MonkeyPatch,
    package: str,
    name: str,
    expected: list[str],
) -> None:
    write_package(workspace, "first", one="first.one:main")
    write_package(workspace, "second", two="second.two:main")
    read: list[str] = []

    def recording(folder: Path) -> dict[str, str]:
        read.append(folder.name)
        return declared_scripts(folder)

    monkeypatch.setattr(executables, "declared_scripts", recording)
    assert find([package, name])[0] == find_in_package(package, name)
    assert read == expected * 2


def test_a_new_package_is_found_by_the_same_process(workspace: Path) -> None:
    write_package(workspace, "first", one="first.one:main")
    with pytest.raises(CommandError, match="Package 'second' not found"):
        find_in_package("second", "two")
    write_package(workspace, "second", two="second.two:main")
    assert find_in_package("second", "two").target == "second.two:main"


@pytest.mark.parametrize(
    ("package", "name", "text"),
    [
        ("first", "two", "No executable found"),
        ("one", "two", "Package 'one' not found"),
        ("mapviz", "mapviz", "mapviz does not run here"),
    ],
)
def test_a_launch_finds_programs_only_by_their_package(
    workspace: Path, package: str, name: str, text: str
) -> None:
    write_package(workspace, "first", one="first.one:main")
    with pytest.raises(ZbotError, match=text):
        find_in_package(package, name)


def test_a_layout_with_src_is_known(workspace: Path) -> None:
    folder = workspace / "modern"
    (folder / "src" / "modern").mkdir(parents=True)
    (folder / "src" / "modern" / "__init__.py").touch()
    (folder / "pyproject.toml").write_text('[project.scripts]\nrun_it = "modern:main"\n')
    assert find(["modern", "run_it"])[0].folders[0] == str(folder / "src")


def test_scripts_of_a_package_are_found_with_and_without_py(workspace: Path) -> None:
    folder = write_package(workspace, "my_robot")
    (folder / "scripts").mkdir()
    (folder / "scripts" / "wave.py").touch()
    for name in ("wave", "wave.py"):
        assert find(["my_robot", name])[0].target == str(folder / "scripts" / "wave.py")


def test_an_exact_name_is_used_before_the_name_with_py(workspace: Path) -> None:
    folder = write_package(workspace, "my_robot", wave="my_robot.wave:main")
    (folder / "scripts").mkdir()
    (folder / "scripts" / "wave.py").touch()
    assert find(["my_robot", "wave"])[0].target == "my_robot.wave:main"
    assert find(["wave"])[0].target == "my_robot.wave:main"
    assert find(["my_robot", "wave.py"])[0].target == str(folder / "scripts" / "wave.py")


def test_of_two_packages_with_one_name_the_nearest_is_used(
    workspace: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    write_package(workspace / "one", "my_robot", wave="my_robot.wave:main")
    second = write_package(workspace / "two", "my_robot", wave="my_robot.again:main")
    assert find(["my_robot", "wave"])[0].target == "my_robot.wave:main"
    for place in (second, second.parent, second / "my_robot"):
        monkeypatch.chdir(place)
        assert find(["my_robot", "wave"])[0].target == "my_robot.again:main"
    found = find(["wave"])[0]
    others = found.hidden
    assert note_of_others(found) == (
        f"package 'my_robot' is also in {others[0]}; this is the one in {second}"
    )
    monkeypatch.setenv("ZBOT_COPIES_NOTED", "1")
    assert note_of_others(found) == ""


@pytest.mark.parametrize(
    ("setup", "target"),
    [
        (f"scripts=['bin/wave'], {ENTRY}", "r.w:main"),
        ("scripts=['bin/wave'], data_files=[('lib/r', ['other/wave'])]", "other/wave"),
        (f"{ENTRY}, data_files=[('lib/r', ['other/wave'])]", "other/wave"),
    ],
)
def test_the_program_that_ros_2_installs_last_is_used(
    workspace: Path, setup: str, target: str
) -> None:
    for name in ("bin/wave", "other/wave"):
        (workspace / "r" / name).parent.mkdir(parents=True)
        (workspace / "r" / name).write_text("#!/usr/bin/env python3\n")
    (workspace / "r" / "package.xml").write_text("<package><name>r</name></package>")
    (workspace / "r" / "setup.py").write_text(f"setup(name='r', {setup})")
    found = find(["r", "wave"])[0]
    assert found.target.endswith(target)
    assert note_of_others(found).startswith("package 'r' has two programs 'wave'; as in ROS 2, ")


def test_scripts_of_setup_py_are_programs(workspace: Path) -> None:
    folder = write_package(workspace, "my_robot")
    (folder / "bin").mkdir()
    (folder / "bin" / "wave").write_text("#!/usr/bin/env python3\n")
    (folder / "setup.py").write_text("setup(name='my_robot', scripts=['bin/wave', 'bin/none'])")
    assert find(["my_robot", "wave"])[0].target == str(folder / "bin" / "wave")
    with pytest.raises(CommandError):
        find(["my_robot", "none"])


def test_a_students_node_hides_a_bundled_one_of_the_same_name(workspace: Path) -> None:
    write_package(workspace, "my_robot", talker="my_robot.talker:main")
    assert find(["talker"])[0].package == "my_robot"
    assert find(["zbot_nodes", "talker"])[0].target == "zbot_nodes.talker:main"


def test_two_packages_with_one_name_are_refused(workspace: Path) -> None:
    write_package(workspace, "blue", drive="blue.drive:main")
    write_package(workspace, "red", drive="red.drive:main")
    with pytest.raises(CommandError) as caught:
        find(["drive"])
    assert str(caught.value).splitlines() == [
        "Multiple executables found:",
        "- blue drive (blue.drive:main)",
        "- red drive (red.drive:main)",
    ]
    assert caught.value.hint == "name the package too: zbot run blue drive"


@pytest.mark.usefixtures("workspace")
def test_an_installed_package_is_run_by_its_console_scripts() -> None:
    assert find(["pytest", "pytest"])[0].package == "pytest"


def test_build_and_install_folders_are_not_searched(workspace: Path) -> None:
    write_package(workspace.parent / "install", "my_robot", drive="my_robot.drive:main")
    assert "my_robot" not in {package.name for package in all_packages()}


# -- mistakes ------------------------------------------------------------------------------------


@pytest.mark.usefixtures("workspace")
def test_an_unknown_package_is_refused(zbot_command: Command) -> None:
    result = zbot_command("run", "nopkg", "nope")
    assert (result.code, result.out) == (1, "")
    assert result.err == (
        "Package 'nopkg' not found\n\nhint: `zbot pkg executables` lists the packages with nodes\n"
    )


@pytest.mark.usefixtures("workspace")
def test_an_unknown_executable_is_refused_with_the_known_ones(zbot_command: Command) -> None:
    result = zbot_command("run", "demo_nodes_py", "nope")
    assert result.code == 1
    assert result.err == f"No executable found\n\nhint: demo_nodes_py has {DEMO_NODES}\n"


@pytest.mark.usefixtures("workspace")
def test_a_package_without_an_executable_is_refused(zbot_command: Command) -> None:
    assert f"demo_nodes_py has {DEMO_NODES}" in zbot_command("run", "demo_nodes_py").err


@pytest.mark.parametrize(
    ("words", "hint"),
    [
        (["sensro"], "did you mean 'sensor'?"),
        (["demo_nodes_py", "taker"], "did you mean 'talker'?"),
        (["turtlesim", "turtelsim_node"], "did you mean 'turtlesim_node'?"),
        (["demo_node_py", "talker"], "did you mean 'demo_nodes_py'?"),
        (["nothing_like_it"], "`zbot pkg executables` lists the nodes"),
    ],
)
@pytest.mark.usefixtures("workspace")
def test_the_nearest_name_is_offered(zbot_command: Command, words: list[str], hint: str) -> None:
    result = zbot_command("run", *words)
    assert result.code == 1
    assert f"hint: {hint}" in result.err


def test_a_module_missing_in_setup_py_is_named(workspace: Path, zbot_command: Command) -> None:
    folder = write_package(workspace, "my_robot", drive="my_robot.drive:main")
    (folder / "my_robot" / "turn.py").touch()
    result = zbot_command("run", "my_robot", "turn")
    assert "add 'turn = my_robot.turn:main' to the console_scripts in" in result.err


def test_a_broken_setup_py_is_the_reason(workspace: Path, zbot_command: Command) -> None:
    folder = write_package(workspace, "my_robot")
    (folder / "setup.py").write_text("setup(entry_points={'console_scripts': [)")
    result = zbot_command("run", "my_robot", "drive")
    assert "No executable found\n\nhint: cannot read " in result.err
    assert "setup.py: line 1: " in result.err


@pytest.mark.parametrize(
    ("words", "code", "text"),
    [
        (["nope.py"], 1, "File 'nope.py' not found\n"),
        (["--prefix", "no_such_command -v", "sensor"], 1, "Prefix command 'no_such_command' not"),
        (["--prefix", "nice 'n", "sensor"], 1, 'cannot read --prefix "nice \'n": No closing quo'),
        ([], 2, "name a node to run"),
        (["--prefx", "nice", "sensor"], 2, "No such option: --prefx"),
    ],
)
@pytest.mark.usefixtures("workspace")
def test_other_mistakes_are_refused_with_a_sentence(
    zbot_command: Command, words: list[str], code: int, text: str
) -> None:
    result = zbot_command("run", *words)
    assert (result.code, result.out) == (code, "")
    assert text in result.err


def test_help_shows_the_usage(zbot_command: Command) -> None:
    result = zbot_command("run", "--help")
    assert result.code == 0
    assert result.out.startswith("Usage: zbot run [OPTIONS] [PACKAGE] EXECUTABLE [ARGS]")
