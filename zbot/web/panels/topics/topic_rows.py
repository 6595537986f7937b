"""Rows of the list of topics."""

from __future__ import annotations

import posixpath
import re
from dataclasses import dataclass
from typing import TYPE_CHECKING

from zbot.errors.suggestion import KnownNames
from zbot.wire.tokens import EntityKind

if TYPE_CHECKING:
    from collections.abc import Collection, Iterator, Sequence

    from zbot.graph.snapshot import Snapshot
    from zbot.wire.tokens import EndpointToken


@dataclass(frozen=True, slots=True)
class FoldedRow:
    """Row of a folded list: a name, or a namespace."""

    name: str  #: full name, e.g. `/robot1/scan`, or a namespace that ends with `/`: `/robot1/`
    depth: int  #: number of open namespaces around it in the list
    names: tuple[str, ...] = ()  #: all names in the namespace. Empty if the row is a name


def folded(names: Sequence[str], opened: Collection[str]) -> list[FoldedRow]:
    """Return the rows of a list of names.

    A namespace that contains all names is not a row, because it would hide everything.

    Args:
        names: Full names, in the order of the list.
        opened: The open namespaces, each with `/` at its end.
    """
    return list(_rows(names, _common_namespace(names), 0, opened))


def _rows(
    names: Sequence[str], namespace: str, depth: int, opened: Collection[str]
) -> Iterator[FoldedRow]:
    groups: dict[str, list[str]] = {}
    for name in names:
        first, slash, _ = name[len(namespace) :].partition("/")
        groups.setdefault(namespace + first + slash, []).append(name)
    for group in groups.values():
        if len(group) == 1:
            yield FoldedRow(group[0], depth)
            continue
        inner = _common_namespace(group)
        yield FoldedRow(inner, depth, tuple(group))
        if inner in opened:
            yield from _rows(group, inner, depth + 1, opened)


def _common_namespace(names: Sequence[str]) -> str:
    folders = [posixpath.dirname(name) for name in names]
    return posixpath.join(posixpath.commonpath(folders), "") if folders else "/"


@dataclass(frozen=True, slots=True)
class TopicRow:
    """Topic with its nodes, and its problem if it has a problem."""

    name: str
    types: tuple[str, ...]
    publishers: tuple[str, ...]  #: sorted full names of nodes, one for each publisher
    subscriptions: tuple[str, ...]  #: sorted full names of nodes, one for each subscription
    guess: str | None  #: a published topic with a similar name, if this topic has no publisher

    @property
    def has_clash(self) -> bool:
        """Whether its nodes use different types and therefore exchange no messages."""
        return len(self.types) > 1


def topic_rows(graph: Snapshot, own_node: str) -> list[TopicRow]:
    """Return the topics in natural order, without the endpoints of the page's own node.

    Args:
        graph: The graph.
        own_node: Full name of the page's node, which subscribes to the topics that pages show.
    """
    ends: dict[str, list[EndpointToken]] = {}
    for end in graph.of_kind(EntityKind.PUBLISHER, EntityKind.SUBSCRIPTION):
        if end.full_node_name != own_node:
            ends.setdefault(end.name, []).append(end)
    published = {name for name, of_name in ends.items() if any(map(_is_publisher, of_name))}
    known = KnownNames(published)
    return [_row(name, ends[name], published, known) for name in sorted(ends, key=_natural)]


def nodes_of(graph: Snapshot, topic: str, own_node: str) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """Return the nodes that publish a topic and those that subscribe to it, as in `TopicRow`."""
    ends = graph.on(topic, EntityKind.PUBLISHER, EntityKind.SUBSCRIPTION)
    return _nodes([end for end in ends if end.full_node_name != own_node])


def _nodes(ends: Sequence[EndpointToken]) -> tuple[tuple[str, ...], tuple[str, ...]]:
    return (
        tuple(sorted(end.full_node_name for end in ends if _is_publisher(end))),
        tuple(sorted(end.full_node_name for end in ends if not _is_publisher(end))),
    )


def _row(name: str, ends: list[EndpointToken], published: set[str], known: KnownNames) -> TopicRow:
    return TopicRow(
        name,
        tuple(sorted({end.type_name for end in ends})),
        *_nodes(ends),
        None if name in published else known.nearest(name),
    )


def _is_publisher(end: EndpointToken) -> bool:
    return end.kind is EntityKind.PUBLISHER


def _natural(name: str) -> list[tuple[int, str]]:
    """Return a sort key. With this key, `/robot2` comes before `/robot10`."""
    parts = re.split(r"0*([0-9]+)", name)
    # Of two numbers without zeros at their begin, the longer one is larger.
    return [(len(part), part) if index % 2 else (-1, part) for index, part in enumerate(parts)]
