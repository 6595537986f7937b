"""A page beside a program: `python -m zbot.web.companion PATH` serves it until that program ends.

The program holds the other end of its standard input, which closes however the program ends.
"""

from __future__ import annotations

import importlib.util
import os
import signal
import subprocess
import sys
import threading
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from typing_extensions import Self

_GOODBYE_S = 5.0


def is_installed() -> bool:
    """Return whether the extra `web` is."""
    return all(importlib.util.find_spec(name) is not None for name in ("nicegui", "psutil"))


class Companion:
    """A process that serves the page, opened in the user's browser, until it is closed.

    Args:
        path: What to show first: `/turtle?node=/turtlesim`.
    """

    def __init__(self, path: str) -> None:
        words = [sys.executable, "-m", __name__, path]
        self._process = subprocess.Popen(words, stdin=subprocess.PIPE)  # noqa: S603 - as just made

    def close(self) -> None:
        """End it; may be called twice."""
        if self._process.stdin is not None:
            self._process.stdin.close()
        try:
            self._process.wait(_GOODBYE_S)
        except subprocess.TimeoutExpired:
            self._process.kill()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()


def main() -> None:
    """Serve until standard input closes."""
    from zbot.signals import SignalHandlerOptions, install  # noqa: PLC0415 - only in that process
    from zbot.web.server import serve  # noqa: PLC0415 - as above

    install(SignalHandlerOptions.ALL)
    threading.Thread(target=_end_with_input, name="zbot companion", daemon=True).start()
    serve(open_browser=True, start_path=sys.argv[1])


def _end_with_input() -> None:
    while sys.stdin.buffer.read(1):
        continue
    if sys.platform == "win32":
        os._exit(0)  # no signal reaches one's own process there
    os.kill(os.getpid(), signal.SIGTERM)


if __name__ == "__main__":
    main()
