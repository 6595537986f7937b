"""Work of an action that the node's executor does: calling the user, one piece after the other."""

from __future__ import annotations

from collections import deque
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.executor.callback_group import CallbackGroup
    from zbot.executor.ready_queue import ReadyQueue


class WorkQueue:
    """Functions that wait for the executor, which may come later than they do.

    Args:
        ready_queue: The node's way to its executor.
        callback_group: Decides beside what a function may run.
    """

    due_ns: int | None = None

    def __init__(self, ready_queue: ReadyQueue, callback_group: CallbackGroup) -> None:
        self.ready_queue = ready_queue
        self.callback_group = callback_group
        self._functions: deque[Callable[[], Any]] = deque()
        ready_queue.add(self)

    def add(self, function: Callable[[], Any]) -> None:
        """Let the executor call a function or coroutine function; from any thread."""
        self._functions.append(function)
        self.ready_queue.post(self)

    def take(self) -> Callable[[], Any] | None:
        """Return the function whose turn it is, if any."""
        try:
            return self._functions.popleft()
        except IndexError:
            return None

    def execute(self, function: Callable[[], Any]) -> Any:
        """Call it; a coroutine is the executor's to run."""
        return function()

    def destroy(self) -> None:
        """Forget what waits."""
        self.ready_queue.remove(self)
        self._functions.clear()
