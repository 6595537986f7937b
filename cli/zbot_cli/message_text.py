"""Messages as text: YAML as `ros2 topic echo` prints it, CSV, JSON, or one field."""

from __future__ import annotations

import array
import base64
import json
import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from zbot.field_path import FieldPath, fields_of, is_message
from zbot_cli.yaml_text import Flow, dump

if TYPE_CHECKING:
    from collections.abc import Iterator

    from zbot.interfaces import FieldType
    from zbot.subscription import MessageInfo

SEPARATOR = "---\n"
#: Numeric lists up to this long stand on one line: a 6x6 covariance does, a scan does not.
SHORT_LIST = 36
_OCTETS = {"byte", "char", "uint8"}
_QUOTED_IN_CSV = frozenset(',"\r\n')


@dataclass(frozen=True)
class Form:
    """How messages are shown; `length` is `None` for everything."""

    csv: bool = False
    fields: tuple[str, ...] = ()
    length: int | None = 128
    no_arr: bool = False
    no_str: bool = False
    flow_style: bool = False
    raw: bool = False
    filter_expression: str | None = None
    with_info: bool = False
    clear: bool = False
    json: bool = False
    losses: bool = True


class Formatter:
    """Turns messages into text, each ending with a newline.

    Args:
        form: How they are to look.
        with_topic: Whether they come from several topics and have to say from which.

    Raises:
        FieldPathError: A field of the form is no path.
    """

    def __init__(self, form: Form, *, with_topic: bool = False) -> None:
        self._form = form
        self._with_topic = with_topic
        self._paths = [FieldPath(text) for text in form.fields]

    def check(self, message_type: type[Any]) -> None:
        """Refuse fields that no message of a type has.

        Raises:
            FieldPathError: There is one.
        """
        if not self._form.raw:
            for path in self._paths:
                path.check(message_type)

    def subject(self, message: Any) -> Any:
        """Return what a filter calls `m`: the message, or the one field that is shown."""
        return self._paths[0].select(message) if len(self._paths) == 1 else message

    def text(self, topic: str, message: Any, info: MessageInfo) -> str:
        """Return a message as text.

        Args:
            topic: The topic that it came from.
            message: The message; its bytes if the form is raw.
            info: When it was sent and received.
        """
        form = self._form
        if form.json and not form.raw:
            return self._json_line(topic, message, info)
        head = f"# {topic}\n" if self._with_topic and not form.csv else ""
        if form.raw:
            return head + _info_text(form, info) + f"{message}\n{SEPARATOR}"
        parts = [path.select(message) for path in self._paths] or [message]
        if not form.csv:
            return head + "".join(_yaml_text(form, part, info) for part in parts)
        head = f"{topic}," if self._with_topic else ""
        return "".join(head + _csv_line(form, part, info) for part in parts)

    def _json_line(self, topic: str, message: Any, info: MessageInfo) -> str:
        parts = [json_value(path.select(message)) for path in self._paths] or [json_value(message)]
        value = parts[0] if len(parts) == 1 else parts
        if self._form.with_info:
            value = {"topic": topic, "info": dict(info), "message": value}
        elif self._with_topic:
            value = {"topic": topic, "message": value}
        return json.dumps(value, ensure_ascii=False, allow_nan=False) + "\n"


# -- YAML ----------------------------------------------------------------------------------------


def _yaml_text(form: Form, value: Any, info: MessageInfo) -> str:
    return _info_text(form, info) + _value_text(form, value) + SEPARATOR


def _value_text(form: Form, value: Any) -> str:
    if is_message(value):
        return dump(plain(value, form))
    if isinstance(value, (str, bytes)) or not hasattr(value, "__len__"):
        return f"{_shown_item(value, None)}\n"
    items = _items(value)
    if items and is_message(items[0]):
        return dump([plain(item, form) for item in items])
    # What was asked for by name is shown whole, and on one line.
    return dump(Flow(_shown_item(item, None) for item in items))


def _info_text(form: Form, info: MessageInfo) -> str:
    return dump(dict(sorted(info.items()))) + SEPARATOR if form.with_info else ""


def plain(message: Any, form: Form) -> dict[str, Any]:
    """Return a message as a dictionary of what YAML can write, shortened as the form says."""
    return {
        field.name: _plain_value(getattr(message, field.name), field.type, form)
        for field in fields_of(message)
    }


def _plain_value(value: Any, kind: FieldType, form: Form) -> Any:
    if kind.kind != "scalar":
        return _array_label(value, kind) if form.no_arr else _shown_list(value, kind, form)
    if kind.is_message:
        return plain(value, form)
    if form.no_str and kind.is_string:
        return f"<string length: <{len(value)}>>"
    return _shown_item(value, form.length)


def _shown_item(item: Any, length: int | None) -> Any:
    if isinstance(item, (bytes, bytearray)):
        item = item.decode("latin-1")  # each byte as the character of that number
    if isinstance(item, str):
        is_long = length is not None and len(item) > length
        return item[:length] + "..." if is_long else item
    return item.item() if hasattr(item, "item") else item


def _array_label(value: Any, kind: FieldType) -> str:
    base = kind.base
    if not (kind.is_message or kind.is_string):
        base = str(type(kind)(base))  # as IDL calls it: double, octet
    if kind.kind == "array":
        return f"<array type: {base}[{kind.size}]>"
    bound = f"[{kind.size}]" if kind.size else ""
    return f"<sequence type: {base}{bound}, length: {len(value)}>"


def _shown_list(value: Any, kind: FieldType, form: Form) -> list[Any]:
    shown = value if form.length is None else value[: form.length]
    items = _items(shown)
    if kind.is_message:
        items = [plain(item, form) for item in items]
    elif not kind.typecode:
        one = type(kind)(kind.base)
        items = [_plain_value(item, one, form) for item in items]
    if len(shown) < len(value):
        items.append("...")
    is_short = kind.typecode and len(value) <= SHORT_LIST
    return Flow(items) if form.flow_style or is_short else items


def _items(value: Any) -> list[Any]:
    items: list[Any] = value.tolist() if hasattr(value, "tolist") else list(value)
    return items


# -- CSV -----------------------------------------------------------------------------------------


def _csv_line(form: Form, value: Any, info: MessageInfo) -> str:
    head: tuple[int, ...] = ()
    if form.with_info:
        head = (
            info["source_timestamp"],
            info["received_timestamp"],
            info["publication_sequence_number"],
            info["reception_sequence_number"],
        )
    return ",".join((*map(str, head), *_leaves(value, form))) + "\n"


def _leaves(value: Any, form: Form) -> Iterator[str]:
    if is_message(value):
        for field in fields_of(value):
            item = getattr(value, field.name)
            if form.no_arr and field.type.kind != "scalar":
                yield _array_label(item, field.type)
            else:
                yield from _leaves(item, form)
    elif isinstance(value, str):
        text = f"<string length: <{len(value)}>>" if form.no_str else value
        yield _quoted(_shown_item(text, form.length))
    elif isinstance(value, (bytes, bytearray)) or not hasattr(value, "__len__"):
        yield str(value)
    else:
        shown = value if form.length is None else value[: form.length]
        for item in _items(shown):
            yield from _leaves(item, form)
        if len(shown) < len(value):
            yield "..."


def _quoted(text: str) -> str:
    if _QUOTED_IN_CSV.isdisjoint(text):
        return text
    return '"' + text.replace('"', '""') + '"'


# -- JSON ----------------------------------------------------------------------------------------


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
