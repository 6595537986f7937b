"""Suggestions of similar names, for a name that does not exist."""

from __future__ import annotations

import re
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
    typed = name.lower()
    found = _typos(typed, by_lower) or _other_lengths(typed, by_lower)
    if not found:
        from difflib import get_close_matches  # noqa: PLC0415 - takes 3 ms, needed only after an error

        found = get_close_matches(typed, by_lower, count, _LEAST_SIMILARITY)
    return tuple(by_lower[lowered] for lowered in found[:count])


def nearest(name: str, known: Iterable[str], most_edits: int = _MOST_EDITS) -> str | None:
    """Return the known name that is most similar to a mistyped `name`, or None if none is similar.

    A similar name needs at most 1 edit if `name` has 3 to 5 characters, and at most `most_edits` if
    it has more. Slashes, and upper and lower case, do not count. A swap of two neighbours, as in
    `topci`, is one edit. Names that differ only in their numbers (`/robot1/scan`, `/robot2/scan`)
    are not similar.
    """
    by_lower = _by_lower(name, known)
    found = _typos(name.lower(), by_lower, most_edits)
    return by_lower[found[0]] if found else None


def _by_lower(name: str, known: Iterable[str]) -> dict[str, str]:
    pattern = _NUMBERS.sub("0", name)
    names = [candidate for candidate in known if _NUMBERS.sub("0", candidate) != pattern]
    # `Nod` means `Node` and not `node`, if both exist.
    names.sort(key=lambda candidate: candidate[:1].isupper() == name[:1].isupper())
    return {candidate.lower(): candidate for candidate in names}


def _typos(name: str, known: Iterable[str], most_edits: int = _MOST_EDITS) -> list[str]:
    limit = min(most_edits, len(name.replace("/", "")) // 3)
    scored = (
        (_edit_distance(name, candidate, limit), candidate)
        for candidate in known
        if abs(len(candidate) - len(name)) <= limit
    )
    return [candidate for distance, candidate in sorted(scored) if distance <= limit]


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
        following = [i]
        for j, right in enumerate(b, 1):
            cost = row[j - 1] if left == right else 1 + min(row[j], following[-1], row[j - 1])
            if above and j > 1 and left == b[j - 2] and right == a[i - 2]:
                cost = min(cost, above[j - 2] + 1)
            following.append(cost)
        if min(*row, *following) > limit:
            return limit + 1
        above, row = row, following
    return row[-1]
