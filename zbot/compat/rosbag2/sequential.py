"""Classes that read, write and describe bags, with the signatures of ROS 2's `rosbag2_py`."""

from __future__ import annotations

import weakref
from pathlib import Path
from typing import TYPE_CHECKING

from zbot.bag import conversion
from zbot.bag.definition import ENCODING, definition_text
from zbot.bag.description import SORT_KEYS, contributions, description, topic_names
from zbot.bag.errors import BagReadError, BagWriteError
from zbot.bag.metadata import METADATA_FILE, metadata_text, read_metadata, read_metadata_file
from zbot.bag.options import StorageOptions
from zbot.bag.reader import Reader
from zbot.bag.writer import STORAGES, Writer
from zbot.compat.rosbag2.storage import (
    BagMetadata,
    CompressionMode,
    CompressionOptions,
    ConverterOptions,
    MessageDefinition,
    ReadOrder,
    StorageFilter,
    TopicMetadata,
    bag_metadata,
    to_own_metadata,
    to_own_topic,
    topic_metadata,
)
from zbot.errors import ArgumentTypeError
from zbot.interfaces import type_hash

if TYPE_CHECKING:
    from collections.abc import Iterator

    from zbot.bag.message import BagMessage


def _check_options(options: object) -> None:
    """Raise `ArgumentTypeError` for other options, e.g. only the path of a bag."""
    if not isinstance(options, StorageOptions):
        uri = str(options) if isinstance(options, (str, Path)) else "my_bag"
        expected = f"StorageOptions: write StorageOptions(uri={uri!r}, storage_id='mcap')"
        raise ArgumentTypeError("storage_options", expected, options)


class SequentialReader:
    """Reader that returns one message after the other, not decoded."""

    def __init__(self) -> None:
        self._bag: Reader | None = None
        self._end_ns: int | None = None
        self._messages: Iterator[BagMessage] = iter(())
        self._next: BagMessage | None = None
        self._filter = StorageFilter().selection()

    def open(
        self, storage_options: StorageOptions, converter_options: ConverterOptions | None = None
    ) -> None:
        """Open a bag.

        Raises:
            BagNotFoundError: There is nothing with this path.
            BagReadError: The path is not a bag, or the bag cannot be read.
        """
        del converter_options  # all messages are CDR
        _check_options(storage_options)
        self._bag = Reader(storage_options.uri, storage_options.storage_id)
        self._end_ns = storage_options.end_time_ns if storage_options.end_time_ns >= 0 else None
        self.seek(max(storage_options.start_time_ns, 0))

    def open_uri(self, uri: str) -> None:
        """Open a bag of any format. Raise the errors of `open`."""
        self.open(StorageOptions(uri))

    def close(self) -> None:
        """Close the bag."""
        bag, self._bag = self._bag, None
        if bag is not None:
            bag.close()

    def has_next(self) -> bool:
        """Return whether `read_next` has a message."""
        topics = self._opened().topics
        while self._next is None or not self._takes(self._next, topics[self._next.topic].type_name):
            self._next = next(self._messages, None)
            if self._next is None:
                return False
        return True

    def read_next(self) -> tuple[str, bytes, int]:
        """Return the topic, the message in CDR, and the time of recording in nanoseconds.

        Raises:
            BagReadError: There is no message left.
        """
        if not self.has_next() or self._next is None:
            raise BagReadError(self._opened().path, "there is no message left")
        message, self._next = self._next, None
        return message.topic, message.data, message.log_ns

    def seek(self, timestamp: int) -> None:
        """Continue with the first message at or after a time. The filter does not change."""
        self._next = None
        self._messages = self._opened().messages(None, timestamp, self._end_ns)

    def set_filter(self, storage_filter: StorageFilter) -> None:
        """Read only messages of some topics from now on."""
        self._filter = storage_filter.selection()

    def reset_filter(self) -> None:
        """Read messages of all topics from now on."""
        self.set_filter(StorageFilter())

    def set_read_order(self, order: ReadOrder) -> bool:
        """Return whether the reader supports an order of messages.

        The reader supports only the default: the time of recording, with the oldest message first.
        """
        return order == ReadOrder()

    def get_all_topics_and_types(self) -> list[TopicMetadata]:
        """Return the topics."""
        topics = self._opened().topics.values()
        return [topic_metadata(number, topic) for number, topic in enumerate(topics, 1)]

    def get_all_message_definitions(self) -> list[MessageDefinition]:
        """Return the definitions of all message types."""
        bag = self._opened()
        types = {topic.type_name: topic.type_hash for topic in bag.topics.values()}
        return [
            MessageDefinition(name, *bag.definition(name), type_hash)
            for name, type_hash in types.items()
        ]

    def get_metadata(self) -> BagMetadata:
        """Return the description of the bag."""
        return bag_metadata(self._opened().metadata)

    def _takes(self, message: BagMessage, type_name: str) -> bool:
        return self._filter.takes(message.topic, type_name)

    def _opened(self) -> Reader:
        if self._bag is None:
            raise BagReadError("", "call open() first")
        return self._bag


