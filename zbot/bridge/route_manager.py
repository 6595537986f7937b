"""Manager of the routes between two sides, which are the routes of all topics and services.

A route carries a topic in one direction, or offers a service of one side on the other side. Bridges
ignore the endpoints that bridges have made. So a message crosses one bridge at most, and never
comes back. If two bridges link the same zbot domain and the same ROS 2 domain, the bridge with the
smaller id carries what both could carry.
"""

from __future__ import annotations

import threading
from collections import defaultdict
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

from zbot.bridge.profiles import mismatches, profiles
from zbot.bridge.routes import ServiceRoute, TopicRoute
from zbot.bridge.selection import Direction, Selection
from zbot.bridge.side import DEPTH, End, World, queue_length
from zbot.interfaces import get_interface, type_hash
from zbot.threads.deadline import Deadline
from zbot.wire.cdr.codec import cdr_codec_for
from zbot.wire.messagepack.codec import messagepack_codec_for
from zbot.wire.qos import qos_text
from zbot.wire.tokens import EntityKind
from zbot.wire.transcoder.transcoder import to_cdr, to_messagepack

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator

    from zbot.bridge.routes import Log
    from zbot.bridge.side import Side
    from zbot.qos import QoSProfile

#: Types of velocities. A message with only zeros stops a robot.
_VELOCITIES = frozenset({"geometry_msgs/msg/Twist", "geometry_msgs/msg/TwistStamped"})
_TOPIC_KINDS = (EntityKind.PUBLISHER, EntityKind.SUBSCRIPTION)
# Several changes often come together, e.g. when a node with ten endpoints starts.
_PAUSE_S = 0.02


@dataclass(frozen=True)
class _Topic:
    """A topic to carry in one direction. A change of a value needs a new route."""

    name: str  #: in ROS 2
    direction: Direction
    type_name: str
    qos_keys: tuple[str, str]


@dataclass(frozen=True)
class _Service:
    """A service to offer on the other side. A change of a value needs a new route."""

    name: str  #: in ROS 2
    direction: Direction
    type_name: str
    node: str  #: full name of the server's node, on the server's side


_Wanted = _Topic | _Service
_Found = dict[str, tuple[list[End], list[End]]]  #: by name, the endpoints of zbot and of ROS 2


