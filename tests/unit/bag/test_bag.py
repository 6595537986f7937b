"""Tests of bags: what zbot writes is read by other readers, and what others wrote by zbot."""

from __future__ import annotations

import contextlib
import importlib
import sys
from typing import TYPE_CHECKING, Any

import pytest
import yaml
from mcap.reader import make_reader
from mcap.writer import Writer as McapLibraryWriter
from mcap_ros2.decoder import DecoderFactory
from rosbags.highlevel import AnyReader
from rosbags.rosbag2 import StoragePlugin
from rosbags.rosbag2 import Writer as RosbagsWriter
from rosbags.typesys import Stores, get_typestore

import zbot.bag
from tests.unit.bag.messages import (
    LATCHED,
    MESSAGES,
    WITHOUT_CHAR,
    expected,
    names_and_messages,
    write,
)
from zbot.bag import Reader, Writer
from zbot.bag.definition import definition_text
from zbot.bag.errors import (
    BagError,
    BagExistsError,
    BagNotFoundError,
    BagReadError,
    BagValueError,
    BagWriteError,
    NoBagExtraError,
)
from zbot.bag.message import BagMessage, Definition
from zbot.bag.metadata import TopicMetadata
from zbot.bag.write_queue import WriteQueue
from zbot.wire.serialization import serialize_message

from geometry_msgs.msg import TwistStamped, Vector3
from std_msgs.msg import Float64, String

if TYPE_CHECKING:
    from pathlib import Path


def test_messages_are_read_as_they_were_written(path: Path) -> None:
    write(path, MESSAGES)
    assert names_and_messages(path) == expected(MESSAGES)
    assert [t for _, _, t in zbot.bag.read(path)] == [1_000_000 * n for n in range(len(MESSAGES))]


def test_rosbags_reads_the_same_messages(path: Path) -> None:
    write(path, WITHOUT_CHAR)
    with AnyReader([path]) as bag:
        found = [
            (connection.topic, time_ns, connection.msgtype, raw)
            for connection, time_ns, raw in bag.messages()
        ]
        texts = [bag.deserialize(raw, type_name) for _, _, type_name, raw in found]
    assert [raw for *_, raw in found] == list(map(serialize_message, WITHOUT_CHAR))
    assert [time_ns for _, time_ns, *_ in found] == [1_000_000 * n for n in range(len(found))]
    assert texts[0].data == "hello"  # type: ignore[attr-defined]
    assert texts[2].header.frame_id == "böx"  # type: ignore[attr-defined]
    assert list(texts[4].ranges) == [1.0, 2.0]  # type: ignore[attr-defined]


def test_mcap_ros2_decodes_with_the_definitions_in_the_file(path: Path) -> None:
    write(path, MESSAGES)
    with (path / "lesson_0.mcap").open("rb") as stream:
        reader = make_reader(stream, decoder_factories=[DecoderFactory()])
        found = [message.decoded_message for message in reader.iter_decoded_messages()]
    assert len(found) == len(MESSAGES)
    assert found[0].data == "hello"
    assert found[2].header.stamp.nanosec == 6
    assert found[6].basic_types_value.int64_value == -5
    assert found[7].string_values == ["a", "bb", "ccc"]
    assert found[9].__class__.__name__ == "Constants"


