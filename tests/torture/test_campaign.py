"""Short forms of the long runs, so that they work when they are needed."""

from __future__ import annotations

import shutil
import subprocess
import sys
import time
from pathlib import Path

import pytest

from tests.conftest import allowed
from tests.torture import domain_chaos, faults, nightly, random_ends
from tests.torture.faults import Schedule, plan
from tests.torture.report import Report, times
from tests.torture.stall import StallMeter

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


IMPORT = """Traceback (most recent call last):
  File "ring_node.py", line 69, in main
    with zbot.init():
  File "<frozen importlib._bootstrap>", line 1387, in _gcd_import
"""
MODULE = """Traceback (most recent call last):
  File "ring_node.py", line 21, in <module>
    import zbot
  File "zbot/__init__.py", line 20, in <module>
    from zbot.interfaces.finder import install_importer
"""
SPIN = """Traceback (most recent call last):
  File "ring_node.py", line 80, in <module>
    main()
  File "zbot/__init__.py", line 90, in spin
"""
NOTE = "Error calling __set_name__ on '_proto_member' instance 'BOOL_ARRAY' in 'Type'\n"


@pytest.mark.parametrize(
    ("text", "is_of_import"),
    [
        (f"{IMPORT}KeyboardInterrupt\n", True),
        (f"{IMPORT}KeyboardInterrupt\n{NOTE}", True),
        (f"{IMPORT}KeyboardInterrupt", True),
        (f"{IMPORT}ValueError: KeyboardInterrupt\n", False),
        (f"{MODULE}KeyboardInterrupt\n", True),
        (f"{SPIN}KeyboardInterrupt\n", False),
        (f"{SPIN}KeyboardInterrupt\n\n{SPIN}KeyboardInterrupt\n", False),
    ],
)
def test_only_ctrl_c_during_an_import_may_print_a_traceback(text: str, is_of_import: bool) -> None:
    assert random_ends.is_of_import(text) is is_of_import


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
        ("churn", "--runs", "1200", "--kind", "publisher", "--starts", "1200"),
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


def test_the_runs_of_a_night_share_the_time(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    assert sum(one.share for one in nightly.RUNS) == pytest.approx(1)
    commands = [" ".join(one.command(600)) for one in nightly.RUNS]
    assert any(command.endswith("chaos --minutes 10.000") for command in commands)
    assert any(command.endswith("random_ends --runs 1500") for command in commands)

    programs = {"good": "print('   1.00 s  0 promises broken')", "bad": "import sys; sys.exit(3)"}
    for name, source in programs.items():
        (tmp_path / f"{name}.py").write_text(source, encoding="utf-8")
    runs = tuple(nightly.Run(name, 0.5, 60, "") for name in programs)
    monkeypatch.setattr(nightly, "RUNS", runs)
    monkeypatch.setattr(
        nightly.Run, "command", lambda one, _: [sys.executable, str(tmp_path / f"{one.name}.py")]
    )
    monkeypatch.setattr(sys, "argv", ["nightly", "--minutes", "1"])
    assert nightly.main() == 1
    said = capsys.readouterr().out
    assert "good: kept all promises" in said
    assert "    1.00 s  0 promises broken" in said
    assert "bad: exit code 3" in said
    folder = Path(said.splitlines()[-1].removeprefix("outputs: "))
    assert (folder / "report.txt").read_text(encoding="utf-8") in said
    shutil.rmtree(folder)


def test_a_run_that_takes_too_long_is_interrupted(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(nightly, "_END_S", 0.5)
    source = "import sys, time\ntry: time.sleep(60)\nexcept KeyboardInterrupt: sys.exit(130)"
    command = [sys.executable, "-c", source]
    monkeypatch.setattr(nightly.Run, "command", lambda *_: command)
    lines = nightly.run(nightly.Run("slow", 1, 60, ""), 0.1, tmp_path / "slow.txt")
    assert lines[0].startswith("slow: interrupted, ")
