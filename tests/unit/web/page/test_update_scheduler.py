from __future__ import annotations

from zbot.web.page.update_scheduler import UpdateScheduler


def test_update_runs_at_most_at_its_rate() -> None:
    faults, runs = list[Exception](), list[str]()
    pace = UpdateScheduler(faults.append)
    pace.add(lambda: runs.append("fast"), 30)
    pace.add(lambda: runs.append("slow"), 2)
    for frame in range(60):  # one second of a display of 60 Hz
        pace.run(frame / 60)
    assert runs.count("fast") == 30
    assert runs.count("slow") == 2
    assert faults == []


def test_removed_update_does_not_run_even_if_another_update_removed_it() -> None:
    runs = list[str]()
    pace = UpdateScheduler(lambda _: None)

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


def test_exception_stops_only_its_update() -> None:
    faults, runs = list[Exception](), list[int]()
    pace = UpdateScheduler(faults.append)
    pace.add(fail, 30)
    pace.add(lambda: runs.append(1), 30)
    pace.run(0.0)
    pace.run(1.0)
    assert [type(fault) for fault in faults] == [RuntimeError]
    assert runs == [1, 1]
