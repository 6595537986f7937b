"""Reader of bags of ROS 1 (`.bag`, version 2.0). The messages become messages of ROS 2."""

from __future__ import annotations

import bz2
import heapq
import itertools
import struct
from collections import Counter
from contextlib import suppress
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, BinaryIO

from zbot.bag.definition import ENCODING, definition_text, message_class
from zbot.bag.errors import BagError, BagReadError
from zbot.bag.message import BagMessage, Definition
from zbot.bag.metadata import BagMetadata, FileInformation, TopicInformation, TopicMetadata
from zbot.bag.packages import import_mcap
from zbot.bag.ros1_message import decoder, read_definitions, ros2_name, ros2_text
from zbot.errors import ZbotError
from zbot.interfaces import type_hash
from zbot.qos import DurabilityPolicy, QoSProfile
from zbot.time import S_TO_NS
from zbot.wire.serialization import serialize_message

if TYPE_CHECKING:
    from collections.abc import Callable, Collection, Iterator
    from pathlib import Path

STORAGE_ID = "rosbag_v2"  #: rosbag2's name of the format
_MAGIC = b"#ROSBAG V2.0\n"
_MESSAGE, _BAG_HEADER, _CHUNK, _CHUNK_INFO, _CONNECTION = 2, 3, 5, 6, 7
_MOST_HEADER_BYTES = 2**24
_MOST_CHUNK_BYTES = 2**30
_ERRORS = (
    struct.error,
    LookupError,
    ValueError,
    EOFError,
    OverflowError,
    MemoryError,
    RuntimeError,
)


@dataclass(frozen=True)
class _Chunk:
    position: int
    start_ns: int
    end_ns: int
    counts: dict[int, int]


@dataclass
class _Connection:
    topic: str
    type_name: str  #: ROS 1's name
    text: str
    is_latched: bool
    decode: Callable[[bytes], Any] | None = field(default=None)


