"""What a picture of the graph shows: nodes, topics, and which way messages go.

Pure: it is made of a snapshot, and whoever shows it decides how.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from enum import Enum
from functools import cached_property
from typing import TYPE_CHECKING

from zbot.graph.filters import Filters, Grouping, compile_filter
from zbot.graph.topics import BoxKind, TopicView, find_topics
from zbot.names import fully_qualified

if TYPE_CHECKING:
    from collections.abc import Iterator

    from zbot.graph.snapshot import Snapshot

__all__ = ["BoxKind", "Edge", "Filters", "GraphView", "Grouping", "Mode", "TopicView", "view"]


_TOOL = "/_zbot_"  # nodes of zbot's own commands and of the page: nobody misses them


class Mode(str, Enum):
    """Which topics are boxes of their own (rqt_graph's three choices)."""

    NODES = "nodes"  #: none: arrows lead from node to node, labelled with their topics
    ACTIVE = "active"  #: those with publishers and subscriptions
    ALL = "all"  #: all


@dataclass(frozen=True, order=True)
class Edge:
    """An arrow between names of nodes and topics; a label names the topic between two nodes."""

    start: str
    end: str
    label: str = ""
    is_publishing: bool = False  #: whether it leads from a node to a topic
    kind: BoxKind = BoxKind.TOPIC  #: what the topic at its end, or on its label, is
    is_wrong: bool = False  #: whether nothing can come through

    @property
    def is_both_ways(self) -> bool:
        """Whether answers come back: goals go one way, feedback and results the other."""
        return self.kind is BoxKind.ACTION

    @property
    def topic(self) -> str:
        """The topic at its end or on its label."""
        return self.label or (self.end if self.is_publishing else self.start)

    @property
    def start_key(self) -> str:
        """What tells the start from everything else in the picture."""
        is_node = self.label or self.is_publishing
        return node_key(self.start) if is_node else self.kind.key(self.start)

    @property
    def end_key(self) -> str:
        """What tells the end from everything else in the picture."""
        return self.kind.key(self.end) if self.is_publishing else node_key(self.end)


def node_key(name: str) -> str:
    """Return what tells a node from a topic of the same name."""
    return f"n:{name}"


@dataclass(frozen=True)
class GraphView:
    """What is drawn: everything sorted by name, so that equal graphs give equal pictures."""

    mode: Mode
    nodes: tuple[str, ...]
    topics: tuple[TopicView, ...]
    namespaces: int = 0  #: how many levels of them get a frame
    problems: tuple[str, ...] = ()  #: sentences, also about topics that the mode leaves out
    left_out: tuple[str, ...] = field(default=(), compare=False)  #: names that filters hide

    @property
    def boxes(self) -> tuple[TopicView, ...]:
        """The topics that are drawn as boxes."""
        return () if self.mode is Mode.NODES else self.topics

    @cached_property
    def edges(self) -> tuple[Edge, ...]:
        """The arrows, each once."""
        found = self._direct_edges() if self.mode is Mode.NODES else self._box_edges()
        return tuple(sorted(set(found)))

    def frames_of(self, name: str) -> tuple[str, ...]:
        """Return the namespaces whose frames are around a name, the outermost first."""
        parts = name.split("/")[1:-1][: self.namespaces]
        return tuple("/" + "/".join(parts[: depth + 1]) for depth in range(len(parts)))

    def _direct_edges(self) -> Iterator[Edge]:
        for topic in self.topics:
            for start in topic.publishers:
                for end in topic.subscriptions:
                    is_wrong = not topic.can_hear(end, start)
                    yield Edge(start, end, topic.name, kind=topic.kind, is_wrong=is_wrong)

    def _box_edges(self) -> Iterator[Edge]:
        for topic in self.topics:
            for node in topic.publishers:
                is_wrong = topic.is_unheard(node)
                yield Edge(node, topic.name, "", True, topic.kind, is_wrong)
            for node in topic.subscriptions:
                yield Edge(topic.name, node, "", False, topic.kind, topic.is_deaf(node))


def view(
    snapshot: Snapshot,
    mode: Mode = Mode.ALL,
    filters: Filters | None = None,
    grouping: Grouping | None = None,
) -> GraphView:
    """Return what to draw of a snapshot.

    Raises:
        InvalidFilterError: A filter has a part that is no regular expression.
    """
    filters, grouping = filters or Filters(), grouping or Grouping()
    names = {fully_qualified(node.namespace, node.node) for node in snapshot.nodes}
    open_nodes = {name for name in names if filters.shows_node(name)}
    passes = compile_filter(filters.nodes)
    nodes = {name for name in open_nodes if passes(name)}
    # As in rqt_graph, a topic is judged with all its nodes, also those that are not drawn.
    found = find_topics(snapshot, open_nodes, grouping)
    shown = [topic.among(nodes) for topic in _chosen(found, mode, filters)]
    judged = [topic.among(nodes) for topic in _chosen(found, Mode.ALL, filters)]
    problems = tuple(topic.problem for topic in judged if topic.ends and topic.problem)
    topics = tuple(topic for topic in shown if topic.ends)
    kept = {topic.name for topic in topics} | nodes
    known = {name for name in names if _TOOL not in name} | {topic.name for topic in found}
    left_out = sorted(known - kept)
    namespaces, everybody = grouping.namespaces, tuple(sorted(nodes))
    return GraphView(mode, everybody, topics, namespaces, problems, tuple(left_out))


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
