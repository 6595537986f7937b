"""Tests of the rows of launches, and of the output of their processes."""

from __future__ import annotations

from typing import Any

import pytest

from zbot.launch.control.running_launch import RunningLaunch
from zbot.launch.errors import LaunchControlError
from zbot.web.page.table import Cell
from zbot.web.panels.launch import launch_list
from zbot.web.panels.launch.launch_list import is_process, look, rows
from zbot.web.panels.launch.process_details import plain

NOW_S = 1000.0


def facts(**changes: Any) -> dict[str, Any]:
    process = {
        "label": "talker-1",
        "command": "zbot run demo_nodes_py talker",
        "pid": 5,
        "runs": 1,
        "since": NOW_S - 12,
        "running": True,
        "exit_code": None,
    }
    ended = {**process, "label": "echo-2", "running": False, "exit_code": 0}
    return {
        "file": "/home/ana/robot of ana.launch.py",
        "arguments": [],
        "started": NOW_S - 60,
        "ending": False,
        "processes": [process, ended],
        **changes,
    }


def shown(monkeypatch: pytest.MonkeyPatch, answer: Any, *, only_running: bool = False) -> Any:
    """Return the texts of the rows of a launch that gives an answer."""

    def ask(*_: Any, **__: Any) -> Any:
        if isinstance(answer, Exception):
            raise answer
        return answer

    monkeypatch.setattr(RunningLaunch, "ask", ask)
    launches = [RunningLaunch(77, 0, 1, "token")]
    monkeypatch.setattr(launch_list, "running_launches", lambda _: launches)
    found = rows(look(0), only_running=only_running, now_s=NOW_S)
    return {
        key: [cell.text if isinstance(cell, Cell) else cell for cell in row][:4]
        for key, row in found.items()
    }


def test_processes_are_below_their_launch(monkeypatch: pytest.MonkeyPatch) -> None:
    found = shown(monkeypatch, facts())
    assert list(found.values()) == [
        ["robot of ana.launch.py", "1 running", "60 s", ""],
        ["talker-1", "running", "12 s", "5"],
        ["echo-2", "finished", "12 s", ""],
    ]
    assert [is_process(key) for key in found] == [False, True, True]
    assert len(shown(monkeypatch, facts(), only_running=True)) == 2


@pytest.mark.parametrize(
    ("code", "state"),
    [(0, "finished"), (3, "failed, exit code 3"), (-2, "ended by signal 2")],
)
def test_the_state_says_how_a_process_ended(
    monkeypatch: pytest.MonkeyPatch, code: int, state: str
) -> None:
    (process,) = facts()["processes"][1:]
    found = shown(monkeypatch, facts(processes=[{**process, "exit_code": code}]))
    assert list(found.values())[1][1] == state


@pytest.mark.parametrize(
    "answer", [LaunchControlError("it has ended"), {}, facts(processes=[{}]), facts(started="x")]
)
def test_a_launch_that_ends_or_is_strange_is_not_shown(
    monkeypatch: pytest.MonkeyPatch, answer: Any
) -> None:
    assert shown(monkeypatch, answer) == {}


def test_output_is_shown_without_codes_for_terminals() -> None:
    assert plain("\x1b[1;31m[ERROR]\x1b[0m a\tb\x07 \x1b[2K\u202eé") == "[ERROR] a\tb é"
