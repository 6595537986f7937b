"""Points in time and durations, in whole nanoseconds, as in ROS 2."""

from __future__ import annotations

import importlib
import numbers
from enum import Enum
from typing import Any, overload

from zbot.errors import ArgumentTypeError, TimeOverflowError, WrongTypeError, negative_time_error

__all__ = ["S_TO_NS", "ClockType", "Duration", "Infinite", "Time"]

S_TO_NS = 1_000_000_000
_LIMIT = 2**63  # ROS 2 keeps nanoseconds in a signed 64-bit integer
_LONGEST_IN_MESSAGE = 2**31 * S_TO_NS - 1  # builtin_interfaces keeps seconds in an int32


class ClockType(Enum):
    """Type of a clock. Only times of the same clock type can be compared."""

    UNINITIALIZED = 0
    ROS_TIME = 1  #: the node's time: system time, or simulated time from `/clock`
    SYSTEM_TIME = 2  #: time since the Unix epoch. It jumps when the system's clock is set.
    STEADY_TIME = 3  #: time since an unspecified moment before the program's start. It never jumps.


class Duration:
    """A span of time, which can be negative."""

    def __init__(self, *, seconds: float = 0, nanoseconds: float = 0) -> None:
        """Add seconds and nanoseconds. Fractions of a nanosecond are cut off.

        Raises:
            ArgumentTypeError: An argument is not a number.
            TimeOverflowError: The sum does not fit in 64 bits (292 years), or is not finite.
        """
        self._nanoseconds = _total("duration", seconds, nanoseconds)

    @classmethod
    def from_msg(cls, msg: Any) -> Duration:
        """Return the value of a `builtin_interfaces/msg/Duration`.

        Raises:
            ArgumentTypeError: The message has no `sec` and `nanosec`.
        """
        total = _from_message("builtin_interfaces/msg/Duration", msg)
        return cls(nanoseconds=_LIMIT - 1 if total == _LONGEST_IN_MESSAGE else total)

    def to_msg(self) -> Any:
        """Return a `builtin_interfaces/msg/Duration`, whose range is about -68 to 68 years.

        `Infinite` becomes the message's largest value. `from_msg` converts it to `Infinite` again.
        """
        infinite = self._nanoseconds == _LIMIT - 1
        return _to_message("Duration", _LONGEST_IN_MESSAGE if infinite else self._nanoseconds)

    @property
    def nanoseconds(self) -> int:
        """The duration in nanoseconds."""
        return self._nanoseconds

    def __repr__(self) -> str:
        return f"Duration(nanoseconds={self._nanoseconds})"

    def __str__(self) -> str:
        return "Infinite" if self == Infinite else f"{self._nanoseconds} nanoseconds"

    def __hash__(self) -> int:
        return hash((Duration, self._nanoseconds))

    def __add__(self, other: Duration) -> Duration:
        if isinstance(other, Duration):
            return Duration(nanoseconds=self._nanoseconds + other._nanoseconds)
        return NotImplemented

    def __sub__(self, other: Duration) -> Duration:
        if isinstance(other, Duration):
            return Duration(nanoseconds=self._nanoseconds - other._nanoseconds)
        return NotImplemented

    def __mul__(self, factor: float) -> Duration:
        if factor == float("inf"):
            return Infinite
        if isinstance(factor, (int, float)):
            return Duration(nanoseconds=self._nanoseconds * factor)
        return NotImplemented

    __rmul__ = __mul__

    def __eq__(self, other: object) -> bool:
        if isinstance(other, Duration):
            return self._nanoseconds == other._nanoseconds
        return NotImplemented

    def __lt__(self, other: Duration) -> bool:
        if isinstance(other, Duration):
            return self._nanoseconds < other._nanoseconds
        return NotImplemented

    def __le__(self, other: Duration) -> bool:
        if isinstance(other, Duration):
            return self._nanoseconds <= other._nanoseconds
        return NotImplemented

    def __gt__(self, other: Duration) -> bool:
        if isinstance(other, Duration):
            return self._nanoseconds > other._nanoseconds
        return NotImplemented

    def __ge__(self, other: Duration) -> bool:
        if isinstance(other, Duration):
            return self._nanoseconds >= other._nanoseconds
        return NotImplemented


