"""Graph of ROS 2, which is read at intervals, because rclpy cannot wait for changes."""

from __future__ import annotations

import time
from typing import TYPE_CHECKING, Any

from zbot.bridge.side import DEPTH, NODE_PREFIX, End, World
from zbot.names import fully_qualified
from zbot.qos import (
    DurabilityPolicy,
    HistoryPolicy,
    LivelinessPolicy,
    QoSProfile,
    ReliabilityPolicy,
)
from zbot.time import Duration
from zbot.wire.tokens import EntityKind

if TYPE_CHECKING:
    from collections.abc import Iterator

# rclpy's name of a node whose name did not arrive yet
_UNKNOWN = "_NODE_NAME_UNKNOWN_"
# The ids of all publishers of a process begin with the same bytes: the id of the DDS participant.
_PARTICIPANT = slice(0, 12)
# Period of full reads. `_read_fingerprint` does not notice if an endpoint replaces another one.
_FULL_S = 2.0
_HASH_BEGIN = "RIHS01_"


class RclpyGraph:
    """Reader of the graph that a node of ROS 2's own rclpy sees. Only one thread may use it.

    Args:
        node: The bridge's node of ROS 2's own rclpy.
    """

    def __init__(self, node: Any) -> None:
        self._node = node
        self._fingerprint: object = None
        self._next_full_s = 0.0
        self._is_complete = False
        self.world = World()
        self._bridges: set[bytes] = set()  #: DDS participants of bridges, also of this bridge
        self._natives: set[bytes] = set()  #: other DDS participants

    def update(self) -> bool:
        """Read the graph if it may have changed. Return whether it has changed."""
        now_s, fingerprint = time.monotonic(), self._read_fingerprint()
        if fingerprint == self._fingerprint and self._is_complete and now_s < self._next_full_s:
            return False
        self._fingerprint, self._next_full_s = fingerprint, now_s + _FULL_S
        before, self.world = self.world, self._read()
        return self.world != before

    def _read_fingerprint(self) -> object:
        node = self._node
        topics = node.get_topic_names_and_types()
        count = node.handle
        counts = [
            (count.get_count_publishers(name), count.get_count_subscribers(name))
            for name, _ in topics
        ]
        services = node.get_service_names_and_types()
        return topics, counts, services, sorted(node.get_node_names_and_namespaces())

    def is_of_bridge(self, topic: str, gid: bytes) -> bool | None:
        """Return whether a bridge published a message, or `None` if the sender is not known yet."""
        participant = gid[_PARTICIPANT]
        if participant in self._natives:
            return False
        if participant in self._bridges:
            return True
        for info in self._node.get_publishers_info_by_topic(topic):
            self._note(info)
        if participant in self._bridges:
            return True
        return False if participant in self._natives else None

    def _note(self, info: Any) -> None:
        participant = bytes(info.endpoint_gid)[_PARTICIPANT]
        if info.node_name.startswith(NODE_PREFIX):
            self._bridges.add(participant)
        elif info.node_name != _UNKNOWN:
            self._natives.add(participant)

    def _read(self) -> World:
        self._is_complete = True
        ends = set(self._topic_ends())
        nodes, bridges = set(), set()
        for name, namespace in self._node.get_node_names_and_namespaces():
            if name.startswith(NODE_PREFIX):
                bridges.add(name.removeprefix(NODE_PREFIX))
            elif name == _UNKNOWN:
                self._is_complete = False
            else:
                nodes.add(fully_qualified(namespace, name))
                ends.update(self._service_ends(name, namespace))
        bridges.discard(self._node.get_name().removeprefix(NODE_PREFIX))
        return World(frozenset(nodes), frozenset(ends), {bridge: frozenset() for bridge in bridges})

    def _topic_ends(self) -> Iterator[End]:
        node = self._node
        for topic, _ in node.get_topic_names_and_types():
            for kind, infos in (
                (EntityKind.PUBLISHER, node.get_publishers_info_by_topic(topic)),
                (EntityKind.SUBSCRIPTION, node.get_subscriptions_info_by_topic(topic)),
            ):
                for info in infos:
                    if kind is EntityKind.PUBLISHER:
                        self._note(info)
                    if info.node_name == _UNKNOWN:
                        self._is_complete = False
                    elif not info.node_name.startswith(NODE_PREFIX):
                        yield _end(kind, topic, info)

    def _service_ends(self, name: str, namespace: str) -> Iterator[End]:
        node, full = self._node, fully_qualified(namespace, name)
        try:
            servers = node.get_service_names_and_types_by_node(name, namespace)
            clients = node.get_client_names_and_types_by_node(name, namespace)
        except Exception:  # noqa: BLE001 - rclpy's error has no public name; the node has just left
            self._is_complete = False
            return
        for kind, found in ((EntityKind.SERVICE, servers), (EntityKind.CLIENT, clients)):
            for service, types in found:
                yield End(kind, full, service, types[0])


def _end(kind: EntityKind, topic: str, info: Any) -> End:
    text = str(info.topic_type_hash) if info.topic_type_hash is not None else ""
    return End(
        kind,
        fully_qualified(info.node_namespace, info.node_name),
        topic,
        info.topic_type,
        # Older releases of ROS 2 send no hash, and rclpy then returns zeros.
        text if text.removeprefix(_HASH_BEGIN).strip("0") else "",
        to_zbot(info.qos_profile),
    )


def to_zbot(theirs: Any) -> QoSProfile:
    """Convert a profile of rclpy. DDS does not send the depth. A missing depth is `DEPTH`."""
    return QoSProfile(
        history=HistoryPolicy.KEEP_LAST,
        depth=theirs.depth or DEPTH,
        reliability=_policy(ReliabilityPolicy, theirs.reliability),
        durability=_policy(DurabilityPolicy, theirs.durability),
        deadline=_duration(theirs.deadline),
        lifespan=_duration(theirs.lifespan),
        liveliness=_policy(LivelinessPolicy, theirs.liveliness),
        liveliness_lease_duration=_duration(theirs.liveliness_lease_duration),
    )


def _policy(policy: Any, theirs: Any) -> Any:
    return policy[theirs.name] if theirs.name in policy.__members__ else policy.SYSTEM_DEFAULT


def _duration(theirs: Any) -> Duration:
    return Duration(nanoseconds=min(max(theirs.nanoseconds, 0), 2**63 - 1))


def to_genuine(rclpy_qos: Any, profile: QoSProfile) -> Any:
    """Convert a profile of zbot to a profile of rclpy."""
    return rclpy_qos.QoSProfile(
        depth=profile.depth,
        reliability=rclpy_qos.ReliabilityPolicy[profile.reliability.name],
        durability=rclpy_qos.DurabilityPolicy[profile.durability.name],
    )
