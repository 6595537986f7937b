"""Scalar values of parameters in YAML, by the rules of ROS 2's C library.

ROS 2 reads a number with C's `strtoll` and `strtod`. So `010` is 8, `08` is 8.0, `1e3`, `0x1p3` and
`nan` are floats, and `1_000`, `0b1`, `1:30`, `null` and `2020-01-01` are strings.
"""

from __future__ import annotations

import re
import sys

#: Letters that are bools too. In a list such as `[x, y, z]`, they are strings.
LETTERS = frozenset("yYnN")
_TRUE = frozenset(["Y", "y", "yes", "Yes", "YES", "true", "True", "TRUE", "on", "On", "ON"])
_FALSE = frozenset(["N", "n", "no", "No", "NO", "false", "False", "FALSE", "off", "Off", "OFF"])
_SPECIAL = re.compile(r"(?P<sign>[-+]?)\.(?:inf|Inf|INF)|\.(?:nan|NaN|NAN)")
# C's white space and digits are ASCII, unlike Python's.
_INTEGER = re.compile(
    r"[ \t\n\v\f\r]*[-+]?(?:(?P<hex>0[xX][0-9a-fA-F]+)|(?P<oct>0[0-7]*)|[1-9][0-9]*)"
)
_FLOAT = re.compile(
    r"[ \t\n\v\f\r]*(?P<sign>[-+]?)(?P<value>"
    r"(?P<decimal>(?=\.?[0-9])(?P<digits>[0-9]*(?:\.[0-9]*)?)(?:[eE][-+]?[0-9]+)?)"
    r"|0[xX](?=\.?[0-9a-fA-F])(?P<hex>[0-9a-fA-F]*\.?[0-9a-fA-F]*)(?:[pP][-+]?[0-9]+)?"
    r"|(?i:inf(?:inity)?)|(?i:nan)(?:\([0-9A-Za-z_]*\))?)"
)
_INT64 = range(-(2**63), 2**63)


def scalar_value(text: str) -> bool | float | str:
    """Return the value of a scalar that has no quotes and no tag.

    An integer that does not fit into 64 bits is a float. A float that is too large for 64 bits, or
    too close to zero, is a string.
    """
    if text in _TRUE or text in _FALSE:
        return text in _TRUE
    special = _SPECIAL.fullmatch(text)
    if special is not None:
        return float(f"{special['sign'] or ''}{text.lower().partition('.')[2]}")
    integer = _INTEGER.fullmatch(text)
    if integer is not None:
        value = int(text, 16 if integer["hex"] else 8 if integer["oct"] else 10)
        if value in _INT64:
            return value
    number = _float(text)
    return text if number is None else number


def _float(text: str) -> float | None:
    match = _FLOAT.fullmatch(text)
    if match is None:
        return None
    word = match["value"].lower()
    if word.startswith(("inf", "nan")):
        return float(match["sign"] + word[:3])
    try:
        value = float.fromhex(match["value"]) if match["hex"] is not None else float(word)
    except OverflowError:
        return None
    digits = match["hex"] if match["hex"] is not None else match["digits"]
    is_zero = not digits.strip("0.")
    if not is_zero and not sys.float_info.min <= value <= sys.float_info.max:
        return None  # `strtod` reports these numbers as out of range
    return -value if match["sign"] == "-" else value
