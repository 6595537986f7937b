"""Queue of the frames that wait for one client of the server for Foxglove."""

from __future__ import annotations

import asyncio
from collections import deque
from typing import TYPE_CHECKING, Any

from zbot.observer.serving.client_budget import MAX_ANSWER_BYTES, MAX_WAITING_BYTES, OverBudgetError
from zbot.web.foxglove.frame import BINARY, text_frame

if TYPE_CHECKING:
    from zbot.web.foxglove.frame import Frame

_BATCH_BYTES = 2**18
_MESSAGE = b"\x01"  #: first byte of a topic's message


class Outbox:
    """Frames that wait for a client. If the client reads slowly, the oldest messages are dropped.

    Only the thread of the server may call the methods.
    """

    def __init__(self) -> None:
        self._answers: deque[bytes] = deque()
        self._messages: deque[bytes] = deque()  #: these may be dropped
        self._answer_bytes = self._message_bytes = 0
        self._dropped = self._reported = 0
        self._has_frames = asyncio.Event()

    def put(self, frame: Frame) -> None:
        """Add a frame of the inner server.

        Raises:
            OverBudgetError: Too many answers wait, which may not be dropped.
        """
        if frame.opcode == BINARY and frame.is_last and frame.content(1) == _MESSAGE:
            self._put_message(frame.raw)
        else:
            self._put_answer(frame.raw)

    def put_status(self, text: str) -> None:
        """Add an error for the client."""
        self.put_fields({"op": "status", "level": 2, "message": text})

    def put_fields(self, fields: dict[str, Any]) -> None:
        """Add an answer."""
        self._put_answer(text_frame(fields))

    def _put_message(self, raw: bytes) -> None:
        self._messages.append(raw)
        self._message_bytes += len(raw)
        while self._message_bytes > MAX_WAITING_BYTES and len(self._messages) > 1:
            self._message_bytes -= len(self._messages.popleft())
            self._dropped += 1
        self._has_frames.set()

    def _put_answer(self, raw: bytes) -> None:
        self._answers.append(raw)
        self._answer_bytes += len(raw)
        if self._answer_bytes > MAX_ANSWER_BYTES and len(self._answers) > 1:
            raise OverBudgetError("too many answers wait, as you read too slowly")
        self._has_frames.set()

    async def take(self) -> list[bytes]:
        """Wait for frames, and remove and return some. Answers come first."""
        await self._has_frames.wait()
        self._report_dropped()
        taken: list[bytes] = []
        size = 0
        while size < _BATCH_BYTES and (self._answers or self._messages):
            taken.append(self._next())
            size += len(taken[-1])
        if not self._answers and not self._messages:
            self._has_frames.clear()
        return taken

    def _next(self) -> bytes:
        if self._answers:
            raw = self._answers.popleft()
            self._answer_bytes -= len(raw)
        else:
            raw = self._messages.popleft()
            self._message_bytes -= len(raw)
        return raw

    def _report_dropped(self) -> None:
        # The first loss, and then each time the number has doubled, so that reports stay few.
        if self._dropped >= max(1, 2 * self._reported):
            self._reported = self._dropped
            text = f"{self._dropped} messages were dropped, as you read too slowly"
            self.put_status(text)
