"""The processes that nodes run in: whose they are, what they cost, and how to stop them."""

from __future__ import annotations

import os
import signal
import socket
import sys
from dataclasses import dataclass
from typing import TYPE_CHECKING

import psutil

from zbot.errors import ZbotError
from zbot.graph.snapshot import full_names, processes

if TYPE_CHECKING:
    from collections.abc import Mapping

    from zbot.graph.snapshot import Process, Snapshot
    from zbot.web.system import System

#: A session is opened after its process has begun; clocks of both are those of one machine.
_SLACK_S = 2.0


class StopError(ZbotError):
    """A process cannot be stopped from here."""


@dataclass(frozen=True, slots=True)
class RunningProcess:
    """A process with the nodes in it."""

    host: str
    pid: int
    started_ns: int  #: nanoseconds since the epoch
    command: str
    version: str  #: of zbot
    nodes: tuple[str, ...]  #: full names
    is_here: bool  #: whether it runs on this machine
    is_page: bool  #: whether it is the one that serves the page
    cpu_percent: float | None = None  #: of one core, since the last look; None elsewhere
    memory_bytes: int | None = None  #: resident; None elsewhere

    @property
    def key(self) -> str:
        """What tells it from all others."""
        return f"{self.host}:{self.pid}"


class ProcessList:
    """Looks at processes again and again. One thread at a time may call it."""

    def __init__(self) -> None:
        self._known: dict[int, psutil.Process] = {}

    def look(self, system: System) -> list[RunningProcess]:
        """Return the processes of the domain's nodes; asks their sessions, 1 to 25 ms."""
        told = processes(system.context.session)
        found = _merged(system.snapshot(), told)
        self._known = {pid: one for pid, one in self._known.items() if psutil.pid_exists(pid)}
        return [self._measured(process, nodes) for process, nodes in found]

    def _measured(self, process: Process, nodes: tuple[str, ...]) -> RunningProcess:
        is_here = process.host == socket.gethostname()
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
        )

    def _costs(self, pid: int) -> tuple[float | None, int | None]:
        try:
            # The object remembers the last look, which the share is reckoned from.
            process = self._known.setdefault(pid, psutil.Process(pid))
            return process.cpu_percent(), process.memory_info().rss
        except psutil.Error:  # it has ended, or belongs to somebody else
            return None, None


def _merged(graph: Snapshot, told: Mapping[str, Process]) -> list[tuple[Process, tuple[str, ...]]]:
    """Return each process once, with the nodes of all its sessions."""
    nodes: dict[tuple[str, int], list[str]] = {}
    first: dict[tuple[str, int], Process] = {}
    for node in graph.nodes:
        process = told.get(node.zid)
        if process is not None:
            key = (process.host, process.pid)
            first.setdefault(key, process)
            nodes.setdefault(key, []).extend(full_names([node]))
    found = [(first[key], tuple(sorted(nodes[key]))) for key in first]
    return sorted(found, key=lambda one: one[1])


def stop(process: RunningProcess, *, force: bool = False) -> None:
    """Ask a process of this machine to end, as Ctrl-C does; or end it, without a goodbye.

    Raises:
        StopError: It runs elsewhere, is somebody else's, or has ended.
    """
    if not process.is_here:
        raise StopError(f"it runs on {process.host}: end it there")
    try:
        running = psutil.Process(process.pid)
        is_same = running.create_time() <= process.started_ns / 1e9 + _SLACK_S
        if is_same and force:
            running.kill()
        elif is_same and sys.platform == "win32":
            running.terminate()  # Ctrl-C reaches only whole consoles there
        elif is_same:
            running.send_signal(signal.SIGINT)
    except psutil.NoSuchProcess:
        is_same = False
    except psutil.AccessDenied:
        raise StopError(f"process {process.pid} belongs to another user") from None
    if not is_same:  # the number may have been given to another process since
        raise StopError(f"process {process.pid} has ended already")
