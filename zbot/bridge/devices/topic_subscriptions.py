"""Subscriptions to the topics whose messages a device gets."""

from __future__ import annotations

import re
from dataclasses import dataclass
from fnmatch import fnmatchcase
from typing import TYPE_CHECKING, Any

from zbot.bridge.devices.errors import DeviceError
from zbot.bridge.devices.topic_type import TopicType, only_field
from zbot.errors import ZbotError
from zbot.names import is_hidden
from zbot.node.event_callbacks import SubscriptionEventCallbacks
from zbot.qos import DurabilityPolicy
from zbot.remote.profiles import profile_to_record
from zbot.remote.types import interface

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Iterator

    from zbot.bridge.devices.tally import Tally
    from zbot.graph.snapshot import Snapshot
    from zbot.node.node import Node
    from zbot.node.subscription import Subscription
    from zbot.qos import QoSProfile

_FOLLOW_S = 0.3
_DEPTH = 5000
_WANTED = re.compile(r"(?P<topic>[^:=\s]+)(?::(?P<type>[^=\s]+))?(?:=(?P<address>\S+))?\Z")
#: Topics that every node has.
_NODE_TOPICS = frozenset({"/rosout", "/parameter_events"})


@dataclass(frozen=True)
class Wanted:
    """What the user wants to send to a device."""

    pattern: str  #: full name of a topic, or a pattern
    kind: TopicType | None = None  #: `None`: the type of the topic's publishers
    address: str = ""  #: name in the device; empty: the name of the topic without the first `/`

    @classmethod
    def parse(cls, text: str) -> Wanted:
        """Return what a text such as `/led:std_msgs/msg/Bool=cmnd/lamp/POWER` wants.

        Raises:
            DeviceError: The text is not valid, or there is no such type.
        """
        match = _WANTED.match(text)
        if match is None:
            raise DeviceError(f"{text!r} is not a topic: write for example /led:std_msgs/msg/Bool")
        topic = match["topic"] if match["topic"][0] in "/*" else f"/{match['topic']}"
        kind = TopicType.parse(match["type"]) if match["type"] else None
        if match["address"] and "*" in topic:
            raise DeviceError(f"{text!r}: only the name of one topic can have a name after '='")
        return cls(topic, kind, match["address"] or "")

    @property
    def is_pattern(self) -> bool:
        """Whether this selects the topics of the graph."""
        return any(character in self.pattern for character in "*?[")

    def selects(self, topic: str) -> bool:
        """Return whether this wants a topic."""
        return fnmatchcase(topic, self.pattern)


@dataclass(frozen=True)
class Received:
    """A message for the device."""

    address: str
    message: Any
    field: str  #: path of the field to send, or empty
    is_latched: bool  #: whether the publishers keep the message for later subscriptions


class TopicSubscriptions:
    """Subscriptions that follow the publishers of the wanted topics.

    The node's executor calls `send`.

    Args:
        node: The node that subscribes.
        wanted: The topics.
        send: Called with each message.
        own: Returns the topics that come from the device. They are not sent back.
        tally: The counts of the device.
    """

    def __init__(
        self,
        node: Node,
        wanted: Iterable[Wanted],
        send: Callable[[Received], object],
        own: Callable[[], frozenset[str]],
        tally: Tally,
    ) -> None:
        self._node, self._send, self._own = node, send, own
        self._wanted, self._tally = tuple(wanted), tally
        self._refused: set[str] = set()
        self._seen: Snapshot | None = None
        self._open: dict[str, tuple[object, Subscription[Any]]] = {}
        if self._wanted:
            self._follow()
            node.create_timer(_FOLLOW_S, self._follow)

    def takes(self, topic: str) -> bool:
        """Return whether the messages of a topic go to the device."""
        return topic in self._open or any(
            not wanted.is_pattern and self._node.resolve_topic_name(wanted.pattern) == topic
            for wanted in self._wanted
        )

    def _follow(self) -> None:
        graph = self._node.context.graph.snapshot()
        if graph is self._seen:
            return
        self._seen, own = graph, self._own()
        for topic, wanted in self._selected(graph):
            if topic in own or topic in self._refused:
                continue
            try:
                self._subscribe(topic, wanted, graph)
            except ZbotError as error:  # the definition of the type is nowhere
                self._refused.add(topic)
                self._node.get_logger().error(f"cannot send {topic}: {error}")

    def _selected(self, graph: Snapshot) -> Iterator[tuple[str, Wanted]]:
        for wanted in self._wanted:
            if not wanted.is_pattern:
                yield self._node.resolve_topic_name(wanted.pattern), wanted
                continue
            for topic, _ in graph.topics():
                hidden = is_hidden(topic) or topic in _NODE_TOPICS
                if wanted.selects(topic) and not hidden and graph.publishers(topic):
                    yield topic, wanted

    def _subscribe(self, topic: str, wanted: Wanted, graph: Snapshot) -> None:
        """Subscribe, or subscribe again if the publishers have another profile or type."""
        publishers = graph.publishers(topic)
        kind = wanted.kind or (TopicType(publishers[0].type_name) if publishers else None)
        if kind is None:
            return
        profile = profile_to_record([publisher.qos for publisher in publishers], _DEPTH)
        key = (kind.name, profile.reliability, profile.durability)
        before = self._open.get(topic)
        if before is not None:
            if before[0] == key or not publishers:
                return
            self._node.destroy_subscription(before[1])
        self._open[topic] = key, self._new(topic, kind, wanted, profile)

    def _new(
        self, topic: str, kind: TopicType, wanted: Wanted, profile: QoSProfile
    ) -> Subscription[Any]:
        message_type = interface(self._node.context, kind.name)
        kind = kind if kind.field else TopicType(kind.name, only_field(message_type))
        is_latched = profile.durability is DurabilityPolicy.TRANSIENT_LOCAL
        address = wanted.address or topic.lstrip("/")

        def receive(message: Any) -> None:
            self._send(Received(address, message, kind.field, is_latched))

        if topic not in self._open:
            self._node.get_logger().info(f"sending {topic} ({kind}) as {address}")

        def lose(event: Any) -> None:
            self._tally.lose(f"{topic} is too fast", count=event.total_count_change)

        events = SubscriptionEventCallbacks(message_lost=lose)
        return self._node.create_subscription(
            message_type, topic, receive, profile, event_callbacks=events
        )
