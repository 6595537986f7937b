"""Side of a bridge that is a zbot context. The context may also use the dialect of rmw_zenoh."""

from __future__ import annotations

from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING, Any

from zbot.bridge.bridge_graph import BRIDGE_ENCLAVE, bridge_of
from zbot.bridge.side import NODE_PREFIX, End, World
from zbot.bridge.zbot_entities import (
    BRIDGE_MARK,
    RawCaller,
    RawPublisher,
    RawServer,
    RawSubscription,
)
from zbot.interfaces import get_interface, type_hash
from zbot.names import split_fully_qualified
from zbot.qos import QoSProfile, qos_profile_services_default
from zbot.remote.types import TypeSearch, UnknownTypeError
from zbot.wire.rmw_zenoh import NO_HASH
from zbot.wire.tokens import EndpointToken, EntityKind, NodeToken

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.bridge.side import Answer, Format
    from zbot.graph.snapshot import Announcement, Token
    from zbot.node.node import Node


class ZbotSide:
    """A zbot context as a side of a bridge. The executor of `node` runs the callbacks.

    Args:
        node: The bridge's node. Its name is `NODE_PREFIX` and the bridge's id.
        label: Name of the side in messages for users.
        wire_format: Format of the bytes in the context's dialect.
        admits: Called with the topic or service and the sender's id of each message or request.
            Returns whether the message or request may pass. `None` lets everything pass.
    """

    def __init__(
        self,
        node: Node,
        *,
        label: str = "zbot",
        wire_format: Format = "messagepack",
        admits: Callable[[str, bytes], bool] | None = None,
    ) -> None:
        self.label = label
        self.format: Format = wire_format
        self._node = node
        self._context = node.context
        self._id = node.get_name().removeprefix(NODE_PREFIX)
        self._admits = admits
        self._changed: Callable[[], None] = lambda: None
        self._nodes: dict[str, tuple[NodeToken, Announcement]] = {}
        self._ends: dict[End, Announcement] = {}
        self._context.graph.watch()
        self._types = TypeSearch(node.context)
        self._context.graph.add_listener(self._on_change)

    def watch(self, changed: Callable[[], None]) -> None:
        """Call a function after each change, in a thread of Zenoh or of this process."""
        self._changed = changed

    def _on_change(self, token: Token, appeared: bool) -> None:
        del appeared
        if token.zid != self._context.zid:
            self._changed()

    def world(self) -> World:
        """Return the nodes and endpoints of the domain that no bridge has made."""
        nodes: set[str] = set()
        ends: set[End] = set()
        bridges: dict[str, set[tuple[EntityKind, str]]] = {}
        for token in self._context.graph.snapshot().tokens:
            if token.zid == self._context.zid:
                continue
            bridge = bridge_of(token)
            if bridge is not None:
                offers = bridges.setdefault(bridge, set())
                if isinstance(token, EndpointToken) and token.enclave.startswith(BRIDGE_ENCLAVE):
                    offers.add((token.kind, token.name))
            elif isinstance(token, NodeToken):
                nodes.add(token.full_node_name)
            else:
                ends.add(_end(token))
        known = {bridge: frozenset(offers) for bridge, offers in bridges.items()}
        return World(frozenset(nodes), frozenset(ends), known)

    def lack(self, type_name: str) -> str:
        """Return why zbot has no definition of a type. Ask the nodes of the domain first.

        This method asks again when there are other nodes, or when zbot has learned the type from
        the other side.
        """
        failure = self._types.search(type_name)
        if isinstance(failure, UnknownTypeError):
            return f"{self.label} has no definition of {type_name}"
        return "" if failure is None else str(failure)

    # -- entities --------------------------------------------------------------------------------

    def receiver(
        self, name: str, type_name: str, qos: QoSProfile, receive: Callable[[bytes], None]
    ) -> RawSubscription:
        """Subscribe to a topic. The subscription itself has no token in the graph."""
        cls = get_interface(type_name)
        admits = None if self._admits is None else partial(self._admits, name)
        return RawSubscription(
            self._node,
            cls,
            self._token("", EntityKind.SUBSCRIPTION, name, type_name, qos),
            partial(_receive, receive, admits),
        )

    def sender(self, name: str, type_name: str, qos: QoSProfile) -> RawPublisher:
        """Return a publisher of bytes. The publisher itself has no token in the graph."""
        token = self._token("", EntityKind.PUBLISHER, name, type_name, qos)
        return RawPublisher(self._node, get_interface(type_name), token)

    def server(
        self, name: str, type_name: str, node: str, serve: Callable[[bytes, Answer], None]
    ) -> RawServer:
        """Offer a service. The graph shows it as a service of `node`."""
        qos = qos_profile_services_default
        token = self._token(node, EntityKind.SERVICE, name, type_name, qos)
        admits = None if self._admits is None else partial(self._admits, name)
        return RawServer(self._node, get_interface(type_name), token, serve, admits)

    def caller(self, name: str, type_name: str) -> RawCaller:
        """Return a client of bytes."""
        qos = qos_profile_services_default
        token = self._token("", EntityKind.CLIENT, name, type_name, qos)
        return RawCaller(self._node, get_interface(type_name), token)

    # -- graph -----------------------------------------------------------------------------------

    def show(self, nodes: frozenset[str], ends: frozenset[End]) -> None:
        """Announce the nodes of the other side, and their endpoints."""
        for end in [known for known in self._ends if known not in ends]:
            self._ends.pop(end).undeclare()
        for name in [known for known in self._nodes if known not in nodes]:
            self._nodes.pop(name)[1].undeclare()
        graph = self._context.graph
        for name in nodes - self._nodes.keys():
            node = self._node_token(name)
            self._nodes[name] = node, graph.announce(node)
        for end in ends - self._ends.keys():
            token = self._token(end.node, end.kind, end.name, end.type_name, end.qos)
            self._ends[end] = graph.announce(token)

    def _node_token(self, name: str) -> NodeToken:
        namespace, base = split_fully_qualified(name)
        context = self._context
        token = NodeToken(
            domain=context.dialect.domain_of(context.get_domain_id(), name),
            zid=context.zid,
            nid=0,
            namespace=namespace,
            node=base,
            enclave=BRIDGE_ENCLAVE + self._id,
        )
        return context.dialect.with_key(context.graph.numbers.numbered(token))

    def _token(
        self, node: str, kind: EntityKind, name: str, type_name: str, qos: QoSProfile
    ) -> EndpointToken:
        """Return the token of an endpoint. `node` is a node of the other side, or empty."""
        own = self._nodes[node][0] if node in self._nodes else self._node.handle.token
        namespace, base = split_fully_qualified(node) if node else (own.namespace, own.node)
        enclave = BRIDGE_ENCLAVE + self._id
        owner = replace(own, namespace=namespace, node=base, enclave=enclave, key="")
        named_type = type_name, type_hash(type_name)
        return self._node.handle.named_endpoint(kind, name, named_type, qos, owner)

    def close(self) -> None:
        """Withdraw all announced nodes and endpoints."""
        self._context.graph.remove_listener(self._on_change)
        if not self._context.is_closed:
            self.show(frozenset(), frozenset())


def _end(token: EndpointToken) -> End:
    return End(
        token.kind,
        token.full_node_name,
        token.name,
        token.type_name,
        "" if token.type_hash == NO_HASH else token.type_hash,
        token.qos,
    )


def _receive(
    receive: Callable[[bytes], None],
    admits: Callable[[bytes], bool] | None,
    data: bytes,
    info: Any,
) -> None:
    gid = info["publisher_gid"]
    sender = b"" if gid is None else gid["data"]
    if sender.startswith(BRIDGE_MARK) or (admits is not None and not admits(sender)):
        return
    receive(data)
