"""Readers of bags that others wrote: MCAP and sqlite3 files, metadata, definitions, QoS files."""

from __future__ import annotations

import sqlite3
import struct
import warnings
from contextlib import closing
from typing import TYPE_CHECKING

import zbot  # noqa: F401 - makes the messages importable
from tests.torture.reader import Reader, temporary_folder
from zbot.bag import Writer
from zbot.bag.conversion import read_outputs
from zbot.bag.definition import definition_text, message_class
from zbot.bag.errors import BagError
from zbot.bag.mcap_options import read_storage_config
from zbot.bag.metadata import METADATA_FILE, metadata_text
from zbot.bag.metadata import BagMetadata as Metadata
from zbot.bag.qos_profiles import profile_values, read_overrides
from zbot.bag.reader import Reader as BagReader
from zbot.bag.reader import read
from zbot.bag.ros1_message import read_definitions
from zbot.qos import QoSProfile
from zbot.wire.errors import CodecError
from zbot.wire.serialization import serialize_message

from geometry_msgs.msg import Vector3
from std_msgs.msg import String

if TYPE_CHECKING:
    from pathlib import Path

_FOLDER = temporary_folder("zbot-torture-bags-")
_TYPE = "geometry_msgs/msg/Twist"


def _mcap_seed(preset: str) -> bytes:
    folder = _FOLDER / preset
    with Writer(folder, preset=preset) as bag:
        bag.write("/a", String(data="hello"), 5)
        bag.write("/b", Vector3(), 6)
    return (folder / f"{preset}_0.mcap").read_bytes()


def _sqlite_seed() -> bytes:
    path = _FOLDER / "seed.db3"
    with closing(sqlite3.connect(path)) as bag:
        bag.execute("PRAGMA page_size=512")
        bag.execute("CREATE TABLE topics(id, name, type, serialization_format)")
        bag.execute("CREATE TABLE messages(id, topic_id, timestamp, data)")
        bag.execute("INSERT INTO topics VALUES (1, '/a', 'std_msgs/msg/String', 'cdr')")
        data = serialize_message(String(data="hello"))
        bag.execute("INSERT INTO messages VALUES (1, 1, 5, ?)", (data,))
        bag.commit()
    return path.read_bytes()


def _file(name: str, data: bytes) -> Path:
    path = _FOLDER / name
    path.parent.mkdir(exist_ok=True)
    path.write_bytes(data)
    return path


def _read(name: str, data: bytes) -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # about texts that are not UTF-8
        assert list(read(_file(name, data))) is not None


def _mcap(data: bytes) -> None:
    _read("x.mcap", data)


def _ros1_seed() -> bytes:
    """Return a bag of ROS 1 with one message."""

    def record(data: bytes, **fields: bytes) -> bytes:
        pairs = [f"{name}=".encode() + value for name, value in fields.items()]
        header = b"".join(struct.pack("<I", len(pair)) + pair for pair in pairs)
        return struct.pack("<I", len(header)) + header + struct.pack("<I", len(data)) + data

    number, text = struct.pack("<I", 0), struct.pack("<I", 5) + b"hello"
    time = struct.pack("<II", 1, 2)
    message = record(text, op=b"\x02", conn=number, time=time)
    size = struct.pack("<I", len(message))
    chunk = record(message, op=b"\x05", compression=b"none", size=size)
    facts = {"type": b"std_msgs/String", "md5sum": b"0", "message_definition": b"string data\n"}
    pairs = [f"{name}=".encode() + value for name, value in facts.items()]
    body = b"".join(struct.pack("<I", len(pair)) + pair for pair in pairs)
    count = struct.pack("<I", 1)

    def start(index: int) -> bytes:
        place = struct.pack("<Q", index)
        return b"#ROSBAG V2.0\n" + record(
            b" " * 40, op=b"\x03", index_pos=place, conn_count=count, chunk_count=count
        )

    first = len(start(0))
    index = record(body, op=b"\x07", conn=number, topic=b"/a") + record(
        number + count,
        op=b"\x06",
        ver=count,
        chunk_pos=struct.pack("<Q", first),
        start_time=time,
        end_time=time,
        count=count,
    )
    return start(first + len(chunk)) + chunk + index


def _ros1(data: bytes) -> None:
    _read("x.bag", data)


def _ros1_definition(data: bytes) -> None:
    read_definitions("torture_msgs/Box", data.decode(errors="replace"))


def _sqlite(data: bytes) -> None:
    _read("x.db3", data)


def _metadata(data: bytes) -> None:
    BagReader(_file(f"folder/{METADATA_FILE}", data).parent).close()


def _definition(data: bytes) -> None:
    message_class("torture_msgs/msg/Box", "ros2msg", data.decode(errors="replace"))


def _overrides(data: bytes) -> None:
    read_overrides(_file("qos.yaml", data))


def _storage_config(data: bytes) -> None:
    read_storage_config(_file("mcap.yaml", data), "zstd")


def _outputs(data: bytes) -> None:
    read_outputs(_file("out.yaml", data))


_PROFILE = "\n".join(
    f"  {key}: {value}" for key, value in profile_values(QoSProfile(depth=1)).items()
)
_MODULES = ("zbot.bag.reader", "zbot.bag.metadata", "zbot.bag.qos_profiles")

BAG_READERS = (
    Reader(
        "mcap",
        (
            "zbot.bag.mcap_reader",
            "zbot.bag.mcap_chunk",
            "zbot.bag.message",
            *_MODULES,
        ),
        _mcap,
        (BagError, CodecError),
        (_mcap_seed("zstd"), _mcap_seed("none"), _mcap_seed("fastwrite")),
    ),
    Reader(
        "sqlite3", ("zbot.bag.sqlite_reader",), _sqlite, (BagError, CodecError), (_sqlite_seed(),)
    ),
    Reader(
        "bag of ros1", ("zbot.bag.ros1_reader",), _ros1, (BagError, CodecError), (_ros1_seed(),)
    ),
    Reader(
        "definition of ros1",
        ("zbot.bag.ros1_message",),
        _ros1_definition,
        (BagError,),
        (b"Header header\nfloat64[3] x # y\nuint8 A=3\n====\nMSG: std_msgs/Header\nuint32 seq\n",),
    ),
    Reader(
        "bag metadata",
        _MODULES,
        _metadata,
        (BagError,),
        (metadata_text(Metadata("mcap")).encode(),),
    ),
    Reader(
        "bag definition",
        ("zbot.bag.definition",),
        _definition,
        (BagError,),
        (definition_text(_TYPE).encode(), definition_text("test_msgs/msg/Nested").encode()),
    ),
    Reader(
        "bag qos overrides", _MODULES, _overrides, (BagError,), (f"/a:\n{_PROFILE}\n".encode(),)
    ),
    Reader(
        "bag storage config",
        ("zbot.bag.mcap_options",),
        _storage_config,
        (BagError,),
        (b"compression: Lz4\nchunkSize: 4096\nnoChunkCRC: true\n",),
    ),
    Reader(
        "bag output options",
        ("zbot.bag.conversion",),
        _outputs,
        (BagError,),
        (b"output_bags:\n- {uri: a, all: true, regex: x, max_bagfile_size: 5, topics: [/a]}\n",),
    ),
)
