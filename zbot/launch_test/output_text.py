"""Whether a text has what a test expects: a text, a pattern, or several in their order."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, Any

from zbot.errors import ArgumentTypeError

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

# Colours and cursor movements (ECMA-48, 5.4), and titles of windows (xterm's OSC).
_ESCAPE = re.compile(r"\x1b(?:\[[0-?]*[ -/]*[@-~]|\][^\x07\x1b]*(?:\x07|\x1b\\))")


def without_escapes(text: str) -> str:
    """Return a text without a terminal's colours and movements."""
    return _ESCAPE.sub("", text)


def has_expected(expected: Any, text: str) -> bool:
    """Return whether a text has what is expected.

    Args:
        expected: A text or a compiled pattern, which may stand anywhere; a list of whole lines or
            of patterns, which must come in that order.
        text: Where to look.

    Raises:
        ArgumentTypeError: `expected` is none of these.
    """
    text = text.replace("\r\n", "\n")
    if isinstance(expected, str):
        return expected in text
    if hasattr(expected, "search"):
        return expected.search(text) is not None
    if isinstance(expected, (list, tuple)) and expected:
        if all(isinstance(one, str) for one in expected):
            return _has_lines(expected, text)
        if all(hasattr(one, "search") for one in expected):
            return _has_patterns(expected, text)
    raise ArgumentTypeError("expected_output", "a text, a pattern or a list of these", expected)


def _has_lines(expected: Sequence[str], text: str) -> bool:
    lines = iter(text.splitlines())
    return all(one in lines for one in expected)  # each `in` goes on behind the former's line


def _has_patterns(expected: Sequence[Any], text: str) -> bool:
    place = 0
    for pattern in expected:
        match = pattern.search(text, place)
        if match is None:
            return False
        place = match.end()
    return True


def basic_output_filter(
    *, filtered_prefixes: Sequence[Any] = (), filtered_patterns: Sequence[Any] = ()
) -> Callable[[str], str]:
    """Return a function that leaves out lines.

    Args:
        filtered_prefixes: Lines that begin with one of these go.
        filtered_patterns: So do lines that match one of these.
    """
    prefixes = tuple(one.decode() if isinstance(one, bytes) else one for one in filtered_prefixes)
    patterns = [
        re.compile(one.decode() if isinstance(one, bytes) else one) for one in filtered_patterns
    ]

    def keep(text: str) -> str:
        return "".join(
            line
            for line in text.splitlines(keepends=True)
            if not line.startswith(prefixes) and not any(one.match(line) for one in patterns)
        )

    return keep


def expect_output(
    *,
    expected_text: Any = None,
    expected_lines: Sequence[Any] | None = None,
    text: str | None = None,
    lines: Sequence[str] | None = None,
    strict: bool = False,
) -> bool:
    """Return whether an output is as expected.

    Args:
        expected_text: A text or a pattern.
        expected_lines: Texts or patterns for whole lines; `None` among them stands for any line.
        text: The output.
        lines: The output, in lines.
        strict: Whether nothing else may be there.
    """
    whole = text if text is not None else "\n".join(lines or ())
    if expected_text is not None:
        if hasattr(expected_text, "search"):
            match = expected_text.fullmatch(whole) if strict else expected_text.search(whole)
            return match is not None
        return bool(whole == expected_text) if strict else expected_text in whole
    return _expect_lines(list(expected_lines or ()), whole.splitlines(), strict=strict)


def _expect_lines(expected: list[Any], lines: list[str], *, strict: bool) -> bool:
    starts = range(1) if strict else range(max(len(lines) - len(expected), -1) + 1)
    if strict and len(expected) != len(lines):
        return False
    return any(
        all(_fits(one, line) for one, line in zip(expected, lines[start:], strict=False))
        for start in starts
    )


def _fits(expected: Any, line: str) -> bool:
    if expected is None:
        return True
    return expected.match(line) is not None if hasattr(expected, "match") else expected == line
