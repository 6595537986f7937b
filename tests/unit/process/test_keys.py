"""Keys of a terminal, also of a program that a shell has sent to the background."""

from __future__ import annotations

import os
import sys
from typing import TYPE_CHECKING

import pytest

from zbot.process.keys import pressed_keys

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="pseudo-terminals are POSIX's")


class Terminal:
    """Terminal of this process. `group` is the process group that a shell has in the foreground."""

    def __init__(self) -> None:
        import pty  # noqa: PLC0415 - there is none on Windows

        self._main, self._end = pty.openpty()
        self.group = os.getpgrp()

    def fileno(self) -> int:
        return self._end

    def press(self, keys: str) -> None:
        os.write(self._main, keys.encode())

    @property
    def reads_lines(self) -> bool:
        import termios  # noqa: PLC0415 - there is none on Windows

        return bool(termios.tcgetattr(self._end)[3] & termios.ICANON)

    def read_lines(self) -> None:
        import termios  # noqa: PLC0415 - there is none on Windows

        settings = termios.tcgetattr(self._end)
        settings[3] |= termios.ICANON | termios.ECHO
        termios.tcsetattr(self._end, termios.TCSANOW, settings)

    def close(self) -> None:
        os.close(self._main)
        os.close(self._end)


@pytest.fixture
def terminal(monkeypatch: pytest.MonkeyPatch) -> Iterator[Terminal]:
    opened = Terminal()
    monkeypatch.setattr(sys, "stdin", opened)
    monkeypatch.setattr(os, "tcgetpgrp", lambda _: opened.group)
    yield opened
    opened.close()


def before_each_turn(*actions: Callable[[], object]) -> Callable[[], bool]:
    left = iter(actions)

    def is_reading() -> bool:
        action = next(left, None)
        if action is not None:
            action()
        return action is not None

    return is_reading


def nothing() -> None:
    pass


def test_a_key_comes_without_a_line_end(terminal: Terminal) -> None:
    turns = before_each_turn(nothing, lambda: terminal.press("s"))
    assert list(pressed_keys(turns)) == ["s"]
    assert terminal.reads_lines  # as before


def test_a_program_in_the_background_leaves_the_terminal_alone(terminal: Terminal) -> None:
    terminal.group += 1
    seen: list[bool] = []
    turns = before_each_turn(
        lambda: terminal.press("ls\n"), lambda: seen.append(terminal.reads_lines)
    )
    assert list(pressed_keys(turns)) == []
    assert seen == [True]


def test_keys_come_again_after_the_shell_has_set_the_terminal_back(terminal: Terminal) -> None:
    turns = before_each_turn(nothing, terminal.read_lines, lambda: terminal.press("s"))
    assert list(pressed_keys(turns)) == ["s"]
