"""Size of a message with default values, and the memory that such values may use."""

from __future__ import annotations

import functools
from typing import TYPE_CHECKING, NamedTuple

from zbot.interfaces.registry import get_spec
from zbot.interfaces.spec import MessageSpec

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.interfaces.spec import FieldType, InterfaceSpec

# Memory of CPython's objects, rounded.
_MESSAGE_BYTES, _ARRAY_BYTES, _REFERENCE_BYTES = 64, 120, 8
# A message that leaves out nothing needs less than 64 bytes of memory for each of its bytes.
_BYTES_FOR_EACH_BYTE = 64
_BYTES_FOR_EACH_MESSAGE = 16 * 2**20
#: Elements that need fewer bytes of memory are not counted.
_SMALL = 256
_ITEM_BYTES = {"b": 1, "B": 1, "h": 2, "H": 2, "i": 4, "I": 4, "f": 4}


class DefaultSize(NamedTuple):
    """Size of a message with default values."""

    octets: int = 0  #: bytes of memory, approximately
    messages: int = 0  #: number of messages: this message and all messages inside it
    levels: int = 0  #: depth, 1 for a message without messages inside


def combined_size(spec: InterfaceSpec, find: Callable[[str], DefaultSize]) -> DefaultSize:
    """Return the size of a message. `find` returns the sizes of the types inside it."""
    fields = spec.fields if isinstance(spec, MessageSpec) else ()
    octets, messages, levels = _MESSAGE_BYTES + _REFERENCE_BYTES * len(fields), 1, 0
    for field in fields:
        kind = field.type
        inner = find(kind.base) if kind.is_message else DefaultSize()
        octets += _octets(kind, inner.octets)
        messages += _count(kind) * inner.messages
        levels = max(levels, inner.levels)
    return DefaultSize(octets, messages, levels + 1)


def _count(kind: FieldType) -> int:
    """Return the number of values of a field that has its default value."""
    return {"scalar": 1, "array": kind.size, "sequence": 0}[kind.kind]


def _octets(kind: FieldType, each: int) -> int:
    count = _count(kind)
    if kind.kind == "scalar":
        return each
    if kind.typecode:
        return _ARRAY_BYTES + count * _ITEM_BYTES.get(kind.typecode, 8)
    return _ARRAY_BYTES + count * (_REFERENCE_BYTES + each)


class DefaultMemory:
    """Memory that a message of `size` bytes may still use for default values.

    Args:
        size: The message's length in bytes. Each byte allows 64 bytes of memory.
        each: Bytes of memory that each message may use in addition.

    In a message, one byte can stand for an element with default values. Such an element can need
    thousands of bytes of memory, so a message of some kilobytes could fill the memory.
    """

    def __init__(self, size: int, each: int = _BYTES_FOR_EACH_MESSAGE) -> None:
        self._left = each + _BYTES_FOR_EACH_BYTE * size

    def suffices(self, kind: FieldType, elements: int) -> bool:
        """Count the elements of a list. Return False if they would need too much memory."""
        if kind.kind == "sequence" and kind.is_message:
            octets = _size_of(kind.base).octets
            self._left -= octets * elements if octets >= _SMALL else 0
        return self._left >= 0


@functools.cache
def _size_of(name: str) -> DefaultSize:
    return combined_size(get_spec(name), _size_of)
