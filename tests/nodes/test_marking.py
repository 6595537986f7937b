"""Tests of the lockstep of the simulator, and of the marking of programs with it."""

from __future__ import annotations

import itertools
import shutil
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest

import zbot
from tests.conftest import wait_until
from zbot.bag.reader import Reader

from geometry_msgs.msg import Twist  # isort: skip
from std_msgs.msg import Int32  # isort: skip

if TYPE_CHECKING:
    from collections.abc import Callable

    from tests.conftest import MakeContext, Spin
    from zbot.simulation.marking.trial import Mark

    Run = Callable[..., Mark]

pytest.importorskip("mujoco", reason="the simulator needs the extra `sim`")
pytest.importorskip("mcap", reason="bags need the extra `bag`")

PROGRAMS = Path(__file__).parents[1] / "programs" / "marking"


@pytest.fixture
def mark(domain: int, tmp_path: Path) -> Run:
    """Return a function that marks a program, and writes the bag of its name."""
    from zbot.simulation.marking.trial import Course, Trial  # noqa: PLC0415 - needs the extra
    from zbot.simulation.node.program import Options  # noqa: PLC0415 - as above

    def run(task: str, program: Path, bag: str = "bag", *, limit_s: float = 20.0) -> Mark:
        course = Course(task, Options("room", ("two_wheeled",)), domain, limit_s)
        return Trial(course, program, tmp_path / bag).run()

    return run


def messages(bag: Path) -> list[tuple[str, int, bytes]]:
    """Return all messages of a bag, with their times."""
    with Reader(bag) as reader:
        return [
            (message.topic, message.log_ns, bytes(message.data)) for message in reader.messages()
        ]


def test_the_same_program_gets_the_same_mark_and_the_same_bag(mark: Run, tmp_path: Path) -> None:
    program = PROGRAMS / "turn_at_walls.py"
    marks = [mark("reaches (9, 9) within 4 s", program, bag) for bag in ("first", "second")]
    assert marks[0] == marks[1]
    assert marks[0].is_exact
    first, second = (messages(tmp_path / bag) for bag in ("first", "second"))
    assert {"/scan", "/odom", "/cmd_vel", "/clock"} <= {topic for topic, _, _ in first}
    assert first == second
    commands = [time_ns for topic, time_ns, _ in first if topic == "/cmd_vel"]
    assert len(commands) > 50
    assert commands[0] == 72_000_000, "the timer of 0.07 s runs at the next time of /clock"


def test_a_program_passes(mark: Run) -> None:
    task = "reaches (1, 0) within 10 s and touches nothing and runs /ahead"
    task += " and publishes geometry_msgs/Twist on /cmd_vel at >= 8 Hz"
    assert mark(task, PROGRAMS / "ahead.py").problems == ()


@pytest.mark.parametrize(
    ("fault", "problem"),
    [
        (
            "crash",
            "the program ended with NameError: name 'no_such_name' is not defined, in line 28",
        ),
        ("end", "the program ended before it made a node"),
        ("typo", "no message came on /cmd_vel; did you mean '/cmd_val'?"),
        ("silence", "no message came on /cmd_vel"),
        ("flood", ""),
    ],
)
def test_what_goes_wrong_is_one_sentence(
    mark: Run, monkeypatch: pytest.MonkeyPatch, fault: str, problem: str
) -> None:
    monkeypatch.setenv("FAULT", fault)
    problems = mark("reaches (0.5, 0) within 4 s", PROGRAMS / "ahead.py").problems
    assert problems[-1:] == ((problem,) if problem else ())


