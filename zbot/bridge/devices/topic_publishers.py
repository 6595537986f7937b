"""Publishers of the topics of a device. A topic gets its publisher with its first value."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from zbot.bridge.devices.errors import UnreadableError
from zbot.bridge.devices.message_maker import MessageMaker
from zbot.bridge.devices.text_value import json_word, topic_name
from zbot.bridge.devices.topic_type import type_of_value
from zbot.errors import InvalidNameError
from zbot.interfaces.yaml_message import Word
from zbot.names import validate_full_topic_name
from zbot.qos import DurabilityPolicy, QoSProfile

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.bridge.devices.tally import Tally
    from zbot.bridge.devices.topic_type import TopicType, TypeTable
    from zbot.node.node import Node
    from zbot.node.publisher import Publisher

_DEPTH = 10
#: A device with a fault could invent names without end.
_MOST_TOPICS = 1000


class _Topic:
    """One topic: its publisher and the maker of its messages."""

    def __init__(self, publisher: Publisher[Any], maker: MessageMaker, *, is_latched: bool) -> None:
        self.publisher, self.maker, self.is_latched = publisher, maker, is_latched


class TopicPublishers:
    """Publishers of one device. Only one thread may publish at a time.

    Args:
        node: The node that publishes.
        types: The types that the user gives.
        tally: The counts of the device.
        is_taken: Returns whether a topic goes to the device. Such a topic is not published.

    Attributes:
        names: The full names of the topics.
    """

    def __init__(
        self,
        node: Node,
        types: TypeTable,
        tally: Tally,
        is_taken: Callable[[str], bool] = lambda _: False,
    ) -> None:
        self._node, self._types, self._tally, self._is_taken = node, types, tally, is_taken
        self._topics: dict[str, _Topic] = {}
        self.names: frozenset[str] = frozenset()

    def type_of(self, name: str) -> TopicType | None:
        """Return the type of a topic, as the user or its first value has decided it, or None."""
        topic = self._topics.get(name)
        return topic.maker.kind if topic else self._types.find(name)

    def publish(
        self, name: str, value: Any, kind: TopicType | None = None, *, is_latched: bool = False
    ) -> None:
        """Publish a value. A value that does not fit the topic's type is counted as lost.

        A dictionary for a topic without a type is published as one topic for each of its values.

        Args:
            name: Name of the topic, as the device writes it. It is empty for several topics.
            value: A word, or the numbers, strings, lists and dictionaries of JSON.
            kind: The type, if the device names it.
            is_latched: Whether the last message is kept for later subscriptions.
        """
        if isinstance(value, dict) and kind is None and (not name or self.type_of(name) is None):
            for key, inner in value.items():
                if inner is not None:
                    self.publish(f"{name}/{key}" if name else key, inner, is_latched=is_latched)
            return
        if not isinstance(value, (Word, list, dict)):
            value = json_word(value)
        try:
            self._publish(name, value, kind, is_latched=is_latched)
        except UnreadableError as error:
            self._lose(name, value, error)
        else:
            self._tally.published += 1

    def _lose(self, name: str, value: Any, error: UnreadableError) -> None:
        fitting = None if isinstance(value, dict) else type_of_value(value)
        short = fitting.name.rpartition("/")[2] if fitting else "TYPE"
        hint = error.hint or f"--type {name}:{short} chooses another type"
        example = f"{value}; {error.detail}" if error.detail else str(value)
        self._tally.lose(f"{error.reason}, on {name}", example, hint)

    def _publish(self, name: str, value: Any, kind: TopicType | None, *, is_latched: bool) -> None:
        topic = self._topics.get(name)
        if topic is None or (is_latched and not topic.is_latched):
            topic = self._open(name, value, kind or self.type_of(name), is_latched=is_latched)
        if kind is not None and kind.name != topic.maker.kind.name:
            raise UnreadableError(f"the type is {topic.maker.kind}, not {kind}")
        topic.publisher.publish(topic.maker.make(value))

    def _open(self, name: str, value: Any, kind: TopicType | None, *, is_latched: bool) -> _Topic:
        kind = kind or type_of_value(value)
        if kind is None:
            raise UnreadableError("no type fits the value", hint="choose a type with --type")
        maker = MessageMaker(kind, lambda: self._node.get_clock().now().to_msg())
        maker.make(value)  # raises an error before the topic exists
        if len(self._topics) >= _MOST_TOPICS:
            raise UnreadableError(f"there are {_MOST_TOPICS} topics already")
        full = self._full_name(name)
        if self._is_taken(full):
            raise UnreadableError("this topic goes the other way")
        self.forget(name)
        durability = DurabilityPolicy.TRANSIENT_LOCAL if is_latched else DurabilityPolicy.VOLATILE
        profile = QoSProfile(depth=1 if is_latched else _DEPTH, durability=durability)
        publisher = self._node.create_publisher(maker.kind.message_type, full, profile)
        self._topics[name] = topic = _Topic(publisher, maker, is_latched=is_latched)
        self.names |= {publisher.topic_name}
        self._node.get_logger().info(f"new topic {publisher.topic_name} ({kind})")
        return topic

    def _full_name(self, name: str) -> str:
        try:
            full = self._node.resolve_topic_name(topic_name(name))
            validate_full_topic_name(full)
        except InvalidNameError as error:
            raise UnreadableError("a topic cannot have this name") from error
        return full

    def forget(self, name: str) -> None:
        """Destroy the publisher of a topic, so that a latched message is kept no longer."""
        topic = self._topics.pop(name, None)
        if topic is not None:
            self.names -= {topic.publisher.topic_name}
            self._node.destroy_publisher(topic.publisher)
