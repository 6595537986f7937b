"""Last messages of latched topics, for the beginning of the next file of a bag."""

from __future__ import annotations

from collections import deque
from typing import TYPE_CHECKING, NamedTuple

from zbot.qos import DurabilityPolicy

if TYPE_CHECKING:
    from collections.abc import Iterator

    from zbot.bag.metadata import TopicMetadata

_MAX_DEPTH = 1000


class LatchedMessage(NamedTuple):
    """Message of a latched topic."""

    topic: str
    data: bytes
    publish_ns: int


class LatchedMessages:
    """Memory of the messages that a late subscription would still get.

    A topic is latched if the profile of one of its publishers has the durability transient local.
    """

    def __init__(self) -> None:
        self._messages: dict[str, deque[LatchedMessage]] = {}

    def add_topic(self, topic: TopicMetadata) -> None:
        """Add a topic. A topic that is not latched is ignored."""
        depths = [
            min(max(profile.depth, 1), _MAX_DEPTH)
            for profile in topic.offered_qos_profiles
            if profile.durability is DurabilityPolicy.TRANSIENT_LOCAL
        ]
        if depths:
            self._messages[topic.name] = deque(maxlen=max(depths))

    def add(self, topic: str, data: bytes, publish_ns: int) -> None:
        """Keep a message if its topic is latched."""
        kept = self._messages.get(topic)
        if kept is not None:
            kept.append(LatchedMessage(topic, data, publish_ns))

    def messages(self) -> Iterator[LatchedMessage]:
        """Yield the messages."""
        for kept in self._messages.values():
            yield from kept
