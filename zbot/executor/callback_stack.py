"""Stack of the callbacks that a thread runs, with functions to call when a callback ends."""

from __future__ import annotations

import threading
from typing import TYPE_CHECKING

from zbot.process import fork

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.executor.ready_queue import Entity
    from zbot.executor.spinnable import NodeExecutor


class CallbackStack(threading.local):
    """The callbacks that the calling thread runs. The innermost callback is the last item."""

    def __init__(self) -> None:
        self.stack: list[tuple[NodeExecutor, Entity]] = []
        self._at_end: list[tuple[int, Callable[[], object]]] = []

    def clear(self) -> None:
        """In a forked child, forget the callbacks that the calling thread ran in the parent."""
        self.stack.clear()
        self._at_end.clear()

    def pop(self) -> None:
        """Remove the innermost callback, and call the functions that it gave to `at_end`."""
        if self.stack:  # it is empty in a forked child, in which a callback goes on
            self.stack.pop()
        self._call_at_end()

    def forget(self, executor: NodeExecutor) -> list[Entity]:
        """Remove all callbacks of an executor, and return their entities.

        An executor that runs no callback calls this, after an exception of a signal has prevented
        a call of `pop`.
        """
        left = [entity for owner, entity in self.stack if owner is executor]
        self.stack[:] = [item for item in self.stack if item[0] is not executor]
        self._call_at_end()
        return left

    def _call_at_end(self) -> None:
        while self._at_end and self._at_end[-1][0] > len(self.stack):
            self._at_end.pop()[1]()

    def at_end(self, function: Callable[[], object]) -> None:
        """Call a quick function after the end of the innermost callback."""
        self._at_end.append((len(self.stack), function))


running_callbacks = CallbackStack()
fork.in_child.append(running_callbacks.clear)


def current_executor() -> NodeExecutor | None:
    """Return the executor whose callback the calling thread runs, if any."""
    return running_callbacks.stack[-1][0] if running_callbacks.stack else None