def test_the_file_has_rosbag2s_form(path: Path) -> None:
    with Writer(path) as bag:
        bag.create_topic(
            TopicMetadata("/a", "geometry_msgs/msg/TwistStamped", offered_qos_profiles=(LATCHED,))
        )
        bag.write_serialized("/a", serialize_message(TwistStamped()), 50, 40)
    with (path / "lesson_0.mcap").open("rb") as stream:
        reader = make_reader(stream, validate_crcs=True)
        assert reader.get_header().profile == "ros2"
        [(schema, channel, message)] = list(reader.iter_messages())
        summary = reader.get_summary()
        [extra] = list(reader.iter_metadata())
    assert schema is not None
    assert (schema.name, schema.encoding) == ("geometry_msgs/msg/TwistStamped", "ros2msg")
    assert f"\n{'=' * 80}\nMSG: geometry_msgs/Twist\n" in schema.data.decode()
    assert (channel.message_encoding, channel.metadata["topic_type_hash"][:7]) == ("cdr", "RIHS01_")
    [profile] = yaml.safe_load(channel.metadata["offered_qos_profiles"])
    assert (profile["depth"], profile["durability"]) == (3, "transient_local")
    assert (message.log_time, message.publish_time) == (50, 40)
    assert summary is not None
    assert summary.chunk_indexes[0].compression == "zstd"
    assert "storage_identifier: mcap" in extra.metadata["serialized_metadata"]


def test_metadata_has_version_9(path: Path) -> None:
    write(path, [String(data="a"), Float64()], custom_data={"room": "12"})
    found = yaml.safe_load((path / "metadata.yaml").read_text())["rosbag2_bagfile_information"]
    assert list(found) == [
        "version",
        "storage_identifier",
        "duration",
        "starting_time",
        "message_count",
        "topics_with_message_count",
        "compression_format",
        "compression_mode",
        "relative_file_paths",
        "files",
        "custom_data",
        "ros_distro",
    ]
    assert (found["version"], found["duration"]) == (9, {"nanoseconds": 1_000_000})
    assert found["files"][0]["path"] == "lesson_0.mcap"
    assert found["topics_with_message_count"][0]["message_count"] == 1
    assert found["custom_data"] == {"room": "12"}


def test_a_bag_of_rosbags_is_read(path: Path) -> None:
    for plugin in (StoragePlugin.MCAP, StoragePlugin.SQLITE3):
        folder = path / plugin.name
        path.mkdir(exist_ok=True)
        store = get_typestore(Stores.ROS2_HUMBLE)
        with RosbagsWriter(folder, version=9, storage_plugin=plugin) as bag:
            connection = bag.add_connection("/v", "geometry_msgs/msg/Vector3", typestore=store)
            vector = store.types["geometry_msgs/msg/Vector3"](1.0, 2.0, 3.0)
            data = store.serialize_cdr(vector, "geometry_msgs/msg/Vector3")
            bag.write(connection, 7, bytes(data))
        assert list(zbot.bag.read(folder)) == [("/v", Vector3(x=1.0, y=2.0, z=3.0), 7)]


def test_topics_and_times_select_messages(path: Path) -> None:
    write(path, [String(data="a"), Float64(), String(data="b")])
    assert [m.data for _, m, _ in zbot.bag.read(path, ["string"])] == ["a", "b"]
    with Reader(path) as bag:
        assert [message.topic for message in bag.messages(None, 1_000_000, 1_000_000)] == [
            "/float64"
        ]
        assert list(bag.messages(["/none"])) == []


def test_messages_come_in_the_order_of_their_times(path: Path) -> None:
    with Writer(path) as bag:
        for time_ns in (30, 10, 20):
            bag.write("/a", Float64(data=float(time_ns)), time_ns)
    assert [t for _, _, t in zbot.bag.read(path)] == [10, 20, 30]


@pytest.mark.parametrize("options", [{"max_bytes": 2000}, {"max_duration_s": 0.01}])
def test_a_long_bag_is_split(path: Path, options: dict[str, Any]) -> None:
    messages = [String(data="x" * 500 + str(n)) for n in range(40)]
    write(path, messages, **options)
    files = sorted(file.name for file in path.glob("*.mcap"))
    assert files[:2] == ["lesson_0.mcap", "lesson_1.mcap"]
    assert names_and_messages(path) == expected(messages)
    with AnyReader([path]) as bag:
        assert bag.message_count == 40
    with Reader(path) as read:
        assert [file.path for file in read.metadata.files] == [
            f"lesson_{n}.mcap" for n in range(len(files))
        ]


