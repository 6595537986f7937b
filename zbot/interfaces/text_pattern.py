"""Patterns of filters for texts: regular expressions, and the patterns of `LIKE`.

Python's `re` tries all ways to match a pattern, one after the other. So `re` can need years for a
text of 40 characters, e.g. with the pattern `(a+)+b`. In this module, the time is proportional to
the length of the text.
"""

from __future__ import annotations

import re
import warnings
from typing import TYPE_CHECKING, NamedTuple

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable

    _States = frozenset[int]

_MAX_PARTS = 2_000  #: parts of a regular expression; `(ab){50}` has 150 parts
_MAX_LEVELS = 50  #: groups inside each other
_MAX_WIDE_RANGES = 30
# A range such as `[a-é]`. Python needs 10 ms for a range up to `\uffff`.
_WIDE_RANGE = re.compile(r"-(?:[^\x00-\x7f]|\\[uUN])")
_MAX_STEPS = 1_000_000  #: steps for one text, about 0.3 s
_MAX_KEPT = 100_000  #: states in the table of known steps, about 10 MB
_CHARACTER = re.compile(
    r"""\\(?: [dDwWsSnrtfva] | x[0-9a-fA-F]{2} | u[0-9a-fA-F]{4} | [^a-zA-Z0-9] )
      | \[\^?\]?(?: \\. | [^\]\\] )*\] | [^\\\[()|*+?^$]""",
    re.VERBOSE | re.DOTALL,
)
_COUNT = re.compile(r"(?:([*+?])|\{(\d+)\}|\{(\d*),(\d*)\})\??")
_GROUP = re.compile(r"\((?:\?:|\?P<\w+>|(?!\?))")


class PatternError(ValueError):
    """A regular expression is not valid, or this module does not support it."""


class _Part(NamedTuple):
    """A part of an expression: one character, or a group of other parts."""

    kind: str  #: `character`, `sequence`, `choice` or `repetition`
    parts: list[_Part]
    accepts: Callable[[str], object] | None = None
    least: int = 0
    most: int | None = None  #: `None` means any number


#: Any characters, also ends of lines.
_REST = _Part("repetition", [_Part("character", [], lambda _: True)])


class _State(NamedTuple):
    """A place in an expression, and the places that follow.

    With `accepts`, the match goes on to these places only with a character that `accepts` allows.
    Without `accepts`, the match goes on without a character.
    """

    accepts: Callable[[str], object] | None
    following: list[int]


class RegularExpression:
    r"""Regular expression for texts. All ways to match are followed at the same time.

    The expression may have characters, `.`, `[a-z]`, classes such as `\d`, groups, `|`, `*`, `+`,
    `?` and `{2,3}`.

    Args:
        pattern: The expression, as Python's `re` writes it.
        is_whole: Whether the expression must match the whole text, as with `re.fullmatch`.
            Otherwise it must match the beginning of the text, as with `re.match`.

    Raises:
        PatternError: The expression is not valid, refers to a group, looks ahead or behind, or is
            too large.
    """

    def __init__(self, pattern: str, *, is_whole: bool = True) -> None:
        if len(_WIDE_RANGE.findall(pattern)) > _MAX_WIDE_RANGES:
            message = f"it has more than {_MAX_WIDE_RANGES} ranges of characters beyond ASCII"
            raise PatternError(message)
        try:
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")  # about regular expressions of later versions
                re.compile(pattern)
                part = _Parser(pattern, is_whole=is_whole).parse()
        except (re.error, RecursionError, OverflowError) as exc:
            raise PatternError(str(exc)) from None
        except PatternError:
            raise
        except ValueError:  # Python converts at most 4,300 digits
            raise PatternError("a number of repetitions has too many digits") from None
        self._states = [_State(None, [])]  # the first one is the end
        self._parts = 0
        self._begin = self._reached([self._add(part, 0)])
        self._known: dict[tuple[_States, str], _States] = {}
        self._kept = 0

    def matches(self, text: str) -> bool:
        """Return whether a text matches. Return False after too many steps."""
        here, steps = self._begin, 0
        for character in text:
            following = self._known.get((here, character))
            if following is None:
                following = self._step(here, character)
                steps += 1 + len(here) + len(following)
            if not following or steps > _MAX_STEPS:
                return False
            here = following
        return 0 in here

    def _step(self, here: _States, character: str) -> _States:
        states, reached = self._states, list[int]()
        for state in here:
            accepts, following = states[state]
            if accepts is not None and accepts(character):
                reached += following
        found = self._reached(reached)
        if self._kept > _MAX_KEPT:
            self._known, self._kept = {}, 0
        self._known[here, character] = found
        self._kept += 1 + len(found)
        return found

    def _reached(self, states: Iterable[int]) -> _States:
        """Return these states and all states that can be reached from them without a character."""
        waiting, found = list(states), set[int]()
        while waiting:
            state = waiting.pop()
            if state not in found:
                found.add(state)
                accepts, following = self._states[state]
                if accepts is None:
                    waiting += following
        return frozenset(found)

    def _new(self, accepts: Callable[[str], object] | None, *following: int) -> int:
        self._states.append(_State(accepts, [*following]))
        return len(self._states) - 1

    def _add(self, part: _Part, following: int) -> int:
        """Add the states of a part, with `following` as the next state. Return the first state."""
        self._parts += 1
        if self._parts > _MAX_PARTS:
            message = f"it has more than {_MAX_PARTS} parts"
            raise PatternError(message)
        if part.kind == "character":
            return self._new(part.accepts, following)
        if part.kind == "choice":
            return self._new(None, *[self._add(inner, following) for inner in part.parts])
        if part.kind == "repetition":
            return self._add_repetition(part, following)
        for inner in reversed(part.parts):
            following = self._add(inner, following)
        return following

    def _add_repetition(self, part: _Part, following: int) -> int:
        (inner,) = part.parts
        first = following
        if part.most is None:
            first = self._new(None, following)
            self._states[first].following.append(self._add(inner, first))
        else:
            for _ in range(part.most - part.least):
                first = self._new(None, following, self._add(inner, first))
        for _ in range(part.least):
            first = self._add(inner, first)
        return first


