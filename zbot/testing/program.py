"""Program of a test, which runs as a process."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import threading
from typing import TYPE_CHECKING

from zbot.package.zbot_command import zbot_command
from zbot.threads.deadline import Deadline

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence
    from pathlib import Path

_END_S = 5.0  # after Ctrl-C, before the program is killed


class Program:
    """Process of a program, whose lines of output a test can wait for.

    Args:
        command: The words of the command. `zbot`, `ros2`, `python` and `python3` are those of the
            Python that runs the test.
        cwd: The folder in which the program runs. `None` means the current folder.
        env: Its environment. `None` means that of the test.
        stdin: Its stdin, with the same values as in `subprocess`.
    """

    def __init__(
        self,
        command: Sequence[str],
        cwd: str | Path | None = None,
        env: Mapping[str, str] | None = None,
        stdin: int = subprocess.DEVNULL,
    ) -> None:
        self._command = " ".join(command)
        self.process = subprocess.Popen(  # noqa: S603 - the test names the program
            _of_this_python(command),
            cwd=cwd,
            env={"PYTHONUNBUFFERED": "1", **(os.environ if env is None else env)},
            stdin=stdin,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            encoding="utf-8",
            errors="replace",
        )
        self.lines: list[str] = []  #: the lines of output that have come
        self._next = 0  # number of the first line that `wait_for` has not read
        self._changed = threading.Condition()
        self._reader = threading.Thread(target=self._read, daemon=True)
        self._is_over = False
        self._reader.start()

    def __str__(self) -> str:
        return self._command

    def _read(self) -> None:
        assert self.process.stdout is not None
        with self.process.stdout as lines:
            for line in lines:
                with self._changed:
                    self.lines.append(line.rstrip("\n"))
                    self._changed.notify_all()
        with self._changed:
            self._is_over = True
            self._changed.notify_all()

    def wait_for(self, text: str, timeout: float = 20.0) -> str:
        """Return the next line that contains `text`.

        Args:
            text: A part of the line.
            timeout: The longest time to wait, in seconds.

        Raises:
            AssertionError: The line did not come in time, or the program ended before.
        """
        __tracebackhide__ = True
        deadline = Deadline(timeout)
        with self._changed:
            while True:
                while self._next < len(self.lines):
                    self._next += 1
                    if text in self.lines[self._next - 1]:
                        return self.lines[self._next - 1]
                if self._is_over or deadline.is_over:
                    raise AssertionError(self._missing(text, timeout))
                self._changed.wait(deadline.left_s)

    def _missing(self, text: str, timeout: float) -> str:
        if self._is_over:
            why = f"ended with exit code {self.process.wait(_END_S)} and never printed"
        else:
            why = f"did not print within {timeout:g} s:"
        return f"`{self}` {why} {text!r}; there was:\n{self.output or '(nothing)'}"

    def see(self, text: str, timeout: float = 20.0) -> None:
        """Wait for a line that contains `text`, unless it has come. Use it for lines in any order.

        Raises:
            AssertionError: As in `wait_for`.
        """
        __tracebackhide__ = True
        with self._changed:
            has_come = any(text in line for line in self.lines[: self._next])
        if not has_come:
            self.wait_for(text, timeout)

    def new_lines(self) -> list[str]:
        """Return the lines that have come since the last line that was waited for."""
        with self._changed:
            found, self._next = self.lines[self._next :], len(self.lines)
        return found

    @property
    def output(self) -> str:
        """All output that has come."""
        with self._changed:
            return "\n".join(self.lines)

    def stop(self, number: int = signal.SIGINT, timeout: float = 15.0) -> int:
        """Press Ctrl-C, or send another signal, and return the exit code after the end.

        On Windows, the program is ended without a signal.

        Raises:
            subprocess.TimeoutExpired: The program still runs after `timeout` seconds.
        """
        if self.process.poll() is None:
            self._signal(number)
        return self.wait(timeout)

    def _signal(self, number: int) -> None:
        if sys.platform == "win32":
            self.process.terminate()
        else:
            self.process.send_signal(number)

    def wait(self, timeout: float = 30.0) -> int:
        """Wait for the end and for all output, and return the exit code.

        Raises:
            subprocess.TimeoutExpired: The program still runs after `timeout` seconds.
        """
        code = self.process.wait(timeout)
        if self.process.stdin is not None:
            self.process.stdin.close()
        self._reader.join(timeout)  # a child of the program may keep the pipe open
        return code

    def end(self) -> None:
        """End the program as Ctrl-C does, and kill it if it still runs after 5 s."""
        try:
            self.stop(timeout=_END_S)
        except subprocess.TimeoutExpired:
            self.process.kill()
            self.wait(_END_S)


def _of_this_python(command: Sequence[str]) -> list[str]:
    first, *others = command
    if first in {"zbot", "ros2"}:
        return [*zbot_command(), *others]
    return [sys.executable if first in {"python", "python3"} else first, *others]
