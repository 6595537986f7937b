"""The student's hour of docs/robot.md, with the genuine rclpy in place of the robot."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from tests.conftest import wait_until
from tests.integration.bridge.conftest import PYTHON, genuine_environment, needs_ros2

if TYPE_CHECKING:
    from collections.abc import Callable

    from tests.classroom.machine import Machine
    from tests.classroom.testbed import LanTestbed
    from tests.conftest import Program

pytestmark = needs_ros2()

ROBOT = Path(__file__).parents[1] / "programs" / "remote" / "genuine_robot.py"
ANA, BEN = 17, 18
DRIVE = ("topic", "pub", "-r", "10", "/class/robot/cmd_vel", "geometry_msgs/msg/Twist")
#: Time in which a driver sends ten messages.
SILENCE_S = 1.0


def genuine(machine: Machine, *words: str) -> Program:
    """Start a program with the Python that has the genuine rclpy."""
    local = {"ROS_AUTOMATIC_DISCOVERY_RANGE": "LOCALHOST"}
    return machine.start(str(PYTHON), "-u", *words, env=local)


def test_a_lesson_with_a_robot(make_testbed: Callable[[int], LanTestbed]) -> None:
    assert genuine_environment(0)["ROS_AUTOMATIC_DISCOVERY_RANGE"] == "LOCALHOST"
    testbed = make_testbed(2)
    teacher, (ana, ben) = testbed.teacher, testbed.laptops
    robot = genuine(teacher, str(ROBOT))
    robot.wait_for("the robot is on")

    # The teacher opens the class.
    opening = genuine(teacher, "-m", "zbot_cli", "class", "start", "Robots", "--robot", "dds")
    opening.wait_for("The robot is in /class/robot/")
    assert opening.wait(30) == 0, opening.output

    # The students join and look at the robot.
    for machine, number, name in ((ana, ANA, "Ana"), (ben, BEN, "Ben")):
        words = ("zbot", "join", teacher.address, "--number", str(number), "--name", name)
        assert machine.run(*words).code == 0
    echoed = ana.run("zbot", "topic", "echo", "/class/robot/battery", "--once", "--timeout", "20")
    assert "percentage: 0.75" in echoed.out, echoed.err
    assert wait_until(lambda: "/class/robot/base" in ana.run("zbot", "node", "list").out, 20)

    # Both drive, but nobody may.
    ana.start("zbot", *DRIVE, "{linear: {x: 0.5}}")
    ben.start("zbot", *DRIVE, "{linear: {x: 0.25}}")
    assert not hears(robot, "speed")

    # The teacher gives the robot to one of them.
    given = teacher.run("zbot", "class", "give", str(ANA), "robot")
    assert "Ana (number 17) drives robot" in given.out, given.err
    robot.wait_for("speed 0.5")
    assert "robot robot: Ana (number 17) drives" in teacher.run("zbot", "class", "list").out
    assert not hears(robot, "speed 0.25")

    # Then to the other: the robot stops first.
    teacher.run("zbot", "class", "give", str(BEN), "robot")
    robot.wait_for("speed 0.0")
    robot.wait_for("speed 0.25")
    assert not hears(robot, "speed 0.5")

    # Who drives calls the robot's services, too.
    call = ("zbot", "service", "call", "/class/robot/beep", "std_srvs/srv/Trigger")
    called = ben.run(*call)
    assert "beep" in called.out, called.err

    # The teacher takes it back: one stop, then silence.
    assert teacher.run("zbot", "class", "take", "robot").out == "nobody drives robot\n"
    robot.wait_for("speed 0.0")
    assert not hears(robot, "speed")

    # Now nobody calls the robot's services.
    refused = ana.run(*call)
    assert refused.code == 1
    assert "it is not your turn" in refused.err

    # The bridge ends with the class.
    assert teacher.run("zbot", "class", "stop").code == 0
    log = teacher.home / ".config" / "zbot" / "robot-robot.log"
    assert log.is_file()
    assert "Traceback" not in log.read_text(encoding="utf-8")


def test_the_page_has_the_commands_of_the_lesson() -> None:
    page = (Path(__file__).parents[2] / "docs" / "robot.md").read_text(encoding="utf-8")
    for command in (
        "zbot class start Robots --robot dds",
        "zbot topic echo /class/robot/battery",
        f"zbot class give {ANA} robot",
        f"zbot {' '.join(DRIVE)} '{{linear: {{x: ",
        "zbot class take robot",
    ):
        assert command in page, command


def test_a_robot_that_is_not_there_is_one_sentence(
    make_testbed: Callable[[int], LanTestbed],
) -> None:
    testbed = make_testbed(0)
    teacher = testbed.teacher
    refused = teacher.run("zbot", "class", "start", "Robots", "--robot", "dds")
    assert refused.code == 1
    assert refused.err.startswith("this Python cannot import ROS 2's rclpy")
    assert teacher.run("zbot", "class", "start", "Robots").code == 0
    given = teacher.run("zbot", "class", "give", "17", "robot")
    assert given.code == 1
    assert "no student has number 17" in given.err
    teacher.run("zbot", "class", "stop")


def hears(robot: Program, text: str) -> bool:
    """Return whether the robot prints a text within the time of ten messages."""
    robot.new_lines()
    return wait_until(lambda: any(text in line for line in robot.new_lines()), SILENCE_S)
