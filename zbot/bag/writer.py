"""Writer of bags: a folder with MCAP or sqlite3 files and `metadata.yaml`."""

from __future__ import annotations

import contextlib
import time
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from zbot.bag.definition import ENCODING, definition_text
from zbot.bag.errors import BagExistsError, BagWriteError, bag_topic_error
from zbot.bag.latched_messages import LatchedMessages
from zbot.bag.mcap_options import McapOptions, preset_options, read_storage_config
from zbot.bag.mcap_writer import McapWriter
from zbot.bag.message import NO_DEFINITION, Definition, compressed_message
from zbot.bag.metadata import (
    METADATA_FILE,
    BagMetadata,
    TopicMetadata,
    merged,
    metadata_text,
)
from zbot.bag.packages import import_mcap
from zbot.bag.sqlite_writer import SqliteWriter
from zbot.interfaces import type_hash, type_name
from zbot.package.ros_variables import ros_variable
from zbot.qos import QoSProfile
from zbot.time import S_TO_NS
from zbot.wire.serialization import serialize_message

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping
    from types import TracebackType

    from typing_extensions import Self

    from zbot.bag.message import StorageWriter
    from zbot.bag.options import RecordOptions, StorageOptions

STORAGES = ("mcap", "sqlite3")
_SUFFIXES = {"mcap": ".mcap", "sqlite3": ".db3"}


