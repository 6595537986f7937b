from __future__ import annotations

import pytest

from zbot.observer.log_ring import LogFilter, LogLine, LogRing, counts, level_of, newest

from rcl_interfaces.msg import Log


def test_since_returns_only_new_lines() -> None:
    ring = LogRing()
    assert ring.since(0) == []
    ring.add(Log(level=20, name="talker", msg="one"))
    assert [line.text for line in ring.since(0)] == ["one"]
    ring.add(Log(level=40, name="talker", msg="two"))
    (line,) = ring.since(1)
    assert (line.number, line.level, line.name, line.text) == (2, 40, "talker", "two")
    assert ring.since(ring.last) == []


def test_old_lines_are_dropped_and_numbers_stay() -> None:
    ring = LogRing(capacity=3)
    for number in range(10):
        ring.add(Log(msg=str(number)))
    assert [(line.number, line.text) for line in ring.since(0)] == [(8, "7"), (9, "8"), (10, "9")]
    assert [line.number for line in ring.since(9)] == [10]


def test_since_a_future_number_returns_nothing() -> None:
    ring = LogRing()
    ring.add(Log(msg="one"))
    assert ring.since(99) == []


def test_long_texts_are_shortened() -> None:
    ring = LogRing()
    ring.add(Log(msg="a" * 50_000, name="b" * 50_000, file="c" * 50_000, function="d" * 50_000))
    (line,) = ring.since(0)
    assert line.text == "a" * 9_999 + "…"
    assert line.characters == 10_000 + 3 * 250


def test_a_flood_of_long_lines_has_a_limit() -> None:
    ring = LogRing()
    for number in range(3_000):
        ring.add(Log(msg=f"{number} ".ljust(20_000, "a")))
    kept = ring.since(0)
    assert sum(line.characters for line in kept) <= 10_000_000
    assert len(kept) == 1_000
    assert kept[-1].text.startswith("2999 ")
    assert [line.number for line in ring.since(2_999)] == [3_000]


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
