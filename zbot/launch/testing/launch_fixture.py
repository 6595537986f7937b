"""launch_pytest's `fixture`: a launch that runs as long as tests of pytest use it."""

from __future__ import annotations

import inspect
from typing import TYPE_CHECKING, Any

import pytest

from zbot.launch.description import LaunchDescription
from zbot.launch.testing.error import LaunchTestError
from zbot.launch.testing.running_launch import RunningLaunch, ready_actions

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

#: The names and scopes of fixtures that `fixture` made, by ids; pytest's own objects hide them.
_names: dict[int, tuple[Any, str, str]] = {}
#: The launches that run, the newest last, by the names of their fixtures.
running: dict[str, RunningLaunch] = {}


def fixture(
    decorated: Callable[..., Any] | None = None, *, auto_shutdown: bool = True, **options: Any
) -> Any:
    """Make a fixture of a function that returns a launch description.

    Args:
        decorated: The function; it may return, or yield, a tuple with more than the description.
        auto_shutdown: Whether the launch ends when all of its processes have.
        options: As for `pytest.fixture`.
    """

    def decorate(function: Callable[..., Any]) -> Any:
        name = options.get("name") or function.__name__

        def launched(**given: Any) -> Iterator[Any]:
            made = function(**given)
            rest = made if inspect.isgenerator(made) else iter((made,))
            value = next(rest)
            description = _description(name, value)
            launch = RunningLaunch(description, keep_alive=not auto_shutdown, must_get_ready=False)
            running[name] = launch
            try:
                launch.wait_until_ready()
                yield value
            finally:
                launch.stop()
                running.pop(name, None)
            next(rest, None)  # what stands behind the function's own yield

        # Not functools.wraps: pytest would look through it, and take the function for the fixture.
        launched.__signature__ = inspect.signature(function)  # type: ignore[attr-defined]
        launched.__name__, launched.__doc__ = function.__name__, function.__doc__
        launched.__module__ = function.__module__
        made = pytest.fixture(**options)(launched)
        _names[id(made)] = (made, name, options.get("scope", "function"))
        return made

    return decorate if decorated is None else decorate(decorated)


def _description(name: str, value: Any) -> LaunchDescription:
    """Return the description in what a fixture's function gave."""
    first = value[0] if isinstance(value, (tuple, list)) and value else value
    if not isinstance(first, LaunchDescription):
        what = "must be either a launch description or a sequence that begins with one"
        raise LaunchTestError(f"what the fixture {name} returns {what}, not {value!r}")
    if sum(1 for _ in ready_actions(first.entities)) > 1:
        raise LaunchTestError(f"the launch of {name} must have only one ReadyToTest action")
    return first


def name_and_scope(made: Any) -> tuple[str, str]:
    """Return the name of a fixture that `fixture` made, and its scope.

    Raises:
        LaunchTestError: It made no such.
    """
    if id(made) not in _names:
        raise LaunchTestError("mark.launch needs fixture=..., made by @launch_pytest.fixture")
    return _names[id(made)][1:]
