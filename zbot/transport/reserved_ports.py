"""Ranges of TCP ports that the operating system reserves, for the report of `zbot doctor`."""

from __future__ import annotations

import contextlib
import re
import subprocess
import sys
from pathlib import Path

_LINUX = Path("/proc/sys/net/ipv4/ip_unprivileged_port_start")
_NETSH = ["netsh", "interface", "ipv4", "show", "excludedportrange", "protocol=tcp"]
_TIMEOUT_S = 5.0


def reserved_range(port: int) -> str:
    """Return which ports around a port the system reserves, and the command that shows it."""
    if sys.platform == "win32":
        return f"{_windows_range(port)} (`{' '.join(_NETSH)}` shows it)"
    with contextlib.suppress(OSError, ValueError):
        first = int(_LINUX.read_text(encoding="ascii"))
        if port < first:
            return f"ports below {first} (`sysctl net.ipv4.{_LINUX.name}` shows it)"
    return f"port {port}"


def _windows_range(port: int) -> str:
    with contextlib.suppress(OSError, subprocess.SubprocessError):
        done = subprocess.run(  # noqa: S603 - fixed words
            _NETSH,
            capture_output=True,
            text=True,
            check=False,
            timeout=_TIMEOUT_S,
            errors="replace",
        )
        return range_in(done.stdout, port)
    return f"port {port}"


def range_in(table: str, port: int) -> str:
    """Return the range with a port in the table that Windows prints, whatever its language."""
    for first, last in re.findall(r"^\s*(\d{1,5})\s+(\d{1,5})\b", table, re.MULTILINE):
        if int(first) <= port <= int(last):
            return f"ports {first} to {last}"
    return f"port {port}"
