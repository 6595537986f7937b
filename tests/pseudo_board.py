"""Board of a test: the other end of a pseudo-terminal, under a name that stays."""

from __future__ import annotations

import os
import tty
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from pathlib import Path


class PseudoBoard:
    """A board that can be unplugged and plugged in again.

    Args:
        path: The name of the port.
    """

    def __init__(self, path: Path) -> None:
        self.path = path
        self._ends: tuple[int, int] = (-1, -1)
        self.plug_in()

    @property
    def port(self) -> str:
        return str(self.path)

    def plug_in(self) -> None:
        board, port = os.openpty()
        tty.setraw(port)
        self._ends = board, port
        self.path.symlink_to(os.ttyname(port))

    def unplug(self) -> None:
        self.path.unlink(missing_ok=True)
        for end in self._ends:
            os.close(end)

    def print(self, *lines: str) -> None:
        self.write("".join(f"{line}\r\n" for line in lines).encode())

    def write(self, data: bytes) -> None:
        while data:
            data = data[os.write(self._ends[0], data) :]

    def read_line(self) -> str:
        """Return the next line that the computer writes."""
        line = b""
        while not line.endswith(b"\n"):
            line += os.read(self._ends[0], 1)
        return line.decode().rstrip("\n")
