"""Server in a launch, by which the page of the same user sees and controls the processes.

It listens on a port of the loopback address. A request is a line of JSON with the token, which only
this user can read in a file. The answer is a line of JSON.
"""

from __future__ import annotations

import asyncio
import contextlib
import json
import os
import time
from typing import TYPE_CHECKING, Any

from zbot.launch.control.process_log import ProcessLog
from zbot.launch.errors import LaunchControlError
from zbot.launch.event import Shutdown
from zbot.launch.process_event import ShutdownProcess, matches_action
from zbot.text.json_reader import JsonError, read_json_object
from zbot.text.whole_number import whole_number
from zbot.transport.config import domain_id
from zbot.transport.errors import SettingError
from zbot.transport.membership import folder
from zbot.transport.process_facts import process_space
from zbot.transport.program_file import ProgramFile

if TYPE_CHECKING:
    from collections.abc import Sequence
    from pathlib import Path

    from zbot.launch.context import LaunchContext
    from zbot.launch.control.process_log import LoggedProcess

#: Folder of the files of running launches, in the folder of the user's settings.
FOLDER = "launches"
_MOST_BYTES = 65_536
_PATIENCE_S = 5.0


def read_request(line: bytes) -> dict[str, str]:
    """Return the words of a request.

    Raises:
        LaunchControlError: The line is not an object of JSON with texts and numbers.
    """
    try:
        document = read_json_object(line.decode("utf-8", "replace"))
    except JsonError as error:
        raise LaunchControlError(f"the request is not an object of JSON: {error}") from None
    return {str(key): str(value) for key, value in document.items()}


class ControlServer:
    """Server that answers as long as the launch runs.

    Args:
        context: The launch.
        file: The launch file.
        arguments: The arguments of the launch file.
    """

    def __init__(self, context: LaunchContext, file: Path, arguments: Sequence[str]) -> None:
        self._context = context
        self._facts = {"file": str(file), "arguments": list(arguments), "started": time.time()}
        self._token = os.urandom(16).hex()
        self._log = ProcessLog(context)
        self._server: asyncio.Server | None = None
        self._file: ProgramFile | None = None
        self._task: asyncio.Task[None] | None = None

    def start(self) -> None:
        """Begin to listen.

        Without a loopback address, or with a wrong domain number, the page does not see the launch.
        The nodes say what is wrong with the number.
        """
        self._task = self._context.running_loop.create_task(self._listen())
        self._context.on_close(self.close)

    async def _listen(self) -> None:
        try:
            domain = domain_id()
            self._server = await asyncio.start_server(
                self._serve, "127.0.0.1", 0, limit=_MOST_BYTES
            )
        except (OSError, SettingError):
            return
        self._file = ProgramFile(folder() / FOLDER)
        self._file.write(
            {
                "pid": os.getpid(),
                "space": process_space(),
                "domain": domain,
                "port": self._server.sockets[0].getsockname()[1],
                "token": self._token,
            }
        )

    def close(self) -> None:
        """Stop to listen, and remove the file. A second call does nothing."""
        if self._server is not None:
            self._server.close()
        if self._file is not None:
            self._file.close()

    async def _serve(self, reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        with contextlib.suppress(OSError), contextlib.closing(writer):
            try:
                line = await asyncio.wait_for(reader.readline(), _PATIENCE_S)
            except (asyncio.TimeoutError, ValueError):  # ValueError: the line is too long
                return
            answer = self._answer(line)
            if answer is not None:
                writer.write(json.dumps(answer).encode() + b"\n")
                await writer.drain()

    def _answer(self, line: bytes) -> dict[str, Any] | None:
        """Return the answer to a request, or None for a client without the token."""
        from hmac import compare_digest  # noqa: PLC0415 - most launches have no client

        try:
            request = read_request(line)
            if not compare_digest(request.get("token", "").encode(), self._token.encode()):
                return None
            return self._do(request)
        except LaunchControlError as error:
            return {"error": str(error)}

    def _do(self, request: dict[str, str]) -> dict[str, Any]:
        op = request.get("op")
        if op == "look":
            processes = [process.document() for process in self._log.processes.values()]
            return {**self._facts, "processes": processes, "ending": self._context.is_shutdown}
        if op == "end":
            self._context.emit_event_sync(Shutdown(reason="the page has stopped the launch"))
            return {}
        process = self._process(request)
        if op == "output":
            last, lines = process.output.since(_number(request.get("after", "0")))
            return {"last": last, "lines": lines}
        if op == "stop":
            matcher = matches_action(process.action)
            self._context.emit_event_sync(ShutdownProcess(process_matcher=matcher))
        elif op == "restart":
            self._restart(process)
        else:
            raise LaunchControlError(f"the launch does not know the request {op!r}")
        return {}

    def _restart(self, process: LoggedProcess) -> None:
        if self._context.is_shutdown:
            raise LaunchControlError("the launch is ending")
        process.action.restart()

    def _process(self, request: dict[str, str]) -> LoggedProcess:
        label = request.get("label", "")
        process = self._log.processes.get(label)
        if process is None:
            raise LaunchControlError(f"the launch has no process {label!r}")
        return process


def _number(text: str) -> int:
    return whole_number(text) or 0
