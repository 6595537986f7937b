"""Process that serves something until the program that started it ends.

The standard input of the process is a pipe from the program. The pipe closes when the program ends,
also if the program is killed.
"""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import threading
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Mapping

    from typing_extensions import Self

_CLOSE_TIMEOUT_S = 5.0


class ChildProcess:
    """Process that runs a module of zbot until `close`. The module calls `end_with_parent`.

    Args:
        module: The name of the module.
        words: The words of its command line.
        variables: Environment variables of the process, in addition to those of this program.
        has_output: Whether `output` has the standard output of the process. Otherwise the process
            writes to the standard output of this program.
    """

    def __init__(
        self,
        module: str,
        *words: str,
        variables: Mapping[str, str] | None = None,
        has_output: bool = False,
    ) -> None:
        self._process: subprocess.Popen[Any] = subprocess.Popen(  # noqa: S603 - our own words
            [sys.executable, "-m", module, *words],
            env={**os.environ, **(variables or {})},
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE if has_output else None,
            **_without_ctrl_c(),
        )

    @property
    def output(self) -> Any:
        """The lines of the standard output, as bytes."""
        return self._process.stdout

    @property
    def is_running(self) -> bool:
        """Whether the process has not ended yet."""
        return self._process.poll() is None

    def close(self) -> None:
        """End the process. A second call does nothing."""
        if self._process.stdin is not None:
            self._process.stdin.close()
        try:
            self._process.wait(_CLOSE_TIMEOUT_S)
        except subprocess.TimeoutExpired:
            self._process.kill()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()


def _without_ctrl_c() -> dict[str, Any]:
    """Return the options for a process that Ctrl-C in the terminal does not reach.

    Ctrl-C reaches the program, which then closes the process. Otherwise the process would print a
    traceback if it still imported its modules.
    """
    if sys.platform == "win32":
        return {"creationflags": subprocess.CREATE_NEW_PROCESS_GROUP}
    return {"start_new_session": True}


def end_with_parent(number: int = signal.SIGTERM) -> None:
    """From now on, end this process by a signal when the program that started it ends."""
    threading.Thread(
        target=_end_with_input, args=(number,), name="zbot child input", daemon=True
    ).start()


def _end_with_input(number: int) -> None:
    while sys.stdin.buffer.read(1):
        continue
    if sys.platform == "win32":
        os._exit(0)  # on Windows, os.kill would end the process with an error code
    os.kill(os.getpid(), number)
