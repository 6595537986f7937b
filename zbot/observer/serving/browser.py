"""Browser of the machine's user, which opens pages if the machine has a desktop."""

from __future__ import annotations

import os
import sys
import threading
import webbrowser


def has_desktop() -> bool:
    """Return whether a browser can open a window for the user.

    It returns False if `$ZBOT_NO_BROWSER` is set. It also returns False in a login over SSH,
    because the user is at another machine.
    """
    if os.environ.get("ZBOT_NO_BROWSER") or os.environ.get("SSH_CONNECTION"):
        return False
    if sys.platform in {"win32", "darwin"}:
        return True
    return bool(os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY"))


def open_page(address: str) -> None:
    """Open an address in the user's browser, without waiting for the browser."""
    # With some browsers, `webbrowser.open` returns only when the browser is closed.
    threading.Thread(
        target=webbrowser.open, args=(address,), name="zbot browser", daemon=True
    ).start()
