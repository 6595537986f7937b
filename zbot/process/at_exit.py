"""Exit function of the process. It closes all contexts before Python kills the other threads.

Zenoh aborts the process if Python kills a thread inside Zenoh. The function first waits for the
program's own threads, because they may still run `spin()` when the main thread ends.
"""

from __future__ import annotations

import atexit
import contextlib
import gc
import signal
import sys
import threading
import traceback
from types import BuiltinFunctionType
from typing import TYPE_CHECKING, Protocol

from zbot.errors import ExternalShutdownException
from zbot.errors.call_source import OWN_FILES
from zbot.threads.deadline import poll
from zbot.threads.weak_set import WeakSet

if TYPE_CHECKING:
    from collections.abc import Callable

    import zenoh

_CALLBACK_TIMEOUT_S = 0.3  # for a callback that runs when the program ends
_CALL_TIMEOUT_S = 0.3  # a call into a closed session returns within a millisecond
_PAUSE_S = 0.001


class OpenContext(Protocol):
    """The part of an open context that the exit function uses."""

    @property
    def sessions(self) -> list[zenoh.Session]:
        """The Zenoh sessions that are open."""
        ...

    @property
    def executors(self) -> set[Executor]:
        """The executors of the context's nodes."""
        ...

    def shutdown(self) -> None:
        """Close the session and all its entities. A second call does nothing."""

    def close(self) -> None:
        """Close the session. This also works after a signal has interrupted `shutdown()`."""

    def leave_to_parent(self) -> None:
        """In a forked child, leave the session and all entities to the parent process."""


class Executor(Protocol):
    """The part of an executor that the exit function uses."""

    def wait_idle(self, timeout_s: float, /) -> bool:
        """Wait until no thread spins the executor."""
        ...

    def leave_to_parent(self) -> None:
        """In a forked child, end all loops."""


#: Every context that has a session.
open_contexts: WeakSet[OpenContext] = WeakSet()


#: Functions that are called after the contexts were closed, and before Python itself waits for
#: threads. The argument is true if a signal interrupted `wait_for_threads`.
when_closed: list[Callable[[bool], None]] = []


class _Process:
    is_registered = False
    is_ending = False
    main_thread_has_ended = False


def wait_for_end(timeout_s: float) -> bool:
    """Wait until the main thread has ended. Return `False` if the time is over."""
    return poll(lambda: _Process.main_thread_has_ended, timeout_s, _PAUSE_S)


def is_ending() -> bool:
    """Return whether the contexts of the process are being closed."""
    return _Process.is_ending


def register() -> None:
    """Let the process close all contexts at its end. A second call does nothing."""
    if not _Process.is_registered:
        _Process.is_registered = True
        # An atexit function would be too late, because Python first joins the non-daemon threads.
        # Zenoh's thread is such a thread, and it ends only when its session is closed.
        # concurrent.futures uses _register_atexit too.
        threading._register_atexit(_end)  # type: ignore[attr-defined] # noqa: SLF001
        # If a signal comes while Python waits for threads, Python does not call `_end`. But it
        # still calls atexit functions.
        atexit.register(_close_contexts)


def leave_to_parent() -> list[OpenContext]:
    """In a forked child, forget the contexts of the parent process, and return them."""
    _Process.is_ending = _Process.main_thread_has_ended = False
    contexts = list(open_contexts)
    open_contexts.clear()
    return contexts


def wait_for_threads() -> None:
    """Wait for the threads that the program started, as Python does at its end.

    While this function waits, the threads can still start other threads and create nodes. Both are
    impossible while Python 3.12 or later waits for threads. A signal's exception ends this function
    immediately.
    """
    _Process.main_thread_has_ended = True
    for thread in _program_threads():
        thread.join()


def _program_threads() -> list[threading.Thread]:
    # The list leaves out the threads of thread pools, which the pools end later, and Zenoh's
    # threads, which end when their session is closed.
    pools = sys.modules.get("concurrent.futures.thread")
    pooled = () if pools is None else pools._threads_queues  # noqa: SLF001 - no public list
    return [
        thread
        for thread in threading.enumerate()
        if not thread.daemon
        and thread not in {threading.main_thread(), threading.current_thread()}
        and thread not in pooled
        and not isinstance(getattr(thread, "_target", None), BuiltinFunctionType)
    ]


def _end() -> None:
    # If a signal ends this wait, the signal also ends the threads that spin. Python itself waits
    # for the other threads.
    was_interrupted = True
    with contextlib.suppress(KeyboardInterrupt, SystemExit, ExternalShutdownException):
        wait_for_threads()
        was_interrupted = False
    if signal.getsignal(signal.SIGINT) is signal.default_int_handler:
        # The program is over: a Ctrl-C from now on must not print a traceback.
        signal.signal(signal.SIGINT, signal.SIG_DFL)
    _close_contexts()
    for function in when_closed:
        function(was_interrupted)


def _close_contexts() -> None:
    _Process.is_ending = True
    for context in open_contexts:
        executors = context.executors
        try:
            context.shutdown()
            if context in open_contexts:
                context.close()  # a signal's exception ended an earlier `shutdown()`
        except Exception:  # noqa: BLE001 - the other contexts must be closed too
            traceback.print_exc()
        for executor in executors:
            executor.wait_idle(_CALLBACK_TIMEOUT_S)
    poll(lambda: not _calls_zbot(), _CALL_TIMEOUT_S, _PAUSE_S)  # the pauses let the threads run


def _calls_zbot() -> bool:
    """Return whether another thread is inside a function of zbot, and so perhaps inside Zenoh.

    After the sessions were closed, such a function raises an error immediately.
    """
    # In Python 3.11 and older, `_current_frames` holds a lock L. A garbage collection during the
    # call lets other threads run. A thread that ends takes Python's main lock and then waits for L.
    # This thread has L and waits for the main lock. So there must be no collection.
    was_enabled = gc.isenabled()
    gc.disable()
    try:
        frames = sys._current_frames()  # noqa: SLF001 - Python has no other way
    finally:
        if was_enabled:
            gc.enable()
    own = threading.get_ident()
    return any(
        frame.f_code.co_filename.startswith(OWN_FILES)
        for ident, frame in frames.items()
        if ident != own
    )
