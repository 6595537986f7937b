"""Arguments of the methods that spin: a timeout in seconds, and a future."""

from __future__ import annotations

import time

from zbot.errors import ArgumentTypeError


def deadline_ns_of(timeout_sec: float | None) -> int | None:
    """Return when a timeout ends, in nanoseconds of the monotonic clock, or None without a limit.

    Args:
        timeout_sec: Seconds. None or a number below 0 means no limit.

    Raises:
        ArgumentTypeError: The timeout is not a number.
    """
    if timeout_sec is None:
        return None
    try:
        return None if timeout_sec < 0 else time.monotonic_ns() + int(timeout_sec * 1e9)
    except TypeError:
        raise ArgumentTypeError("timeout_sec", "a number of seconds", timeout_sec) from None


def left_s(deadline_ns: int | None) -> float | None:
    """Return the seconds until a deadline, at least 0, or None without a limit."""
    return None if deadline_ns is None else max(0, deadline_ns - time.monotonic_ns()) / 1e9


def is_future(value: object) -> bool:
    """Return whether a value is a future, and not the class."""
    return hasattr(value, "add_waker") and not isinstance(value, type)


def check_future(future: object) -> None:
    """Raise `ArgumentTypeError` if the argument is not a future."""
    if not is_future(future):
        raise ArgumentTypeError("future", "a future, e.g. the result of call_async()", future)
