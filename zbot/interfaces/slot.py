"""Fields of a message class, prepared for a walk over a message: `slots_of`, `walk`."""

from __future__ import annotations

from functools import cached_property, lru_cache
from typing import TYPE_CHECKING, Any

from zbot.interfaces import FieldType, get_message, message_spec_of

if TYPE_CHECKING:
    from collections.abc import Callable

    Leaf = Callable[[Any, "Slot"], Any]

_OCTETS = frozenset({"byte", "char", "uint8"})


class Slot:
    """One field of a message class, or one element of a list.

    Args:
        name: The field's name.
        type: The field's type.

    Attributes:
        is_list: Whether the field is an array or a sequence.
        is_message: Whether the values, or the elements of a list, are messages.
        is_octets: Whether the field is a list of byte, char or uint8.
        is_float: Whether the values, or the elements of a list, are floats.
    """

    def __init__(self, name: str, type: FieldType) -> None:  # noqa: A002 - as in `Field`
        self.name, self.type = name, type
        self.is_list, self.is_message = type.kind != "scalar", type.is_message
        self.is_octets = self.is_list and type.base in _OCTETS
        self.is_float = type.base in {"float32", "float64"}
        #: The type of a single value that needs no conversion and no check.
        self.plain_type = {"float64": float, "bool": bool}.get(type.base)

    @cached_property
    def message_type(self) -> type[Any]:
        """The class of the values, or of the elements of a list. They are messages."""
        return get_message(self.type.base)

    @cached_property
    def element(self) -> Slot:
        """The slot of a list's elements."""
        return Slot(self.name, FieldType(self.type.base, string_bound=self.type.string_bound))

    @cached_property
    def check(self) -> Callable[[str, Any], Any]:
        """The check of the field's values, which is called with the field's path and a value.

        A byte is checked as a number, because plain values have numbers in place of bytes.
        """
        from zbot.interfaces.field_check import field_check  # noqa: PLC0415 - writers need none

        kind = self.type._replace(base="uint8") if self.type.base == "byte" else self.type
        return field_check("", kind, self.message_type if self.is_message else None)

    def has_plain(self, values: list[Any]) -> bool:
        """Return whether all elements of a list are numbers that need no conversion."""
        return self._plain_types.issuperset(map(type, values))

    @cached_property
    def _plain_types(self) -> frozenset[type[Any]]:
        if not (self.type.typecode or self.is_octets):
            return frozenset()
        return frozenset({int, float} if self.is_float else {int})


def _slots_of(message_type: Any) -> dict[str, Slot]:
    fields = message_spec_of(message_type).fields
    return {field.name: Slot(field.name, field.type) for field in fields}


#: Returns the slots of a message class by name, in the order of the definition.
slots_of: Callable[[Any], dict[str, Slot]] = lru_cache(maxsize=512)(_slots_of)


def walk(message: Any, leaf: Leaf) -> dict[str, Any]:
    """Return a message as a dictionary.

    Args:
        message: The message.
        leaf: Function that converts the value of each field that is not itself a message. If the
            field is a list of messages, this function can call `walk` for its elements.
    """
    return {
        name: walk(getattr(message, name), leaf)
        if slot.is_message and not slot.is_list
        else leaf(getattr(message, name), slot)
        for name, slot in slots_of(type(message)).items()
    }
