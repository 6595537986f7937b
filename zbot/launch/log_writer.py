"""Writer of log lines and of processes' output, for the screen and for files."""

from __future__ import annotations

import codecs
import logging
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Final

from zbot.launch.log import get_logger, get_output_loggers, launch_config
from zbot.launch.log.handlers import is_coloured, show

if TYPE_CHECKING:
    from collections.abc import Mapping

#: Colours of the labels. The label of each new process gets the next colour.
_LABEL_COLOURS: Final = ("\x1b[36m", "\x1b[35m", "\x1b[34m", "\x1b[32m", "\x1b[33m")
_RESET: Final = "\x1b[0m"
_STREAMS: Final = {1: "stdout", 2: "stderr"}


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


class OutputLines:
    """Splits the output of a process into lines and writes them to screen and log files."""

    def __init__(
        self, label: str, sinks: Mapping[str, frozenset[str]], writer: LogWriter, line_format: str
    ) -> None:
        self._label, self._writer, self._line_format = label, writer, line_format
        seen = [fd for fd, stream in _STREAMS.items() if "screen" in sinks[stream] | sinks["both"]]
        self._on_screen = frozenset(seen)
        # The screen is handled separately, because only the screen shows labels in colour.
        files = {stream: chosen - {"screen"} for stream, chosen in sinks.items()}
        loggers = get_output_loggers(label, files, launch_config.log_file_name)
        self._loggers = dict(zip(_STREAMS, loggers, strict=True))
        decoder = codecs.getincrementaldecoder("utf-8")
        self._decoders = {fd: decoder("backslashreplace") for fd in _STREAMS}
        #: The parts of a line that has no newline yet. To join them each time would take too long.
        self._rest: dict[int, list[str]] = {fd: [] for fd in _STREAMS}

    def feed(self, fd: int, data: bytes) -> None:
        """Add output of stdout (1) or stderr (2). Complete lines are written immediately."""
        first, *others = self._decoders[fd].decode(data).split("\n")
        self._rest[fd].append(first)
        for text in others:
            line = "".join(self._rest[fd])
            self._rest[fd] = [text]
            self._write(fd, line.rstrip("\r"))

    def close(self) -> None:
        """Write the last line of each stream, if this line has no newline yet."""
        for fd in _STREAMS:
            rest = "".join(self._rest[fd]) + self._decoders[fd].decode(b"", final=True)
            self._rest[fd] = []
            if rest:
                self._write(fd, rest)

    def _write(self, fd: int, line: str) -> None:
        logger, formed = self._loggers[fd], self._line_format.format(line=line, label=self._label)
        if fd in self._on_screen and logger.isEnabledFor(logging.INFO):
            self._writer.output(self._label, formed)
        logger.info(formed)
