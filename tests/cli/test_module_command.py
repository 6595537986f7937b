"""Tests of `python -m zbot` where the command `zbot` does not exist or is refused."""

from __future__ import annotations

import os
import subprocess
import sys
import sysconfig
import venv
from pathlib import Path
from typing import TYPE_CHECKING, TypeAlias

import pytest

from tests.conftest import allowed

if TYPE_CHECKING:
    from collections.abc import Callable

    from tests.conftest import Start

Zbot: TypeAlias = "Callable[..., subprocess.CompletedProcess[str]]"
LAUNCH = """
from launch import LaunchDescription
from launch.actions import ExecuteProcess
from launch_ros.actions import Node

def generate_launch_description():
    options = {"package": "zbot_nodes", "output": "screen"}
    return LaunchDescription([
        Node(executable="talker", **options),
        Node(executable="listener", **options),
        ExecuteProcess(cmd=["ros2", "topic", "echo", "--once", "/chatter"], output="screen"),
    ])
"""


@pytest.fixture(scope="module")
def python(tmp_path_factory: pytest.TempPathFactory) -> str:
    """Return a Python with zbot and without scripts."""
    folder = tmp_path_factory.mktemp("no_scripts")
    venv.create(folder, symlinks=sys.platform != "win32")
    found = venv.EnvBuilder().ensure_directories(folder)
    name = "Scripts" if sys.platform == "win32" else "bin"
    # Python 3.10 has no scheme for virtual environments.
    has_scheme = "venv" in sysconfig.get_scheme_names()
    scheme = "venv" if has_scheme else sysconfig.get_default_scheme()
    site = Path(sysconfig.get_path("purelib", scheme, {"base": str(folder)}))
    site.joinpath("host.pth").write_text("\n".join(sys.path[1:]), encoding="utf-8")
    assert not list((folder / name).glob("zbot*"))
    return str(found.env_exe)


@pytest.fixture(autouse=True)
def path_without_zbot(python: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """Remove all folders with zbot's scripts from the PATH, and begin with the Python above."""
    folders = os.environ["PATH"].split(os.pathsep)
    kept = [folder for folder in folders if not any(Path(folder).glob("zbot*"))]
    monkeypatch.setenv("PATH", os.pathsep.join([str(Path(python).parent), *kept]))


@pytest.fixture
def zbot(python: str) -> Callable[..., subprocess.CompletedProcess[str]]:
    """Return a function that runs `python -m zbot`."""

    def run(*words: str) -> subprocess.CompletedProcess[str]:
        return subprocess.run(
            [python, "-m", "zbot", *words],
            capture_output=True,
            text=True,
            timeout=allowed(60),
            check=False,
        )

    return run


@pytest.mark.parametrize(
    "words", [("topik", "list"), ("pkg", "prefix", "no_such"), ("run", "nope")]
)
def test_errors_name_the_command_that_was_typed(words: tuple[str, ...], zbot: Zbot) -> None:
    done = zbot(*words)
    assert done.returncode
    assert "`zbot " not in done.stderr
    assert "'zbot " not in done.stderr


@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no signal for Ctrl-C here")
def test_a_launch_and_its_commands_work(
    python: str, start: Start, tmp_path: Path, zbot: Zbot
) -> None:
    (tmp_path / "all.launch.py").write_text(LAUNCH)
    launch = start(python, "-m", "zbot", "launch", str(tmp_path / "all.launch.py"))
    launch.wait_for("I heard")
    launch.see("data: ")
    assert zbot("node", "list").stdout == "/listener\n/talker\n"


@pytest.mark.skipif(sys.platform == "win32", reason="as above")
def test_the_first_lesson_works(python: str, start: Start, zbot: Zbot) -> None:
    start(python, "-m", "zbot", "run", "turtlesim").wait_for("Spawning turtle")
    circle = "{linear: {x: 2.0}, angular: {z: 1.8}}"
    words = ("topic", "pub", "--once", "/turtle1/cmd_vel", "geometry_msgs/msg/Twist", circle)
    assert zbot(*words).returncode == 0
    assert "/turtle1/cmd_vel" in zbot("topic", "list").stdout
    assert "x:" in zbot("topic", "echo", "--once", "/turtle1/pose").stdout
    assert zbot("service", "call", "/reset", "std_srvs/srv/Empty").returncode == 0
    assert zbot("param", "get", "/turtlesim", "background_b").returncode == 0
    goal = ("action", "send_goal", "/turtle1/rotate_absolute")
    assert zbot(*goal, "turtlesim/action/RotateAbsolute", "{theta: 0.1}").returncode == 0
