"""Contestants of the benchmark, and the processes in which their programs run."""

from __future__ import annotations

import itertools
import json
import os
import socket
import subprocess
import sys
import threading
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any

from zbot.transport.config import MEETING_PORT

if TYPE_CHECKING:
    from collections.abc import Mapping

    from typing_extensions import Self

ROOT = Path(__file__).resolve().parents[1]
PROGRAMS = Path(__file__).resolve().parent / "programs"
ROS2_PYTHON = os.environ.get("ZBOT_ROS2_PYTHON", "")
_DOMAINS = itertools.cycle(range(150, 230))
_LONGEST_S = 120  # a program that answers nothing is killed


class ProgramError(Exception):
    """A measured program ended without a result."""


@dataclass(frozen=True)
class Contestant:
    """A library and a way to use it."""

    name: str  #: as it is printed
    script: str = "zbot_program.py"
    options: Mapping[str, Any] = field(default_factory=dict)  #: for each of its programs
    variables: Mapping[str, str] = field(
        default_factory=dict
    )  #: in the environment of its programs
    checkout: Path = ROOT  #: where its zbot is
    python: str = sys.executable

    @property
    def is_zbot(self) -> bool:
        return self.script == ZBOT.script

    @property
    def is_raw(self) -> bool:
        return self.script == RAW_WAYS[0].script


ZBOT = Contestant("zbot")
ASLEEP = Contestant("zbot, sleeps at once", options={"stays_awake": False})
RAW_WAYS = tuple(
    Contestant(name, "raw_program.py", {"way": way})
    for way, name in (
        ("direct", "raw, direct callback"),
        ("thread", "raw, callback thread"),
        ("channel", "raw, channel"),
    )
)
POLLING = Contestant("raw, channel that polls", "raw_program.py", {"way": "poll"})
#: As a user would write it: the default settings, and a put of bytes.
PLAIN = Contestant("raw, plain put", "raw_program.py", {"way": "direct", "is_plain": True})
WAKE = Contestant("raw, direct and main thread", "raw_program.py", {"way": "wake"})
RCLPY = [Contestant("rclpy", "rclpy_program.py", python=ROS2_PYTHON)] if ROS2_PYTHON else []


def environment(contestant: Contestant) -> dict[str, str]:
    """Return the environment of a new group of programs, with a port and a domain of its own."""
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        port = str(probe.getsockname()[1])
    domain = str(next(number for number in _DOMAINS if _is_free(MEETING_PORT + number)))
    env = {**os.environ, **contestant.variables, "BENCH_PORT": port, "ZBOT_DOMAIN_ID": domain}
    if contestant in RCLPY:
        # rclpy's interpreter starts itself again with these. zbot must not inherit them.
        return env | {"ROS_DOMAIN_ID": domain[-2:], "ROS_AUTOMATIC_DISCOVERY_RANGE": "LOCALHOST"}
    folders = (contestant.checkout, contestant.checkout / "cli", contestant.checkout / "nodes")
    return env | {"PYTHONPATH": os.pathsep.join(map(str, folders))}


def _is_free(port: int) -> bool:
    with socket.socket() as probe:
        return probe.connect_ex(("127.0.0.1", port)) != 0


class Program:
    """A measured program, until the end of a `with` block."""

    def __init__(
        self, contestant: Contestant, role: str, env: Mapping[str, str], **options: Any
    ) -> None:
        self._what = f"{contestant.name}: {role}"
        words = json.dumps({**contestant.options, **options})
        self._process = subprocess.Popen(
            [contestant.python, str(PROGRAMS / contestant.script), role, words],
            cwd=PROGRAMS,  # which has no zenoh.json5
            env=dict(env),
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL if contestant in RCLPY else None,
            text=True,
        )
        self.pid = self._process.pid

    def read(self) -> dict[str, Any]:
        """Return what the program reports next.

        Raises:
            ProgramError: The program ended, or reported nothing for two minutes.
        """
        assert self._process.stdout is not None
        watchdog = threading.Timer(_LONGEST_S, self._process.kill)
        watchdog.start()
        line = self._process.stdout.readline()
        watchdog.cancel()
        if not line:
            raise ProgramError(f"{self._what} ended with {self._process.wait()}")
        return json.loads(line)  # type: ignore[no-any-return]

    def tell(self, **words: Any) -> None:
        """Let the program go on."""
        assert self._process.stdin is not None
        self._process.stdin.write(json.dumps(words) + "\n")
        self._process.stdin.flush()

    def ask(self, **words: Any) -> dict[str, Any]:
        """Return the program's answer."""
        self.tell(**words)
        return self.read()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self._process.terminate()
        try:
            self._process.wait(10)
        except subprocess.TimeoutExpired:
            self._process.kill()
            self._process.wait()
        for pipe in (self._process.stdin, self._process.stdout):
            if pipe is not None:
                pipe.close()


def data_options(
    contestant: Contestant, kind: str | int, *, size: int, queue: int
) -> dict[str, Any]:
    """Return the options that say what a program sends: a message, or bytes of the same length."""
    return {"size": size, "queue": queue} if contestant.is_raw else {"kind": kind}