class Ros1Reader:
    """Reader of one bag of ROS 1.

    Args:
        path: The file.

    Raises:
        BagReadError: The file cannot be read, is not a bag, or has no index, which
            `rosbag reindex` writes.
        NoBagExtraError: The extra `bag` is not installed.
    """

    def __init__(self, path: Path) -> None:
        import_mcap()
        self._path = path
        self.damage = ""
        self._connections: dict[int, _Connection] = {}
        self._chunks: list[_Chunk] = []
        self._known_types: set[str] = set()
        try:
            with path.open("rb") as stream:
                self._read_index(stream)
            self.definitions = dict(self._definitions())
            self.metadata = self._metadata()
        except OSError as error:
            raise BagReadError(path, error.strerror or str(error)) from error
        except BagError:
            raise
        except _ERRORS as error:
            raise BagReadError(path, f"the file is damaged ({error})") from error

    def messages(
        self, topics: Collection[str] | None, start_ns: int, end_ns: int | None
    ) -> Iterator[BagMessage]:
        """Yield messages as `StorageReader.messages` says. Messages are converted to ROS 2's CDR.

        Raises:
            BagReadError: A part of the file is damaged.
            BagTypeError: The definition of a type is incomplete.
        """
        wanted = {
            number: connection
            for number, connection in self._connections.items()
            if topics is None or connection.topic in topics
        }
        last_ns = 2**63 if end_ns is None else end_ns
        waiting: list[tuple[int, int, int, bytes]] = []
        serial = itertools.count()
        try:
            with self._path.open("rb") as stream:
                chunks = _Chunks(stream, self._path.stat().st_size)
                for chunk in sorted(self._chunks, key=lambda chunk: chunk.start_ns):
                    while waiting and waiting[0][0] < chunk.start_ns:
                        yield self._converted(*heapq.heappop(waiting))
                    is_out = chunk.end_ns < start_ns or chunk.start_ns > last_ns
                    if not is_out and not wanted.keys().isdisjoint(chunk.counts):
                        for time_ns, number, data in chunks.messages(chunk.position):
                            if number in wanted and start_ns <= time_ns <= last_ns:
                                # The serial number keeps the order of messages with the same time.
                                heapq.heappush(waiting, (time_ns, next(serial), number, data))
                while waiting:
                    yield self._converted(*heapq.heappop(waiting))
        except OSError as error:
            raise BagReadError(self._path, error.strerror or str(error)) from error
        except ZbotError:
            raise
        except _ERRORS as error:
            raise BagReadError(self._path, f"the file is damaged ({error})") from error

    def _converted(self, time_ns: int, _: int, number: int, data: bytes) -> BagMessage:
        connection = self._connections[number]
        if connection.decode is None:
            definitions = read_definitions(connection.type_name, connection.text)
            name = ros2_name(connection.type_name)
            if name not in self._known_types:
                message_class(name, *self.definitions[name])
                self._known_types.add(name)
            connection.decode = decoder(connection.type_name, definitions)
        message = connection.decode(data)
        return BagMessage(connection.topic, serialize_message(message), time_ns, time_ns)

    def _read_index(self, stream: BinaryIO) -> None:
        if stream.read(len(_MAGIC)) != _MAGIC:
            raise BagReadError(self._path, "it is not a bag of ROS 1, version 2.0")
        header, _ = _record(stream)
        (position,) = struct.unpack("<Q", header[b"index_pos"])
        if header[b"op"] != bytes((_BAG_HEADER,)) or not position:
            raise BagReadError(self._path, "it has no index: `rosbag reindex` of ROS 1 writes it")
        expected = struct.unpack("<II", header[b"conn_count"] + header[b"chunk_count"])
        stream.seek(position)
        size = self._path.stat().st_size
        while stream.tell() < size:
            header, data = _record(stream)
            kind = header[b"op"][0]
            if kind == _CONNECTION:
                (number,) = struct.unpack("<I", header[b"conn"])
                self._connections[number] = _connection(header, data)
            elif kind == _CHUNK_INFO:
                self._chunks.append(_chunk_info(header, data))
        if (len(self._connections), len(self._chunks)) != expected:
            raise BagReadError(self._path, "the file is not complete")

    def _definitions(self) -> Iterator[tuple[str, Definition]]:
        for connection in self._connections.values():
            name = ros2_name(connection.type_name)
            try:
                text = definition_text(name)
            except LookupError:
                text = ros2_text(
                    connection.type_name, read_definitions(connection.type_name, connection.text)
                )
            yield name, Definition(ENCODING, text)

    def _metadata(self) -> BagMetadata:
        counts: Counter[int] = Counter()
        for chunk in self._chunks:
            counts.update(chunk.counts)
        filled = [chunk for chunk in self._chunks if chunk.counts]
        start = min((chunk.start_ns for chunk in filled), default=0)
        end = max((chunk.end_ns for chunk in filled), default=0)
        topics: dict[str, TopicInformation] = {}
        for number, connection in self._connections.items():
            known = topics.get(connection.topic)
            count = counts[number] + (known.message_count if known else 0)
            topics[connection.topic] = TopicInformation(
                known.topic if known else _topic(connection), count
            )
        total = sum(counts.values())
        return BagMetadata(
            storage_id=STORAGE_ID,
            topics=tuple(topics.values()),
            files=(FileInformation(self._path.name, start, end - start, total),),
            paths=(self._path.name,),
            start_ns=start,
            duration_ns=end - start,
            message_count=total,
            bag_size=self._path.stat().st_size,
        )


def _topic(connection: _Connection) -> TopicMetadata:
    name = ros2_name(connection.type_name)
    profile = QoSProfile(depth=10)
    if connection.is_latched:
        profile = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
    digest = ""
    with suppress(LookupError):  # the type is not known here
        digest = type_hash(name)
    return TopicMetadata(connection.topic, name, offered_qos_profiles=(profile,), type_hash=digest)


