"""Tests of the control of a running launch by the page of the same user."""

from __future__ import annotations

import socket
import sys
import threading
from typing import TYPE_CHECKING, Any

import pytest

from tests.conftest import wait_until
from zbot.launch import LaunchDescription, LaunchService
from zbot.launch.actions import ExecuteProcess, OpaqueFunction, Shutdown
from zbot.launch.control.control_server import FOLDER, ControlServer
from zbot.launch.control.running_launch import RunningLaunch, running_launches
from zbot.launch.errors import LaunchControlError
from zbot.transport.membership import folder

if TYPE_CHECKING:
    from collections.abc import Iterator
    from pathlib import Path

DOMAIN = 17
WAITING = "print('up', flush=True); import time; time.sleep(100)"


def program(code: str, name: str, **options: Any) -> ExecuteProcess:
    return ExecuteProcess(cmd=[sys.executable, "-c", code], name=name, **options)


class Launch:
    """Running launch of some programs, as the page sees it."""

    def __init__(self, path: Path, *programs: ExecuteProcess) -> None:
        self.service = LaunchService(noninteractive=True)
        server = ControlServer(self.service.context, path, ["a:=1"])
        control = OpaqueFunction(function=lambda _: server.start())
        self.service.include_launch_description(LaunchDescription([*programs, control]))
        self.thread = threading.Thread(target=self.service.run)
        self.thread.start()
        assert wait_until(lambda: bool(running_launches(DOMAIN)))
        self.seen: RunningLaunch = running_launches(DOMAIN)[0]

    def process(self, label: str) -> dict[str, Any]:
        found = {one["label"]: one for one in self.seen.ask("look")["processes"]}
        process: dict[str, Any] = found.get(label, {})
        return process

    def runs(self, label: str, times: int) -> bool:
        process = self.process(label)
        lines = self.seen.ask("output", label=label, after=0)["lines"] if process else []
        return bool(process) and process["running"] and lines.count("up") == times

    def close(self) -> None:
        self.service.shutdown()
        self.thread.join()


@pytest.fixture
def launches(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Any]:
    """Return a function that starts a launch with programs."""
    monkeypatch.setenv("ZBOT_DOMAIN_ID", str(DOMAIN))
    monkeypatch.setenv("ROS_LOG_DIR", str(tmp_path / "log"))
    started: list[Launch] = []

    def start(*programs: ExecuteProcess) -> Launch:
        started.append(Launch(tmp_path / "robot.launch.py", *programs))
        return started[-1]

    yield start
    for launch in started:
        launch.close()
    assert running_launches(DOMAIN) == []


def test_a_launch_is_seen_only_by_its_user_and_domain(launches: Any, tmp_path: Path) -> None:
    launch = launches(program(WAITING, "node"))
    assert wait_until(lambda: launch.runs("node-1", 1))
    facts = launch.seen.ask("look")
    assert facts["file"] == str(tmp_path / "robot.launch.py")
    assert facts["arguments"] == ["a:=1"]
    assert running_launches(DOMAIN + 1) == []
    (path,) = (folder() / FOLDER).iterdir()
    if sys.platform != "win32":
        assert path.stat().st_mode & 0o077 == 0
        assert path.parent.stat().st_mode & 0o077 == 0


def test_a_restart_is_no_end_for_the_launch(launches: Any) -> None:
    launch = launches(program(WAITING, "node", on_exit=Shutdown()))
    assert wait_until(lambda: launch.runs("node-1", 1))
    first = launch.process("node-1")["pid"]
    launch.seen.ask("restart", label="node-1")
    assert wait_until(lambda: launch.runs("node-1", 2))
    assert launch.process("node-1")["pid"] != first
    assert launch.process("node-1")["runs"] == 2
    # A stop is an end, to which the launch file reacts.
    launch.seen.ask("stop", label="node-1")
    launch.thread.join()
    assert running_launches(DOMAIN) == []


def test_a_process_that_has_ended_starts_again(launches: Any) -> None:
    launch = launches(program(WAITING, "node"), program("print('up')", "once"))
    assert wait_until(lambda: launch.process("once-2").get("exit_code") == 0)
    launch.seen.ask("restart", label="once-2")
    assert wait_until(lambda: launch.process("once-2")["runs"] == 2)
    assert wait_until(lambda: not launch.process("once-2")["running"])


def test_a_stopped_process_does_not_respawn(launches: Any) -> None:
    launch = launches(program(WAITING, "node"), program(WAITING, "other", respawn=True))
    assert wait_until(lambda: launch.runs("other-2", 1))
    launch.seen.ask("stop", label="other-2")
    assert wait_until(lambda: not launch.process("other-2")["running"])
    launch.seen.ask("restart", label="other-2")
    assert wait_until(lambda: launch.runs("other-2", 2))
    assert launch.process("node-1")["running"]


def test_a_stop_during_a_restart_stops(launches: Any) -> None:
    launch = launches(program(WAITING, "node"), program(WAITING, "other"))
    assert wait_until(lambda: launch.runs("other-2", 1))
    launch.seen.ask("restart", label="other-2")
    launch.seen.ask("stop", label="other-2")
    assert wait_until(lambda: not launch.process("other-2")["running"])
    assert launch.process("other-2")["runs"] == 1


def test_the_whole_launch_ends_on_request(launches: Any) -> None:
    launch = launches(program(WAITING, "node"))
    assert wait_until(lambda: launch.runs("node-1", 1))
    launch.seen.ask("end")
    launch.thread.join()
    with pytest.raises(LaunchControlError, match="the launch has ended"):
        launch.seen.ask("look")


def test_requests_that_are_wrong_change_nothing(launches: Any) -> None:
    launch = launches(program(WAITING, "node"))
    assert wait_until(lambda: launch.runs("node-1", 1))
    guest = RunningLaunch(launch.seen.pid, DOMAIN, launch.seen.port, "guess")
    with pytest.raises(LaunchControlError, match="has ended"):  # it gets no answer
        guest.ask("end")
    with pytest.raises(LaunchControlError, match="no process 'lost'"):
        launch.seen.ask("stop", label="lost")
    with pytest.raises(LaunchControlError, match="does not know the request 'fly'"):
        launch.seen.ask("fly", label="node-1")
    # A website in the user's browser can send a request of HTTP.
    for text in (b"POST / HTTP/1.1\r\n\r\n", b"[1]\n", b"x" * 100_000 + b"\n"):
        with socket.create_connection(("127.0.0.1", launch.seen.port), 5) as connection:
            connection.sendall(text)
            try:
                answer = connection.recv(1000)
            except ConnectionError:
                answer = b""
            assert b"processes" not in answer
    assert launch.runs("node-1", 1)