class Writer:
    """Writer of a new bag. Only one thread at a time may use it.

        with zbot.bag.Writer("lesson") as bag:
            bag.write("/chatter", String(data="hello"))

    Without `close`, e.g. after SIGKILL, the files have all messages before the last `flush`.

    Args:
        path: Folder of the new bag. It must not exist. The first file in it is `NAME_0.mcap`.
        storage_id: `mcap`, or `sqlite3` for programs of older versions of ROS 2.
        max_bytes: Size of a file after which the next file begins. 0 means no limit.
        max_duration_s: Duration of a file in seconds after which the next file begins. 0 means no
            limit.
        preset: Options of the MCAP file: `zstd` (the default), `zstd_fast`, `zstd_small`, `none` or
            `fastwrite`. The last two do not compress.
        mcap_options: Options of the MCAP file, instead of a preset.
        compress_messages: Compress each message. Only rosbag2 and zbot can read such bags.
        compress_files: Compress each complete file as a whole, to `NAME_0.mcap.zstd`.
        custom_data: Texts for the bag's metadata.
        repeats_latched: Whether each further file begins with the last messages of transient local
            topics.

    Raises:
        ValueError: `storage_id` is wrong.
        BagExistsError: The path exists.
        BagWriteError: The folder or the file cannot be made.
        NoBagExtraError: The extra `bag` is not installed.
    """

    def __init__(
        self,
        path: str | Path,
        *,
        storage_id: str = "mcap",
        max_bytes: int = 0,
        max_duration_s: float = 0,
        preset: str = "zstd",
        mcap_options: McapOptions | None = None,
        compress_files: bool = False,
        compress_messages: bool = False,
        custom_data: Mapping[str, str] | None = None,
        repeats_latched: bool = False,
    ) -> None:
        if storage_id not in STORAGES:
            raise ValueError(f"storage_id cannot be {storage_id!r}: choose mcap or sqlite3")
        import_mcap()
        self.path = Path(path)
        self._storage_id = storage_id
        self._max_bytes = max_bytes
        self._max_duration_ns = int(max_duration_s * S_TO_NS)
        options = mcap_options or preset_options(preset)
        self._options = (
            replace(options, compression="none") if compress_files or compress_messages else options
        )
        self._compresses_files = compress_files
        self._compresses_messages = compress_messages
        self._custom_data = dict(custom_data or {})
        self._distro = ros_variable("ROS_DISTRO")
        self._topics: dict[str, tuple[TopicMetadata, Definition]] = {}
        self._parts: list[BagMetadata] = []
        self._latched = LatchedMessages() if repeats_latched else None
        #: Function that is called with the paths of a finished file and of the next file.
        self.on_split: Callable[[Path, Path], None] | None = None
        self._file: StorageWriter | None = None
        self._is_closed = False
        try:
            self.path.mkdir(parents=True)
            self._file = self._new_file()
        except FileExistsError:
            raise BagExistsError(path, "choose another name, or delete the folder") from None
        except OSError as error:
            raise BagWriteError(path, _reason(error)) from error

    @property
    def message_count(self) -> int:
        """Messages that were written."""
        present = 0 if self._file is None else self._file.message_count
        return present + sum(part.message_count for part in self._parts)

    @property
    def topics(self) -> frozenset[str]:
        """Names of the topics."""
        return frozenset(self._topics)

    def write(self, topic: str, msg: Any, t_ns: int | None = None) -> None:
        """Write a message. The first message of a topic decides the topic's type.

        Args:
            topic: Full name of the topic. A name without a leading slash gets one.
            msg: The message.
            t_ns: Time in nanoseconds since the epoch. `None` means now.

        Raises:
            BagValueError: The topic has another type.
            CodecError: A field has a wrong value.
            BagWriteError: The bag cannot be written, e.g. because the disk is full.
        """
        name = topic if topic.startswith("/") else f"/{topic}"
        message_type = type_name(type(msg))
        known = self._topics.get(name)
        if known is None:
            profile = QoSProfile(depth=10)
            self.create_topic(TopicMetadata(name, message_type, offered_qos_profiles=(profile,)))
        elif known[0].type_name != message_type:
            reason = f"its type is {known[0].type_name}, and the message is a {message_type}"
            raise bag_topic_error(name, reason)
        now = time.time_ns() if t_ns is None else t_ns
        self.write_serialized(name, serialize_message(msg), now)

    def create_topic(self, topic: TopicMetadata, definition: Definition | None = None) -> None:
        """Add a topic. A topic that is known already does not change.

        Args:
            topic: The topic. If there is no definition and no hash, this machine's hash of the type
                is used.
            definition: The definition of its type. `None` means this machine's definition.

        Raises:
            UnknownPackageError: The type is not known here.
            UnknownInterfaceError: The type is not known here, but its package is known.
            BagWriteError: The bag cannot be written, e.g. because the disk is full.
        """
        if topic.name in self._topics:
            return
        if definition is None:
            definition = Definition(ENCODING, definition_text(topic.type_name))
            if not topic.type_hash:
                topic = TopicMetadata(
                    topic.name,
                    topic.type_name,
                    topic.serialization_format,
                    topic.offered_qos_profiles,
                    type_hash(topic.type_name),
                )
        self._topics[topic.name] = topic, definition
        if self._latched is not None:
            self._latched.add_topic(topic)
        file = self._open_file()
        try:
            file.add_topic(topic, definition)
        except OSError as error:
            raise self._failure(error) from error

    def write_serialized(
        self, topic: str, data: bytes, log_ns: int, publish_ns: int | None = None
    ) -> None:
        """Write a message that is CDR already. Times are nanoseconds since the epoch.

        Raises:
            BagValueError: `create_topic` was not called for the topic, or a time is below 0.
            BagWriteError: The bag cannot be written, e.g. because the disk is full.
        """
        if topic not in self._topics:
            raise bag_topic_error(topic, "call create_topic() first")
        sent_ns = log_ns if publish_ns is None else publish_ns
        if not (0 <= log_ns < 2**63 and 0 <= sent_ns < 2**63):
            raise bag_topic_error(topic, f"the time {log_ns} ns is not between 1970 and 2262")
        if self._compresses_messages:
            data = compressed_message(data)
        file = self._open_file()
        try:
            if self._is_full(file, log_ns):
                file = self._begin_next_file(file, log_ns)
            file.write(topic, data, log_ns, sent_ns)
        except OSError as error:
            raise self._failure(error) from error
        if self._latched is not None:
            self._latched.add(topic, data, sent_ns)

    def split(self) -> None:
        """Finish the file, and begin the next one. Do nothing if the file has no messages.

        Raises:
            BagWriteError: The bag cannot be written, e.g. because the disk is full.
        """
        file = self._open_file()
        try:
            if file.message_count:
                self._begin_next_file(file, time.time_ns())
        except OSError as error:
            raise self._failure(error) from error

    def set_custom_data(self, key: str, value: str) -> None:
        """Set a text of the bag's metadata. It is written at the end of each file."""
        self._custom_data[key] = value

    def flush(self) -> None:
        """Write all messages so far into the file, so that they survive a crash of the process.

        Raises:
            BagWriteError: The bag cannot be written, e.g. because its folder was removed.
        """
        file = self._open_file()
        try:
            file.flush()
            if not self.path.is_dir():
                raise FileNotFoundError(2, "its folder was removed")
        except OSError as error:
            raise self._failure(error) from error

    def close(self) -> None:
        """Write the end of the file and `metadata.yaml`. This method may be called twice.

        Raises:
            BagWriteError: The bag cannot be written, e.g. because the disk is full. What was
                written before can be read.
        """
        if self._is_closed:
            return
        self._is_closed = True
        file, self._file = self._file, None
        if file is None:
            return  # after an error
        try:
            self._finish_file(file)
            text = metadata_text(self._metadata())
            (self.path / METADATA_FILE).write_text(text, encoding="utf-8")
        except OSError as error:
            raise self._failure(error, file) from error

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self.close()

    def _open_file(self) -> StorageWriter:
        if self._file is None:
            raise BagWriteError(self.path, "it is closed")
        return self._file

    def _is_full(self, file: StorageWriter, log_ns: int) -> bool:
        if not file.message_count:
            return False
        is_long = self._max_duration_ns and log_ns - file.start_ns >= self._max_duration_ns
        return bool(is_long or (self._max_bytes and file.size >= self._max_bytes))

    def _new_file(self) -> StorageWriter:
        suffix = _SUFFIXES[self._storage_id]
        path = self.path / f"{self.path.resolve().name}_{len(self._parts)}{suffix}"
        file: StorageWriter
        if self._storage_id == "mcap":
            file = McapWriter(path, self._options)
        else:
            file = SqliteWriter(path, self._distro)
        for topic, definition in self._topics.values():
            file.add_topic(topic, definition or NO_DEFINITION)
        return file

    def _begin_next_file(self, file: StorageWriter, log_ns: int) -> StorageWriter:
        self._finish_file(file)
        opened = self._file = self._new_file()
        if self._latched is not None:
            for topic, data, sent_ns in self._latched.messages():
                opened.write(topic, data, log_ns, sent_ns)
        if self.on_split is not None:
            self.on_split(self.path / self._parts[-1].paths[0], opened.path)
        return opened

    def _finish_file(self, file: StorageWriter) -> None:
        described = file.close(self._custom_data, self._distro)
        if self._compresses_files:
            described = _compressed(self.path, described)
        self._parts.append(described)

    def _metadata(self) -> BagMetadata:
        whole = merged(self._parts)
        if self._compresses_messages:
            return replace(whole, compression_format="zstd", compression_mode="MESSAGE")
        if self._compresses_files:
            return replace(whole, compression_format="zstd", compression_mode="FILE")
        return whole

    def _failure(self, error: OSError, file: StorageWriter | None = None) -> BagWriteError:
        """Close the file after an error of the system, and return the error for the caller."""
        broken, self._file = self._file or file, None
        if broken is not None:
            # This may fail too, e.g. if the file is closed. Only the first error is reported.
            with contextlib.suppress(OSError, ValueError):
                broken.abandon()
        return BagWriteError(self.path, _reason(error))


