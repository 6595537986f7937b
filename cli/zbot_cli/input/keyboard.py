"""Keys of the terminal while a command runs, e.g. space for a pause."""

from __future__ import annotations

import contextlib
import os
import sys
from typing import TYPE_CHECKING

from zbot.process.keys import pressed_keys
from zbot.threads.background_thread import background_thread

if TYPE_CHECKING:
    from collections.abc import Callable
    from contextlib import AbstractContextManager
    from threading import Event


def has_keyboard() -> bool:
    """Return whether the command may read keys. A command in the background must not read keys."""
    try:
        if not sys.stdin.isatty():
            return False
        return sys.platform == "win32" or os.tcgetpgrp(sys.stdin.fileno()) == os.getpgrp()
    except (AttributeError, OSError, ValueError):
        return False  # there is no stdin, or it is closed


def keys_to(on_key: Callable[[str], None]) -> AbstractContextManager[None]:
    """Call a function with each key during the `with` block, in a thread.

    The keys are those of `zbot.process.keys.pressed_keys`: an arrow gives several characters.
    """

    def read(is_over: Event) -> None:
        with contextlib.suppress(OSError):  # the terminal was closed
            for key in pressed_keys(lambda: not is_over.is_set()):
                on_key(key)

    # The thread restores the settings of the terminal when it ends.
    return background_thread("zbot keys", read)
