"""Values in texts of devices: numbers, true and false, words. And the names that they have."""

from __future__ import annotations

import re
from typing import Any

from zbot.interfaces.yaml_message import Word

#: A number, as programs on boards print it. A point after digits always belongs to the number:
#: with two ways to read `1.`, a line with many such values would be read in millions of ways.
NUMBER = r"[+-]?(?:[0-9]+(?:\.[0-9]*|(?!\.))|\.[0-9]+)(?:[eE][+-]?[0-9]{1,3})?"
#: A unit of measurement after a number: C, %, hPa, m/s^2. `0xee` is no number with a unit.
UNIT = r"(?![xX])[^\s0-9,;:=|]{1,6}"
_INTEGER = re.compile(r"[+-]?[0-9]{1,19}\Z", re.ASCII)
_FLOAT = re.compile(rf"(?:{NUMBER}|[+-]?(?:nan|inf))\Z", re.ASCII | re.IGNORECASE)
_MEASURED = re.compile(rf"({NUMBER})\s*{UNIT}\Z", re.ASCII)
_BOOLS = {"true": True, "false": False, "on": True, "off": False}
_NO_NAME_CHARACTERS = re.compile(r"[^A-Za-z0-9_/]+")
_DIGIT_FIRST = re.compile(r"(?:(?<=/)|^)(?=[0-9])")
_REPEATED = re.compile(r"/+")


def word_of(text: str) -> Word:
    """Return the value in a text, with the text.

    The value is an int, a float (also `nan` and `inf`), a bool (`true`, `false`, `on`, `off`, also
    with capital letters) or the text. A unit after a number is left out: `23.5 C` is 23.5.
    """
    if _INTEGER.match(text):
        return Word(text, int(text))
    if _FLOAT.match(text):
        return Word(text, float(text))
    known = _BOOLS.get(text.lower())
    if known is not None:
        return Word(text, known)
    measured = _MEASURED.match(text)
    if measured:
        return Word(text, word_of(measured[1]).value)
    return Word(text, text)


def json_word(value: Any) -> Word:
    """Return a number, a string or a bool of JSON as a word. `ON` and `OFF` are bools."""
    if isinstance(value, str):
        return Word(value, _BOOLS.get(value.lower(), value))
    return Word(str(value).lower() if isinstance(value, bool) else str(value), value)


def topic_name(text: str) -> str:
    """Return a valid topic name that is similar to a text, or an empty string if there is none.

    Each other character becomes `_`: `home/living-room/1` becomes `home/living_room/_1`.
    """
    name = _NO_NAME_CHARACTERS.sub("_", text.strip())
    name = _REPEATED.sub("/", name).rstrip("/")
    return "" if not name.strip("_/") else _DIGIT_FIRST.sub("_", name)
