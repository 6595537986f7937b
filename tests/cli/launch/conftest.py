"""Launch files of tests, and what their processes are."""

from __future__ import annotations

import os
import re
from typing import TYPE_CHECKING

import pytest

if TYPE_CHECKING:
    from collections.abc import Callable
    from pathlib import Path

    from tests.conftest import Program

_IMPORTS = """
import sys
from launch import LaunchDescription
from launch.actions import *
from launch.conditions import *
from launch.event_handlers import *
from launch.events import Shutdown as ShutdownEvent
from launch.events.process import *
from launch.substitutions import *
from launch_ros.actions import *
def python(code, **options):
    return ExecuteProcess(cmd=[sys.executable, "-c", code], **options)
def generate_launch_description():
    return LaunchDescription([
"""


@pytest.fixture(autouse=True)
def log_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("ZBOT_LOG_DIR", str(tmp_path / "log"))
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    return tmp_path / "log"


@pytest.fixture
def launch(tmp_path: Path, start: Callable[..., Program]) -> Callable[..., Program]:
    """Return a function that launches the given arguments of a LaunchDescription."""
    return launcher(_IMPORTS, tmp_path, start)


def launcher(begin: str, folder: Path, start: Callable[..., Program]) -> Callable[..., Program]:
    """Return a function that launches actions in a file that begins with some code."""

    def run(actions: str, *words: str) -> Program:
        file = folder / "a.launch.py"
        file.write_text(f"{begin}{actions}\n])\n", encoding="utf-8")
        return start("zbot", "launch", str(file), *words)

    return run


def pid_in(line: str) -> int:
    match = re.search(r"pid \[(\d+)\]", line)
    assert match is not None
    return int(match[1])


def is_alive(pid: int) -> bool:
    try:
        os.kill(pid, 0)
    except ProcessLookupError:
        return False
    return True
