"""Function that sets the fields of a message: `set_message_fields`."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING, Any

from zbot.interfaces import type_name
from zbot.interfaces.errors import FieldValueError
from zbot.interfaces.message_reader import FieldMisfitError, MessageReader

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping
    from typing import TypeAlias

    from zbot.interfaces.slot import Slot

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
    reader = _FieldSetter(header_auto=expand_header_auto, time_now=expand_time_now)
    reader.fill(msg, values)
    return reader.setters


class _FieldSetter(MessageReader):
    """Reader of ROS 2's dictionaries. Their values may be messages, and texts of numbers."""

    def __init__(self, *, header_auto: bool, time_now: bool) -> None:
        super().__init__()
        self._texts = {_HEADER: "auto" if header_auto else None, _TIME: "now" if time_now else None}
        self.setters: list[StampSetter] = []

    def set_field(self, message: Any, slot: Slot, value: Any, path: str) -> None:
        present = getattr(message, slot.name)
        if slot.is_list:
            found = value
            if slot.is_message:
                found = [self._message(slot.message_type, item, path) for item in value]
        elif not slot.is_message:
            found = _scalar(message, slot, type(present), value)
        elif isinstance(value, str):
            self._expand(message, slot, value, path)
            return
        else:
            found = self._message(type(present), value, path)
        setattr(message, slot.name, found)

    def _message(self, cls: type[Any], value: Any, path: str) -> Any:
        return value if isinstance(value, cls) else self.message(cls, value, path)

    def no_dictionary(self, message: Any, value: Any, path: str) -> Exception:
        return TypeError(str(super().no_dictionary(message, value, path)))

    def unknown_field(self, message: Any, name: str, value: Any, path: str) -> Exception:
        error = super().unknown_field(message, name, value, path)
        assert isinstance(error, FieldMisfitError)
        return AttributeError(error.sentence)

    def _expand(self, message: Any, slot: Slot, text: str, path: str) -> None:
        present, kind = getattr(message, slot.name), slot.type.base
        if text != self._texts.get(kind):
            raise self.no_dictionary(present, text, path)
        owner, stamp = (message, slot.name) if kind == _TIME else (present, "stamp")
        self.setters.append(partial(setattr, owner, stamp))


def _scalar(message: Any, slot: Slot, kind: type[Any], value: Any) -> Any:
    if isinstance(value, kind):
        return value
    try:
        # A `byte` field stores one byte, but bytes(7) would be seven zero bytes.
        return bytes([value]) if kind is bytes else kind(value)
    except ValueError as error:
        expected = f"of the type {slot.type}"
        raise FieldValueError(type_name(type(message)), slot.name, expected, value) from error
