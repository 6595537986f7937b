"""Reader of JSON from other programs and machines, with limits. It raises only `JsonError`."""

from __future__ import annotations

import json
import math
import re
from typing import Any

from zbot.errors import ZbotError

_MAX_BYTES = 16 * 1024 * 1024
_MAX_LEVELS = 64
# Python needs up to 20 times the memory of the text for `[{},{},...]`, and stops all other threads
# while it reads it. A map of 1000 * 1000 cells has a million values, and a large graph some 10,000
# objects.
_MAX_VALUES = 1_100_000
_MAX_CONTAINERS = 200_000
_MOST_COUNTED = 4_000_000
# It also takes a string without an end, so that its time grows only with the length of the text.
_STRING = re.compile(r'"[^"\\]*(?:\\(?:.|\Z)[^"\\]*)*(?:"|\Z)', re.DOTALL)
_MAX_DIGITS = 400  # every number that fits in a float64 is shorter


class JsonError(ZbotError, ValueError):
    """A text is not JSON that zbot accepts."""

    def __init__(self, reason: str) -> None:
        self.reason = reason
        super().__init__(f"this is not valid JSON: {reason}")


def read_json(text: str | bytes, max_bytes: int = _MAX_BYTES) -> Any:
    """Return the value in a JSON text.

    Args:
        text: The text. Bytes are UTF-8.
        max_bytes: The largest allowed number of bytes, or of characters if `text` is a `str`.

    Raises:
        JsonError: The text is not valid, is too long or is nested deeper than 64 levels. It has
            more than 200,000 objects and lists, or more than 1,100,000 values. A number is infinite
            or has more than 400 digits. Or UTF-8 cannot encode a string.
    """
    if len(text) > max_bytes:
        raise JsonError(f"it is longer than {max_bytes} bytes")
    try:
        if isinstance(text, bytes):
            text = text.decode(json.detect_encoding(text), "surrogatepass")
        _check_size(text)
        value = json.loads(
            text, parse_int=_integer, parse_float=_float, parse_constant=_refuse_constant
        )
    except JsonError:
        raise
    except RecursionError:
        raise JsonError(f"it is nested deeper than {_MAX_LEVELS} levels") from None
    except ValueError as error:
        raise JsonError(str(error)) from error
    _check(value)
    return value


def read_json_object(text: str | bytes, max_bytes: int = _MAX_BYTES) -> dict[str, Any]:
    """Return the object in a JSON text. The errors are those of `read_json`.

    Raises:
        JsonError: The text is not valid, or is not an object.
    """
    value = read_json(text, max_bytes)
    if not isinstance(value, dict):
        raise JsonError("it is not an object")
    return value


def _check_size(text: str) -> None:
    """Check the number of values before the text is read.

    Commas inside strings do not count, unless the text is so long that this would take long.
    """
    is_long = len(text) > _MOST_COUNTED
    if _is_large(text) and (is_long or _is_large(_STRING.sub("", text))):
        raise JsonError(
            f"it has more than {_MAX_CONTAINERS} objects and lists, or {_MAX_VALUES} values"
        )


def _is_large(text: str) -> bool:
    containers = text.count("{") + text.count("[")
    return containers > _MAX_CONTAINERS or containers + text.count(",") > _MAX_VALUES


def _check(value: Any) -> None:
    """Check depth and strings in a loop, because a recursive function would need a deep stack."""
    level = [value]
    for _ in range(_MAX_LEVELS + 1):
        deeper: list[Any] = []
        for item in level:
            if isinstance(item, str):
                _check_text(item)
            elif isinstance(item, list):
                deeper += item
            elif isinstance(item, dict):
                deeper += item
                deeper += item.values()
        if not deeper:
            return
        level = deeper
    raise JsonError(f"it is nested deeper than {_MAX_LEVELS} levels")


def _check_text(text: str) -> None:
    if not text.isascii():
        try:
            text.encode()
        except UnicodeEncodeError:
            raise JsonError("a string has characters that UTF-8 cannot hold") from None


def _integer(digits: str) -> int:
    if len(digits) > _MAX_DIGITS:
        raise JsonError(f"a number has more than {_MAX_DIGITS} digits")
    return int(digits)


def _float(digits: str) -> float:
    value = float(digits)
    if not math.isfinite(value):
        raise JsonError("a number is infinite")
    return value


def _refuse_constant(word: str) -> Any:
    raise JsonError(f"{word} is not a number")
