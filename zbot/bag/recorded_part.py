"""Counts and times of a file that is being written, for its description."""

from __future__ import annotations

from typing import TYPE_CHECKING

from zbot.bag.metadata import BagMetadata, FileInformation, TopicInformation

if TYPE_CHECKING:
    from pathlib import Path

    from zbot.bag.metadata import TopicMetadata


class RecordedPart:
    """Counts and times of the messages in one file of a bag.

    Args:
        storage_id: `mcap` or `sqlite3`.
        path: The file.
    """

    def __init__(self, storage_id: str, path: Path) -> None:
        self._storage_id = storage_id
        self._name = path.name
        self._topics: dict[str, TopicMetadata] = {}
        self._counts: dict[str, int] = {}
        self.count = 0  #: messages in the file
        self.start_ns = 0  #: time of the first message
        self._end_ns = 0

    def add_topic(self, topic: TopicMetadata) -> None:
        """Add a topic without messages."""
        self._topics[topic.name] = topic
        self._counts[topic.name] = 0

    def add_message(self, topic: str, log_ns: int) -> None:
        """Count a message. The time is nanoseconds since the epoch."""
        self.start_ns = min(log_ns, self.start_ns) if self.count else log_ns
        self._end_ns = max(log_ns, self._end_ns)
        self.count += 1
        self._counts[topic] += 1

    def metadata(self, custom_data: dict[str, str], ros_distro: str) -> BagMetadata:
        """Return the description of the file."""
        duration_ns = self._end_ns - self.start_ns
        file = FileInformation(self._name, self.start_ns, duration_ns, self.count)
        return BagMetadata(
            storage_id=self._storage_id,
            topics=tuple(
                TopicInformation(one, self._counts[name]) for name, one in self._topics.items()
            ),
            files=(file,),
            paths=(self._name,),
            start_ns=self.start_ns,
            duration_ns=duration_ns,
            message_count=self.count,
            custom_data=custom_data,
            ros_distro=ros_distro,
        )
