from __future__ import annotations

from zbot.observer.log_ring import LogRing

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
