"""Whether a text has what a test expects: a text, a pattern, or several in their order."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, Any

from zbot.errors import ArgumentTypeError

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Sequence

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


def get_default_filtered_prefixes() -> list[str]:
    """Return how lines begin that `basic_output_filter` leaves out if it is not told."""
    return ["pid", "rc"]


def get_default_filtered_patterns() -> list[str]:
    """Return which lines `basic_output_filter` leaves out if it is not told: none."""
    return []


def _to_text(word: str | bytes) -> str:
    return word.decode() if isinstance(word, bytes) else word


def basic_output_filter(
    filtered_prefixes: Iterable[str | bytes] | None = None,
    filtered_patterns: Iterable[str | bytes] | None = None,
) -> Callable[[str], str]:
    """Return a function that leaves out lines.

    Args:
        filtered_prefixes: Lines that begin with one of these go; `pid` and `rc` if left out.
        filtered_patterns: So do lines that match one of these.
    """
    if filtered_prefixes is None:
        filtered_prefixes = get_default_filtered_prefixes()
    prefixes = tuple(map(_to_text, filtered_prefixes))
    patterns = [re.compile(_to_text(one)) for one in filtered_patterns or ()]

    def keep(text: str) -> str:
        return "".join(
            line
            for line in text.splitlines(keepends=True)
            if not line.startswith(prefixes) and not any(one.match(line) for one in patterns)
        )

    return keep


def ros_output_filter(
    filtered_prefixes: Iterable[str | bytes] | None = None,
    filtered_patterns: Iterable[str | bytes] | None = None,
    filtered_rmw_implementation: str | None = None,
) -> Callable[[str], str]:
    """Return a function that leaves out lines: launch_testing_ros's `basic_output_filter`.

    Args:
        filtered_prefixes: As for `basic_output_filter`.
        filtered_patterns: As for `basic_output_filter`.
        filtered_rmw_implementation: The middleware whose own lines are left out; Zenoh writes none.
    """
    del filtered_rmw_implementation
    return basic_output_filter(filtered_prefixes, filtered_patterns)
