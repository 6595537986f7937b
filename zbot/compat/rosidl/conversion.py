"""Conversion of messages to ordered dictionaries, YAML and CSV, as in `rosidl_runtime_py`."""

from __future__ import annotations

from collections import OrderedDict
from typing import TYPE_CHECKING, Any

from zbot.interfaces.field_path import is_message
from zbot.interfaces.plain_value import Shortening, csv_values, items_of, plain, shown_item
from zbot.interfaces.yaml_text import dump

if TYPE_CHECKING:
    from zbot.interfaces.slot_type import AbstractType

_NO_LIST_IS_SHORT = -1


def message_to_ordereddict(
    msg: Any,
    *,
    truncate_length: int | None = None,
    no_arr: bool = False,
    no_str: bool = False,
) -> OrderedDict[str, Any]:
    """Return a message as a dictionary of dictionaries, lists, numbers and strings.

    Args:
        msg: The message. A serialized message becomes `{'bytes': msg}`.
        truncate_length: Maximum length of lists and strings. `None` means no limit.
        no_arr: Replace each list by its type and length.
        no_str: Replace each string by its length.
    """
    if isinstance(msg, bytes):
        return OrderedDict(bytes=msg)
    shortening = Shortening(truncate_length, no_arr, no_str, short_list=_NO_LIST_IS_SHORT)
    found: OrderedDict[str, Any] = _ordered(plain(msg, shortening))
    return found


def message_to_yaml(
    msg: Any,
    *,
    truncate_length: int | None = None,
    no_arr: bool = False,
    no_str: bool = False,
    flow_style: bool = False,
) -> str:
    """Return a message as YAML. `flow_style` writes one line. See `message_to_ordereddict`."""
    if isinstance(msg, bytes):
        return dump({"bytes": msg}, flow_style=flow_style)
    shortening = Shortening(truncate_length, no_arr, no_str, short_list=_NO_LIST_IS_SHORT)
    return dump(plain(msg, shortening), flow_style=flow_style)


def message_to_csv(
    msg: Any,
    *,
    truncate_length: int | None = None,
    no_arr: bool = False,
    no_str: bool = False,
) -> str:
    """Return the values of a message, separated by commas. See `message_to_ordereddict`."""
    return ",".join(csv_values(msg, Shortening(truncate_length, no_arr, no_str)))


def get_message_slot_types(msg: Any) -> OrderedDict[str, AbstractType]:
    """Return the types of the fields in order. `msg` is a message or a message class."""
    return OrderedDict(zip(msg.get_fields_and_field_types(), msg.SLOT_TYPES, strict=True))


def convert_value(
    value: Any,
    *,
    truncate_length: int | None = None,
    no_arr: bool = False,
    no_str: bool = False,
) -> Any:
    """Convert a value of any type as `message_to_ordereddict` converts the values of fields."""
    if is_message(value):
        return message_to_ordereddict(
            value, truncate_length=truncate_length, no_arr=no_arr, no_str=no_str
        )
    return _shortened(value, Shortening(truncate_length, no_arr, no_str))


def _shortened(value: Any, shortening: Shortening) -> Any:
    if isinstance(value, dict):
        # Keys are not truncated, because two keys could become equal.
        return {key: _shortened(item, shortening) for key, item in value.items()}
    if isinstance(value, str) and shortening.no_str:
        return f"<string length: <{len(value)}>>"
    if isinstance(value, (str, bytes, bytearray)) or not hasattr(value, "__len__"):
        return shown_item(value, shortening.length)
    kept = value if shortening.length is None else value[: shortening.length]
    items = [_shortened(item, shortening) for item in items_of(kept)]
    if len(kept) < len(value):
        items.append("...")
    return tuple(items) if isinstance(value, tuple) else items


def _ordered(value: Any) -> Any:
    if isinstance(value, dict):
        return OrderedDict((name, _ordered(item)) for name, item in value.items())
    return [_ordered(item) for item in value] if isinstance(value, list) else value
