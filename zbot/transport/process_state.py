"""State of a process of this machine."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path


def is_stopped(pid: int) -> bool:
    """Return whether a process is stopped, e.g. by Ctrl-Z. It is `False` on Windows."""
    if sys.platform == "win32":
        return False
    try:
        facts = Path(f"/proc/{pid}/stat").read_text(errors="replace")
    except OSError:
        return sys.platform == "darwin" and _state_by_ps(pid).startswith("T")
    # The name of the program, in brackets, may contain blanks and brackets.
    return facts.rpartition(")")[2].split()[:1] == ["T"]


def _state_by_ps(pid: int) -> str:
    ps = ["/bin/ps", "-o", "state=", "-p", str(pid)]
    try:
        return subprocess.run(ps, capture_output=True, text=True, check=False, timeout=2).stdout  # noqa: S603 - fixed words
    except (OSError, subprocess.TimeoutExpired):
        return ""
