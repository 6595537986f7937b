"""Reader of MCAP files. It also reads files that have no end because the recorder was killed."""

from __future__ import annotations

import struct
from collections import deque
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any

from zbot.bag.errors import BagReadError
from zbot.bag.mcap_chunk import MAX_CHUNK_BYTES, chunk_data, chunk_messages
from zbot.bag.mcap_chunk import records as chunk_records
from zbot.bag.message import BagMessage, Definition
from zbot.bag.metadata import (
    BagMetadata,
    FileInformation,
    TopicInformation,
    TopicMetadata,
    read_metadata,
)
from zbot.bag.packages import import_mcap
from zbot.bag.qos_profiles import read_profiles

if TYPE_CHECKING:
    from collections.abc import Collection, Iterator
    from pathlib import Path

STORAGE_ID = "mcap"
_MIN_BYTES = 64  #: a shorter file has no room for a footer
_MAX_RECORD_BYTES = 2**30  #: attachments are records, too


@dataclass
class _Contents:
    """What a file contains, from its summary or from all its records."""

    channels: dict[int, Any] = field(default_factory=dict)
    schemas: dict[int, Any] = field(default_factory=dict)
    counts: dict[int, int] = field(default_factory=dict)
    start_ns: int = 0
    end_ns: int = 0
    chunks: list[Any] = field(default_factory=list)  #: indexes of chunks, if the file has a summary

    def add(self, channel_id: int, time_ns: int) -> None:
        self.start_ns = min(time_ns, self.start_ns) if self.counts else time_ns
        self.end_ns = max(time_ns, self.end_ns)
        self.counts[channel_id] = self.counts.get(channel_id, 0) + 1


