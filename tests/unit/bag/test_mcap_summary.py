"""Tests of MCAP files whose summary lacks parts. Writers may leave out each part."""

from __future__ import annotations

import itertools
from typing import TYPE_CHECKING, Any

import pytest
from mcap.writer import CompressionType, IndexType
from mcap.writer import Writer as McapLibraryWriter

import zbot.bag
from zbot.bag.mcap_options import read_storage_config
from zbot.bag.mcap_reader import McapReader
from zbot.bag.options import StorageOptions
from zbot.compat.rosbag2.sequential import SequentialReader
from zbot.compat.rosbag2.storage import ConverterOptions
from zbot.wire.serialization import serialize_message

from std_msgs.msg import String

if TYPE_CHECKING:
    from pathlib import Path

INDEXES = (IndexType.CHUNK, IndexType.MESSAGE, IndexType.METADATA, IndexType.ATTACHMENT)
SWITCHES = (
    "use_chunking",
    "use_statistics",
    "use_summary_offsets",
    "repeat_channels",
    "repeat_schemas",
    "enable_crcs",
)
TEXTS = ["a", "b", "c", "d", "e"]


def write(path: Path, **options: Any) -> None:
    """Write five messages of two topics with the library `mcap`."""
    with path.open("wb") as stream:
        writer = McapLibraryWriter(
            stream, chunk_size=100, compression=CompressionType.NONE, **options
        )
        writer.start()
        schema = writer.register_schema("std_msgs/msg/String", "ros2msg", b"string data")
        channels = [writer.register_channel(name, "cdr", schema) for name in ("/x", "/y")]
        for number, text in enumerate(TEXTS):
            data = serialize_message(String(data=text))
            writer.add_message(channels[number % 2], number, data, number)
        writer.add_metadata("rosbag2", {"ROS_DISTRO": "jazzy"})
        writer.finish()  # type: ignore[no-untyped-call]


@pytest.mark.parametrize("switches", list(itertools.product([True, False], repeat=6)))
def test_every_message_is_read_whatever_the_summary_lacks(
    tmp_path: Path, switches: tuple[bool, ...]
) -> None:
    for number, chosen in enumerate(itertools.product([True, False], repeat=len(INDEXES))):
        indexes = IndexType.NONE
        for index, is_on in zip(INDEXES, chosen, strict=True):
            indexes |= index if is_on else IndexType.NONE
        path = tmp_path / f"{number}.mcap"
        write(path, index_types=indexes, **dict(zip(SWITCHES, switches, strict=True)))
        reader = McapReader(path)
        assert reader.damage == ""
        assert reader.metadata.message_count == len(TEXTS)
        assert reader.metadata.ros_distro == "jazzy"
        assert {
            information.topic.name: information.message_count
            for information in reader.metadata.topics
        } == {
            "/x": 3,
            "/y": 2,
        }
        assert {information.topic.type_name for information in reader.metadata.topics} == {
            "std_msgs/msg/String"
        }
        found = [message.data for _, message, _ in zbot.bag.read(path)]
        assert found == TEXTS


KEYS = (
    "noChunkCRC",
    "noChunking",
    "noMessageIndex",
    "noSummary",
    "noSummaryCRC",
    "noAttachmentIndex",
    "noMetadataIndex",
    "noChunkIndex",
    "noStatistics",
    "noSummaryOffsets",
    "noRepeatedChannels",
    "noRepeatedSchemas",
)


@pytest.mark.parametrize(
    "keys", [*((key,) for key in KEYS), KEYS, KEYS[-2:], ("noChunking", *KEYS[-2:])]
)
def test_a_bag_with_any_option_of_rosbag2_has_all_messages(
    tmp_path: Path, keys: tuple[str, ...]
) -> None:
    config = tmp_path / "options.yaml"
    config.write_text("".join(f"{key}: true\n" for key in keys))
    folder = tmp_path / "bag"
    with zbot.bag.Writer(folder, mcap_options=read_storage_config(config, "none")) as bag:
        for number, text in enumerate(TEXTS):
            bag.write("/x", String(data=text), number)
    (file,) = folder.glob("*.mcap")
    for path in (folder, file):
        assert [message.data for _, message, _ in zbot.bag.read(path)] == TEXTS
        reader = SequentialReader()
        reader.open(StorageOptions(uri=str(path), storage_id="mcap"), ConverterOptions("", ""))
        assert reader.get_metadata().message_count == len(TEXTS)
        assert [topic.name for topic in reader.get_all_topics_and_types()] == ["/x"]
