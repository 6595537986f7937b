"""Process that serves the 3D view until the program that started it ends.

The program runs `python -m zbot.view.server.view_process`.
"""

from __future__ import annotations

import contextlib
import sys
from typing import TYPE_CHECKING

from zbot.observer.serving.child_process import ChildProcess, end_with_parent

if TYPE_CHECKING:
    from contextlib import AbstractContextManager


class ViewProcess(ChildProcess):
    """Process that serves the view and opens it in the user's browser, until `close`."""

    def __init__(self) -> None:
        super().__init__(__name__)


def view_if_installed() -> AbstractContextManager[object]:
    """Return a `with` block in which the 3D view is served. Without its extra, print a sentence."""
    from zbot.observer.errors import ViewerError  # noqa: PLC0415 - not in the process of the view
    from zbot.view.server.viser_server import check_extra  # noqa: PLC0415 - as above

    try:
        check_extra()
    except ViewerError as error:
        print(f"no 3D view: {error}", file=sys.stderr)
        return contextlib.nullcontext()
    return ViewProcess()


def main() -> None:
    """Serve the view until standard input closes."""
    from zbot.observer.serving.browser import has_desktop  # noqa: PLC0415 - as above
    from zbot.process.signals import install  # noqa: PLC0415 - only in this process
    from zbot.view.server.server import DEFAULT_PORT, serve  # noqa: PLC0415 - as above

    end_with_parent()
    install(calls_ok=False)
    serve(port=DEFAULT_PORT, open_browser=has_desktop())


if __name__ == "__main__":
    main()
