"""Limit for the memory of values that a message leaves out and that the decoder fills in.

In a message, one byte can stand for an element with default values. Such an element can need
thousands of bytes of memory, so a message of some kilobytes could fill the memory.
"""

from __future__ import annotations

import functools
import threading
from typing import TYPE_CHECKING, Any

from zbot.interfaces import get_spec
from zbot.interfaces.default_size import DefaultSize, combined_size
from zbot.interfaces.spec import MessageSpec
from zbot.wire.validation import Fault

if TYPE_CHECKING:
    from zbot.interfaces.spec import Field

# A message that leaves out nothing needs less than 64 bytes of memory for each of its bytes.
_BYTES_FOR_EACH_BYTE = 64
_BYTES_FOR_EACH_MESSAGE = 16 * 2**20
#: Elements that need fewer bytes of memory are not counted.
_SMALL = 256


class _Memory(threading.local):
    left = 0


_memory = _Memory()


def begin_message(size: int) -> None:
    """Begin a new count in this thread for a message of `size` bytes."""
    _memory.left = _BYTES_FOR_EACH_MESSAGE + _BYTES_FOR_EACH_BYTE * size


def count_elements(field: str, values: Any, octets: int) -> None:
    """Count the messages in a list. One message with default values needs `octets` bytes.

    Raises:
        Fault: The message leaves out so many values that they would need too much memory.
    """
    if type(values) is list:
        _memory.left -= octets * len(values)
        if _memory.left < 0:
            raise Fault(field, "the messages in it leave out too many values")


def large_element(field: Field) -> int:
    """Return the memory of an element of a sequence. Return 0 if elements need not be counted."""
    if field.type.kind != "sequence" or not field.type.is_message:
        return 0
    octets = _size(field.type.base).octets
    return octets if octets >= _SMALL else 0


def has_large_elements(spec: MessageSpec) -> bool:
    """Return whether a message, or a message inside it, has sequences that are counted."""
    return any(
        large_element(field) or _has_large_elements(field.type.base)
        for field in spec.fields
        if field.type.is_message
    )


@functools.cache
def _has_large_elements(name: str) -> bool:
    spec = get_spec(name)
    return isinstance(spec, MessageSpec) and has_large_elements(spec)


@functools.cache
def _size(name: str) -> DefaultSize:
    return combined_size(get_spec(name), _size)
