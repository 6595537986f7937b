"""Adapter that turns tests of launch_pytest, e.g. generators and coroutines, into functions."""

from __future__ import annotations

import asyncio
import inspect
from collections import defaultdict, deque
from typing import TYPE_CHECKING, Any

import pytest

from zbot.launch.testing.launch_fixture import running

if TYPE_CHECKING:
    from collections.abc import AsyncGenerator, Callable

_YIELDED_TWICE = "must stop iteration after yielding once"


class StagedTest:
    """A test of a launch. The code after its `yield` runs after the launch has ended.

    Args:
        function: The test.
        fixture_name: The name of the fixture with the launch.
    """

    def __init__(self, function: Callable[..., Any], fixture_name: str) -> None:
        self._function, self._fixture_name = function, fixture_name
        self.has_two_stages = inspect.isgeneratorfunction(function) or inspect.isasyncgenfunction(
            function
        )
        #: Tests that wait at their `yield`. The key is the id of the launch. None is a failed test.
        self._waiting: defaultdict[int, deque[Any]] = defaultdict(deque)

    def as_one_function(self, *, shutdown: bool) -> Any:
        """Return the test as one function.

        Args:
            shutdown: Whether the whole test runs after the end of the launch.
        """

        def plain(*args: Any, **given: Any) -> None:
            if shutdown and self.has_two_stages:
                kind = "a generator or async generator"
                reason = "its yield marks the shutdown already"
                pytest.fail(f"{kind} cannot be marked with shutdown=True: {reason}")
            if shutdown:
                self._launch.stop()
            steps = self._begin(args, given)
            if steps is not None:
                self._end(steps)

        return self._with_metadata(plain)

    def as_two_functions(self) -> tuple[Any, Any]:
        """Return the test as two functions. Other tests of the launch run between the two calls."""

        def first(*args: Any, **given: Any) -> None:
            waiting = self._waiting[id(self._launch)]
            waiting.append(None)
            waiting[-1] = self._begin(args, given)

        def second(**_: Any) -> None:
            waiting = self._waiting[id(self._launch)]
            steps = waiting.popleft() if waiting else None
            if steps is None:
                pytest.skip("the test failed before its yield")
            self._end(steps)

        return self._with_metadata(first), self._with_metadata(second)

    @property
    def _launch(self) -> Any:
        return running[self._fixture_name]

    def _begin(self, args: Any, given: Any) -> Any:
        """Run the test until its `yield`. Return the generator, or None if there is no `yield`."""
        made = self._function(*args, **given)
        if inspect.iscoroutine(made):
            asyncio.run(made)
            return None
        if inspect.isgenerator(made):
            return made if next(made, made) is not made else None
        if inspect.isasyncgen(made):
            return _AsyncGeneratorRunner(made).begun()
        return None

    def _end(self, steps: Any) -> None:
        """End the launch and run the part after the `yield`."""
        self._launch.stop()
        nothing = object()
        last = (
            steps.end(nothing) if isinstance(steps, _AsyncGeneratorRunner) else next(steps, nothing)
        )
        if last is not nothing:
            pytest.fail(f"{self._function.__name__} {_YIELDED_TWICE}")

    def _with_metadata(self, plain: Any) -> Any:
        # functools.wraps is not used, because pytest would unwrap `plain` and use `function`.
        function: Any = self._function
        plain.__signature__ = inspect.signature(function)
        plain.__name__, plain.__doc__ = function.__name__, function.__doc__
        plain.__module__, plain.__qualname__ = function.__module__, function.__qualname__
        plain.pytestmark = list(getattr(function, "pytestmark", []))
        return plain


class _AsyncGeneratorRunner:
    """An asynchronous generator, with the event loop that runs it before and after the `yield`."""

    def __init__(self, made: AsyncGenerator[Any, Any]) -> None:
        self._made, self._loop = made, asyncio.new_event_loop()

    def begun(self) -> _AsyncGeneratorRunner | None:
        """Run the generator until its `yield`. Return None if there is no `yield`."""
        nothing = object()
        is_open = False
        try:
            is_open = self._next(nothing) is not nothing
        finally:
            if not is_open:
                self._close()
        return self if is_open else None

    def end(self, nothing: object) -> object:
        """Run the rest of the generator. Return `nothing` if there is no second `yield`."""
        try:
            return self._next(nothing)
        finally:
            self._close()

    def _next(self, nothing: object) -> object:
        async def one_step() -> object:
            return await anext(self._made, nothing)

        return self._loop.run_until_complete(one_step())

    def _close(self) -> None:
        self._loop.run_until_complete(self._loop.shutdown_asyncgens())
        self._loop.run_until_complete(self._loop.shutdown_default_executor())
        self._loop.close()
