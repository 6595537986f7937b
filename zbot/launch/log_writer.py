"""Writer of log lines and of processes' output, for the screen and for files."""

from __future__ import annotations

import logging
from functools import cached_property
from pathlib import Path
from typing import Final

from zbot.launch.log import get_logger, launch_config
from zbot.launch.log.handlers import is_coloured, show

#: Colours of the labels. The label of each new process gets the next colour.
_LABEL_COLOURS: Final = ("\x1b[36m", "\x1b[35m", "\x1b[34m", "\x1b[32m", "\x1b[33m")
_RESET: Final = "\x1b[0m"


class LogWriter:
    """Writes lines to the screen and to the files in the folder of the launch.

    Args:
        debug: Whether debug lines are shown.
    """

    def __init__(self, *, debug: bool = False) -> None:
        self._is_debug = debug
        self._colours: dict[str, str] = {}

    @property
    def folder(self) -> Path | None:
        """The folder of the log files. The first use creates it. It is None if that fails."""
        try:
            return Path(launch_config.log_dir)
        except OSError:  # the first log line reports this error
            return None

    @property
    def shows_debug(self) -> bool:
        """Whether debug lines are shown."""
        return self._is_debug or launch_config.level <= logging.DEBUG

    @cached_property
    def is_coloured(self) -> bool:
        """Whether the screen shows colours. See `handlers.is_coloured`."""
        return is_coloured()

    def debug(self, logger: str, text: str) -> None:
        """Write a line at level DEBUG. The screen shows it only with `--debug`."""
        self.log("DEBUG", logger, text)

    def info(self, logger: str, text: str) -> None:
        """Write a line at level INFO."""
        self.log("INFO", logger, text)

    def warning(self, logger: str, text: str) -> None:
        """Write a line at level WARNING."""
        self.log("WARNING", logger, text)

    def error(self, logger: str, text: str) -> None:
        """Write a line at level ERROR."""
        self.log("ERROR", logger, text)

    def log(self, level: str, name: str, text: str) -> None:
        """Write a line to screen and file if its level is shown.

        The file also gets all debug lines.
        """
        logger, number = get_logger(name), int(getattr(logging, level))
        record = logger.makeRecord(name, number, "", 0, text, (), None)
        if logger.isEnabledFor(number) or (number == logging.DEBUG and self.shows_debug):
            logger.handle(record)
        elif number == logging.DEBUG:
            launch_config.get_log_file_handler(launch_config.log_file_name).handle(record)

    def output(self, label: str, line: str) -> None:
        """Show an output line of a process on the screen."""
        if self.is_coloured and line.startswith(f"[{label}]"):
            colour = self._colours.setdefault(
                label, _LABEL_COLOURS[len(self._colours) % len(_LABEL_COLOURS)]
            )
            line = f"{colour}[{label}]{_RESET}{line[len(label) + 2 :]}"
        show(line)

    def close(self) -> None:
        """Close the files. A later line opens its file again."""
        launch_config.close()
