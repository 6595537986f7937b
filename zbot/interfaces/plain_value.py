"""Conversion of messages to dictionaries, lists and scalars for YAML, JSON and CSV."""

from __future__ import annotations

import array
import base64
from dataclasses import dataclass
from math import isfinite
from typing import TYPE_CHECKING, Any

from zbot.interfaces.field_path import fields_of, is_message
from zbot.interfaces.slot import walk
from zbot.interfaces.yaml_text import Flow

if TYPE_CHECKING:
    from collections.abc import Iterator

    from zbot.interfaces import FieldType
    from zbot.interfaces.slot import Slot

_QUOTED_IN_CSV = frozenset(',"\r\n')
#: Maximum length of a numeric list on one line. A 6x6 covariance fits, but a laser scan does not.
SHORT_LIST = 36


@dataclass(frozen=True)
class Shortening:
    """Options that shorten the output of a message."""

    length: int | None = None  #: maximum length of strings and lists, or `None` for no limit
    no_arr: bool = False  #: replace lists by their type and length
    no_str: bool = False  #: replace strings by their length
    flow_style: bool = False  #: write lists on one line
    short_list: int = SHORT_LIST  #: maximum length of a numeric list on one line


EVERYTHING = Shortening()


def plain(message: Any, shortening: Shortening = EVERYTHING) -> dict[str, Any]:
    """Return a message as a dictionary of plain values, shortened by the options."""

    def leaf(value: Any, slot: Slot) -> Any:
        if not slot.is_list:
            return _shown_scalar(value, shortening)
        if shortening.no_arr:
            return array_label(value, slot.type)
        items = value if shortening.length is None else value[: shortening.length]
        shown = [walk(item, leaf) for item in items] if slot.is_message else items_of(items)
        return _shown_list(value, shown, slot.type, shortening)

    return walk(message, leaf)


def _shown_scalar(value: Any, shortening: Shortening) -> Any:
    if shortening.no_str and isinstance(value, str):
        return f"<string length: <{len(value)}>>"
    return shown_item(value, shortening.length)


def _shown_list(value: Any, shown: list[Any], kind: FieldType, shortening: Shortening) -> list[Any]:
    """Return the elements that are shown, with `...` in place of those that are left out."""
    is_shortened = len(shown) < len(value)
    if not (kind.typecode or kind.is_message):
        shown = [_shown_scalar(item, shortening) for item in shown]
    if is_shortened:
        shown.append("...")
    is_short = kind.typecode and len(value) <= shortening.short_list
    return Flow(shown) if shortening.flow_style or is_short else shown


def shown_item(item: Any, length: int | None) -> Any:
    """Return a number, or a string of at most `length` characters. Bytes become characters."""
    if isinstance(item, (bytes, bytearray)):
        item = item.decode("latin-1")  # each byte becomes the character with that code
    if isinstance(item, str):
        is_long = length is not None and len(item) > length
        return item[:length] + "..." if is_long else item
    return item.item() if hasattr(item, "item") else item


def array_label(value: Any, kind: FieldType) -> str:
    """Return the text that replaces a list. It contains the list's type and length."""
    base = kind.base
    if not (kind.is_message or kind.is_string):
        base = str(type(kind)(base))  # IDL's name: double, octet
    if kind.kind == "array":
        return f"<array type: {base}[{kind.size}]>"
    bound = f"[{kind.size}]" if kind.size else ""
    return f"<sequence type: {base}{bound}, length: {len(value)}>"


def items_of(value: Any) -> list[Any]:
    """Return the elements of a list, an array or an ndarray."""
    items: list[Any] = value.tolist() if hasattr(value, "tolist") else list(value)
    return items


def csv_values(value: Any, shortening: Shortening = EVERYTHING) -> Iterator[str]:
    """Yield the CSV text of each value in a message, in order."""
    if is_message(value):
        for field in fields_of(value):
            item = getattr(value, field.name)
            if shortening.no_arr and field.type.kind != "scalar":
                yield array_label(item, field.type)
            else:
                yield from csv_values(item, shortening)
    elif isinstance(value, str):
        text = f"<string length: <{len(value)}>>" if shortening.no_str else value
        yield _quoted(shown_item(text, shortening.length))
    elif isinstance(value, (bytes, bytearray)) or not hasattr(value, "__len__"):
        yield str(value)
    else:
        shown = value if shortening.length is None else value[: shortening.length]
        for item in items_of(shown):
            yield from csv_values(item, shortening)
        if len(shown) < len(value):
            yield "..."


def _quoted(text: str) -> str:
    if _QUOTED_IN_CSV.isdisjoint(text):
        return text
    return '"' + text.replace('"', '""') + '"'


def json_value(value: Any) -> Any:
    """Return a value in the form for JSON.

    NaN and infinities become null, because JSON does not have them. Arrays of byte, char or
    uint8 become base64, and one byte becomes a number. `MessageReader` reads all of them, and null
    as NaN.
    """
    if is_message(value):
        return walk(value, _json_leaf)
    if isinstance(value, float):
        return value if isfinite(value) else None
    if isinstance(value, (bytes, bytearray)):
        return value[0] if len(value) == 1 else _base64(value)
    if isinstance(value, array.array) and value.typecode == "B":
        return _base64(value)
    if hasattr(value, "tolist"):
        return json_value(value.tolist())
    if isinstance(value, list):
        return [json_value(item) for item in value]
    return value


def _json_leaf(value: Any, slot: Slot) -> Any:
    if slot.is_octets:
        return _base64(octets_of(value, slot))
    if slot.is_list and slot.type.typecode:
        numbers = items_of(value)
        if slot.type.typecode in "fd":
            return [number if isfinite(number) else None for number in numbers]
        return numbers
    return json_value(value)


def octets_of(value: Any, slot: Slot) -> bytes:
    """Return the bytes of a list of byte, char or uint8."""
    if slot.type.base == "byte":
        return b"".join(value)
    return value.tobytes() if hasattr(value, "tobytes") else bytes(value)


def _base64(octets: Any) -> str:
    return base64.b64encode(octets).decode()
