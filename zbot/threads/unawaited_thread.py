"""Thread that is started by Zenoh's threads, which must not wait for it."""

from __future__ import annotations

import contextlib
import threading
from _thread import start_new_thread
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Callable


class UnawaitedThread(threading.Thread):
    """Thread whose `start` does not wait until the thread runs.

    Python's `start` waits. A new thread may begin with a garbage collection, which may destroy a
    transient local publisher. Zenoh then waits for a task of its network thread. If that network
    thread waited for the new thread, both would wait for ten seconds.

    Args:
        target: The function that the thread runs.
        name: Name of the thread, for debuggers.
    """

    def __init__(self, target: Callable[[], Any], name: str) -> None:
        super().__init__(target=target, name=name, daemon=True)
        self._is_begun = threading.Event()
        self._is_begun.set()

    def start(self) -> None:
        """Let the thread start soon.

        Raises:
            RuntimeError: No thread can be started any more, because the process ends.
        """
        self._is_begun.clear()
        try:
            start_new_thread(self._begin, ())
        except RuntimeError:
            self._is_begun.set()  # otherwise, `join` would wait for a thread that never begins
            raise

    def _begin(self) -> None:
        with contextlib.suppress(RuntimeError):  # the process ends
            super().start()
        self._is_begun.set()

    def join(self, timeout: float | None = None) -> None:
        """Wait until the thread has ended, or for `timeout` seconds. It may never have started."""
        self._is_begun.wait(timeout)
        if self.ident is not None:
            super().join(timeout)
