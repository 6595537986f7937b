"""Parts of a proxy: it reads the head of a request, and copies data between two servers."""

from __future__ import annotations

import asyncio

_MOST_BYTES = 16_384
_PATIENCE_S = 5.0
#: Connections that have not sent a request yet. Beyond this number, the oldest is closed.
_MAX_SILENT = 100
_BLOCK_BYTES = 2**18


class HeadReader:
    """Reader of the heads of requests. Too many connections that send nothing are closed."""

    def __init__(self) -> None:
        self._silent: dict[asyncio.StreamWriter, None] = {}

    async def read(
        self, reader: asyncio.StreamReader, writer: asyncio.StreamWriter
    ) -> bytes | None:
        """Return the head of a request. Return None if it is too long, or does not come in 5 s."""
        self._silent[writer] = None
        if len(self._silent) > _MAX_SILENT:
            oldest = next(iter(self._silent))
            del self._silent[oldest]
            oldest.transport.abort()
        try:
            return await _read_head(reader)
        finally:
            self._silent.pop(writer, None)


async def _read_head(reader: asyncio.StreamReader) -> bytes | None:
    try:
        head = await asyncio.wait_for(reader.readuntil(b"\r\n\r\n"), _PATIENCE_S)
    except (asyncio.IncompleteReadError, asyncio.LimitOverrunError, asyncio.TimeoutError):
        return None
    return head if len(head) <= _MOST_BYTES else None


async def copy(reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
    """Copy data until its side closes."""
    while data := await reader.read(_BLOCK_BYTES):
        writer.write(data)
        await writer.drain()


async def copy_both(
    reader: asyncio.StreamReader,
    writer: asyncio.StreamWriter,
    inner_reader: asyncio.StreamReader,
    inner_writer: asyncio.StreamWriter,
) -> None:
    """Copy data in both directions until one side closes."""
    ways = [
        asyncio.ensure_future(copy(reader, inner_writer)),
        asyncio.ensure_future(copy(inner_reader, writer)),
    ]
    await asyncio.wait(ways, return_when=asyncio.FIRST_COMPLETED)
    for way in ways:
        way.cancel()
    await asyncio.gather(*ways, return_exceptions=True)
