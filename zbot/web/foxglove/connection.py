"""Connection of one client through the guard to the server of the SDK.

The SDK gives each client whatever it asks for, and calls Python in its own threads. So the guard
publishes for the client, and passes on only what the client may ask for.
"""

from __future__ import annotations

import asyncio
import contextlib
import struct
import time
import traceback
from typing import TYPE_CHECKING, Any, NamedTuple, TypeVar

from zbot.errors import ZbotError
from zbot.log import get_logger
from zbot.observer.errors import ViewerError
from zbot.observer.serving.client_budget import (
    MAX_CALLS,
    MAX_MESSAGE_BYTES,
    MAX_SUBSCRIBED,
    ClientBudget,
    OverBudgetError,
)
from zbot.text.json_reader import read_json_object
from zbot.web.foxglove.frame import (
    BINARY,
    POLICY_VIOLATION,
    TEXT,
    Frame,
    close_frame,
    read_frame,
    text_frame,
)
from zbot.web.foxglove.outbox import Outbox

if TYPE_CHECKING:
    from collections.abc import Callable
    from concurrent.futures import Executor

    from zbot.web.foxglove.publishing import Publishing

T = TypeVar("T")

_MESSAGE, _CALL, _ANSWER = 1, 2, 3  # first bytes of binary messages
_CHANNEL = struct.Struct("<BI")
_CALL_HEAD = struct.Struct("<BII")
_MOST_TEXT_BYTES = 1_000_000  # descriptions of 500 channels with their types are smaller
_MOST_FRAMES = 10_000
_PATIENCE_S = 1.0


class _Message(NamedTuple):
    frames: list[Frame]

    @property
    def opcode(self) -> int:
        return self.frames[0].opcode

    @property
    def size(self) -> int:
        return sum(len(frame.raw) for frame in self.frames)

    def content(self) -> bytes:
        return b"".join(frame.content() for frame in self.frames)


class Streams(NamedTuple):
    """Two directions of a TCP connection."""

    reader: asyncio.StreamReader
    writer: asyncio.StreamWriter