class Time:
    """A point in time of one clock type. It is not before the clock's zero."""

    def __init__(
        self,
        *,
        seconds: float = 0,
        nanoseconds: float = 0,
        clock_type: ClockType = ClockType.SYSTEM_TIME,
    ) -> None:
        """Add seconds and nanoseconds. Fractions of a nanosecond are cut off.

        Raises:
            ArgumentTypeError: An argument is not a number, or `clock_type` is not a `ClockType`.
            WrongValueError: An argument is below zero.
            TimeOverflowError: The sum does not fit in 64 bits (292 years), or is not finite.
        """
        if not isinstance(clock_type, ClockType):
            raise ArgumentTypeError("clock_type", "a ClockType", clock_type)
        self._nanoseconds = _total("time", seconds, nanoseconds)
        if seconds < 0 or nanoseconds < 0:
            raise negative_time_error(seconds if seconds < 0 else nanoseconds)
        self._clock_type = clock_type

    @classmethod
    def from_msg(cls, msg: Any, clock_type: ClockType = ClockType.ROS_TIME) -> Time:
        """Return the value of a `builtin_interfaces/msg/Time`. The message has no clock type.

        Raises:
            ArgumentTypeError: The message has no `sec` and `nanosec`.
            WrongValueError: The message's time is before the clock's zero.
        """
        nanoseconds = _from_message("builtin_interfaces/msg/Time", msg)
        return cls(nanoseconds=nanoseconds, clock_type=clock_type)

    def to_msg(self) -> Any:
        """Return a `builtin_interfaces/msg/Time`. The range of this message ends in 2038."""
        return _to_message("Time", self._nanoseconds)

    @property
    def nanoseconds(self) -> int:
        """Nanoseconds since the clock's zero."""
        return self._nanoseconds

    @property
    def clock_type(self) -> ClockType:
        """The type of the clock that gave the time."""
        return self._clock_type

    def seconds_nanoseconds(self) -> tuple[int, int]:
        """Return the whole seconds and the remaining nanoseconds."""
        return divmod(self._nanoseconds, S_TO_NS)

    def __repr__(self) -> str:
        return f"Time(nanoseconds={self._nanoseconds}, clock_type={self._clock_type.name})"

    def __hash__(self) -> int:
        return hash((self._clock_type, self._nanoseconds))

    def __add__(self, other: Duration) -> Time:
        if isinstance(other, Duration):
            return self._moved(other.nanoseconds)
        return NotImplemented

    __radd__ = __add__

    @overload
    def __sub__(self, other: Time) -> Duration: ...
    @overload
    def __sub__(self, other: Duration) -> Time: ...
    def __sub__(self, other: Time | Duration) -> Time | Duration:
        if isinstance(other, Time):
            return Duration(nanoseconds=self._nanoseconds - self._same_clock(other))
        if isinstance(other, Duration):
            return self._moved(-other.nanoseconds)
        return NotImplemented

    def __eq__(self, other: object) -> bool:
        if isinstance(other, Time):
            return self._nanoseconds == self._same_clock(other)
        return NotImplemented

    def __lt__(self, other: Time) -> bool:
        if isinstance(other, Time):
            return self._nanoseconds < self._same_clock(other)
        return NotImplemented

    def __le__(self, other: Time) -> bool:
        if isinstance(other, Time):
            return self._nanoseconds <= self._same_clock(other)
        return NotImplemented

    def __gt__(self, other: Time) -> bool:
        if isinstance(other, Time):
            return self._nanoseconds > self._same_clock(other)
        return NotImplemented

    def __ge__(self, other: Time) -> bool:
        if isinstance(other, Time):
            return self._nanoseconds >= self._same_clock(other)
        return NotImplemented

    def _moved(self, nanoseconds: int) -> Time:
        return Time(nanoseconds=self._nanoseconds + nanoseconds, clock_type=self._clock_type)

    def _same_clock(self, other: Time) -> int:
        if self._clock_type is not other._clock_type:
            raise WrongTypeError(
                "cannot compare or subtract times of different clock types "
                f"({self._clock_type.name} and {other._clock_type.name}): "
                "take both from the same clock"
            )
        return other._nanoseconds


def _total(what: str, seconds: float, nanoseconds: float) -> int:
    try:
        total = int(_number("seconds", seconds) * S_TO_NS) + int(
            _number("nanoseconds", nanoseconds)
        )
    except (ValueError, OverflowError):  # NaN or infinity
        raise TimeOverflowError(what, seconds, nanoseconds) from None
    if not -_LIMIT <= total < _LIMIT:
        raise TimeOverflowError(what, seconds, nanoseconds)
    return total


def _number(argument: str, value: float) -> float:
    """Return the value as a Python number, because a numpy int32 can overflow in a product."""
    if isinstance(value, (int, float)):
        return value
    if isinstance(value, numbers.Integral):
        return int(value)
    if isinstance(value, numbers.Real):
        return float(value)
    raise ArgumentTypeError(argument, "a number", value)


def _from_message(type_name: str, msg: Any) -> int:
    try:
        seconds, nanoseconds = msg.sec, msg.nanosec
    except AttributeError:
        raise ArgumentTypeError("msg", f"a {type_name}", msg) from None
    return int(seconds) * S_TO_NS + int(nanoseconds)


def _to_message(name: str, nanoseconds: int) -> Any:
    # Imported here, because the message classes belong to a layer above this module.
    message = getattr(importlib.import_module("builtin_interfaces.msg"), name)
    seconds, rest = divmod(nanoseconds, S_TO_NS)
    return message(sec=seconds, nanosec=rest)


#: The longest duration. A deadline or lifespan of this length never expires.
Infinite = Duration(nanoseconds=_LIMIT - 1)


def as_seconds(argument: str, timeout: float | Duration | None) -> float | None:
    """Return a timeout in seconds. `None` stays `None`.

    Args:
        argument: The argument's name, for the error.
        timeout: A number of seconds, or a `Duration`.

    Raises:
        ArgumentTypeError: The timeout has another type.
    """
    if isinstance(timeout, Duration):
        return timeout.nanoseconds / S_TO_NS
    if timeout is None or isinstance(timeout, numbers.Real):
        return timeout
    raise ArgumentTypeError(argument, "a number of seconds", timeout)


def timeout_sec_to_nsec(timeout_sec: float | None) -> int:
    """Return a timeout in nanoseconds. Return -1 (no timeout) for `None` and negative values."""
    return -1 if timeout_sec is None or timeout_sec < 0 else int(timeout_sec * S_TO_NS)


class TimeoutObject:
    """A timeout that can be changed between two waits.

    Args:
        timeout: The timeout in seconds.
    """

    timeout: float

    def __init__(self, timeout: float) -> None:
        self.timeout = timeout
