"""Tests of launch files that start Gazebo by its command line."""

from __future__ import annotations

from typing import Any

import pytest

from zbot.launch import LaunchContext
from zbot.launch.actions import ExecuteProcess
from zbot.launch.actions import executable as executable_module
from zbot.package import unavailable, zbot_command
from zbot.package.errors import NotRunnableError


@pytest.fixture(autouse=True)
def nothing_on_path(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("shutil.which", lambda *_, **__: None)
    for module in (zbot_command, executable_module):
        monkeypatch.setattr(module, "zbot_command", lambda: ["/a venv/zbot"])


@pytest.fixture
def is_simulator_here(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(unavailable, "find_spec", lambda _: object())


@pytest.mark.usefixtures("is_simulator_here")
@pytest.mark.parametrize(
    ("cmd", "expected"),
    [
        (["gz sim -r", "a.sdf"], "'/a venv/zbot' run gz_sim gz sim -r a.sdf"),
        ([["gz sim -v 4 -r ", "a.sdf"]], "'/a venv/zbot' run gz_sim gz sim -v 4 -r a.sdf"),
        (["ign gazebo", "a.sdf"], "'/a venv/zbot' run gz_sim ign gazebo a.sdf"),
        (["gzserver", "a.world"], "'/a venv/zbot' run gazebo gzserver a.world"),
        (["echo  'gz sim'"], "echo  'gz sim'"),
    ],
)
def test_a_line_for_a_shell_starts_the_simulator(cmd: Any, expected: str) -> None:
    prepared = ExecuteProcess(cmd=cmd, shell=True).prepare(LaunchContext())
    assert " ".join(prepared.words) == expected


@pytest.mark.parametrize(
    "given", [{"cmd": ["gzserver", "a.world"]}, {"cmd": ["gz sim -r", "a.sdf"], "shell": True}]
)
def test_without_the_extra_the_simulator_is_left_out(
    given: dict[str, Any], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(unavailable, "find_spec", lambda _: None)
    with pytest.raises(NotRunnableError, match=r'after `pip install "zbot\[sim\]"`'):
        ExecuteProcess(**given).execute(LaunchContext())
