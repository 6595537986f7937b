"""Tests of the programs that start and end controllers."""

from __future__ import annotations

import signal
from typing import TYPE_CHECKING

from tests.nodes.test_control import ARM, DRIVE, URDF
from zbot_nodes.control.spawner import read_arguments

if TYPE_CHECKING:
    from pathlib import Path

    from tests.conftest import Start


def test_a_spawner_activates_controllers_of_a_file(start: Start, tmp_path: Path) -> None:
    (tmp_path / "robot.yaml").write_text(
        "controller_manager:\n  ros__parameters:\n    update_rate: 50\n"
        "    joints: {type: joint_state_broadcaster/JointStateBroadcaster}\n"
        "    base: {type: diff_drive_controller/DiffDriveController}\n"
        "base:\n  ros__parameters:\n"
        + "".join(f"    {name}: {value}\n" for name, value in DRIVE.items())
    )
    (tmp_path / "arm.yaml").write_text(
        "/**/arm:\n  ros__parameters:\n"
        "    type: joint_trajectory_controller/JointTrajectoryController\n"
        + "".join(f"    {name}: {value}\n" for name, value in ARM.items())
    )
    (tmp_path / "robot.urdf").write_text(URDF)
    run = ("zbot", "run", "controller_manager")
    manager = start(*run, "ros2_control_node", "--ros-args", "--params-file", "robot.yaml")
    manager.wait_for("Waiting for data on 'robot_description' topic")
    start("zbot", "run", "robot_state_publisher", "robot_state_publisher", "robot.urdf")
    spawner = start(*run, "spawner", "joints", "base")
    spawner.wait_for("Configured and activated base", 20)
    assert spawner.wait() == 0
    arm = start(*run, "spawner", "arm", "--param-file", "arm.yaml", "--inactive")
    arm.wait_for("Loaded arm")
    assert arm.wait() == 0
    start("zbot", "topic", "echo", "--once", "/joint_states").wait_for("- elbow")
    failing = start(*run, "spawner", "nothing")
    failing.wait_for("error: Failed loading controller nothing: the manager's log has the reason")
    assert failing.wait() == 1
    ending = start(*run, "unspawner", "base")
    ending.wait_for("Unloaded base")
    assert ending.wait() == 0
    staying = start(*run, "spawner", "base", "--unload-on-kill")
    staying.wait_for("Waiting until interrupt to unload controllers")
    assert staying.stop(signal.SIGTERM) == 0
    assert "Unloaded base" in staying.output


def test_a_spawner_takes_parameters_of_the_launch_file(tmp_path: Path) -> None:
    path = tmp_path / "launch_params.yaml"
    path.write_text("arm:\n  ros__parameters: {type: a/B}\n")
    words = ["arm", "--inactive", "--ros-args", "-p", "a:=1", "--params-file", str(path)]
    options = read_arguments(words)
    (arm,) = options.controllers
    assert (arm.name, arm.inactive, arm.param_file) == ("arm", True, [str(path)])


def test_a_spawner_takes_empty_words_of_a_launch_file() -> None:
    options = read_arguments(["arm", "", "--namespace", "", "-c", "/cm"])
    assert (options.namespace, options.controller_manager) == ("", "/cm")
    assert [controller.name for controller in options.controllers] == ["arm"]


def test_each_controller_of_a_spawner_has_options_of_its_own(tmp_path: Path) -> None:
    path = tmp_path / "arm.yaml"
    path.write_text("")
    words = ["-c", "/cm", "--controller", "arm", "-p", str(path), "--switch-timeout", "3", ""]
    options = read_arguments([*words, "--controller", "grip", "--inactive", "--load-only"])
    assert (options.controller_manager, options.switch_timeout) == ("/cm", 3.0)
    found = [
        (controller.name, controller.param_file, controller.inactive, controller.load_only)
        for controller in options.controllers
    ]
    assert found == [("arm", [str(path)], False, False), ("grip", [], True, True)]


def test_controllers_of_a_namespace_have_their_own_names(start: Start, tmp_path: Path) -> None:
    (tmp_path / "robot.yaml").write_text(
        "/**/manager:\n  ros__parameters:\n"
        "    base: {type: diff_drive_controller/DiffDriveController}\n"
        "/**/base:\n  ros__parameters:\n"
        + "".join(f"    {name}: {value}\n" for name, value in DRIVE.items())
    )
    (tmp_path / "robot.urdf").write_text(URDF)
    run = ("zbot", "run", "controller_manager")
    names = ("-r", "__ns:=/r1", "-r", "__node:=manager", "-r", "base/cmd_vel:=cmd_vel")
    start(*run, "ros2_control_node", "--ros-args", *names, "--params-file", "robot.yaml")
    words = ("--ros-args", "-r", "__ns:=/r1")
    start("zbot", "run", "robot_state_publisher", "robot_state_publisher", "robot.urdf", *words)
    spawner = start(*run, "spawner", "base", "-c", "/r1/manager")
    spawner.wait_for("Configured and activated base", 20)
    echo = start("zbot", "topic", "echo", "--once", "/r1/base/odom")
    echo.wait_for("frame_id: r1/odom")
    start("zbot", "topic", "info", "/r1/cmd_vel").wait_for("Subscription count: 1")


def test_a_spawner_says_what_it_waits_for(start: Start) -> None:
    words = ("zbot", "run", "controller_manager", "spawner", "a")
    program = start(*words, "--controller-manager-timeout", "1")
    program.wait_for("error: Could not contact service /controller_manager/list_controllers in 1")
    assert program.wait() == 1
    program = start(*words, "-p", "none.yaml")
    program.wait_for("the file 'none.yaml' of --param-file does not exist")
    assert program.wait() == 2
