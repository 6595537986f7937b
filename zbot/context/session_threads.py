"""Threads that use a session, which end before the process does.

Python kills the threads that still run at its exit. Killing a thread inside Zenoh crashes the
process.
"""

from __future__ import annotations

import threading
from typing import TYPE_CHECKING, Any

import zenoh

from zbot.threads.foreign_call import called_by_zenoh, without_interruption
from zbot.threads.unawaited_thread import UnawaitedThread
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

        thread = UnawaitedThread(body, name)
        self._threads[thread] = wake
        without_interruption(thread.start)

    def receiver(self, receive: Callable[[Any], object], *, may_wait: bool = False) -> Any:
        """Return a Zenoh handler that calls a function. `join` waits for the function's last call.

        Args:
            receive: The function. Zenoh's network thread calls it, or the thread that causes the
                event. So it must return within microseconds.
            may_wait: Whether the function may wait, or log. Then a thread of its own calls it. The
                thread sleeps until an event comes. Up to 256 events wait for it, and more events
                block the session.
        """
        ended = threading.Event()

        @called_by_zenoh
        def call(event: Any) -> None:
            receive(event)

        @called_by_zenoh
        def end() -> None:
            self._receivers.discard(ended)
            ended.set()

        self._receivers.add(ended)
        return zenoh.handlers.Callback(call, drop=end, indirect=may_wait)

    def join(self) -> None:
        """Wake the threads of a closed session, and wait for their end, at most 2 s for each."""
        for thread, wake in list(self._threads.items()):
            wake()
            if thread is not threading.current_thread():
                thread.join(_JOIN_TIMEOUT_S)
        for ended in self._receivers:
            ended.wait(_JOIN_TIMEOUT_S)
