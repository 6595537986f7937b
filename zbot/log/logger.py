"""What a program logs with."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING, cast

from zbot.errors import ArgumentTypeError, InvalidNameError
from zbot.log.call_site import CallSite
from zbot.log.registry import HUB
from zbot.log.severity import LoggingSeverity, to_severity

if TYPE_CHECKING:
    from types import FrameType

    from typing_extensions import Unpack

    from zbot.log.call_site import FilterOptions, LogOptions

_DEBUG, _INFO, _WARN = LoggingSeverity.DEBUG, LoggingSeverity.INFO, LoggingSeverity.WARN
_ERROR, _FATAL = LoggingSeverity.ERROR, LoggingSeverity.FATAL

_caller = sys._getframe  # noqa: SLF001 - inspect's way to the frame takes 100 times as long


class Logger:
    """Writes log lines under one name. Made by `get_logger` or `Node.get_logger`.

    The methods return whether the line was written. A message of any type is written as `str()`
    writes it. All take these options:

    * `once=True`: only the first call at this place in the source writes.
    * `skip_first=True`: all but the first call write.
    * `throttle_duration_sec=2.0`: at most one line in two seconds, on the monotonic clock or on
      the one given as `throttle_time_source_type`.
    * `name="other"`: writes under another logger's name.

    A call whose severity, name or filters differ from what the same place asked for before raises
    `LogCallChangedError`; an unknown option raises `LogOptionError`.

    Args:
        name: The logger's name; dots separate parents from children.
    """

    def __init__(self, name: str = "") -> None:
        self._channel = HUB.channel(name)
        self._sites: dict[tuple[str, str, int, int], CallSite] = {}

    @property
    def name(self) -> str:
        """The logger's full name."""
        return self._channel.name

    def get_child(self, name: str) -> Logger:
        """Return the logger `<this name>.<name>`, which inherits this one's level.

        Raises:
            InvalidNameError: The name is empty or missing.
            ArgumentTypeError: The name is no string.
        """
        _check_name("Child logger name", name)
        return Logger(f"{self.name}.{name}" if self.name else name)

    def set_level(self, level: int) -> None:
        """Set the least severity that this logger and its children write.

        Raises:
            InvalidSeverityError: There is no such level.
        """
        HUB.set_logger_level(self.name, level)

    def get_effective_level(self) -> LoggingSeverity:
        """Return the least severity that is written: the logger's own or its nearest parent's."""
        return self._channel.threshold

    def is_enabled_for(self, severity: int) -> bool:
        """Return whether lines of a severity are written.

        Raises:
            InvalidSeverityError: There is no such severity.
        """
        return to_severity(severity) >= self._channel.threshold

    def debug(self, message: object, **options: Unpack[LogOptions]) -> bool:
        """Write a line that helps to find a mistake; switched off unless the level is DEBUG."""
        if self._channel.threshold > _DEBUG:
            return False
        return self._log(_DEBUG, message, options, _caller(1))

    def info(self, message: object, **options: Unpack[LogOptions]) -> bool:
        """Write a line about what goes on."""
        if self._channel.threshold > _INFO:
            return False
        return self._log(_INFO, message, options, _caller(1))

    def warning(self, message: object, **options: Unpack[LogOptions]) -> bool:
        """Write a line about something unusual."""
        if self._channel.threshold > _WARN:
            return False
        return self._log(_WARN, message, options, _caller(1))

    warn = warning

    def error(self, message: object, **options: Unpack[LogOptions]) -> bool:
        """Write a line about something that went wrong."""
        if self._channel.threshold > _ERROR:
            return False
        return self._log(_ERROR, message, options, _caller(1))

    def fatal(self, message: object, **options: Unpack[LogOptions]) -> bool:
        """Write a line about something that ends the program."""
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
        if self._channel.threshold > level:
            return False
        named = cast("LogOptions", options)
        if name is not None:
            named["name"] = name
        return self._log(level, message, named, _caller(1))

    def _log(
        self, severity: LoggingSeverity, message: object, options: LogOptions, frame: FrameType
    ) -> bool:
        channel = self._channel
        if options and (name := options.pop("name", None)) is not None:
            channel = HUB.channel(name)
        code = frame.f_code
        # The last instruction tells two calls on one line apart.
        place = (code.co_filename, code.co_name, frame.f_lineno, frame.f_lasti)
        site = self._sites.get(place)
        if site is None:
            site = self._sites.setdefault(place, CallSite(severity, channel.name, options))
        else:
            site.check(severity, channel.name, options, frame)
        if not site.admit():
            return False
        HUB.emit(channel, severity, message, frame)
        return True

    def __repr__(self) -> str:
        return f"Logger({self.name!r})"


def get_logger(name: str) -> Logger:
    """Return a logger of that name.

    Raises:
        InvalidNameError: The name is empty or missing.
        ArgumentTypeError: The name is no string.
    """
    _check_name("Logger name", name)
    return Logger(name)


def _check_name(kind: str, name: str) -> None:
    if not name:
        raise InvalidNameError(kind.lower(), name or "", f"{kind} must not be empty", 0)
    if not isinstance(name, str):
        raise ArgumentTypeError(kind, "a string", name)
