"""Tests of `zbot sim`: its mistakes, and a simulator in a process of its own."""

from __future__ import annotations

import signal
from typing import TYPE_CHECKING

import pytest

import zbot
from tests.conftest import wait_until
from zbot.errors.installation import pip_install

from geometry_msgs.msg import Twist  # isort: skip
from nav_msgs.msg import Odometry  # isort: skip

if TYPE_CHECKING:
    from collections.abc import Callable

    from tests.cli.conftest import Result
    from tests.conftest import MakeContext, Spin, Start

    Command = Callable[..., Result]

pytest.importorskip("mujoco", reason="the simulator needs the extra `sim`")

WITHOUT_EXTRA = """
import sys
sys.modules["mujoco"] = sys.modules["numpy"] = None
sys.argv = ["zbot", "sim"]
from zbot_cli.main import main
main()
"""


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("rooom",), "there is no world 'rooom'; did you mean 'room'"),
        (("--robot", "three_wheeled"), "there is no robot 'three_wheeled'"),
        (("--robot", "a.urdf"), "a.urdf cannot be read"),
        (("--robots", "0"), "--robots must be 1 to 100, not 0"),
        (("--robots", "2", "--robot", "two_wheeled", "--robot", "two_wheeled"), "at most one"),
        (("--rate", "0"), "--rate must be 0.01 to 100.0, or max, not '0'"),
    ],
)
def test_mistakes_are_told_in_one_sentence(
    zbot_command: Command, words: tuple[str, ...], said: str
) -> None:
    result = zbot_command("sim", "--headless", *words)
    assert result.code == 1
    assert said in result.err
    assert result.err.count("\n") == 1


def test_a_missing_extra_is_named(start: Start) -> None:
    program = start(source=WITHOUT_EXTRA)
    assert program.wait() == 1
    assert program.lines == [f"the simulator needs MuJoCo: {pip_install('zbot[sim]')}"]


@pytest.mark.parametrize("way", [signal.SIGINT, signal.SIGTERM])
def test_a_simulator_runs_until_a_signal_ends_it(
    start: Start, make_context: MakeContext, spin: Spin, way: signal.Signals
) -> None:
    context = make_context()
    node = zbot.Node("student", context=context)
    heard: list[Odometry] = []
    node.create_subscription(Odometry, "/odom", heard.append, 10)
    wheel = node.create_publisher(Twist, "/cmd_vel", 10)
    spin(node)
    program = start("zbot", "sim", "--headless")
    command = Twist()
    command.linear.x = 0.3

    def drives() -> bool:
        wheel.publish(command)
        return bool(heard) and heard[-1].pose.pose.position.x > 0.1

    assert wait_until(drives, 30)
    program.process.send_signal(way)
    assert program.wait() == 128 + way
    assert not any("Traceback" in line for line in program.lines)


def test_a_simulator_starts_after_another_was_killed(start: Start) -> None:
    first = start("zbot", "sim", "--headless")
    first.wait_for("has the robots: robot")
    second = start("zbot", "sim", "--headless")
    second.wait_for("the node /simulator publishes /clock in this domain already")
    assert second.wait() == 1
    first.process.kill()
    first.wait()
    third = start("zbot", "sim", "--headless")
    third.wait_for("has the robots: robot")
