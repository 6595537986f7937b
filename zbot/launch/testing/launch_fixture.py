"""Fixture of pytest that runs a launch while tests use it, like `fixture` of launch_pytest."""

from __future__ import annotations

import inspect
from typing import TYPE_CHECKING, Any

import pytest

from zbot.launch.description import LaunchDescription
from zbot.launch.testing.error import LaunchTestError
from zbot.launch.testing.running_launch import RunningLaunch, ready_actions
from zbot.package.absent import absent_packages_reported

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

#: The object, name and scope of each fixture. The keys are the ids of the objects.
_names: dict[int, tuple[Any, str, str]] = {}
#: The running launches. The keys are the names of their fixtures. The newest launch is the last.
running: dict[str, RunningLaunch] = {}


def fixture(
    decorated: Callable[..., Any] | None = None, *, auto_shutdown: bool = True, **options: Any
) -> Any:
    """Turn a function that returns a launch description into a fixture.

    Args:
        decorated: The function. It returns or yields the description, or a tuple that begins with
            the description.
        auto_shutdown: Whether the launch ends when all its processes have ended.
        options: The options of `pytest.fixture`.
    """

    def decorate(function: Callable[..., Any]) -> Any:
        name = options.get("name") or function.__name__

        def launched(**given: Any) -> Iterator[Any]:
            with absent_packages_reported():  # the launch says what it leaves out
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
                running.pop(name, None)
                launch.stop()
            next(rest, None)  # runs the code after the function's own yield

        # functools.wraps is not used, because pytest would unwrap `launched` and use `function`.
        launched.__signature__ = inspect.signature(function)  # type: ignore[attr-defined]
        launched.__name__, launched.__doc__ = function.__name__, function.__doc__
        launched.__module__ = function.__module__
        made = pytest.fixture(**options)(launched)
        _names[id(made)] = (made, name, options.get("scope", "function"))
        return made

    return decorate if decorated is None else decorate(decorated)


def _description(name: str, value: Any) -> LaunchDescription:
    """Return the launch description that a fixture's function returned or yielded."""
    first = value[0] if isinstance(value, (tuple, list)) and value else value
    if not isinstance(first, LaunchDescription):
        what = "must be either a launch description or a sequence that begins with one"
        raise LaunchTestError(f"the value of the fixture {name} {what}, not {value!r}")
    if sum(1 for _ in ready_actions(first.entities)) > 1:
        raise LaunchTestError(f"the launch of {name} must have only one ReadyToTest action")
    return first


def name_and_scope(made: Any) -> tuple[str, str]:
    """Return name and scope of a fixture that the decorator `fixture` created.

    Raises:
        LaunchTestError: The object is not such a fixture.
    """
    if id(made) not in _names:
        raise LaunchTestError("mark.launch needs fixture=..., made by @launch_pytest.fixture")
    return _names[id(made)][1:]
