"""Tests of the frames of WebSockets, and of the frames that wait for a client."""

from __future__ import annotations

import asyncio
import json
import struct

import pytest

from zbot.observer.serving.client_budget import OverBudgetError
from zbot.web.foxglove import outbox as outbox_module
from zbot.web.foxglove.frame import BINARY, TEXT, Frame, close_frame, read_frame, text_frame
from zbot.web.foxglove.outbox import Outbox

KEY = b"\x01\x02\x03\x04"


def masked(opcode: int, content: bytes) -> bytes:
    hidden = bytes(octet ^ KEY[index % 4] for index, octet in enumerate(content))
    return struct.pack(">BBH", 0x80 | opcode, 0x80 | 126, len(content)) + KEY + hidden


def read(data: bytes, most: int | None = 1000) -> Frame:
    async def feed() -> Frame:
        reader = asyncio.StreamReader()
        reader.feed_data(data)
        reader.feed_eof()
        return await read_frame(reader, most)

    return asyncio.run(feed())


@pytest.mark.parametrize("size", [0, 1, 3, 4, 125, 126, 999])
def test_a_masked_frame_is_read(size: int) -> None:
    content = bytes(index % 251 for index in range(size))
    raw = masked(BINARY, content)
    frame = read(raw + b"next")
    assert (frame.opcode, frame.is_last, frame.raw) == (BINARY, True, raw)
    assert frame.content() == content
    assert frame.content(3) == content[:3]


@pytest.mark.parametrize("size", [1, 200, 70_000])
@pytest.mark.parametrize("is_masked", [False, True])
def test_what_is_written_is_read(size: int, is_masked: bool) -> None:
    fields = {"op": "status", "message": "x" * size}
    frame = read(text_frame(fields, is_masked=is_masked), None)
    assert frame.opcode == TEXT
    assert json.loads(frame.content()) == fields


def test_a_frame_that_is_too_large_is_refused_before_it_is_read() -> None:
    head = struct.pack(">BBQ", 0x82, 0xFF, 2**40) + KEY
    with pytest.raises(OverBudgetError, match="more than 1000 bytes"):
        read(head)


def test_a_frame_that_ends_too_early_is_an_end() -> None:
    with pytest.raises(asyncio.IncompleteReadError):
        read(masked(TEXT, b"hello")[:-1])


def test_the_reason_of_an_end_is_never_too_long() -> None:
    frame = read(close_frame(1008, "ä" * 200), None)
    assert frame.is_control
    assert 100 < len(frame.content()) <= 125
    frame.content()[2:].decode()


def message(number: int, size: int = 100) -> Frame:
    content = b"\x01" + bytes((number,)) + bytes(size)
    return read(struct.pack(">BBH", 0x82, 126, len(content)) + content)


def taken(outbox: Outbox) -> list[bytes]:
    return asyncio.run(outbox.take())


def test_a_slow_client_keeps_the_newest_messages_and_is_told(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(outbox_module, "MAX_WAITING_BYTES", 350)
    outbox = Outbox()
    for number in range(10):
        outbox.put(message(number))
    status, *messages = taken(outbox)
    assert b"7 messages were dropped, as you read too slowly" in status
    assert [raw[5] for raw in messages] == [7, 8, 9]


def fill(outbox: Outbox) -> None:
    for _ in range(10):
        outbox.put_status("x" * 100)


def test_answers_are_never_dropped_and_end_a_client_that_does_not_read(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(outbox_module, "MAX_ANSWER_BYTES", 350)
    outbox = Outbox()
    outbox.put_status("first")
    for number in range(5):
        outbox.put(message(number))
    assert b"first" in taken(outbox)[0]
    with pytest.raises(OverBudgetError, match="too many answers wait"):
        fill(outbox)
