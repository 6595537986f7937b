"""Tests of launch_pytest as functions that pytest can call: generators, coroutines, both."""

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
    """A test of a launch; what stands behind its `yield` comes after the launch has ended.

    Args:
        function: The test.
        fixture_name: Of the launch that it belongs to.
    """

    def __init__(self, function: Callable[..., Any], fixture_name: str) -> None:
        self._function, self._fixture_name = function, fixture_name
        self.has_two_stages = inspect.isgeneratorfunction(function) or inspect.isasyncgenfunction(
            function
        )
        #: By the launch: where the tests stand, None for those that failed; in pytest's order.
        self._waiting: defaultdict[int, deque[Any]] = defaultdict(deque)

    def whole(self, *, shutdown: bool) -> Any:
        """Return the test as one function.

        Args:
            shutdown: Whether all of it runs after the launch.
        """

        def plain(*args: Any, **given: Any) -> None:
            if shutdown and self.has_two_stages:
                kind = "a generator or async generator"
                pytest.fail(f"{kind} cannot be marked with shutdown=True: its yield says when")
            if shutdown:
                self._launch.stop()
            steps = self._begin(args, given)
            if steps is not None:
                self._end(steps)

        return self._dressed(plain)

    def halves(self) -> tuple[Any, Any]:
        """Return the test as two functions, for a launch that other tests need in between."""

        def first(*args: Any, **given: Any) -> None:
            waiting = self._waiting[id(self._launch)]
            waiting.append(None)
            waiting[-1] = self._begin(args, given)

        def second(**_: Any) -> None:
            waiting = self._waiting[id(self._launch)]
            steps = waiting.popleft() if waiting else None
            if steps is None:
                pytest.skip("what stands before its yield failed")
            self._end(steps)

        return self._dressed(first), self._dressed(second)

    @property
    def _launch(self) -> Any:
        return running[self._fixture_name]

    def _begin(self, args: Any, given: Any) -> Any:
        """Run the test up to its `yield`; return what is left."""
        made = self._function(*args, **given)
        if inspect.iscoroutine(made):
            asyncio.run(made)
            return None
        if inspect.isgenerator(made):
            return made if next(made, made) is not made else None
        if inspect.isasyncgen(made):
            return _Loop(made).begun()
        return None

    def _end(self, steps: Any) -> None:
        """Run what stands behind the `yield`, after the launch."""
        self._launch.stop()
        nothing = object()
        last = steps.end(nothing) if isinstance(steps, _Loop) else next(steps, nothing)
        if last is not nothing:
            pytest.fail(f"{self._function.__name__} {_YIELDED_TWICE}")

    def _dressed(self, plain: Any) -> Any:
        # Not functools.wraps: pytest would look through it, and take the function for the test.
        function: Any = self._function
        plain.__signature__ = inspect.signature(function)
        plain.__name__, plain.__doc__ = function.__name__, function.__doc__
        plain.__module__, plain.__qualname__ = function.__module__, function.__qualname__
        plain.pytestmark = list(getattr(function, "pytestmark", []))
        return plain


class _Loop:
    """An asynchronous generator with the event loop that both of its halves run in."""

    def __init__(self, made: AsyncGenerator[Any, Any]) -> None:
        self._made, self._loop = made, asyncio.new_event_loop()

    def begun(self) -> _Loop | None:
        """Run it up to its `yield`; return None if there is none."""
        nothing = object()
        is_open = False
        try:
            is_open = self._next(nothing) is not nothing
        finally:
            if not is_open:
                self._close()
        return self if is_open else None

    def end(self, nothing: object) -> object:
        """Run the rest; return `nothing` if it ends there."""
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
