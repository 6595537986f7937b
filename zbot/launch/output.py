"""Splitter of a process's output into lines, for the screen and the log files."""

from __future__ import annotations

import codecs
import logging
from typing import TYPE_CHECKING, Final

from zbot.launch.log import get_output_loggers, launch_config

if TYPE_CHECKING:
    from collections.abc import Mapping

    from zbot.launch.log_writer import LogWriter

_STREAMS: Final = {1: "stdout", 2: "stderr"}


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
        self._rest = dict.fromkeys(_STREAMS, "")

    def feed(self, fd: int, data: bytes) -> None:
        """Add output of stdout (1) or stderr (2). Complete lines are written immediately."""
        text = self._rest[fd] + self._decoders[fd].decode(data)
        *lines, self._rest[fd] = text.split("\n")
        for line in lines:
            self._write(fd, line.rstrip("\r"))

    def close(self) -> None:
        """Write the last line of each stream, if this line has no newline yet."""
        for fd in _STREAMS:
            rest = self._rest[fd] + self._decoders[fd].decode(b"", final=True)
            self._rest[fd] = ""
            if rest:
                self._write(fd, rest)

    def _write(self, fd: int, line: str) -> None:
        logger, formed = self._loggers[fd], self._line_format.format(line=line, label=self._label)
        if fd in self._on_screen and logger.isEnabledFor(logging.INFO):
            self._writer.output(self._label, formed)
        logger.info(formed)
