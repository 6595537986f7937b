"""Keys as they are pressed, from the terminal that the program runs in."""

from __future__ import annotations

import os
import sys
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

_PATIENCE_S = 0.1  # how long Ctrl-C may go unnoticed


def pressed_keys(go_on: Callable[[], bool]) -> Iterator[str]:
    """Yield each character that is typed, until the input ends or `go_on` says no.

    An arrow key comes as several characters, of which the last is `A` (up), `B` (down), `C` (right)
    or `D` (left). The terminal is as it was afterwards.
    """
    return _windows_keys(go_on) if sys.platform == "win32" else _posix_keys(go_on)


def _posix_keys(go_on: Callable[[], bool]) -> Iterator[str]:
    import select  # noqa: PLC0415 - not for Windows' terminals

    file = sys.stdin.fileno()
    restore = _listen_to_single_keys(file)
    try:
        while go_on():
            if not select.select([file], [], [], _PATIENCE_S)[0]:
                continue
            typed = os.read(file, 64)
            if not typed:
                return
            yield from typed.decode(errors="replace")
    finally:
        restore()


def _listen_to_single_keys(file: int) -> Callable[[], None]:
    import termios  # noqa: PLC0415 - there is none on Windows

    try:
        before = termios.tcgetattr(file)
    except termios.error:  # not a terminal: whatever comes through the pipe
        return lambda: None
    wanted: list[Any] = termios.tcgetattr(file)
    wanted[3] &= ~(termios.ICANON | termios.ECHO)  # Ctrl-C still works
    termios.tcsetattr(file, termios.TCSANOW, wanted)
    return lambda: termios.tcsetattr(file, termios.TCSANOW, before)


def _windows_keys(go_on: Callable[[], bool]) -> Iterator[str]:
    import time  # noqa: PLC0415 - only here

    console: Any = __import__("msvcrt")
    arrows = {"H": "A", "P": "B", "M": "C", "K": "D"}
    while go_on():
        if not console.kbhit():
            time.sleep(_PATIENCE_S / 5)
            continue
        key = console.getwch()
        yield arrows.get(console.getwch(), "") if key in {"\0", "\xe0"} else key
