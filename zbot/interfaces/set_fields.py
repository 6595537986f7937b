"""Function that sets the fields of a message: `set_message_fields`."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING, Any

from zbot.errors.suggestion import did_you_mean
from zbot.interfaces import get_message, type_name
from zbot.interfaces.errors import FieldValueError
from zbot.interfaces.field_path import is_message

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping
    from typing import TypeAlias

    StampSetter: TypeAlias = Callable[[Any], None]

_HEADER = "std_msgs/msg/Header"
_TIME = "builtin_interfaces/msg/Time"


def set_message_fields(
    msg: Any,
    values: Mapping[str, Any],
    expand_header_auto: bool = False,
    expand_time_now: bool = False,
) -> list[StampSetter]:
    """Set fields of a message. The other fields keep their values.

    Args:
        msg: The message, of any class that has ROS 2's attributes.
        values: New values by field name. For a field that is a message, the value is a message or a
            dictionary. Fields that are missing in such an inner dictionary get their defaults.
        expand_header_auto: Whether the string `auto` means a header with the current time.
        expand_time_now: Whether the string `now` means the current time.

    Returns:
        One function for each field that needs the current time. Call it with a `Time` message.

    Raises:
        AttributeError: The message has no field with a given name.
        TypeError: `values` is not a dictionary, or a value has the wrong type.
        FieldValueError: A value is out of range, or a string is not a number. This error is a
            ValueError.
    """
    return _FieldSetter(header_auto=expand_header_auto, time_now=expand_time_now).fill(msg, values)


class _FieldSetter:
    def __init__(self, *, header_auto: bool, time_now: bool) -> None:
        self._texts = {_HEADER: "auto" if header_auto else None, _TIME: "now" if time_now else None}
        self._setters: list[StampSetter] = []

    def fill(self, message: Any, values: Any) -> list[StampSetter]:
        if not hasattr(values, "items"):
            kind = type(values).__name__
            raise TypeError(f"Value '{values}' is expected to be a dictionary but is a {kind}")
        slots = dict(zip(message.get_fields_and_field_types(), message.SLOT_TYPES, strict=True))
        for name, value in values.items():
            if name not in slots:
                raise AttributeError(
                    f"'{type(message).__name__}' object has no attribute '{name}'"
                    f"{did_you_mean(name, slots, before='; ')}"
                )
            self._set(message, name, slots[name], value)
        return self._setters

    def _set(self, message: Any, name: str, slot: Any, value: Any) -> None:
        present = getattr(message, name)
        if isinstance(value, str) and is_message(present):
            self._expand(message, name, present, value)
        elif is_message(present):
            setattr(message, name, self._message(type(present), value))
        elif hasattr(slot, "value_type"):
            setattr(message, name, self._elements(slot.value_type, value))
        else:
            setattr(message, name, _scalar(message, name, type(present), value))

    def _expand(self, message: Any, name: str, present: Any, text: str) -> None:
        kind = type_name(type(present))
        if text != self._texts.get(kind):
            self.fill(present, text)  # raises TypeError
        owner, stamp = (message, name) if kind == _TIME else (present, "stamp")
        self._setters.append(partial(setattr, owner, stamp))

    def _elements(self, element: Any, values: Any) -> Any:
        if not hasattr(element, "namespaces"):
            return values
        cls = get_message("/".join((*element.namespaces, element.name)))
        return [self._message(cls, value) for value in values]

    def _message(self, cls: type[Any], value: Any) -> Any:
        if isinstance(value, cls):
            return value
        message = cls()
        self.fill(message, value)
        return message


def _scalar(message: Any, name: str, kind: type[Any], value: Any) -> Any:
    if isinstance(value, kind):
        return value
    try:
        # A `byte` field stores one byte, but bytes(7) would be seven zero bytes.
        return bytes([value]) if kind is bytes else kind(value)
    except ValueError as error:
        expected = f"of the type {message.get_fields_and_field_types()[name]}"
        raise FieldValueError(type_name(type(message)), name, expected, value) from error