class _Chunks:
    """Chunks of an open file.

    Args:
        stream: The file.
        size: Its size. The chunks that are read have no more bytes together.
    """

    def __init__(self, stream: BinaryIO, size: int) -> None:
        self._stream, self._left = stream, size

    def messages(self, position: int) -> Iterator[tuple[int, int, bytes]]:
        """Return the times, the connections and the bytes of the messages of a chunk."""
        self._stream.seek(position)
        header, data = _record(self._stream)
        if header[b"op"] != bytes((_CHUNK,)):
            raise ValueError("a chunk is missing")
        self._left -= len(data)
        if self._left < 0:
            raise ValueError("the index names the same chunk several times")
        (size,) = struct.unpack("<I", header[b"size"])
        if size > _MOST_CHUNK_BYTES:
            raise ValueError(f"a chunk has {size} bytes, and the limit is {_MOST_CHUNK_BYTES}")
        return _messages(_decompressed(header[b"compression"].decode(), data, size))


def _messages(data: bytes) -> Iterator[tuple[int, int, bytes]]:
    """Yield the times, the connections and the bytes of the messages in a chunk."""
    place = 0
    while place < len(data):
        header, body, place = _record_in(data, place)
        if header[b"op"][0] == _MESSAGE:
            (number,) = struct.unpack("<I", header[b"conn"])
            yield _time_ns(header[b"time"]), number, body


def _decompressed(compression: str, data: bytes, size: int) -> bytes:
    if compression == "none":
        return data
    if compression == "bz2":
        return bz2.BZ2Decompressor().decompress(data, size)
    if compression == "lz4":
        import lz4.frame  # type: ignore[import-untyped]  # noqa: PLC0415 - an extra

        found: bytes = lz4.frame.LZ4FrameDecompressor().decompress(data, size)
        return found
    raise ValueError(f"the compression {compression!r} is not known")


def _record(stream: BinaryIO) -> tuple[dict[bytes, bytes], bytes]:
    header = _fields(_block(stream, _MOST_HEADER_BYTES))
    return header, _block(stream, _MOST_CHUNK_BYTES)


def _block(stream: BinaryIO, limit: int) -> bytes:
    (length,) = struct.unpack("<I", stream.read(4))
    if length > limit:
        raise ValueError(f"a record has {length} bytes")
    data = stream.read(length)
    if len(data) < length:
        raise EOFError("the file is not complete")
    return data


def _record_in(data: bytes, place: int) -> tuple[dict[bytes, bytes], bytes, int]:
    (length,) = struct.unpack_from("<I", data, place)
    start = place + 4
    (body_length,) = struct.unpack_from("<I", data, start + length)
    body = start + length + 4
    if body + body_length > len(data):
        raise EOFError("a chunk is not complete")
    header = _fields(data[start : start + length])
    return header, data[body : body + body_length], body + body_length


def _fields(header: bytes) -> dict[bytes, bytes]:
    found, place = {}, 0
    while place < len(header):
        (length,) = struct.unpack_from("<I", header, place)
        name, _, value = header[place + 4 : place + 4 + length].partition(b"=")
        found[name] = value
        place += 4 + length
    return found


def _connection(header: dict[bytes, bytes], data: bytes) -> _Connection:
    fields = _fields(data)
    return _Connection(
        topic=header[b"topic"].decode(),
        type_name=fields[b"type"].decode(),
        text=fields[b"message_definition"].decode("utf-8", "replace"),
        is_latched=fields.get(b"latching") == b"1",
    )


def _chunk_info(header: dict[bytes, bytes], data: bytes) -> _Chunk:
    (position,) = struct.unpack("<Q", header[b"chunk_pos"])
    pairs = struct.iter_unpack("<II", data)
    start, end = _time_ns(header[b"start_time"]), _time_ns(header[b"end_time"])
    return _Chunk(position, start, end, dict(pairs))


def _time_ns(value: bytes) -> int:
    seconds, nanoseconds = struct.unpack("<II", value)
    return int(seconds * S_TO_NS + nanoseconds)
