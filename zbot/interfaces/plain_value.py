"""Messages as plain values: dictionaries, lists and leaves that YAML, JSON and CSV can write."""

from __future__ import annotations

import array
import base64
import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from zbot.interfaces.field_path import fields_of, is_message
from zbot.interfaces.yaml_text import Flow

if TYPE_CHECKING:
    from collections.abc import Iterator

    from zbot.interfaces import FieldType

_OCTETS = {"byte", "char", "uint8"}
_QUOTED_IN_CSV = frozenset(',"\r\n')
#: Numeric lists up to this long stand on one line: a 6x6 covariance does, a scan does not.
SHORT_LIST = 36


@dataclass(frozen=True)
class Shortening:
    """How much of a message is kept; `length` is `None` for everything."""

    length: int | None = None  #: of texts and lists
    no_arr: bool = False  #: of lists, only type and length
    no_str: bool = False  #: of texts, only the length
    flow_style: bool = False  #: lists on one line
    short_list: int = SHORT_LIST  #: numeric lists up to this long stand on one line


EVERYTHING = Shortening()


def plain(message: Any, shortening: Shortening = EVERYTHING) -> dict[str, Any]:
    """Return a message as a dictionary of what YAML can write, shortened as wished."""
    return {
        field.name: _plain_value(getattr(message, field.name), field.type, shortening)
        for field in fields_of(message)
    }


def _plain_value(value: Any, kind: FieldType, shortening: Shortening) -> Any:
    if kind.kind != "scalar":
        return (
            array_label(value, kind) if shortening.no_arr else _shown_list(value, kind, shortening)
        )
    if kind.is_message:
        return plain(value, shortening)
    if shortening.no_str and kind.is_string:
        return f"<string length: <{len(value)}>>"
    return shown_item(value, shortening.length)


def shown_item(item: Any, length: int | None) -> Any:
    """Return a number, or a text of at most `length` characters; bytes become characters."""
    if isinstance(item, (bytes, bytearray)):
        item = item.decode("latin-1")  # each byte as the character of that number
    if isinstance(item, str):
        is_long = length is not None and len(item) > length
        return item[:length] + "..." if is_long else item
    return item.item() if hasattr(item, "item") else item


def array_label(value: Any, kind: FieldType) -> str:
    """Return what stands for a list that is left out."""
    base = kind.base
    if not (kind.is_message or kind.is_string):
        base = str(type(kind)(base))  # as IDL calls it: double, octet
    if kind.kind == "array":
        return f"<array type: {base}[{kind.size}]>"
    bound = f"[{kind.size}]" if kind.size else ""
    return f"<sequence type: {base}{bound}, length: {len(value)}>"


def _shown_list(value: Any, kind: FieldType, shortening: Shortening) -> list[Any]:
    shown = value if shortening.length is None else value[: shortening.length]
    items = items_of(shown)
    if kind.is_message:
        items = [plain(item, shortening) for item in items]
    elif not kind.typecode:
        one = type(kind)(kind.base)
        items = [_plain_value(item, one, shortening) for item in items]
    if len(shown) < len(value):
        items.append("...")
    is_short = kind.typecode and len(value) <= shortening.short_list
    return Flow(items) if shortening.flow_style or is_short else items


def items_of(value: Any) -> list[Any]:
    """Return the elements of a list, an array or an ndarray."""
    items: list[Any] = value.tolist() if hasattr(value, "tolist") else list(value)
    return items


def leaves(value: Any, shortening: Shortening = EVERYTHING) -> Iterator[str]:
    """Return every value in a message, from the first to the last, as a line of CSV has it."""
    if is_message(value):
        for field in fields_of(value):
            item = getattr(value, field.name)
            if shortening.no_arr and field.type.kind != "scalar":
                yield array_label(item, field.type)
            else:
                yield from leaves(item, shortening)
    elif isinstance(value, str):
        text = f"<string length: <{len(value)}>>" if shortening.no_str else value
        yield _quoted(shown_item(text, shortening.length))
    elif isinstance(value, (bytes, bytearray)) or not hasattr(value, "__len__"):
        yield str(value)
    else:
        shown = value if shortening.length is None else value[: shortening.length]
        for item in items_of(shown):
            yield from leaves(item, shortening)
        if len(shown) < len(value):
            yield "..."


def _quoted(text: str) -> str:
    if _QUOTED_IN_CSV.isdisjoint(text):
        return text
    return '"' + text.replace('"', '""') + '"'


def json_value(value: Any) -> Any:
    """Return a value as JSON has it.

    Numbers that JSON lacks (NaN, infinities) become null. Many bytes, of whichever type, become
    base64; one byte is a number. `zbot topic pub` reads all of it but null.
    """
    if is_message(value):
        return {
            field.name: _json_field(getattr(value, field.name), field.type)
            for field in fields_of(value)
        }
    if isinstance(value, float):
        return value if math.isfinite(value) else None
    if isinstance(value, (bytes, bytearray)):
        return value[0] if len(value) == 1 else _base64(value)
    if isinstance(value, array.array) and value.typecode == "B":
        return _base64(value)
    if hasattr(value, "tolist"):
        return json_value(value.tolist())
    if isinstance(value, list):
        return [json_value(item) for item in value]
    return value


def _json_field(value: Any, kind: FieldType) -> Any:
    if kind.kind == "scalar" or kind.base not in _OCTETS:
        return json_value(value)
    if kind.base == "byte":
        return _base64(b"".join(value))
    return _base64(value.tobytes() if hasattr(value, "tobytes") else bytes(value))


def _base64(octets: Any) -> str:
    return base64.b64encode(octets).decode()
