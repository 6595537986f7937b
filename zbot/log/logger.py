"""Loggers, with which programs write log lines."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING, cast

from zbot.errors import ArgumentTypeError, InvalidNameError
from zbot.log.call_site import CallSite
from zbot.log.record import LoggingSeverity, to_severity
from zbot.log.registry import REGISTRY

if TYPE_CHECKING:
    from types import FrameType

    from typing_extensions import Unpack

    from zbot.log.call_site import FilterOptions, LogOptions

_DEBUG, _INFO, _WARN = LoggingSeverity.DEBUG, LoggingSeverity.INFO, LoggingSeverity.WARN
_ERROR, _FATAL = LoggingSeverity.ERROR, LoggingSeverity.FATAL

_caller = sys._getframe  # noqa: SLF001 - inspect.stack() takes 100 times as long


class Logger:
    """Logger that writes lines under one name. `get_logger` and `Node.get_logger` make loggers.

    The log methods return whether the line was written. They convert the message with `str()`.
    All log methods have these options:

    * `once=True`: only the first call at this place in the source writes a line.
    * `skip_first=True`: every call at this place writes a line, except the first call.
    * `throttle_duration_sec=2.0`: at most one line is written in two seconds. The option
      `throttle_time_source_type` gives the clock. The default is the monotonic clock.
    * `name="other"`: the line has another logger's name.

    A call raises `WrongValueError` if its severity, name or filters differ from the first call
    at the same place. A call raises `WrongTypeError` for an unknown option.

    Args:
        name: The logger's name. Dots separate parents from children.
    """

    def __init__(self, name: str = "") -> None:
        self._state = REGISTRY.state_of(name)
        self._sites: dict[tuple[str, str, int, int], CallSite] = {}

    @property
    def name(self) -> str:
        """The logger's full name."""
        return self._state.name

    def get_child(self, name: str) -> Logger:
        """Return the logger `<this name>.<name>`. It inherits the level of this logger.

        Raises:
            InvalidNameError: The name is empty or missing.
            ArgumentTypeError: The name is not a string.
        """
        _check_name("Child logger name", name)
        return Logger(f"{self.name}.{name}" if self.name else name)

    def set_level(self, level: int) -> None:
        """Set the lowest severity of this logger, and of its children that have no own level.

        Raises:
            InvalidSeverityError: There is no such level.
        """
        REGISTRY.set_logger_level(self.name, level)

    def get_effective_level(self) -> LoggingSeverity:
        """Return the lowest severity that is written: this logger's level or an inherited level."""
        return self._state.threshold

    def is_enabled_for(self, severity: int) -> bool:
        """Return whether lines of a severity are written.

        Raises:
            InvalidSeverityError: There is no such severity.
        """
        return to_severity(severity) >= self._state.threshold

    def debug(self, message: object, **options: Unpack[LogOptions]) -> bool:
        """Write a line for debugging. It is written only if the logger's level is DEBUG."""
        if self._state.threshold > _DEBUG:
            return False
        return self._log(_DEBUG, message, options, _caller(1))

    def info(self, message: object, **options: Unpack[LogOptions]) -> bool:
        """Write a line about normal operation."""
        if self._state.threshold > _INFO:
            return False
        return self._log(_INFO, message, options, _caller(1))

    def warning(self, message: object, **options: Unpack[LogOptions]) -> bool:
        """Write a line about an unusual situation."""
        if self._state.threshold > _WARN:
            return False
        return self._log(_WARN, message, options, _caller(1))

    warn = warning

    def error(self, message: object, **options: Unpack[LogOptions]) -> bool:
        """Write a line about an error."""
        if self._state.threshold > _ERROR:
            return False
        return self._log(_ERROR, message, options, _caller(1))

    def fatal(self, message: object, **options: Unpack[LogOptions]) -> bool:
        """Write a line about an error that ends the program."""
        return self._log(_FATAL, message, options, _caller(1))

    def log(
        self,
        message: object,
        severity: int,
        name: str | None = None,
        **options: Unpack[FilterOptions],
    ) -> bool:
        """Write a line of any severity.

        Raises:
            InvalidSeverityError: There is no such severity.
        """
        level = to_severity(severity)
        if self._state.threshold > level:
            return False
        named = cast("LogOptions", options)
        if name is not None:
            named["name"] = name
        return self._log(level, message, named, _caller(1))

    def _log(
        self, severity: LoggingSeverity, message: object, options: LogOptions, frame: FrameType
    ) -> bool:
        state = self._state
        if options and (name := options.pop("name", None)) is not None:
            state = REGISTRY.state_of(name)
        code = frame.f_code
        # `f_lasti` distinguishes two calls on one line.
        place = (code.co_filename, code.co_name, frame.f_lineno, frame.f_lasti)
        site = self._sites.get(place)
        if site is None:
            site = self._sites.setdefault(place, CallSite(severity, state.name, options))
        else:
            site.check(severity, state.name, options, frame)
        if not site.passes_filters():
            return False
        REGISTRY.emit(state, severity, message, frame)
        return True

    def __repr__(self) -> str:
        return f"Logger({self.name!r})"


def get_logger(name: str) -> Logger:
    """Return a logger with a name.

    Raises:
        InvalidNameError: The name is empty or missing.
        ArgumentTypeError: The name is not a string.
    """
    _check_name("Logger name", name)
    return Logger(name)


_warned: set[str] = set()


def warn_once(text: str) -> None:
    """Log a warning of zbot itself. Each text is logged once in a process."""
    if text not in _warned:
        _warned.add(text)
        get_logger("zbot").warning(text)


def _check_name(kind: str, name: str) -> None:
    if not name:
        raise InvalidNameError(kind.lower(), name or "", f"{kind} must not be empty", 0)
    if not isinstance(name, str):
        raise ArgumentTypeError(kind, "a string", name)
