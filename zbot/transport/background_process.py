"""Background process of zbot. It still runs after the program that started it has ended."""

from __future__ import annotations

import contextlib
import os
import socket
import subprocess
import sys
import time
from pathlib import Path
from typing import IO, TYPE_CHECKING, Any

from zbot.threads.deadline import poll
from zbot.transport import membership
from zbot.transport.process_facts import process_space

if TYPE_CHECKING:
    from collections.abc import Mapping

# On Windows, no other process can read a locked byte, so the locked byte is far behind the text.
_LOCKED_BYTE = 1 << 20
_LOCK_TIMEOUT_S = 0.2
_LOCK_PAUSE_S = 0.005
_OLD_S = 7 * 24 * 3600.0
_forgotten: set[int] = set()  #: ids of processes that may run longer than this one


def lock_path(name: str) -> Path:
    """Return the path of a lock file.

    Machines, containers and network namespaces that share a home folder have different files.
    """
    return membership.folder() / f"{name}@{process_space()}.lock"


def remove_old_locks() -> None:
    """Remove the lock files that nobody has used for a week.

    The names of lock files are different after each start of the machine.
    """
    for path in membership.folder().glob(f"*@{socket.gethostname()}*.lock"):
        with contextlib.suppress(OSError):  # another program has just removed it
            if time.time() - path.stat().st_mtime < _OLD_S:
                continue
            with path.open("r+", encoding="utf-8") as file:
                if lock(file):
                    path.unlink()


def lock(file: IO[str]) -> bool:
    """Lock a file until this process ends. Return `False` if another process has locked it.

    On POSIX, a process that inherits the file keeps the lock.
    """
    try:
        if sys.platform == "win32":
            import msvcrt  # noqa: PLC0415 - Windows only

            file.seek(_LOCKED_BYTE)
            try:
                msvcrt.locking(file.fileno(), msvcrt.LK_NBLCK, 1)
            finally:
                file.seek(0)  # the caller may read the file of the process that has locked it
        else:
            import fcntl  # noqa: PLC0415 - not on Windows

            fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except OSError:
        return False
    return True


def lock_soon(file: IO[str]) -> bool:
    """Lock a file. Try for 0.2 s, because a program that looks for its owner locks it for a moment.

    Return `False` if another process keeps it locked.
    """
    return poll(lambda: lock(file), _LOCK_TIMEOUT_S, _LOCK_PAUSE_S)


def hub_lock_path() -> Path:
    """Return the file that the hub of this user's machine locks as long as it runs."""
    return membership.folder() / "hub.lock"


def is_hub_locked() -> bool:
    """Return whether the hub of this user's machine runs."""
    return is_locked(hub_lock_path())


def is_locked(path: Path) -> bool:
    """Return whether a process keeps a file locked."""
    try:
        with path.open("r+", encoding="utf-8") as file:
            return not lock(file)
    except OSError:
        return False


def start(
    module: str, *words: str, variables: Mapping[str, str] | None = None, **options: Any
) -> subprocess.Popen[str]:
    """Start `python -m module words` without a terminal. Ctrl-C does not reach the process.

    Args:
        module: A module of zbot.
        words: Arguments of the module. Every user of the machine can read them.
        variables: Environment variables for the process. Those of this process have priority.
        options: Options of `subprocess.Popen`.
    """
    reap()
    return subprocess.Popen(  # noqa: S603 - runs this Python itself
        [sys.executable, "-m", module, *words],
        stdin=subprocess.DEVNULL,
        env={**(variables or {}), **_environment()},
        encoding="utf-8",
        **_detached(),
        **options,
    )


def forget(process: subprocess.Popen[str]) -> None:
    """Let a process run longer than this one. Python then does not warn that it still runs."""
    process.returncode = 0
    _forgotten.add(process.pid)


def reap() -> None:
    """Let the system forget the processes that this program started and that have ended.

    Otherwise they stay in the system's list of processes, as zombies, until this program ends.
    """
    if sys.platform == "win32":
        return
    for number in tuple(_forgotten):
        try:
            has_ended = os.waitpid(number, os.WNOHANG)[0] == number
        except ChildProcessError:  # the program has waited for all its children, or is a fork
            has_ended = True
        if has_ended:
            _forgotten.discard(number)


def _environment() -> dict[str, str]:
    """Return this process's environment without `ZBOT_PIN`. In a checkout, add zbot's path."""
    kept = {name: value for name, value in os.environ.items() if name != "ZBOT_PIN"}
    root = Path(__file__).parents[2]
    if root.name != "site-packages":  # a checkout, which may be importable only from its folder
        kept["PYTHONPATH"] = os.pathsep.join(filter(None, [str(root), kept.get("PYTHONPATH")]))
    return {**kept, "PYTHONUNBUFFERED": "1"}


def _detached() -> dict[str, Any]:
    if sys.platform == "win32":
        return {"creationflags": subprocess.DETACHED_PROCESS | subprocess.CREATE_NEW_PROCESS_GROUP}
    return {"start_new_session": True}
