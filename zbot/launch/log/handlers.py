"""Log handlers that can use a separate format for each logger.

The module contains every handler of Python's `logging` and `logging.handlers`. Each handler has its
usual name, and the additional method `setFormatterFor()`.
"""

from __future__ import annotations

import functools
import logging
import logging.handlers
import os
import sys
from typing import TYPE_CHECKING, Any, Final, TextIO

from zbot.text.terminal import escape_control_characters

if TYPE_CHECKING:
    from pathlib import Path

_LEVEL_COLOURS: Final = {logging.WARNING: "\x1b[33m", logging.ERROR: "\x1b[31m"}
_RESET: Final = "\x1b[0m"


class _FormatterPerLogger:
    """Mixin for handlers that adds formatters for single loggers."""

    def __init__(self, *args: Any, **options: Any) -> None:
        super().__init__(*args, **options)
        self._formatters: dict[str, logging.Formatter] = {}

    # `launch.logging` has the same names of methods.
    def setFormatterFor(  # noqa: N802
        self, logger: logging.Logger | str, formatter: logging.Formatter
    ) -> None:
        """Set the formatter for the lines of one logger."""
        self._formatters[_name(logger)] = formatter

    def unsetFormatterFor(self, logger: logging.Logger | str) -> None:  # noqa: N802
        """Remove the formatter of one logger. Its lines get the common format again."""
        self._formatters.pop(_name(logger), None)

    def format(self, record: logging.LogRecord) -> str:
        own = self._formatters.get(record.name)
        if own is not None:
            return own.format(record)
        text: str = super().format(record)  # type: ignore[misc] # super() is a handler
        return text


def _name(logger: logging.Logger | str) -> str:
    return logger if isinstance(logger, str) else logger.name


if TYPE_CHECKING:
    _StreamHandler = logging.StreamHandler[TextIO]
else:
    _StreamHandler = logging.StreamHandler  # not generic before Python 3.11


class ScreenHandler(_FormatterPerLogger, _StreamHandler):
    """Writes each line to the current `sys.stdout`. Warnings and errors are coloured."""

    def emit(self, record: logging.LogRecord) -> None:
        """Write a line."""
        line = self.format(record)
        colour = _LEVEL_COLOURS.get(record.levelno, "") if is_coloured() else ""
        show(line, colour)


class LogFileHandler(_FormatterPerLogger, logging.FileHandler):
    """Appends lines to a file, and warns once if the file is not writable.

    The first line creates the file.
    """

    def __init__(self, path: str | Path, encoding: str = "utf-8") -> None:
        super().__init__(path, encoding=encoding, delay=True, errors="backslashreplace")
        self._is_broken = False

    def emit(self, record: logging.LogRecord) -> None:
        """Write a line."""
        if self._is_broken:
            return
        try:
            super().emit(record)
        except OSError as error:  # the file cannot be opened
            self._disable(error)

    def handleError(self, record: logging.LogRecord) -> None:  # noqa: N802
        """Warn once about an OSError. Other errors go to Python's `handleError`."""
        error = sys.exc_info()[1]
        if isinstance(error, OSError):
            self._disable(error)
        else:
            super().handleError(record)

    def _disable(self, error: OSError) -> None:
        self._is_broken = True
        show(f"[WARNING] [launch]: cannot write to {self.baseFilename}: {error.strerror}")


def show(line: str, colour: str = "") -> None:
    """Write a line to the screen, in a colour if one is given.

    A terminal gets the line's colours, and its carriage returns, because progress bars use them.
    Other control characters are escaped, because the text may have come over the network.
    """
    # Ignore errors, because the launch continues when the reader of stdout has exited, as with
    # `| head`.
    try:
        if _is_terminal():
            parts = (
                escape_control_characters(part, keep_colours=True) for part in line.split("\r")
            )
            line = "\r".join(parts)
        print(f"{colour}{line}{_RESET}" if colour else line, flush=True)
    except (OSError, ValueError):
        return


def is_coloured() -> bool:
    """Return whether to use colours.

    The environment variables for colours decide. If none is set, only a terminal gets colours.
    """
    if os.environ.get("NO_COLOR") or os.environ.get("RCUTILS_COLORIZED_OUTPUT") == "0":
        return False
    if os.environ.get("FORCE_COLOR") or os.environ.get("RCUTILS_COLORIZED_OUTPUT") == "1":
        return True
    try:
        return _is_terminal()
    except ValueError:  # stdout is closed
        return False


def _is_terminal() -> bool:
    return sys.stdout is not None and sys.stdout.isatty()


@functools.cache
def __getattr__(name: str) -> type[logging.Handler]:
    for module in (logging, logging.handlers):
        found = getattr(module, name, None)
        if isinstance(found, type) and issubclass(found, logging.Handler):
            return type(name, (_FormatterPerLogger, found), {"__doc__": found.__doc__})
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
