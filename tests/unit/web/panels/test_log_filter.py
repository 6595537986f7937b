"""Tests of the filter of log lines."""

from __future__ import annotations

import pytest

from zbot.observer.log_ring import LogLine
from zbot.web.panels.console.log_filter import LogFilter, counts, level_of, newest


def line(level: int = 20, name: str = "robot.arm", text: str = "Moves on") -> LogLine:
    return LogLine(1, 0, level, name, text, "", "", 0)


@pytest.mark.parametrize(
    ("wanted", "condition"),
    [
        (LogFilter(), ""),
        (LogFilter(level=20), "m.level >= 20"),
        (LogFilter(logger="robot"), "m.name == 'robot'"),
        (LogFilter(logger="robot.arm"), "m.name == 'robot.arm'"),
        (LogFilter(text="MOVES"), "'moves' in m.msg.lower()"),
        (LogFilter(text="arm"), "'arm' in m.msg.lower()"),
        (LogFilter(20, "robot"), "m.level >= 20 and m.name == 'robot'"),
    ],
)  # fmt: skip
def test_matching_lines_pass(wanted: LogFilter, condition: str) -> None:
    assert wanted.matches(line())
    assert wanted.condition == condition


@pytest.mark.parametrize(
    "wanted", [LogFilter(level=30), LogFilter(logger="rob"), LogFilter(text="stops")]
)
def test_other_lines_do_not_pass(wanted: LogFilter) -> None:
    assert not wanted.matches(line())


def test_lines_are_counted_by_level() -> None:
    assert counts([line(10), line(20), line(25), line(255), line(0)]) == {10: 2, 20: 2, 50: 1}
    assert level_of(line(40)) == 40


def test_the_newest_lines_have_a_limited_size() -> None:
    lines = [line(name="", text=text) for text in ("aaaa", "bbb", "ccccc", "dd")]
    assert newest(lines, 10) == lines[1:]
    assert newest(lines, 9) == lines[2:]
    assert newest(lines, 1) == lines[3:]
    assert newest(lines, 99) == lines
    assert newest([], 5) == []
