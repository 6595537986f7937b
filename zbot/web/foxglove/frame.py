"""Frames of WebSockets (RFC 6455), which the guard of the server for Foxglove reads and writes."""

from __future__ import annotations

import json
import struct
from typing import TYPE_CHECKING, Any, NamedTuple

from zbot.observer.serving.client_budget import MAX_MESSAGE_BYTES, OverBudgetError

if TYPE_CHECKING:
    import asyncio

TEXT, BINARY, CLOSE = 1, 2, 8
POLICY_VIOLATION = 1008
_LAST, _OPCODE, _MASKED = 0x80, 0x0F, 0x80
_KEY_BYTES = 4
_BLOCK_BYTES = 65_536  # a multiple of the key's length
_MOST_REASON = 120  # bytes; a control frame has at most 125


class Frame(NamedTuple):
    """Frame as it travels, and what it contains."""

    raw: bytes
    opcode: int
    is_last: bool  #: whether it is the last frame of its message
    start: int  #: where the content starts in `raw`
    key: bytes  #: the mask of the content, or nothing

    @property
    def is_control(self) -> bool:
        """Whether the frame is a ping, a pong or a close."""
        return self.opcode >= CLOSE

    def content(self, size: int | None = None) -> bytes:
        """Return the first bytes of the content, or all of them."""
        end = len(self.raw) if size is None else self.start + size
        data = self.raw[self.start : end]
        return _unmasked(data, self.key) if self.key else data


async def read_frame(reader: asyncio.StreamReader, most: int | None = MAX_MESSAGE_BYTES) -> Frame:
    """Return the next frame.

    Args:
        reader: The connection.
        most: The largest size of the content in bytes, or None for no limit.

    Raises:
        IncompleteReadError: The connection has ended.
        OverBudgetError: The content is too large.
    """
    head = await reader.readexactly(2)
    size = head[1] & ~_MASKED
    if size >= 126:
        head += await reader.readexactly(2 if size == 126 else 8)
        size = int.from_bytes(head[2:], "big")
    if most is not None and size > most:
        raise OverBudgetError(f"a message has more than {most} bytes")
    start = len(head)
    key = b""
    if head[1] & _MASKED:
        key = await reader.readexactly(_KEY_BYTES)
        start += _KEY_BYTES
    raw = b"".join((head, key, await reader.readexactly(size)))
    return Frame(raw, head[0] & _OPCODE, bool(head[0] & _LAST), start, key)


def _unmasked(data: bytes, key: bytes) -> bytes:
    # In blocks, because other threads wait while one number is made.
    blocks = (data[at : at + _BLOCK_BYTES] for at in range(0, len(data), _BLOCK_BYTES))
    return b"".join(_xor(block, key) for block in blocks)


def _xor(block: bytes, key: bytes) -> bytes:
    size = len(block)
    mask = (key * (size // _KEY_BYTES + 1))[:size]
    number = int.from_bytes(block, "little") ^ int.from_bytes(mask, "little")
    return number.to_bytes(size, "little")


def text_frame(fields: dict[str, Any], *, is_masked: bool = False) -> bytes:
    """Return a frame with a JSON object. The frames of a client must be masked."""
    return _frame(TEXT, json.dumps(fields, separators=(",", ":")).encode(), is_masked=is_masked)


def close_frame(code: int, reason: str) -> bytes:
    """Return the frame that ends a connection."""
    text = reason.encode()[:_MOST_REASON].decode(errors="ignore")
    return _frame(CLOSE, struct.pack(">H", code) + text.encode())


def _frame(opcode: int, content: bytes, *, is_masked: bool = False) -> bytes:
    size, mask = len(content), _MASKED if is_masked else 0
    head = bytes((_LAST | opcode,))
    if size < 126:
        head += bytes((mask | size,))
    elif size < 2**16:
        head += struct.pack(">BH", mask | 126, size)
    else:
        head += struct.pack(">BQ", mask | 127, size)
    return head + bytes(_KEY_BYTES if is_masked else 0) + content
