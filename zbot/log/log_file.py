"""Log file of a process. It is written only if a log folder is set."""

from __future__ import annotations

import os
import sys
import threading
import time
from pathlib import Path
from typing import TYPE_CHECKING

from zbot.package.user_folders import home_folder

if TYPE_CHECKING:
    from io import FileIO


def get_logging_directory() -> Path:
    """Return the folder for log files. The folder may be missing.

    The folder is `$ZBOT_LOG_DIR`, else `$ROS_LOG_DIR`, else `$ROS_HOME/log`, else `~/.ros/log`.
    """
    wanted = _wanted_directory()
    if wanted is not None:
        return wanted
    home = os.environ.get("ROS_HOME")
    return (Path(home).expanduser() if home else home_folder() / ".ros") / "log"


class LogFile:
    """Log file `<folder>/<program>_<pid>_<milliseconds>.log`. The first log line creates it.

    Args:
        prefix: Replaces the program's name in the file's name, if the prefix is not empty.
    """

    def __init__(self, prefix: str = "") -> None:
        self._prefix = prefix
        self._directory = _wanted_directory()
        self._file: FileIO | None = None
        self._lock = threading.RLock()  # re-entrant, because a signal handler may log
        self.is_open = self._directory is not None  #: whether lines are written

    def renew_lock(self) -> None:
        """In a forked child, replace the lock, which a thread of the parent may hold."""
        self._lock = threading.RLock()

    def write(self, line: str) -> None:
        """Append a line in one write.

        Raises:
            OSError: The line cannot be written. The file is then closed permanently.
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
        """Close the file and ignore all later lines. A second call has no effect."""
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
    """Return the folder from an environment variable. Return `None` if no variable is set."""
    wanted = os.environ.get("ZBOT_LOG_DIR") or os.environ.get("ROS_LOG_DIR")
    return Path(wanted).expanduser() if wanted else None
