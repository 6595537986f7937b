"""Tests of the output that a launch keeps for the page."""

from __future__ import annotations

from zbot.launch.control.process_log import OutputTail


def test_lines_are_kept_when_they_are_whole() -> None:
    tail = OutputTail()
    tail.feed(1, b"one\r\ntw")
    tail.feed(2, b"error\n")
    tail.feed(1, b"o\n\xff\n")
    assert tail.since(0) == (4, ["one", "error", "two", "\\xff"])
    assert tail.since(3) == (4, ["\\xff"])
    assert tail.since(4) == tail.since(9) == (4, [])


def test_the_last_line_needs_no_line_end() -> None:
    tail = OutputTail()
    tail.feed(1, b"one")
    tail.end()
    tail.end()
    assert tail.since(0) == (1, ["one"])


def test_memory_has_a_limit() -> None:
    tail = OutputTail()
    for number in range(1000):
        tail.feed(1, f"{number}\n".encode())
    last, lines = tail.since(100)
    assert (last, lines[0], len(lines)) == (1000, "500", 500)
    tail.feed(1, b"x" * 10_000)
    tail.feed(1, b"\n")
    assert len(tail.since(1000)[1][0]) == 2000
