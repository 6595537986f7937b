"""Suggestions of similar names, for a name that does not exist."""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Iterable

_NUMBERS = re.compile(r"\d+")
_SHORTEST_ABBREVIATION = 2
_MOST_EDITS = 2
_LEAST_SIMILARITY = 0.75  #: of `difflib`, from 0 to 1


def did_you_mean(name: str, known: Iterable[str], *, before: str = "", count: int = 1) -> str:
    """Return `did you mean 'a'?`, or an empty string if no known name is similar.

    Args:
        name: The name that does not exist.
        known: The names that exist.
        before: Text in front of the question, e.g. `; `.
        count: The largest number of suggestions.
    """
    return question(similar_names(name, known, count), before)


def correction(name: str, known: Iterable[str]) -> str:
    """Return `did you mean 'a'?` if a name is a known name with a typo, or an empty string."""
    near = nearest(name, known)
    return question([near]) if near else ""


def question(suggestions: Iterable[str], before: str = "") -> str:
    """Return `did you mean 'a' or 'b'?`, or an empty string if there are no suggestions."""
    text = " or ".join(f"'{suggestion}'" for suggestion in suggestions)
    return f"{before}did you mean {text}?" if text else ""


def similar_names(name: str, known: Iterable[str], count: int = 1) -> tuple[str, ...]:
    """Return at most `count` of the known names that can be meant by `name`, best first.

    Names that differ by a typo (see `nearest`) come first. If there are none, the result has longer
    and shorter names, such as `arguments` for `arg` and `/bot/scan` for `/scan`. If there are none,
    it has names with mostly the same characters. It never contains the name itself.
    """
    by_lower = _by_lower(name, known)
    typos = KnownNames(by_lower.values()).typos(name)
    if typos:
        return tuple(typos[:count])
    typed = name.lower()
    found = _other_lengths(typed, by_lower)
    if not found:
        from difflib import get_close_matches  # noqa: PLC0415 - takes 3 ms, needed only after an error

        found = get_close_matches(typed, by_lower, count, _LEAST_SIMILARITY)
    return tuple(by_lower[lowered] for lowered in found[:count])


def nearest(name: str, known: Iterable[str], most_edits: int = _MOST_EDITS) -> str | None:
    """Return the known name that is most similar to a mistyped `name`, or None if none is similar.

    A similar name needs at most 1 edit if `name` has 3 to 5 characters, and at most `most_edits` if
    it has more. Slashes, and upper and lower case, do not count. A swap of two neighbours, as in
    `topci`, is one edit. Names that differ only in their numbers (`/robot1/scan`, `/robot2/scan`)
    are not similar. If many names are compared with the same known names, `KnownNames` is faster.
    """
    return KnownNames(known).nearest(name, most_edits)


class KnownNames:
    """Names that exist, prepared for the comparison with many mistyped names.

    Args:
        names: The names.
    """

    def __init__(self, names: Iterable[str]) -> None:
        # A domain with a hundred robots has a hundred topics of each pattern.
        self._patterns: dict[str, _Pattern] = {}
        for name in names:
            pattern = _pattern(name)
            if pattern not in self._patterns:
                self._patterns[pattern] = _Pattern(_letters(pattern))
            self._patterns[pattern].names.append((name, name.lower(), _letters(name)))

    def nearest(self, name: str, most_edits: int = _MOST_EDITS) -> str | None:
        """Return what the function `nearest` returns for these names."""
        for edits in range(_limit(name, most_edits) + 1):  # names with few edits are found faster
            if found := self._within(name, edits):
                return found[0]
        return None

    def typos(self, name: str) -> list[str]:
        """Return the known names of which `name` may be a typo (see `nearest`), best first."""
        return self._within(name, _limit(name, _MOST_EDITS))

    def _within(self, name: str, edits: int) -> list[str]:
        pattern, lowered, letters = _pattern(name), name.lower(), _letters(name)
        pattern_letters = _letters(pattern)
        scored = [
            # Of two names with as many edits, the one with the right first letter is meant. `Nod`
            # means `Node` and not `node`, if both exist.
            (
                distance,
                known[:1] != lowered[:1],
                known,
                text[:1].isupper() != name[:1].isupper(),
                text,
            )
            for other, alike in self._patterns.items()
            if other != pattern and _may_be_near(pattern_letters, alike.letters, edits)
            for text, known, known_letters in alike.names
            if abs(len(known) - len(lowered)) <= edits
            and _may_be_near(letters, known_letters, edits)
            and (distance := _edit_distance(lowered, known, edits)) <= edits
        ]
        return [text for *_, text in sorted(scored)]


@dataclass(frozen=True, slots=True)
class _Pattern:
    """Names that differ only in their numbers."""

    letters: frozenset[str]
    names: list[tuple[str, str, frozenset[str]]] = field(default_factory=list)


def _limit(name: str, most_edits: int) -> int:
    return min(most_edits, len(name.replace("/", "")) // 3)


def _letters(name: str) -> frozenset[str]:
    return frozenset(name.lower())


def _may_be_near(a: frozenset[str], b: frozenset[str], edits: int) -> bool:
    """Return whether names with these letters may need so few edits: each edit changes one."""
    return len(a - b) <= edits and len(b - a) <= edits


def _pattern(name: str) -> str:
    return _NUMBERS.sub("0", name)


def _by_lower(name: str, known: Iterable[str]) -> dict[str, str]:
    pattern = _pattern(name)
    names = [candidate for candidate in known if _pattern(candidate) != pattern]
    # `Nod` means `Node` and not `node`, if both exist.
    names.sort(key=lambda candidate: candidate[:1].isupper() == name[:1].isupper())
    return {candidate.lower(): candidate for candidate in names}


def _other_lengths(name: str, known: Iterable[str]) -> list[str]:
    bare = name.strip("/")
    if len(bare) < _SHORTEST_ABBREVIATION:
        return []
    found = [
        candidate
        for candidate in known
        if candidate.startswith(name)
        or candidate.endswith(f"/{bare}")
        or (len(candidate.strip("/")) >= _SHORTEST_ABBREVIATION and name.startswith(candidate))
        or name.endswith(f"/{candidate.strip('/')}")
    ]
    return sorted(found, key=lambda candidate: (abs(len(candidate) - len(name)), candidate))


def _edit_distance(a: str, b: str, limit: int) -> int:
    """Return the number of edits from a to b. Return `limit + 1` for more than `limit` edits.

    An edit inserts, removes or replaces a character, or swaps two neighbours.
    """
    above: list[int] = []
    row = list(range(len(b) + 1))
    for i, left in enumerate(a, 1):
        following = [i] + [limit + 1] * len(b)
        for j in range(max(1, i - limit), min(len(b), i + limit) + 1):  # the others cost too much
            right = b[j - 1]
            cost = row[j - 1] if left == right else 1 + min(row[j], following[j - 1], row[j - 1])
            if above and j > 1 and left == b[j - 2] and right == a[i - 2]:
                cost = min(cost, above[j - 2] + 1)
            following[j] = cost
        if min(*row, *following) > limit:
            return limit + 1
        above, row = row, following
    return row[-1]
