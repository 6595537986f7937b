"""Log lines in a file of their own for each process, where a log folder is set."""

from __future__ import annotations

import os
import sys
import threading
import time
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from io import FileIO


def get_logging_directory() -> Path:
    """Return the folder for log files, which need not exist.

    That is the first of `$ZBOT_LOG_DIR`, `$ROS_LOG_DIR`, `$ROS_HOME/log` and `~/.ros/log`.
    """
    wanted = _wanted_directory()
    if wanted is not None:
        return wanted
    home = os.environ.get("ROS_HOME")
    return (Path(home) if home else Path("~/.ros")).expanduser() / "log"


class LogFile:
    """Appends lines to `<folder>/<program>_<pid>_<milliseconds>.log`, made for the first one.

    Args:
        prefix: What the file's name begins with; the program's name if empty.
    """

    def __init__(self, prefix: str = "") -> None:
        self._prefix = prefix
        self._directory = _wanted_directory()
        self._file: FileIO | None = None
        self._lock = threading.RLock()  # re-entrant, for a signal's handler may log
        self.is_open = self._directory is not None  #: whether lines are wanted, and still possible

    def write(self, line: str) -> None:
        """Append a line, in one piece.

        Raises:
            OSError: It cannot be written; the file is closed for good.
        """
        with self._lock:
            if self._directory is None or not self.is_open:
                return
            try:
                self._file = self._file or self._open_in(self._directory)
                self._file.write(f"{line}\n".encode(errors="backslashreplace"))
            except OSError:
                self.close()
                raise

    def close(self) -> None:
        """Write no more lines; may be called twice."""
        with self._lock:
            self.is_open = False
            file, self._file = self._file, None
            if file is not None:
                file.close()

    def _open_in(self, directory: Path) -> FileIO:
        directory.mkdir(parents=True, exist_ok=True)
        program = self._prefix or Path(sys.argv[0]).stem or "python"
        name = f"{program}_{os.getpid()}_{time.time_ns() // 1_000_000}.log"
        return (directory / name).open("ab", buffering=0)


def _wanted_directory() -> Path | None:
    """Return the folder that somebody asked for, or `None`."""
    wanted = os.environ.get("ZBOT_LOG_DIR") or os.environ.get("ROS_LOG_DIR")
    return Path(wanted).expanduser() if wanted else None
