"""Router process of a domain: a background process that introduces the domain's programs.

The domain's first program starts the router, and the router ends soon after the last program. The
router belongs to no terminal, so Ctrl-C and Ctrl-Z in a terminal do not reach it. If the router
does not answer, a program kills it and starts another. The programs then link to the new router.
The links between the programs stay.
"""

from __future__ import annotations

import contextlib
import os
import signal
import subprocess
import sys
import time
from pathlib import Path
from typing import IO, Any

from zbot.package.user_folders import make_private
from zbot.text.whole_number import whole_number
from zbot.threads.deadline import poll
from zbot.transport import background_process, membership

_PROC = Path("/proc")
# A blocked router uses no processor. A router that works uses a processor, or waits for one.
_IDLE_SHARE = 0.05  # a process that uses less than this share of a processor is idle
# On a quiet machine with two cores and ten nodes at 100 Hz, a process waits for a processor at most
# as long as it runs, and at most 40 ms while it asks a router.
_BUSY_RATIO = 2.0
_BUSY_WAIT_S = 0.05
_BUSY_THREADS = 2
_BUSY_FACTOR = 15
_END_TIMEOUT_S = 1.0  # a killed process ends within 20 ms
_PAUSE_S = 0.002
_PS_S = 2.0
_KILLED = "killed"
_CHANGE_S = 1.0  # a killed router keeps its port for milliseconds, or longer on a busy machine
REPLACEMENT = "replacement"  #: argument of a router if the router before it was killed


def start(domain: int) -> bool:
    """Start the domain's router process if it does not run. Return whether this call started it."""
    try:
        make_private(membership.folder())
        # `os.open` does not truncate the file. On a full disk, a truncated file would stay empty.
        number = os.open(_path(domain), os.O_RDWR | os.O_CREAT, 0o600)
        with os.fdopen(number, "r+", encoding="utf-8") as file:
            return _start_locked(domain, file)
    except OSError:  # the folder is read-only: two routers may start, and one of them gets the port
        _start(domain)
        return True


def _start_locked(domain: int, file: IO[str]) -> bool:
    if not background_process.lock(file):
        return False
    process = _start(domain, file, is_replacement=bool(file.read()))
    _overwrite(file, str(process.pid))
    return True


def _start(domain: int, *files: IO[str], is_replacement: bool = False) -> subprocess.Popen[str]:
    null = subprocess.DEVNULL
    kept: dict[str, Any] = (
        {} if sys.platform == "win32" else {"pass_fds": [file.fileno() for file in files]}
    )
    words = [str(domain), *([REPLACEMENT] if is_replacement else [])]
    process = background_process.start("zbot.transport", *words, stdout=null, stderr=null, **kept)
    background_process.forget(process)
    return process


def hold_lock(domain: int) -> IO[str] | None:
    """Lock the file that shows that this process is the domain's router, and return the file.

    On POSIX, the process has inherited the locked file, so the result is `None`.
    """
    if sys.platform != "win32":
        return None
    file = _path(domain).open("r+", encoding="utf-8")
    background_process.lock_soon(file)
    return file


def pid(domain: int) -> int | None:
    """Return the process id of the domain's router, or `None` if no router of this user runs."""
    number = whole_number(_read(domain))
    return number if number is not None and background_process.is_locked(_path(domain)) else None


def age_s(domain: int) -> float:
    """Return how many seconds ago the domain's router was started, killed or ended.

    A new session of the router counts as a start. The result is 0 if there was no router.
    """
    try:
        return time.time() - _path(domain).stat().st_mtime
    except OSError:
        return 0.0


def note_new_session(domain: int) -> None:
    """Note that the router opens a new session. It counts as a new router, so nobody ends it."""
    with contextlib.suppress(OSError):  # the folder is read-only
        os.utime(_path(domain))


def is_expected(domain: int) -> bool:
    """Return whether a router of this user runs, starts, or was killed."""
    return bool(_read(domain))


def is_changing(domain: int) -> bool:
    """Return whether a router of this user was started, killed or ended within the last second.

    A router that ends may still have the port, but its file has no process id any more.
    """
    return _path(domain).exists() and age_s(domain) < _CHANGE_S


def note_end(domain: int) -> None:
    """Note that the router of the domain ends because no program needs it."""
    _write(domain, "")


def _read(domain: int) -> str:
    try:
        return _path(domain).read_text(encoding="utf-8")
    except OSError:
        return ""


def _write(domain: int, text: str) -> None:
    with (
        contextlib.suppress(OSError),  # the folder is read-only
        _path(domain).open("r+", encoding="utf-8") as file,
    ):
        _overwrite(file, text)


