"""Tests of bags of ROS 1, which rosbags writes."""

from __future__ import annotations

import struct
import time
from typing import TYPE_CHECKING, Any

import numpy as np
import pytest
from rosbags.rosbag1 import Writer as Rosbag1Writer
from rosbags.typesys import Stores, get_types_from_msg, get_typestore

import zbot.bag
from tests.conftest import allowed
from zbot.bag import Reader
from zbot.bag.conversion import Output, convert
from zbot.bag.errors import BagError, BagReadError, BagTypeError
from zbot.bag.options import RecordOptions, StorageOptions
from zbot.bag.ros1_message import Ros1Field, _Decoders, decoder, read_definitions
from zbot.bag.ros1_reader import Ros1Reader
from zbot.interfaces.parser import parse
from zbot.interfaces.registry import register_spec
from zbot.qos import DurabilityPolicy

from sensor_msgs.msg import CameraInfo, Image, LaserScan
from std_msgs.msg import String

if TYPE_CHECKING:
    from pathlib import Path

STORE: Any = get_typestore(Stores.ROS1_NOETIC)
BOX = """\
# A type that only this bag has.
Header header
time seen
duration[2] spans
uint8 KIND=3
byte[] flags
geometry_msgs/Point[] corners
string[] names
char Letter
"""
STORE.register(get_types_from_msg(BOX, "ros1_test_msgs/msg/Box"))


def make(name: str, **fields: Any) -> Any:
    return STORE.types[name](**fields)


def header(frame: str) -> Any:
    stamp = make("builtin_interfaces/msg/Time", sec=5, nanosec=6)
    return make("std_msgs/msg/Header", seq=7, stamp=stamp, frame_id=frame)


def write(path: Path, messages: list[tuple[str, Any, int]], compression: str = "none") -> Path:
    """Write messages with their topics and times. The topic /map is latched."""
    writer = Rosbag1Writer(path)
    if compression != "none":
        writer.set_compression(Rosbag1Writer.CompressionFormat[compression.upper()])
    with writer:
        connections: dict[str, Any] = {}
        for topic, message, time_ns in messages:
            kind = message.__msgtype__
            if topic not in connections:
                latching = 1 if topic == "/map" else None
                connections[topic] = writer.add_connection(
                    topic, kind, typestore=STORE, latching=latching
                )
            writer.write(connections[topic], time_ns, STORE.serialize_ros1(message, kind))
    return path


@pytest.fixture
def old_bag(tmp_path: Path) -> Path:
    return tmp_path / "old.bag"


@pytest.mark.parametrize("compression", ["none", "bz2", "lz4"])
def test_messages_of_ros1_become_messages_of_ros2(old_bag: Path, compression: str) -> None:
    floats = np.array([1.0, 2.5], dtype=np.float32)
    scan = make(
        "sensor_msgs/msg/LaserScan",
        header=header("laser"),
        ranges=floats,
        intensities=floats[:0],
        **dict.fromkeys(("angle_min", "angle_max", "angle_increment", "time_increment"), 0.5),
        **dict.fromkeys(("scan_time", "range_min", "range_max"), 2.0),
    )
    data = np.arange(6, dtype=np.uint8)
    image = make(
        "sensor_msgs/msg/Image",
        header=header("eye"),
        height=1,
        width=2,
        encoding="rgb8",
        is_bigendian=0,
        step=6,
        data=data,
    )
    text = make("std_msgs/msg/String", data="böx")
    write(old_bag, [("/map", text, 10), ("/scan", scan, 5), ("/image", image, 20)], compression)
    found = list(zbot.bag.read(old_bag))
    assert [(topic, t) for topic, _, t in found] == [("/scan", 5), ("/map", 10), ("/image", 20)]
    messages = [message for _, message, _ in found]
    assert [type(message) for message in messages] == [LaserScan, String, Image]
    assert list(messages[0].ranges) == [1.0, 2.5]
    assert (messages[0].header.frame_id, messages[0].header.stamp.sec) == ("laser", 5)
    assert messages[1].data == "böx"
    assert bytes(messages[2].data) == bytes(range(6))
    with Reader(old_bag) as bag:
        assert bag.metadata.storage_id == "rosbag_v2"
        assert bag.metadata.message_count == 3
        assert (bag.metadata.start_ns, bag.metadata.end_ns) == (5, 20)
        [profile] = bag.topics["/map"].offered_qos_profiles
        assert profile.durability is DurabilityPolicy.TRANSIENT_LOCAL


def test_fields_with_capital_letters_find_their_names(old_bag: Path) -> None:
    numbers = np.arange(12, dtype=np.float64)
    region = make(
        "sensor_msgs/msg/RegionOfInterest",
        **dict.fromkeys(("x_offset", "y_offset", "height", "width"), 1),
        do_rectify=True,
    )
    info = make(
        "sensor_msgs/msg/CameraInfo",
        header=header("eye"),
        height=4,
        width=6,
        distortion_model="plumb_bob",
        D=numbers[:5],
        K=numbers[:9],
        R=numbers[:9],
        P=numbers,
        binning_x=1,
        binning_y=2,
        roi=region,
    )
    write(old_bag, [("/info", info, 1)])
    [(_, message, _)] = zbot.bag.read(old_bag)
    assert isinstance(message, CameraInfo)
    assert list(message.k) == list(range(9))
    assert list(message.p) == list(range(12))
    assert message.roi.do_rectify is True


