"""Whole numbers in texts of others."""

from __future__ import annotations

_MAX_DIGITS = 18  # each such number fits into 64 bits


def whole_number(text: str, most_digits: int = _MAX_DIGITS) -> int | None:
    """Return the number in a text of ASCII digits, or None if it has other or too many characters.

    `int()` accepts more forms, such as `1_0`, and raises an error for thousands of digits.
    `str.isdigit()` accepts texts that `int()` does not accept, such as `²`.
    """
    is_number = text.isascii() and text.isdigit() and len(text) <= most_digits
    return int(text) if is_number else None
