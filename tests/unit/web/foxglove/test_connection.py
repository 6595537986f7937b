"""Tests of a client's connection to the server for Foxglove."""

from __future__ import annotations

import asyncio
import threading
from concurrent.futures import ThreadPoolExecutor
from typing import TYPE_CHECKING, Any

from zbot.text.json_reader import read_json_object
from zbot.web.foxglove import connection
from zbot.web.foxglove.connection import Connection, Streams
from zbot.web.foxglove.frame import text_frame

if TYPE_CHECKING:
    import pytest


class Writer:
    """One direction of a connection, without a network."""

    def __init__(self) -> None:
        self.has_written = asyncio.Event()

    def write(self, _data: bytes) -> None:
        self.has_written.set()

    async def drain(self) -> None: ...


class FakePublishing:
    """Publishers of a client. No node explains a type before `answer`."""

    def __init__(self, answer: threading.Event) -> None:
        self._answer = answer
        self.removed = threading.Event()
        self.closed = threading.Event()

    def advertise(self, _channel: Any) -> None:
        assert self._answer.wait(10.0)

    def unadvertise(self, _number: int) -> None:
        self.removed.set()

    def close(self) -> None:
        self.closed.set()


def test_a_client_that_advertises_an_unknown_type_does_not_delay_others() -> None:
    async def run() -> None:
        answer = threading.Event()
        pools = ThreadPoolExecutor(1), ThreadPoolExecutor(1)
        readers = asyncio.StreamReader(), asyncio.StreamReader()
        publishers = FakePublishing(answer), FakePublishing(answer)
        tasks = []
        for reader, publishing in zip(readers, publishers, strict=True):
            other: Any = Writer()
            given: Any = publishing
            streams = Streams(reader, other), Streams(asyncio.StreamReader(), other)
            tasks.append(asyncio.create_task(Connection(*streams, given, *pools).run()))
        readers[0].feed_data(text_frame({"op": "advertise", "channels": [{}]}, is_masked=True))
        readers[1].feed_data(text_frame({"op": "unadvertise", "channelIds": [1]}, is_masked=True))
        assert await asyncio.to_thread(publishers[1].removed.wait, 5.0)
        answer.set()
        for reader in readers:
            reader.feed_eof()
        await asyncio.gather(*tasks)
        for publishing in publishers:
            assert await asyncio.to_thread(publishing.closed.wait, 5.0)

    asyncio.run(run())


def test_operations_are_read_and_written_in_threads(monkeypatch: pytest.MonkeyPatch) -> None:
    used: list[int] = []

    def noted(function: Any) -> Any:
        def call(*arguments: Any, **more: Any) -> Any:
            used.append(threading.get_ident())
            return function(*arguments, **more)

        return call

    monkeypatch.setattr(connection, "read_json_object", noted(read_json_object))
    monkeypatch.setattr(connection, "text_frame", noted(text_frame))

    async def run() -> None:
        pools = ThreadPoolExecutor(1), ThreadPoolExecutor(1)
        reader, server = asyncio.StreamReader(), Writer()
        writers: Any = Writer(), server
        publishing: Any = FakePublishing(threading.Event())
        streams = Streams(reader, writers[0]), Streams(asyncio.StreamReader(), writers[1])
        task = asyncio.create_task(Connection(*streams, publishing, *pools).run())
        reader.feed_data(text_frame({"op": "subscribe", "subscriptions": []}, is_masked=True))
        await asyncio.wait_for(server.has_written.wait(), 5.0)
        reader.feed_eof()
        await task

    asyncio.run(run())
    assert len(used) == 2
    assert threading.get_ident() not in used
