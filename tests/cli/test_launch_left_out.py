"""Tests of launch files with programs that cannot run in zbot: they are named and left out."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest

from tests.cli.conftest import write_package
from zbot.launch.zbot_command import find_on_path
from zbot.package import PackageNotFoundError, package_share
from zbot.package.bundled_nodes import BUNDLED_NODES
from zbot.package.unavailable import _BY_PACKAGE, _BY_PROGRAM, _PACKAGES

if TYPE_CHECKING:
    from collections.abc import Callable
    from pathlib import Path

    from tests.cli.conftest import Command
    from tests.conftest import Program, Start

    Launch = Callable[..., Program]

_IMPORTS = """
import sys
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import *
from launch.event_handlers import *
from launch.substitutions import *
from launch_ros.actions import *
from launch_ros.descriptions import ComposableNode
from launch_ros.substitutions import FindPackageShare
gazebo = Node(package="gazebo_ros", executable="spawn_entity.py", name="spawn")
done = ExecuteProcess(cmd=[sys.executable, "-c", "print('still here')"])
def generate_launch_description():
    return LaunchDescription([
"""
RVIZ = "Node(package='rviz2', executable='rviz2', arguments=['-d', FindPackageShare('nowhere')])"
SENTENCE = (
    "[WARNING] [launch]: rviz2 is left out: it is a 3D viewer in C++, which does not run here; "
    "`zbot web` shows topics, images, plots and the graph, and `zbot foxglove` serves 3D viewers"
)
WORLD = "PathJoinSubstitution([FindPackageShare('ros_gz_sim'), 'launch', 'gz_sim.launch.py'])"
INCLUDE = f"IncludeLaunchDescription({WORLD}, launch_arguments={{'gz_args': '-r'}}.items())"


@pytest.fixture
def launch(tmp_path: Path, start: Start, monkeypatch: pytest.MonkeyPatch) -> Launch:
    """Return a function that launches the given arguments of a LaunchDescription."""
    monkeypatch.setenv("ZBOT_LOG_DIR", str(tmp_path / "log"))

    def run(actions: str, *words: str) -> Program:
        file = tmp_path / "a.launch.py"
        file.write_text(f"{_IMPORTS}{actions}\n])\n", encoding="utf-8")
        return start("zbot", "launch", str(file), *words)

    return run


def test_a_known_program_is_named_once_and_the_launch_goes_on(launch: Launch) -> None:
    program = launch(f"{RVIZ}, {RVIZ}, done")
    assert program.wait() == 0
    assert program.output.count(SENTENCE) == 1
    assert "still here" in program.output
    assert "nodes with the name" not in program.output


def test_strict_fails_at_the_first_one(launch: Launch) -> None:
    program = launch(f"{RVIZ}, done", "--strict")
    assert program.wait() == 1
    assert "a.launch.py:15: rviz2 does not run here: it is a 3D viewer" in program.output
    assert "still here" not in program.output


def test_a_launch_file_of_a_known_package_is_left_out(launch: Launch) -> None:
    program = launch(f"{INCLUDE}, done")
    assert program.wait() == 0
    assert "ros_gz_sim is left out: it is a simulator in C++" in program.output
    assert "still here" in program.output


def test_a_known_command_is_left_out(launch: Launch) -> None:
    if find_on_path("gzserver", {}) is not None:
        pytest.skip("this machine has Gazebo")
    program = launch("ExecuteProcess(cmd=['gzserver', '-s', 'world']), done")
    assert program.wait() == 0
    assert "gzserver is left out: it is a simulator in C++" in program.output
    assert "still here" in program.output


def test_what_waits_for_the_end_of_a_short_program_goes_on(launch: Launch) -> None:
    waiting = "RegisterEventHandler(OnProcessExit(target_action=gazebo, on_exit=[done]))"
    program = launch(f"{waiting}, gazebo")
    assert program.wait() == 0
    assert "gazebo_ros is left out" in program.output
    assert "still here" in program.output


def test_what_waits_for_the_end_of_a_viewer_does_not_run(launch: Launch) -> None:
    viewer = "rviz := Node(package='rviz2', executable='rviz2', on_exit=Shutdown())"
    waiting = "RegisterEventHandler(OnProcessExit(target_action=rviz, on_exit=[done]))"
    program = launch(f"{viewer}, {waiting}")
    assert program.wait() == 0
    assert "still here" not in program.output


def test_a_managed_node_that_cannot_run_is_left_out(launch: Launch) -> None:
    driver = "package='urg_node', executable='urg_node', name='urg', namespace='', autostart=True"
    program = launch(f"LifecycleNode({driver}), done")
    assert program.wait() == 0
    assert "urg_node is left out: it is a compiled driver of a laser scanner" in program.output


def test_a_cpp_program_of_the_workspace_is_left_out(
    launch: Launch, workspace: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    folder = write_package(workspace, "my_robot")
    (folder / "setup.py").unlink()
    (folder / "CMakeLists.txt").write_text(
        "project(my_robot)\nadd_executable(drive drive.cpp)\n"
        "install(TARGETS drive DESTINATION lib/${PROJECT_NAME})\n"
    )
    monkeypatch.setenv("ZBOT_WORKSPACE", str(workspace))
    program = launch("Node(package='my_robot', executable='drive'), done")
    assert program.wait() == 0
    assert "drive of package my_robot is left out: it is a C++ program" in program.output
    assert "still here" in program.output


def test_strict_fails_for_components_too(launch: Launch) -> None:
    components = "[ComposableNode(package='a', plugin='a::B')]"
    container = f"name='box', composable_node_descriptions={components}"
    options = f"ComposableNodeContainer(namespace='', package='c', executable='d', {container})"
    program = launch(f"{options}, done", "--strict")
    assert program.wait() == 1
    assert "the container 'box' of a::B does not run here: it is a C++ library" in program.output
    assert "still here" not in program.output


def test_a_typo_still_ends_the_launch(launch: Launch) -> None:
    program = launch("Node(package='rviz3', executable='rviz3'), done")
    assert program.wait() == 1
    assert "Package 'rviz3' not found" in program.output


def test_a_share_directory_that_a_file_asks_for_is_named_with_what_to_do(launch: Launch) -> None:
    program = launch("Node(package='a', executable=get_package_share_directory('ros_gz_sim'))")
    assert program.wait() == 1
    assert (
        "(ros_gz_sim is a simulator in C++, which does not run here: write "
        "FindPackageShare('ros_gz_sim') in place of get_package_share_directory, and the launch "
        "goes on without it)"
    ) in program.output


@pytest.mark.usefixtures("workspace")
def test_run_says_the_same_sentence(zbot_command: Command) -> None:
    result = zbot_command("run", "rviz2", "rviz2")
    assert (result.code, result.out) == (1, "")
    assert "rviz2 does not run here: it is a 3D viewer in C++; `zbot web` shows" in result.err


def test_the_table_names_each_package_once_and_no_package_of_zbot() -> None:
    names = [name for _, text in _PACKAGES for name in text.split()]
    assert len(names) == len(set(names))
    assert not set(names) & set(BUNDLED_NODES)
    for kind in {*_BY_PACKAGE.values(), *_BY_PROGRAM.values()}:
        assert not kind.what.endswith(".")
        assert not kind.instead.endswith(".")
    with pytest.raises(PackageNotFoundError):
        package_share("rviz2")
