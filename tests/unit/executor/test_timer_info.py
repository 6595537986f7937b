from __future__ import annotations

from typing import Any

import pytest

from zbot.errors import ArgumentTypeError, NegativeTimeError
from zbot.executor.timer import TimerInfo
from zbot.time import ClockType, Time


def test_times_are_nanoseconds_of_one_kind_of_clock() -> None:
    info = TimerInfo(expected_call_time=5, actual_call_time=7, clock_type=ClockType.STEADY_TIME)
    assert info.expected_call_time == Time(nanoseconds=5, clock_type=ClockType.STEADY_TIME)
    assert info.actual_call_time == Time(nanoseconds=7, clock_type=ClockType.STEADY_TIME)


@pytest.mark.parametrize(
    ("arguments", "error"),
    [
        ({"clock_type": 1}, ArgumentTypeError),
        ({"expected_call_time": -1}, NegativeTimeError),
        ({"actual_call_time": -1}, NegativeTimeError),
    ],
)
def test_a_wrong_time_is_refused(arguments: Any, error: type[Exception]) -> None:
    with pytest.raises(error):
        TimerInfo(**arguments)
