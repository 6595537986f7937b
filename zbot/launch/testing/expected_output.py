"""Search for expected lines or texts in an output, like `expect_output` in launch_testing."""

from __future__ import annotations

import re
from pathlib import Path
from typing import TYPE_CHECKING, Any

from zbot.errors import ArgumentTypeError, WrongValueError
from zbot.launch.testing.error import LaunchTestError
from zbot.launch.testing.output_text import without_escapes

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence


def expect_output(
    text: str | None = None,
    *,
    lines: Sequence[str] | None = None,
    expected_text: Any = None,
    expected_lines: Any = None,
    strip_ansi_escape_sequences: bool = True,
    strict: bool = False,
) -> bool:
    """Return whether an output contains the expected text or lines.

    Args:
        text: The output.
        lines: The output as lines, instead of `text`.
        expected_text: A text, a pattern, or a list of texts and patterns. The output must contain
            the items of the list in the same order.
        expected_lines: Like `expected_text`, but each item must be in a line of its own. A text may
            be anywhere in a line. A pattern must match from the beginning of a line.
        strip_ansi_escape_sequences: Whether to remove colours from the output first.
        strict: Whether the output must start with the expected parts, without gaps between them.
            More output may follow, because the program may still be running. There are two
            exceptions. A string in `expected_text` must be the whole output. A string or pattern in
            `expected_lines`, without a list, must match every line of the output.

    Raises:
        WrongValueError: Exactly one of `text` and `lines` is required. The same is true for
            `expected_text` and `expected_lines`.
        ArgumentTypeError: The expected argument is not a text, a pattern or a list of them.
    """
    if (text is None) == (lines is None):
        raise WrongValueError("expect_output takes either text or lines")
    if (expected_text is None) == (expected_lines is None):
        raise WrongValueError("expect_output takes either expected_text or expected_lines")
    whole = "\n".join(lines or ()) if text is None else text.replace("\r\n", "\n")
    if strip_ansi_escape_sequences:
        whole = without_escapes(whole)
    if expected_text is not None:
        return _has_text(expected_text, whole, strict=strict)
    found = whole.splitlines() if lines is None else whole.split("\n") if lines else []
    return _has_lines(expected_lines, found, strict=strict)


def expected_output_from_file(path: str, encoding: str | None = None) -> list[Any]:
    """Return the expected lines in a file.

    Args:
        path: The path without the suffix. A file with the suffix `.txt` contains lines, and a file
            with the suffix `.regex` contains patterns.
        encoding: The encoding of the file, e.g. `unicode_escape` if it contains escapes.

    Raises:
        LaunchTestError: No file with this path and one of these suffixes exists.
    """
    texts, patterns = Path(f"{path}.txt"), Path(f"{path}.regex")
    if texts.is_file():
        return list(texts.read_text(encoding=encoding or "utf-8").splitlines())
    if patterns.is_file():
        return [
            re.compile(line)
            for line in patterns.read_text(encoding=encoding or "utf-8").splitlines()
        ]
    raise LaunchTestError(f"there is neither {texts} nor {patterns}")


def _has_text(expected: Any, text: str, *, strict: bool) -> bool:
    if strict and isinstance(expected, str):
        return text == expected
    end = 0
    for wanted in _each("expected_text", expected):
        pattern = re.compile(re.escape(wanted)) if isinstance(wanted, str) else wanted
        found = pattern.match(text, end) if strict else pattern.search(text, end)
        if found is None:
            return False
        end = found.end()
    return True


def _has_lines(expected: Any, lines: Sequence[str], *, strict: bool) -> bool:
    if strict and isinstance(expected, str):
        return all(line == expected for line in lines)
    if strict and hasattr(expected, "match"):
        return all(expected.match(line) for line in lines)
    place = 0
    for wanted in _each("expected_lines", expected):
        within = lines[place : place + 1] if strict else lines[place:]
        step = next(
            (n for n, line in enumerate(within, start=1) if _matches_line(wanted, line)), None
        )
        if step is None:
            return False
        place += step
    return True


def _each(name: str, expected: Any) -> Iterable[Any]:
    if isinstance(expected, str) or hasattr(expected, "match"):
        return (expected,)
    several = list(expected) if hasattr(expected, "__iter__") else []
    if several and all(isinstance(item, str) or hasattr(item, "match") for item in several):
        return several
    raise ArgumentTypeError(name, "a text, a pattern or several of these", expected)


def _matches_line(expected: Any, line: str) -> bool:
    return expected in line if isinstance(expected, str) else expected.match(line) is not None
