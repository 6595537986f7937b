"""Ports of a simulator: Gazebo's own topics, and their connections with topics of ROS.

In Gazebo, sensors and plugins use topics of Gazebo's own transport. A program of ROS sees such a
topic only if a bridge connects it with a topic of ROS.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from zbot.errors import ZbotError
from zbot.interfaces.registry import get_message
from zbot.qos import DurabilityPolicy, QoSProfile
from zbot.simulation.errors import SimulationError
from zbot.simulation.gazebo.names import TRANSPORT
from zbot.text.json_reader import JsonError, read_json

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable

    from zbot.node.node import Node

#: Topic on which bridges publish the connections that they want, as JSON.
CONNECTIONS_TOPIC = "/simulation/connections"
TO_ROS, TO_GAZEBO, BOTH = "to_ros", "to_gazebo", "both"
_MOST_CONNECTIONS = 1000
_DEPTH = 10
#: Profile of /tf_static, whose listeners hear only publishers that keep their messages.
_KEPT = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
#: Topics that the simulator publishes in any case.
_OWN = frozenset({"/clock"})


@dataclass(frozen=True)
class Connection:
    """Connection of a topic of Gazebo with a topic of ROS."""

    gazebo: str  #: the topic of Gazebo, e.g. `/scan`
    ros: str  #: the topic of ROS
    type_name: str = ""  #: its type in ROS, or an empty text for that of the port
    direction: str = BOTH


def read_connections(text: str) -> list[Connection]:
    """Return the connections in the JSON text that a bridge publishes.

    Raises:
        SimulationError: The text is not valid.
    """
    try:
        rows = read_json(text)
    except JsonError as error:
        raise SimulationError(f"the connections are not valid: {error}") from error
    if not isinstance(rows, list) or len(rows) > _MOST_CONNECTIONS:
        raise SimulationError(f"the connections are not a list of at most {_MOST_CONNECTIONS}")
    found = []
    for row in rows:
        if not isinstance(row, list) or [type(value) for value in row] != [str] * 4:
            raise SimulationError("a connection must be a list of four texts")
        if row[3] not in {TO_ROS, TO_GAZEBO, BOTH}:
            raise SimulationError(f"a direction must be {TO_ROS}, {TO_GAZEBO} or {BOTH}")
        found.append(Connection(*row))
    return found


class Port:
    """Topic of Gazebo, with its topics of ROS."""

    def __init__(self, node: Node, type_: type[Any], topic: str) -> None:
        self.node, self.type, self.topic = node, type_, topic
        self.msg_type = type_
        self.connected: dict[str, Any] = {}  #: publishers or subscriptions by topic of ROS

    def connect(self, connection: Connection) -> None:
        """Connect it with a topic of ROS, if the direction and the type fit."""
        raise NotImplementedError

    def disconnect(self, wanted: Iterable[str] = ()) -> None:
        """Remove all connections, except for these topics of ROS."""
        for topic in self.connected.keys() - set(wanted):
            self.destroy(self.connected.pop(topic))

    def destroy(self, entity: Any) -> None:
        """Destroy a publisher or a subscription."""
        raise NotImplementedError


class OutPort(Port):
    """Topic that the simulator publishes. It has the methods of a publisher."""

    def connect(self, connection: Connection) -> None:
        """Publish on a topic of ROS, too."""
        own = f"{self.type.__module__.partition('.')[0]}/msg/{self.type.__name__}"
        is_same = connection.type_name in {"", own}
        if connection.direction == TO_GAZEBO or connection.ros in self.connected | _OWN_TOPICS:
            return
        if not is_same:
            self.node.get_logger().warning(
                f"{connection.ros} has the type {own}, not {connection.type_name}: it is not "
                "connected"
            )
            return
        is_kept = connection.ros.endswith("/tf_static")
        made = self.node.create_publisher(self.type, connection.ros, _KEPT if is_kept else _DEPTH)
        self.connected[connection.ros] = made

    def destroy(self, entity: Any) -> None:
        """Destroy a publisher."""
        self.node.destroy_publisher(entity)

    @property
    def is_heard(self) -> bool:
        """Whether a program listens."""
        return any(publisher.is_heard for publisher in self.connected.values())

    def publish(self, message: Any) -> None:
        """Publish on all connected topics of ROS."""
        for publisher in self.connected.values():
            publisher.publish(message)


class InPort(Port):
    """Topic that the simulator follows."""

    def __init__(
        self, node: Node, type_: type[Any], topic: str, callback: Callable[[Any], object]
    ) -> None:
        super().__init__(node, type_, topic)
        self._callback = callback

    def connect(self, connection: Connection) -> None:
        """Follow a topic of ROS."""
        if connection.direction == TO_ROS or connection.ros in self.connected:
            return
        type_ = self.type
        if connection.type_name:
            try:
                type_ = get_message(connection.type_name)
            except ZbotError as error:
                self.node.get_logger().warning(str(error))
                return
        made = self.node.create_subscription(type_, connection.ros, self._take, _DEPTH)
        self.connected[connection.ros] = made

    def destroy(self, entity: Any) -> None:
        """Destroy a subscription."""
        self.node.destroy_subscription(entity)

    def _take(self, message: Any) -> None:
        if isinstance(message, self.type):
            self._callback(message)
        elif isinstance(getattr(message, "twist", None), self.type):  # a TwistStamped
            self._callback(message.twist)
        else:
            name = type(message).__name__
            text = f"{self.topic} cannot use messages of the type {name}"
            self.node.get_logger().warning(text, once=True)


_OWN_TOPICS = dict.fromkeys(_OWN)


class Ports:
    """Ports of all robots in a simulator. Robots use it like a node.

    Args:
        node: The simulator.
        is_open: Whether each topic of Gazebo also is a topic of ROS with the same name, without a
            bridge.
    """

    def __init__(self, node: Node, *, is_open: bool = False) -> None:
        self._node, self._is_open = node, is_open
        self._ports: list[Port] = []
        self._wanted: dict[str, list[Connection]] = {}  # by bridge

    @property
    def context(self) -> Any:
        """The context of the simulator."""
        return self._node.context

    def get_logger(self) -> Any:
        """Return the logger of the simulator."""
        return self._node.get_logger()

    def create_publisher(self, type_: type[Any], topic: str, qos: Any) -> Any:
        """Create a publisher of ROS, or a port for a topic of Gazebo."""
        gazebo = _gazebo_topic(topic)
        if gazebo is None:
            # As in Gazebo: programs that want every message hear sensors, too.
            depth = qos if isinstance(qos, int) else max(qos.depth, _DEPTH)
            return self._node.create_publisher(type_, topic, depth)
        return self._add(OutPort(self._node, type_, gazebo))

    def create_subscription(
        self, type_: type[Any], topic: str, callback: Callable[[Any], object], qos: Any
    ) -> Any:
        """Create a subscription of ROS, or a port for a topic of Gazebo."""
        gazebo = _gazebo_topic(topic)
        if gazebo is None:
            return self._node.create_subscription(type_, topic, callback, qos)
        return self._add(InPort(self._node, type_, gazebo, callback))

    def destroy_publisher(self, publisher: Any) -> None:
        """Destroy a publisher or a port."""
        self._destroy(publisher, self._node.destroy_publisher)

    def destroy_subscription(self, subscription: Any) -> None:
        """Destroy a subscription or a port."""
        self._destroy(subscription, self._node.destroy_subscription)

    def _destroy(self, entity: Any, destroy: Callable[[Any], object]) -> None:
        if isinstance(entity, Port):
            self._ports.remove(entity)
            entity.disconnect()
        else:
            destroy(entity)

    def _add(self, port: Port) -> Port:
        self._ports.append(port)
        self._connect(port)
        return port

    def want(self, bridge: str, connections: list[Connection]) -> None:
        """Use the connections of a bridge: its node, a blank, and a number of its own."""
        self._wanted[bridge] = connections
        self._connect_all()

    def keep_only(self, bridges: Iterable[str]) -> None:
        """Remove the connections of bridges that have ended. The names are those of their nodes."""
        running = set(bridges)
        ended = [key for key in self._wanted if key.partition(" ")[0] not in running]
        for name in ended:
            del self._wanted[name]
        if ended:
            self._connect_all()

    def _connect_all(self) -> None:
        for port in self._ports:
            self._connect(port)

    def _connect(self, port: Port) -> None:
        rows = [Connection(port.topic, port.topic)] if self._is_open else []
        rows += [row for found in self._wanted.values() for row in found]
        fitting = [row for row in rows if row.gazebo == port.topic]
        port.disconnect(row.ros for row in fitting)
        for row in fitting:
            port.connect(row)


def _gazebo_topic(topic: str) -> str | None:
    """Return the topic of Gazebo, or None for a topic of ROS."""
    _, found, rest = topic.partition(TRANSPORT)
    return f"/{rest.strip('/')}" if found else None
