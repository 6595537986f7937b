"""Decorators for the functions and test cases of launch tests."""

from __future__ import annotations

import functools
import time
from typing import TYPE_CHECKING, Any, TypeVar

from zbot.launch.testing.error import LaunchTestError

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Sequence

T = TypeVar("T")


def keep_alive(test_description: T) -> T:
    """Keep a launch running until its tests have ended, even without running processes."""
    _markers(test_description)["keep_alive"] = True
    return test_description


def ready_to_test_action_timeout(timeout: float) -> Callable[[T], T]:
    """Set the maximum number of seconds to wait for the launch's `ReadyToTest`. Default: 15."""

    def decorate(test_description: T) -> T:
        _markers(test_description)["ready_timeout"] = timeout
        return test_description

    return decorate


def parametrize(argnames: str | Sequence[str], argvalues: Iterable[Any]) -> Callable[[T], T]:
    """Run the launch and its tests once for each set of argument values."""
    names = (
        [name.strip() for name in argnames.split(",")]
        if isinstance(argnames, str)
        else list(argnames)
    )
    rows = [value if len(names) > 1 else (value,) for value in argvalues]

    def decorate(test_description: T) -> T:
        _markers(test_description)["rows"] = [dict(zip(names, row, strict=True)) for row in rows]
        return test_description

    return decorate


def markers_of(test_description: Any) -> dict[str, Any]:
    """Return the markers that the decorators of this module set on a function."""
    return getattr(test_description, "__markers__", {})


def _markers(test_description: Any) -> dict[str, Any]:
    if not hasattr(test_description, "__markers__"):
        test_description.__markers__ = {}
    markers: dict[str, Any] = test_description.__markers__
    return markers


def post_shutdown_test() -> Callable[[T], T]:
    """Run a test case after the launch has ended."""

    def decorate(case: T) -> T:
        case.__post_shutdown_test__ = True  # type: ignore[attr-defined]
        return case

    return decorate


def retry_on_failure(
    *, times: int, delay: float | None = None
) -> Callable[[Callable[..., T]], Callable[..., T]]:
    """Repeat a test until no assertion fails. The test runs at most `times` times.

    Between two runs is a pause of `delay` seconds.

    Raises:
        LaunchTestError: `times` is below 1.
    """
    if times < 1:
        raise LaunchTestError(f"retry_on_failure needs times=1 or more, not {times}")

    def decorate(test: Callable[..., T]) -> Callable[..., T]:
        @functools.wraps(test)
        def retried(*args: Any, **kwargs: Any) -> T:
            for _ in range(times - 1):
                try:
                    return test(*args, **kwargs)
                except AssertionError:
                    time.sleep(delay or 0)
            return test(*args, **kwargs)

        return retried

    return decorate
