from __future__ import annotations

from zbot.web.log_ring import LogRing

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
