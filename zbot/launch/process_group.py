"""Process groups of a launch, which all end when the launch ends.

On POSIX each process leads its own group, which also contains its children. A watchdog process ends
the groups if the launch is killed. On Windows a job object ends all processes of the launch.
"""

from __future__ import annotations

import os
import signal
import subprocess
import sys
from pathlib import Path
from typing import Any

_WATCHDOG = str(Path(__file__).with_name("watchdog.py"))


class ProcessGroups:
    """The process groups of a launch. The watchdog knows the same groups."""

    def __init__(self) -> None:
        self._groups: set[int] = set()
        self._watchdog: subprocess.Popen[str] | None = None

    def prepare(self) -> None:
        """Ensure that the end of this process also ends all processes that start later."""
        if os.name == "nt":
            _join_job()
        elif self._watchdog is None:
            self._watchdog = subprocess.Popen(  # noqa: S603 - a file of this package
                [sys.executable, "-I", "-S", _WATCHDOG],
                stdin=subprocess.PIPE,
                text=True,
                bufsize=1,
                start_new_session=True,
            )

    def add(self, group: int) -> None:
        """Add a process group, so that it ends with the launch."""
        self._groups.add(group)
        self._tell(f"+{group}")

    def discard(self, group: int) -> None:
        """Remove a group whose leader has ended, unless the group has other processes."""
        if group in self._groups and not send(group, 0):
            self._groups.discard(group)
            self._tell(f"-{group}")

    def close(self) -> None:
        """Make the watchdog end the remaining groups, and wait for the watchdog."""
        for group in list(self._groups):
            self.discard(group)
        watchdog, self._watchdog = self._watchdog, None
        if watchdog is not None and watchdog.stdin is not None:
            watchdog.stdin.close()
            watchdog.wait()

    def _tell(self, line: str) -> None:
        if self._watchdog is not None and self._watchdog.stdin is not None:
            try:
                self._watchdog.stdin.write(f"{line}\n")
            except BrokenPipeError:
                self._watchdog = None  # the watchdog was killed, and the launch works without it


def send(group: int, number: int) -> bool:
    """Send a signal to a process group. Return whether the group contains a process.

    On Windows, end the process `group`, because Windows has no signals.
    """
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
    """Put this process into a job object.

    When the job's handle closes, all processes of the job end.
    """
    if _job or sys.platform != "win32":
        return
    import ctypes  # noqa: PLC0415 - only Windows needs it

    kernel32 = ctypes.windll.kernel32
    kernel32.CreateJobObjectW.restype = ctypes.c_void_p
    kernel32.GetCurrentProcess.restype = ctypes.c_void_p
    job = ctypes.c_void_p(kernel32.CreateJobObjectW(None, None))
    # This is a JOBOBJECT_EXTENDED_LIMIT_INFORMATION. Only its LimitFlags are set, and their value
    # 0x2000 is JOB_OBJECT_LIMIT_KILL_ON_JOB_CLOSE.
    information = (ctypes.c_byte * (144 if ctypes.sizeof(ctypes.c_void_p) == 8 else 112))()
    ctypes.memmove(ctypes.byref(information, 16), ctypes.byref(ctypes.c_uint32(0x2000)), 4)
    extended, size = 9, ctypes.sizeof(information)
    kernel32.SetInformationJobObject(job, extended, ctypes.byref(information), size)
    kernel32.AssignProcessToJobObject(job, ctypes.c_void_p(kernel32.GetCurrentProcess()))
    _job.append(job)