class SequentialWriter:
    """Writer of a bag. `close` or the end of the object completes the bag."""

    _mode = CompressionMode.NONE

    def __init__(self) -> None:
        self._bag: Writer | None = None

    def open(
        self, storage_options: StorageOptions, converter_options: ConverterOptions | None = None
    ) -> None:
        """Make a new bag.

        Raises:
            BagExistsError: The path exists.
            BagWriteError: The bag cannot be made, or there is no such storage.
        """
        del converter_options  # all messages are CDR
        _check_options(storage_options)
        storage_id = storage_options.storage_id or "mcap"
        if storage_id not in STORAGES:
            reason = f"there is no storage {storage_id}: choose mcap or sqlite3"
            raise BagWriteError(storage_options.uri, reason)
        bag = self._bag = Writer(
            storage_options.uri,
            compress_files=self._mode is CompressionMode.FILE,
            compress_messages=self._mode is CompressionMode.MESSAGE,
            storage_id=storage_id,
            max_bytes=storage_options.max_bagfile_size,
            max_duration_s=storage_options.max_bagfile_duration,
            preset=storage_options.storage_preset_profile or "zstd",
            custom_data=storage_options.custom_data,
        )
        # At the end of the program, `__del__` comes too late: Python can then import no module.
        weakref.finalize(self, bag.close)

    def create_topic(self, topic: TopicMetadata) -> None:
        """Add a topic. Its type must be known here. Raise the errors of `Writer`."""
        self._opened().create_topic(to_own_topic(topic))

    def write(
        self, topic_name: str, message: bytes, time_stamp: int, send_time_stamp: int | None = None
    ) -> None:
        """Write a message in CDR. The times are nanoseconds. Raise the errors of `Writer`.

        Raises:
            ArgumentTypeError: The message is not serialized.
        """
        if hasattr(message, "get_fields_and_field_types"):
            raise ArgumentTypeError("message", "bytes: write serialize_message(message)", message)
        self._opened().write_serialized(topic_name, bytes(message), time_stamp, send_time_stamp)

    def remove_topic(self, topic: TopicMetadata) -> None:
        """Do nothing, because MCAP files keep their topics. It exists for programs of ROS 2."""

    def split_bagfile(self) -> None:
        """Begin the next file of the bag. Raise `BagWriteError` if it cannot be made."""
        self._opened().split()

    def take_snapshot(self) -> bool:
        """Return false, because this writer keeps no messages in memory."""
        return False

    def close(self) -> None:
        """Complete the bag. This method may be called twice."""
        bag, self._bag = self._bag, None
        if bag is not None:
            bag.close()

    def _opened(self) -> Writer:
        if self._bag is None:
            raise BagWriteError("", "call open() first")
        return self._bag


class SequentialCompressionReader(SequentialReader):
    """Reader of compressed bags. `SequentialReader` reads them too."""


class SequentialCompressionWriter(SequentialWriter):
    """Writer whose files are compressed.

    Args:
        compression_options: Whether whole files or single messages are compressed.
    """

    def __init__(self, compression_options: CompressionOptions | None = None) -> None:
        super().__init__()
        if compression_options is not None:
            self._mode = compression_options.compression_mode


