"""One child process: started, read from, signalled, waited for."""

from __future__ import annotations

import asyncio
import contextlib
import os
import signal
import subprocess
import sys
from typing import TYPE_CHECKING, Any, cast

from zbot.launch.process_group import send

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping, Sequence

    from zbot.launch.process_group import ProcessGroup

# For what is still in the pipes of a process that ended; whoever inherited them may keep them open.
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
    """Reads what a process writes to a pseudo terminal."""

    def __init__(self, fd: int, on_data: Callable[[int, bytes], None]) -> None:
        self._fd, self._on_data = fd, on_data
        self.closed = asyncio.Event()

    def data_received(self, data: bytes) -> None:
        self._on_data(self._fd, data.replace(b"\r\n", b"\n"))

    def connection_lost(self, exc: Exception | None) -> None:  # noqa: ARG002 - EIO is its end
        self.closed.set()


class ChildProcess:
    """A running process.

    Args:
        transport: The process, as asyncio has it.
        protocol: What it told so far.
        terminals: What reads from its pseudo terminals.
        family: Where its group is registered.
    """

    def __init__(
        self,
        transport: asyncio.SubprocessTransport,
        protocol: _Protocol,
        terminals: Sequence[tuple[asyncio.BaseTransport, _Terminal]],
        family: ProcessGroup,
    ) -> None:
        self._transport, self._protocol = transport, protocol
        self._terminals, self._family = terminals, family
        self.pid: int = transport.get_pid()
        if os.name != "nt":
            family.add(self.pid)

    @property
    def is_running(self) -> bool:
        """Whether it has not ended."""
        return not self._protocol.exited.is_set()

    def send_signal(self, number: int) -> None:
        """Send a signal to the process and all in its group."""
        if os.name == "nt":
            # Ctrl-C reaches console processes by itself; there is no gentler way than this one.
            with contextlib.suppress(ProcessLookupError):
                self._transport.terminate()
        else:
            send(self.pid, number)

    def write(self, data: bytes) -> None:
        """Give it something to read, if it reads from a pipe."""
        pipe = cast("asyncio.WriteTransport | None", self._transport.get_pipe_transport(0))
        if pipe is not None:
            pipe.write(data)

    async def ended(self) -> None:
        """Wait until it has ended; what it wrote may still come."""
        await self._protocol.exited.wait()

    async def wait(self) -> int:
        """Wait until it has ended and its output was read; return its exit code."""
        await self._protocol.exited.wait()
        closed = [self._protocol.closed, *(terminal.closed for _, terminal in self._terminals)]
        with contextlib.suppress(asyncio.TimeoutError):
            await asyncio.wait_for(asyncio.gather(*(one.wait() for one in closed)), _DRAIN_S)
        for transport, _ in self._terminals:
            transport.close()
        code = self._transport.get_returncode()
        self._transport.close()
        if os.name != "nt":
            self._family.discard(self.pid)
        return -signal.SIGKILL if code is None else code


async def start(
    command: str | Sequence[str],
    *,
    env: Mapping[str, str],
    cwd: str | None,
    has_terminal: bool,
    stdin: int | None,
    on_data: Callable[[int, bytes], None],
    family: ProcessGroup,
) -> ChildProcess:
    """Start a process.

    Args:
        command: Words, or a text for the shell.
        env: Its environment.
        cwd: Its current folder.
        has_terminal: Whether it is to believe that it writes to a terminal.
        stdin: Where it reads from, as `subprocess` has it.
        on_data: Called with 1 or 2 and what it wrote to stdout or stderr.
        family: What it is to end with.

    Raises:
        OSError: It cannot be started.
    """
    family.prepare()
    loop = asyncio.get_running_loop()
    protocol = _Protocol(on_data)
    masters, slaves = _terminals() if has_terminal else ([], [])
    options: dict[str, Any] = {
        "env": dict(env),
        "cwd": cwd,
        "stdin": stdin,
        "stdout": slaves[0] if slaves else subprocess.PIPE,
        "stderr": slaves[1] if slaves else subprocess.PIPE,
        # Its own session: Ctrl-C in the terminal reaches the launch alone, which tells the others.
        "start_new_session": os.name != "nt",
    }
    try:
        if isinstance(command, str):
            transport, _ = await loop.subprocess_shell(lambda: protocol, command, **options)
        else:
            transport, _ = await loop.subprocess_exec(lambda: protocol, *command, **options)
    except BaseException:
        for fd in masters:
            os.close(fd)
        raise
    finally:
        for fd in slaves:
            os.close(fd)
    terminals = [await _read(number, fd, on_data) for number, fd in enumerate(masters, 1)]
    return ChildProcess(transport, protocol, terminals, family)


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