class RouteManager:
    """Opens and closes the routes between zbot and ROS 2.

    `run` works until another thread calls `close`.

    Args:
        zbot: The side of zbot.
        ros: The side of ROS 2.
        selection: What is carried.
        bridge_id: The id of this bridge, which is a part of its nodes' names.
        prefix: Namespace in zbot for all names of ROS 2, e.g. `/robot1`, or empty.
        log: Gets lines about what cannot be carried.
        patience_s: In the first `patience_s` seconds, this bridge carries nothing that another
            bridge in zbot with a smaller id carries. After this time, only bridges that ROS 2's
            graph shows too have this effect, because they link the same two domains.
    """

    def __init__(
        self,
        zbot: Side,
        ros: Side,
        selection: Selection,
        *,
        bridge_id: str,
        prefix: str = "",
        log: Log,
        patience_s: float = 0.0,
    ) -> None:
        self._patience = Deadline(patience_s)
        self._zbot, self._ros = zbot, ros
        self._selection = selection
        self._id = bridge_id
        self._prefix = prefix.rstrip("/")
        self._log = log
        self._routes: dict[_Wanted, TopicRoute | ServiceRoute] = {}
        self._told: set[str] = set()
        self._changed = threading.Event()
        self._is_closed = False
        self._profiles: dict[_Topic, tuple[QoSProfile, QoSProfile]] = {}
        zbot.watch(self._changed.set)
        ros.watch(self._changed.set)

    def run(self) -> None:
        """Carry until `close`."""
        while not self._is_closed:
            self._changed.clear()
            self.update()
            self._changed.wait(None if self._patience.is_over else self._patience.left_s)
            if not self._is_closed:
                threading.Event().wait(_PAUSE_S)
        for route in self._routes.values():
            route.close()

    def close(self) -> None:
        """Let `run` close all routes and return."""
        self._is_closed = True
        self._changed.set()

    def halt(self) -> None:
        """Stop the robots: publish a zero velocity on each velocity topic that goes to ROS 2.

        A topic is left out if no message was carried since the last call. Any thread may call this.
        """
        for item, route in list(self._routes.items()):
            is_driven = isinstance(item, _Topic) and item.direction is Direction.OUT
            if is_driven and item.type_name in _VELOCITIES and isinstance(route, TopicRoute):
                cls = get_interface(item.type_name)
                codec = (
                    cdr_codec_for(cls) if self._ros.format == "cdr" else messagepack_codec_for(cls)
                )
                route.send_once(codec.encode(cls()))

    @property
    def carried(self) -> list[tuple[str, Direction]]:
        """The topics and services that are carried now, by their names in ROS 2."""
        return sorted((item.name, item.direction) for item in self._routes)

    def update(self) -> None:
        """Compare the routes with the endpoints on both sides, and open and close routes."""
        zbot, ros = self._in_ros(self._zbot.world()), self._ros.world()
        topics = _by_name(zbot, ros, _TOPIC_KINDS)
        wanted = {**self._topics(topics), **self._services(zbot, ros)}
        wanted = {item: ends for item, ends in wanted.items() if self._is_possible(item, ends)}
        taken = self._taken(zbot, ros)
        own = {item for item in wanted if _offer(item) not in taken}
        for item in [item for item in self._routes if item not in own]:
            self._routes.pop(item).close()
        for item in own - self._routes.keys():
            self._open(item)
        self._show(zbot, ros, own & self._routes.keys())
        self._tell_mismatches(topics, own)

    # -- names -----------------------------------------------------------------------------------

    def _zbot_name(self, ros_name: str) -> str:
        return self._prefix + ros_name

    def _in_ros(self, world: World) -> World:
        """Return the endpoints of zbot with their names in ROS 2, i.e. without the prefix.

        Names that do not begin with the prefix are left out.
        """
        prefix = self._prefix
        if not prefix:
            return world
        ends = (
            replace(end, name=end.name.removeprefix(prefix))
            for end in world.ends
            if end.name.startswith(f"{prefix}/")
        )
        bridges = {
            bridge: frozenset(
                (kind, name.removeprefix(prefix))
                for kind, name in offers
                if name.startswith(f"{prefix}/")
            )
            for bridge, offers in world.bridges.items()
        }
        return World(world.nodes, frozenset(ends), bridges)

    # -- what is to be carried -------------------------------------------------------------------

    def _topics(self, found: _Found) -> dict[_Wanted, list[End]]:
        wanted: dict[_Wanted, list[End]] = {}
        self._profiles.clear()
        for name, ends in found.items():
            types = {end.type_name for end in [*ends[0], *ends[1]]}
            if len(types) > 1:
                if self._is_taken_topic(name):
                    self._tell(f"{name} has several types ({', '.join(sorted(types))})")
                continue
            for direction in Direction:
                source, target = ends if direction is Direction.OUT else reversed(ends)
                publishers = _of(source, EntityKind.PUBLISHER)
                # A route to ROS 2 is opened as soon as ROS 2 has a subscription, because a program
                # in zbot may wait for a subscription before it publishes its first message.
                waiting = _of(target, EntityKind.SUBSCRIPTION)
                is_needed = publishers or (direction is Direction.OUT and waiting)
                if is_needed and self._selection.takes_topic(name, direction):
                    type_name = next(iter(types))
                    pair = self._pair(type_name, publishers, waiting)
                    keys = qos_text(pair[0]), qos_text(pair[1])
                    topic = _Topic(name, direction, type_name, keys)
                    self._profiles[topic] = pair
                    wanted[topic] = publishers + waiting
        return wanted

    def _pair(
        self, type_name: str, publishers: list[End], waiting: list[End]
    ) -> tuple[QoSProfile, QoSProfile]:
        is_known = not self._zbot.lack(type_name)
        queue = queue_length(type_name) if is_known else DEPTH
        return profiles([end.qos for end in publishers], [end.qos for end in waiting], queue)

    def _is_taken_topic(self, name: str) -> bool:
        return any(self._selection.takes_topic(name, direction) for direction in Direction)

    def _services(self, zbot: World, ros: World) -> dict[_Wanted, list[End]]:
        wanted: dict[_Wanted, list[End]] = {}
        for name, (ours, theirs) in _by_name(zbot, ros, (EntityKind.SERVICE,)).items():
            direction = Direction.IN if theirs else Direction.OUT
            server = min(theirs or ours, key=lambda end: end.node)
            if not self._selection.takes_service(name, server.type_name, direction):
                continue
            if ours and theirs:
                self._tell(f"the service {name} exists in zbot and in ROS 2, so each keeps its own")
                continue
            service = _Service(name, direction, server.type_name, server.node)
            wanted[service] = [*ours, *theirs]
        return wanted

    def _is_possible(self, wanted: _Wanted, ends: Iterable[End]) -> bool:
        """Return whether both sides have the same definition of a type. If not, log it once."""
        name = wanted.type_name
        for side in (self._ros, self._zbot):
            reason = side.lack(name)
            if reason:
                self._tell(f"{wanted.name} is not carried: {reason}")
                return False
        hashes = {end.type_hash for end in ends if end.type_hash}
        if hashes - {type_hash(name)}:
            self._tell(
                f"{wanted.name} is not carried: zbot and ROS 2 have different definitions of {name}"
            )
            return False
        return True

    def _taken(self, zbot: World, ros: World) -> set[tuple[EntityKind, str]]:
        """Return what bridges with smaller ids carry between the same two domains."""
        is_patient = not self._patience.is_over
        return {
            offer
            for bridge, offers in zbot.bridges.items()
            if bridge < self._id and (is_patient or bridge in ros.bridges)
            for offer in offers
        }

    # -- routes ----------------------------------------------------------------------------------

    def _open(self, wanted: _Wanted) -> None:
        """Open a route. If that fails, the next change of the graph is another chance."""
        try:
            self._routes[wanted] = (
                self._topic_route(wanted)
                if isinstance(wanted, _Topic)
                else self._service_route(wanted)
            )
        except Exception as error:  # noqa: BLE001 - the classes of rclpy's errors are private
            self._tell(f"{wanted.name} is not carried: {error}")

    def _sides(self, direction: Direction) -> tuple[Side, Side]:
        pair = self._zbot, self._ros
        return pair if direction is Direction.OUT else (pair[1], pair[0])

    def _names(self, name: str, direction: Direction) -> tuple[str, str]:
        pair = self._zbot_name(name), name
        return pair if direction is Direction.OUT else (pair[1], pair[0])

    def _topic_route(self, topic: _Topic) -> TopicRoute:
        sides = self._sides(topic.direction)
        return TopicRoute(
            (*self._names(topic.name, topic.direction), topic.type_name),
            sides,
            self._profiles[topic],
            convert=_converter(topic.type_name, *sides),
            hertz=self._selection.rate(topic.name, topic.direction),
            log=self._log,
        )

    def _service_route(self, service: _Service) -> ServiceRoute:
        sides = self._sides(service.direction)
        node = service.node
        return ServiceRoute(
            (*self._names(service.name, service.direction), service.type_name),
            sides,
            self._zbot_name(node) if service.direction is Direction.IN else node,
            request=_converter(f"{service.type_name}_Request", sides[1], sides[0]),
            response=_converter(f"{service.type_name}_Response", *sides),
        )

    # -- graph -----------------------------------------------------------------------------------

    def _show(self, zbot: World, ros: World, own: set[_Wanted]) -> None:
        """Show the nodes of each side, and their carried endpoints, on the other side."""
        for direction, source, target in (
            (Direction.IN, ros, self._zbot),
            (Direction.OUT, zbot, self._ros),
        ):
            is_second = any(
                bridge < self._id for bridge in zbot.bridges.keys() & ros.bridges.keys()
            )
            nodes = frozenset() if is_second else self._shown_nodes(source, direction)
            target.show(nodes, frozenset(self._shown(source, direction, own)))

    def _shown_nodes(self, source: World, direction: Direction) -> frozenset[str]:
        if direction is Direction.IN:
            return frozenset(map(self._zbot_name, source.nodes))
        return source.nodes

    def _shown(self, source: World, direction: Direction, own: set[_Wanted]) -> Iterator[End]:
        """Yield the endpoints of the source side that the graph of the target side shows.

        A publisher is shown if its topic is carried from the source to the target. A subscription
        or a client is shown if its topic or service is carried from the target to the source.
        """
        back = Direction.OUT if direction is Direction.IN else Direction.IN
        rename = self._in_zbot if direction is Direction.IN else _unchanged
        carried = {(item.name, isinstance(item, _Topic), item.direction) for item in own}
        for end in source.ends:
            # A server is left out, because the server of its route is in the target's graph.
            if end.kind is not EntityKind.SERVICE:
                way = direction if end.kind is _PUBLISHER else back
                if (end.name, end.kind in _TOPIC_KINDS, way) in carried:
                    yield rename(end)
        heard = {end.name for end in source.ends if end.kind is _SUBSCRIPTION}
        for item in own:
            if item.direction is back and (isinstance(item, _Service) or item.name not in heard):
                kind = _SUBSCRIPTION if isinstance(item, _Topic) else EntityKind.CLIENT
                yield rename(End(kind, "", item.name, item.type_name))

    def _in_zbot(self, end: End) -> End:
        node = self._zbot_name(end.node) if end.node else ""
        return replace(end, name=self._zbot_name(end.name), node=node)

    def _tell_mismatches(self, topics: _Found, own: Iterable[_Wanted]) -> None:
        for item in own:
            # In zbot, all QoS profiles are compatible.
            if isinstance(item, _Topic) and item.direction is Direction.OUT:
                ours, theirs = topics[item.name]
                for text in mismatches(_of(ours, _PUBLISHER), _of(theirs, _SUBSCRIPTION)):
                    self._tell(text)

    def _tell(self, text: str) -> None:
        if text not in self._told:
            self._told.add(text)
            self._log.warning(text)


