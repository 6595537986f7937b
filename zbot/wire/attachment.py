"""The 33 bytes that travel beside every message: number, time and sender, laid out as in ROS 2."""

from __future__ import annotations

from struct import Struct
from typing import NamedTuple

__all__ = ["GID_LENGTH", "LAYOUT", "Attachment", "pack", "unpack"]

GID_LENGTH = 16
# The lone byte is the gid's length: rmw_zenoh serialises an array of bytes with its length first.
LAYOUT = Struct("<qqB16s")


class Attachment(NamedTuple):
    """What a sender says about one message."""

    sequence_number: int  #: from 1, one more with each message of the same sender
    source_ns: int  #: when it was sent, nanoseconds since the Unix epoch by the sender's clock
    gid: bytes  #: the sending endpoint's 16 bytes


def pack(sequence_number: int, source_ns: int, gid: bytes) -> bytes:
    """Return the attachment's 33 bytes."""
    return LAYOUT.pack(sequence_number, source_ns, GID_LENGTH, gid)


def unpack(data: bytes | bytearray | memoryview | None) -> Attachment | None:
    """Return the facts of an attachment; None where it is absent or not ours.

    Any Zenoh program may publish on a topic, so a foreign attachment is no error.
    """
    if data is None or len(data) != LAYOUT.size:
        return None
    sequence_number, source_ns, length, gid = LAYOUT.unpack(data)
    if length != GID_LENGTH or sequence_number < 0 or source_ns < 0:
        return None
    return Attachment(sequence_number, source_ns, gid)
