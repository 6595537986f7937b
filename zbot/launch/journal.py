"""Where a launch and its processes write: the screen, and files in a folder of its own."""

from __future__ import annotations

import os
import socket
import sys
import time
from functools import cached_property
from typing import TYPE_CHECKING, Any, Final

from zbot.log.log_file import get_logging_directory

if TYPE_CHECKING:
    from pathlib import Path
    from typing import TextIO

_LEVEL_COLOURS: Final = {"WARNING": "\x1b[33m", "ERROR": "\x1b[31m"}
#: Each process gets the next one for its label.
_LABEL_COLOURS: Final = ("\x1b[36m", "\x1b[35m", "\x1b[34m", "\x1b[32m", "\x1b[33m")
_RESET: Final = "\x1b[0m"


class Journal:
    """Writes lines to the screen and to files.

    Args:
        debug: Whether debug lines are shown.
    """

    def __init__(self, *, debug: bool = False) -> None:
        self.shows_debug = debug
        self._files: dict[str, TextIO] = {}
        self._colours: dict[str, str] = {}
        self._has_files = True

    @cached_property
    def folder(self) -> Path:
        """The folder of the log files, made when it is first asked for."""
        stamp = time.time()
        day = time.strftime("%Y-%m-%d-%H-%M-%S", time.localtime(stamp))
        name = f"{day}-{int(stamp % 1 * 1e6):06}-{socket.gethostname()}-{os.getpid()}"
        folder = get_logging_directory() / name
        try:
            folder.mkdir(parents=True, exist_ok=True)
        except OSError as error:
            self._has_files = False
            self._show(f"[WARNING] [launch]: cannot write log files to {folder}: {error.strerror}")
            return folder
        self._link_latest(folder)
        return folder

    def _link_latest(self, folder: Path) -> None:
        latest = folder.parent / "latest"
        try:
            if latest.is_symlink():
                latest.unlink()
            latest.symlink_to(folder.name)
        except OSError:
            # A convenience: Windows allows no links, and another launch may have made its own.
            return

    def debug(self, logger: str, text: str) -> None:
        """Write a line that only `--debug` shows."""
        self.log("DEBUG", logger, text, to_screen=self.shows_debug)

    def info(self, logger: str, text: str) -> None:
        """Write what happens."""
        self.log("INFO", logger, text)

    def warning(self, logger: str, text: str) -> None:
        """Write what may be wrong."""
        self.log("WARNING", logger, text)

    def error(self, logger: str, text: str) -> None:
        """Write what is wrong."""
        self.log("ERROR", logger, text)

    def log(self, level: str, logger: str, text: str, *, to_screen: bool = True) -> None:
        """Write a line in ROS 2's form."""
        line = f"[{level}] [{logger}]: {text}"
        if to_screen:
            colour = _LEVEL_COLOURS.get(level, "") if self.is_coloured else ""
            self._show(f"{colour}{line}{_RESET}" if colour else line)
        self.write("launch.log", f"{time.time():.7f} {line}")

    def output(self, label: str, line: str) -> None:
        """Show a line of a process."""
        if self.is_coloured and line.startswith(f"[{label}]"):
            colour = self._colours.setdefault(
                label, _LABEL_COLOURS[len(self._colours) % len(_LABEL_COLOURS)]
            )
            line = f"{colour}[{label}]{_RESET}{line[len(label) + 2 :]}"
        self._show(line)

    def write(self, name: str, line: str) -> None:
        """Append a line to a file of the folder."""
        folder = self.folder
        if not self._has_files:
            return
        try:
            file = self._files.get(name)
            if file is None:
                file = self._files[name] = (folder / name).open("a", encoding="utf-8", buffering=1)
            file.write(f"{line}\n")
        except OSError as error:  # e.g. the disk is full
            self._has_files = False
            self._show(f"[WARNING] [launch]: cannot write to {folder / name}: {error.strerror}")

    def close(self) -> None:
        """Close the files; lines that come later open them again."""
        while self._files:
            self._files.popitem()[1].close()

    @cached_property
    def is_coloured(self) -> bool:
        """Whether the screen is a terminal that nobody wants without colour."""
        if os.environ.get("NO_COLOR") or os.environ.get("RCUTILS_COLORIZED_OUTPUT") == "0":
            return False
        if os.environ.get("FORCE_COLOR") or os.environ.get("RCUTILS_COLORIZED_OUTPUT") == "1":
            return True
        return _is_terminal(sys.stdout)

    def _show(self, line: str) -> None:
        # The launch goes on when nobody reads any more (`| head`): its end is not the reader's.
        try:
            print(line, flush=True)
        except (OSError, ValueError):
            return


def _is_terminal(stream: Any) -> bool:
    try:
        return stream is not None and bool(stream.isatty())
    except ValueError:  # closed
        return False
