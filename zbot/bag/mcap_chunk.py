"""Messages of the chunks of an MCAP file, in the order in which they were recorded.

A chunk is read when its first message is needed. The `BagMessage` objects are made one by one. So a
player gets the first message of a chunk after a few milliseconds, even if the chunk has 100,000
messages.
"""

from __future__ import annotations

import struct
from collections import deque
from heapq import heappop, heappush, heapreplace
from typing import TYPE_CHECKING, Any, BinaryIO, NamedTuple

from zbot.bag.message import BagMessage

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator, Mapping

# A record has an opcode, its length and its content (see the specification of MCAP).
_RECORD = struct.Struct("<BQ")
_MESSAGE = struct.Struct("<HIQQ")  # channel, sequence, log time, publish time; the data follow
_MESSAGE_OPCODE = 5


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
    waiting = deque(sorted(chunks, key=lambda one: one.message_start_time))
    heap: list[tuple[int, int, BagMessage, Iterator[BagMessage]]] = []
    while waiting or heap:
        if waiting and (not heap or waiting[0].message_start_time <= heap[0][0]):
            offset = waiting.popleft().chunk_start_offset
            rest = _messages_at(stream, offset, topics)
            for first in rest:
                heappush(heap, (first.log_ns, offset, first, rest))
                break
            continue
        _, offset, message, rest = heap[0]
        yield message
        following = next(rest, None)
        if following is None:
            heappop(heap)
        else:
            heapreplace(heap, (following.log_ns, offset, following, rest))


def _messages_at(stream: BinaryIO, offset: int, topics: Mapping[int, str]) -> Iterator[BagMessage]:
    from mcap.data_stream import ReadDataStream  # noqa: PLC0415 - an extra
    from mcap.records import Chunk  # noqa: PLC0415 - an extra
    from mcap.stream_reader import get_chunk_data_stream  # noqa: PLC0415 - an extra

    stream.seek(offset + _RECORD.size)
    source, size = get_chunk_data_stream(Chunk.read(ReadDataStream(stream)), validate_crc=True)
    data = source.read(size)
    for place in sorted(_places(data, topics)):
        yield BagMessage(place.topic, data[place.begin : place.end], place.log_ns, place.publish_ns)


def _places(data: bytes, topics: Mapping[int, str]) -> Iterator[_Place]:
    end = 0
    while end < len(data):
        opcode, length = _RECORD.unpack_from(data, end)
        begin = end + _RECORD.size
        end = begin + length
        if end > len(data):
            raise ValueError("a record is longer than its chunk")
        if opcode == _MESSAGE_OPCODE:
            if length < _MESSAGE.size:
                raise ValueError("a message is too short")
            channel, _, log_ns, publish_ns = _MESSAGE.unpack_from(data, begin)
            if channel in topics:
                yield _Place(log_ns, begin + _MESSAGE.size, end, topics[channel], publish_ns)
