"""How serious a log line is."""

from __future__ import annotations

from enum import IntEnum

from zbot.log.errors import InvalidSeverityError


class LoggingSeverity(IntEnum):
    """A log line's level, and the least level that a logger lets through."""

    UNSET = 0  #: for a logger: its parent's level
    DEBUG = 10
    INFO = 20
    WARN = 30
    ERROR = 40
    FATAL = 50


def to_severity(value: int) -> LoggingSeverity:
    """Return the severity that a number stands for.

    Raises:
        InvalidSeverityError: It stands for none.
    """
    try:
        return LoggingSeverity(value)
    except ValueError:
        raise InvalidSeverityError(value) from None


def get_logging_severity_from_string(log_severity: str) -> LoggingSeverity:
    """Return the severity of a name such as `warn`, in capitals or not.

    Raises:
        InvalidSeverityError: No severity has that name.
    """
    try:
        return LoggingSeverity[log_severity.upper()]
    except (KeyError, AttributeError):
        raise InvalidSeverityError(log_severity) from None
