"""Attachment of a message: 33 bytes with its number, time and sender, in rmw_zenoh's layout."""

from __future__ import annotations

from struct import Struct
from typing import NamedTuple

__all__ = ["GID_LENGTH", "LAYOUT", "NUMBER", "Attachment", "pack", "unpack"]

GID_LENGTH = 16
# The single byte is the gid's length, because rmw_zenoh writes an array's length before its bytes.
LAYOUT = Struct("<qqB16s")
NUMBER = Struct("<q")  #: the first field


class Attachment(NamedTuple):
    """Metadata that a sender adds to one message."""

    sequence_number: int  #: counts the sender's messages, from 1
    source_ns: int  #: time of sending by the sender's clock, in nanoseconds since the Unix epoch
    gid: bytes  #: the sending endpoint's id, 16 bytes


def pack(sequence_number: int, source_ns: int, gid: bytes) -> bytes:
    """Return the attachment's 33 bytes."""
    return LAYOUT.pack(sequence_number, source_ns, GID_LENGTH, gid)


def unpack(data: bytes | bytearray | memoryview | None) -> Attachment | None:
    """Return the attachment in `data`. Return None if `data` has another format.

    Any Zenoh program may publish on a topic, so an unknown attachment is not an error.
    """
    if data is None or len(data) != LAYOUT.size:
        return None
    sequence_number, source_ns, length, gid = LAYOUT.unpack(data)
    if length != GID_LENGTH or sequence_number < 0 or source_ns < 0:
        return None
    return Attachment(sequence_number, source_ns, gid)
