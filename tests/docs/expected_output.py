"""Documented output of a command. What differs from run to run may differ from the page too."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Sequence

_ANY = (re.compile(re.escape("...")), ".*?")
#: What differs in each run: times, measured numbers, ids of goals, the columns of a table.
_VARIES = [
    (re.compile(r"-?\d+\.\d{2,}(?:e[-+]\d+)?"), r"-?\d+(?:\.\d+)?(?:e[-+]\d+)?"),
    (re.compile(r"\b[0-9a-f]{32}\b"), r"[0-9a-f]{32}"),
    (re.compile(" {2,}"), " +"),
]
#: In the output of a program that goes on, also counts and numbers of processes.
_COUNT = (re.compile(r"\d+"), r"\d+")


#: Lines that no page shows, because they come only on a busy machine.
_ON_BUSY_MACHINE = re.compile(
    r"\d+ messages? lost: they come faster than the callback takes them"
    r"|no message on \S+ yet; its publisher is"
)


class ExpectedOutput:
    """Output of a command on a page.

    Args:
        lines: The documented lines. `...` stands for any text of a line, or for any lines.
        is_endless: The program goes on: more may come after the documented lines.
    """

    def __init__(self, lines: Sequence[str], *, is_endless: bool = False) -> None:
        self.is_endless = is_endless
        varies = [_ANY, *_VARIES, *([_COUNT] if is_endless else [])]
        #: Lines that follow each other. Between two sections, there may be any lines.
        self.sections: list[list[re.Pattern[str]]] = [[]]
        for line in _without_blank_end(lines):
            if line.strip() == "...":
                self.sections.append([])
            else:
                self.sections[-1].append(re.compile(_fragment(line.rstrip(), varies)))

    def matches(self, output: str) -> bool:
        """Return whether an output is what the page says."""
        lines = [line.rstrip() for line in output.split("\n") if not _ON_BUSY_MACHINE.search(line)]
        # The last line of a program that goes on may still be incomplete.
        lines = lines[:-1] if self.is_endless else _without_blank_end(lines)
        first, *others = self.sections
        if not _is_at(first, lines, 0) or not (others or self.is_endless):
            return not others and len(lines) == len(first) and _is_at(first, lines, 0)
        place = len(first)
        for section in others:
            end = len(lines) - len(section)
            is_last = section is others[-1] and not self.is_endless
            places = range(max(place, end) if is_last else place, end + 1)
            found = next(
                (candidate for candidate in places if _is_at(section, lines, candidate)), None
            )
            if found is None:
                return False
            place = found + len(section)
        return True


def _without_blank_end(lines: Sequence[str]) -> list[str]:
    kept = list(lines)
    while kept and not kept[-1].strip():
        kept.pop()
    return kept


def _is_at(section: Sequence[re.Pattern[str]], lines: Sequence[str], place: int) -> bool:
    there = lines[place : place + len(section)]
    return len(there) == len(section) and all(
        wanted.fullmatch(line) for wanted, line in zip(section, there, strict=True)
    )


def _fragment(text: str, varies: Sequence[tuple[re.Pattern[str], str]]) -> str:
    """Return a pattern of a text: each match of the first item is replaced, then of the others."""
    if not varies:
        return re.escape(text)
    (matched, replacement), *others = varies
    return replacement.join(_fragment(piece, others) for piece in matched.split(text))
