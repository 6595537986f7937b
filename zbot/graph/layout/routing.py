"""The ways of links: from a side of one item to a side of another."""

from __future__ import annotations

from typing import TYPE_CHECKING

from zbot.graph.layout.graph import Route

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from zbot.graph.layout.graph import Place, Point
    from zbot.graph.layout.net import Net

_PORT_GAP = 9.0  # between links at a side
_PORT_EDGE = 9.0  # between the outermost links and the ends of a side
_LOOP = 26.0  # how far a link from an item to itself reaches


def routes(
    net: Net,
    y: list[float],
    columns: Mapping[int, tuple[float, float]],
    places: Sequence[Place],
) -> tuple[Route, ...]:
    """Return the way of each link, in their order."""
    ports = _ports(net, y)
    found = []
    for number, chain in enumerate(net.chains):
        start, end = chain[0], chain[-1]
        label = net.label.get(number)
        if start == end:
            found.append(_loop(places[start], _label_point(net, y, columns, label)))
            continue
        points = [(places[start].right, y[start] + ports[number, True])]
        for vertex in chain[1:-1]:
            left, right = columns[net.layer[vertex]]
            points += [(left, y[vertex]), (right, y[vertex])]
        points.append((places[end].left, y[end] + ports[number, False]))
        is_backward = net.is_turned[number]
        way = tuple(reversed(points)) if is_backward else tuple(points)
        found.append(Route(way, _label_point(net, y, columns, label), is_backward))
    return tuple(found)


def _label_point(
    net: Net, y: list[float], columns: Mapping[int, tuple[float, float]], label: int | None
) -> Point | None:
    if label is None:
        return None
    left, right = columns[net.layer[label]]
    return ((left + right) / 2, y[label])


def _ports(net: Net, y: list[float]) -> dict[tuple[int, bool], float]:
    """Spread links along the sides of items, in the order of where they come from."""
    sides: dict[tuple[int, bool], list[tuple[float, bool, int]]] = {}
    for number, chain in enumerate(net.chains):
        if len(chain) > 1:
            turned = net.is_turned[number]
            sides.setdefault((chain[0], True), []).append((y[chain[1]], turned, number))
            sides.setdefault((chain[-1], False), []).append((y[chain[-2]], turned, number))
    found: dict[tuple[int, bool], float] = {}
    for (vertex, is_right), links in sides.items():
        room = net.height[vertex] - 2 * _PORT_EDGE
        gap = min(_PORT_GAP, room / max(1, len(links) - 1))
        for position, (_, _, number) in enumerate(sorted(links)):
            found[number, is_right] = (position - (len(links) - 1) / 2) * gap
    return found


def _loop(place: Place, label: Point | None) -> Route:
    x = place.right + _LOOP if label is None else label[0]
    y = place.y if label is None else label[1]
    start, end = (place.right, place.y - _PORT_GAP), (place.right, place.y + _PORT_GAP)
    return Route((start, (x, y - _PORT_GAP), (x, y + _PORT_GAP), end), label)
