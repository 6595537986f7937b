"""Queue of an action's functions, which the node's executor calls."""

from __future__ import annotations

from collections import deque
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.executor.callback_group import CallbackGroup
    from zbot.executor.ready_queue import ReadyQueue


class WorkQueue:
    """Functions that wait for the executor. They may be added before the node has an executor.

    Args:
        ready_queue: The node's ready queue.
        callback_group: Decides which callbacks may run at the same time as a function.
    """

    due_ns: int | None = None

    def __init__(self, ready_queue: ReadyQueue, callback_group: CallbackGroup) -> None:
        self.ready_queue = ready_queue
        self.callback_group = callback_group
        self._functions: deque[Callable[[], Any]] = deque()
        ready_queue.add(self)

    def add(self, function: Callable[[], Any]) -> None:
        """Let the executor call a function or coroutine function. Any thread may call this."""
        self._functions.append(function)
        self.ready_queue.post(self)

    def take(self) -> Callable[[], Any] | None:
        """Return the oldest function, or `None` if no function waits."""
        try:
            return self._functions.popleft()
        except IndexError:
            return None

    def execute(self, function: Callable[[], Any]) -> Any:
        """Call the function and return its result. If this is a coroutine, the executor runs it."""
        return function()

    def destroy(self) -> None:
        """Remove this queue from the ready queue, and drop the functions that wait."""
        self.ready_queue.remove(self)
        self._functions.clear()