def test_a_file_without_an_end_is_read_up_to_its_last_flush(path: Path) -> None:
    bag = Writer(path)
    for number in range(3):
        bag.write("/a", Float64(data=float(number)), number)
        bag.flush()
    copy = path / "copy.mcap"
    copy.write_bytes((path / "lesson_0.mcap").read_bytes())
    with Reader(copy) as read:
        assert read.metadata.message_count == 3
        assert "no end" in read.damage
        assert [message.log_ns for message in read.messages()] == [0, 1, 2]
    copy.write_bytes(copy.read_bytes()[:-30])  # in the middle of the last chunk or its index
    with Reader(copy) as read:
        assert [message.log_ns for message in read.messages()][:2] == [0, 1]
    bag.close()


def test_every_cut_of_a_file_is_read_or_refused_with_one_error(path: Path, tmp_path: Path) -> None:
    write(path, [String(data="a"), Float64()])
    whole = (path / "lesson_0.mcap").read_bytes()
    cut = tmp_path / "cut.mcap"
    for length in range(0, len(whole), 7):
        cut.write_bytes(whole[:length])
        with contextlib.suppress(BagReadError), Reader(cut) as bag:
            assert len(list(bag.messages())) <= 2


def test_damaged_bytes_give_one_error_or_messages(path: Path, tmp_path: Path) -> None:
    write(path, [String(data="a"), Float64()])
    whole = (path / "lesson_0.mcap").read_bytes()
    damaged = tmp_path / "damaged.mcap"
    for place in range(8, len(whole), 11):
        damaged.write_bytes(whole[:place] + bytes([whole[place] ^ 0xFF]) + whole[place + 1 :])
        with contextlib.suppress(BagError), Reader(damaged) as bag:
            assert len(list(bag.messages())) <= 2


@pytest.mark.parametrize("is_complete", [True, False])
def test_a_chunk_that_would_fill_the_memory_is_refused(tmp_path: Path, is_complete: bool) -> None:
    path = tmp_path / "bomb.mcap"
    # A frame that claims 8 GiB: magic, descriptor (eight bytes of size), size, an empty block.
    frame = b"\x28\xb5\x2f\xfd\xe0" + (8 * 2**30).to_bytes(8, "little") + b"\x01\0\0"
    with pytest.MonkeyPatch.context() as patch, path.open("wb") as stream:
        patch.setattr("mcap.writer.zstandard.compress", lambda _: frame)
        writer: Any = McapLibraryWriter(stream)
        writer.start()
        writer.add_message(writer.register_channel("/a", "cdr", 0), 5, b"", 5)
        if is_complete:
            writer.finish()
        else:
            writer.flush()
    with Reader(path) as bag:
        if is_complete:
            with pytest.raises(BagReadError, match="too much memory"):
                list(bag.messages())
        else:
            assert (list(bag.messages()), "too much memory" in bag.damage) == ([], True)


def test_a_folder_without_metadata_is_read(path: Path) -> None:
    write(path, [String(data=str(n)) for n in range(20)], max_duration_s=0.001)
    before = list(zbot.bag.read(path))
    with Reader(path) as bag:
        assert bag.has_metadata_file
    (path / "metadata.yaml").unlink()
    assert list(zbot.bag.read(path)) == before


def test_mistakes_are_one_sentence(path: Path, tmp_path: Path) -> None:
    (tmp_path / "lesson_1").mkdir()
    with pytest.raises(BagNotFoundError, match=r"Bag path '.*lesson' does not exist!") as caught:
        Reader(path)
    assert caught.value.hint == f"did you mean '{tmp_path / 'lesson_1'}'?"
    with pytest.raises(BagReadError, match=r"no .mcap, .db3 or .bag file"):
        Reader(tmp_path)
    (tmp_path / "notes.txt").write_text("x")
    with pytest.raises(BagReadError, match="no folder"):
        Reader(tmp_path / "notes.txt")
    (tmp_path / "notes.mcap").write_text("x" * 100)
    with pytest.raises(BagReadError, match="not an MCAP file"):
        Reader(tmp_path / "notes.mcap")
    (tmp_path / "notes.db3").write_text("x" * 100)
    with pytest.raises(BagReadError, match="not a database"):
        Reader(tmp_path / "notes.db3")
    write(path, [String()])
    with pytest.raises(BagExistsError, match="already exists: choose another name"):
        Writer(path)
    with pytest.raises(BagReadError, match="its storage is mcap"):
        Reader(path, "sqlite3")
    (path / "metadata.yaml").write_text("a: [")
    with pytest.raises(BagReadError, match="metadata"):
        Reader(path)
    (path / "metadata.yaml").write_text("a: 1")
    with pytest.raises(BagReadError, match="zbot bag reindex"):
        Reader(path)


