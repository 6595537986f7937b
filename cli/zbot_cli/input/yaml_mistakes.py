"""Advice for the YAML of a message: which mistake a text has, and what to type."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from zbot.interfaces.message_reader import number_with_comma

if TYPE_CHECKING:
    from zbot.interfaces import yaml_text

_NUMBER = re.compile(r"[-+]?[0-9.]+([eE][-+]?[0-9]+)?\Z")
_PAIRS = {"{": "}", "[": "]"}
_WRONG_COLON = re.compile(r"([\w.]+)\s*([:=])\s*(\S.*)\Z")
#: The end of a value, and the name of the next field without a comma in front of it.
_TYPE_AT_END = re.compile(r"(.*\})\s+(\w+/(?:\w+/)?\w+)\Z")
_COLON = re.compile(r"\s*:")
_TWO_WORDS = re.compile(r"[^\s:,{\[]\s+\w+\Z")


def stray_comma(
    before: tuple[yaml_text.Node, yaml_text.Node], key: yaml_text.Node, text: str
) -> tuple[str, str] | None:
    """Return a sentence and a hint for a word after a comma that is not a field with a value.

    Args:
        before: The field in front of the comma, and its value.
        key: The word after the comma.
        text: The whole text.

    Returns:
        `None` if there is no such mistake.
    """
    field, value = before
    if not isinstance(value.value, str) or _has_colon(key, text) or not _has_colon(field, text):
        return None
    if ":" in key.value or "=" in key.value:
        return None  # a field whose colon is wrong
    name, both = field.value, text[value.start_mark.index : key.end_mark.index]
    sentence = f"'{key.value}' has no value: a comma separates fields"
    if hint := number_with_comma(name, both):
        return f"'{both}' is not a number: a comma separates fields", hint
    if _NUMBER.match(value.value) and _NUMBER.match(key.value):
        return sentence, f"put a list in brackets: {name}: [{both}]"
    return sentence, f"put a text with a comma in quotes: {name}: '{both}'"


def _has_colon(key: yaml_text.Node, text: str) -> bool:
    return _COLON.match(text, key.end_mark.index) is not None


def wrong_colon(name: str) -> str:
    """Return what to type for `x:2.0` or `x=2.0`, or an empty string for other words."""
    match = _WRONG_COLON.match(name)
    if match is None:
        return ""
    advice = (
        "put a blank after the colon" if match[2] == ":" else "write a colon and a blank, not '='"
    )
    return f"{advice}: {match[1]}: {match[3]}"


def syntax_hint(text: str, error: yaml_text.YamlError) -> str:
    """Return what to type in place of a text that is not YAML."""
    if match := _TYPE_AT_END.match(text):
        return f'write the type before the values: {match[2]} "{match[1]}"'
    for opening, closing in _PAIRS.items():
        missing = text.count(opening) - text.count(closing)
        if missing > 0:
            return f"add {closing * missing} at the end: each {opening} needs a {closing}"
        if missing < 0:
            return f"remove {closing * -missing}: there are more {closing} than {opening}"
    line = "".join(text.splitlines()[error.line or 0 :][:1])
    before, after = line[: error.column], line[error.column :]
    if ";" in before:
        return "separate fields with a comma, not ';': {x: 1.0, y: 2.0}"
    if after.startswith(":") and _TWO_WORDS.search(before):
        return "put a comma between two fields, and braces around all: {x: 1.0, y: 2.0}"
    if "{" in before and not after.startswith(":"):
        return "put one pair of braces around all fields: {linear: {x: 2.0}, angular: {z: 1.0}}"
    return 'write it like "{linear: {x: 2.0}}", with a blank after each colon'
