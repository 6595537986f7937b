"""Tests of the forms of files: sqlite3, compression and options."""

from __future__ import annotations

import shutil
import sqlite3
from typing import TYPE_CHECKING, Any

import pytest
from mcap.reader import make_reader
from rosbags.highlevel import AnyReader

import zbot.bag
from tests.unit.bag.messages import (
    LATCHED,
    MESSAGES,
    WITHOUT_CHAR,
    expected,
    names_and_messages,
    write,
)
from zbot.bag import Reader, TopicMetadata, Writer
from zbot.bag.conversion import reindex
from zbot.bag.errors import BagValueError
from zbot.bag.mcap_options import read_storage_config
from zbot.wire.serialization import serialize_message

from std_msgs.msg import Float64, String

if TYPE_CHECKING:
    from pathlib import Path


def test_a_sqlite_bag_of_foxy_is_read(tmp_path: Path) -> None:
    path = tmp_path / "old.db3"
    bag = sqlite3.connect(path)
    bag.executescript(
        "CREATE TABLE topics(id INTEGER PRIMARY KEY, name TEXT, type TEXT, "
        "serialization_format TEXT, offered_qos_profiles TEXT);"
        "CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id INTEGER, timestamp INTEGER, "
        "data BLOB);"
    )
    profile = "- {history: 1, depth: 5, reliability: 2, deadline: {sec: 2147483647, nsec: 0}}"
    bag.execute("INSERT INTO topics VALUES (1, '/a', 'std_msgs/msg/String', 'cdr', ?)", (profile,))
    data = serialize_message(String(data="old"))
    bag.execute("INSERT INTO messages VALUES (1, 1, 9, ?)", (data,))
    bag.commit()
    bag.close()
    assert list(zbot.bag.read(path)) == [("/a", String(data="old"), 9)]
    with Reader(path) as read:
        [qos] = read.topics["/a"].offered_qos_profiles
    assert (qos.depth, qos.reliability.short_key) == (5, "best_effort")


def test_compressed_files_are_read(path: Path) -> None:
    messages = [String(data="a"), Float64()]
    write(path, messages, compress_files=True)
    assert [file.name for file in path.glob("*.zstd")] == ["lesson_0.mcap.zstd"]
    assert names_and_messages(path) == expected(messages)
    with AnyReader([path]) as bag:
        assert bag.message_count == 2


def test_rosbags_reads_a_sqlite_bag(path: Path) -> None:
    write(path, WITHOUT_CHAR, storage_id="sqlite3")
    with AnyReader([path]) as read:
        found: list[Any] = [
            (connection.topic, read.deserialize(data, connection.msgtype))
            for connection, _, data in read.messages()
        ]
        connections: list[Any] = read.connections
        assert {connection.topic for connection in connections} == {topic for topic, _ in found}
        assert all(connection.ext.offered_qos_profiles for connection in connections)
    assert len(found) == len(WITHOUT_CHAR)
    assert found[0][1].data == "hello"


def test_a_sqlite_bag_is_read_as_it_was_written(path: Path) -> None:
    write(path, MESSAGES, storage_id="sqlite3", max_duration_s=0.005)
    assert names_and_messages(path) == expected(MESSAGES)
    names = [f"lesson_{number}.db3" for number in range(3)]
    assert sorted(file.name for file in path.glob("*.db3")) == names
    with Reader(path) as bag, Reader(path, uses_metadata_file=False) as scanned:
        assert bag.metadata.storage_id == "sqlite3"
        assert bag.topics == scanned.topics
        assert bag.metadata.files == scanned.metadata.files


def test_an_unfinished_sqlite_bag_is_read_up_to_its_last_flush(path: Path, tmp_path: Path) -> None:
    with Writer(path, storage_id="sqlite3") as bag:
        bag.write("/a", String(data="kept"), 1)
        bag.flush()
        bag.write("/a", String(data="lost"), 2)
        copy = tmp_path / "copy"
        shutil.copytree(path, copy)
    assert [message.data for _, message, _ in zbot.bag.read(copy)] == ["kept"]
    assert reindex(copy).message_count == 1


