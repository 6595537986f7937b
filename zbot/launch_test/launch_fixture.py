"""launch_pytest's `fixture`: a launch that runs as long as tests of pytest use it."""

from __future__ import annotations

import asyncio
import inspect
from typing import TYPE_CHECKING, Any

import pytest

from zbot.launch.description import LaunchDescription
from zbot.launch_test.error import LaunchTestError
from zbot.launch_test.running_launch import RunningLaunch

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

#: The names of fixtures that `fixture` made, by their ids; pytest's own objects hide the names.
_names: dict[int, tuple[Any, str]] = {}
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
            description = value[0] if isinstance(value, tuple) else value
            if not isinstance(description, LaunchDescription):
                raise LaunchTestError(f"{name} must return a LaunchDescription, not {value!r}")
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
        _names[id(made)] = (made, name)
        return made

    return decorate if decorated is None else decorate(decorated)


def name_of(made: Any) -> str:
    """Return the name of a fixture that `fixture` made.

    Raises:
        LaunchTestError: It made no such.
    """
    if id(made) not in _names:
        raise LaunchTestError("mark.launch needs fixture=..., made by @launch_pytest.fixture")
    return _names[id(made)][1]


def as_plain_test(function: Callable[..., Any], fixture_name: str, *, shutdown: bool) -> Any:
    """Return a test that pytest can call, for one that may be a generator or a coroutine.

    Args:
        function: The test; what stands behind a generator's `yield` runs after the launch.
        fixture_name: Of the launch that it belongs to.
        shutdown: Whether all of it runs after the launch.
    """

    def plain(*args: Any, **given: Any) -> None:
        launch = running[fixture_name]
        if shutdown:
            launch.stop()
        steps = function(*args, **given)
        if inspect.iscoroutine(steps):
            asyncio.run(steps)
        elif inspect.isgenerator(steps):
            next(steps)
            launch.stop()
            next(steps, None)
        elif inspect.isasyncgen(steps):
            asyncio.run(_both_halves(steps, launch))

    plain.__signature__ = inspect.signature(function)  # type: ignore[attr-defined]
    plain.__name__, plain.__doc__ = function.__name__, function.__doc__
    plain.__module__, plain.__qualname__ = function.__module__, function.__qualname__
    plain.pytestmark = list(getattr(function, "pytestmark", []))  # type: ignore[attr-defined]
    return plain


async def _both_halves(steps: Any, launch: RunningLaunch) -> None:
    await anext(steps)
    await asyncio.to_thread(launch.stop)
    await anext(steps, None)
