"""Handlers of log lines that can have a form of their own for each logger.

Every handler of Python's `logging` and `logging.handlers` is here by its name, with
`setFormatterFor()`.
"""

from __future__ import annotations

import functools
import logging
import logging.handlers
import os
import sys
from typing import TYPE_CHECKING, Any, Final, TextIO

if TYPE_CHECKING:
    from pathlib import Path

_LEVEL_COLOURS: Final = {logging.WARNING: "\x1b[33m", logging.ERROR: "\x1b[31m"}
_RESET: Final = "\x1b[0m"


class _FormPerLogger:
    """What is added to a handler."""

    def __init__(self, *args: Any, **options: Any) -> None:
        super().__init__(*args, **options)
        self._forms: dict[str, logging.Formatter] = {}

    # Named as `launch.logging` names them.
    def setFormatterFor(  # noqa: N802
        self, logger: logging.Logger | str, formatter: logging.Formatter
    ) -> None:
        """Give the lines of one logger a form of their own."""
        self._forms[_name(logger)] = formatter

    def unsetFormatterFor(self, logger: logging.Logger | str) -> None:  # noqa: N802
        """Give the lines of one logger the form of all others."""
        self._forms.pop(_name(logger), None)

    def format(self, record: logging.LogRecord) -> str:
        """Return a line in its logger's form."""
        own = self._forms.get(record.name)
        if own is not None:
            return own.format(record)
        text: str = super().format(record)  # type: ignore[misc] # the handler's
        return text


def _name(logger: logging.Logger | str) -> str:
    return logger if isinstance(logger, str) else logger.name


if TYPE_CHECKING:
    _StreamHandler = logging.StreamHandler[TextIO]
else:
    _StreamHandler = logging.StreamHandler  # no generic class before Python 3.11


class ScreenHandler(_FormPerLogger, _StreamHandler):
    """Writes to what is stdout now, as tests and programs replace it; warnings are coloured."""

    def emit(self, record: logging.LogRecord) -> None:
        """Write a line."""
        line = self.format(record)
        colour = _LEVEL_COLOURS.get(record.levelno, "") if is_coloured() else ""
        show(f"{colour}{line}{_RESET}" if colour else line)


class LogFileHandler(_FormPerLogger, logging.FileHandler):
    """Appends to a file that is made for the first line; a full disk is told once."""

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
            self._give_up(error)

    def handleError(self, record: logging.LogRecord) -> None:  # noqa: N802
        """Tell what went wrong with a line."""
        error = sys.exc_info()[1]
        if isinstance(error, OSError):
            self._give_up(error)
        else:
            super().handleError(record)

    def _give_up(self, error: OSError) -> None:
        self._is_broken = True
        show(f"[WARNING] [launch]: cannot write to {self.baseFilename}: {error.strerror}")


def show(line: str) -> None:
    """Write a line to the screen."""
    # The launch goes on when nobody reads any more (`| head`): its end is not the reader's.
    try:
        print(line, flush=True)
    except (OSError, ValueError):
        return


def is_coloured() -> bool:
    """Return whether the screen is a terminal that nobody wants without colour."""
    if os.environ.get("NO_COLOR") or os.environ.get("RCUTILS_COLORIZED_OUTPUT") == "0":
        return False
    if os.environ.get("FORCE_COLOR") or os.environ.get("RCUTILS_COLORIZED_OUTPUT") == "1":
        return True
    try:
        return sys.stdout is not None and sys.stdout.isatty()
    except ValueError:  # closed
        return False


@functools.cache
def __getattr__(name: str) -> type[logging.Handler]:
    for module in (logging, logging.handlers):
        found = getattr(module, name, None)
        if isinstance(found, type) and issubclass(found, logging.Handler):
            return type(name, (_FormPerLogger, found), {"__doc__": found.__doc__})
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
