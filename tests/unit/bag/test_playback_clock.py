"""Clock of a playback."""

from __future__ import annotations

import math
from types import SimpleNamespace

import pytest

from zbot.bag import playback_clock
from zbot.bag.playback_clock import PlaybackClock
from zbot.time import S_TO_NS


class Machine:
    """Machine whose time passes when the test says so."""

    now_s = 1000.0

    def perf_counter(self) -> float:
        return self.now_s


@pytest.fixture
def machine(monkeypatch: pytest.MonkeyPatch) -> Machine:
    machine = Machine()
    monkeypatch.setattr(playback_clock, "time", SimpleNamespace(perf_counter=machine.perf_counter))
    return machine


def test_the_clock_runs_at_its_rate(machine: Machine) -> None:
    clock = PlaybackClock(5 * S_TO_NS, 2.0, is_paused=False)
    machine.now_s += 1
    assert clock.now_ns() == 7 * S_TO_NS
    assert clock.seconds_until(9 * S_TO_NS) == 1
    clock.set_rate(0.5)
    machine.now_s += 2
    assert clock.now_ns() == 8 * S_TO_NS


def test_the_clock_stands_still_during_a_pause(machine: Machine) -> None:
    clock = PlaybackClock(0, 1.0, is_paused=True)
    machine.now_s += 100
    assert (clock.now_ns(), clock.seconds_until(S_TO_NS)) == (0, math.inf)
    clock.resume()
    machine.now_s += 1
    assert clock.now_ns() == S_TO_NS


def test_the_clock_stands_still_while_the_program_is_suspended(machine: Machine) -> None:
    clock = PlaybackClock(0, 1.0, is_paused=False)
    machine.now_s += 1
    assert clock.seconds_until(2 * S_TO_NS) == 1
    machine.now_s += 600
    assert clock.seconds_until(2 * S_TO_NS) == 1
    machine.now_s += 1
    assert clock.now_ns() == 2 * S_TO_NS
