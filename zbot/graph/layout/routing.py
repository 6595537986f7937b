"""Paths of links, from a side of one item to a side of another item."""

from __future__ import annotations

from typing import TYPE_CHECKING

from zbot.graph.layout.geometry import Route

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from zbot.graph.layout.geometry import Place, Point
    from zbot.graph.layout.layered_graph import LayeredGraph

_PORT_GAP = 9.0  # between two links at one side of an item
_PORT_EDGE = 9.0  # between the outermost links and the corners of the item
_LOOP = 26.0  # width of a link from an item to itself


def route_links(
    graph: LayeredGraph,
    y: list[float],
    columns: Mapping[int, tuple[float, float]],
    places: Sequence[Place],
) -> tuple[Route, ...]:
    """Return the route of each link, in the order of the links."""
    ports = _ports(graph, y)
    found = []
    for number, chain in enumerate(graph.chains):
        start, end = chain[0], chain[-1]
        label = graph.label.get(number)
        if start == end:
            found.append(_loop(places[start], _label_point(graph, y, columns, label)))
            continue
        points = [(places[start].right, y[start] + ports[number, True])]
        for vertex in chain[1:-1]:
            left, right = columns[graph.layer[vertex]]
            points += [(left, y[vertex]), (right, y[vertex])]
        points.append((places[end].left, y[end] + ports[number, False]))
        is_backward = graph.is_reversed[number]
        way = tuple(reversed(points)) if is_backward else tuple(points)
        found.append(Route(way, _label_point(graph, y, columns, label), is_backward))
    return tuple(found)


def _label_point(
    graph: LayeredGraph,
    y: list[float],
    columns: Mapping[int, tuple[float, float]],
    label: int | None,
) -> Point | None:
    if label is None:
        return None
    left, right = columns[graph.layer[label]]
    return ((left + right) / 2, y[label])


def _ports(graph: LayeredGraph, y: list[float]) -> dict[tuple[int, bool], float]:
    """Return the y offset of each link from the middle of an item's side.

    The links of a side have the same order as the vertices to which they lead.
    """
    sides: dict[tuple[int, bool], list[tuple[float, bool, int]]] = {}
    for number, chain in enumerate(graph.chains):
        if len(chain) > 1:
            turned = graph.is_reversed[number]
            sides.setdefault((chain[0], True), []).append((y[chain[1]], turned, number))
            sides.setdefault((chain[-1], False), []).append((y[chain[-2]], turned, number))
    found: dict[tuple[int, bool], float] = {}
    for (vertex, is_right), links in sides.items():
        room = graph.height[vertex] - 2 * _PORT_EDGE
        gap = min(_PORT_GAP, room / max(1, len(links) - 1))
        for position, (_, _, number) in enumerate(sorted(links)):
            found[number, is_right] = (position - (len(links) - 1) / 2) * gap
    return found


def _loop(place: Place, label: Point | None) -> Route:
    x = place.right + _LOOP if label is None else label[0]
    y = place.y if label is None else label[1]
    start, end = (place.right, place.y - _PORT_GAP), (place.right, place.y + _PORT_GAP)
    return Route((start, (x, y - _PORT_GAP), (x, y + _PORT_GAP), end), label)
