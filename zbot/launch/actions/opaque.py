"""Actions that call a Python function or run a coroutine."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from zbot.launch.action import Action
from zbot.launch.entity import LaunchDescriptionEntity
from zbot.launch.event_handler import OnShutdown

if TYPE_CHECKING:
    import asyncio
    from collections.abc import Callable, Coroutine, Iterable, Mapping, Sequence

    from zbot.launch.context import LaunchContext


class OpaqueFunction(Action):
    """Call a function with the context and visit the entities that it returns.

    Args:
        function: Called as `function(context, *args, **kwargs)`.
        args: More arguments.
        kwargs: More arguments by name.
    """

    def __init__(
        self,
        *,
        function: Callable[..., Sequence[LaunchDescriptionEntity] | None],
        args: Iterable[Any] | None = None,
        kwargs: Mapping[str, Any] | None = None,
        **options: Any,
    ) -> None:
        super().__init__(**options)
        self.function = function
        self.args, self.kwargs = tuple(args or ()), dict(kwargs or {})

    def execute(self, context: LaunchContext) -> Sequence[LaunchDescriptionEntity] | None:
        """Call the function and return its entities."""
        returned = self.function(context, *self.args, **self.kwargs)
        return [returned] if isinstance(returned, LaunchDescriptionEntity) else returned

    def describe(self) -> str:
        """Return the names of the class and the function."""
        return f"OpaqueFunction('{getattr(self.function, '__name__', self.function)}')"


class OpaqueCoroutine(Action):
    """Run a coroutine in the launch's event loop. The launch's shutdown cancels the coroutine.

    Args:
        coroutine: Called as `coroutine(context, *args, **kwargs)`.
        args: More arguments.
        kwargs: More arguments by name.
        ignore_context: Whether to call `coroutine` without the context.
    """

    def __init__(
        self,
        *,
        coroutine: Callable[..., Coroutine[Any, Any, None]],
        args: Iterable[Any] | None = None,
        kwargs: Mapping[str, Any] | None = None,
        ignore_context: bool = False,
        **options: Any,
    ) -> None:
        super().__init__(**options)
        self._coroutine = coroutine
        self._args, self._kwargs = tuple(args or ()), dict(kwargs or {})
        self._ignores_context = ignore_context
        self._task: asyncio.Task[Any] | None = None

    def execute(self, context: LaunchContext) -> None:
        """Start the coroutine."""
        first = () if self._ignores_context else (context,)
        task = context.create_task(self._coroutine(*first, *self._args, **self._kwargs))
        self._task = task

        def cancel(*_: object) -> None:
            task.cancel()

        context.register_event_handler(OnShutdown(on_shutdown=cancel))

    def get_asyncio_future(self) -> asyncio.Future[Any] | None:
        """Return the task of the coroutine."""
        return self._task
