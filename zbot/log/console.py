"""Console output of log lines, in colour on a terminal."""

from __future__ import annotations

import os
import sys
from typing import TYPE_CHECKING, Final, TextIO

from zbot.log.record import LoggingSeverity, formatter
from zbot.text.terminal import escape_control_characters, write_styled

if TYPE_CHECKING:
    from collections.abc import Mapping

_RESET: Final = "\x1b[0m"
#: ROS 2's colours: green, none, yellow, red, red
_COLOURS: Final[Mapping[int, str]] = {
    LoggingSeverity.DEBUG: "\x1b[32m",
    LoggingSeverity.INFO: _RESET,
    LoggingSeverity.WARN: "\x1b[33m",
    LoggingSeverity.ERROR: "\x1b[31m",
    LoggingSeverity.FATAL: "\x1b[31m",
}


class Console:
    """Writer of log lines to stderr. With `RCUTILS_LOGGING_USE_STDOUT=1` it writes to stdout.

    The constructor reads the environment variables. `write` ignores errors of the stream, because a
    program must not end if nobody reads its log.
    """

    def __init__(self) -> None:
        self.setting_errors: list[str] = []  #: errors in the environment variables
        self.format = formatter(
            os.environ.get("RCUTILS_CONSOLE_OUTPUT_FORMAT", "")
        )  #: function from a record to a line
        self._uses_stdout = self._switch("RCUTILS_LOGGING_USE_STDOUT") is True
        self._is_buffered = self._switch("RCUTILS_LOGGING_BUFFERED_STREAM") is True
        self._colour = self._colour_setting()
        self._stream: TextIO | None = None
        self._is_coloured = self._is_terminal = False

    def write(self, severity: LoggingSeverity, line: str) -> None:
        """Write a line in its severity's colour.

        A line may contain text that came over the network. So the control characters of the line
        are escaped if the stream is a terminal. Colour codes are kept, because programs use them in
        their lines.
        """
        # The stream is looked up each time, because programs and tests replace sys.stderr.
        stream = sys.stdout if self._uses_stdout else sys.stderr
        if stream is not self._stream:
            self._stream, self._is_terminal = stream, _is_terminal(stream)
            self._is_coloured = _has_colour(stream) if self._colour is None else self._colour
        if self._is_terminal:
            line = escape_control_characters(line, keep_colours=True)
        if self._is_coloured:
            line = f"{_COLOURS[severity]}{line}{_RESET}"
        _write_safely(stream, f"{line}\n", flush=not self._is_buffered)

    def _switch(self, variable: str) -> bool | None:
        value = os.environ.get(variable, "")
        if value not in {"", "0", "1"}:
            self.setting_errors.append(f"{variable} is {value!r}: use 0 or 1")
            return None
        return value == "1" if value else None

    def _colour_setting(self) -> bool | None:
        """Return whether the environment asks for colour. `None` means that the stream decides."""
        setting = self._switch("RCUTILS_COLORIZED_OUTPUT")
        if setting is None and os.environ.get("NO_COLOR"):
            setting = False
        if setting is None and os.environ.get("FORCE_COLOR"):
            setting = True
        return setting


def _write_safely(stream: TextIO | None, text: str, *, flush: bool) -> None:
    """Write a text in one call, so that the lines of threads and processes do not mix."""
    if stream is None:  # pythonw on Windows has no console
        return
    try:
        try:
            write_styled(stream, text)
        except UnicodeEncodeError:
            encoding = stream.encoding or "ascii"
            write_styled(stream, text.encode(encoding, "backslashreplace").decode(encoding))
        except RuntimeError:
            # A signal handler logs while it interrupts a write to the same stream.
            os.write(stream.fileno(), text.encode(errors="backslashreplace"))
        if flush:
            stream.flush()
    except (OSError, ValueError, RuntimeError):
        # The stream is closed or its reader has ended, so the error cannot be reported.
        return


def _is_terminal(stream: TextIO | None) -> bool:
    try:
        return stream is not None and stream.isatty()
    except ValueError:  # the stream is closed
        return False


def _has_colour(stream: TextIO | None) -> bool:
    return stream is not None and _is_terminal(stream) and _enable_colour(stream)


def _enable_colour(stream: TextIO) -> bool:
    """Enable escape sequences in a Windows console. Return whether the terminal has them."""
    if sys.platform != "win32":
        return True
    import ctypes  # noqa: PLC0415 - only Windows needs it
    import msvcrt  # noqa: PLC0415 - only Windows has it

    kernel32 = ctypes.windll.kernel32
    handle = msvcrt.get_osfhandle(stream.fileno())
    mode = ctypes.c_ulong()
    if not kernel32.GetConsoleMode(handle, ctypes.byref(mode)):
        return False
    virtual_terminal = 0x0004  # ENABLE_VIRTUAL_TERMINAL_PROCESSING
    return bool(kernel32.SetConsoleMode(handle, mode.value | virtual_terminal))
