"""Command in a terminal of its own, for keys."""

from __future__ import annotations

import os
import selectors
import subprocess
import sys
import time
from typing import TYPE_CHECKING

import pytest

from tests.conftest import allowed

if TYPE_CHECKING:
    from pathlib import Path


posix = pytest.mark.skipif(sys.platform == "win32", reason="pseudo-terminals are POSIX's")


class Terminal:
    """Command in a terminal of its own."""

    def __init__(self, folder: Path, *words: str) -> None:
        import pty  # noqa: PLC0415 - there is none on Windows

        self._main, end = pty.openpty()
        self._text = ""
        self.process = subprocess.Popen(
            [sys.executable, "-m", "zbot_cli", *words],
            stdin=end,
            stdout=end,
            stderr=end,
            cwd=folder,
            preexec_fn=lambda: become_foreground(end),  # noqa: PLW1509 - the tests start no threads in it
        )
        os.close(end)

    def press(self, keys: str) -> None:
        os.write(self._main, keys.encode())

    def wait_for(self, text: str) -> None:
        """Wait for a text after the last one."""
        deadline = time.monotonic() + allowed(30)
        with selectors.DefaultSelector() as selector:
            selector.register(self._main, selectors.EVENT_READ)
            while text not in self._text:
                assert selector.select(max(deadline - time.monotonic(), 0)), self._text
                try:
                    self._text += os.read(self._main, 65536).decode()
                except OSError:  # the end of the output
                    pytest.fail(f"{text!r} never came; there was:\n{self._text}")
        self._text = self._text.partition(text)[2]

    def close(self) -> None:
        self.process.kill()
        self.process.wait(5)
        os.close(self._main)


def become_foreground(end: int) -> None:
    """Make a terminal the controlling terminal of this process, as a shell does."""
    os.setsid()
    import fcntl  # noqa: PLC0415 - there is none on Windows
    import termios  # noqa: PLC0415 - as above

    fcntl.ioctl(end, termios.TIOCSCTTY, 0)
