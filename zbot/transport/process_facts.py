"""Facts about this process that other programs read in its session's admin space."""

from __future__ import annotations

import os
import socket
import sys
import time
from pathlib import Path
from typing import Any

from zbot.transport.process_space import process_space


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
