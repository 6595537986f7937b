"""The processes of this launch as a whole: none of them outlives it.

On POSIX each process leads a group of its own, with whatever it starts, and a guardian process ends
the groups if the launch is killed. On Windows a job object does that, for all that this process
starts.
"""

from __future__ import annotations

import os
import signal
import subprocess
import sys
from pathlib import Path
from typing import Any

_GUARDIAN = str(Path(__file__).with_name("guardian.py"))


class ProcessGroup:
    """Knows the process groups of a launch, and lets the guardian know."""

    def __init__(self) -> None:
        self._groups: set[int] = set()
        self._guardian: subprocess.Popen[str] | None = None

    def prepare(self) -> None:
        """Make sure that what starts from now on ends with this process."""
        if os.name == "nt":
            _join_job()
        elif self._guardian is None:
            self._guardian = subprocess.Popen(  # noqa: S603 - our own file
                [sys.executable, "-I", "-S", _GUARDIAN],
                stdin=subprocess.PIPE,
                text=True,
                bufsize=1,
                start_new_session=True,
            )

    def add(self, group: int) -> None:
        """Let a process group end with the launch."""
        self._groups.add(group)
        self._tell(f"+{group}")

    def discard(self, group: int) -> None:
        """Forget a group whose leader ended, unless others are left in it."""
        if group in self._groups and not send(group, 0):
            self._groups.discard(group)
            self._tell(f"-{group}")

    def close(self) -> None:
        """Have the guardian end what is left."""
        for group in list(self._groups):
            self.discard(group)
        guardian, self._guardian = self._guardian, None
        if guardian is not None and guardian.stdin is not None:
            guardian.stdin.close()
            guardian.wait()

    def _tell(self, line: str) -> None:
        if self._guardian is not None and self._guardian.stdin is not None:
            try:
                self._guardian.stdin.write(f"{line}\n")
            except BrokenPipeError:
                self._guardian = None  # somebody killed it; the launch works without


def send(group: int, number: int) -> bool:
    """Send a signal to a process group; return whether there is anybody in it."""
    try:
        if sys.platform == "win32":
            os.kill(group, signal.SIGTERM)
        else:
            os.killpg(group, number)
    except (ProcessLookupError, PermissionError):
        return False
    return True


_job: list[Any] = []


def _join_job() -> None:
    """Put this process into a job object that ends its processes when its last handle closes."""
    if _job or sys.platform != "win32":
        return
    import ctypes  # noqa: PLC0415 - only Windows needs it

    kernel32 = ctypes.windll.kernel32
    kernel32.CreateJobObjectW.restype = ctypes.c_void_p
    kernel32.GetCurrentProcess.restype = ctypes.c_void_p
    job = ctypes.c_void_p(kernel32.CreateJobObjectW(None, None))
    # JOBOBJECT_EXTENDED_LIMIT_INFORMATION, of which only LimitFlags is set.
    information = (ctypes.c_byte * (144 if ctypes.sizeof(ctypes.c_void_p) == 8 else 112))()
    ctypes.memmove(ctypes.byref(information, 16), ctypes.byref(ctypes.c_uint32(0x2000)), 4)
    extended, size = 9, ctypes.sizeof(information)
    kernel32.SetInformationJobObject(job, extended, ctypes.byref(information), size)
    kernel32.AssignProcessToJobObject(job, ctypes.c_void_p(kernel32.GetCurrentProcess()))
    _job.append(job)
