"""Reader of rosbag2's sqlite3 files, which ROS 2 wrote by default before Iron."""

from __future__ import annotations

import sqlite3
from contextlib import closing
from typing import TYPE_CHECKING, Any

from zbot.bag.errors import BagReadError
from zbot.bag.message import BagMessage, Definition
from zbot.bag.metadata import BagMetadata, FileInformation, TopicInformation, TopicMetadata
from zbot.bag.qos_profiles import read_profiles

if TYPE_CHECKING:
    from collections.abc import Collection, Iterator
    from pathlib import Path

STORAGE_ID = "sqlite3"
# sqlite3 also says that it lacks memory if a size in a damaged file is too large.
_ERRORS = (sqlite3.Error, MemoryError)
_TABLES = ("topics", "messages", "message_definitions")


class SqliteReader:
    """Reader of one sqlite3 file.

    Args:
        path: The file.

    Raises:
        BagReadError: The file cannot be read or is not a bag.
    """

    def __init__(self, path: Path) -> None:
        self._path = path
        self.damage = ""
        try:
            with closing(self._connect()) as bag:
                _check_tables(bag)
                self.definitions = _definitions(bag)
                self._topics = {
                    row["id"]: _topic(row) for row in bag.execute("SELECT * FROM topics")
                }
                self.metadata = self._metadata(bag)
        except (*_ERRORS, IndexError, TypeError, UnicodeError) as error:
            raise BagReadError(path, _reason(error)) from error

    def messages(
        self, topics: Collection[str] | None, start_ns: int, end_ns: int | None
    ) -> Iterator[BagMessage]:
        """Yield messages as `StorageReader.messages` says.

        Raises:
            BagReadError: The file is damaged.
        """
        wanted = {
            number: topic.name
            for number, topic in self._topics.items()
            if topics is None or topic.name in topics
        }
        query = (
            "SELECT topic_id, data, timestamp FROM messages WHERE timestamp BETWEEN ? AND ? "
            "ORDER BY timestamp, id"
        )
        try:
            with closing(self._connect()) as bag:
                last = 2**63 - 1 if end_ns is None else end_ns
                for number, data, time_ns in bag.execute(query, (start_ns, last)):
                    if number in wanted:
                        # sqlite3 allows any kind of value in any column.
                        if not isinstance(data, bytes) or not isinstance(time_ns, int):
                            raise BagReadError(self._path, "a message is not made of bytes")
                        yield BagMessage(wanted[number], data, time_ns, time_ns)
        except _ERRORS as error:
            raise BagReadError(self._path, _reason(error)) from error

    def _connect(self) -> sqlite3.Connection:
        bag = sqlite3.connect(f"{self._path.absolute().as_uri()}?mode=ro", uri=True)
        bag.row_factory = sqlite3.Row
        # The file's own functions must not run, e.g. in a view, an index or a computed column.
        bag.execute("PRAGMA trusted_schema = OFF")
        return bag

    def _metadata(self, bag: sqlite3.Connection) -> BagMetadata:
        counts = dict(bag.execute("SELECT topic_id, COUNT(*) FROM messages GROUP BY topic_id"))
        start, end = bag.execute("SELECT MIN(timestamp), MAX(timestamp) FROM messages").fetchone()
        start, duration, count = start or 0, (end or 0) - (start or 0), sum(counts.values())
        return BagMetadata(
            storage_id=STORAGE_ID,
            topics=tuple(
                TopicInformation(topic, counts.get(number, 0))
                for number, topic in self._topics.items()
            ),
            files=(FileInformation(self._path.name, start, duration, count),),
            paths=(self._path.name,),
            start_ns=start,
            duration_ns=duration,
            message_count=count,
            bag_size=self._path.stat().st_size,
        )


def _check_tables(bag: sqlite3.Connection) -> None:
    """Check that what is read is in the file. A view or a computed column has no end or no limit.

    Raises:
        sqlite3.DatabaseError: It is a view, a virtual table or a computed column.
    """
    for table in _TABLES:
        for kind, sql in bag.execute("SELECT type, sql FROM sqlite_master WHERE name=?", (table,)):
            is_virtual = str(sql).upper().startswith("CREATE VIRTUAL")
            if kind != "table" or is_virtual:
                raise sqlite3.DatabaseError(f"{table} is no table")
        # The last column is 0 for a column whose values are in the file.
        if any(column[-1] for column in bag.execute(f"PRAGMA table_xinfo({table})")):
            raise sqlite3.DatabaseError(f"a column of {table} is computed")


def _reason(error: Exception) -> str:
    return str(error) or "the file is damaged: a size in it is too large"


def _topic(row: sqlite3.Row) -> TopicMetadata:
    columns: list[Any] = row.keys()  # older versions of rosbag2 wrote fewer columns
    return TopicMetadata(
        name=str(row["name"]),
        type_name=str(row["type"]),
        serialization_format=str(row["serialization_format"]),
        offered_qos_profiles=tuple(
            read_profiles(row["offered_qos_profiles"]) if "offered_qos_profiles" in columns else ()
        ),
        type_hash=row["type_description_hash"] if "type_description_hash" in columns else "",
    )


def _definitions(bag: sqlite3.Connection) -> dict[str, Definition]:
    tables = {row[0] for row in bag.execute("SELECT name FROM sqlite_master WHERE type='table'")}
    if "message_definitions" not in tables:
        return {}
    query = "SELECT topic_type, encoding, encoded_message_definition FROM message_definitions"
    return {str(row[0]): Definition(str(row[1]), str(row[2])) for row in bag.execute(query)}
