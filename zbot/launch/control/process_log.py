"""Log of the processes of a launch: the state of each, and the last lines of its output."""

from __future__ import annotations

import codecs
import shlex
import time
from collections import deque
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Final

from zbot.launch.event_handler import EventHandler
from zbot.launch.process_event import ProcessExited, ProcessIO, ProcessStarted

if TYPE_CHECKING:
    from zbot.launch.actions.execute import ExecuteLocal
    from zbot.launch.context import LaunchContext

_MOST_LINES = 500
_LONGEST_LINE = 2000
_STREAMS: Final[tuple[int, ...]] = (1, 2)  # stdout and stderr


class OutputTail:
    """The last lines of the output of a process. Each line has a number, from 1."""

    def __init__(self) -> None:
        self._lines: deque[str] = deque(maxlen=_MOST_LINES)
        self._count = 0
        decoder = codecs.getincrementaldecoder("utf-8")
        self._decoders = {fd: decoder("backslashreplace") for fd in _STREAMS}
        self._rest = dict.fromkeys(_STREAMS, "")

    def feed(self, fd: int, data: bytes) -> None:
        """Add output of stdout (1) or stderr (2)."""
        *lines, rest = (self._rest[fd] + self._decoders[fd].decode(data)).split("\n")
        self._rest[fd] = rest[:_LONGEST_LINE]
        for line in lines:
            self.add(line.rstrip("\r"))

    def add(self, line: str) -> None:
        """Add a line."""
        self._lines.append(line[:_LONGEST_LINE])
        self._count += 1

    def end(self) -> None:
        """Add the last line of each stream, if it has no newline."""
        for fd, rest in self._rest.items():
            if rest:
                self.add(rest)
            self._rest[fd] = ""

    def since(self, number: int) -> tuple[int, list[str]]:
        """Return the number of the last line, and the kept lines after a number."""
        new = min(len(self._lines), max(0, self._count - number))
        return self._count, list(self._lines)[len(self._lines) - new :]


@dataclass
class LoggedProcess:
    """Process that the launch has started, or starts again."""

    label: str  #: e.g. `talker-1`
    action: ExecuteLocal
    command: str
    pid: int = 0
    runs: int = 0  #: how often it was started
    since_s: float = 0.0  #: begin of the state, in seconds since the epoch
    is_running: bool = True
    exit_code: int | None = None  #: of the last run
    output: OutputTail = field(default_factory=OutputTail)

    def document(self) -> dict[str, Any]:
        """Return the facts as JSON."""
        return {
            "label": self.label,
            "command": self.command,
            "pid": self.pid,
            "runs": self.runs,
            "since": self.since_s,
            "running": self.is_running,
            "exit_code": self.exit_code,
        }


class ProcessLog:
    """Log of all processes of a launch, which hears the events of the launch.

    Args:
        context: The launch.
    """

    def __init__(self, context: LaunchContext) -> None:
        self.processes: dict[str, LoggedProcess] = {}  #: by label
        kinds = (ProcessStarted, ProcessIO, ProcessExited)
        context.register_event_handler(
            EventHandler(matcher=lambda event: isinstance(event, kinds), entities=self._hear)
        )

    def _hear(self, event: Any, _: LaunchContext) -> None:
        if not event.pid:
            return  # a program that was left out
        if isinstance(event, ProcessStarted):
            self._start(event)
        process = self.processes.get(event.process_name)
        if process is None:
            return
        if isinstance(event, ProcessIO) and event.fd in _STREAMS:
            process.output.feed(event.fd, event.text)
        elif isinstance(event, ProcessExited):
            process.output.end()
            process.is_running, process.exit_code = False, event.returncode
            process.since_s = time.time()

    def _start(self, event: ProcessStarted) -> None:
        process = self.processes.get(event.process_name)
        if process is None:
            command = shlex.join(map(str, event.cmd))
            process = LoggedProcess(event.process_name, event.action, command)
            self.processes[event.process_name] = process
        elif process.runs:
            process.output.end()
            process.output.add("-- started again --")
        process.pid, process.since_s, process.is_running = event.pid, time.time(), True
        process.runs += 1