class McapReader:
    """Reader of one MCAP file.

    Args:
        path: The file.

    Raises:
        BagReadError: The file cannot be read or is not MCAP.
        NoBagExtraError: The package `mcap` is not installed.
    """

    def __init__(self, path: Path) -> None:
        import_mcap()
        self._path = path
        self._errors = _read_errors()
        self.damage = ""
        self._extra: dict[str, str] = {}
        try:
            self._contents = self._summary() or self._scan()
            self.metadata = self._metadata()
        except OSError as error:
            raise BagReadError(path, error.strerror or str(error)) from error
        except self._errors as error:
            raise BagReadError(path, _reason(error)) from error
        self.definitions = {
            schema.name: Definition(schema.encoding, schema.data.decode("utf-8", "replace"))
            for schema in self._contents.schemas.values()
        }

    def messages(
        self, topics: Collection[str] | None, start_ns: int, end_ns: int | None
    ) -> Iterator[BagMessage]:
        """Yield messages as `StorageReader.messages` says.

        In a file without an end, messages are ordered only inside each chunk. Usually this is
        enough, because a recorder writes the messages in order.

        Raises:
            BagReadError: A part in the middle of the file is damaged, or the file was removed.
        """
        wanted = {
            number: channel.topic
            for number, channel in self._contents.channels.items()
            if topics is None or channel.topic in topics
        }
        found = self._indexed(wanted, start_ns, end_ns)
        if not self._contents.chunks:
            found = self._unindexed(wanted)
        try:
            for message in found:
                if start_ns <= message.log_ns and (end_ns is None or message.log_ns <= end_ns):
                    yield message
        except OSError as error:
            raise BagReadError(self._path, error.strerror or str(error)) from error
        except self._errors as error:
            raise BagReadError(self._path, _reason(error)) from error

    def _indexed(
        self, wanted: dict[int, str], start_ns: int, end_ns: int | None
    ) -> Iterator[BagMessage]:
        chunks = [
            chunk
            for chunk in self._contents.chunks
            if start_ns <= chunk.message_end_time
            and (end_ns is None or chunk.message_start_time <= end_ns)
            # Without offsets, which a writer may leave out, the topics of a chunk are not known.
            and not wanted.keys().isdisjoint(chunk.message_index_offsets or wanted)
        ]
        with self._path.open("rb") as stream:
            yield from chunk_messages(stream, chunks, wanted)

    def _unindexed(self, wanted: dict[int, str]) -> Iterator[BagMessage]:
        for block in self._blocks():
            for entry in sorted(block, key=lambda record: getattr(record, "log_time", 0)):
                if hasattr(entry, "log_time") and getattr(entry, "channel_id", None) in wanted:
                    topic = wanted[entry.channel_id]
                    yield BagMessage(topic, entry.data, entry.log_time, entry.publish_time)

    def _summary(self) -> _Contents | None:
        """Return the contents from the file's summary, or `None` if the summary lacks a part."""
        from mcap.reader import SeekingReader  # noqa: PLC0415 - an extra

        with self._path.open("rb") as stream:
            if self._path.stat().st_size < _MIN_BYTES:
                return None
            reader = SeekingReader(stream)
            try:
                summary = reader.get_summary()
            except self._errors:
                return None  # the footer is missing
            counted = None if summary is None else summary.statistics
            if summary is None or counted is None or not _is_complete(summary, counted):
                return None
            largest = max(index.uncompressed_size for index in summary.chunk_indexes)
            if largest > MAX_CHUNK_BYTES:
                raise ValueError(f"a chunk has {largest} bytes, and the limit is {MAX_CHUNK_BYTES}")
            # Only the last description counts. A damaged index could name a long one very often.
            summary.metadata_indexes = [
                index for index in summary.metadata_indexes if index.name == "rosbag2"
            ][-1:]
            for metadata in reader.iter_metadata():
                self._extra = dict(metadata.metadata)
        return _Contents(
            channels=summary.channels,
            schemas=summary.schemas,
            counts=dict(counted.channel_message_counts),
            start_ns=counted.message_start_time,
            end_ns=counted.message_end_time,
            chunks=summary.chunk_indexes,
        )

    def _scan(self) -> _Contents:
        """Return the contents from all records of the file."""
        from mcap import records  # noqa: PLC0415 - an extra

        found = _Contents()
        for block in self._blocks():
            for record in block:
                if isinstance(record, records.Message):
                    found.add(record.channel_id, record.log_time)
                elif isinstance(record, records.Channel):
                    found.channels[record.id] = record
                elif isinstance(record, records.Schema):
                    found.schemas[record.id] = record
                elif isinstance(record, records.Metadata) and record.name == "rosbag2":
                    self._extra = dict(record.metadata)
        return found

    def _blocks(self) -> Iterator[list[Any]]:
        """Yield lists: all records of a chunk, or one other record. End at the first damage."""
        from mcap.records import Chunk  # noqa: PLC0415 - an extra
        from mcap.stream_reader import StreamReader, breakup_chunk, read_magic  # noqa: PLC0415

        size = self._path.stat().st_size
        with self._path.open("rb") as stream:
            from mcap.data_stream import ReadDataStream  # noqa: PLC0415 - an extra

            read_magic(ReadDataStream(stream))
            # A record cannot be longer than the file, so a damaged length allocates no memory. A
            # file with holes can be longer than the disk.
            limit = min(size, _MAX_RECORD_BYTES)
            records = StreamReader(
                stream, skip_magic=True, emit_chunks=True, record_size_limit=limit
            ).records
            while True:
                try:
                    record = next(records, None)
                    if record is None:
                        return
                    if isinstance(record, Chunk):
                        data = chunk_data(record)
                        deque(chunk_records(data), maxlen=0)  # raises the errors of its records
                        yield breakup_chunk(replace(record, compression="", data=data))
                    else:
                        yield [record]
                except self._errors as error:
                    # The records after the damage are not read.
                    self.damage = self.damage or _reason(error)
                    return

    def _metadata(self) -> BagMetadata:
        contents = self._contents
        count = sum(contents.counts.values())
        start, duration = contents.start_ns, contents.end_ns - contents.start_ns
        topics: dict[str, TopicInformation] = {}
        for number, channel in contents.channels.items():
            known = topics.get(channel.topic)
            messages = contents.counts.get(number, 0) + (known.message_count if known else 0)
            topics[channel.topic] = TopicInformation(self._topic(channel), messages)
        written = self._written()
        return BagMetadata(
            storage_id=STORAGE_ID,
            topics=tuple(topics.values()),
            files=(FileInformation(self._path.name, start, duration, count),),
            paths=(self._path.name,),
            start_ns=start,
            duration_ns=duration,
            message_count=count,
            custom_data={} if written is None else written.custom_data,
            ros_distro=self._extra.get("ROS_DISTRO", "") if written is None else written.ros_distro,
            bag_size=self._path.stat().st_size,
        )

    def _topic(self, channel: Any) -> TopicMetadata:
        schema = self._contents.schemas.get(channel.schema_id)
        return TopicMetadata(
            name=channel.topic,
            type_name="" if schema is None else schema.name,
            serialization_format=channel.message_encoding,
            offered_qos_profiles=tuple(
                read_profiles(channel.metadata.get("offered_qos_profiles", ""))
            ),
            type_hash=channel.metadata.get("topic_type_hash", ""),
        )

    def _written(self) -> BagMetadata | None:
        """Return the description that rosbag2 writes into the file, if there is one."""
        try:
            return read_metadata(self._extra["serialized_metadata"])
        except (AttributeError, KeyError, TypeError, ValueError):
            return None


def _is_complete(summary: Any, counted: Any) -> bool:
    """Return whether a summary has all that its statistics count.

    Writers may leave out any part. E.g. rosbag2 leaves out channels with `noRepeatedChannels`.
    """
    channels = summary.channels.values()
    return (
        len(summary.chunk_indexes) > 0
        and len(summary.chunk_indexes) >= counted.chunk_count
        and len(channels) >= counted.channel_count
        and len(summary.schemas) >= counted.schema_count
        and len(summary.metadata_indexes) >= counted.metadata_count
        and {0, *summary.schemas}.issuperset(channel.schema_id for channel in channels)
        and summary.channels.keys() >= counted.channel_message_counts.keys()
        and sum(counted.channel_message_counts.values()) == counted.message_count
    )


def _read_errors() -> tuple[type[Exception], ...]:
    """Return all exceptions that damaged bytes cause in mcap and its decompressors."""
    from mcap.exceptions import McapError  # noqa: PLC0415 - an extra

    found = [McapError, struct.error, ValueError, KeyError, OverflowError, MemoryError]
    import zstandard  # noqa: PLC0415 - an extra

    found.append(zstandard.ZstdError)
    return (*found, RuntimeError)  # lz4 raises RuntimeError


def _reason(error: Exception) -> str:
    from mcap.exceptions import EndOfFile, InvalidMagic  # noqa: PLC0415 - an extra

    if isinstance(error, InvalidMagic):
        return "it is not an MCAP file"
    if isinstance(error, EndOfFile | struct.error):
        return "the file has no end: its program was killed, or it was copied incompletely"
    return f"a part of the file is damaged ({type(error).__name__}: {error})"
