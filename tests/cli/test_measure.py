"""Figures of `zbot topic hz` and `bw` by a clock that a test turns."""

from __future__ import annotations

import pytest

from zbot_cli.commands.topic.measurement import Bandwidths, Kind, Rates


class Hands:
    """A clock; `now` is in seconds."""

    def __init__(self) -> None:
        self.now = 0.0

    def __call__(self) -> int:
        return int(self.now * 1e9)


def test_rates_follow_the_clock_that_is_given() -> None:
    clock = Hands()
    meter = Rates(10).meter(clock)
    for second in (0, 1, 3, 5):  # at 0, no time has come yet
        clock.now = second
        meter.add(b"x")
    figures = meter.figures()
    assert figures is not None
    assert (figures["rate"], figures["min"], figures["window"]) == (0.5, 2, 2)
    assert meter.figures() is None


def test_bandwidths_follow_the_clock_that_is_given() -> None:
    clock = Hands()
    meter = Bandwidths(10).meter(clock)
    for second in (0, 1, 1):  # at 0, no time has come yet
        clock.now = second
        meter.add(b"1234")
    assert meter.figures() is None  # a simulation that is paused
    clock.now = 5
    figures = meter.figures()
    assert figures is not None
    assert (figures["bytes_per_second"], figures["messages"]) == (2, 2)


@pytest.mark.parametrize("kind", [Rates(10), Bandwidths(10)])
def test_a_clock_that_is_set_back_begins_the_figures_anew(
    kind: Kind, capsys: pytest.CaptureFixture[str]
) -> None:
    clock = Hands()
    meter = kind.meter(clock)
    for second in (7, 8, 1):
        clock.now = second
        meter.add(b"x")
    assert meter.figures() is None
    assert capsys.readouterr().err == "time has reset, resetting counters\n"
