"""Messages of the chunks of an MCAP file, in the order in which they were recorded.

A chunk is read when its first message is needed. The `BagMessage` objects are made one by one. So a
player gets the first message of a chunk after a few milliseconds, even if the chunk has 100,000
messages.
"""

from __future__ import annotations

import itertools
import os
import struct
import zlib
from collections import deque
from heapq import heappop, heappush, heapreplace
from io import BytesIO
from typing import TYPE_CHECKING, Any, BinaryIO, NamedTuple

from zbot.bag.message import BagMessage

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator, Mapping

# A record has an opcode, its length and its content (see the specification of MCAP).
_RECORD = struct.Struct("<BQ")
_MESSAGE = struct.Struct("<HIQQ")  # channel, sequence, log time, publish time; the data follow
_MESSAGE_OPCODE = 5
#: Size of a chunk after decompression. rosbag2 and zbot write chunks of some megabytes.
MAX_CHUNK_BYTES = 2**28
# Each record needs some 200 bytes of memory.
_MAX_RECORDS = 2_000_000
_HEAD_BYTES = 1000  # of a chunk: times, sizes and the name of the compression


class _Place(NamedTuple):
    """Place of a message's data in a chunk."""

    log_ns: int
    begin: int
    end: int
    topic: str
    publish_ns: int


def chunk_messages(
    stream: BinaryIO, chunks: Iterable[Any], topics: Mapping[int, str]
) -> Iterator[BagMessage]:
    """Yield the messages of chunks, ordered by the time at which they were recorded.

    Args:
        stream: The file.
        chunks: The file's indexes of the chunks. The times of chunks may overlap.
        topics: The topics that are wanted, by the number of their channel.

    Raises:
        ValueError: A chunk is damaged. `mcap` and its decompressors raise other exceptions, too.
    """
    waiting = deque(sorted(chunks, key=lambda chunk: chunk.message_start_time))
    size, read = os.fstat(stream.fileno()).st_size, 0
    # The serial number decides between messages that are equal: iterators have no order.
    heap: list[tuple[int, int, int, BagMessage, Iterator[BagMessage]]] = []
    serial = itertools.count()
    while waiting or heap:
        if waiting and (not heap or waiting[0].message_start_time <= heap[0][0]):
            offset = waiting.popleft().chunk_start_offset
            chunk = _chunk_at(stream, offset)
            read += len(chunk.data)
            if read > size:  # so many chunks are not in the file
                raise ValueError("the index names the same chunk several times")
            rest = _messages_of(chunk, topics)
            for first in rest:
                heappush(heap, (first.log_ns, offset, next(serial), first, rest))
                break
            continue
        _, offset, number, message, rest = heap[0]
        yield message
        following = next(rest, None)
        if following is None:
            heappop(heap)
        else:
            heapreplace(heap, (following.log_ns, offset, number, following, rest))


def _chunk_at(stream: BinaryIO, offset: int) -> Any:
    from mcap.data_stream import ReadDataStream  # noqa: PLC0415 - an extra
    from mcap.records import Chunk  # noqa: PLC0415 - an extra

    size = os.fstat(stream.fileno()).st_size
    if offset > size:
        raise ValueError(f"a chunk is at byte {offset}, and the file has {size} bytes")
    stream.seek(offset)
    _, length = _RECORD.unpack(stream.read(_RECORD.size))
    # A length that the file does not have would allocate memory.
    if length > min(size, MAX_CHUNK_BYTES + _HEAD_BYTES):
        raise ValueError(f"a chunk has {length} bytes")
    return Chunk.read(ReadDataStream(BytesIO(stream.read(length))))


def _messages_of(chunk: Any, topics: Mapping[int, str]) -> Iterator[BagMessage]:
    data = chunk_data(chunk)
    for place in sorted(_places(data, topics)):
        yield BagMessage(place.topic, data[place.begin : place.end], place.log_ns, place.publish_ns)


def chunk_data(chunk: Any) -> bytes:
    """Return the records of a chunk. The size after decompression is limited before and while it.

    Raises:
        ValueError: The chunk is larger than the limit or than it says, or is damaged. The
            decompressors raise other exceptions, too.
    """
    size = chunk.uncompressed_size
    if size > MAX_CHUNK_BYTES:
        raise ValueError(f"a chunk has {size} bytes, and the limit is {MAX_CHUNK_BYTES}")
    data = _decompressed(chunk.compression, chunk.data, size)
    if len(data) != size:
        raise ValueError(f"a chunk has {len(data)} bytes and says that it has {size}")
    if chunk.uncompressed_crc and zlib.crc32(data) != chunk.uncompressed_crc:
        raise ValueError("the checksum of a chunk is wrong")
    return data


def _decompressed(compression: str, data: bytes, size: int) -> bytes:
    """Decompress data to one byte more than `size` at most."""
    if compression == "zstd":
        import zstandard  # noqa: PLC0415 - an extra

        decompressor = zstandard.ZstdDecompressor(max_window_size=MAX_CHUNK_BYTES)
        with decompressor.stream_reader(data) as reader:
            return bytes(reader.read(size + 1))
    if compression == "lz4":
        import lz4.frame  # type: ignore[import-untyped]  # noqa: PLC0415 - an extra

        return bytes(lz4.frame.LZ4FrameDecompressor().decompress(data, size + 1))
    if compression:
        raise ValueError(f"the compression {compression!r} is not known")
    return data


def records(data: bytes) -> Iterator[tuple[int, int, int]]:
    """Yield the opcode, the beginning and the end of each record of a chunk.

    Raises:
        ValueError: The chunk has too many records, or a record is longer than the chunk.
    """
    end = 0
    for _ in range(_MAX_RECORDS):
        if end >= len(data):
            return
        opcode, length = _RECORD.unpack_from(data, end)
        begin = end + _RECORD.size
        end = begin + length
        if end > len(data):
            raise ValueError("a record is longer than its chunk")
        yield opcode, begin, end
    raise ValueError(f"a chunk has more than {_MAX_RECORDS} records")


def _places(data: bytes, topics: Mapping[int, str]) -> Iterator[_Place]:
    for opcode, begin, end in records(data):
        if opcode == _MESSAGE_OPCODE:
            if end - begin < _MESSAGE.size:
                raise ValueError("a message is too short")
            channel, _, log_ns, publish_ns = _MESSAGE.unpack_from(data, begin)
            if channel in topics:
                yield _Place(log_ns, begin + _MESSAGE.size, end, topics[channel], publish_ns)
