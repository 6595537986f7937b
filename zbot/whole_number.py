"""Whole numbers in texts of others."""

from __future__ import annotations

_MAX_DIGITS = 19  # as many as 2**63 has


def whole_number(text: str) -> int | None:
    """Return the number in a text of 1 to 19 ASCII digits, otherwise None.

    `int()` accepts more forms, such as `1_0`, and raises an error for thousands of digits.
    `str.isdigit()` accepts texts that `int()` does not accept, such as `²`.
    """
    is_number = text.isascii() and text.isdigit() and len(text) <= _MAX_DIGITS
    return int(text) if is_number else None
