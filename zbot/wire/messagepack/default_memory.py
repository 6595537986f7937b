"""Limit for the memory of values that a message leaves out and that the decoder fills in.

In a message, one byte can stand for an element with default values. Such an element can need
thousands of bytes of memory, so a message of some kilobytes could fill the memory.
"""

from __future__ import annotations

import functools
from typing import TYPE_CHECKING

from zbot.interfaces import get_spec
from zbot.interfaces.default_size import DefaultSize, combined_size
from zbot.wire.validation import Fault

if TYPE_CHECKING:
    from zbot.interfaces.spec import Field

# A message that leaves out nothing needs less than 64 bytes of memory for each of its bytes.
_BYTES_FOR_EACH_BYTE = 64
_BYTES_FOR_EACH_MESSAGE = 16 * 2**20
#: Elements that need fewer bytes of memory are not counted.
_SMALL = 256


class DefaultMemory:
    """Memory that a message of `size` bytes may still use for default values."""

    def __init__(self, size: int) -> None:
        self._left = _BYTES_FOR_EACH_MESSAGE + _BYTES_FOR_EACH_BYTE * size

    def count(self, field: Field, elements: int) -> None:
        """Count the elements of a sequence of messages.

        Raises:
            Fault: The message leaves out so many values that they would need too much memory.
        """
        if field.type.kind != "sequence" or not field.type.is_message:
            return
        octets = _size(field.type.base).octets
        self._left -= octets * elements if octets >= _SMALL else 0
        if self._left < 0:
            raise Fault(field.name, "the messages in it leave out too many values")


@functools.cache
def _size(name: str) -> DefaultSize:
    return combined_size(get_spec(name), _size)
