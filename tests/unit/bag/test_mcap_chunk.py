"""Tests of reading the chunks of MCAP files."""

from __future__ import annotations

import struct
from typing import TYPE_CHECKING

import pytest
from mcap.writer import CompressionType
from mcap.writer import Writer as McapLibraryWriter

from zbot.bag.errors import BagReadError
from zbot.bag.mcap_reader import McapReader

if TYPE_CHECKING:
    from pathlib import Path

NONE = CompressionType.NONE
TIMES = (5, 1, 9, 3, 7, 2, 8, 4, 6, 5)


def write(path: Path) -> None:
    """Write a file with a chunk for each message or two, without an order."""
    with path.open("wb") as stream:
        writer = McapLibraryWriter(stream, chunk_size=60, compression=NONE, enable_crcs=False)
        writer.start()
        channel = writer.register_channel("/x", "cdr", 0)
        for log_ns in TIMES:
            writer.add_message(channel, log_ns, bytes([log_ns]) * 20, log_ns)
        writer.finish()  # type: ignore[no-untyped-call]


def test_chunks_that_overlap_are_read_in_the_order_of_their_times(tmp_path: Path) -> None:
    write(tmp_path / "x.mcap")
    reader = McapReader(tmp_path / "x.mcap")
    found = [(message.log_ns, message.data) for message in reader.messages(None, 0, None)]
    assert found == [(number, bytes([number]) * 20) for number in sorted(TIMES)]
    assert [message.log_ns for message in reader.messages(["/x"], 3, 5)] == [3, 4, 5, 5]
    assert list(reader.messages(["/y"], 0, None)) == []


@pytest.mark.parametrize("length", [3, 10_000])
def test_a_message_of_a_wrong_length_is_one_error(tmp_path: Path, length: int) -> None:
    path = tmp_path / "x.mcap"
    write(path)
    data = path.read_bytes()
    record = struct.pack("<BQ", 5, 22 + 20)
    assert record in data
    damaged = data.replace(record, struct.pack("<BQ", 5, length), 1)
    path.write_bytes(damaged)
    reader = McapReader(path)
    with pytest.raises(BagReadError):
        list(reader.messages(None, 0, None))
