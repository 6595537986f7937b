"""Tests of the figures of `zbot topic hz` and `bw` with a clock that the test sets."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest

from zbot_cli.commands.topic.bw import Bandwidths
from zbot_cli.commands.topic.hz import Rates

if TYPE_CHECKING:
    from zbot_cli.commands.topic.measurement import Measurement


class ManualClock:
    """Clock that a test sets: `now`, in seconds, returned in nanoseconds."""

    def __init__(self) -> None:
        self.now = 0.0

    def __call__(self) -> int:
        return int(self.now * 1e9)


def test_rates_follow_the_given_clock() -> None:
    clock = ManualClock()
    meter = Rates(10).meter(clock)
    for second in (0, 1, 3, 5):  # 0: no time has been received yet
        clock.now = second
        meter.add(b"x")
    figures = meter.figures()
    assert figures is not None
    assert (figures["rate"], figures["min"], figures["window"]) == (0.5, 2, 2)
    assert meter.figures() is None


def test_bandwidths_follow_the_given_clock() -> None:
    clock = ManualClock()
    meter = Bandwidths(10).meter(clock)
    for second in (0, 1, 1):  # 0: no time has been received yet
        clock.now = second
        meter.add(b"1234")
    assert meter.figures() is None  # the simulation is paused
    clock.now = 5
    figures = meter.figures()
    assert figures is not None
    assert (figures["bytes_per_second"], figures["messages"]) == (2, 2)


@pytest.mark.parametrize("measurement", [Rates(10), Bandwidths(10)])
def test_a_jump_back_of_the_clock_resets_the_figures(
    measurement: Measurement, capsys: pytest.CaptureFixture[str]
) -> None:
    clock = ManualClock()
    meter = measurement.meter(clock)
    for second in (7, 8, 1):
        clock.now = second
        meter.add(b"x")
    assert meter.figures() is None
    assert capsys.readouterr().err == "time has reset, resetting counters\n"
