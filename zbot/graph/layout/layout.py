"""Layout of items and links, with the paths of links. It is new or based on the previous one."""

from __future__ import annotations

from dataclasses import replace
from statistics import median
from typing import TYPE_CHECKING

from zbot.graph.layout.coordinates import column_bounds, y_coordinates
from zbot.graph.layout.frames import frame_outlines
from zbot.graph.layout.geometry import Layout, Place, Route
from zbot.graph.layout.layered_graph import LayeredGraph
from zbot.graph.layout.ordering import order_around, reduce_crossings

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from zbot.graph.layout.geometry import Item, Link, Point

_COLUMN_GAP = 96.0  # space for the text of a rate beside an arrow
_ENOUGH_KNOWN = 0.5  # with a smaller share of old items, the layout is new
_BEARABLE = 4  # a layout that keeps places may have up to 4 + 2n crossings if a new one has n
_PORT_GAP = 9.0  # between two links at one side of an item
_PORT_EDGE = 9.0  # between the outermost links and the corners of the item
_LOOP = 26.0  # width of a link from an item to itself


def lay_out(items: Sequence[Item], links: Sequence[Link], previous: Layout | None = None) -> Layout:
    """Return the layout of a graph.

    Equal arguments give equal layouts. Links point right, but each cycle has a link that points
    left.
    Items do not overlap, and a frame contains only its own items.

    Args:
        items: The boxes, which have unique keys.
        links: The arrows between items. They contain the keys of the items.
        previous: The layout on the screen. Its items stay in place or move a little, unless most
            items are new or too many links would cross.
    """
    if not items:
        return Layout({}, (), (), {}, 0, 0)
    if previous is None or not _is_known(items, previous):
        return _aligned(_laid_out(items, links, None), previous)
    kept = replace(_laid_out(items, links, previous), best=previous.best)
    if kept.crossings <= _BEARABLE + 2 * kept.best:
        return kept
    new = _laid_out(items, links, None)
    if kept.crossings <= _BEARABLE + 2 * new.crossings:
        return replace(kept, best=new.crossings)
    return _aligned(new, previous)


def _is_known(items: Sequence[Item], previous: Layout) -> bool:
    known = sum(item.key in previous.places for item in items)
    return known >= _ENOUGH_KNOWN * len(items)


def _laid_out(items: Sequence[Item], links: Sequence[Link], previous: Layout | None) -> Layout:
    before = previous.places if previous else {}
    graph = LayeredGraph(items, links, {key: place.layer for key, place in before.items()})
    fixed = {v: before[placed.key].y for v, placed in enumerate(items) if placed.key in before}
    crossings = order_around(graph, fixed) if fixed else reduce_crossings(graph)
    y = y_coordinates(graph, fixed)
    spans = column_bounds(graph, previous.columns if previous else {}, _COLUMN_GAP)
    places = {}
    for vertex, item in enumerate(items):
        left, right = spans[graph.layer[vertex]]
        x = (left + right) / 2
        places[item.key] = Place(x, y[vertex], item.width, item.height, graph.layer[vertex])
    found = route_links(graph, y, spans, [places[item.key] for item in items])
    return Layout(places, found, frame_outlines(graph, y, spans), spans, crossings, crossings)


def _aligned(new: Layout, previous: Layout | None) -> Layout:
    """Return a new layout, moved as a whole so that old items are near their old places."""
    shared = [key for key in new.places if previous and key in previous.places]
    if previous is None or not shared:
        return new
    dx = median(previous.places[key].x - new.places[key].x for key in shared)
    dy = median(previous.places[key].y - new.places[key].y for key in shared)
    return new.moved(dx, dy)


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
