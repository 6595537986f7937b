"""Functions in which a Ctrl-C has to wait: its exception would be lost, or leave locks taken.

What Zenoh calls runs in its own threads, but for a service of one's own process in the caller's,
which may be the main one: no exception may leave it, for Rust would drop that.
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
_codes: set[CodeType] = set()
_known = threading.local()


def uninterrupted(function: FunctionT) -> FunctionT:
    """Mark a function that a signal's exception must not leave half done."""
    _codes.add(function.__code__)
    return function


def called_by_zenoh(function: FunctionT) -> FunctionT:
    """Mark a function that Zenoh calls."""
    return uninterrupted(function)


@uninterrupted
def in_one_go(function: Callable[..., ResultT], *arguments: Any, **options: Any) -> ResultT:
    """Call a function that starts a thread: one of ours, or of Zenoh's for what it is to call.

    A signal's exception would leave that thread half started: nobody could wait for its end any
    more, and Python's end, which destroys it, makes Zenoh abort the process.
    """
    return function(*arguments, **options)


def is_uninterrupted(frame: FrameType | None) -> bool:
    """Return whether a frame is inside of a marked function, or of Python's own for imports.

    The latter would leave the lock of all imports taken. What a module itself does is not meant.
    """
    if frame is not None and frame.f_code.co_filename == _IMPORTS:
        return True
    while frame is not None:
        if frame.f_code in _codes:
            return True
        frame = frame.f_back
    return False


def keep_thread_state() -> None:
    """Let Python remember the calling thread of Zenoh's until the process ends.

    A foreign thread is a new one to Python at each call, and gets memory for its frames from the
    kernel, which takes it 20 us. Zenoh's threads are few and live as long as the process, so they
    enter once more than they leave. Does nothing where Python is not CPython.
    """
    if getattr(_known, "is_kept", False):
        return
    _known.is_kept = True
    import ctypes  # noqa: PLC0415 - 3 ms, which a program without service calls does not need

    enter = getattr(getattr(ctypes, "pythonapi", None), "PyGILState_Ensure", None)
    if enter is not None:
        enter()