_PUBLISHER, _SUBSCRIPTION = EntityKind.PUBLISHER, EntityKind.SUBSCRIPTION


def _by_name(zbot: World, ros: World, kinds: tuple[EntityKind, ...]) -> _Found:
    """Return the endpoints of some kinds by name."""
    found: _Found = defaultdict(lambda: ([], []))
    for index, world in enumerate((zbot, ros)):
        for end in world.ends:
            if end.kind in kinds:
                found[end.name][index].append(end)
    return found


def _unchanged(end: End) -> End:
    return end


def _of(ends: list[End], kind: EntityKind) -> list[End]:
    return [end for end in ends if end.kind is kind]


def _offer(wanted: _Wanted) -> tuple[EntityKind, str]:
    """Return the endpoint that the graph of zbot shows if a bridge carries `wanted`."""
    into = wanted.direction is Direction.IN
    if isinstance(wanted, _Topic):
        return (_PUBLISHER if into else _SUBSCRIPTION), wanted.name
    return (EntityKind.SERVICE if into else EntityKind.CLIENT), wanted.name


def _converter(type_name: str, source: Side, target: Side) -> Any:
    if source.format == target.format:
        return None
    cls = get_interface(type_name)
    return to_cdr(cls) if target.format == "cdr" else to_messagepack(cls)
