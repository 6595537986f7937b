"""Child process of a launch, with its output, its signals and its exit code."""

from __future__ import annotations

import asyncio
import contextlib
import os
import signal
import subprocess
import sys
from typing import TYPE_CHECKING, Any, cast

from zbot.launch.process_group import send
from zbot.package.zbot_command import zbot_command

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator, Mapping, Sequence

    from zbot.launch.process_group import ProcessGroups

_KILLED = -9  # the exit code of a process that SIGKILL ended
# Longest time to read the output of an ended process. Its children may keep the pipes open.
_DRAIN_S = 0.5


class _Protocol(asyncio.SubprocessProtocol):
    def __init__(self, on_data: Callable[[int, bytes], None]) -> None:
        self._on_data = on_data
        self.exited = asyncio.Event()
        self.closed = asyncio.Event()

    def pipe_data_received(self, fd: int, data: bytes) -> None:
        self._on_data(fd, data)

    def process_exited(self) -> None:
        self.exited.set()

    def connection_lost(self, exc: Exception | None) -> None:  # noqa: ARG002 - fixed by asyncio
        self.closed.set()


class _Terminal(asyncio.Protocol):
    """Reader of the pseudo terminal that a process writes to."""

    def __init__(self, fd: int, on_data: Callable[[int, bytes], None]) -> None:
        self._fd, self._on_data = fd, on_data
        self.closed = asyncio.Event()

    def data_received(self, data: bytes) -> None:
        self._on_data(self._fd, data.replace(b"\r\n", b"\n"))

    def connection_lost(self, exc: Exception | None) -> None:  # noqa: ARG002 - EIO means closed
        self.closed.set()


class ChildProcess:
    """A running process.

    Args:
        transport: The asyncio transport of the process.
        protocol: The protocol of this transport.
        terminals: Transports and protocols of the process's pseudo terminals.
        process_groups: The groups of the launch. The constructor adds the group of this process.
    """

    def __init__(
        self,
        transport: asyncio.SubprocessTransport,
        protocol: _Protocol,
        terminals: Sequence[tuple[asyncio.BaseTransport, _Terminal]],
        process_groups: ProcessGroups,
    ) -> None:
        self._transport, self._protocol = transport, protocol
        self._terminals, self._process_groups = terminals, process_groups
        self.pid: int = transport.get_pid()
        if os.name != "nt":
            process_groups.add(self.pid)

    @property
    def is_running(self) -> bool:
        """Whether the process still runs."""
        return not self._protocol.exited.is_set()

    def send_signal(self, number: int) -> None:
        """Send a signal to every process in the group of this process."""
        if os.name == "nt":
            # Windows itself sends Ctrl-C to console processes. Here, any `number` ends the process.
            with contextlib.suppress(ProcessLookupError):
                self._transport.terminate()
        else:
            send(self.pid, number)

    def write(self, data: bytes) -> None:
        """Write to the process's stdin, if it is a pipe."""
        pipe = cast("asyncio.WriteTransport | None", self._transport.get_pipe_transport(0))
        if pipe is not None:
            pipe.write(data)

    async def ended(self) -> None:
        """Wait until the process has ended. Its output may still arrive later."""
        await self._protocol.exited.wait()

    async def wait(self) -> int:
        """Wait until the process has ended and its output was read. Return its exit code."""
        await self._protocol.exited.wait()
        closed = [self._protocol.closed, *(terminal.closed for _, terminal in self._terminals)]
        with contextlib.suppress(asyncio.TimeoutError):
            await asyncio.wait_for(asyncio.gather(*(pipe.wait() for pipe in closed)), _DRAIN_S)
        for transport, _ in self._terminals:
            transport.close()
        code = self._transport.get_returncode()
        self._transport.close()
        if os.name != "nt":
            self._process_groups.discard(self.pid)
        return _KILLED if code is None else code


async def start(
    command: str | Sequence[str],
    *,
    env: Mapping[str, str],
    cwd: str | None,
    has_terminal: bool,
    stdin: int | None,
    on_data: Callable[[int, bytes], None],
    process_groups: ProcessGroups,
) -> ChildProcess:
    """Start a process.

    Args:
        command: Words, or a command line for the shell.
        env: Its environment.
        cwd: Its working directory.
        has_terminal: Whether its stdout and stderr are pseudo terminals. Otherwise they are pipes.
        stdin: Its stdin, with the same values as in `subprocess`.
        on_data: Called with 1 (stdout) or 2 (stderr) and the bytes that the process wrote.
        process_groups: The groups of the launch, which end when the launch ends.

    Raises:
        OSError: The process cannot be started.
    """
    process_groups.prepare()
    loop = asyncio.get_running_loop()
    protocol = _Protocol(on_data)
    masters, slaves = _terminals() if has_terminal else ([], [])
    options: dict[str, Any] = {
        "env": dict(env),
        "cwd": cwd,
        "stdin": stdin,
        "stdout": slaves[0] if slaves else subprocess.PIPE,
        "stderr": slaves[1] if slaves else subprocess.PIPE,
        # The process gets its own session. So Ctrl-C reaches only the launch, and the launch then
        # sends signals to the process.
        "start_new_session": os.name != "nt",
    }
    try:
        if isinstance(command, str):
            transport, _ = await loop.subprocess_shell(lambda: protocol, command, **options)
        else:
            with _blocked_interrupts(command):
                transport, _ = await loop.subprocess_exec(lambda: protocol, *command, **options)
    except BaseException:
        for fd in masters:
            os.close(fd)
        raise
    finally:
        for fd in slaves:
            os.close(fd)
    terminals = [await _read(number, fd, on_data) for number, fd in enumerate(masters, 1)]
    return ChildProcess(transport, protocol, terminals, process_groups)


@contextlib.contextmanager
def _blocked_interrupts(command: Sequence[str]) -> Iterator[None]:
    """Start a command of zbot with SIGINT blocked. zbot unblocks it when it can handle it.

    Without this, Python would print a traceback if a launch ends while the command still starts.
    Other programs start as usual, because they would never unblock SIGINT.
    """
    words = zbot_command()
    if sys.platform == "win32" or list(command[: len(words)]) != words:
        yield
        return
    signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})  # the process inherits the mask
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_UNBLOCK, {signal.SIGINT})


def _terminals() -> tuple[list[int], list[int]]:
    if sys.platform == "win32":
        return [], []
    pairs = (os.openpty(), os.openpty())
    return [master for master, _ in pairs], [slave for _, slave in pairs]


async def _read(
    number: int, fd: int, on_data: Callable[[int, bytes], None]
) -> tuple[asyncio.BaseTransport, _Terminal]:
    loop = asyncio.get_running_loop()
    file = os.fdopen(fd, "rb", buffering=0)
    return await loop.connect_read_pipe(lambda: _Terminal(number, on_data), file)
