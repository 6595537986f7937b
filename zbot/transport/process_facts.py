"""Facts about this process that other programs read in its session's admin space, and its space."""

from __future__ import annotations

import os
import socket
import sys
import time
import zlib
from pathlib import Path
from typing import Any

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


def process_facts(version: str) -> dict[str, Any]:
    """Return the facts about this process, for a session's admin space (see docs/wire.md)."""
    return {
        "zbot": {
            "version": version,
            "host": socket.gethostname(),
            "pid": os.getpid(),
            "space": process_space(),
            "started": time.time_ns(),
            "command": command_line(),
        }
    }


def command_line() -> str:
    """Return the command line of this process, with the program's name and without its folder."""
    command = " ".join([Path(sys.argv[0]).name, *sys.argv[1:]]) if sys.argv else ""
    # Python replaces bytes that are not UTF-8 by surrogate characters. Zenoh's JSON parser refuses
    # these characters.
    return command.encode(errors="replace").decode()
