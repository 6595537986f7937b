"""Writer of one sqlite3 file, as rosbag2 writes it."""

from __future__ import annotations

import os
import sqlite3
from contextlib import closing, suppress
from typing import TYPE_CHECKING

from zbot.bag.metadata import VERSION, RecordedPart, metadata_text
from zbot.bag.qos_profiles import profiles_text
from zbot.bag.sqlite_reader import STORAGE_ID

if TYPE_CHECKING:
    from pathlib import Path

    from zbot.bag.message import Definition
    from zbot.bag.metadata import BagMetadata, TopicMetadata

_SCHEMA_VERSION = 4
_TABLES = """
CREATE TABLE schema(schema_version INTEGER PRIMARY KEY, ros_distro TEXT NOT NULL);
CREATE TABLE metadata(
    id INTEGER PRIMARY KEY, metadata_version INTEGER NOT NULL, metadata TEXT NOT NULL);
CREATE TABLE topics(
    id INTEGER PRIMARY KEY, name TEXT NOT NULL, type TEXT NOT NULL,
    serialization_format TEXT NOT NULL, offered_qos_profiles TEXT NOT NULL,
    type_description_hash TEXT NOT NULL);
CREATE TABLE message_definitions(
    id INTEGER PRIMARY KEY, topic_type TEXT NOT NULL, encoding TEXT NOT NULL,
    encoded_message_definition TEXT NOT NULL, type_description_hash TEXT NOT NULL);
CREATE TABLE messages(
    id INTEGER PRIMARY KEY, topic_id INTEGER NOT NULL, timestamp INTEGER NOT NULL,
    data BLOB NOT NULL);
CREATE INDEX timestamp_idx ON messages (timestamp ASC);
"""
# Bytes that a row needs in addition to its data, e.g. for the index.
_ROW_BYTES = 32


class SqliteWriter:
    """Writer of one sqlite3 file.

    After an `OSError`, only `abandon` may be called.

    Args:
        path: The new file.
        ros_distro: Name of ROS 2's distribution that the file gets, e.g. `jazzy`.

    Raises:
        OSError: The file cannot be made, or it exists.
    """

    def __init__(self, path: Path, ros_distro: str) -> None:
        # `os.open` refuses an existing file, and its errors have the system's number. sqlite3 would
        # open an existing file.
        os.close(os.open(path, os.O_CREAT | os.O_EXCL | os.O_RDWR, 0o666))
        self.path = path
        self._part = RecordedPart(STORAGE_ID, path)
        self._numbers: dict[str, int] = {}
        self._types: set[str] = set()
        self._bytes = 0
        with _as_os_error():
            # The thread that writes is not the thread that made the object.
            self._bag = sqlite3.connect(path, check_same_thread=False, isolation_level=None)
            self._bag.execute("PRAGMA journal_mode = WAL")
            # With this setting, a commit survives the end of the process, but does not wait for the
            # disk.
            self._bag.execute("PRAGMA synchronous = NORMAL")
            self._bag.executescript(_TABLES)
            self._bag.execute("INSERT INTO schema VALUES (?, ?)", (_SCHEMA_VERSION, ros_distro))
            self._bag.execute("BEGIN")

    @property
    def size(self) -> int:
        """Bytes of the file so far. The number is not exact."""
        return self._bytes

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
        self._part.add_topic(topic)
        self._numbers[topic.name] = len(self._numbers) + 1
        row = (
            topic.name,
            topic.type_name,
            topic.serialization_format,
            profiles_text(topic.offered_qos_profiles),
            topic.type_hash,
        )
        with _as_os_error():
            self._bag.execute(
                "INSERT INTO topics VALUES (?, ?, ?, ?, ?, ?)", (self._numbers[topic.name], *row)
            )
            if topic.type_name not in self._types:
                self._types.add(topic.type_name)
                self._bag.execute(
                    "INSERT INTO message_definitions VALUES (NULL, ?, ?, ?, ?)",
                    (topic.type_name, *definition, topic.type_hash),
                )

    def write(self, topic: str, data: bytes, log_ns: int, publish_ns: int) -> None:  # noqa: ARG002
        """Add a message without `publish_ns`, because sqlite3 bags have no time of sending."""
        with _as_os_error():
            self._bag.execute(
                "INSERT INTO messages VALUES (NULL, ?, ?, ?)", (self._numbers[topic], log_ns, data)
            )
        self._bytes += len(data) + _ROW_BYTES
        self._part.add_message(topic, log_ns)

    def flush(self) -> None:
        """Write all messages so far into the file. Then they survive a crash of the process."""
        with _as_os_error():
            if self._bag.in_transaction:
                self._bag.execute("COMMIT")
            self._bag.execute("BEGIN")

    def close(self, custom_data: dict[str, str], ros_distro: str) -> BagMetadata:
        """Write the end of the file, and return the description of the file."""
        described = self._part.metadata(custom_data, ros_distro)
        with _as_os_error(), closing(self._bag) as bag:
            bag.execute(
                "INSERT INTO metadata VALUES (NULL, ?, ?)",
                (VERSION, metadata_text(described, root=False)),
            )
            bag.execute("COMMIT")
        return described

    def abandon(self) -> None:
        """Close the file after an error. The file keeps all messages before the last `flush`."""
        with suppress(sqlite3.Error):  # the first error is reported
            self._bag.close()


class _as_os_error:  # noqa: N801 - used as a statement
    """Raise errors of sqlite3 as `OSError`, as files do."""

    def __enter__(self) -> None:
        return None

    def __exit__(self, kind: object, error: BaseException | None, trace: object) -> None:
        if isinstance(error, sqlite3.Error):
            raise OSError(None, str(error)) from error
