"""Severities of log lines."""

from __future__ import annotations

from enum import IntEnum

from zbot.log.errors import InvalidSeverityError


class LoggingSeverity(IntEnum):
    """Severity of a log line. The level of a logger is the lowest severity that it writes."""

    UNSET = 0  #: a logger with this level has the level of its parent
    DEBUG = 10
    INFO = 20
    WARN = 30
    ERROR = 40
    FATAL = 50


def to_severity(value: int) -> LoggingSeverity:
    """Return the severity whose number is `value`.

    Raises:
        InvalidSeverityError: No severity has that number.
    """
    try:
        return LoggingSeverity(value)
    except ValueError:
        raise InvalidSeverityError(value) from None


def get_logging_severity_from_string(log_severity: str) -> LoggingSeverity:
    """Return the severity with a name such as `warn`, in upper or lower case.

    Raises:
        InvalidSeverityError: No severity has that name.
    """
    try:
        return LoggingSeverity[log_severity.upper()]
    except (KeyError, AttributeError):
        raise InvalidSeverityError(log_severity) from None
