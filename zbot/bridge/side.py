"""Side of a bridge: the interface through which the route manager uses zbot and ROS 2."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Literal, Protocol

from zbot.interfaces import has_sequences
from zbot.qos import QoSProfile
from zbot.wire.qos import qos_text

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping

    from zbot.bridge.errors import CallError
    from zbot.wire.tokens import EntityKind

#: First part of the name of a bridge's node. The rest is the bridge's id.
NODE_PREFIX = "_zbot_bridge_"
#: depth of a QoS profile if the other side does not report its depth
DEPTH = 10
# Number of messages that can wait while the bridge is busy. The depth in a node's profile may be
# too small, because the bridge must not lose messages. A message with sequences may be large, so
# fewer such messages can wait.
_QUEUE = 1000
_QUEUE_OF_SEQUENCES = 100

Format = Literal["cdr", "messagepack"]


@dataclass(frozen=True)
class End:
    """Publisher, subscription, server or client of a node."""

    kind: EntityKind
    node: str  #: full name of its node
    name: str  #: full name of the topic or service
    type_name: str
    type_hash: str = field(default="", compare=False)  #: empty if unknown
    qos: QoSProfile = field(default_factory=lambda: QoSProfile(depth=DEPTH), compare=False)
    qos_key: str = ""  #: makes endpoints with different profiles unequal

    def __post_init__(self) -> None:
        if not self.qos_key:
            object.__setattr__(self, "qos_key", qos_text(self.qos))


@dataclass(frozen=True)
class World:
    """Nodes and endpoints of a side, at one moment."""

    nodes: frozenset[str] = frozenset()  #: full names of nodes, except for those of bridges
    ends: frozenset[End] = frozenset()  #: endpoints of these nodes
    #: for each other bridge, by its id: the kinds and names that it offers on this side
    bridges: Mapping[str, frozenset[tuple[EntityKind, str]]] = field(default_factory=dict)


class Entity(Protocol):
    """Endpoint that a bridge has on a side."""

    def close(self) -> None:
        """Remove the endpoint."""
        ...


class Sender(Entity, Protocol):
    """Publisher of bytes."""

    @property
    def is_heard(self) -> bool:
        """Whether a message would have a receiver, now or later."""
        ...

    def send(self, data: bytes) -> None:
        """Publish a message. Any thread may call this."""
        ...


class Answer(Protocol):
    """Answer to a request. One of the methods is called once, in any thread."""

    def reply(self, data: bytes) -> None:
        """Send the response."""
        ...

    def fail(self, error: CallError) -> None:
        """Tell the client that the call failed, if the side can tell it."""
        ...


class Caller(Entity, Protocol):
    """Client of a service."""

    def call(self, request: bytes, answer: Answer) -> None:
        """Send a request. The answer gets the response or an error. Any thread may call this."""
        ...


class Side(Protocol):
    """zbot or ROS 2, as the route manager uses it. The route manager's thread calls the methods."""

    label: str  #: name of the side in messages for users: `zbot` or `ROS 2`
    format: Format  #: format of messages as bytes

    def world(self) -> World:
        """Return the present nodes and endpoints, without those that bridges have made."""
        ...

    def watch(self, changed: Callable[[], None]) -> None:
        """Call a function after each change of `world()`, in any thread."""
        ...

    def lack(self, type_name: str) -> str:
        """Return why this side cannot have messages of a type, or "" if it can."""
        ...

    def receiver(
        self, name: str, type_name: str, qos: QoSProfile, receive: Callable[[bytes], None]
    ) -> Entity:
        """Subscribe to a topic. Messages that a bridge published are left out."""
        ...

    def sender(self, name: str, type_name: str, qos: QoSProfile) -> Sender:
        """Return a publisher of a topic."""
        ...

    def server(
        self, name: str, type_name: str, node: str, serve: Callable[[bytes, Answer], None]
    ) -> Entity:
        """Offer a service. `node` is the node on the other side that has the service."""
        ...

    def caller(self, name: str, type_name: str) -> Caller:
        """Return a client of a service."""
        ...

    def show(self, nodes: frozenset[str], ends: frozenset[End]) -> None:
        """Show exactly these nodes and endpoints of the other side in this side's graph.

        An endpoint without a node belongs to the bridge's own node.
        """
        ...

    def close(self) -> None:
        """Leave zbot or ROS 2."""
        ...


def queue_length(type_name: str) -> int:
    """Return how many messages of a type a bridge's subscription keeps."""
    return _QUEUE_OF_SEQUENCES if has_sequences(type_name) else _QUEUE
