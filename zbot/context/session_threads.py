"""Threads that use a session, which end before the process does.

Python kills the threads that still run at its exit. Killing a thread inside Zenoh crashes the
process.
"""

from __future__ import annotations

import threading
from typing import TYPE_CHECKING, Any

import zenoh

from zbot.threads.foreign_call import without_interruption
from zbot.threads.weak_set import WeakSet

if TYPE_CHECKING:
    from collections.abc import Callable

_JOIN_TIMEOUT_S = 2.0  # threads end within a millisecond after their session


class SessionThreads:
    """Threads of Python and of Zenoh that use a session. Any thread may call the methods."""

    def __init__(self) -> None:
        self._threads: dict[threading.Thread, Callable[[], object]] = {}
        # The set is weak, because a signal's exception may come before Zenoh gets a receiver.
        # `join` must not wait for such a receiver.
        self._receivers: WeakSet[threading.Event] = WeakSet()

    def start(self, name: str, run: Callable[[], None], wake: Callable[[], object] = bool) -> None:
        """Run a function in a thread that `join` waits for.

        Args:
            name: Name of the thread, for debuggers.
            run: The function, which must end after the session was closed and `wake` was called.
            wake: Called after the session was closed.
        """

        def body() -> None:
            try:
                run()
            finally:
                self._threads.pop(thread, None)

        thread = threading.Thread(target=body, name=name, daemon=True)
        self._threads[thread] = wake
        without_interruption(thread.start)

    def receiver(self, receive: Callable[[Any], object]) -> Any:
        """Return a Zenoh handler that calls a function in a thread that `join` waits for.

        The thread belongs to Zenoh and sleeps until an event comes. A Python thread that waited
        for a channel of Zenoh would wake up ten times a second. The handler's queue holds 256
        events, and a full queue blocks the session.

        Args:
            receive: The function, which must return quickly.
        """
        ended = threading.Event()

        def end() -> None:
            self._receivers.discard(ended)
            ended.set()

        self._receivers.add(ended)
        return zenoh.handlers.Callback(receive, drop=end)

    def join(self) -> None:
        """Wake the threads of a closed session, and wait for their end, at most 2 s for each."""
        for thread, wake in list(self._threads.items()):
            wake()
            # A thread whose start was interrupted by a signal has no ident.
            if thread is not threading.current_thread() and thread.ident is not None:
                thread.join(_JOIN_TIMEOUT_S)
        for ended in self._receivers:
            ended.wait(_JOIN_TIMEOUT_S)