def test_a_program_that_hangs_does_not_stop_the_world(
    mark: Run, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("FAULT", "hang")
    found = mark("reaches (1, 0) within 1 s", PROGRAMS / "ahead.py", limit_s=0.5)
    assert found.problems[0].startswith("/ahead did not end its work of 0.1 s within 0.5 s")
    assert not found.is_exact


def test_the_launch_file_of_a_package_is_marked(mark: Run, tmp_path: Path) -> None:
    package = tmp_path / "student"
    for folder in ("launch", "ahead_robot"):
        (package / folder).mkdir(parents=True)
    (package / "ahead_robot" / "__init__.py").touch()
    before, _, after = (PROGRAMS / "ahead.py").read_text().rpartition("\nif FAULT")
    end = after.replace("    rclpy", "        rclpy")
    (package / "ahead_robot" / "drive.py").write_text(f"{before}\ndef main():\n    if FAULT{end}")
    (package / "package.xml").write_text(
        "<package format='3'><name>ahead_robot</name><version>1.0.0</version><description>d"
        "</description><maintainer email='a@b.org'>a</maintainer><license>MIT</license>"
        "<export><build_type>ament_python</build_type></export></package>"
    )
    (package / "setup.py").write_text(
        "from setuptools import setup\nsetup(name='ahead_robot', packages=['ahead_robot'], "
        "entry_points={'console_scripts': ['drive = ahead_robot.drive:main']})\n"
    )
    file = package / "launch" / "main.launch.py"
    file.write_text(
        "from launch import LaunchDescription\nfrom launch_ros.actions import Node\n\n\n"
        "def generate_launch_description():\n"
        "    return LaunchDescription([Node(package='ahead_robot', executable='drive')])\n"
    )
    found = mark("reaches (0.5, 0) within 10 s", file)
    assert found.problems == ()
    assert found.is_exact


def test_a_program_that_python_cannot_read_has_the_line_of_its_error(
    mark: Run, tmp_path: Path
) -> None:
    program = tmp_path / "program.py"
    shutil.copy(PROGRAMS / "no_syntax.txt", program)
    (problem,) = mark("touches nothing", program).problems
    assert problem == "the program ended with SyntaxError: invalid syntax, in line 4"


def test_a_loop_with_a_rate_is_in_lockstep(mark: Run, tmp_path: Path) -> None:
    found = mark("reaches (9, 9) within 2 s", PROGRAMS / "loop.py")
    assert found.is_exact
    times = [time_ns for topic, time_ns, _ in messages(tmp_path / "bag") if topic == "/cmd_vel"]
    steps = {after - before for before, after in itertools.pairwise(times[1:])}
    assert steps == {100_000_000}


class Counter(zbot.Node):
    """Node that sends a number 20 times a second of simulated time."""

    def __init__(self, **options: Any) -> None:
        super().__init__("counter", **options)
        self.number = 0
        self.numbers = self.create_publisher(Int32, "/number", 10)
        self.create_timer(0.05, self.count)

    def count(self) -> None:
        """Send the next number."""
        self.number += 1
        self.numbers.publish(Int32(data=self.number))


class Driver(zbot.Node):
    """Node in another session, which drives with a speed that it gets."""

    def __init__(self, **options: Any) -> None:
        super().__init__("driver", **options)
        self.commands = self.create_publisher(Twist, "/cmd_vel", 10)
        self.create_subscription(Int32, "/number", self.drive, 10)

    def drive(self, message: Int32) -> None:
        """Drive with a speed."""
        command = Twist()
        command.linear.x = message.data / 1000
        self.commands.publish(command)


def test_each_instant_waits_for_messages_that_pass_through_several_programs(
    make_context: MakeContext, spin: Spin
) -> None:
    from zbot.executor.single_threaded_executor import (  # noqa: PLC0415 - with the extra
        SingleThreadedExecutor,
    )
    from zbot.simulation.node.pace import Pace  # noqa: PLC0415 - needs the extra
    from zbot.simulation.node.program import Options, robots_of  # noqa: PLC0415 - as above
    from zbot.simulation.node.simulator import Simulator  # noqa: PLC0415 - as above
    from zbot.simulation.world import World  # noqa: PLC0415 - as above
    from zbot.simulation.worlds.file import find_world  # noqa: PLC0415 - as above

    found = find_world("room")
    world, context = World(found.spec), make_context()
    simulator = Simulator(world, Pace(None), in_lockstep=True, context=context)
    simulator.is_paused = True
    simulator.add_robots(robots_of(Options(), world, found.start))
    executor = SingleThreadedExecutor(context=context)
    executor.add_node(simulator)
    follows = [zbot.Parameter("use_sim_time", value=True)]
    nodes = [
        kind(context=make_context(), parameter_overrides=follows) for kind in (Counter, Driver)
    ]
    for node in nodes:
        spin(node)
    lockstep = simulator.lockstep
    assert lockstep is not None

    def are_known() -> bool:
        executor.spin_once(0.01)
        lockstep.notice_changes()
        return len(lockstep.present) == 2

    assert wait_until(are_known, 10)
    commands = []
    for _ in range(250):
        simulator.step()
        commands.append(world.robots["robot"].command[0])
    # 0.052 s is the first time of /clock at which 0.05 s have passed.
    assert commands[11] == 0.0
    assert commands[12] == pytest.approx(0.001)
    assert commands[-1] == pytest.approx(0.020)
    assert sorted(set(commands)) == pytest.approx([number / 1000 for number in range(21)])
