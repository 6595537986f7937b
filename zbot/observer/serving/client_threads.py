"""Share of one client in the threads of a server."""

from __future__ import annotations

import threading
from collections import deque
from functools import partial
from typing import TYPE_CHECKING, Any

from zbot.observer.serving.client_budget import MAX_THREADS

if TYPE_CHECKING:
    from collections.abc import Callable
    from concurrent.futures import Executor


class ClientThreads:
    """Threads of one client. Other work of the client waits while it uses its share.

    Args:
        pool: The threads of all clients.
        most: The number of threads that the client may use at the same time.
    """

    def __init__(self, pool: Executor, most: int = MAX_THREADS) -> None:
        self._pool = pool
        self._idle = most
        self._waiting: deque[Callable[[], object]] = deque()
        self._lock = threading.Lock()

    def submit(self, function: Callable[..., object], *arguments: Any) -> None:
        """Call a function in a thread when it is its turn."""
        with self._lock:
            self._waiting.append(partial(function, *arguments))
            if not self._idle:
                return
            self._idle -= 1
        self._pool.submit(self._run)

    def _run(self) -> None:
        with self._lock:
            work = self._waiting.popleft() if self._waiting else None
        try:
            if work is not None:
                work()
        finally:
            self._continue()

    def _continue(self) -> None:
        with self._lock:
            if not self._waiting:
                self._idle += 1
                return
        self._pool.submit(self._run)  # behind the work of other clients

    def close(self) -> None:
        """Forget what waits."""
        with self._lock:
            self._waiting.clear()
