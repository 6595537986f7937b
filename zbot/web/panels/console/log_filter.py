"""Filter for log lines, and the number of lines of each level."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Iterable

    from zbot.observer.log_ring import LogLine

#: Levels of rcl_interfaces/msg/Log, with their names.
LEVELS = {10: "Debug", 20: "Info", 30: "Warn", 40: "Error", 50: "Fatal"}


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
