"""Tests of bags that were made to fill the memory, to hang, or to read other files."""

from __future__ import annotations

import os
import sqlite3
import struct
import sys
import tracemalloc
from contextlib import closing
from typing import TYPE_CHECKING, Any

import pytest
import zstandard
from mcap.opcode import Opcode
from mcap.records import Chunk
from mcap.writer import CompressionType
from mcap.writer import Writer as McapLibraryWriter

from tests.unit.bag.messages import write
from zbot.bag import mcap_chunk, metadata
from zbot.bag import reader as reader_module
from zbot.bag.errors import BagReadError, BagTypeError, BagValueError
from zbot.bag.mcap_chunk import chunk_data, records
from zbot.bag.mcap_reader import McapReader
from zbot.bag.reader import Reader
from zbot.bag.selection import Selection
from zbot.bag.sqlite_reader import SqliteReader
from zbot.wire.serialization import serialize_message

from std_msgs.msg import String

if TYPE_CHECKING:
    from pathlib import Path

MB = 2**20


def chunk(compression: str, data: bytes, size: int) -> Chunk:
    return Chunk(
        compression=compression,
        data=data,
        message_end_time=0,
        message_start_time=0,
        uncompressed_crc=0,
        uncompressed_size=size,
    )


def packed(compression: str, data: bytes) -> bytes:
    if compression == "zstd":
        return zstandard.ZstdCompressor(write_content_size=False).compress(data)
    frame: Any = pytest.importorskip("lz4.frame", reason="lz4 is not installed")
    found: bytes = frame.compress(data, store_size=False)
    return found


@pytest.mark.parametrize("compression", ["zstd", "lz4"])
def test_a_chunk_that_expands_more_than_it_says_is_refused(compression: str) -> None:
    data = packed(compression, bytes(64 * MB))
    assert chunk_data(chunk(compression, packed(compression, b"abc"), 3)) == b"abc"
    tracemalloc.start()
    with pytest.raises(ValueError, match="bytes and says that it has 1000"):
        chunk_data(chunk(compression, data, 1000))
    assert tracemalloc.get_traced_memory()[1] < 16 * MB
    tracemalloc.stop()


def test_a_chunk_that_says_it_is_huge_is_refused() -> None:
    with pytest.raises(ValueError, match="a chunk has 1099511627776 bytes, and the limit is"):
        chunk_data(chunk("zstd", packed("zstd", b"abc"), 2**40))