def _overwrite(file: IO[str], text: str) -> None:
    """Replace the contents of a file. On a full disk, this works if the file was not empty."""
    with contextlib.suppress(OSError):  # a new file on a full disk: it stays empty
        os.lseek(file.fileno(), 0, os.SEEK_SET)
        os.write(file.fileno(), text.encode())
        os.ftruncate(file.fileno(), len(text))


def _path(domain: int) -> Path:
    return background_process.lock_path(f"router-{domain}")


def kill(domain: int, number: int) -> bool:
    """Kill the domain's router process, and wait for its end.

    Args:
        domain: 0 to 232.
        number: The process id that `pid` returned.

    Returns:
        Whether this call killed the process. Another program may have killed it before, or may do
        so at this moment.
    """
    # Many programs notice a stopped router within milliseconds. Without this lock, one of them
    # could write `killed` over the id of the next router.
    try:
        with background_process.lock_path(f"router-{domain}-end").open(
            "a", encoding="utf-8"
        ) as file:
            return background_process.lock(file) and _kill(domain, number)
    except OSError:  # the folder is read-only, or the disk is full
        return _kill(domain, number)


def _kill(domain: int, number: int) -> bool:
    if pid(domain) != number:
        return False
    _write(domain, _KILLED)  # so that no other program kills it too
    try:
        os.kill(number, getattr(signal, "SIGKILL", signal.SIGTERM))
    except OSError:  # it has just ended, or it is another user's
        return False
    # Another program may already have started the next router. Then the file has the new id.
    poll(
        lambda: _read(domain) != _KILLED or not background_process.is_locked(_path(domain)),
        _END_TIMEOUT_S,
        _PAUSE_S,
    )
    return True


def is_stopped(number: int) -> bool:
    """Return whether SIGSTOP, Ctrl-Z or a debugger has suspended a process (Windows: `False`)."""
    return any(state in "Tt" for state, _ in _threads(number))


class IdleWatch:
    """Watch of a process from now on. An idle process does not use a processor or wait for one.

    Args:
        number: The process id.
    """

    def __init__(self, number: int) -> None:
        self.number = number
        self.saw_busy_machine = is_machine_busy()  #: before the watch, or during the watch
        self._begin_s = time.monotonic()
        self._begin, self._begin_times = _threads(number), processor_times()

    def is_idle(self, watch_s: float) -> bool:
        """Return whether the process was idle. On Windows, return `False`.

        On a busy machine, the process may wait for other processes, so it is watched 15 times as
        long.

        Args:
            watch_s: The process is watched for at least this time.
        """
        self.saw_busy_machine |= is_machine_busy(self._begin_times)
        if self.saw_busy_machine:
            watch_s *= _BUSY_FACTOR
        time.sleep(max(0.0, watch_s - (time.monotonic() - self._begin_s)))
        end = _threads(self.number)
        used_s = sum(seconds for _, seconds in end) - sum(seconds for _, seconds in self._begin)
        is_running = any(state == "R" for state, _ in end)
        return bool(end) and not is_running and used_s < watch_s * _IDLE_SHARE


def processor_times() -> tuple[float, float]:
    """Return how long this process's threads have run, and have waited for a processor (s).

    Both are 0 on systems other than Linux.
    """
    ran_ns = waited_ns = 0
    for path in _PROC.glob("self/task/*/schedstat"):
        with contextlib.suppress(OSError):  # the thread has ended
            ran, waited, _ = path.read_text(encoding="ascii").split()
            ran_ns, waited_ns = ran_ns + int(ran), waited_ns + int(waited)
    return ran_ns / 1e9, waited_ns / 1e9


def is_machine_busy(begin: tuple[float, float] = (0.0, 0.0)) -> bool:
    """Return whether this process waits for a processor much longer than it runs.

    On macOS, return whether more than two threads for each processor ran or waited in the last
    minute. On Windows, return `False`.

    Args:
        begin: The `processor_times()` when the interval began. By default, this is the start of
            the process.
    """
    ran_s, waited_s = processor_times()
    if ran_s:
        limit_s = max(_BUSY_RATIO * (ran_s - begin[0]), _BUSY_WAIT_S)
        return waited_s - begin[1] > limit_s
    if sys.platform != "win32":
        return os.getloadavg()[0] > _BUSY_THREADS * (os.cpu_count() or 1)
    return False


def _threads(number: int) -> list[tuple[str, float]]:
    """Return the state and the processor time (s) of a process's threads (Windows: `[]`)."""
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
    line: list[str] = []
    with contextlib.suppress(OSError, subprocess.TimeoutExpired):
        done = subprocess.run(words, capture_output=True, text=True, check=False, timeout=_PS_S)  # noqa: S603 - a number
        line = done.stdout.split()
    if not line:
        return []
    minutes, _, seconds = line[1].rpartition(":")
    return [(line[0][0], float(seconds) + 60 * int(minutes.rpartition(":")[2] or 0))]
