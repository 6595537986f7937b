"""Which log lines a reader wants to see, and how many there are of each level."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Iterable

    from zbot.web.log_ring import LogLine

#: Levels of rcl_interfaces/msg/Log, with the words that stand for them.
LEVELS = {10: "Debug", 20: "Info", 30: "Warn", 40: "Error", 50: "Fatal"}


def level_of(line: LogLine) -> int:
    """Return the level of a line, one of `LEVELS`: programs may use any number up to 255."""
    return min(max(line.level // 10 * 10, 10), 50)


@dataclass(frozen=True, slots=True)
class LogFilter:
    """What a line has to be."""

    level: int = 10  #: at least
    logger: str = ""  #: this one, or one below it; any if empty
    text: str = ""  #: which the line or its logger contains, in any case

    def matches(self, line: LogLine) -> bool:
        """Return whether a line is wanted."""
        if line.level < self.level:
            return False
        if self.logger and line.name != self.logger and not line.name.startswith(f"{self.logger}."):
            return False
        wanted = self.text.lower()
        return not wanted or wanted in line.text.lower() or wanted in line.name.lower()

    @property
    def condition(self) -> str:
        """The same for `zbot topic echo --filter`; empty if every line is wanted."""
        parts = []
        if self.level > min(LEVELS):
            parts.append(f"m.level >= {self.level}")
        if self.logger:
            parts.append(f"m.name == {self.logger!r}")
        if self.text:
            parts.append(f"{self.text.lower()!r} in m.msg.lower()")
        return " and ".join(parts)


def counts(lines: Iterable[LogLine]) -> Counter[int]:
    """Return how many lines there are of each level."""
    return Counter(map(level_of, lines))
