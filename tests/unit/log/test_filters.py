from __future__ import annotations

from typing import TYPE_CHECKING, Any

import pytest

from zbot.errors import ArgumentTypeError, WrongTypeError, WrongValueError, ZbotError
from zbot.log import LoggingSeverity, get_logger, warn_once
from zbot.time import Time

if TYPE_CHECKING:
    from tests.unit.log.conftest import Logged


INFO, WARN, ERROR = LoggingSeverity.INFO, LoggingSeverity.WARN, LoggingSeverity.ERROR


class FakeClock:
    def __init__(self) -> None:
        self.sec = 0.0

    def now(self) -> Time:
        return Time(seconds=self.sec)


def test_once_writes_the_first_call_at_a_place(logged: Logged) -> None:
    logger = get_logger("sensor")
    written = [logger.info(number, once=True) for number in range(3)]
    written += [logger.info("elsewhere", once=True), logger.info("same line", once=True)]
    assert written == [True, False, False, True, True]
    assert logged() == ["0", "elsewhere", "same line"]


def test_once_is_remembered_for_each_logger(logged: Logged) -> None:
    for name in ("a", "b", "a"):
        get_logger(name).info(name, once=True)
    assert logged() == ["a", "b", "a"]


def test_once_waits_until_the_level_lets_it_through() -> None:
    logger = get_logger("sensor")
    logged = []
    for level in (ERROR, INFO, INFO):
        logger.set_level(level)
        logged.append(logger.info("text", once=True))
    assert logged == [False, True, False]


def test_skip_first_writes_all_but_the_first() -> None:
    logger = get_logger("sensor")
    assert [logger.info("text", skip_first=True) for _ in range(3)] == [False, True, True]


def test_skip_first_and_once_write_the_second() -> None:
    logger = get_logger("sensor")
    logged = [logger.info("text", skip_first=True, once=True) for _ in range(4)]
    assert logged == [False, True, False, False]


@pytest.mark.parametrize(
    ("duration_s", "times_s", "expected"),
    [
        (1.0, (1.0, 1.5, 1.99, 2.0, 2.5, 7.0, 7.1), [True, False, False, True, False, True, False]),
        (1.0, (100.0, 100.5, 0.0, 0.5), [True, False, True, False]),
        (2.0, (0.0, 1.0, 2.0, 3.0), [False, False, True, False]),
    ],
    ids=["one line in its duration", "simulated time begins again", "it has not begun"],
)
def test_throttle_measures_the_time_of_its_clock(
    duration_s: float, times_s: tuple[float, ...], expected: list[bool]
) -> None:
    logger, clock, logged = get_logger("sensor"), FakeClock(), []
    options: dict[str, Any] = {
        "throttle_duration_sec": duration_s,
        "throttle_time_source_type": clock,
    }
    for clock.sec in times_s:
        logged.append(logger.info("text", **options))
    assert logged == expected


def test_throttle_measures_monotonic_time_by_default() -> None:
    logger = get_logger("sensor")
    assert [logger.info("text", throttle_duration_sec=3600) for _ in range(3)] == [
        True,
        False,
        False,
    ]


@pytest.mark.parametrize("options", [{"once": False}, {"throttle_duration_sec": 0}])
def test_filter_that_is_off_does_nothing(options: dict[str, Any]) -> None:
    logger = get_logger("sensor")
    assert [logger.info("text", **options) for _ in range(3)] == [True] * 3


def test_other_name_is_used_for_the_line(capsys: pytest.CaptureFixture[str]) -> None:
    get_logger("sensor").info("text", name="driver")
    assert "[driver]: text" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("options", "error", "text"),
    [
        ({"onse": True}, WrongTypeError, "parameter 'onse' is not one of the recognized"),
        (
            {"throttle_time_source_type": FakeClock()},
            WrongTypeError,
            "required parameter.*not specified",
        ),
        ({"severity": ERROR}, WrongTypeError, "multiple values for argument 'severity'"),
        ({"throttle_duration_sec": "1"}, ArgumentTypeError, "number of seconds"),
        (
            {"throttle_duration_sec": 1, "throttle_time_source_type": "STEADY"},
            WrongValueError,
            "'STEADY'",
        ),
    ],
)
def test_wrong_option_is_refused(
    options: dict[str, Any], error: type[ZbotError], text: str
) -> None:
    with pytest.raises(error, match=text):
        get_logger("sensor").info("text", **options)


@pytest.mark.parametrize(
    ("first", "second", "what"),
    [
        ({"severity": INFO}, {"severity": WARN}, "severity"),
        ({"severity": INFO, "name": "a"}, {"severity": INFO, "name": "b"}, "logger name"),
        ({"severity": INFO}, {"severity": INFO, "once": True}, "filter parameters"),
        (
            {"severity": INFO, "throttle_duration_sec": 1.0},
            {"severity": INFO, "throttle_duration_sec": 2.0},
            "filter parameters",
        ),
    ],
)
def test_the_log_call_at_a_place_cannot_change(
    first: dict[str, Any], second: dict[str, Any], what: str
) -> None:
    logger = get_logger("sensor")

    def place(options: dict[str, Any]) -> bool:
        return logger.log("text", **options)

    assert place(first)
    assert place(first) or "throttle_duration_sec" in first
    with pytest.raises(WrongValueError, match=rf"{what} .*test_filters\.py:\d+"):
        place(second)


def test_zbot_warns_of_the_same_thing_once(logged: Logged) -> None:
    for text in ("no free port", "no free port", "no free file", "no free port"):
        warn_once(text)
    assert logged() == ["no free port", "no free file"]
