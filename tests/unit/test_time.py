from __future__ import annotations

import operator
import sys
from types import ModuleType, SimpleNamespace
from typing import TYPE_CHECKING, Any

import pytest

from zbot.errors import ArgumentTypeError, TimeOverflowError, WrongTypeError, WrongValueError
from zbot.time import S_TO_NS, ClockType, Duration, Infinite, Time

if TYPE_CHECKING:
    from collections.abc import Callable

ROS = ClockType.ROS_TIME


@pytest.mark.parametrize(
    ("seconds", "nanoseconds", "expected"),
    [
        (0, 0, 0),
        (1, 2, 1_000_000_002),
        (1.5, 0, 1_500_000_000),
        (0.1, 0, 100_000_000),
        (0, 1.7, 1),
        (1700000000, 123456789, 1_700_000_000_123_456_789),
    ],
)
def test_seconds_and_nanoseconds_add_up(seconds: float, nanoseconds: float, expected: int) -> None:
    assert Time(seconds=seconds, nanoseconds=nanoseconds).nanoseconds == expected
    assert Duration(seconds=seconds, nanoseconds=nanoseconds).nanoseconds == expected


def test_reprs_are_those_of_ros() -> None:
    assert repr(Time(seconds=1)) == "Time(nanoseconds=1000000000, clock_type=SYSTEM_TIME)"
    assert repr(Time(clock_type=ROS)) == "Time(nanoseconds=0, clock_type=ROS_TIME)"
    assert repr(Duration(seconds=-1)) == "Duration(nanoseconds=-1000000000)"
    assert str(Duration(seconds=-1.5)) == "-1500000000 nanoseconds"


def test_time_splits_into_seconds_and_nanoseconds() -> None:
    assert Time(seconds=3, nanoseconds=4).seconds_nanoseconds() == (3, 4)


def test_arithmetic_keeps_the_clock_type() -> None:
    time = Time(seconds=5, clock_type=ROS)
    assert time + Duration(seconds=1) == Time(seconds=6, clock_type=ROS)
    assert Duration(seconds=1) + time == Time(seconds=6, clock_type=ROS)
    assert time - Duration(seconds=1) == Time(seconds=4, clock_type=ROS)
    assert time - Time(seconds=7, clock_type=ROS) == Duration(seconds=-2)


@pytest.mark.parametrize("factor", [float("nan"), float("-inf")])
def test_a_duration_is_not_multiplied_by_nan(factor: float) -> None:
    with pytest.raises(ValueError, match="duration out of range"):
        operator.mul(Duration(seconds=1), factor)


def test_durations_add_subtract_and_scale() -> None:
    one, two = Duration(seconds=1), Duration(seconds=2)
    assert one + two == Duration(seconds=3)
    assert one - two == Duration(seconds=-1)
    assert one * 2 == 2 * one == two
    assert two * 0.5 == one


def test_comparisons_order_times_and_durations() -> None:
    early, late = Time(seconds=1), Time(seconds=2)
    assert early < late
    assert early <= late
    assert late > early
    assert late >= early
    assert early != late
    assert Duration(seconds=1) < Duration(seconds=2) <= Infinite
    assert Infinite > Duration() >= Duration(seconds=-1)


def test_comparing_with_something_else_is_false_or_a_type_error() -> None:
    assert Time(seconds=1) != 1
    assert Duration(seconds=1) != 1
    with pytest.raises(TypeError):
        assert Time() < 1  # type: ignore[operator]  # pyright: ignore[reportOperatorIssue]
    with pytest.raises(TypeError):
        Duration() + 1  # type: ignore[operator]  # pyright: ignore[reportOperatorIssue]


@pytest.mark.parametrize(
    "operation",
    [
        lambda a, b: a == b,
        lambda a, b: a != b,
        lambda a, b: a < b,
        lambda a, b: a >= b,
        lambda a, b: a - b,
    ],
)
def test_different_clock_types_do_not_mix(operation: Callable[[Time, Time], object]) -> None:
    with pytest.raises(WrongTypeError, match="SYSTEM_TIME and ROS_TIME"):
        operation(Time(seconds=1), Time(seconds=1, clock_type=ROS))


