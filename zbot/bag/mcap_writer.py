"""Writer of one MCAP file, as rosbag2 writes it."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from zbot.bag.mcap_options import McapOptions
from zbot.bag.mcap_reader import STORAGE_ID
from zbot.bag.metadata import RecordedPart, metadata_text
from zbot.bag.packages import import_mcap
from zbot.bag.qos_profiles import profiles_text
from zbot.version import __version__

if TYPE_CHECKING:
    from pathlib import Path

    from zbot.bag.message import Definition
    from zbot.bag.metadata import BagMetadata, TopicMetadata


class McapWriter:
    """Writer of one MCAP file.

    After an `OSError`, only `abandon` may be called.

    Args:
        path: The new file.
        options: The options of the file.

    Raises:
        OSError: The file cannot be made, or it exists.
        NoBagExtraError: The package `mcap` is not installed.
    """

    def __init__(self, path: Path, options: McapOptions | None = None) -> None:
        import_mcap()
        self.path = path
        self._file = _File(path)
        self._part = RecordedPart(STORAGE_ID, path)
        self._channels: dict[str, int] = {}
        self._schemas: dict[str, int] = {}
        self._pending = 0
        self._writer: Any = _writer(self._file, options or McapOptions())
        self._writer.start(profile="ros2", library=f"zbot {__version__}")
        self._file.mark()

    @property
    def size(self) -> int:
        """Bytes of the file so far. Messages that are not compressed yet count in full."""
        return self._file.position + self._pending

    @property
    def message_count(self) -> int:
        """Messages in the file."""
        return self._part.count

    @property
    def start_ns(self) -> int:
        """Time of the first message, in nanoseconds since the epoch."""
        return self._part.start_ns

    def add_topic(self, topic: TopicMetadata, definition: Definition) -> None:
        """Add a topic. All messages of the topic come later."""
        schema = self._schemas.get(topic.type_name)
        if schema is None:
            schema = self._writer.register_schema(
                topic.type_name, definition.encoding, definition.text.encode()
            )
            self._schemas[topic.type_name] = schema
        self._channels[topic.name] = self._writer.register_channel(
            topic.name,
            topic.serialization_format,
            schema,
            {
                "offered_qos_profiles": profiles_text(topic.offered_qos_profiles),
                "topic_type_hash": topic.type_hash,
            },
        )
        self._part.add_topic(topic)

    def write(self, topic: str, data: bytes, log_ns: int, publish_ns: int) -> None:
        """Add a message. The message is in the file after the next `flush`, or earlier."""
        before = self._file.position
        self._writer.add_message(self._channels[topic], log_ns, data, publish_ns)
        if self._file.position != before:  # a chunk is full
            self._file.mark()
            self._pending = 0
        else:
            self._pending += len(data)
        self._part.add_message(topic, log_ns)

    def flush(self) -> None:
        """Write all messages so far into the file, so that they survive a crash of the process."""
        if self._pending:
            self._writer.flush()
            self._file.mark()
            self._pending = 0

    def close(self, custom_data: dict[str, str], ros_distro: str) -> BagMetadata:
        """Write the end of the file, and return the description of the file."""
        described = self._part.metadata(custom_data, ros_distro)
        self.flush()
        self._writer.add_metadata(
            "rosbag2", {"serialized_metadata": metadata_text(described, root=False)}
        )
        self._writer.finish()
        self._file.close()
        return described

    def abandon(self) -> None:
        """Close the file after an error. The file keeps all records that are complete."""
        self._file.cut()


class _File:
    """File without a buffer, so a failed write raises an error immediately."""

    def __init__(self, path: Path) -> None:
        self._raw = path.open("xb", buffering=0)
        self.position = 0
        self._complete = 0

    def write(self, data: bytes) -> int:
        left = memoryview(data)
        while left:
            written = self._raw.write(left) or 0
            self.position += written
            left = left[written:]
        return len(data)

    def tell(self) -> int:
        return self.position

    def flush(self) -> None:
        """Do nothing: there is no buffer."""

    def mark(self) -> None:
        """Note that all records so far are complete."""
        self._complete = self.position

    def cut(self) -> None:
        """Remove the last record if it is incomplete, and close the file."""
        with self._raw:
            self._raw.truncate(self._complete)

    def close(self) -> None:
        self._raw.close()


def _writer(file: _File, options: McapOptions) -> Any:
    from mcap.writer import CompressionType, IndexType, Writer  # noqa: PLC0415 - an extra

    indexes = IndexType.ALL if options.has_message_index else IndexType.ALL & ~IndexType.MESSAGE
    return Writer(
        file,  # type: ignore[arg-type]  # it has the methods that the writer calls
        chunk_size=options.chunk_bytes,
        compression=CompressionType[options.compression.upper()],
        index_types=indexes,
        use_chunking=options.uses_chunks,
        use_statistics=options.has_statistics,
        use_summary_offsets=options.has_summary_offsets,
        repeat_channels=options.repeats_channels,
        repeat_schemas=options.repeats_schemas,
        enable_crcs=options.has_crcs,
        enable_data_crcs=options.has_data_crc,
    )
