"""Reader of JSON from other programs and machines, with limits. It raises only `JsonError`."""

from __future__ import annotations

import json
import math
from typing import TYPE_CHECKING, Any

from zbot.errors import ZbotError

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator

_MAX_BYTES = 16 * 1024 * 1024
_MAX_LEVELS = 64
# Python needs up to 20 times the memory of the text for `[{},{},...]`. A map of 1000 * 1000 cells
# has a million values, and a large graph some 10,000 objects.
_MAX_VALUES = 1_100_000
_MAX_OBJECTS = 200_000
# All other threads of the process wait while Python reads lists and strings: for these numbers of
# lists or of escapes in strings, 10 to 15 ms.
_MAX_LISTS = 50_000
_MAX_ESCAPES = 1_100_000
_PIECE = 65_536  # characters that are searched in one step, for the same reason
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
            more than 200,000 objects, 50,000 lists or 1,100,000 values. Its strings have more than
            1,100,000 backslashes. A number is infinite or has more than 400 digits. Or UTF-8 cannot
            encode a string.
    """
    if len(text) > max_bytes:
        raise JsonError(f"it is longer than {max_bytes} bytes")
    try:
        if isinstance(text, bytes):
            text = text.decode(json.detect_encoding(text), "surrogatepass")
        _check_size(text)
        value = json.loads(
            text,
            object_hook=_let_others_work if len(text) > _PIECE else None,
            parse_int=_integer,
            parse_float=_float,
            parse_constant=_refuse_constant,
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
    """Check the number of values before the text is read. What is inside strings does not count."""
    if len(text) > _MAX_LISTS and _is_large(_pieces(text)) and _is_large(_outside_strings(text)):
        raise JsonError(
            f"it has more than {_MAX_OBJECTS} objects, {_MAX_LISTS} lists or {_MAX_VALUES} values"
        )
    if len(text) > _MAX_ESCAPES and _escapes(text) > _MAX_ESCAPES:
        raise JsonError(f"its strings have more than {_MAX_ESCAPES} backslashes")


def _is_large(pieces: Iterable[str]) -> bool:
    objects = lists = commas = 0
    for piece in pieces:
        objects += piece.count("{")
        lists += piece.count("[")
        commas += piece.count(",")
        if objects > _MAX_OBJECTS or lists > _MAX_LISTS or objects + lists + commas > _MAX_VALUES:
            return True
    return False


def _escapes(text: str) -> int:
    return sum(piece.count("\\") for piece in _pieces(text))


def _pieces(text: str) -> Iterator[str]:
    return (text[start : start + _PIECE] for start in range(0, len(text), _PIECE))


def _outside_strings(text: str) -> Iterator[str]:
    is_inside, rest = False, ""
    for piece in _pieces(text):
        joined = rest + piece
        # The last backslash may belong to the next piece.
        rest = "\\" * ((len(joined) - len(joined.rstrip("\\"))) % 2)
        parts = joined.removesuffix(rest).replace("\\\\", "").replace('\\"', "").split('"')
        yield "".join(parts[is_inside::2])
        is_inside ^= len(parts) % 2 == 0


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
            for piece in _pieces(text):
                piece.encode()
        except UnicodeEncodeError:
            raise JsonError("a string has characters that UTF-8 cannot hold") from None


def _let_others_work(value: dict[str, Any]) -> dict[str, Any]:
    # Python lets another thread work at each call of a function that is written in Python.
    return value


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
