"""Freezer of a process: it does nothing and answers nothing, but its state is not `stopped`.

A process in a deadlock looks the same. Needs Linux with control groups of version 2, and root.
"""

from __future__ import annotations

import contextlib
import os
from pathlib import Path

_ROOTS = (Path("/sys/fs/cgroup"), Path("/sys/fs/cgroup/unified"))


class Freezer:
    """A control group for frozen processes, which is removed at the end of the block."""

    def __init__(self) -> None:
        self._folder: Path | None = None

    def __enter__(self) -> Freezer:
        for root in _ROOTS:
            folder = root / f"zbot-torture-{os.getpid()}"
            with contextlib.suppress(OSError):
                folder.mkdir()
                if (folder / "cgroup.freeze").exists():
                    self._folder = folder
                    return self
                folder.rmdir()
        return self

    def __exit__(self, *_: object) -> None:
        if self._folder is not None:
            self._write("cgroup.freeze", "0")
            with contextlib.suppress(OSError):
                for number in (self._folder / "cgroup.procs").read_text().split():
                    os.kill(int(number), 9)
                self._folder.rmdir()

    @property
    def works(self) -> bool:
        """Whether this machine can freeze processes."""
        return self._folder is not None

    def freeze(self, pid: int) -> None:
        """Freeze a process. It can be killed, but not continued."""
        self._write("cgroup.procs", str(pid))
        self._write("cgroup.freeze", "1")

    def _write(self, name: str, text: str) -> None:
        if self._folder is not None:
            with contextlib.suppress(OSError):  # the process has ended
                (self._folder / name).write_text(text, encoding="ascii")
