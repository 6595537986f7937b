"""Functions that Zenoh calls, which no exception may leave: Rust would drop it.

They run in Zenoh's threads, but for a service of one's own process in the caller's, which may be
the main one. A Ctrl-C that arrives there has to be raised later.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any, TypeVar

if TYPE_CHECKING:
    from types import CodeType, FrameType

FunctionT = TypeVar("FunctionT", bound=Callable[..., Any])

_codes: set[CodeType] = set()


def called_by_zenoh(function: FunctionT) -> FunctionT:
    """Mark a function."""
    _codes.add(function.__code__)
    return function


def is_foreign(frame: FrameType | None) -> bool:
    """Return whether a frame is inside of a marked function."""
    while frame is not None:
        if frame.f_code in _codes:
            return True
        frame = frame.f_back
    return False
