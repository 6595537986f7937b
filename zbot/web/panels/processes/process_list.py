"""List of the nodes' processes, with CPU and memory, and a function that stops a process."""

from __future__ import annotations

import os
import signal
import sys
from dataclasses import dataclass
from typing import TYPE_CHECKING

import psutil

from zbot.graph.snapshot import full_names
from zbot.observer.errors import ViewerError
from zbot.transport.admin_query import processes

if TYPE_CHECKING:
    from collections.abc import Mapping

    from zbot.graph.snapshot import Snapshot
    from zbot.observer.system import System
    from zbot.transport.admin_query import Process

#: Tolerance between the start of a process and the start that its session reports.
_SLACK_S = 2.0


@dataclass(frozen=True, slots=True)
class RunningProcess:
    """Process and its nodes."""

    host: str
    pid: int
    started_ns: int  #: nanoseconds since the epoch
    command: str
    version: str  #: the version of zbot
    nodes: tuple[str, ...]  #: full names
    is_here: bool  #: whether it runs on this machine
    is_page: bool  #: whether it serves the page
    cpu_percent: float | None = None  #: of one core, since the last `look`; None on other machines
    memory_bytes: int | None = None  #: resident memory; None on other machines
    space: str = ""  #: see `process_space`

    @property
    def key(self) -> str:
        """A unique key of the process."""
        return f"{self.host}:{self.space}:{self.pid}"


class ProcessList:
    """List of processes, with CPU use since the last `look`. One thread at a time may use it."""

    def __init__(self) -> None:
        self._known: dict[int, psutil.Process] = {}

    def look(self, system: System) -> list[RunningProcess]:
        """Query the sessions of the domain's nodes (1 to 25 ms), and return their processes."""
        by_session = processes(system.context.session)
        found = _merged(system.snapshot(), by_session)
        self._known = {
            pid: process for pid, process in self._known.items() if psutil.pid_exists(pid)
        }
        return [self._measured(process, nodes) for process, nodes in found]

    def _measured(self, process: Process, nodes: tuple[str, ...]) -> RunningProcess:
        is_here = process.is_here
        cpu, memory = self._costs(process.pid) if is_here else (None, None)
        return RunningProcess(
            process.host,
            process.pid,
            process.started_ns,
            process.command,
            process.version,
            nodes,
            is_here,
            is_here and process.pid == os.getpid(),
            cpu,
            memory,
            process.space,
        )

    def _costs(self, pid: int) -> tuple[float | None, int | None]:
        try:
            # The object is kept: psutil measures CPU time since the last call on the same object.
            process = self._known.setdefault(pid, psutil.Process(pid))
            return process.cpu_percent(), process.memory_info().rss
        except psutil.Error:  # the process has ended, or belongs to another user
            return None, None


def _merged(
    graph: Snapshot, by_session: Mapping[str, Process]
) -> list[tuple[Process, tuple[str, ...]]]:
    """Return each process once, with the nodes of all its sessions."""
    nodes: dict[tuple[str, str, int], list[str]] = {}
    first: dict[tuple[str, str, int], Process] = {}
    for node in graph.nodes:
        process = by_session.get(node.zid)
        if process is not None:
            key = (process.host, process.space, process.pid)
            first.setdefault(key, process)
            nodes.setdefault(key, []).extend(full_names([node]))
    found = [(first[key], tuple(sorted(nodes[key]))) for key in first]
    return sorted(found, key=lambda pair: pair[1])


def stop(process: RunningProcess, *, force: bool = False) -> None:
    """Stop a process of this machine with SIGINT, as Ctrl-C does. `force` uses SIGKILL instead.

    Raises:
        ViewerError: The process runs on another machine, belongs to another user, or has ended.
    """
    if not process.is_here:
        raise ViewerError(f"process {process.pid} runs on {process.host}: stop it there")
    try:
        running = psutil.Process(process.pid)
        is_same = running.create_time() <= process.started_ns / 1e9 + _SLACK_S
        if is_same and force:
            running.kill()
        elif is_same and sys.platform == "win32":
            running.terminate()  # on Windows, Ctrl-C can be sent only to all processes of a console
        elif is_same:
            running.send_signal(signal.SIGINT)
    except psutil.NoSuchProcess:
        is_same = False
    except psutil.AccessDenied:
        raise ViewerError(f"process {process.pid} belongs to another user") from None
    if not is_same:  # another process may have the same number now
        raise ViewerError(f"process {process.pid} has ended already")
