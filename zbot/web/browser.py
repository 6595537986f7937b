"""Showing the page to whoever sits in front of the machine, if anybody does."""

from __future__ import annotations

import os
import sys
import threading
import webbrowser


def has_desktop() -> bool:
    """Return whether a browser can open a window here, and nobody said that it should not.

    `$ZBOT_NO_BROWSER` says so; so does a login over SSH, where it would open on the other side.
    """
    if os.environ.get("ZBOT_NO_BROWSER") or os.environ.get("SSH_CONNECTION"):
        return False
    if sys.platform in {"win32", "darwin"}:
        return True
    return bool(os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY"))


def open_page(address: str) -> None:
    """Open an address in the user's browser, without waiting for it."""
    # Some browsers keep their starter busy until they are closed.
    threading.Thread(
        target=webbrowser.open, args=(address,), name="zbot browser", daemon=True
    ).start()
