"""Count of the bytes of a port that the system has lost before a program could read them."""

from __future__ import annotations

import struct
import sys
from typing import Any

_TIOCGICOUNT = 0x545D
#: The kernel's `serial_icounter_struct`: 11 counts, and 9 numbers without a meaning.
_COUNTS = struct.Struct("20i")
_OVERRUN, _BUFFER_OVERRUN = 7, 10


def lost_bytes(opened: Any) -> int:
    """Return how many times a port was full since the system started.

    It is 0 if the system does not count: Windows, macOS, and ports that are not hardware.

    Args:
        opened: pyserial's object of an open port.
    """
    if sys.platform != "linux":
        return 0
    import fcntl  # noqa: PLC0415 - Windows has none

    try:
        answer = fcntl.ioctl(opened.fileno(), _TIOCGICOUNT, bytes(_COUNTS.size))
    except OSError:
        return 0
    counts = _COUNTS.unpack(answer)
    return int(counts[_OVERRUN] + counts[_BUFFER_OVERRUN])
