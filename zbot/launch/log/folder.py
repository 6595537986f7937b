"""The folder of a launch's log files."""

from __future__ import annotations

import os
import socket
import time
from pathlib import Path


def make_unique_log_dir(*, base_path: str) -> str:
    """Make a folder that no other launch writes to, and return it.

    Raises:
        OSError: It cannot be made.
    """
    while True:
        stamp = time.time()
        day = time.strftime("%Y-%m-%d-%H-%M-%S", time.localtime(stamp))
        name = f"{day}-{int(stamp % 1 * 1e6):06}-{socket.gethostname()}-{os.getpid()}"
        folder = Path(base_path) / name
        folder.parent.mkdir(parents=True, exist_ok=True)
        try:
            folder.mkdir()
        except FileExistsError:
            continue  # made in the same microsecond
        return str(folder)


def renew_latest_log_dir(*, log_dir: str) -> bool:
    """Let `latest` beside a folder lead to it; return whether it does."""
    folder = Path(log_dir)
    latest = folder.parent / "latest"
    try:
        if latest.is_symlink():
            latest.unlink()
        latest.symlink_to(folder.name)
    except OSError:
        # A convenience: Windows allows no links, and another launch may have made its own.
        return False
    return True
