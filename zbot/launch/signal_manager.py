"""Manager of signal handlers, which run inside an event loop."""

from __future__ import annotations

import contextlib
import os
import signal
import socket
import sys
from typing import TYPE_CHECKING, Any

from zbot.process import signals
from zbot.threads.foreign_call import is_deferring_signals

if TYPE_CHECKING:
    import asyncio
    from collections.abc import Callable
    from types import TracebackType


class AsyncSafeSignalManager:
    """Context manager that calls handlers in an event loop when signals come.

    Managers may be nested. The manager also calls the previous handler of a signal, but not
    Python's own handler, which would raise KeyboardInterrupt.

    Args:
        loop: The event loop that calls the handlers.
        interruption: Function that gets the number of a signal at once, while the loop may run
            code that takes long. If it returns an error, the signal raises this error in that code
            and the handler is not called.
    """

    def __init__(
        self,
        loop: asyncio.AbstractEventLoop,
        interruption: Callable[[int], BaseException | None] = lambda _: None,
    ) -> None:
        self._loop, self._interruption = loop, interruption
        self._handlers: dict[int, Callable[[int], Any]] = {}
        self._previous: dict[int, Any] = {}
        self._is_entered = False
        self._ends: tuple[socket.socket, ...] = ()  # Python writes signals into the second socket
        self._previous_fd = -1

    def handle(
        self, signum: signal.Signals | int, handler: Callable[[int], Any] | None
    ) -> Callable[[int], Any] | None:
        """Set a signal's handler. The handler gets the signal's number. None removes the handler.

        Returns:
            The handler that this manager had for the signal, or None.

        Raises:
            ValueError: `handler` is not callable, or this is not the main thread.
        """
        if handler is not None and not callable(handler):
            raise ValueError(f"a signal's handler must be callable, not {handler!r}")
        number = signal.Signals(signum)
        previous = self._handlers.pop(number, None)
        if handler is not None:
            self._handlers[number] = handler
        if self._is_entered:
            self._install(number)
        return previous

    def _install(self, number: int) -> None:
        if number in self._handlers and number not in self._previous:
            self._previous[number] = signal.signal(number, self._on_signal)
        elif number not in self._handlers and number in self._previous:
            signal.signal(number, self._previous.pop(number))

    def _on_signal(self, number: int, frame: Any) -> None:
        if is_deferring_signals(frame):
            signals.send_again(number)
            return
        handler, previous = self._handlers.get(number), self._previous.get(number)
        error = None if handler is None else self._interruption(number)
        if handler is not None and error is None:
            self._loop.call_soon_threadsafe(handler, number)
        if callable(previous) and previous is not signal.default_int_handler:
            previous(number, frame)
        if error is not None:
            raise error

    def __enter__(self) -> AsyncSafeSignalManager:
        self._is_entered = True
        self._let_signals_wake_the_loop()
        for number in self._handlers:
            self._install(number)
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self._is_entered = False
        while self._previous:
            signal.signal(*self._previous.popitem())
        if self._ends:
            if not self._loop.is_closed():
                self._loop.remove_reader(self._ends[0])
            signal.set_wakeup_fd(self._previous_fd)
        for end in self._ends:
            end.close()
        self._ends = ()

    def _let_signals_wake_the_loop(self) -> None:
        # Python writes each signal into a socket. So a signal wakes the loop even if the signal
        # comes just before the loop waits. On Windows, the loop itself does this.
        if sys.platform == "win32":
            return
        self._ends = reader, writer = socket.socketpair()
        reader.setblocking(False)
        writer.setblocking(False)
        self._previous_fd = signal.set_wakeup_fd(writer.fileno(), warn_on_full_buffer=False)
        self._loop.add_reader(reader, self._pass_on)

    def _pass_on(self) -> None:
        numbers = self._ends[0].recv(4096)
        if self._previous_fd != -1:
            with contextlib.suppress(OSError):  # the buffer is full, or the descriptor is closed
                os.write(self._previous_fd, numbers)
