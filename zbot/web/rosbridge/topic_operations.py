"""Operations on topics: advertise, unadvertise, publish, subscribe and unsubscribe."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from zbot.interfaces import type_name
from zbot.interfaces.plain_value import json_value
from zbot.observer.serving.client_budget import MAX_PUBLISHED, MAX_SUBSCRIBED
from zbot.observer.watch import QUEUE_DEPTH, subscribe_to_payloads
from zbot.qos import DurabilityPolicy, QoSProfile
from zbot.remote.profiles import profile_to_show
from zbot.web.rosbridge.client_message import RosbridgeError
from zbot.web.rosbridge.frame import COMPRESSIONS, cbor_value, dump, frames
from zbot.web.rosbridge.json_message import message_from_json
from zbot.web.rosbridge.outbox import TopicQueue
from zbot.wire.errors import CodecError
from zbot.wire.serialization import serialize_message

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.node.message_info import MessageInfo
    from zbot.observer.shared_entities import EntityReference
    from zbot.web.rosbridge.client_message import ClientMessage
    from zbot.web.rosbridge.frame import Frame
    from zbot.web.rosbridge.session import Session

_MAX_IDS = 100
_MAX_QUEUE = 1000


@dataclass(frozen=True)
class _Options:
    throttle_s: float
    queue_length: int
    fragment_size: int | None
    compression: str


class TopicOperations:
    """Publishers and subscriptions of one client.

    Args:
        session: The client's session.

    Attributes:
        operations: The operations by name.
    """

    def __init__(self, session: Session) -> None:
        self._session = session
        self._publishers: dict[str, EntityReference[Any]] = {}
        self._subscriptions: dict[str, _Subscription] = {}
        self.operations: dict[str, Callable[[ClientMessage], None]] = {
            "advertise": self._advertise,
            "unadvertise": self._unadvertise,
            "publish": self._publish,
            "subscribe": self._subscribe,
            "unsubscribe": self._unsubscribe,
        }

    def close(self) -> None:
        """Destroy the client's publishers and subscriptions."""
        for publisher in self._publishers.values():
            publisher.release()
        for subscription in self._subscriptions.values():
            subscription.close()

    def _advertise(self, message: ClientMessage) -> None:
        self._session.require_writable("publishing")
        bridge = self._session.bridge
        topic = bridge.node.resolve_topic_name(message.word("topic"))
        message_type = self._session.interface("msg", message.word("type"))
        self._check_type(topic, message_type)
        depth = int(message.number("queue_size", 100, most=_MAX_QUEUE)) or 1
        self._open_publisher(topic, message_type, depth, is_latched=message.flag("latch"))
        self._session.report("info", f"{topic} is advertised", message)

    def _open_publisher(
        self, topic: str, message_type: Any, depth: int, *, is_latched: bool
    ) -> Any:
        known = self._publishers.get(topic)
        if known is not None:
            if known.entity.msg_type is not message_type:
                raise RosbridgeError(f"you have advertised {topic} with another type")
            return known.entity
        if len(self._publishers) >= MAX_PUBLISHED:
            raise RosbridgeError(f"a client can publish on {MAX_PUBLISHED} topics")
        durability = DurabilityPolicy.TRANSIENT_LOCAL if is_latched else DurabilityPolicy.VOLATILE
        profile = QoSProfile(depth=depth, durability=durability)
        node = self._session.bridge.node
        reference = self._session.bridge.shared.get(
            ("publisher", topic, type_name(message_type), is_latched),
            lambda: node.create_publisher(message_type, topic, profile),
            node.destroy_publisher,
        )
        self._publishers[topic] = reference
        return reference.entity

    def _check_type(self, topic: str, message_type: Any) -> None:
        """Raise `RosbridgeError` if nodes use the topic, but only with other types."""
        types = dict(self._session.bridge.graph().topics()).get(topic, [])
        name = type_name(message_type)
        if types and name not in types:
            raise RosbridgeError(f"{topic} has the type {', '.join(types)}, not {name}")

    def _unadvertise(self, message: ClientMessage) -> None:
        topic = self._session.bridge.node.resolve_topic_name(message.word("topic"))
        publisher = self._publishers.pop(topic, None)
        if publisher is None:
            self._session.report("warning", f"you have not advertised {topic}", message)
        else:
            publisher.release()

    def _publish(self, message: ClientMessage) -> None:
        self._session.require_writable("publishing")
        bridge = self._session.bridge
        topic = bridge.node.resolve_topic_name(message.word("topic"))
        reference = self._publishers.get(topic)
        publisher = self._from_graph(topic) if reference is None else reference.entity
        value = {} if message.get("msg") is None else message.get("msg")
        publisher.publish(message_from_json(publisher.msg_type, value, bridge.now, message.size))

    def _from_graph(self, topic: str) -> Any:
        types = dict(self._session.bridge.graph().topics()).get(topic, [])
        if len(types) != 1:
            raise RosbridgeError(f"the type of {topic} is not known: advertise it first")
        message_type = self._session.interface("msg", types[0])
        return self._open_publisher(topic, message_type, 100, is_latched=False)

    def _subscribe(self, message: ClientMessage) -> None:
        options = _read_options(message)
        name = message.word("topic")
        bridge = self._session.bridge
        topic = bridge.node.resolve_topic_name(name)
        given = message.word("type", "")
        types = [given] if given else dict(bridge.graph().topics()).get(topic, [])
        if not types:
            raise RosbridgeError(f"nobody uses {topic}: give its type with 'type'")
        message_type = self._session.interface("msg", types[0])
        self._check_type(topic, message_type)
        known = self._subscriptions.get(name)
        if known is None:
            if len(self._subscriptions) >= MAX_SUBSCRIBED:
                raise RosbridgeError(f"a client can subscribe to {MAX_SUBSCRIBED} topics")
            known = _Subscription(self._session, name, topic, message_type)
            known.set(message.id, options)
            known.open()
            self._subscriptions[name] = known
        elif known.message_type is not message_type:
            raise RosbridgeError(f"you have subscribed to {topic} with another type")
        else:
            known.set(message.id, options)

    def _unsubscribe(self, message: ClientMessage) -> None:
        name = message.word("topic")
        subscription = self._subscriptions.get(name)
        if subscription is None:
            self._session.report("warning", f"you have not subscribed to {name}", message)
        elif not subscription.forget(message.id):
            self._subscriptions.pop(name).close()


