"""Events that report the start, exit or output of a process, or request to signal or end it."""

from __future__ import annotations

import os
import signal
from typing import TYPE_CHECKING, Any, TypeAlias

from zbot.launch.event import Event

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from zbot.launch.actions.execute import ExecuteLocal

    ProcessMatcher: TypeAlias = Callable[["ExecuteLocal"], bool]


class RunningProcessEvent(Event):
    """Base class of events about a process that was started."""

    name = "launch.events.process.RunningProcessEvent"

    def __init__(
        self,
        *,
        action: ExecuteLocal,
        name: str,
        cmd: Sequence[str],
        cwd: str | None,
        env: dict[str, str] | None,
        pid: int,
    ) -> None:
        self.action = action
        self.process_name = name
        self.cmd = list(cmd)
        self.cwd, self.env, self.pid = cwd, env, pid

    @property
    def execute_process_action(self) -> ExecuteLocal:
        """The action that started the process. This property is the old name of `action`."""
        return self.action


class ProcessStarted(RunningProcessEvent):
    """A process was started."""

    name = "launch.events.process.ProcessStarted"


class ProcessExited(RunningProcessEvent):
    """A process ended.

    Args:
        returncode: The exit code. It is negative if a signal ended the process.
        process: The arguments of `RunningProcessEvent`.
    """

    name = "launch.events.process.ProcessExited"

    def __init__(self, *, returncode: int = 0, **process: Any) -> None:
        super().__init__(**process)
        self.returncode = returncode


class ProcessIO(RunningProcessEvent):
    """Output of a process, or input for it.

    Args:
        text: The bytes.
        fd: 0 for stdin, 1 for stdout, 2 for stderr. None means the class attribute `fd`.
        process: The arguments of `RunningProcessEvent`.
    """

    name = "launch.events.process.ProcessIO"
    fd: int = 1

    def __init__(self, *, text: bytes = b"", fd: int | None = None, **process: Any) -> None:
        super().__init__(**process)
        self.text = text
        self.fd = self.fd if fd is None else fd

    @property
    def from_stdin(self) -> bool:
        """Whether the bytes are input for the process's stdin."""
        return self.fd == 0

    @property
    def from_stdout(self) -> bool:
        """Whether the bytes came from stdout."""
        return self.fd == 1

    @property
    def from_stderr(self) -> bool:
        """Whether the bytes came from stderr."""
        return self.fd == 2


class ProcessStdin(ProcessIO):
    """Request to write to the stdin of a process."""

    name = "launch.events.process.ProcessStdin"
    fd = 0


class ProcessStdout(ProcessIO):
    """A process wrote to stdout."""

    name = "launch.events.process.ProcessStdout"


class ProcessStderr(ProcessIO):
    """A process wrote to stderr."""

    name = "launch.events.process.ProcessStderr"
    fd = 2


class ProcessTargetedEvent(Event):
    """Base class of requests to processes, which a matcher selects."""

    name = "launch.events.process.ProcessTargetedEvent"

    def __init__(self, *, process_matcher: ProcessMatcher) -> None:
        self.process_matcher = process_matcher


class ShutdownProcess(ProcessTargetedEvent):
    """Request to end processes with SIGINT, later with SIGTERM, and last with SIGKILL."""

    name = "launch.events.process.ShutdownProcess"


class SignalProcess(ProcessTargetedEvent):
    """Request to send a signal to processes."""

    name = "launch.events.process.SignalProcess"

    def __init__(
        self, *, signal_number: str | int | signal.Signals, process_matcher: ProcessMatcher
    ) -> None:
        super().__init__(process_matcher=process_matcher)
        if isinstance(signal_number, str):
            signal_number = getattr(signal, signal_number)
        self.signal = signal.Signals(int(signal_number))
        self.signal_name = self.signal.name


def matches_action(target_action: ExecuteLocal) -> ProcessMatcher:
    """Return a matcher that selects the process of an action."""
    return lambda action: action is target_action


def matches_pid(pid: int) -> ProcessMatcher:
    """Return a matcher that selects a process by its process id."""
    return lambda action: action.process_details.get("pid") == pid


def matches_name(name: str) -> ProcessMatcher:
    """Return a matcher that selects processes by a part of their name, e.g. `talker-1`."""
    return lambda action: bool(action.process_details) and name in action.process_details["name"]


def matches_executable(executable: str) -> ProcessMatcher:
    """Return a matcher that selects processes by the file name of their program."""

    def matches(action: ExecuteLocal) -> bool:
        details = action.process_details
        return bool(details) and os.path.basename(details["cmd"][0]) == executable  # noqa: PTH119

    return matches
