"""Keyboard input: single keys from the terminal in which the program runs."""

from __future__ import annotations

import os
import sys
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

_POLL_S = 0.1  # longest time until Ctrl-C is noticed


if sys.platform == "win32":
    import msvcrt
    import time

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
        restore = _read_single_keys(file)
        try:
            while is_reading():
                if not select.select([file], [], [], _POLL_S)[0]:
                    continue
                typed = os.read(file, 64)
                if not typed:
                    return
                yield from typed.decode(errors="replace")
        finally:
            restore()

    def _read_single_keys(file: int) -> Callable[[], None]:
        try:
            before = termios.tcgetattr(file)
        except termios.error:  # not a terminal but a pipe, which has no settings
            return lambda: None
        wanted = termios.tcgetattr(file)
        wanted[3] &= ~(termios.ICANON | termios.ECHO)  # Ctrl-C still works
        termios.tcsetattr(file, termios.TCSANOW, wanted)
        return lambda: termios.tcsetattr(file, termios.TCSANOW, before)


def pressed_keys(is_reading: Callable[[], bool]) -> Iterator[str]:
    """Yield each character that is typed, until the input ends or `is_reading` returns false.

    An arrow key gives one or several characters. The last of these is `A` (up), `B` (down), `C`
    (right) or `D` (left). At the end, the settings of the terminal are restored.
    """
    return _keys(is_reading)
