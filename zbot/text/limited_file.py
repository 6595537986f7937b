"""Reader of files of others, whose size has a limit."""

from __future__ import annotations

import errno
import stat
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from pathlib import Path


def read_limited(path: Path, most_bytes: int) -> bytes:
    """Return the bytes of a file, or only its first bytes if it is too large.

    Args:
        path: The file.
        most_bytes: The limit. If the result is longer, the file is too large.

    Raises:
        OSError: The file cannot be read, or is a device or a pipe, which may have no end.
        ValueError: The path is not valid.
    """
    mode = path.stat().st_mode
    if not stat.S_ISREG(mode) and not stat.S_ISDIR(mode):
        raise OSError(errno.EINVAL, "it is a device or a pipe")
    with path.open("rb") as file:
        return file.read(most_bytes + 1)
