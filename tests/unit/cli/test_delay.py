"""Tests of the delays that `zbot topic delay` prints."""

from __future__ import annotations

import pytest

from zbot_cli.commands.topic.delay import Delays

from builtin_interfaces.msg import Time
from sensor_msgs.msg import Temperature
from std_msgs.msg import Header

NOW_S = 1_800_000_000


@pytest.mark.parametrize("seconds", [0, 75])  # without a clock, and since the start of a board
def test_stamps_of_a_board_without_a_clock_are_named_once(
    seconds: int, capsys: pytest.CaptureFixture[str]
) -> None:
    meter = Delays(3).meter(lambda: NOW_S * 10**9)
    for _ in range(3):
        meter.add(Temperature(header=Header(stamp=Time(sec=seconds))))
    assert capsys.readouterr().err.count("has no clock") == 1
    assert meter.figures() is not None


@pytest.mark.parametrize(("now_s", "stamp_s"), [(NOW_S, NOW_S - 1), (80, 75)])
def test_stamps_of_a_clock_and_of_simulated_time_are_not_named(
    now_s: int, stamp_s: int, capsys: pytest.CaptureFixture[str]
) -> None:
    meter = Delays(3).meter(lambda: now_s * 10**9)
    meter.add(Temperature(header=Header(stamp=Time(sec=stamp_s))))
    assert capsys.readouterr().err == ""
