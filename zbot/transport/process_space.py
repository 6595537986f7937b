"""Space of this process: the processes that see the same process ids and the same ports.

Programs of one user can have one home folder, but run on several machines, in several containers or
in several network namespaces. A process id or a port in a file of this folder means something only
in the space of the program that wrote it.
"""

from __future__ import annotations

import os
import socket
import sys
import zlib
from pathlib import Path

_BOOT = Path("/proc/sys/kernel/random/boot_id")
_NAMESPACES = Path("/proc/self/ns")


def process_space() -> str:
    """Return the name of the space: the name of the machine, and on Linux a number after it.

    The number differs between two starts of a machine, and between two namespaces of process ids
    or of the network.
    """
    host = socket.gethostname()
    if sys.platform != "linux":
        return host
    try:
        parts = [_BOOT.read_text(encoding="ascii").strip()]
        parts += [str((_NAMESPACES / name).stat().st_ino) for name in ("net", "pid")]
    except OSError:  # /proc belongs to other processes, so this process knows only itself
        parts = [str(os.getpid())]
    return f"{host}-{zlib.crc32(' '.join(parts).encode()):08x}"
