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
                self.definitions = _definitions(bag)
                self._topics = {
                    row["id"]: _topic(row) for row in bag.execute("SELECT * FROM topics")
                }
                self.metadata = self._metadata(bag)
        except (sqlite3.Error, IndexError, UnicodeError) as error:
            raise BagReadError(path, str(error)) from error

    def messages(
        self, topics: Collection[str] | None, start_ns: int, end_ns: int | None
    ) -> Iterator[BagMessage]:
        """Yield messages as `StorageReader.messages` says.

        Raises:
            BagReadError: The file is damaged.
        """
        wanted = {
            number: one.name
            for number, one in self._topics.items()
            if topics is None or one.name in topics
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
                        yield BagMessage(wanted[number], bytes(data), time_ns, time_ns)
        except sqlite3.Error as error:
            raise BagReadError(self._path, str(error)) from error

    def _connect(self) -> sqlite3.Connection:
        bag = sqlite3.connect(f"{self._path.absolute().as_uri()}?mode=ro", uri=True)
        bag.row_factory = sqlite3.Row
        return bag

    def _metadata(self, bag: sqlite3.Connection) -> BagMetadata:
        counts = dict(bag.execute("SELECT topic_id, COUNT(*) FROM messages GROUP BY topic_id"))
        start, end = bag.execute("SELECT MIN(timestamp), MAX(timestamp) FROM messages").fetchone()
        start, duration, count = start or 0, (end or 0) - (start or 0), sum(counts.values())
        return BagMetadata(
            storage_id=STORAGE_ID,
            topics=tuple(
                TopicInformation(one, counts.get(number, 0)) for number, one in self._topics.items()
            ),
            files=(FileInformation(self._path.name, start, duration, count),),
            paths=(self._path.name,),
            start_ns=start,
            duration_ns=duration,
            message_count=count,
            bag_size=self._path.stat().st_size,
        )


def _topic(row: sqlite3.Row) -> TopicMetadata:
    columns: list[Any] = row.keys()  # older versions of rosbag2 wrote fewer columns
    return TopicMetadata(
        name=row["name"],
        type_name=row["type"],
        serialization_format=row["serialization_format"],
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
    return {row[0]: Definition(row[1], row[2]) for row in bag.execute(query)}
