"""Log calls in the source of a program, and their filters `once`, `skip_first` and throttling."""

from __future__ import annotations

import threading
import time
from typing import TYPE_CHECKING, NamedTuple, Protocol, TypedDict

from zbot.errors import ArgumentTypeError, WrongTypeError
from zbot.log.errors import log_call_changed_error, log_option_error, not_a_clock_error

if TYPE_CHECKING:
    from types import FrameType

    from zbot.log.record import LoggingSeverity
    from zbot.time import Time

# Re-entrant, because a signal handler may log too.
_lock = threading.RLock()


def renew_lock() -> None:
    """In a forked child, replace the lock, which a thread of the parent may hold."""
    global _lock  # noqa: PLW0603 - there is one per process
    _lock = threading.RLock()


class TimeProvider(Protocol):
    """Any object with a clock's `now()`."""

    def now(self) -> Time:
        """Return the current time."""
        ...


class FilterOptions(TypedDict, total=False):
    """Options that limit how often a call writes its line."""

    once: bool  #: only the first call writes
    skip_first: bool  #: every call except the first call writes
    throttle_duration_sec: float  #: at most one line in this time, in seconds
    throttle_time_source_type: TimeProvider  #: clock of the throttle; the default is monotonic


class LogOptions(FilterOptions, total=False):
    """Keyword arguments of `info()` and the other log methods."""

    name: str  #: name of another logger, which then writes the line


class Filters(NamedTuple):
    """Filters of a log call. A false value switches a filter off."""

    once: bool = False
    skip_first: bool = False
    throttle_sec: float = 0
    clock: TimeProvider | None = None


_NO_FILTERS = Filters()


class CallSite:
    """One log call in the source, with the state of its filters.

    Args:
        severity: The call's severity.
        name: The logger's name in the call.
        options: The call's filters.

    Raises:
        WrongTypeError: An option is unknown, or a throttle's duration is missing.
        WrongValueError: The throttle's time source is not a clock.
        ArgumentTypeError: The throttle's duration is not a number.
    """

    __slots__ = ("_filters", "_last_ns", "_name", "_passed", "_severity")

    def __init__(self, severity: LoggingSeverity, name: str, options: FilterOptions) -> None:
        self._severity, self._name = severity, name
        self._filters = _filters(options) if options else _NO_FILTERS
        self._passed = 0
        # As in rclpy: if the program gives a clock, the throttle begins as if a line was written at
        # time 0. So with simulated time, the first line is written only when the clock reaches the
        # throttle's duration.
        self._last_ns: int | None = None if self._filters.clock is None else 0

    def check(
        self, severity: LoggingSeverity, name: str, options: FilterOptions, frame: FrameType
    ) -> None:
        """Check that a call has the same options as the first call at this place.

        Raises:
            WrongValueError: The call has another severity, name or filter.
        """
        if severity is not self._severity:
            raise log_call_changed_error("severity", _place(frame))
        if name != self._name:
            raise log_call_changed_error("logger name", _place(frame))
        if (_filters(options) if options else _NO_FILTERS) != self._filters:
            raise log_call_changed_error("filter parameters", _place(frame))

    def passes_filters(self) -> bool:
        """Return whether the current call may write its line."""
        filters = self._filters
        if filters is _NO_FILTERS:
            return True
        now_ns = _now_ns(filters.clock) if filters.throttle_sec else 0
        with _lock:
            if filters.throttle_sec and not self._throttle_has_elapsed(now_ns):
                return False
            number, self._passed = self._passed, self._passed + 1
        first = 1 if filters.skip_first else 0
        return number == first if filters.once else number >= first

    def _throttle_has_elapsed(self, now_ns: int) -> bool:
        # If the time goes backwards, a simulation was restarted. Then the line is written.
        if self._last_ns is not None:
            passed_sec = (now_ns - self._last_ns) / 1e9
            if 0 <= passed_sec < self._filters.throttle_sec:
                return False
        self._last_ns = now_ns
        return True


def _filters(options: FilterOptions) -> Filters:
    unknown = options.keys() - FilterOptions.__annotations__.keys()
    if unknown:
        raise _unknown(min(unknown))
    clock, throttle_sec = options.get("throttle_time_source_type"), 0.0
    if "throttle_duration_sec" in options:
        throttle_sec = options["throttle_duration_sec"] or 0
    elif clock is not None:
        lack = "has a required parameter throttle_duration_sec that was not specified"
        raise log_option_error("throttle_time_source_type", lack)
    if not isinstance(throttle_sec, (int, float)):
        raise ArgumentTypeError("throttle_duration_sec", "a number of seconds", throttle_sec)
    if clock is not None and not callable(getattr(clock, "now", None)):
        raise not_a_clock_error("throttle_time_source_type", clock)
    once, skip_first = bool(options.get("once")), bool(options.get("skip_first"))
    return Filters(once, skip_first, throttle_sec, clock)


def _unknown(option: str) -> WrongTypeError:
    if option == "severity":  # the reason quotes Python's error for an argument given twice
        reason = "is set by the method: got multiple values for argument 'severity'; use log()"
        return log_option_error(option, reason)
    known = ", ".join(FilterOptions.__annotations__)
    return log_option_error(option, f"is not one of the recognized ones: use {known} or name")


def _now_ns(clock: TimeProvider | None) -> int:
    return time.monotonic_ns() if clock is None else clock.now().nanoseconds


def _place(frame: FrameType) -> str:
    return f"{frame.f_code.co_filename}:{frame.f_lineno}"
