"""Short forms of the long runs, so that they work when they are needed."""

from __future__ import annotations

import subprocess
import sys
import time
from typing import TYPE_CHECKING

import pytest

from tests.conftest import allowed
from tests.torture import domain_chaos, faults, random_ends
from tests.torture.faults import Schedule, plan
from tests.torture.report import Report, times
from tests.torture.stall import StallMeter

if TYPE_CHECKING:
    from pathlib import Path

linux_only = pytest.mark.skipif(sys.platform != "linux", reason="needs Linux's list of processes")


def test_a_seed_makes_the_same_faults() -> None:
    kinds = {"kill": 2.0, "stop": 1.0}
    planned = plan("a", kinds, 100, 1.0)
    assert planned == plan("a", kinds, 100, 1.0)
    assert planned != plan("b", kinds, 100, 1.0)
    assert {fault.kind for fault in planned} == set(kinds)
    assert all(0 < fault.at_s < 100 for fault in planned)
    assert list(random_ends.ends("a", 50)) == list(random_ends.ends("a", 50))


def test_each_kind_of_fault_has_a_function() -> None:
    for kind in domain_chaos._KINDS:
        assert hasattr(domain_chaos.DomainChaos, f"_fault_{kind.replace(' ', '_')}")


class Clock:
    """Time that passes only while the schedule sleeps."""

    now_s = 0.0

    def monotonic(self) -> float:
        return self.now_s

    def sleep(self, seconds: float) -> None:
        self.now_s += seconds


def test_functions_are_called_in_the_order_of_their_times(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(faults, "time", clock := Clock())
    schedule, called = Schedule(), list[tuple[int, float]]()
    for delay_s in (3, 1, 2):
        schedule.add(delay_s, lambda number=delay_s: called.append((number, clock.now_s)))  # type: ignore[misc]
    schedule.finish()
    assert called == [(1, 1.0), (2, 2.0), (3, 3.0)]


def test_a_broken_promise_is_reported(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    report = Report()
    report.violation("a node hangs")
    assert report.end("python -m x --seed a", tmp_path, StallMeter()) == 1
    said = capsys.readouterr().out
    assert "again: python -m x --seed a" in said
    assert f"outputs: {tmp_path}" in said
    assert tmp_path.exists()
    assert times([1.0, 3.0, 2.0]).startswith("median 2.00 s")


def test_the_outputs_of_a_run_that_breaks_no_promise_are_removed(tmp_path: Path) -> None:
    (tmp_path / "run").mkdir()
    assert Report().end("again", tmp_path / "run", StallMeter()) == 0
    assert not (tmp_path / "run").exists()


def test_an_interrupted_run_has_an_exit_code_of_its_own(tmp_path: Path) -> None:
    report = Report()
    with report.until_interrupted():
        raise KeyboardInterrupt
    assert report.end("again", tmp_path / "run", StallMeter()) == 130


def test_limits_are_never_shorter_than_on_a_quiet_machine() -> None:
    with StallMeter() as stall:
        begin = time.monotonic()
        assert stall.allowed(2.0, begin) >= 2.0


@linux_only
@pytest.mark.parametrize(
    "words",
    [
        ("random_ends", "--runs", "6", "--seed", "ci"),
        ("meeting_point_holders", "--runs", "1", "--seed", "ci", "--kind", "killed"),
        ("churn", "--runs", "4000", "--kind", "publisher", "--starts", "1200"),
    ],
    ids=["ends", "holders", "churn"],
)
def test_a_short_run_breaks_no_promise(words: tuple[str, ...]) -> None:
    done = subprocess.run(
        [sys.executable, "-m", f"tests.torture.{words[0]}", *words[1:]],
        capture_output=True,
        text=True,
        timeout=allowed(60),
        check=False,
    )
    assert done.returncode == 0, done.stdout + done.stderr
