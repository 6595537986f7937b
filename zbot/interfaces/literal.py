"""Literals in a definition: the values of constants and defaults."""

from __future__ import annotations

import math
import re

from zbot.interfaces.grammar import GrammarError
from zbot.interfaces.spec import FLOAT32_MAX, INTEGER_RANGES, FieldType, Scalar

_QUOTES = "\"'"
_QUOTED_ELEMENT = re.compile(r"""\s*("(?:\\.|[^"\\])*"|'(?:\\.|[^'\\])*'|[^,"'\s][^,]*)\s*(,|$)""")
# Python's escapes, which rosidl uses too: `\n`, `\x41`, `\101`, `\u00e9`, `\N{BULLET}`.
_ESCAPED = re.compile(
    r"\\(?:[0-7]{1,3}|x[0-9a-fA-F]{2}|u[0-9a-fA-F]{4}|U[0-9a-fA-F]{8}|N\{[^{}\\]*\}|.)", re.DOTALL
)
_WHOLE_ESCAPES = re.compile(r"(?:\\.|[^\\])*", re.DOTALL)
_PREFIXED = re.compile(r"[+-]?0[xob]", re.IGNORECASE)
_TRUE, _FALSE = ("true", "1"), ("false", "0")
#: Numbers below this limit become the largest float32, e.g. C's `FLT_MAX`, 3.4028235e38.
_FLOAT32_LIMIT = 2.0**128 - 2.0**103
# Limit for int(), which is slow on megabytes of digits. Every valid number is shorter.
_LONGEST_NUMBER = 400


def parse_value(field_type: FieldType, text: str) -> Scalar | tuple[Scalar, ...]:
    """Return the value of a literal for a type.

    An array becomes a tuple and a `byte` becomes `bytes` of length 1. Any other value has the type
    of the message's field in Python.

    Raises:
        GrammarError: The text is not a value of the type. The error says what to write.
    """
    if field_type.is_message:
        raise GrammarError("a field that is a message cannot have a default")
    if field_type.kind == "scalar":
        return _scalar(field_type, text)
    if not (text.startswith("[") and text.endswith("]") and len(text) > 1):
        raise GrammarError(f"the default of an array is a list such as [1, 2], not {text!r}")
    values = tuple(_scalar(field_type, part) for part in _elements(field_type, text[1:-1]))
    if field_type.kind == "array" and len(values) != field_type.size:
        raise GrammarError(f"{field_type.size} values are needed, but {len(values)} are given")
    if field_type.size and len(values) > field_type.size:
        raise GrammarError(f"at most {field_type.size} values fit, but {len(values)} are given")
    return values


def _elements(field_type: FieldType, text: str) -> list[str]:
    if not text.strip():
        return []
    if not field_type.is_string:
        return [part.strip() for part in text.split(",")]
    parts: list[str] = []
    position, separator = 0, ","
    while separator:
        match = _QUOTED_ELEMENT.match(text, position)
        if match is None:
            rest = text[position:].strip()
            raise GrammarError(f"cannot read the list at {rest!r}: put strings in quotes")
        parts.append(match[1].strip())
        position, separator = match.end(), match[2]
    return parts


def _scalar(field_type: FieldType, text: str) -> Scalar:
    if field_type.is_string:
        return _string(field_type, text)
    base = field_type.base
    if base == "bool":
        return _bool(text)
    if base == "byte":
        return bytes([_integer("uint8", text)])
    if base in INTEGER_RANGES:
        return _integer(base, text)
    return _float(base, text)


def _bool(text: str) -> bool:
    if text.lower() not in _TRUE + _FALSE:
        raise GrammarError(f"a bool is true or false (or 1 or 0), not {text!r}")
    return text.lower() in _TRUE


def _integer(base: str, text: str) -> int:
    low, high = INTEGER_RANGES[base]
    value = _as_int(text)
    if value is None or not low <= value <= high:
        raise GrammarError(f"write a whole number from {low} to {high}, not {text!r}")
    return value


def _as_int(text: str) -> int | None:
    """Return the integer in a text, or None. 007 is decimal. 0x, 0o and 0b are allowed too."""
    if len(text) > _LONGEST_NUMBER:
        return None
    try:
        return int(text, 0 if _PREFIXED.match(text) else 10)
    except ValueError:
        return None


def _float(base: str, text: str) -> float:
    try:
        value = float(text)
    except ValueError:
        reason = f"write a number with '.' as its decimal point, not {text!r}"
        raise GrammarError(reason) from None
    if base == "float32" and FLOAT32_MAX < abs(value) < math.inf:
        if abs(value) >= _FLOAT32_LIMIT:
            raise GrammarError(f"{text} is too large for a float32: write float64")
        return math.copysign(FLOAT32_MAX, value)
    return value


def _string(field_type: FieldType, text: str) -> str:
    value = _unquoted(text)
    bound = field_type.string_bound
    if bound and len(value) > bound:
        raise GrammarError(f"at most {bound} characters fit, but {value!r} has {len(value)}")
    return value


def _unquoted(text: str) -> str:
    quote = text[:1]
    if not quote or quote not in _QUOTES:
        return _unescaped(text)
    inner = text[1:-1]
    if len(text) < 2 or text[-1] != quote or not _WHOLE_ESCAPES.fullmatch(inner):
        raise GrammarError(f"the string begins with {quote} and must end with {quote}")
    if quote in _ESCAPED.sub("", inner):
        raise GrammarError(f"write \\{quote} for a quote inside the string")
    return _unescaped(inner)


def _unescaped(text: str) -> str:
    """Return a text with its escapes replaced. Other backslashes stay in the text."""
    try:
        found = _ESCAPED.sub(lambda match: _character(match[0]), text)
        found.encode()
    except UnicodeError:
        raise GrammarError(f"an escape in {text!r} is not a character") from None
    return found


def _character(escape: str) -> str:
    is_known = escape[1] in "01234567xuUN\\'\"abfnrtv"
    try:
        return escape.encode().decode("unicode_escape") if is_known else escape
    except UnicodeDecodeError:
        if len(escape) > 2:
            raise
        return escape  # e.g. an x without digits
