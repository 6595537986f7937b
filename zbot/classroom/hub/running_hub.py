"""Hub process in the background. It keeps running when its terminal is closed.

A user has at most one hub on a machine. The hub locks a file as long as it runs. The system
releases the lock when the process ends, also after a crash.
"""

from __future__ import annotations

import contextlib
import json
import os
import signal
import subprocess
import sys
import time
from dataclasses import asdict, dataclass
from typing import TYPE_CHECKING

from zbot.classroom.errors import already_joined_error, hub_start_error
from zbot.errors import ZbotError
from zbot.security.secret import make_private_folder, write_private
from zbot.text.json_reader import read_json_object
from zbot.threads.deadline import poll
from zbot.transport import background_process, config, router_process
from zbot.transport.errors import SettingError
from zbot.transport.membership import folder
from zbot.transport.process_facts import process_space

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator
    from pathlib import Path

READY = "ready"
_STOP_TIMEOUT_S = 5.0
_PAUSE_S = 0.02
# Zenoh accepts all links in one thread, and receives in two. If a laptop is out of reach when its
# link is closed, the thread stands still for 10 s (docs/design/zenoh-faults.md). These are enough
# threads for a class of thirty. They cost 1 MB.
_ZENOH_THREADS = {"ZENOH_RUNTIME": "(acc: (worker_threads: 32), rx: (worker_threads: 32))"}


@dataclass(frozen=True)
class RunningHub:
    """Content of the state file of a running hub."""

    pid: int
    role: str
    listen: list[str]
    connect: list[str]
    started_ns: int  #: since the epoch
    space: str = ""  #: see `process_space`


def log_path() -> Path:
    """Return the log file of a hub in the background."""
    return folder() / "hub.log"


def _state_path() -> Path:
    return folder() / "hub.json"


@contextlib.contextmanager
def hub_lock() -> Iterator[None]:
    """Hold the lock of this machine's hub during a `with` block.

    Raises:
        ClassroomError: Another hub runs.
    """
    make_private_folder(folder())
    with background_process.hub_lock_path().open("w", encoding="utf-8") as file:
        if not background_process.lock_soon(file):
            running = find()
            raise already_joined_error(f"has a hub already ({running.role if running else 'busy'})")
        try:
            yield
        finally:
            _state_path().unlink(missing_ok=True)


def write_state(role: str, listen: tuple[str, ...], connect: tuple[str, ...]) -> None:
    """Write the state file of a hub that is ready."""
    space = process_space()
    state = RunningHub(os.getpid(), role, list(listen), list(connect), time.time_ns(), space)
    write_private(_state_path(), json.dumps(asdict(state)).encode())


def find() -> RunningHub | None:
    """Return this machine's hub, or `None` if no hub runs.

    A hub of another machine, container or network namespace with the same home folder is not found.
    """
    if not background_process.is_hub_locked():
        return None
    try:
        hub = RunningHub(**read_json_object(_state_path().read_text(encoding="utf-8")))
    except (OSError, ValueError, TypeError):
        return None  # the hub is starting or ending
    return hub if hub.space in {"", process_space()} else None


def start(role: str) -> None:
    """Start the hub and wait until it is ready. Its settings are in the membership file.

    Raises:
        ClassroomError: The hub ended before it was ready. Its last line of output is the reason.
    """
    make_private_folder(folder())
    write_private(log_path(), b"")
    with log_path().open("a", encoding="utf-8") as log:
        process = background_process.start(
            "zbot.classroom",
            role,
            variables=_ZENOH_THREADS,
            stdout=subprocess.PIPE,
            stderr=log,
            cwd=folder(),
        )
    assert process.stdout is not None
    with process.stdout as lines:
        said = [line.strip() for line in lines]
    if READY not in said:
        process.wait(_STOP_TIMEOUT_S)
        raise hub_start_error(str(log_path()), said[-1] if said else "")
    background_process.forget(process)


def report_ready() -> None:
    """Tell the parent process that the hub is ready. Further output goes to the log."""
    print(READY, flush=True)
    sys.stdout = sys.stderr
    os.dup2(2, 1)


def exit_code(run: Callable[[], None]) -> int:
    """Run the work of a process in the background, and return its exit code.

    An error is printed for the program that has started the process.
    """
    try:
        run()
    except ZbotError as error:
        print(error, flush=True)
        return 1
    return 0


def end_router() -> None:
    """End the router of this machine's domain after the machine has joined or left a class or hub.

    The router has the former user name and the former port of the hub. Programs start a new router.
    """
    with contextlib.suppress(SettingError):
        domain = config.domain_id()
        number = router_process.pid(domain)
        if number is not None:
            router_process.kill(domain, number)


def stop() -> bool:
    """End the hub and wait for its end. Return whether a hub was running."""
    hub = find()
    if hub is None:
        return False
    for number in (signal.SIGTERM, getattr(signal, "SIGKILL", signal.SIGTERM)):
        with contextlib.suppress(OSError):  # it has just ended
            os.kill(hub.pid, number)
        if poll(lambda: not background_process.is_hub_locked(), _STOP_TIMEOUT_S, _PAUSE_S):
            break
    return True