def _read_options(message: ClientMessage) -> _Options:
    compression = message.word("compression", "none")
    if compression not in COMPRESSIONS:
        raise RosbridgeError(
            f"the compression {compression!r} is not one of {', '.join(COMPRESSIONS)}"
        )
    return _Options(
        message.number("throttle_rate", 0) / 1000,
        min(int(message.number("queue_length", 0)), _MAX_QUEUE),
        int(message.number("fragment_size", 0)) or None,
        compression,
    )


class _Subscription:
    """Subscription of a client to a topic.

    Several parts of the client may subscribe to the same topic, each with its own id and options.
    """

    def __init__(self, session: Session, name: str, topic: str, message_type: Any) -> None:
        self.message_type = message_type
        self._session = session
        self._name = name  #: the name as the client wrote it; the client finds its callback by it
        self._topic = topic
        self._type_name = type_name(message_type)
        self._options: dict[Any, _Options] = {}
        self._queue = TopicQueue(self._encode)
        self._compression = "none"
        self._fragment_size: int | None = None
        self._reported = 0
        context = session.bridge.node.context
        self._decode = context.dialect.codec_for(message_type).decode
        self._entity: Any = None

    def open(self) -> None:
        node, graph = self._session.bridge.node, self._session.bridge.graph()
        self._session.outbox.add(self._queue)
        self._entity = subscribe_to_payloads(
            node,
            self.message_type,
            self._topic,
            self._put,
            profile_to_show([end.qos for end in graph.publishers(self._topic)], QUEUE_DEPTH),
        )

    def set(self, id_: Any, options: _Options) -> None:
        """Add or replace the options of one part of the client.

        All parts get messages at the highest rate that one of the parts wants.
        """
        if id_ not in self._options and len(self._options) >= _MAX_IDS:
            raise RosbridgeError(f"a client can subscribe to a topic {_MAX_IDS} times")
        self._options[id_] = options
        self._combine()

    def forget(self, id_: Any) -> bool:
        """Forget the options of one part, or of all parts if the id is None.

        Return whether options of other parts remain.
        """
        if id_ is None:
            self._options.clear()
        else:
            self._options.pop(id_, None)
        if self._options:
            self._combine()
        return bool(self._options)

    def _combine(self) -> None:
        options = self._options.values()
        self._queue.period_s = min(option.throttle_s for option in options)
        self._queue.queue_length = max(option.queue_length for option in options)
        sizes = [option.fragment_size for option in options if option.fragment_size is not None]
        self._fragment_size = min(sizes, default=None)
        # Use the most compact form that one part wants. All clients can read all forms.
        self._compression = max((option.compression for option in options), key=COMPRESSIONS.index)

    def _put(self, payload: bytes, _info: MessageInfo) -> None:
        self._session.outbox.put(self._queue, payload)

    def _encode(self, payload: bytes) -> list[Frame]:
        try:
            message = self._decode(payload)
        except CodecError as error:
            text = f"a message on {self._topic} cannot be read: {error}"
            return [dump({"op": "status", "level": "error", "msg": text})]
        fields = {"op": "publish", "topic": self._name, "msg": self._value(message)}
        self._report_dropped()
        return frames(fields, self._compression, self._fragment_size)

    def _value(self, message: Any) -> Any:
        if self._compression == "cbor":
            return cbor_value(message)
        if self._compression == "cbor-raw":
            now = self._session.bridge.now()
            octets = serialize_message(message)
            return {"secs": now.sec, "nsecs": now.nanosec, "bytes": octets}
        return json_value(message)

    def _report_dropped(self) -> None:
        dropped = self._queue.dropped
        # Report the first loss, and then each time the number has doubled. So a slow client gets
        # few reports.
        if dropped >= max(1, 2 * self._reported):
            self._reported = dropped
            text = f"{dropped} messages of {self._topic} were dropped, because their queue was full"
            self._session.report("warning", text)

    def close(self) -> None:
        """End the subscription."""
        self._session.outbox.remove(self._queue)
        node = self._session.bridge.node
        if self._entity is not None and node.context.ok():
            node.destroy_subscription(self._entity)
