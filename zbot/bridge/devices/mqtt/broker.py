"""Link between an MQTT broker and a domain: topics of the broker are topics of zbot, and back."""

from __future__ import annotations

import time
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from zbot.bridge.devices.errors import UnreadableError
from zbot.bridge.devices.message_maker import text_of
from zbot.bridge.devices.mqtt.client import BrokerClient
from zbot.bridge.devices.mqtt.payload import read_payload
from zbot.bridge.devices.tally import Tally
from zbot.bridge.devices.topic_publishers import TopicPublishers
from zbot.bridge.devices.topic_subscriptions import Received, TopicSubscriptions, Wanted
from zbot.bridge.devices.topic_type import TypeTable
from zbot.threads.deadline import Deadline

if TYPE_CHECKING:
    from zbot.bridge.devices.mqtt.address import BrokerAddress
    from zbot.bridge.devices.mqtt.client import Heard
    from zbot.node.node import Node

_REPORT_S = 10.0
_LOOK_S = 0.2
_BOOLS = ("OFF", "ON")


@dataclass(frozen=True)
class BrokerOptions:
    """What the user asks for."""

    filters: tuple[str, ...] = ()  #: MQTT filters of the broker's topics to publish, e.g. `home/#`
    to_broker: tuple[Wanted, ...] = ()  #: topics whose messages the broker gets
    types: TypeTable = field(default_factory=TypeTable)
    qos: int = 0  #: of messages to the broker, 0 to 2
    prefix: str = ""  #: namespace for the topics of the broker, e.g. `home`


class Broker:
    """A broker. `run` works until Ctrl-C or SIGTERM.

    Args:
        node: The node that stands for the broker.
        address: Where the broker is.
        options: What the user asks for.
    """

    def __init__(self, node: Node, address: BrokerAddress, options: BrokerOptions) -> None:
        self._node, self._options = node, options
        self.tally = Tally(node.get_logger(), "message")
        self._client: BrokerClient | None = None
        self._subscriptions: TopicSubscriptions | None = None
        self._sent_topics: set[str] = set()
        self._topics = TopicPublishers(node, options.types, self.tally, self._is_taken)
        self._client = BrokerClient(address, node.get_logger(), options.filters, self._hear)
        self._subscriptions = TopicSubscriptions(
            node, options.to_broker, self._send, lambda: self._topics.names, self.tally
        )
        node.get_logger().info(f"connected with the broker {address}")

    def run(self) -> None:
        """Pass messages on until Ctrl-C or SIGTERM."""
        assert self._client is not None
        report_time = Deadline(_REPORT_S)
        try:
            while self._node.context.ok():
                time.sleep(_LOOK_S)
                if report_time.is_over:
                    report_time = Deadline(_REPORT_S)
                    self.tally.report()
        finally:
            self._client.close()
            self._node.get_logger().info(self.tally.summary())

    def _is_taken(self, topic: str) -> bool:
        return self._subscriptions is not None and self._subscriptions.takes(topic)

    def _name(self, topic: str) -> str:
        return f"{self._options.prefix.strip('/')}/{topic.lstrip('/')}".lstrip("/")

    def _hear(self, message: Heard) -> None:
        """Publish a message of the broker, in paho-mqtt's thread."""
        if message.topic in self._sent_topics:
            return  # MQTT 3.1.1 brings the messages back to the one that has sent them
        self.tally.received += 1
        name = self._name(message.topic)
        if not message.payload:
            self._topics.forget(name)  # this is how MQTT deletes a retained message
            return
        try:
            value = read_payload(message.payload)
        except UnreadableError as error:
            self.tally.lose(error.reason, message.topic)
            return
        self._topics.publish(name, value, is_latched=bool(message.retain))

    def _send(self, received: Received) -> None:
        """Send a message to the broker, in the thread of the node."""
        assert self._client is not None
        payload = text_of(received.message, received.field, _BOOLS).encode()
        self._sent_topics.add(received.address)
        is_sent = self._client.publish(
            received.address, payload, self._options.qos, is_retained=received.is_latched
        )
        if is_sent:
            self.tally.sent += 1
        else:
            self.tally.lose("the broker is gone", received.address)
