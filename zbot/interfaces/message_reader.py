"""Reader of messages from plain values, and what it says about values that do not fit.

The reader of this module reads what JSON has: dictionaries, lists, strings, numbers, true, false
and null. Readers of YAML, of forms and of ROS 2's dictionaries are subclasses: they say what a
single value looks like. The walk over the fields, the checks and the sentences are the same.
"""

from __future__ import annotations

import base64
import binascii
import math
import re
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from zbot.errors import ZbotError, shortened
from zbot.errors.suggestion import did_you_mean
from zbot.interfaces.errors import FieldTypeError, FieldValueError
from zbot.interfaces.slot import slots_of

if TYPE_CHECKING:
    from zbot.interfaces.default_size import DefaultMemory
    from zbot.interfaces.slot import Slot

_DECIMAL_COMMA = re.compile(r"[-+]?[0-9]+,[0-9]+([eE][-+]?[0-9]+)?\Z")
_THOUSANDS = re.compile(r"[-+]?[0-9]{1,3}(,[0-9]{3})+\Z")


class FieldMisfitError(ZbotError, ValueError):
    """A plain value does not fit a message.

    Attributes:
        path: The field, e.g. `linear.x`.
    """

    def __init__(self, path: str, text: str, hint: str = "") -> None:
        self.path = path
        super().__init__(text, hint=hint)

    @property
    def sentence(self) -> str:
        """The text and the hint."""
        return f"{self}; {self.hint}" if self.hint else str(self)


