"""Text of messages in a page, on one line or as a tree of fields."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from zbot.interfaces.field_path import fields_of, is_message

if TYPE_CHECKING:
    from collections.abc import Iterator

    from zbot.interfaces import FieldType

#: A tree shows at most this many elements of a list. A scan has hundreds.
MOST_ELEMENTS = 24
#: The largest number of rows in a tree. A nested message can have thousands.
MOST_ROWS = 300
_LONGEST_TEXT = 2000
_HEADER = "std_msgs/msg/Header"
_TIMES = {"builtin_interfaces/msg/Time", "builtin_interfaces/msg/Duration"}


@dataclass(frozen=True, slots=True)
class TreeRow:
    """Row of a tree."""

    path: str  #: `pose.position.x`, `ranges[3]`
    name: str  #: the last part of the path
    depth: int
    type: str
    text: str  #: the value; empty if the rows of its fields follow
    is_number: bool = False


def number(value: float) -> str:
    """Return the text of a number. A float has six significant digits."""
    if isinstance(value, bool):
        return str(value).lower()
    return f"{value:.6g}" if isinstance(value, float) else str(value)


def brief(message: Any, longest: int = 80) -> str:
    """Return a message on one line, cut to a length, e.g. `x: 5.54, y: 5.54, theta: 0`."""
    fields = fields_of(message)
    if len(fields) == 1:
        text = _brief_value(getattr(message, fields[0].name), longest)
    else:
        text = _brief_fields(message, longest)
    return text if len(text) <= longest else text[: longest - 1] + "…"


def _brief_fields(message: Any, longest: int) -> str:
    parts: list[str] = []
    length = 0
    # One line has no space for a header.
    fields = [field for field in fields_of(message) if field.type.base != _HEADER] or fields_of(
        message
    )
    for field in fields:
        parts.append(f"{field.name}: {_brief_value(getattr(message, field.name), longest)}")
        length += len(parts[-1]) + 2
        if length > longest:
            break
    return ", ".join(parts)


def _brief_value(value: Any, longest: int) -> str:
    if is_message(value):
        return f"{{{_brief_fields(value, longest)}}}"
    if isinstance(value, str):
        return value[: longest + 1]
    if isinstance(value, (int, float)):
        return number(value)
    count = len(value)
    if isinstance(value, bytes) or count > 8:
        return f"[{count} elements]"
    return f"[{', '.join(_brief_value(_plain(item), longest) for item in value)}]"


def _plain(value: Any) -> Any:
    """Return a NumPy number as a Python number."""
    return value.item() if hasattr(value, "item") else value


def tree(message: Any) -> list[TreeRow]:
    """Return a row for each field of a message. The fields of an inner message follow its row."""
    rows: list[TreeRow] = []
    for row in _rows(message, "", 0):
        rows.append(row)
        if len(rows) >= MOST_ROWS:
            rows.append(TreeRow("…", "…", 0, "", "more fields are not shown"))
            break
    return rows


def _rows(message: Any, prefix: str, depth: int) -> Iterator[TreeRow]:
    for field in fields_of(message):
        value = getattr(message, field.name)
        yield from _field(f"{prefix}{field.name}", field.name, field.type, value, depth)


def _field(path: str, name: str, kind: FieldType, value: Any, depth: int) -> Iterator[TreeRow]:
    if kind.kind != "scalar":
        yield from _list(path, name, kind, value, depth)
    elif kind.base in _TIMES:
        yield TreeRow(path, name, depth, kind.text, f"{value.sec}.{value.nanosec:09}")
    elif kind.is_message:
        yield TreeRow(path, name, depth, kind.text, "")
        yield from _rows(value, f"{path}.", depth + 1)
    else:
        yield TreeRow(path, name, depth, kind.text, _scalar(value), _is_number(value))


def _list(path: str, name: str, kind: FieldType, values: Any, depth: int) -> Iterator[TreeRow]:
    count = len(values)
    yield TreeRow(path, name, depth, kind.text, f"[{count}]" if count else "[]")
    if isinstance(values, bytes) and count > MOST_ELEMENTS:
        return  # bytes, for example of an image
    element = type(kind)(kind.base, "scalar", 0, kind.string_bound)
    for index in range(min(count, MOST_ELEMENTS)):
        inner = f"[{index}]"
        yield from _field(f"{path}{inner}", inner, element, _plain(values[index]), depth + 1)
    if count > MOST_ELEMENTS:
        more = f"and {count - MOST_ELEMENTS} more"
        yield TreeRow(f"{path}[…]", "…", depth + 1, "", more)


def _scalar(value: Any) -> str:
    if isinstance(value, str):
        return value if len(value) <= _LONGEST_TEXT else value[:_LONGEST_TEXT] + "…"
    if isinstance(value, bytes):
        return str(value[0]) if len(value) == 1 else value.hex(" ")
    return number(value)


def _is_number(value: Any) -> bool:
    return isinstance(value, (int, float))


def duration(seconds: float) -> str:
    """Return a duration in full seconds, minutes or hours, e.g. `12 s`."""
    if seconds < 100:
        return f"{max(0.0, seconds):.0f} s"
    return f"{seconds / 60:.0f} min" if seconds < 6000 else f"{seconds / 3600:.0f} h"


def amount(value: float, unit: str) -> str:
    """Return a quantity with three digits and a prefix, e.g. `1.23 kB/s`, or no text for 0."""
    if value <= 0:
        return ""
    prefixes = ["", "k", "M", "G"]
    while value >= 999.5 and len(prefixes) > 1:  # 999.6 would be shown as 1000
        value /= 1000
        prefixes.pop(0)
    digits = 0 if value >= 99.95 else 1 if value >= 9.995 else 2
    return f"{value:.{digits}f} {prefixes[0]}{unit}"
