"""Folder of a launch's log files, and the link `latest` to it."""

from __future__ import annotations

import os
import socket
import time
from pathlib import Path


def make_unique_log_dir(*, base_path: str) -> str:
    """Create a folder for one launch, and return the path of the folder.

    Raises:
        OSError: The folder cannot be created.
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
            continue  # another launch created it in the same microsecond
        return str(folder)


def renew_latest_log_dir(*, log_dir: str) -> bool:
    """Set the link `latest` to a folder, and return whether this succeeded.

    The link is next to the folder.
    """
    folder = Path(log_dir)
    latest = folder.parent / "latest"
    try:
        if latest.is_symlink():
            latest.unlink()
        latest.symlink_to(folder.name)
    except OSError:
        # This is not an error: Windows may forbid links, and another launch may replace the link.
        return False
    return True
