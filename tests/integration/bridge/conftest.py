"""Processes of a genuine ROS 2, and bridges that run beside it.

Set ZBOT_ROS2_PREFIX to the prefix of a Python environment with zbot and the wheels of ROS 2,
installed by `pip install -e '.[ros2]' ros-test-msgs`.
"""

from __future__ import annotations

import contextlib
import json
import os
import subprocess
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest

from tests.conftest import Program, wait_until
from zbot.testing.domain import reserved_domain

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    Peers = Callable[..., "GenuinePeer"]
    Bridges = Callable[..., Program]

PREFIX = os.environ.get("ZBOT_ROS2_PREFIX", "")
PYTHON = Path(PREFIX, "bin", "python")
ONE_SIDE = "one side of the bridge speaks zbot's own dialect"
PEER = Path(__file__).parents[2] / "programs" / "remote" / "genuine_peer.py"
#: How long DDS may need until two processes have found each other.
DISCOVERY_S = 20.0
#: DDS allows numbers up to 101 on Linux. A larger number's ports may belong to clients.
_MOST_DDS_DOMAIN = 101


def needs_ros2() -> list[pytest.MarkDecorator]:
    """Return the marks of tests that need the genuine rclpy."""
    is_there = bool(PREFIX) and bool(list(Path(PREFIX).glob("lib/python*/site-packages/rclpy")))
    reason = "ZBOT_ROS2_PREFIX names no environment with a genuine rclpy"
    return [
        pytest.mark.ros2,
        pytest.mark.skipif(not is_there, reason=reason),
        pytest.mark.own_dialect(ONE_SIDE),
    ]


class GenuinePeer:
    """Process with a node of the genuine rclpy that does what a test tells it."""

    def __init__(self, name: str, environment: dict[str, str], folder: Path) -> None:
        self.errors = (folder / f"{name}.log").open("w")
        self.process = subprocess.Popen(
            [PYTHON, PEER, name],
            env=environment,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=self.errors,
            encoding="utf-8",
        )
        assert self._answer() == "ready"

    def _answer(self) -> Any:
        assert self.process.stdout is not None
        line = self.process.stdout.readline()
        assert line, Path(self.errors.name).read_text(encoding="utf-8")
        return json.loads(line)

    def __getattr__(self, operation: str) -> Callable[..., Any]:
        def tell(**options: Any) -> Any:
            assert self.process.stdin is not None
            print(json.dumps([operation, options]), file=self.process.stdin, flush=True)
            answer = self._answer()
            assert not isinstance(answer, dict), answer
            return answer

        return tell

    def end(self) -> None:
        self.process.kill()
        self.process.wait(10)
        for stream in (self.process.stdin, self.process.stdout, self.errors):
            if stream is not None:
                with contextlib.suppress(OSError):
                    stream.close()


def genuine_environment(domain: int) -> dict[str, str]:
    """Return the environment of a process with the genuine rclpy, without what leaks."""
    clean = {
        name: value
        for name, value in os.environ.items()
        if name not in {"LD_LIBRARY_PATH", "LD_PRELOAD", "_ROS_WHEELS_BOOTSTRAP_COMPLETE"}
    }
    return clean | {
        "ROS_AUTOMATIC_DISCOVERY_RANGE": "LOCALHOST",
        "ROS_DOMAIN_ID": str(domain),
        "ZBOT_DOMAIN_ID": str(domain),
    }


@pytest.fixture
def ros_domain() -> Iterator[int]:
    """Return a domain of ROS 2 that no other test uses."""
    with reserved_domain(_MOST_DDS_DOMAIN) as number:
        yield number


@pytest.fixture
def peer(ros_domain: int, tmp_path: Path) -> Iterator[Peers]:
    """Return a function that starts a genuine node."""
    running: list[GenuinePeer] = []

    def start(name: str = "robot", domain: int | None = None) -> GenuinePeer:
        environment = genuine_environment(ros_domain if domain is None else domain)
        running.append(GenuinePeer(name, environment, tmp_path))
        return running[-1]

    yield start
    for program in running:
        program.end()


@pytest.fixture
def bridge(domain: int, ros_domain: int, tmp_path: Path) -> Iterator[Bridges]:
    """Return a function that starts `zbot bridge dds` with options, and waits until it works."""
    running: list[Program] = []

    def start(*options: str, on: int | None = None) -> Program:
        words = ["bridge", "dds", "--ros-domain", str(ros_domain if on is None else on), *options]
        environment = genuine_environment(domain)
        program = Program([str(PYTHON), "-m", "zbot_cli", *words], tmp_path, environment)
        running.append(program)
        program.wait_for("carrying between", 30)
        return program

    yield start
    for program in running:
        if program.process.poll() is None:
            program.process.kill()
        program.process.wait(10)


def eventually(condition: Callable[[], object], timeout_s: float = DISCOVERY_S) -> bool:
    """Wait until a condition is true."""
    return wait_until(lambda: bool(condition()), timeout_s)
