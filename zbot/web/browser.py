"""Browser of the machine's user: whether one can be opened, and opening a page in it."""

from __future__ import annotations

import os
import sys
import threading
import webbrowser


def has_desktop() -> bool:
    """Return whether a browser can open a window for the user.

    It cannot with `$ZBOT_NO_BROWSER`, and in a login over SSH, as the user is at another machine.
    """
    if os.environ.get("ZBOT_NO_BROWSER") or os.environ.get("SSH_CONNECTION"):
        return False
    if sys.platform in {"win32", "darwin"}:
        return True
    return bool(os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY"))


def open_page(address: str) -> None:
    """Open an address in the user's browser, and return at once."""
    # With some browsers, `webbrowser.open` returns only when the browser is closed.
    threading.Thread(
        target=webbrowser.open, args=(address,), name="zbot browser", daemon=True
    ).start()
