from __future__ import annotations

from zbot.web.pace import Pace


def test_update_runs_no_more_often_than_it_wants() -> None:
    faults, runs = list[Exception](), list[str]()
    pace = Pace(faults.append)
    pace.add(lambda: runs.append("fast"), 30)
    pace.add(lambda: runs.append("slow"), 2)
    for frame in range(60):  # one second of a display of 60 Hz
        pace.run(frame / 60)
    assert runs.count("fast") == 30
    assert runs.count("slow") == 2
    assert faults == []


def test_update_ends_when_it_is_undone_even_by_another_update() -> None:
    runs = list[str]()
    pace = Pace(lambda _: None)

    def first() -> None:
        runs.append("first")
        undo_second()
        undo_second()

    pace.add(first, 30)
    undo_second = pace.add(lambda: runs.append("second"), 30)
    pace.run(0.0)
    pace.run(1.0)
    assert runs == ["first", "first"]


def fail() -> None:
    raise RuntimeError("no")


def test_fault_stops_its_update_and_no_other() -> None:
    faults, runs = list[Exception](), list[int]()
    pace = Pace(faults.append)
    pace.add(fail, 30)
    pace.add(lambda: runs.append(1), 30)
    pace.run(0.0)
    pace.run(1.0)
    assert [type(fault) for fault in faults] == [RuntimeError]
    assert runs == [1, 1]
