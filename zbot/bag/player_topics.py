"""Topics of a playback: their publishers and message classes."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING, Any, Protocol

from zbot.bag.description import action_name, is_service_event, service_name
from zbot.bag.qos_profiles import profile_to_publish
from zbot.bag.service_requests import GoalPublisher, RequestPublisher
from zbot.errors import ZbotError
from zbot.interfaces import type_name
from zbot.threads.deadline import Deadline
from zbot.wire.errors import CodecError
from zbot.wire.payload import is_cdr
from zbot.wire.serialization import deserialize_message, serialize_message

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from zbot.bag.metadata import TopicMetadata
    from zbot.bag.options import PlayOptions
    from zbot.bag.reader import Reader
    from zbot.bag.selection import Selection
    from zbot.bag.service_requests import Goals
    from zbot.node.node import Node
    from zbot.wire.dialect import Dialect

CLOCK_TOPIC = "/clock"
_DISCOVERY_S = 0.5  #: longest wait for the discovery of servers that run already


class MessagePublisher(Protocol):
    """Publisher of a topic, or client that repeats the requests of recorded service events."""

    def publish(self, msg: Any, /) -> None:
        """Send a message."""


class PlayedTopic:
    """Topic that is played, with its publisher and the number of messages with errors."""

    def __init__(
        self, name: str, publisher: MessagePublisher, prepare: Callable[[bytes], Any]
    ) -> None:
        self.name = name  #: name in the domain
        self.publisher = publisher
        self.prepare = prepare  #: converts a message in CDR to what the publisher takes
        self.errors = 0  #: messages whose bytes do not fit the type


def played_topics(
    node: Node, bags: Sequence[Reader], options: PlayOptions
) -> dict[str, PlayedTopic]:
    """Create the publishers of a playback. A topic that cannot be played is left out.

    Returns:
        The topics by their names in the bags.
    """
    topics: dict[str, tuple[TopicMetadata, Reader]] = {}
    for bag in bags:
        for name, topic in bag.topics.items():
            topics.setdefault(name, (topic, bag))
    found = {}
    goals: Goals = {}
    selection = options.selection()
    for name, (topic, bag) in topics.items():
        if _is_wanted(topic, options, selection):
            played = _played(node, topic, bag, options, goals)
            if played is not None:
                found[name] = played
    deadline = Deadline(_DISCOVERY_S)
    for played_topic in found.values():
        if isinstance(played_topic.publisher, RequestPublisher):
            played_topic.publisher.wait_for_server(deadline.left_s)
    return found


def _is_wanted(topic: TopicMetadata, options: PlayOptions, selection: Selection) -> bool:
    if options.clock_publish_frequency > 0 and topic.name == CLOCK_TOPIC:
        return False  # the player publishes its own clock, not the recorded clock
    if options.send_actions_as_client and action_name(topic.name) and not _is_event(topic):
        return False  # the action's server publishes its feedback and its status itself
    return selection.takes(topic.name, topic.type_name)


def _is_event(topic: TopicMetadata) -> bool:
    return is_service_event(topic.name, topic.type_name)


def _played(
    node: Node, topic: TopicMetadata, bag: Reader, options: PlayOptions, goals: Goals
) -> PlayedTopic | None:
    try:
        message_class = bag.message_class(topic)
        publisher = _publisher(node, topic, message_class, options, goals)
    except ZbotError as error:
        node.get_logger().warning(f"Ignoring a topic '{topic.name}', reason: {error}.")
        return None
    prepare = partial(deserialize_message, message_type=message_class)
    if not isinstance(publisher, RequestPublisher):
        prepare = partial(_payload, node.context.dialect, message_class)
    # The first call generates code for the type, which takes milliseconds.
    prepare(serialize_message(message_class()))
    return PlayedTopic(options.remap(topic.name), publisher, prepare)


def _payload(dialect: Dialect, message_class: type[Any], data: bytes) -> bytes:
    if is_cdr(data):
        return dialect.payload_of(data, message_class)
    raise CodecError("decode", type_name(message_class), "", "the bytes are not CDR")


def _publisher(
    node: Node,
    topic: TopicMetadata,
    message_class: type[Any],
    options: PlayOptions,
    goals: Goals,
) -> MessagePublisher:
    name = options.remap(topic.name)
    if _is_event(topic):
        service, of_clients = service_name(name), options.requests_of_clients
        if options.send_actions_as_client and action_name(topic.name):
            return GoalPublisher(node, service, topic.type_name, goals, is_of_clients=of_clients)
        if options.publish_service_requests:
            return RequestPublisher(node, service, topic.type_name, is_of_clients=of_clients)
    profile = options.topic_qos_profile_overrides.get(topic.name)
    if profile is None:
        profile = profile_to_publish(topic.offered_qos_profiles)
    else:
        node.get_logger().info(f"Overriding QoS profile for topic {topic.name}")
    return node.create_publisher(message_class, name, profile)