class MessageReader:
    """Reader of messages from the values of JSON.

    Missing fields get their defaults. In a field for floats, null means NaN. A field for octets may
    be base64 or a list of numbers. An integer may be written as 1e3.

    Args:
        memory: The memory that values may use that a message leaves out. Text of other machines
            needs it: in such a text, `{}` can stand for thousands of bytes of memory.
    """

    def __init__(self, memory: DefaultMemory | None = None) -> None:
        self._memory = memory

    def message(self, message_type: type[Any], values: Any, path: str = "") -> Any:
        """Return a new message.

        Args:
            message_type: The message's class. It may also be a part of a service or an action.
            values: The values of the fields by name.
            path: The path of the message in the message that contains it.

        Raises:
            FieldMisfitError: The values do not fit.
        """
        message = message_type()
        self.fill(message, values, path)
        return message

    def fill(self, message: Any, values: Any, path: str = "") -> None:
        """Set fields of a message. Raise the errors of `message`."""
        if values.__class__ is not dict and not isinstance(values, Mapping):
            raise self.no_dictionary(message, values, path)
        slots = slots_of(type(message))
        for name, value in values.items():
            slot = slots.get(name)
            if slot is None:
                raise self.unknown_field(message, name, value, path)
            self.set_field(message, slot, value, f"{path}.{name}" if path else name)

    def set_field(self, message: Any, slot: Slot, value: Any, path: str) -> None:
        """Set one field of a message."""
        setattr(message, slot.name, self.value(slot, value, path))

    def value(self, slot: Slot, value: Any, path: str) -> Any:
        """Return the value of a field. Raise the errors of `message`."""
        if slot.is_list:
            return self._list(slot, value, path)
        read = self.nested if slot.is_message else self._scalar
        return read(slot, value, path)

    def nested(self, slot: Slot, value: Any, path: str) -> Any:
        """Return the message of a field, or of one element of a list."""
        return self.message(slot.message_type, value, path)

    def items(self, slot: Slot, value: Any) -> Any:
        """Return the elements of a list. A value that is no list is returned as it is."""
        if slot.is_octets and isinstance(value, str):
            return octets(value)
        return value

    def leaf(self, slot: Slot, value: Any) -> Any:
        """Return a number, a string or a bool. A value that does not fit is returned as it is."""
        if value is None:
            return math.nan if slot.is_float else None  # JSON has no NaN
        if value.__class__ is bool and slot.type.base != "bool":
            return str(value).lower()  # in Python, true is also the number 1
        if value.__class__ is float and value.is_integer() and not slot.is_float:
            return int(value)  # JavaScript writes large integers as 1e21
        return value

    def _scalar(self, slot: Slot, value: Any, path: str) -> Any:
        if value.__class__ is slot.plain_type:
            return value
        found = self.leaf(slot, value)
        if found.__class__ is slot.plain_type:
            return found
        try:
            checked = slot.check(path, found)
        except (FieldTypeError, FieldValueError) as error:
            raise self.misfit(slot, error) from None
        return bytes((checked,)) if slot.type.base == "byte" else checked

    def _list(self, slot: Slot, value: Any, path: str) -> Any:
        items = self.items(slot, value)
        if isinstance(items, list):
            items = self._elements(slot, items, path)
        try:
            checked = slot.check(path, items)
        except (FieldTypeError, FieldValueError) as error:
            raise self.misfit(slot, error) from None
        return [bytes((octet,)) for octet in checked] if slot.type.base == "byte" else checked

    def _elements(self, slot: Slot, items: list[Any], path: str) -> list[Any]:
        if slot.has_plain(items):
            return items
        if self._memory is not None and not self._memory.suffices(slot.type, len(items)):
            raise FieldMisfitError(path, f"the messages in {path} leave out too many values")
        element = slot.element
        read = self.nested if slot.is_message else self._scalar
        found = [read(element, item, f"{path}[{index}]") for index, item in enumerate(items)]
        return [item[0] for item in found] if slot.type.base == "byte" else found

    # -- what does not fit ---------------------------------------------------------------------

    def misfit(self, slot: Slot, error: FieldTypeError | FieldValueError) -> Exception:
        """Return the error for a value that the check of a field has refused."""
        also = "base64 or " if slot.is_octets and error.field[-1:] != "]" else ""
        given = "nothing" if error.value is None else shortened(error.value)
        text = f"{error.field} must be {also}{error.expected}, not {given}"
        hint = _example(slot, error.field, error.value)
        return FieldMisfitError(error.field, text, hint)

    def no_dictionary(self, message: Any, value: Any, path: str) -> Exception:
        """Return the error for a message that is not a dictionary."""
        text = f"Value '{value}' is expected to be a dictionary but is a {type(value).__name__}"
        fields = ", ".join(f"{name}: ..." for name in slots_of(type(message)))
        name = path.rpartition(".")[2]
        hint = f"write {name}: {{{fields}}}" if path else f"write {{{fields}}}"
        return FieldMisfitError(path, text, hint)

    def unknown_field(self, message: Any, name: str, value: Any, path: str) -> Exception:  # noqa: ARG002 - for subclasses
        """Return the error for a field that a message does not have."""
        known = tuple(slots_of(type(message)))
        fields = f"its fields are {', '.join(known)}" if known else "it has no fields"
        text = f"'{type(message).__name__}' object has no attribute '{name}'"
        return FieldMisfitError(path, text, did_you_mean(str(name), known) or fields)


def octets(text: str) -> bytes | str:
    """Return the bytes of a base64 text. A text that is not base64 is returned as it is."""
    try:
        return base64.b64decode(text, validate=True)
    except (binascii.Error, ValueError):
        return text


def number_with_comma(name: str, text: str) -> str:
    """Return what to type for `2,0`, or an empty string if the text is not such a number."""
    if _THOUSANDS.match(text):
        return f"write {name}: {text.replace(',', '')} or {name}: {text.replace(',', '.')}"
    if _DECIMAL_COMMA.match(text):
        return f"write a point, not a comma: {name}: {text.replace(',', '.')}"
    return ""


def _example(slot: Slot, path: str, value: Any) -> str:
    """Return how a value of a field is written."""
    name, kind = path.rpartition(".")[2], slot.type
    if slot.is_list:
        is_one = isinstance(value, (str, int, float)) and not slot.is_message
        return f"{path} is {kind.text}: write {name}: [{value if is_one else '...'}]"
    if kind.is_string:
        return "" if isinstance(value, str) else f"put the text of {path} in quotes"
    if isinstance(value, str) and (hint := number_with_comma(name, value)):
        return hint
    article = "an" if kind.base.startswith("i") else "a"
    example = {"bool": "true", "float32": "1.5", "float64": "1.5"}.get(kind.base, "2")
    return f"{path} is {article} {kind.base}: write {name}: {example}"