def test_a_topic_keeps_its_type(path: Path) -> None:
    with Writer(path) as bag:
        bag.write("/a", String())
        with pytest.raises(BagValueError, match="its type is std_msgs/msg/String"):
            bag.write("/a", Float64())
        with pytest.raises(BagValueError, match="create_topic"):
            bag.write_serialized("/b", b"", 1)
        with pytest.raises(BagValueError, match="1970"):
            bag.write_serialized("/a", b"", -1)
    with pytest.raises(BagWriteError, match="closed"):
        bag.write("/a", String())
    bag.close()


def test_a_removed_folder_is_told(path: Path) -> None:
    bag = Writer(path)
    bag.write("/a", String())
    for file in path.iterdir():
        file.unlink()
    path.rmdir()
    with pytest.raises(BagWriteError, match="its folder was removed"):
        bag.flush()
    bag.close()


@pytest.mark.skipif(sys.platform == "win32", reason="POSIX limits")
def test_a_full_disk_keeps_what_was_written(path: Path) -> None:
    resource: Any = importlib.import_module("resource")  # Windows has none

    bag = Writer(path, preset="none")
    bag.write("/a", String(data="first"), 1)
    bag.flush()
    limits = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (10_000, limits[1]))
    try:
        with pytest.raises(BagWriteError, match="File too large"):
            bag.write("/a", String(data="x" * 2_000_000), 2)
        with pytest.raises(BagWriteError, match="closed"):
            bag.flush()
        bag.close()
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, limits)
    assert [m.data for _, m, _ in zbot.bag.read(path)] == ["first"]


@pytest.fixture
def without_mcap(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "mcap", None)


@pytest.mark.usefixtures("without_mcap")
def test_a_missing_package_is_named(path: Path) -> None:
    with pytest.raises(NoBagExtraError, match=r'install it with .* -m pip install "zbot\[bag\]"'):
        Writer(path)
    assert not path.exists()


def test_a_full_queue_loses_messages_and_says_so(path: Path) -> None:
    waiting = WriteQueue(Writer(path), max_bytes=1)
    text = Definition("ros2msg", definition_text("std_msgs/msg/String"))
    waiting.add_topic(TopicMetadata("/a", "std_msgs/msg/String"), text)
    data = serialize_message(String(data="x" * 100_000))
    taken = sum(waiting.put(BagMessage("/a", data, n, n)) for n in range(50))
    waiting.close()
    assert 1 <= taken < 50
    with Reader(path) as bag:
        assert bag.metadata.message_count == taken


def test_an_unexpected_error_ends_the_writing(path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def fail(*_: object) -> None:
        raise MemoryError("no room")

    def close() -> None:
        Writer.close(bag)
        raise ValueError("a later error")

    bag = Writer(path)
    monkeypatch.setattr(bag, "create_topic", fail)
    monkeypatch.setattr(bag, "close", close)
    waiting = WriteQueue(bag, max_bytes=0)
    waiting.add_topic(TopicMetadata("/a", "std_msgs/msg/String"), Definition("ros2msg", ""))
    with pytest.raises(BagWriteError, match=r"cannot write the bag '.*': MemoryError\('no room'\)"):
        waiting.close()
    assert isinstance(waiting.error, BagWriteError)  # it ends a recording
