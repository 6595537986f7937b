"""Process of a command line in bash, with a keyboard and with its output as text."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import threading
import time
from typing import TYPE_CHECKING

from tests.conftest import allowed

if TYPE_CHECKING:
    from collections.abc import Callable
    from pathlib import Path


def _pseudo_terminal() -> tuple[int, int]:
    if sys.platform == "win32":
        raise OSError("Windows has no pseudo-terminals")
    return os.openpty()


class Shell:
    """Process of a command line in bash, with a keyboard and with its output as text."""

    def __init__(self, command: str, folder: Path, env: dict[str, str]) -> None:
        self.keyboard, screen = _pseudo_terminal()
        self.process = subprocess.Popen(
            ["bash", "-c", command],
            cwd=folder,
            env=env,
            stdin=screen,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            start_new_session=True,
        )
        os.close(screen)
        self.output = ""
        self._changed = threading.Condition()
        self._thread = threading.Thread(target=self._read, daemon=True)
        self._thread.start()

    def _read(self) -> None:
        assert self.process.stdout is not None
        with self.process.stdout as lines:
            for line in lines:
                with self._changed:
                    self.output += line.decode("utf-8").replace("\r\n", "\n")
                    self._changed.notify_all()

    def wait_for(self, is_wanted: Callable[[str], bool], timeout_s: float = 20) -> bool:
        """Wait until the output is as wanted; return whether it is."""
        deadline = time.monotonic() + min(allowed(timeout_s), 60)
        with self._changed:
            while not is_wanted(self.output):
                left = deadline - time.monotonic()
                # A program that has ended has no more output than the reader thread has now.
                if left < 0 or not self._thread.is_alive():
                    return is_wanted(self.output)
                self._changed.wait(min(left, 0.1))
        return True

    def wait(self, timeout_s: float = 30) -> int:
        """Wait for the end and for all output; return the exit code."""
        code = self.process.wait(allowed(timeout_s))
        # A background process of the command, such as a router, may keep the pipe open.
        self._thread.join(1)
        return code

    def press(self, keys: bytes) -> None:
        """Press keys of the keyboard."""
        os.write(self.keyboard, keys)

    def send(self, number: signal.Signals) -> None:
        """Send a signal to the program, as Ctrl-C does."""
        if sys.platform != "win32" and self.process.poll() is None:
            os.killpg(self.process.pid, number)

    def close(self) -> None:
        """End the program."""
        if sys.platform != "win32":
            self.send(signal.SIGKILL)
        self.process.wait(5)
        os.close(self.keyboard)
