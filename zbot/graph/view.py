"""Selection of the nodes, topics and edges that a drawing of the graph contains."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from enum import Enum
from functools import cached_property
from typing import TYPE_CHECKING

from zbot.graph.filters import Filters, Grouping, compile_filter
from zbot.graph.topics import BoxKind, TopicView, find_topics

if TYPE_CHECKING:
    from collections.abc import Iterator

    from zbot.graph.snapshot import Snapshot

__all__ = [
    "BoxKind",
    "Edge",
    "Filters",
    "GraphView",
    "Grouping",
    "Mode",
    "TopicView",
    "limited",
    "view",
]

# With these limits, the layout takes about a second. A robot with Nav2 has some 30 nodes, 150
# topics and 500 edges. An edge with a label needs as much time as three others.
_MOST_NODES = 300
_MOST_TOPICS = 600
_MOST_EDGES = 2_000
_TOOL = "/_zbot_"  # in the names of zbot's own nodes; `left_out` does not contain these nodes


class Mode(str, Enum):
    """Choice of the topics that are drawn as boxes (the three modes of rqt_graph)."""

    NODES = "nodes"  #: topics have no boxes; edges go from node to node, with the topic as label
    ACTIVE = "active"  #: topics with publishers and subscriptions
    ALL = "all"  #: all topics


@dataclass(frozen=True, order=True)
class Edge:
    """Arrow from a node to a topic, from a topic to a node, or from a node to another node."""

    start: str
    end: str
    label: str = ""
    is_publishing: bool = False  #: whether the arrow goes from a node to a topic
    kind: BoxKind = BoxKind.TOPIC  #: the kind of the topic's box
    is_wrong: bool = False  #: whether messages do not arrive, e.g. because types differ

    @property
    def is_both_ways(self) -> bool:
        """Whether the arrow has two heads: goals go one way, and feedback and results come back."""
        return self.kind is BoxKind.ACTION

    @property
    def topic(self) -> str:
        """The topic at one end of the arrow, or on its label."""
        return self.label or (self.end if self.is_publishing else self.start)

    @property
    def start_key(self) -> str:
        """The key of the box at the arrow's start, unique in the drawing."""
        is_node = self.label or self.is_publishing
        return node_key(self.start) if is_node else self.kind.key(self.start)

    @property
    def end_key(self) -> str:
        """The key of the box at the arrow's end, unique in the drawing."""
        return self.kind.key(self.end) if self.is_publishing else node_key(self.end)


def node_key(name: str) -> str:
    """Return a node's key in the drawing. A topic of the same name has another key."""
    return f"n:{name}"


@dataclass(frozen=True)
class GraphView:
    """Content of a drawing. It is sorted by name, so that equal graphs give equal drawings."""

    mode: Mode
    nodes: tuple[str, ...]
    topics: tuple[TopicView, ...]
    namespaces: int = 0  #: the number of namespace levels that get a frame
    problems: tuple[str, ...] = ()  #: sentences, also about topics that the mode leaves out
    left_out: tuple[str, ...] = field(default=(), compare=False)  #: names that are not drawn

    @property
    def boxes(self) -> tuple[TopicView, ...]:
        """The topics that are drawn as boxes."""
        return () if self.mode is Mode.NODES else self.topics

    @cached_property
    def edges(self) -> tuple[Edge, ...]:
        """The arrows without duplicates, sorted."""
        found = self._direct_edges() if self.mode is Mode.NODES else self._box_edges()
        return tuple(sorted(set(found)))

    def frames_of(self, name: str) -> tuple[str, ...]:
        """Return the namespaces whose frames contain a name. The outermost frame comes first."""
        parts = name.split("/")[1:-1][: self.namespaces]
        return tuple("/" + "/".join(parts[: depth + 1]) for depth in range(len(parts)))

    def _direct_edges(self) -> Iterator[Edge]:
        for topic in self.topics:
            for start in topic.publishers:
                for end in topic.subscriptions:
                    is_wrong = not topic.receives(end, start)
                    yield Edge(start, end, topic.name, kind=topic.kind, is_wrong=is_wrong)

    def _box_edges(self) -> Iterator[Edge]:
        for topic in self.topics:
            for node in topic.publishers:
                is_wrong = topic.has_no_receiver(node)
                yield Edge(node, topic.name, "", True, topic.kind, is_wrong)
            for node in topic.subscriptions:
                yield Edge(topic.name, node, "", False, topic.kind, topic.receives_nothing(node))


def view(
    snapshot: Snapshot,
    mode: Mode = Mode.ALL,
    filters: Filters | None = None,
    grouping: Grouping | None = None,
) -> GraphView:
    """Return the part of a snapshot to draw.

    Raises:
        InvalidFilterError: A part of a filter is not a regular expression.
    """
    filters, grouping = filters or Filters(), grouping or Grouping()
    names = {node.full_node_name for node in snapshot.nodes}
    open_nodes = {name for name in names if filters.shows_node(name)}
    passes = compile_filter(filters.nodes)
    nodes = {name for name in open_nodes if passes(name)}
    # As in rqt_graph, problems and active topics are found with all nodes that the switches allow.
    # Only then are the nodes that `passes` excludes left out.
    found = find_topics(snapshot, open_nodes, grouping)
    shown = [topic.among(nodes) for topic in _chosen(found, mode, filters)]
    judged = [topic.among(nodes) for topic in _chosen(found, Mode.ALL, filters)]
    problems = tuple(topic.problem for topic in judged if topic.ends and topic.problem)
    topics = tuple(topic for topic in shown if topic.ends)
    kept = {topic.name for topic in topics} | nodes
    known = {name for name in names if _TOOL not in name} | {topic.name for topic in found}
    left_out = sorted(known - kept)
    namespaces, all_nodes = grouping.namespaces, tuple(sorted(nodes))
    return GraphView(mode, all_nodes, topics, namespaces, problems, tuple(left_out))


def limited(drawn: GraphView) -> GraphView:
    """Return the part of a view that can be drawn soon. The names of the rest are in `left_out`."""
    nodes = drawn.nodes[:_MOST_NODES]
    known = set(nodes)
    kept: list[TopicView] = []
    edges = 0
    for topic in drawn.topics:
        part = topic if len(nodes) == len(drawn.nodes) else topic.among(known)
        starts, ends = len(part.publishers), len(part.subscriptions)
        count = 3 * starts * ends if drawn.mode is Mode.NODES else starts + ends
        if part.ends and len(kept) < _MOST_TOPICS and edges + count <= _MOST_EDGES:
            kept.append(part)
            edges += count
    names = {*nodes, *(topic.name for topic in kept)}
    rest = {*drawn.nodes, *(topic.name for topic in drawn.topics)} - names
    left_out = tuple(sorted(rest.union(drawn.left_out)))
    return replace(drawn, nodes=nodes, topics=tuple(kept), left_out=left_out)


def _chosen(topics: list[TopicView], mode: Mode, filters: Filters) -> Iterator[TopicView]:
    passes = compile_filter(filters.topics)
    for topic in topics:
        is_left_out = (
            (filters.dead_sinks and not topic.subscriptions)
            or (filters.leaf_topics and len(topic.publishers) + len(topic.subscriptions) < 2)
            or (mode is not Mode.ALL and not topic.is_active)
            or (filters.actions and topic.kind is BoxKind.ACTION)
        )
        if not is_left_out and filters.shows_topic(topic.name) and passes(topic.name):
            yield topic
