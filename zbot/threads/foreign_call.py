"""Functions that a signal's exception must not interrupt. The signal waits until they return.

Otherwise the exception would be lost, or the function would not release its locks. Zenoh usually
calls Python functions in its own threads. But if a client and its service are in one process, Zenoh
calls the service in the client's thread, which may be the main thread. Zenoh's Rust code loses
exceptions of these functions.

A signal may come when Python has just entered such a function. Then Python shows the signal's
handler the frame of the caller of Zenoh. So a declaration that leads back into Python is marked
too.
"""

from __future__ import annotations

import threading
from collections.abc import Callable
from typing import TYPE_CHECKING, Any, TypeVar

if TYPE_CHECKING:
    from types import CodeType, FrameType

FunctionT = TypeVar("FunctionT", bound=Callable[..., Any])
ResultT = TypeVar("ResultT")

_IMPORTS = "<frozen importlib._bootstrap>"
_deferring: set[CodeType] = set()
_known = threading.local()


def defers_signals(function: FunctionT) -> FunctionT:
    """Mark a function that a signal's exception must not interrupt."""
    _deferring.add(function.__code__)
    return function


def called_by_zenoh(function: FunctionT) -> FunctionT:
    """Mark a function that Zenoh calls."""
    return defers_signals(function)


@defers_signals
def without_interruption(
    function: Callable[..., ResultT], *arguments: Any, **options: Any
) -> ResultT:
    """Call a function that starts a thread. A signal's exception waits until the function returns.

    An exception would leave the thread half started. Then no other thread could wait for its end,
    and Zenoh would abort the process when Python destroys the thread at the exit.
    """
    return function(*arguments, **options)


def is_deferring_signals(frame: FrameType | None) -> bool:
    """Return whether a frame is inside a marked function or is a function of Python's import.

    After an exception, an import function would not release the import lock. A signal is allowed
    to interrupt the code of an imported module.
    """
    if frame is not None and frame.f_code.co_filename == _IMPORTS:
        return True
    while frame is not None:
        if frame.f_code in _deferring:
            return True
        frame = frame.f_back
    return False


def keep_thread_state() -> None:
    """Let Python keep its state of the calling Zenoh thread until the process ends.

    Without this, Python creates a new state at each call from Zenoh. This takes 20 us, because the
    memory comes from the kernel. Zenoh has few threads, and they exist as long as the process. So
    this function calls `PyGILState_Ensure` once in each thread, and never releases the state. If
    Python is not CPython, the function does nothing.
    """
    if getattr(_known, "is_kept", False):
        return
    _known.is_kept = True
    import ctypes  # noqa: PLC0415 - takes 3 ms, and only service calls need it

    enter = getattr(getattr(ctypes, "pythonapi", None), "PyGILState_Ensure", None)
    if enter is not None:
        enter()