class LocalMessageDefinitionSource:
    """Definitions of the message types that this machine knows."""

    def get_full_text(self, topic_type: str) -> MessageDefinition:
        """Return the definition of a type and of all types inside it.

        The encoding is `unknown`, and the text is empty, if this machine does not know the type.
        """
        try:
            text = definition_text(topic_type)
        except LookupError:
            return MessageDefinition(topic_type, "unknown", "", "")
        return MessageDefinition(topic_type, ENCODING, text, type_hash(topic_type))


class Info:
    """Descriptions of bags, and their texts."""

    def read_metadata(self, uri: str, storage_id: str = "") -> BagMetadata:
        """Return the description of a bag. Raise the errors of `SequentialReader.open`."""
        with Reader(uri, storage_id) as bag:
            return bag_metadata(bag.metadata)

    def print_output(self, metadata: BagMetadata, sorting_method: str = "name") -> None:
        """Print a description as `ros2 bag info`."""
        print(description(to_own_metadata(metadata), sort=sorting_method), end="")

    def print_output_topic_name_only(
        self, metadata: BagMetadata, sorting_method: str = "name"
    ) -> None:
        """Print the names of the topics."""
        print("\n".join(topic_names(to_own_metadata(metadata), sorting_method)))

    def print_output_verbose(
        self, uri: str, metadata: BagMetadata, sorting_method: str = "name"
    ) -> None:
        """Print a description as `ros2 bag info --verbose`."""
        with Reader(uri) as bag:
            sizes, calls = contributions(bag)
        found = to_own_metadata(metadata)
        print(description(found, sort=sorting_method, sizes=sizes, calls=calls), end="")

    def get_sorting_methods(self) -> set[str]:
        """Return the names of the orders in which topics can be printed."""
        return set(SORT_KEYS)


class MetadataIo:
    """Reader and writer of `metadata.yaml`."""

    def metadata_file_exists(self, uri: str) -> bool:
        """Return whether the folder has such a file."""
        return (Path(uri) / METADATA_FILE).exists()

    def read_metadata(self, uri: str) -> BagMetadata:
        """Return the contents of the file. Raise `BagReadError` if it cannot be read."""
        return bag_metadata(read_metadata_file(Path(uri)))

    def write_metadata(self, uri: str, metadata: BagMetadata) -> None:
        """Write the file. Raise `BagWriteError` if it cannot be written."""
        try:
            text = metadata_text(to_own_metadata(metadata))
            (Path(uri) / METADATA_FILE).write_text(text, encoding="utf-8")
        except OSError as error:
            raise BagWriteError(uri, error.strerror or str(error)) from error

    def serialize_metadata(self, metadata: BagMetadata) -> str:
        """Return the YAML of a description."""
        return metadata_text(to_own_metadata(metadata))

    def deserialize_metadata(self, text: str) -> BagMetadata:
        """Return the description in YAML. Raise `BagReadError` if the text is not a description."""
        try:
            return bag_metadata(read_metadata(text))
        except (AttributeError, KeyError, TypeError, ValueError) as error:
            raise BagReadError("text", f"it is not a bag's metadata: {error}") from error


class Reindexer:
    """Writer of lost `metadata.yaml` files."""

    def reindex(self, storage_options: StorageOptions) -> None:
        """Write `metadata.yaml` again. Raise `BagReadError` if the bag cannot be read."""
        conversion.reindex(Path(storage_options.uri))


def get_registered_readers() -> set[str]:
    """Return the storages that can be read."""
    return {"mcap", "sqlite3"}


def get_registered_writers() -> set[str]:
    """Return the storages that can be written."""
    return set(STORAGES)


def get_registered_compressors() -> set[str]:
    """Return the formats of `--compression-format`."""
    return {"zstd"}


def get_registered_serializers() -> set[str]:
    """Return an empty set, because zbot has no converters to other serializations."""
    return set()


def get_default_storage_id() -> str:
    """Return the storage of new bags."""
    return "mcap"
