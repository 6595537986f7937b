"""Functions that search for expected texts in an output, or remove lines from an output."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, Any

from zbot.errors import ArgumentTypeError

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Sequence

# Colours and cursor movements (ECMA-48, 5.4), and window titles (xterm's OSC).
_ESCAPE = re.compile(r"\x1b(?:\[[0-?]*[ -/]*[@-~]|\][^\x07\x1b]*(?:\x07|\x1b\\))")


def without_escapes(text: str) -> str:
    """Return a text without terminal escape sequences."""
    return _ESCAPE.sub("", text)


def has_expected(expected: Any, text: str) -> bool:
    """Return whether a text contains the expected texts or patterns.

    Args:
        expected: A text or a compiled pattern, which may be anywhere. A list contains complete
            lines or patterns, which must come in the same order.
        text: The text to search.

    Raises:
        ArgumentTypeError: `expected` has another type.
    """
    text = text.replace("\r\n", "\n")
    if isinstance(expected, str):
        return expected in text
    if hasattr(expected, "search"):
        return expected.search(text) is not None
    if isinstance(expected, (list, tuple)) and expected:
        if all(isinstance(part, str) for part in expected):
            return _has_lines(expected, text)
        if all(hasattr(part, "search") for part in expected):
            return _has_patterns(expected, text)
    raise ArgumentTypeError("expected_output", "a text, a pattern or a list of these", expected)


def _has_lines(expected: Sequence[str], text: str) -> bool:
    lines = iter(text.splitlines())
    return all(line in lines for line in expected)  # each `in` continues after the last line found


def _has_patterns(expected: Sequence[Any], text: str) -> bool:
    place = 0
    for pattern in expected:
        match = pattern.search(text, place)
        if match is None:
            return False
        place = match.end()
    return True


def get_default_filtered_prefixes() -> list[str]:
    """Return the prefixes of lines that `basic_output_filter` removes by default."""
    return ["pid", "rc"]


def get_default_filtered_patterns() -> list[str]:
    """Return an empty list. By default, `basic_output_filter` uses only prefixes, no patterns."""
    return []


def _to_text(word: str | bytes) -> str:
    return word.decode() if isinstance(word, bytes) else word


def basic_output_filter(
    filtered_prefixes: Iterable[str | bytes] | None = None,
    filtered_patterns: Iterable[str | bytes] | None = None,
) -> Callable[[str], str]:
    """Return a function that removes lines from a text.

    Args:
        filtered_prefixes: Prefixes of lines to remove. None means `pid` and `rc`.
        filtered_patterns: Patterns of lines to remove. They must match at the beginning of a line.
    """
    if filtered_prefixes is None:
        filtered_prefixes = get_default_filtered_prefixes()
    prefixes = tuple(map(_to_text, filtered_prefixes))
    patterns = [re.compile(_to_text(pattern)) for pattern in filtered_patterns or ()]

    def keep(text: str) -> str:
        return "".join(
            line
            for line in text.splitlines(keepends=True)
            if not line.startswith(prefixes)
            and not any(pattern.match(line) for pattern in patterns)
        )

    return keep


def ros_output_filter(
    filtered_prefixes: Iterable[str | bytes] | None = None,
    filtered_patterns: Iterable[str | bytes] | None = None,
    filtered_rmw_implementation: str | None = None,
) -> Callable[[str], str]:
    """Return a function that removes lines, like `basic_output_filter` of launch_testing_ros.

    Args:
        filtered_prefixes: The same as for `basic_output_filter`.
        filtered_patterns: The same as for `basic_output_filter`.
        filtered_rmw_implementation: Has no effect, because Zenoh does not write to the output.
    """
    del filtered_rmw_implementation
    return basic_output_filter(filtered_prefixes, filtered_patterns)
