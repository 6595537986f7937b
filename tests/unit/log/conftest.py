from __future__ import annotations

import re
from typing import TYPE_CHECKING

import pytest

from zbot import log

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    Logged = Callable[[], list[str]]

LINE = re.compile(r"\[(\w+)\] \[(\d{10}\.\d{9})\] \[([\w.]+)\]: (.*)", re.DOTALL)


@pytest.fixture(autouse=True)
def fresh_log(monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    colour = ("NO_COLOR", "FORCE_COLOR", "RCUTILS_COLORIZED_OUTPUT")
    output = ("RCUTILS_CONSOLE_OUTPUT_FORMAT", "RCUTILS_LOGGING_USE_STDOUT")
    for variable in (*colour, *output, "ZBOT_LOG_DIR", "ROS_LOG_DIR", "ROS_HOME"):
        monkeypatch.delenv(variable, raising=False)
    log.clear_config()
    yield
    log.clear_config()


@pytest.fixture
def logged(capsys: pytest.CaptureFixture[str]) -> Logged:
    """Return a function that returns the messages written to stderr since its last call."""

    def read() -> list[str]:
        matches = map(LINE.fullmatch, capsys.readouterr().err.splitlines())
        return [match[4] if match else "not a log line" for match in matches]

    return read
