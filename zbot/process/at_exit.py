"""The end of the process: what is open is closed before Python kills the threads that are left.

A thread that is inside Zenoh when Python kills it takes the whole process down, with an abort. The
program's own threads come first: one that spins goes on after the main thread's last line.
"""

from __future__ import annotations

import atexit
import contextlib
import signal
import sys
import threading
import traceback
from types import BuiltinFunctionType
from typing import TYPE_CHECKING, Protocol

from zbot.errors import ExternalShutdownException
from zbot.transport.weak_set import WeakSet

if TYPE_CHECKING:
    import zenoh

_PATIENCE_S = 0.3  # for a callback that is running when the program ends


class OpenContext(Protocol):
    """A context that has a session, as the end of the process sees it."""

    @property
    def sessions(self) -> list[zenoh.Session]:
        """The Zenoh sessions that are open."""
        ...

    @property
    def executors(self) -> set[Executor]:
        """The executors that spin its nodes."""
        ...

    def interrupt(self) -> None:
        """End all that spins."""

    def shutdown(self) -> None:
        """Close the session and everything in it; the second call does nothing."""

    def close(self) -> None:
        """Close the session, also where a signal has interrupted `shutdown()`."""


class Executor(Protocol):
    """An executor, as the end of the process sees it."""

    def wait_idle(self, timeout_s: float, /) -> bool:
        """Wait until nothing spins there."""
        ...


#: Every context that has a session.
open_contexts: WeakSet[OpenContext] = WeakSet()


class _Process:
    hooked = False
    ending = False


def is_ending() -> bool:
    """Return whether the main thread has come to its end."""
    return _Process.ending


def hook() -> None:
    """Close all contexts at the end of the process; the second call does nothing."""
    if not _Process.hooked:
        _Process.hooked = True
        # Python joins non-daemon threads before it runs atexit functions, and Zenoh's thread ends
        # only with its session: concurrent.futures closes its pools by the same, private, means.
        threading._register_atexit(_end)  # type: ignore[attr-defined] # noqa: SLF001
        # A signal that comes just then keeps Python from calling that, but not this.
        atexit.register(_close_contexts)


def wait_for_threads() -> None:
    """Wait for the threads that the program started itself, as Python does at its end.

    Python does so when no thread can start another any more (from 3.12 on), so that none of them
    could open a node. A signal's exception leaves this function at once.
    """
    for thread in _programs_threads():
        thread.join()


def _programs_threads() -> list[threading.Thread]:
    # Pools end their threads after this, and Zenoh's end with their session.
    pools = sys.modules.get("concurrent.futures.thread")
    pooled = () if pools is None else pools._threads_queues  # noqa: SLF001 - their only list
    return [
        thread
        for thread in threading.enumerate()
        if not thread.daemon
        and thread not in {threading.main_thread(), threading.current_thread()}
        and thread not in pooled
        and not isinstance(getattr(thread, "_target", None), BuiltinFunctionType)
    ]


def _end() -> None:
    # A signal ends whatever spins; Python waits for the rest.
    with contextlib.suppress(KeyboardInterrupt, SystemExit, ExternalShutdownException):
        wait_for_threads()
    if signal.getsignal(signal.SIGINT) is signal.default_int_handler:
        # All is done: nobody needs to hear where in Python's own end a Ctrl-C came.
        signal.signal(signal.SIGINT, signal.SIG_DFL)
    _close_contexts()


def _close_contexts() -> None:
    _Process.ending = True
    for context in open_contexts:
        executors = context.executors
        try:
            context.shutdown()
            if context in open_contexts:
                context.close()  # a signal's exception has left an earlier `shutdown()`
        except Exception:  # noqa: BLE001 - the others must be closed too
            traceback.print_exc()
        for executor in executors:
            executor.wait_idle(_PATIENCE_S)
