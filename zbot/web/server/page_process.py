"""Process that serves the page until the program that started it ends.

The program runs `python -m zbot.web.server.page_process PATH`.
"""

from __future__ import annotations

import importlib.util
import os
import signal
import socket
import sys
import webbrowser

from zbot.observer.serving.child_process import ChildProcess, end_with_parent

_PATIENCE_S = 30.0
# If several page processes start together, only the process that can bind a certain port serves the
# page. The port's number is this number plus the domain's meeting port, which is the local port
# where programs of the domain find each other.
_ABOVE_MEETING_PORT = 2000


def is_installed() -> bool:
    """Return whether the extra `web` is installed."""
    return all(importlib.util.find_spec(name) is not None for name in ("nicegui", "psutil"))


class PageProcess(ChildProcess):
    """Process that serves the page and opens it in the user's browser, until `close`.

    Args:
        path: The path of the page to open, e.g. `/turtle?node=/turtlesim`.
    """

    def __init__(self, path: str) -> None:
        super().__init__(__name__, path)


def main() -> None:
    """Serve the page until standard input closes.

    If another process serves the page already, only open that page in the browser.
    """
    from zbot.process.signals import install  # noqa: PLC0415 - only in the page process
    from zbot.web.server.server import serve  # noqa: PLC0415 - as above

    end_with_parent()
    path = sys.argv[1]
    with socket.socket() as arbiter:
        if _is_first(arbiter):
            install(calls_ok=False)
            serve(open_browser=True, start_path=path)
        else:
            _show_others(path)


def _is_first(arbiter: socket.socket) -> bool:
    """Return whether this process is the domain's first page process on this machine."""
    from zbot.transport.config import MEETING_PORT, domain_id  # noqa: PLC0415 - only in the page process

    try:
        arbiter.bind(("127.0.0.1", MEETING_PORT + _ABOVE_MEETING_PORT + domain_id()))
        arbiter.listen()
    except PermissionError:
        return True  # the system reserves the port, so no other process has it either
    except OSError:
        return False
    return True


def _show_others(path: str) -> None:
    """Wait for the page that another process is starting, and open it."""
    signal.signal(signal.SIGINT, signal.SIG_DFL)  # no traceback: the program reports Ctrl-C
    from zbot.context import Context  # noqa: PLC0415 - only in the page process
    from zbot.node.node import Node  # noqa: PLC0415 - as above
    from zbot.web.server.page_discovery import TOPIC, running_page  # noqa: PLC0415 - as above

    context = Context()
    context.init([])
    node = Node(f"_zbot_page_{os.getpid()}", context=context, enable_rosout=False)
    context.graph.wait_for(lambda graph: bool(graph.publishers(TOPIC)), _PATIENCE_S)
    address = running_page(node)
    context.shutdown()
    if address is not None:
        webbrowser.open(address + path)


if __name__ == "__main__":
    main()