class _Parser:
    """Reader of regular expressions that `re` has accepted."""

    def __init__(self, pattern: str, *, is_whole: bool) -> None:
        self._pattern = pattern
        self._is_whole = is_whole
        self._place = 0
        self._levels = 0

    def parse(self) -> _Part:
        part = self._choice()
        if self._place < len(self._pattern):
            raise self._unsupported()
        return part

    def _unsupported(self) -> PatternError:
        rest = self._pattern[self._place : self._place + 20]
        return PatternError(
            f"{rest!r} is not supported; use characters, '.', '[a-z]', '( )', '|', '*', '+', '?'"
        )

    def _choice(self) -> _Part:
        parts = [self._sequence()]
        while self._pattern.startswith("|", self._place):
            self._place += 1
            parts.append(self._sequence())
        return parts[0] if len(parts) == 1 else _Part("choice", parts)

    def _sequence(self) -> _Part:
        parts = list[_Part]()
        is_outer = self._levels == 0
        if is_outer:  # `^` and `$` are supported only outside of all groups
            self._skip("^")
        while self._place < len(self._pattern) and self._pattern[self._place] not in "|)$":
            parts.append(self._repetition(self._group() or self._character()))
        if is_outer and not self._skip("$") and not self._is_whole:
            parts.append(_REST)
        return _Part("sequence", parts)

    def _skip(self, sign: str) -> bool:
        is_there = self._pattern.startswith(sign, self._place)
        self._place += is_there
        return is_there

    def _group(self) -> _Part | None:
        found = _GROUP.match(self._pattern, self._place)
        if found is None:
            return None
        self._levels += 1
        if self._levels > _MAX_LEVELS:
            message = f"it has more than {_MAX_LEVELS} groups inside each other"
            raise PatternError(message)
        self._place = found.end()
        part = self._choice()
        if not self._pattern.startswith(")", self._place):
            raise self._unsupported()
        self._place += 1
        self._levels -= 1
        return part

    def _character(self) -> _Part:
        found = _CHARACTER.match(self._pattern, self._place)
        if found is None:
            raise self._unsupported()
        self._place = found.end()
        text = re.escape(found[0]) if found[0] in "{}" else found[0]
        return _Part("character", [], re.compile(text).fullmatch)

    def _repetition(self, part: _Part) -> _Part:
        found = _COUNT.match(self._pattern, self._place)
        if found is None:
            return part
        self._place = found.end()
        if self._pattern.startswith("+", self._place):  # `a*+` matches without going back
            raise self._unsupported()
        sign, exact, least, most = found.groups()
        if sign:
            return _Part("repetition", [part], None, int(sign == "+"), 1 if sign == "?" else None)
        low, high = int(exact or least or 0), int(exact or most or 0)
        if max(low, high) > _MAX_PARTS:
            message = f"it has more than {_MAX_PARTS} parts"
            raise PatternError(message)
        return _Part("repetition", [part], None, low, None if exact is None and not most else high)


def like_expression(pattern: str) -> re.Pattern[str]:
    """Return the regular expression for a pattern of `LIKE`. Use it with `fullmatch`.

    Each text between two `%` or `*` is matched at the first place where it is found. A group
    prevents `re` from trying other places. Without groups, `%a%a%a%a%b` can take years.
    """
    # `re` searches in `(?=...)` only once. `(?P=...)` matches the text that was found there.
    first, *rest = (_single(text) for text in re.split(r"[%*]+", pattern))
    *middle, last = rest or [""]
    words = [f"(?=(?P<part{n}>.*?{text}))(?P=part{n})" for n, text in enumerate(middle)]
    return re.compile("".join([first, *words, ".*" + last if rest else ""]), re.DOTALL)


def _single(text: str) -> str:
    return "".join("." if character in "_?" else re.escape(character) for character in text)