def test_equal_values_have_equal_hashes() -> None:
    assert {Time(seconds=1), Time(nanoseconds=S_TO_NS)} == {Time(seconds=1)}
    assert hash(Duration(seconds=1)) == hash(Duration(nanoseconds=S_TO_NS))


@pytest.mark.parametrize("arguments", [{"seconds": -1}, {"nanoseconds": -1}])
def test_a_time_is_never_negative(arguments: dict[str, float]) -> None:
    with pytest.raises(WrongValueError, match="must not be negative: -1"):
        Time(**arguments)  # type: ignore[arg-type]  # pyright: ignore[reportArgumentType]


def test_subtracting_too_much_is_refused() -> None:
    with pytest.raises(WrongValueError):
        _ = Time(seconds=1) - Duration(seconds=2)


@pytest.mark.parametrize("kind", [Time, Duration])
@pytest.mark.parametrize("seconds", [1e30, float("inf"), float("nan"), 2**63])
def test_values_beyond_64_bits_overflow(kind: type[Time | Duration], seconds: float) -> None:
    with pytest.raises(TimeOverflowError, match="out of range"):
        kind(seconds=seconds)


@pytest.mark.parametrize("kind", [Time, Duration])
def test_a_text_is_not_a_number(kind: type[Time | Duration]) -> None:
    with pytest.raises(ArgumentTypeError, match="seconds must be a number, not str: 'a'"):
        kind(seconds="a")  # type: ignore[arg-type]  # pyright: ignore[reportArgumentType]


def test_numpy_numbers_are_accepted_as_python_numbers() -> None:
    numpy = pytest.importorskip("numpy")
    assert Duration(seconds=numpy.int32(5)).nanoseconds == 5 * S_TO_NS
    assert Duration(seconds=numpy.float32(0.5)).nanoseconds == S_TO_NS // 2


def test_an_invalid_clock_type_is_refused() -> None:
    with pytest.raises(ArgumentTypeError, match="clock_type must be a ClockType"):
        Time(clock_type=1)  # type: ignore[arg-type]  # pyright: ignore[reportArgumentType]


def test_infinite_is_the_longest_duration() -> None:
    assert Infinite.nanoseconds == 2**63 - 1


def test_from_msg_reads_seconds_and_nanoseconds() -> None:
    message = SimpleNamespace(sec=2, nanosec=500)
    assert Time.from_msg(message) == Time(nanoseconds=2 * S_TO_NS + 500, clock_type=ROS)
    assert Duration.from_msg(SimpleNamespace(sec=-2, nanosec=500_000_000)) == Duration(seconds=-1.5)


@pytest.mark.parametrize("kind", [Time, Duration])
def test_from_msg_needs_a_message(kind: type[Time | Duration]) -> None:
    with pytest.raises(ArgumentTypeError, match="builtin_interfaces/msg"):
        kind.from_msg(3)


def test_to_msg_splits_below_zero_as_ros_does(monkeypatch: pytest.MonkeyPatch) -> None:
    module = ModuleType("builtin_interfaces.msg")
    vars(module).update(Time=SimpleNamespace, Duration=SimpleNamespace)
    monkeypatch.setitem(sys.modules, "builtin_interfaces", ModuleType("builtin_interfaces"))
    monkeypatch.setitem(sys.modules, "builtin_interfaces.msg", module)
    assert Time(seconds=2.5).to_msg() == SimpleNamespace(sec=2, nanosec=500_000_000)
    assert Duration(seconds=-1.5).to_msg() == SimpleNamespace(sec=-2, nanosec=500_000_000)


def test_infinite_survives_a_message_and_any_factor() -> None:
    assert Duration.from_msg(Infinite.to_msg()) == Infinite
    assert Infinite.to_msg().sec == 2**31 - 1
    assert Duration(seconds=1) * float("inf") == Infinite
    assert str(Infinite) == "Infinite"
    assert str(Duration(nanoseconds=5)) == "5 nanoseconds"


@pytest.mark.parametrize("kind", [Time, Duration])
def test_programs_may_attach_attributes_of_their_own(kind: type[Time | Duration]) -> None:
    moment: Any = kind(seconds=3.5)
    moment.secs = moment.nanoseconds // 10**9  # programs that were ported from ROS 1 do so
    assert moment.secs == 3
    assert moment == kind(seconds=3.5)
