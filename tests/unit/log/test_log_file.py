from __future__ import annotations

import re
import sys
from typing import TYPE_CHECKING

import pytest

from zbot import log
from zbot.log import get_logger

if TYPE_CHECKING:
    from pathlib import Path

    from tests.unit.log.conftest import Logged


LINE = re.compile(r"\[(\w+)\] \[(\d{10}\.\d{9})\] \[([\w.]+)\]: (.*)", re.DOTALL)


@pytest.mark.parametrize("variable", ["ZBOT_LOG_DIR", "ROS_LOG_DIR"])
def test_lines_are_written_to_a_file_in_the_configured_folder(
    variable: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    folder = tmp_path / "new" / "logs"
    monkeypatch.setenv(variable, str(folder))
    monkeypatch.setattr(sys, "argv", ["/somewhere/sensor.py"])
    assert not folder.exists()
    get_logger("sensor").info("20 °C")
    get_logger("sensor").info("21 °C")
    (file,) = folder.iterdir()
    assert re.fullmatch(r"sensor_\d+_\d{13}\.log", file.name)
    lines = file.read_text(encoding="utf-8").splitlines()
    assert [line.partition("]: ")[2] for line in lines] == ["20 °C", "21 °C"]


def test_file_has_no_colour_and_stays_when_the_console_is_off(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("ZBOT_LOG_DIR", str(tmp_path))
    monkeypatch.setenv("FORCE_COLOR", "1")
    log.configure(stdout_enabled=False, file_prefix="mine")
    get_logger("sensor").info("text")
    (file,) = tmp_path.iterdir()
    assert file.name.startswith("mine_")
    assert LINE.fullmatch(file.read_text().rstrip("\n"))


def test_file_can_be_switched_off(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("ZBOT_LOG_DIR", str(tmp_path))
    log.configure(file_enabled=False)
    get_logger("sensor").info("text")
    assert list(tmp_path.iterdir()) == []


def test_unusable_folder_is_reported_once(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, logged: Logged
) -> None:
    (tmp_path / "file").touch()
    monkeypatch.setenv("ZBOT_LOG_DIR", str(tmp_path / "file"))
    for number in range(2):
        get_logger("sensor").info(number)
    first, complaint, *others = logged()
    assert (first, others) == ("0", ["1"])
    assert complaint.startswith("cannot write the log file")


@pytest.mark.parametrize(
    ("variables", "expected"),
    [
        ({"ZBOT_LOG_DIR": "z", "ROS_LOG_DIR": "r", "ROS_HOME": "h"}, "z"),
        ({"ROS_LOG_DIR": "r", "ROS_HOME": "h"}, "r"),
        ({"ROS_HOME": "h"}, "h/log"),
        ({}, "home/.ros/log"),
        ({"ZBOT_LOG_DIR": "", "ROS_LOG_DIR": "~/r"}, "home/r"),
    ],
)
def test_logging_directory_follows_the_environment(
    variables: dict[str, str], expected: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("HOME", "home")
    monkeypatch.setenv("USERPROFILE", "home")
    for variable, value in variables.items():
        monkeypatch.setenv(variable, value)
    assert log.get_logging_directory().as_posix() == expected
