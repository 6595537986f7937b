"""Process that serves the view to the live page, until the page's process ends.

The page runs `python -m zbot.view.server.embedded_view HOST PAGE_PORT [--read-only]`.
"""

from __future__ import annotations

import contextlib
import signal
import sys
import threading
from urllib.parse import parse_qs, urlsplit

from zbot.errors import ZbotError
from zbot.observer.errors import ViewerError
from zbot.observer.serving.address import TOKEN_PARAMETER
from zbot.observer.serving.child_process import ChildProcess, end_with_parent
from zbot.transport.config import COMMAND_DOMAIN

_ADDRESS = "zbot view: "
_ERROR = "error: "
_READ_ONLY = "--read-only"


class EmbeddedView(ChildProcess):
    """Process that serves the view.

    Args:
        host: The host that the live page listens on. The view listens on it too.
        page_port: The port of the live page.
        read_only: Whether the view can only show the system.
        domain: The domain that the view shows.
    """

    def __init__(self, host: str, page_port: int, *, read_only: bool, domain: int) -> None:
        words = [host, str(page_port), *([_READ_ONLY] if read_only else [])]
        variables = {COMMAND_DOMAIN: str(domain)}
        super().__init__(__name__, *words, variables=variables, has_output=True)

    def address(self) -> tuple[int, str]:
        """Wait until the view can be opened. Return its port and its token.

        Raises:
            ViewerError: The process has ended, e.g. because no session can be opened.
        """
        reason = "its process has ended"
        for line in self.output:
            text = line.decode("utf-8", "replace").strip()
            if text.startswith(_ADDRESS):
                threading.Thread(target=self._drain, name="zbot view output", daemon=True).start()
                return _parts(text.removeprefix(_ADDRESS))
            reason = text.removeprefix(_ERROR) if text.startswith(_ERROR) else reason
        raise ViewerError(f"the 3D view cannot start: {reason}")

    def _drain(self) -> None:
        with contextlib.suppress(ValueError, OSError):  # the pipe is closed
            for _ in self.output:
                continue


def _parts(address: str) -> tuple[int, str]:
    parts = urlsplit(address)
    return parts.port or 0, parse_qs(parts.query)[TOKEN_PARAMETER][0]


def main() -> None:
    """Serve the view until standard input closes. Print why if that is not possible."""
    from zbot.view.server.server import Content, bytes_per_s, serve  # noqa: PLC0415 - only in the process of the view

    end_with_parent(signal.SIGINT)
    host, page_port = sys.argv[1:3]
    try:
        content = Content(bytes_per_s=bytes_per_s(host, None), read_only=_READ_ONLY in sys.argv)
        serve(host, 0, page_port=int(page_port), content=content)
    except KeyboardInterrupt:
        return
    except ZbotError as error:
        print(f"{_ERROR}{error}", flush=True)


if __name__ == "__main__":
    main()
