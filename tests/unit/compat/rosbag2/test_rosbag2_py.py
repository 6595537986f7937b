"""Tests of `rosbag2_py`: programs for ROS 2's bags run without changes."""

from __future__ import annotations

import gc
import subprocess
import sys
from typing import TYPE_CHECKING, Any

import pytest

import zbot.compat  # noqa: F401 - makes rosbag2_py importable
from zbot.bag.errors import BagError
from zbot.time import Duration

from std_msgs.msg import Int32, String

if TYPE_CHECKING:
    from pathlib import Path


@pytest.fixture
def rosbag2_py() -> Any:
    return pytest.importorskip("rosbag2_py")


@pytest.fixture
def serialization() -> Any:
    return pytest.importorskip("rclpy.serialization")


@pytest.fixture
def uri(tmp_path: Path, rosbag2_py: Any, serialization: Any) -> str:
    """Return a bag with five texts and five numbers, written as in ROS 2's tutorial."""
    uri = str(tmp_path / "my_bag")
    writer = rosbag2_py.SequentialWriter()
    storage_options = rosbag2_py.StorageOptions(uri=uri, storage_id="mcap")
    writer.open(storage_options, rosbag2_py.ConverterOptions("", ""))
    for number, (name, type_name) in enumerate(
        (("/chatter", "std_msgs/msg/String"), ("/count", "std_msgs/msg/Int32"))
    ):
        writer.create_topic(
            rosbag2_py.TopicMetadata(
                id=number, name=name, type=type_name, serialization_format="cdr"
            )
        )
    for n in range(5):
        writer.write("/chatter", serialization.serialize_message(String(data=str(n))), 10 * n)
        writer.write("/count", serialization.serialize_message(Int32(data=n)), 10 * n + 5)
    del writer
    gc.collect()
    return uri


def opened(rosbag2_py: Any, uri: str) -> Any:
    reader = rosbag2_py.SequentialReader()
    reader.open(
        rosbag2_py.StorageOptions(uri=uri, storage_id="mcap"),
        rosbag2_py.ConverterOptions(
            input_serialization_format="cdr", output_serialization_format="cdr"
        ),
    )
    return reader


def test_the_tutorials_reader_gets_all_messages(
    uri: str, rosbag2_py: Any, serialization: Any
) -> None:
    reader = opened(rosbag2_py, uri)
    types = {topic.name: topic.type for topic in reader.get_all_topics_and_types()}
    assert types == {"/chatter": "std_msgs/msg/String", "/count": "std_msgs/msg/Int32"}
    classes = {"/chatter": String, "/count": Int32}
    found = []
    while reader.has_next():
        topic, data, time_ns = reader.read_next()
        found.append((serialization.deserialize_message(data, classes[topic]).data, time_ns))
    assert found[:3] == [("0", 0), (0, 5), ("1", 10)]
    assert len(found) == 10
    with pytest.raises(RuntimeError, match="no message left"):
        reader.read_next()


def test_filters_and_seek_can_be_combined(uri: str, rosbag2_py: Any) -> None:
    reader = opened(rosbag2_py, uri)
    reader.set_filter(rosbag2_py.StorageFilter(topics=["/count"]))
    assert reader.read_next()[2] == 5
    reader.seek(20)
    assert reader.read_next()[2] == 25
    reader.reset_filter()
    assert reader.read_next()[2] == 30
    reader.set_filter(rosbag2_py.StorageFilter(regex_to_exclude="chat"))
    assert reader.read_next()[2] == 35


def test_definitions_and_metadata_are_described(
    uri: str, rosbag2_py: Any, capsys: pytest.CaptureFixture[str]
) -> None:
    [text, _] = opened(rosbag2_py, uri).get_all_message_definitions()
    assert (text.topic_type, text.encoding) == ("std_msgs/msg/String", "ros2msg")
    assert "string data" in text.encoded_message_definition
    info = rosbag2_py.Info()
    metadata = info.read_metadata(uri, "mcap")
    assert metadata.message_count == 10
    assert metadata.duration == Duration(nanoseconds=45)
    assert metadata.topics_with_message_count[0].topic_metadata.name == "/chatter"
    info.print_output(metadata, "name")
    assert "Messages:          10\n" in capsys.readouterr().out
    info.print_output_topic_name_only(metadata, "count")
    assert capsys.readouterr().out == "/chatter\n/count\n"
    info.print_output_verbose(uri, metadata, "name")
    assert "Size Contribution: 40 B" in capsys.readouterr().out


def test_metadata_is_written_and_read(uri: str, rosbag2_py: Any) -> None:
    files = rosbag2_py.MetadataIo()
    metadata = files.read_metadata(uri)
    files.write_metadata(uri, metadata)
    assert files.read_metadata(uri) == metadata
    assert files.deserialize_metadata(files.serialize_metadata(metadata)) == metadata
    rosbag2_py.Reindexer().reindex(rosbag2_py.StorageOptions(uri))
    assert files.metadata_file_exists(uri)
    assert files.read_metadata(uri) == metadata


def test_what_is_not_open_is_one_error(rosbag2_py: Any, tmp_path: Path) -> None:
    with pytest.raises(BagError, match="call open"):
        rosbag2_py.SequentialReader().has_next()
    with pytest.raises(BagError, match="call open"):
        rosbag2_py.SequentialWriter().write("/a", b"", 1)
    with pytest.raises(BagError, match="does not exist"):
        rosbag2_py.SequentialReader().open_uri(str(tmp_path / "none"))
    options = rosbag2_py.StorageOptions(str(tmp_path / "new"), "rosbag_v2")
    with pytest.raises(BagError, match="choose mcap or sqlite3"):
        rosbag2_py.SequentialWriter().open(options)


def test_what_is_not_options_or_bytes_is_told(rosbag2_py: Any, tmp_path: Path) -> None:
    with pytest.raises(TypeError, match=r"write StorageOptions\(uri='my_bag', storage_id='mcap'\)"):
        rosbag2_py.SequentialReader().open("my_bag")
    with pytest.raises(TypeError, match="storage_options must be StorageOptions"):
        rosbag2_py.SequentialWriter().open(None)
    writer = rosbag2_py.SequentialWriter()
    writer.open(rosbag2_py.StorageOptions(str(tmp_path / "new")))
    with pytest.raises(TypeError, match=r"write serialize_message\(message\)"):
        writer.write("/chatter", String(data="a"), 0)


def test_the_end_of_a_program_completes_its_bag(tmp_path: Path) -> None:
    program = (
        "import rosbag2_py\n"
        "writer = rosbag2_py.SequentialWriter()\n"
        "writer.open(rosbag2_py.StorageOptions(uri='bag'), rosbag2_py.ConverterOptions('', ''))\n"
    )
    command = [sys.executable, "-c", program]
    ended = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=False)
    assert (ended.returncode, ended.stderr) == (0, "")
    assert (tmp_path / "bag" / "metadata.yaml").is_file()
