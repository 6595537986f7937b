from __future__ import annotations

import asyncio
from typing import Any

from zbot.observer.serving.proxy import HeadReader


class Writer:
    """Connection that can be closed."""

    def __init__(self) -> None:
        self.transport = self
        self.is_closed = False

    def abort(self) -> None:
        self.is_closed = True


def test_the_oldest_connection_is_closed_if_too_many_send_nothing() -> None:
    async def run() -> None:
        heads = HeadReader()
        writers: list[Any] = [Writer() for _ in range(101)]
        readers = [asyncio.StreamReader() for _ in writers]
        reads = [
            asyncio.create_task(heads.read(reader, writer))
            for reader, writer in zip(readers, writers, strict=True)
        ]
        await asyncio.sleep(0)
        assert [writer.is_closed for writer in writers] == [True] + 100 * [False]
        for reader in readers:
            reader.feed_data(b"GET / HTTP/1.1\r\n\r\n")
        assert set(await asyncio.gather(*reads)) == {b"GET / HTTP/1.1\r\n\r\n"}

    asyncio.run(run())
