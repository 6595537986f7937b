"""Log records, and the formatter that converts a record to text."""

from __future__ import annotations

import re
from datetime import datetime
from enum import IntEnum
from operator import attrgetter
from typing import TYPE_CHECKING, Final, NamedTuple

from zbot.log.errors import InvalidSeverityError

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping

    _Getter = Callable[["Record"], object]

DEFAULT_FORMAT: Final = "[{severity}] [{time}] [{name}]: {message}"


class LoggingSeverity(IntEnum):
    """Severity of a log line. The level of a logger is the lowest severity that it writes."""

    UNSET = 0  #: a logger with this level has the level of its parent
    DEBUG = 10
    INFO = 20
    WARN = 30
    ERROR = 40
    FATAL = 50


_NAMES: Final[Mapping[int, str]] = {severity: severity.name for severity in LoggingSeverity}
_TOKEN = re.compile(r"\{(\w+)\}")
_ESCAPE = re.compile(r"\\(x1b|[abnrt])")
_ESCAPED = {"a": "\a", "b": "\b", "n": "\n", "r": "\r", "t": "\t", "x1b": "\x1b"}


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


class Record(NamedTuple):
    """One log line."""

    stamp_ns: int  #: system time, nanoseconds since the epoch
    level: LoggingSeverity
    name: str  #: name of the logger
    message: str  #: one or several lines; UTF-8 can encode them
    file: str  #: path of the source file with the log call
    function: str
    line: int  #: number of the line in `file`, from 1


def formatter(template: str) -> Callable[[Record], str]:
    """Return a function that formats records by a template like `RCUTILS_CONSOLE_OUTPUT_FORMAT`.

    Unknown `{tokens}` are kept as text. An empty template means `DEFAULT_FORMAT`.
    """
    text = _ESCAPE.sub(lambda match: _ESCAPED[match[1]], template or DEFAULT_FORMAT)
    pattern, end = "", 0
    getters: list[_Getter] = []
    for match in _TOKEN.finditer(text):
        if match[1] in _GETTERS:
            pattern += _literal(text[end : match.start()]) + "%s"
            getters.append(_GETTERS[match[1]])
            end = match.end()
    pattern += _literal(text[end:])
    return lambda record: pattern % tuple([getter(record) for getter in getters])


def _literal(text: str) -> str:
    return text.replace("%", "%%")


def _seconds(record: Record) -> str:
    seconds, nanoseconds = divmod(record.stamp_ns, 1_000_000_000)
    return f"{seconds}.{nanoseconds:09}"


def _date_time(record: Record) -> str:
    moment = datetime.fromtimestamp(record.stamp_ns // 1_000_000_000).astimezone()
    return f"{moment:%Y-%m-%d %H:%M:%S}.{record.stamp_ns // 1_000_000 % 1000:03}"


_GETTERS: Final[Mapping[str, _Getter]] = {
    "severity": lambda record: _NAMES[record.level],
    "time": _seconds,
    "time_as_nanoseconds": attrgetter("stamp_ns"),
    "name": attrgetter("name"),
    "message": attrgetter("message"),
    "function_name": attrgetter("function"),
    "file_name": attrgetter("file"),
    "line_number": attrgetter("line"),
    "date_time_with_ms": _date_time,
}