class Connection:
    """Connection of one client.

    Args:
        client: The client.
        server: The server of the SDK.
        publishing: The publishers of the client.
        threads: Threads for what takes long.
        waiting_threads: Threads that wait for answers of nodes. A node that does not answer delays
            only these threads.
    """

    def __init__(
        self,
        client: Streams,
        server: Streams,
        publishing: Publishing,
        threads: Executor,
        waiting_threads: Executor,
    ) -> None:
        self._client, self._server = client, server
        self._publishing = publishing
        self._threads, self._waiting_threads = threads, waiting_threads
        self._budget = ClientBudget()
        self._outbox = Outbox()
        self._subscribed: set[int] = set()
        self._calls: set[tuple[int, int]] = set()

    async def run(self) -> None:
        """Serve the client until one side closes, or until the client exceeds a limit."""
        ways = [
            asyncio.ensure_future(way)
            for way in (self._from_client(), self._from_server(), self._send())
        ]
        try:
            await asyncio.wait(ways, return_when=asyncio.FIRST_COMPLETED)
        finally:
            for way in ways:
                way.cancel()
            outcomes = await asyncio.gather(*ways, return_exceptions=True)
            # Without a wait: the server may be ending, and nothing depends on it. `close` waits for
            # the end of an `advertise`.
            self._waiting_threads.submit(self._publishing.close)
        for outcome in outcomes:
            if isinstance(outcome, OverBudgetError):
                await self._close(str(outcome))
            elif isinstance(outcome, Exception):
                text = "".join(traceback.format_exception(outcome))
                get_logger("zbot.foxglove").error(text)

    async def _close(self, reason: str) -> None:
        with contextlib.suppress(OSError, asyncio.TimeoutError):
            self._client.writer.write(close_frame(POLICY_VIOLATION, reason))
            await asyncio.wait_for(self._client.writer.drain(), _PATIENCE_S)

    async def _send(self) -> None:
        with contextlib.suppress(OSError):
            while True:
                # Not `writelines`: in Python 3.12.0 to 3.12.8, 3.13.0 and 3.13.1, `drain` does not
                # wait after it, so a slow client fills the memory (CVE-2024-12254).
                for frame in await self._outbox.take():
                    self._client.writer.write(frame)
                await self._client.writer.drain()

    async def _from_server(self) -> None:
        with contextlib.suppress(asyncio.IncompleteReadError, OSError):
            while True:
                frame = await read_frame(self._server.reader, None)
                self._forget_call(frame)
                self._outbox.put(frame)

    def _forget_call(self, frame: Frame) -> None:
        if not self._calls:
            return
        if frame.opcode == BINARY:
            head = frame.content(_CALL_HEAD.size)
            if head[:1] == bytes((_ANSWER,)) and len(head) == _CALL_HEAD.size:
                self._calls.discard(_CALL_HEAD.unpack(head)[1:])
        elif frame.opcode == TEXT and b"serviceCallFailure" in frame.content(100):
            with contextlib.suppress(ZbotError):
                found = read_json_object(frame.content())
                self._calls.discard((found.get("serviceId", -1), found.get("callId", -1)))

    async def _from_client(self) -> None:
        with contextlib.suppress(asyncio.IncompleteReadError, OSError):
            while True:
                message = await self._next_message()
                try:
                    self._budget.check_message(message.size)
                    await self._take(message)
                except ZbotError as error:
                    if str(error):
                        self._outbox.put_status(str(error))
                    await asyncio.sleep(self._budget.refusal_pause_s(message.size))

    async def _next_message(self) -> _Message:
        frames: list[Frame] = []
        size = 0
        while True:
            frame = await read_frame(self._client.reader, MAX_MESSAGE_BYTES - size)
            if frame.is_control:
                await self._pass_on(frame.raw)
                continue
            frames.append(frame)
            size += len(frame.raw)
            if frame.is_last:
                return _Message(frames)
            if len(frames) > _MOST_FRAMES:
                raise OverBudgetError(f"a message has more than {_MOST_FRAMES} frames")

    async def _take(self, message: _Message) -> None:
        if message.opcode == TEXT:
            if message.size > _MOST_TEXT_BYTES:
                raise OverBudgetError(f"an operation has more than {_MOST_TEXT_BYTES} bytes")
            await self._operate(await self._work(self._threads, _fields, message))
            return
        head = message.frames[0].content(_CALL_HEAD.size)
        if head[:1] == bytes((_MESSAGE,)):
            await self._work(self._threads, self._publish, message)
        elif head[:1] == bytes((_CALL,)) and len(head) == _CALL_HEAD.size:
            await self._call(_CALL_HEAD.unpack(head)[1:], message)
        else:
            await self._pass_on(*(frame.raw for frame in message.frames))

    def _publish(self, message: _Message) -> None:
        data = message.content()
        if len(data) < _CHANNEL.size:
            raise OverBudgetError("a message is too short")
        self._publishing.publish(_CHANNEL.unpack_from(data)[1], data[_CHANNEL.size :])

    async def _call(self, call: tuple[int, int], message: _Message) -> None:
        if len(self._calls) >= MAX_CALLS:
            text = f"you wait for {MAX_CALLS} answers already"
            fields = {"serviceId": call[0], "callId": call[1], "message": text}
            self._outbox.put_fields({"op": "serviceCallFailure", **fields})
            return
        self._calls.add(call)
        await self._pass_on(*(frame.raw for frame in message.frames))

    async def _operate(self, fields: dict[str, Any]) -> None:
        op = fields.get("op")
        if op == "advertise":
            await self._advertise(_list(fields, "channels"))
            return
        if op == "unadvertise":
            for number in _list(fields, "channelIds"):
                await self._work(self._threads, self._publishing.unadvertise, _number(number))
            return
        if op == "subscribe":
            fields = self._allowed(fields)
        elif op == "unsubscribe":
            self._subscribed.difference_update(map(_number, _list(fields, "subscriptionIds")))
        elif op in {"getParameters", "setParameters"}:
            self._budget.check_request()
        # The text is written again, so that both sides read the same operation in it.
        await self._pass_on(await self._work(self._threads, _frame_of, fields))

    async def _advertise(self, channels: list[Any]) -> None:
        for channel in channels:
            try:
                # Nodes may have to explain the type of the channel.
                await self._work(self._waiting_threads, self._publishing.advertise, channel)
            except ViewerError as error:
                self._outbox.put_status(str(error))  # the other channels are advertised

    def _allowed(self, fields: dict[str, Any]) -> dict[str, Any]:
        """Return the operation `subscribe` without subscriptions beyond the limit."""
        allowed = []
        for subscription in _list(fields, "subscriptions"):
            number = _number(subscription.get("id") if isinstance(subscription, dict) else None)
            if number in self._subscribed or len(self._subscribed) < MAX_SUBSCRIBED:
                self._subscribed.add(number)
                allowed.append(subscription)
        left = len(fields["subscriptions"]) - len(allowed)
        if left:
            text = f"a client can subscribe to {MAX_SUBSCRIBED} topics: {left} are left out"
            self._outbox.put_status(text)
        return {**fields, "subscriptions": allowed}

    async def _work(self, threads: Executor, function: Callable[[Any], T], argument: Any) -> T:
        """Return the result of a function, called in a thread.

        After that, a client that needs too much has to wait.
        """

        def work() -> T:
            began_s = time.thread_time()
            try:
                return function(argument)
            finally:
                used.append(time.thread_time() - began_s)

        used: list[float] = []
        try:
            return await asyncio.get_running_loop().run_in_executor(threads, work)
        finally:
            if used:
                await asyncio.sleep(self._budget.note_work(used[0]))

    async def _pass_on(self, *blocks: bytes) -> None:
        for block in blocks:
            self._server.writer.write(block)
        await self._server.writer.drain()


def _fields(message: _Message) -> dict[str, Any]:
    return read_json_object(message.content())


def _frame_of(fields: dict[str, Any]) -> bytes:
    return text_frame(fields, is_masked=True)


def _list(fields: dict[str, Any], name: str) -> list[Any]:
    found = fields.get(name)
    if not isinstance(found, list):
        raise OverBudgetError(f"the field {name!r} must be a list")
    return found


def _number(value: Any) -> int:
    return value if isinstance(value, int) else -1
