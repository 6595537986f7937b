"""End of a wait, and repeated calls of a function until a deadline."""

from __future__ import annotations

import math
import threading
import time
from typing import TYPE_CHECKING, TypeVar

if TYPE_CHECKING:
    from collections.abc import Callable

T = TypeVar("T")


class Deadline:
    """Point in time at which a wait ends.

    Args:
        timeout_s: Seconds from now. `None` means no limit. If the number is 0 or negative, the time
            is over already.
    """

    __slots__ = ("_end_s",)

    def __init__(self, timeout_s: float | None) -> None:
        self._end_s = math.inf if timeout_s is None else time.monotonic() + timeout_s

    @property
    def left_s(self) -> float:
        """Seconds that are left, at least 0. Without a limit, the longest wait of a lock."""
        return min(max(self._end_s - time.monotonic(), 0.0), threading.TIMEOUT_MAX)

    @property
    def is_over(self) -> bool:
        """Whether no time is left."""
        return time.monotonic() >= self._end_s


def poll(look: Callable[[], T], timeout_s: float | None, pause_s: float) -> T:
    """Call a function until its result is true or the time is over. Return its last result.

    The function is called at least once, and also at the end of the time.

    Args:
        look: The function.
        timeout_s: Seconds to wait. `None` means no limit.
        pause_s: Seconds to sleep between two calls.
    """
    deadline = Deadline(timeout_s)
    while not (seen := look()) and not deadline.is_over:
        time.sleep(min(pause_s, deadline.left_s))
    return seen