def test_the_records_of_a_chunk_are_limited(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(mcap_chunk, "_MAX_RECORDS", 3)
    record = struct.pack("<BQ", Opcode.MESSAGE_INDEX, 0)
    assert len(list(records(record * 2))) == 2
    with pytest.raises(ValueError, match="more than 3 records"):
        list(records(record * 4))


def mcap_file(path: Path) -> Path:
    with path.open("wb") as stream:
        writer = McapLibraryWriter(stream, compression=CompressionType.NONE)
        writer.start()
        schema = writer.register_schema("std_msgs/msg/String", "ros2msg", b"string data")
        channel = writer.register_channel("/x", "cdr", schema)
        writer.add_message(channel, 5, serialize_message(String(data="hello")), 5)
        writer.finish()  # type: ignore[no-untyped-call]
    return path


def test_a_chunk_whose_length_is_beyond_the_file_is_one_error(tmp_path: Path) -> None:
    path = mcap_file(tmp_path / "x.mcap")
    data = bytearray(path.read_bytes())
    place = data.index(b"MCAP0") + 7
    while data[place] != Opcode.CHUNK:
        place += 9 + struct.unpack_from("<Q", data, place + 1)[0]
    struct.pack_into("<Q", data, place + 1, 2**61)
    path.write_bytes(data)
    reader = McapReader(path)
    with pytest.raises(BagReadError):
        list(reader.messages(None, 0, None))


def test_an_index_that_names_a_chunk_many_times_is_one_error(tmp_path: Path) -> None:
    reader = McapReader(mcap_file(tmp_path / "x.mcap"))
    reader._contents.chunks *= 1000
    with pytest.raises(BagReadError, match="names the same chunk several times"):
        list(reader.messages(None, 0, None))


def test_a_chunk_whose_place_is_beyond_the_file_is_one_error(tmp_path: Path) -> None:
    path = mcap_file(tmp_path / "x.mcap")
    reader = McapReader(path)
    with path.open("rb") as stream, pytest.raises(ValueError, match="a chunk is at byte"):
        mcap_chunk._chunk_at(stream, 2**63 - 1)
    reader._contents.chunks[0].chunk_start_offset = 2**63 - 1
    with pytest.raises(BagReadError, match="a chunk is at byte"):
        list(reader.messages(None, 0, None))


def bag(path: Path, *names: str) -> Path:
    """Write a bag whose description names other files."""
    write(path, [String(data="hello")])
    description = path / "metadata.yaml"
    text = description.read_text()
    listed = "".join(f"  - {name}\n" for name in names)
    begin = text.index("  relative_file_paths:\n") + len("  relative_file_paths:\n")
    end = text.index("  files:")
    description.write_text(text[:begin] + listed + text[end:])
    return path


@pytest.mark.parametrize("name", ["../secret.mcap", "a/../../secret.mcap", "{}/secret.mcap"])
def test_a_bag_never_names_files_outside_its_folder(tmp_path: Path, name: str) -> None:
    mcap_file(tmp_path / "secret.mcap")
    path = bag(tmp_path / "lesson", name.format(tmp_path))
    with pytest.raises(BagReadError, match=r"its file secret\.mcap is missing"):
        Reader(path)


def test_a_file_in_the_folder_is_found_whatever_its_path_says(tmp_path: Path) -> None:
    path = bag(tmp_path / "lesson", "/home/ana/lesson/lesson_0.mcap")
    with Reader(path) as reader:
        assert reader.metadata.message_count == 1


@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no such pipes")
def test_a_pipe_is_no_bag(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "x.mcap")
    for path in (tmp_path, tmp_path / "x.mcap"):
        with pytest.raises(BagReadError, match="it is no file"):
            Reader(path)


def test_a_compressed_file_that_becomes_too_large_is_refused(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(reader_module, "_MOST_UNPACKED_BYTES", MB)
    path = tmp_path / "x.mcap.zstd"
    path.write_bytes(packed("zstd", bytes(16 * MB)))
    with pytest.raises(BagReadError, match="it becomes larger than"):
        Reader(path)


TOPICS = "CREATE TABLE topics(id, name, type, serialization_format)"
MESSAGES = "CREATE TABLE messages(id, topic_id, timestamp, data)"
ENDLESS = "WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n) SELECT i AS id"


def database(path: Path, *statements: str) -> Path:
    with closing(sqlite3.connect(path)) as connection:
        for statement in statements:
            connection.execute(statement)
        connection.execute("INSERT INTO topics VALUES (1, '/a', 'std_msgs/msg/String', 'cdr')")
        connection.commit()
    return path


@pytest.mark.parametrize(
    "messages",
    [
        f"CREATE VIEW messages AS {ENDLESS}, 1 AS topic_id, i AS timestamp, x'00' AS data FROM n",
        "CREATE TABLE messages(id, topic_id, timestamp, data AS (zeroblob(2000000000)))",
        "CREATE TABLE messages(id, topic_id, timestamp, data AS (zeroblob(9)) STORED)",
    ],
)
def test_a_database_that_computes_its_messages_is_refused(tmp_path: Path, messages: str) -> None:
    path = database(tmp_path / "x.db3", TOPICS, messages)
    with pytest.raises(BagReadError, match=r"messages is no table|of messages is computed"):
        SqliteReader(path)


@pytest.mark.parametrize("data", ["10000000000", "'text'", "1.5", "NULL"])
def test_a_message_that_is_not_made_of_bytes_is_one_error(tmp_path: Path, data: str) -> None:
    insert = f"INSERT INTO messages VALUES (1, 1, 5, {data})"
    path = database(tmp_path / "x.db3", TOPICS, MESSAGES, insert)
    with pytest.raises(BagReadError, match="not made of bytes"):
        list(SqliteReader(path).messages(None, 0, None))


def test_sizes_in_a_damaged_database_are_one_error(tmp_path: Path) -> None:
    path = database(tmp_path / "x.db3", "PRAGMA page_size = 512", TOPICS, MESSAGES)
    data = path.read_bytes()
    reasons = set()
    for place in range(100, 512):
        path.write_bytes(data[:place] + b"\xff" * 9 + data[place + 9 :])
        try:
            list(SqliteReader(path).messages(None, 0, None))
        except BagReadError as error:
            reasons.add(str(error))
    assert any("a size in it is too large" in reason for reason in reasons), reasons


def test_a_trigger_does_not_run(tmp_path: Path) -> None:
    trigger = "CREATE TRIGGER t AFTER INSERT ON messages BEGIN DELETE FROM topics; END"
    path = database(tmp_path / "x.db3", TOPICS, MESSAGES, trigger)
    before = path.read_bytes()
    assert [topic.topic.name for topic in SqliteReader(path).metadata.topics] == ["/a"]
    assert path.read_bytes() == before


def test_definitions_in_a_circle_are_one_error(tmp_path: Path) -> None:
    path = tmp_path / "x.mcap"
    text = f"circle_msgs/B b\n{'=' * 80}\nMSG: circle_msgs/B\ncircle_msgs/A a\n"
    with path.open("wb") as stream:
        writer = McapLibraryWriter(stream)
        writer.start()
        schema = writer.register_schema("circle_msgs/msg/A", "ros2msg", text.encode())
        writer.add_message(writer.register_channel("/x", "cdr", schema), 5, b"\0\1\0\0", 5)
        writer.finish()  # type: ignore[no-untyped-call]
    with Reader(path) as reader, pytest.raises(BagTypeError):
        reader.message_class(reader.topics["/x"])


def test_profiles_that_many_topics_share_are_read_once(monkeypatch: pytest.MonkeyPatch) -> None:
    calls: list[object] = []

    def note(value: object) -> list[object]:
        calls.append(value)
        return []

    monkeypatch.setattr(metadata, "read_profiles", note)
    topic = "{topic_metadata: {name: a, type: b, serialization_format: cdr, "
    shared = "&a " + topic + 'offered_qos_profiles: "- {}"}, message_count: 0}'
    text = metadata.metadata_text(metadata.BagMetadata("mcap"))
    aliases = ", *a" * 1000
    changed = text.replace("_count: []", f"_count: [{shared}{aliases}]")
    assert len(metadata.read_metadata(changed).topics) == 1001
    assert calls == ["- {}"]


def test_a_file_that_the_metadata_name_often_is_read_once(tmp_path: Path) -> None:
    mcap_file(tmp_path / "x.mcap")
    text = metadata.metadata_text(metadata.BagMetadata("mcap", paths=("x.mcap", "a/x.mcap") * 9))
    (tmp_path / metadata.METADATA_FILE).write_text(text)
    with Reader(tmp_path) as bag:
        assert len(bag._files) == 1


def test_topics_with_one_type_read_its_definition_once(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    calls: list[str] = []

    def note(name: str, *_: object) -> type[Any]:
        calls.append(name)
        return String

    monkeypatch.setattr(reader_module, "message_class", note)
    with Reader(mcap_file(tmp_path / "x.mcap")) as bag:
        (topic, *_) = bag.topics.values()
        for _ in range(5):
            bag.message_class(topic)
    assert calls == [topic.type_name]


@pytest.mark.parametrize("pattern", ["(" * 3000 + ")" * 3000, "a{99999999999}", "["])
def test_an_odd_regular_expression_is_one_error(pattern: str) -> None:
    with pytest.raises(BagValueError, match="is not a regular expression"):
        Selection(regex=pattern)
