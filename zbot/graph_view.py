"""What a picture of the graph shows: nodes, topics, and which way messages go.

Pure: it is made of a snapshot, and whoever shows it decides how.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum
from typing import TYPE_CHECKING

from zbot.names import fully_qualified, is_hidden, nearest
from zbot.wire.tokens import EntityKind

if TYPE_CHECKING:
    from collections.abc import Iterator

    from zbot.graph import Snapshot

_DEBUG_TOPICS = frozenset({"/rosout", "/statistics"})
_TF_TOPICS = frozenset({"/tf", "/tf_static"})
_PARAMETER_TOPICS = frozenset({"/parameter_events"})


class Mode(str, Enum):
    """Which topics are boxes of their own (rqt_graph's three choices)."""

    NODES = "nodes"  #: none: arrows lead from node to node, labelled with their topics
    ACTIVE = "active"  #: those with publishers and subscriptions
    ALL = "all"  #: all


@dataclass(frozen=True)
class Filters:
    """What is left out."""

    debug: bool = True  #: /rosout and /statistics
    tf: bool = False  #: transforms
    params: bool = True  #: /parameter_events
    dead_sinks: bool = False  #: topics without subscriptions
    leaf_topics: bool = False  #: topics with a single connection
    hidden: bool = True  #: names with a part that begins with an underscore


@dataclass(frozen=True)
class TopicView:
    """A topic, and what looks wrong with it."""

    name: str
    types: tuple[str, ...]
    publishers: tuple[str, ...]  #: full names of nodes, sorted
    subscriptions: tuple[str, ...]  #: likewise
    guess: str | None  #: the published topic that was probably meant, if nobody publishes this one

    @property
    def has_clash(self) -> bool:
        """Whether its nodes use different types, and so cannot hear each other."""
        return len(self.types) > 1

    @property
    def is_active(self) -> bool:
        """Whether messages can go through it."""
        return bool(self.publishers and self.subscriptions)


@dataclass(frozen=True, order=True)
class Edge:
    """An arrow between names of nodes and topics; a label names the topic between two nodes."""

    start: str
    end: str
    label: str = ""
    is_publishing: bool = False  #: whether it leads from a node to a topic


@dataclass(frozen=True)
class GraphView:
    """What is drawn: everything sorted by name, so that equal graphs give equal pictures."""

    mode: Mode
    nodes: tuple[str, ...]
    topics: tuple[TopicView, ...]

    @property
    def boxes(self) -> tuple[TopicView, ...]:
        """The topics that are drawn as boxes."""
        if self.mode is Mode.NODES:
            return ()
        return tuple(one for one in self.topics if self.mode is Mode.ALL or one.is_active)

    @property
    def edges(self) -> tuple[Edge, ...]:
        """The arrows, each once."""
        found = self._direct_edges() if self.mode is Mode.NODES else self._box_edges()
        return tuple(sorted(set(found)))

    def _direct_edges(self) -> Iterator[Edge]:
        for topic in self.topics:
            for publisher in topic.publishers:
                for subscription in topic.subscriptions:
                    yield Edge(publisher, subscription, topic.name)

    def _box_edges(self) -> Iterator[Edge]:
        for topic in self.boxes:
            yield from (Edge(node, topic.name, is_publishing=True) for node in topic.publishers)
            yield from (Edge(topic.name, node) for node in topic.subscriptions)


def view(snapshot: Snapshot, mode: Mode = Mode.ALL, filters: Filters | None = None) -> GraphView:
    """Return what to draw of a snapshot."""
    filters = filters or Filters()
    names = {fully_qualified(node.namespace, node.node) for node in snapshot.nodes}
    nodes = {name for name in names if not (filters.hidden and is_hidden(name))}
    topics = (one for one in _topics(snapshot, nodes) if _is_shown(one, filters))
    return GraphView(mode, tuple(sorted(nodes)), tuple(topics))


def _topics(snapshot: Snapshot, nodes: set[str]) -> Iterator[TopicView]:
    types: dict[str, set[str]] = {}
    ends: dict[str, tuple[set[str], set[str]]] = {}
    for end in snapshot.of_kind(EntityKind.PUBLISHER, EntityKind.SUBSCRIPTION):
        node = fully_qualified(end.namespace, end.node)
        if node not in nodes:
            continue
        types.setdefault(end.name, set()).add(end.type_name)
        both = ends.setdefault(end.name, (set(), set()))
        both[end.kind is EntityKind.SUBSCRIPTION].add(node)
    published = sorted(name for name, (publishers, _) in ends.items() if publishers)
    for name, (publishers, subscriptions) in sorted(ends.items()):
        yield TopicView(
            name,
            tuple(sorted(types[name])),
            tuple(sorted(publishers)),
            tuple(sorted(subscriptions)),
            None if publishers else nearest(name, published),
        )


def _is_shown(topic: TopicView, filters: Filters) -> bool:
    left_out = (
        (filters.debug and topic.name in _DEBUG_TOPICS)
        or (filters.tf and topic.name in _TF_TOPICS)
        or (filters.params and topic.name in _PARAMETER_TOPICS)
        or (filters.hidden and is_hidden(topic.name))
        or (filters.dead_sinks and not topic.subscriptions)
        or (filters.leaf_topics and len(topic.publishers) + len(topic.subscriptions) < 2)
    )
    return not left_out


def dot(drawn: GraphView) -> str:
    """Return the picture in Graphviz's language: nodes as ellipses, topics as boxes."""
    lines = ["digraph graph_of_nodes {", "  rankdir=LR;"]
    lines += [f"  {_quoted('n:' + name)} [label={_quoted(name)}];" for name in drawn.nodes]
    for box in drawn.boxes:
        colour = ", color=red" if box.has_clash or box.guess else ""
        lines.append(
            f"  {_quoted('t:' + box.name)} [label={_quoted(box.name)}, shape=box{colour}];"
        )
    lines += map(_dot_edge, drawn.edges)
    return "\n".join([*lines, "}"])


def _dot_edge(edge: Edge) -> str:
    start = "n:" if edge.label or edge.is_publishing else "t:"
    end = "t:" if edge.is_publishing else "n:"
    text = f" [label={_quoted(edge.label)}]" if edge.label else ""
    return f"  {_quoted(start + edge.start)} -> {_quoted(end + edge.end)}{text};"


def _quoted(text: str) -> str:
    escaped = text.replace("\\", "\\\\").replace('"', '\\"')
    return f'"{escaped}"'
