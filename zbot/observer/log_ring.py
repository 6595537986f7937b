"""Ring buffer of the last log lines of all nodes.

Each line has a number, and readers ask for the lines after a number. Any program may publish log
lines, so the buffer also limits the sizes of the lines.
"""

from __future__ import annotations

import threading
from collections import Counter, deque
from dataclasses import dataclass
from itertools import islice
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Iterable

#: Usually enough for a lesson, but 1000 lines a second fill the buffer in 10 s.
CAPACITY = 10_000
_MOST_CHARACTERS = 10_000_000  #: of all lines; a usual line has 200
_LONGEST_TEXT = 10_000
_LONGEST_NAME = 250
#: Levels of rcl_interfaces/msg/Log, with their names.
LEVELS = {10: "Debug", 20: "Info", 30: "Warn", 40: "Error", 50: "Fatal"}


@dataclass(frozen=True, slots=True)
class LogLine:
    """One line of `/rosout`."""

    number: int  #: starts at 1 and has no gaps
    stamp_ns: int  #: nanoseconds since the epoch
    level: int  #: 10 debug, 20 info, 30 warn, 40 error, 50 fatal
    name: str  #: the name of the logger
    text: str
    file: str
    function: str
    line: int

    @property
    def characters(self) -> int:
        """The number of characters in its texts."""
        return sum(map(len, (self.name, self.text, self.file, self.function)))


class LogRing:
    """Ring buffer of log lines. All methods may be called from any thread.

    Args:
        capacity: The number of lines that are kept.
    """

    def __init__(self, capacity: int = CAPACITY) -> None:
        self._capacity = capacity
        self._lines: deque[LogLine] = deque()
        self._lock = threading.Lock()
        self._last = 0
        self._characters = 0

    @property
    def last(self) -> int:
        """The number of the newest line. It is 0 before the first line."""
        return self._last

    def add(self, message: Any) -> None:
        """Add a `rcl_interfaces/msg/Log`."""
        with self._lock:
            self._last += 1
            self._lines.append(_line(self._last, message))
            self._characters += self._lines[-1].characters
            while len(self._lines) > self._capacity or self._characters > _MOST_CHARACTERS:
                self._characters -= self._lines.popleft().characters

    def since(self, number: int) -> list[LogLine]:
        """Return the kept lines after a number. The oldest line is the first."""
        with self._lock:
            new = min(self._last - number, len(self._lines))
            return list(islice(self._lines, len(self._lines) - new, None)) if new > 0 else []


def _line(number: int, log: Any) -> LogLine:
    return LogLine(
        number,
        log.stamp.sec * 10**9 + log.stamp.nanosec,
        int(log.level),
        _shortened(log.name, _LONGEST_NAME),
        _shortened(log.msg, _LONGEST_TEXT),
        _shortened(log.file, _LONGEST_NAME),
        _shortened(log.function, _LONGEST_NAME),
        log.line,
    )


def _shortened(text: str, longest: int) -> str:
    return text if len(text) <= longest else f"{text[: longest - 1]}…"


def level_of(line: LogLine) -> int:
    """Return a key of `LEVELS`: the line's level, rounded down, but at least 10."""
    return min(max(line.level // 10 * 10, 10), 50)


@dataclass(frozen=True, slots=True)
class LogFilter:
    """Filter for log lines."""

    level: int = 10  #: the lowest level
    logger: str = ""  #: the logger, including its children; empty for all loggers
    text: str = ""  #: a part of the line or of its logger's name, in upper or lower case

    def matches(self, line: LogLine) -> bool:
        """Return whether a line passes the filter."""
        if line.level < self.level:
            return False
        if self.logger and line.name != self.logger and not line.name.startswith(f"{self.logger}."):
            return False
        wanted = self.text.lower()
        return not wanted or wanted in line.text.lower() or wanted in line.name.lower()

    @property
    def condition(self) -> str:
        """The condition for `zbot topic echo --filter`. It is empty if all lines pass."""
        parts = []
        if self.level > min(LEVELS):
            parts.append(f"m.level >= {self.level}")
        if self.logger:
            parts.append(f"m.name == {self.logger!r}")
        if self.text:
            parts.append(f"{self.text.lower()!r} in m.msg.lower()")
        return " and ".join(parts)


def counts(lines: Iterable[LogLine]) -> Counter[int]:
    """Return the number of lines of each level."""
    return Counter(map(level_of, lines))


def newest(lines: list[LogLine], most_characters: int) -> list[LogLine]:
    """Return the last lines, which have at most `most_characters` characters together.

    The newest line is returned even if it is longer.
    """
    begin = len(lines)
    while begin and (begin == len(lines) or most_characters >= lines[begin - 1].characters):
        begin -= 1
        most_characters -= lines[begin].characters
    return lines[begin:]
