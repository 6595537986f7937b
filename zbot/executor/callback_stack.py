"""The callbacks that a thread is in, and what has to wait until they end."""

from __future__ import annotations

import threading
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.executor.executor import Executor
    from zbot.executor.ready_queue import Entity


class CallbackStack(threading.local):
    """The calling thread's callbacks, the innermost last."""

    def __init__(self) -> None:
        self.stack: list[tuple[Executor, Entity]] = []
        self._afterwards: list[tuple[int, Callable[[], object]]] = []

    def pop(self) -> None:
        """Leave the innermost callback."""
        self.stack.pop()
        while self._afterwards and self._afterwards[-1][0] > len(self.stack):
            self._afterwards.pop()[1]()

    def at_end(self, function: Callable[[], object]) -> None:
        """Call a quick function when the innermost callback has ended."""
        self._afterwards.append((len(self.stack), function))


callbacks = CallbackStack()


def current_executor() -> Executor | None:
    """Return the executor whose callback the calling thread is in, if any."""
    return callbacks.stack[-1][0] if callbacks.stack else None