def _compressed(folder: Path, described: BagMetadata) -> BagMetadata:
    """Compress the file of a description as a whole. Return the new description."""
    import zstandard  # noqa: PLC0415 - an extra

    plain = folder / described.paths[0]
    packed = plain.with_name(f"{plain.name}.zstd")
    with plain.open("rb") as source, packed.open("xb") as target:
        zstandard.ZstdCompressor().copy_stream(source, target)
    plain.unlink()
    file = replace(described.files[0], path=packed.name)
    return replace(described, files=(file,), paths=(packed.name,))


def _reason(error: OSError) -> str:
    return error.strerror or str(error)


def writer_for(storage: StorageOptions, record: RecordOptions) -> Writer:
    """Return the writer of a new bag. Raise the errors of `Writer` and `read_storage_config`."""
    preset, config = storage.storage_preset_profile or "zstd", storage.storage_config_uri
    mode = record.compression_mode.lower()
    return Writer(
        storage.uri,
        storage_id=storage.storage_id or "mcap",
        max_bytes=storage.max_bagfile_size,
        max_duration_s=storage.max_bagfile_duration,
        preset=preset,
        mcap_options=read_storage_config(Path(config), preset) if config else None,
        compress_files=mode == "file",
        compress_messages=mode == "message",
        custom_data=storage.custom_data,
        repeats_latched=storage.repeat_latched,
    )
