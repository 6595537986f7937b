"""Tests of the log of diagnostics: the tree, levels, ages and the history."""

from __future__ import annotations

from zbot.web.panels.diagnostics.diagnostics_log import DiagnosticsLog, Level

from diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus, KeyValue

S = 10**9
OK, WARN, ERROR, STALE = b"\0", b"\1", b"\2", b"\3"


def take(log: DiagnosticsLog, time_s: float, **statuses: tuple[bytes, str]) -> None:
    """Give statuses to a log. In their names, `__` is a slash."""
    status = [
        DiagnosticStatus(name="/" + name.replace("__", "/"), level=level, message=message)
        for name, (level, message) in statuses.items()
    ]
    log.take(DiagnosticArray(status=status), int(time_s * S))


def lines(log: DiagnosticsLog, time_s: float) -> list[tuple[str, int, Level]]:
    branches = log.tree(int(time_s * S)).worst_first()
    return [(branch.path, branch.depth, branch.level) for branch in branches]


def test_the_worst_comes_first_in_each_group() -> None:
    log = DiagnosticsLog()
    take(
        log,
        1,
        arm__elbow=(OK, ""),
        arm__wrist=(WARN, "warm"),
        base__left=(ERROR, "stuck"),
        base__right=(STALE, ""),
        camera=(OK, ""),
    )
    assert lines(log, 1) == [
        ("base", 0, Level.ERROR),
        ("base/left", 1, Level.ERROR),
        ("base/right", 1, Level.STALE),
        ("arm", 0, Level.WARN),
        ("arm/wrist", 1, Level.WARN),
        ("arm/elbow", 1, Level.OK),
        ("camera", 0, Level.OK),
    ]
    assert log.counts(S) == {Level.ERROR: 1, Level.STALE: 1, Level.WARN: 1, Level.OK: 2}


def test_a_group_has_the_level_of_its_own_status() -> None:
    log = DiagnosticsLog()
    take(log, 1, arm=(WARN, "one of two"), arm__elbow=(ERROR, "stuck"))
    assert lines(log, 1) == [("arm", 0, Level.WARN), ("arm/elbow", 1, Level.ERROR)]
    assert log.counts(S)[Level.WARN] == 0  # a group is not counted


def test_a_status_is_stale_after_five_seconds_and_kept() -> None:
    log = DiagnosticsLog()
    take(log, 1, arm=(OK, "fine"))
    assert lines(log, 6) == [("arm", 0, Level.OK)]
    assert lines(log, 6.1) == [("arm", 0, Level.STALE)]
    assert log.entries["arm"].status.message == "fine"


def test_the_history_has_changes_only() -> None:
    log = DiagnosticsLog()
    for time_s in range(1, 4):
        take(log, time_s, arm=(OK, "fine"))
    take(log, 4, arm=(WARN, "warm"))
    take(log, 5, arm=(WARN, "hot"))
    take(log, 20, arm=(WARN, "hot"))
    changes = log.entries["arm"].changes
    assert [(change.time_ns / S, change.level, change.message) for change in changes] == [
        (1, Level.OK, "fine"),
        (4, Level.WARN, "warm"),
        (5, Level.WARN, "hot"),
        (10, Level.STALE, "no status for 5 s"),
        (20, Level.WARN, "hot"),
    ]


def test_memory_has_a_limit() -> None:
    log = DiagnosticsLog()
    for number in range(3000):
        take(log, number, **{f"n{number}": (OK, ""), "n0": (OK, str(number))})
    assert len(log.entries) == 2000
    assert len(log.entries["n0"].changes) == 100


def test_odd_names_and_levels_have_a_place() -> None:
    log = DiagnosticsLog()
    odd = [DiagnosticStatus(name="", level=b"\x09"), DiagnosticStatus(name="//a//b/", level=OK)]
    log.take(DiagnosticArray(status=odd), S)
    assert lines(log, 1) == [
        ("(no name)", 0, Level.ERROR),
        ("a", 0, Level.OK),
        ("a/b", 1, Level.OK),
    ]


def test_long_names_and_texts_are_cut() -> None:
    log = DiagnosticsLog()
    pairs = [KeyValue(key="k" * 1000, value="v" * 1000)] * 1000
    deep = DiagnosticStatus(
        name="a/" * 50_000, message="m" * 1000, hardware_id="h" * 1000, values=pairs
    )
    long = DiagnosticStatus(name=f"{'b' * 1000}/c")
    log.take(DiagnosticArray(status=[deep, long]), S)
    paths = [branch.path for branch in log.tree(S).worst_first()]
    assert paths[9:] == ["a/a/a/a/a/a/a/a/a/a", "b" * 100, f"{'b' * 100}/c"]
    status = log.entries[paths[9]].status
    assert (len(status.message), len(status.hardware_id)) == (500, 100)
    assert status.values == (("k" * 100, "v" * 500),) * 200
    assert log.entries[paths[9]].changes[0].message == "m" * 500