@pytest.mark.parametrize("name", ["Zstd", "Lz4", "None"])
def test_a_storage_config_selects_the_form_of_the_file(
    path: Path, tmp_path: Path, name: str
) -> None:
    config = tmp_path / "mcap.yaml"
    config.write_text(f"compression: {name}\nchunkSize: 4096\nnoChunkCRC: true\n")
    options = read_storage_config(config, "zstd_small")
    write(path, [String(data="x" * 1000)] * 20, mcap_options=options)
    assert names_and_messages(path) == [("/string", String(data="x" * 1000))] * 20
    with (path / "lesson_0.mcap").open("rb") as stream:
        summary = make_reader(stream).get_summary()
    assert summary is not None
    assert len(summary.chunk_indexes) >= 4
    assert {index.compression for index in summary.chunk_indexes} == {
        name.lower().replace("none", "")
    }


@pytest.mark.parametrize(
    ("text", "sentence"),
    [
        ("compression: gzip", "choose Zstd, Lz4 or None"),
        ("chunkSize: 1", "choose 1024 to"),
        ("noChunking: 3", "must be true or false"),
        ("colour: red", "does not know the key 'colour'"),
        ("[1]", "cannot use the storage options"),
    ],
)
def test_a_wrong_storage_config_is_one_sentence(tmp_path: Path, text: str, sentence: str) -> None:
    config = tmp_path / "mcap.yaml"
    config.write_text(text)
    with pytest.raises(BagValueError, match=sentence):
        read_storage_config(config, "zstd")


@pytest.mark.parametrize("storage_id", ["mcap", "sqlite3"])
def test_latched_messages_begin_each_file(path: Path, storage_id: str) -> None:
    with Writer(path, storage_id=storage_id, repeats_latched=True) as bag:
        bag.create_topic(TopicMetadata("/map", "std_msgs/msg/String", "cdr", (LATCHED,)))
        bag.create_topic(TopicMetadata("/a", "std_msgs/msg/String"))
        for number in range(5):
            bag.write("/map", String(data=str(number)), number)
        bag.write("/a", String(data="first"), 10)
        bag.split()
        bag.split()  # nothing was written since, apart from the latched messages
        bag.write("/a", String(data="second"), 2**62)
    [first, *_, last] = sorted(path.glob("lesson_*"))
    assert [m.data for _, m, _ in zbot.bag.read(first)] == ["0", "1", "2", "3", "4", "first"]
    assert [m.data for _, m, _ in zbot.bag.read(last)] == ["2", "3", "4", "second"]


@pytest.mark.parametrize("storage_id", ["mcap", "sqlite3"])
def test_a_clock_that_jumps_loses_no_messages(path: Path, storage_id: str) -> None:
    times = [100, 101, 50, 51, 2**62, 102]
    with Writer(path, storage_id=storage_id) as bag:
        for time_ns in times:
            bag.write("/a", String(data=str(time_ns)), time_ns)
            bag.flush()
    with Reader(path) as read:
        assert read.metadata.start_ns == 50
        assert read.metadata.end_ns == 2**62
    assert [t for _, _, t in zbot.bag.read(path)] == sorted(times)


@pytest.mark.parametrize("storage_id", ["mcap", "sqlite3"])
def test_compressed_messages_are_read_with_and_without_metadata(
    path: Path, storage_id: str
) -> None:
    message = String(data="x" * 10_000)
    write(path, [message] * 3, storage_id=storage_id, compress_messages=True)
    assert sum(file.stat().st_size for file in path.iterdir()) < 60_000
    with Reader(path) as bag:
        assert bag.metadata.compression_mode == "MESSAGE"
    assert names_and_messages(path) == [("/string", message)] * 3
    (path / "metadata.yaml").unlink()
    assert names_and_messages(path) == [("/string", message)] * 3
