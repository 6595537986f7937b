"""Router process of a domain: a background process that introduces the domain's programs.

The domain's first program starts it, and it ends soon after the last one. It belongs to no
terminal, so Ctrl-C and Ctrl-Z in a terminal do not reach it. If it does not answer, a program kills
it and starts another. The programs then link to the new router, and their own links stay.
"""

from __future__ import annotations

import contextlib
import os
import signal
import subprocess
import sys
import time
from pathlib import Path
from typing import IO

from zbot.transport import background_process, membership

_PROC = Path("/proc")
# A router that waits for ever uses no processor. On a busy machine, it uses or awaits a processor.
_IDLE_SHARE = 0.05
_END_TIMEOUT_S = 1.0  # a killed process ends within 20 ms
_PAUSE_S = 0.002
_KILLED = "killed"


def start(domain: int) -> bool:
    """Start the domain's router process, unless it runs. Return whether this call started it."""
    try:
        membership.folder().mkdir(parents=True, exist_ok=True)
        with _path(domain).open("a+", encoding="utf-8") as file:
            return _start_locked(domain, file)
    except OSError:  # the folder is read-only: two routers may start, and one of them gets the port
        _start(domain)
        return True


def _start_locked(domain: int, file: IO[str]) -> bool:
    if not background_process.lock(file):
        return False
    process = _start(domain, file)
    file.truncate(0)
    file.write(str(process.pid))
    return True


def _start(domain: int, *files: IO[str]) -> subprocess.Popen[str]:
    null = subprocess.DEVNULL
    kept = {} if sys.platform == "win32" else {"pass_fds": [file.fileno() for file in files]}
    process = background_process.start(
        "zbot.transport", str(domain), stdout=null, stderr=null, **kept
    )
    background_process.forget(process)
    return process


def hold_lock(domain: int) -> IO[str] | None:
    """Return the locked file that shows that this process is the domain's router.

    On POSIX the process inherited the lock, so the result is `None`.
    """
    if sys.platform != "win32":
        return None
    file = _path(domain).open("r+", encoding="utf-8")
    background_process.lock(file)
    return file


def pid(domain: int) -> int | None:
    """Return the process id of the domain's router, or `None` if no router of this user runs."""
    text = _read(domain)
    return int(text) if text.isdigit() and _is_locked(domain) else None


def _is_locked(domain: int) -> bool:
    try:
        with _path(domain).open("r+", encoding="utf-8") as file:
            return not background_process.lock(file)
    except OSError:
        return False


def age_s(domain: int) -> float:
    """Return how many seconds ago the domain's router was started."""
    try:
        return time.time() - _path(domain).stat().st_mtime
    except OSError:
        return 0.0


def is_expected(domain: int) -> bool:
    """Return whether a router of this user runs, starts, or was killed."""
    return bool(_read(domain))


def note_end(domain: int) -> None:
    """Note that the router of the domain ends because no program needs it."""
    _write(domain, "")


def _read(domain: int) -> str:
    try:
        return _path(domain).read_text(encoding="utf-8")
    except OSError:
        return ""


def _write(domain: int, text: str) -> None:
    with contextlib.suppress(OSError):  # the folder is read-only
        _path(domain).write_text(text, encoding="utf-8")


def _path(domain: int) -> Path:
    return membership.folder() / f"router-{domain}.lock"


def kill(domain: int, number: int) -> bool:
    """Kill the domain's router process, and wait for its end.

    Args:
        domain: 0 to 232.
        number: The process id that `pid` returned.

    Returns:
        Whether this call killed the process. Another program may have killed it before.
    """
    if pid(domain) != number:
        return False
    _write(domain, _KILLED)  # so that no other program kills it too
    try:
        os.kill(number, getattr(signal, "SIGKILL", signal.SIGTERM))
    except (ProcessLookupError, PermissionError):
        return False
    deadline = time.monotonic() + _END_TIMEOUT_S
    # Another program may have started the next router already: its process id is in the file then.
    while _read(domain) == _KILLED and _is_locked(domain) and time.monotonic() < deadline:
        time.sleep(_PAUSE_S)
    return True


def is_stopped(number: int) -> bool:
    """Return whether SIGSTOP, Ctrl-Z or a debugger has stopped a process. On Windows: `False`."""
    return any(state in "Tt" for state, _ in _threads(number))


def is_idle(number: int, watch_s: float) -> bool:
    """Watch whether a process neither uses nor awaits a processor. On Windows: `False`."""
    begin = _threads(number)
    time.sleep(watch_s)
    end = _threads(number)
    used_s = sum(seconds for _, seconds in end) - sum(seconds for _, seconds in begin)
    is_running = any(state == "R" for state, _ in end)
    return bool(end) and not is_running and used_s < watch_s * _IDLE_SHARE


def _threads(number: int) -> list[tuple[str, float]]:
    """Return the state and the used processor time (s) of a process's threads, if known."""
    if _PROC.is_dir():
        found = []
        for path in _PROC.glob(f"{number}/task/*/stat"):
            with contextlib.suppress(OSError):  # the thread has ended
                fields = path.read_text(encoding="utf-8").rpartition(")")[2].split()
                found.append((fields[0], (int(fields[11]) + int(fields[12])) / 100))
        return found
    if sys.platform == "win32":
        return []
    # macOS: one line for the whole process, e.g. `S 0:01.25`.
    words = ["ps", "-o", "state=,cputime=", "-p", str(number)]
    line = subprocess.run(words, capture_output=True, text=True, check=False).stdout.split()  # noqa: S603 - a number
    if not line:
        return []
    minutes, _, seconds = line[1].rpartition(":")
    return [(line[0][0], float(seconds) + 60 * int(minutes.rpartition(":")[2] or 0))]
