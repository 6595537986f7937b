"""Keyboard input: single keys from the terminal in which the program runs."""

from __future__ import annotations

import os
import sys
import time
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

_POLL_S = 0.1  # longest time until Ctrl-C is noticed


if sys.platform == "win32":
    import msvcrt

    def _keys(is_reading: Callable[[], bool]) -> Iterator[str]:
        arrows = {"H": "A", "P": "B", "M": "C", "K": "D"}
        while is_reading():
            if not msvcrt.kbhit():
                time.sleep(_POLL_S / 5)
                continue
            key = msvcrt.getwch()
            yield arrows.get(msvcrt.getwch(), "") if key in {"\0", "\xe0"} else key

else:
    import select
    import termios

    def _keys(is_reading: Callable[[], bool]) -> Iterator[str]:
        file = sys.stdin.fileno()
        before: list[Any] | None = None
        try:
            while is_reading():
                if _is_in_background(file):
                    time.sleep(_POLL_S)
                    continue
                before = _read_single_keys(file) or before
                if not select.select([file], [], [], _POLL_S)[0] or _is_in_background(file):
                    continue
                typed = os.read(file, 64)
                if not typed:
                    return
                yield from typed.decode(errors="replace")
        finally:
            if before is not None and not _is_in_background(file):
                termios.tcsetattr(file, termios.TCSANOW, before)

    def _is_in_background(file: int) -> bool:
        """Return whether the system would stop this process if it read from its terminal."""
        try:
            return os.tcgetpgrp(file) != os.getpgrp()
        except OSError:  # a pipe, or the terminal of another session
            return False

    def _read_single_keys(file: int) -> list[Any] | None:
        """Let a terminal send each key. Return its settings before, or `None` without a change.

        A shell sets the terminal back while the program is suspended.
        """
        try:
            before = termios.tcgetattr(file)
        except termios.error:  # not a terminal but a pipe, which has no settings
            return None
        lines = termios.ICANON | termios.ECHO  # Ctrl-C still works
        if not before[3] & lines:
            return None
        wanted = [*before[:3], before[3] & ~lines, *before[4:]]
        termios.tcsetattr(file, termios.TCSANOW, wanted)
        return before


def pressed_keys(is_reading: Callable[[], bool]) -> Iterator[str]:
    """Yield each character that is typed, until the input ends or `is_reading` returns false.

    An arrow key gives one or several characters. The last of these is `A` (up), `B` (down), `C`
    (right) or `D` (left). At the end, the settings of the terminal are restored. No key comes while
    the program runs in the background of a shell.
    """
    return _keys(is_reading)
