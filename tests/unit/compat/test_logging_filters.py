"""Tests of the filters of `rclpy.impl.rcutils_logger`, called as its loggers call them."""

from __future__ import annotations

import inspect
from typing import Any

import pytest

from zbot.compat.logging_filters import (
    CallerId,
    LoggingFilter,
    Once,
    SkipFirst,
    Throttle,
    get_filters_from_kwargs,
    supported_filters,
)
from zbot.errors import WrongTypeError, WrongValueError
from zbot.executor.clock import Clock
from zbot.time import Time


class _Clock(Clock):
    seconds = 1000

    def now(self) -> Time:
        return Time(seconds=self.seconds)


@pytest.mark.parametrize(
    ("options", "expected"),
    [
        ({}, []),
        ({"once": True}, ["once"]),
        ({"once": False}, []),
        ({"throttle_duration_sec": 1.0, "once": True}, ["throttle", "once"]),
        ({"once": True, "skip_first": True}, ["skip_first", "once"]),
    ],
)
def test_options_switch_filters_on(options: dict[str, Any], expected: list[str]) -> None:
    assert get_filters_from_kwargs(**options) == expected


@pytest.mark.parametrize("options", [{"bogus": 1}, {"throttle_time_source_type": Clock()}])
def test_options_that_do_not_fit_are_refused(options: dict[str, Any]) -> None:
    with pytest.raises(WrongTypeError):
        get_filters_from_kwargs(**options)


def test_once_admits_the_first_call() -> None:
    context: dict[str, Any] = {}
    Once.initialize_context(context, once=True)
    assert [Once.should_log(context) for _ in range(3)] == [True, False, False]


def test_skip_first_admits_all_but_the_first_call() -> None:
    context: dict[str, Any] = {}
    SkipFirst.initialize_context(context, skip_first=True)
    assert [SkipFirst.should_log(context) for _ in range(3)] == [False, True, True]


def test_throttle_admits_a_call_when_the_duration_is_over() -> None:
    clock: Any = _Clock()
    context: dict[str, Any] = {}
    Throttle.initialize_context(context, throttle_duration_sec=2.0, throttle_time_source_type=clock)
    admitted = []
    for clock.seconds in range(1000, 1005):
        admitted.append(Throttle.should_log(context))
    assert admitted == [True, False, True, False, True]


def test_a_filter_names_missing_parameters() -> None:
    with pytest.raises(WrongTypeError, match="'once' is missing"):
        Once.initialize_context({})
    with pytest.raises(WrongValueError):
        Throttle.initialize_context({}, throttle_duration_sec=1.0, throttle_time_source_type=3)


def test_a_filter_of_a_program_is_applied() -> None:
    class Never(LoggingFilter):
        params = {"never": None}  # type: ignore[typeddict-unknown-key]  # noqa: RUF012

        @staticmethod
        def should_log(context: Any) -> bool:  # noqa: ARG004
            return False

    supported_filters["never"] = Never  # type: ignore[index]
    try:
        assert get_filters_from_kwargs(never=True) == ["never"]
    finally:
        del supported_filters["never"]  # type: ignore[arg-type]


def test_a_log_call_is_identified_by_its_place() -> None:
    first, second = CallerId(), CallerId()
    assert first.function_name == "test_a_log_call_is_identified_by_its_place"
    assert first.file_path == __file__
    assert second.line_number == first.line_number
    assert first != second
    assert CallerId(inspect.currentframe()).line_number == second.line_number + 5
