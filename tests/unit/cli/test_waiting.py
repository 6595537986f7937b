"""Waiting of commands."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import pytest

from zbot_cli.domain import waiting
from zbot_cli.domain.waiting import PeriodicSleep

CONTEXT: Any = SimpleNamespace(add_waker=lambda _: None)


class FakeSleep(PeriodicSleep):
    """Sleep on a clock of its own. `times` are the ends of the sleeps."""

    now_s = 0.0

    def __init__(self, rate_hz: float) -> None:
        super().__init__(CONTEXT, rate_hz)
        self.times: list[float] = []

    def until(self, time_s: float) -> None:
        FakeSleep.now_s = max(self.now_s, time_s)
        self.times.append(self.now_s)


@pytest.fixture
def work(monkeypatch: pytest.MonkeyPatch) -> Any:
    def work(seconds: float) -> None:
        FakeSleep.now_s += seconds

    monkeypatch.setattr(FakeSleep, "now_s", 100.0)
    monkeypatch.setattr(waiting, "time", SimpleNamespace(monotonic=lambda: FakeSleep.now_s))
    return work


@pytest.mark.parametrize(
    ("rate_hz", "seconds", "times"),
    [
        pytest.param(10, [0, 0.02, 0], [100.1, 100.2, 100.3], id="the work is short"),
        pytest.param(10, [0.15, 0, 0], [100.15, 100.2, 100.3], id="a delay is made up for"),
        pytest.param(1000, [0.002, 0, 0], [100.002, 100.002, 100.003], id="a high rate"),
        pytest.param(10, [600, 0, 0], [700, 700.1, 700.2], id="the program was suspended"),
        pytest.param(0.5, [600, 0, 0], [700, 702, 704], id="a low rate"),
    ],
)
def test_periods_that_were_missed_are_left_out(
    work: Any, rate_hz: float, seconds: list[float], times: list[float]
) -> None:
    sleep = FakeSleep(rate_hz)
    for work_s in seconds:
        work(work_s)
        sleep.until_next()
    assert sleep.times == pytest.approx(times)