def test_types_that_only_the_bag_has_are_learned(old_bag: Path, tmp_path: Path) -> None:
    time = make("builtin_interfaces/msg/Time", sec=2**31 - 1, nanosec=2_000_000_008)
    span = make("builtin_interfaces/msg/Duration", sec=-1, nanosec=500_000_000)
    point = make("geometry_msgs/msg/Point", x=1.0, y=2.0, z=3.0)
    box = make(
        "ros1_test_msgs/msg/Box",
        header=header("a"),
        seen=time,
        spans=[span, span],
        corners=[point],
        flags=np.array([1, 2], dtype=np.int8),
        names=["x", "y"],
        Letter=65,
    )
    write(old_bag, [("/box", box, 1)])
    [(_, message, _)] = zbot.bag.read(old_bag)
    assert type(message).__name__ == "Box"
    assert message.header.frame_id == "a"
    assert (message.seen.sec, message.seen.nanosec) == (2**31 - 1, 8)  # ROS 2's times end in 2038
    assert (message.spans[0].sec, message.spans[0].nanosec) == (-1, 500_000_000)
    assert (message.corners[0].z, list(message.names), message.letter) == (3.0, ["x", "y"], 65)
    assert [int(flag) for flag in message.flags] == [1, 2]
    with Reader(old_bag) as bag:
        new = Output(StorageOptions(str(tmp_path / "new")), RecordOptions(all_topics=True))
        assert convert([bag], new) == 1
    [(_, copied, _)] = zbot.bag.read(tmp_path / "new")
    assert copied == message


def test_topics_and_times_select_messages(old_bag: Path) -> None:
    lines = [
        (f"/{'ab'[n % 2]}", make("std_msgs/msg/String", data="x" * 100_000), n) for n in range(40)
    ]
    write(old_bag, lines)
    with Reader(old_bag) as bag:
        assert [message.log_ns for message in bag.messages(["/a"], 10, 20)] == list(
            range(10, 21, 2)
        )


def test_damaged_files_are_refused_or_read(old_bag: Path, tmp_path: Path) -> None:
    write(old_bag, [("/a", make("std_msgs/msg/String", data="x"), 1)])
    data = old_bag.read_bytes()
    broken = tmp_path / "broken.bag"
    for length in range(0, len(data), 97):
        broken.write_bytes(data[:length])
        with pytest.raises(BagReadError):
            list(zbot.bag.read(broken))
    for place in range(13, len(data), 11):
        broken.write_bytes(data[:place] + bytes((data[place] ^ 255,)) + data[place + 1 :])
        try:
            list(zbot.bag.read(broken))
        except BagError:
            continue


def test_an_index_that_names_a_chunk_many_times_is_damage(old_bag: Path) -> None:
    write(old_bag, [("/a", make("std_msgs/msg/String", data="x"), 1)])
    reader = Ros1Reader(old_bag)
    reader._chunks *= 1000
    with pytest.raises(BagReadError, match="names the same chunk several times"):
        list(reader.messages(None, 0, None))


def test_a_record_without_a_kind_is_damage(old_bag: Path) -> None:
    def record(**fields: bytes) -> bytes:
        parts = [f"{name}=".encode() + value for name, value in fields.items()]
        head = b"".join(struct.pack("<I", len(part)) + part for part in parts)
        return struct.pack("<I", len(head)) + head + struct.pack("<I", 0)

    none = struct.pack("<I", 0)
    facts = {"op": b"\x03", "conn_count": none, "chunk_count": none}
    magic = b"#ROSBAG V2.0\n"
    index = len(magic + record(**facts, index_pos=bytes(8)))
    start = magic + record(**facts, index_pos=struct.pack("<Q", index))
    old_bag.write_bytes(start + record(op=b""))
    with pytest.raises(BagReadError, match="damaged"):
        Reader(old_bag)


def wide_definition(levels: int, fields: int, kind: str = "") -> str:
    """Return a message in which each level holds several of the next; the last one is empty."""
    texts = []
    for level in range(levels):
        lines = "".join(f"bomb_msgs/L{level + 1}{kind} f{number}\n" for number in range(fields))
        texts.append(f"MSG: bomb_msgs/L{level}\n{lines}" if level else lines)
    texts.append(f"MSG: bomb_msgs/L{levels}\n")
    return f"{'=' * 80}\n".join(texts)


def test_a_type_with_many_equal_messages_inside_is_read_once() -> None:
    text = wide_definition(18, 10)
    definitions = read_definitions("bomb_msgs/L0", text)
    decoders = _Decoders(definitions)
    for level in reversed(range(19)):
        register_spec(parse(f"bomb_msgs/msg/L{level}", ""))
    decoders.message("bomb_msgs/L0", "bomb_msgs/msg/L0", 0)
    assert len(decoders._made) == 19


def test_thousands_of_definitions_are_read_quickly() -> None:
    text = "".join(f"=\nMSG: a/B{number}\n" for number in range(20_000))
    begin = time.process_time()
    assert len(read_definitions("a/B", text)) == 20_001
    assert time.process_time() - begin < allowed(2)


def test_an_array_with_thousands_of_digits_in_its_size_is_no_field() -> None:
    with pytest.raises(BagTypeError, match=r"99\.\.\. is no field") as caught:
        read_definitions("bomb_msgs/L0", f"float64[{'9' * 5000}] a\n")
    assert len(str(caught.value)) < 200


def test_a_message_that_is_a_text_in_ros2_is_refused() -> None:
    definitions = {"std_msgs/String": [Ros1Field("a/B", "data", None)], "a/B": []}
    with pytest.raises(BagTypeError, match="the field data is a a/B, and a string in ROS 2"):
        decoder("std_msgs/String", definitions)


def test_a_list_of_messages_without_bytes_is_damage() -> None:
    definitions = read_definitions("bomb_msgs/L0", wide_definition(3, 1, "[1000000]"))
    for level in range(4):
        register_spec(parse(f"bomb_msgs/msg/L{level}", ""))
    with pytest.raises(struct.error, match="no bytes"):
        decoder("bomb_msgs/L0", definitions)(b"")
