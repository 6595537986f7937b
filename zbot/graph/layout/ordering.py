"""Order of the vertices in each layer, with few crossings of links.

In a layer, the vertices of a frame stay together, and the vertices of a component stay together.
"""

from __future__ import annotations

from bisect import bisect_right, insort
from itertools import pairwise
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping

    from zbot.graph.layout.layered_graph import LayeredGraph

_SWEEPS = 12
_ROUNDS_OF_SWAPS = 4


def reduce_crossings(graph: LayeredGraph) -> int:
    """Order the vertices in each row of a graph, and return the number of crossings."""
    _initial_order(graph)
    best, best_rows = count_crossings(graph), _copy(graph)
    for sweep in range(_SWEEPS):
        if not best:
            break
        _sweep(graph, to_the_right=sweep % 2 == 0)
        crossings = count_crossings(graph)
        if crossings < best:
            best, best_rows = crossings, _copy(graph)
    graph.rows = best_rows
    return best - _swap(graph) if best else 0


def order_around(graph: LayeredGraph, fixed: Mapping[int, float]) -> int:
    """Order each row. The vertices in `fixed` keep their y. Return the number of crossings."""
    y = {vertex: fixed.get(vertex, 0.0) for row in graph.rows.values() for vertex in row}
    placed = set(fixed)
    for _ in range(4):
        for row in graph.rows.values():
            for vertex in row:
                near = [
                    y[neighbour]
                    for neighbour in graph.left[vertex] + graph.right[vertex]
                    if neighbour in placed
                ]
                if vertex not in fixed and near:
                    y[vertex] = sum(near) / len(near)
                    placed.add(vertex)
    lowest = max(fixed.values(), default=0.0)
    for vertex in y.keys() - placed:
        y[vertex] = lowest + 1.0 + vertex  # below all other vertices
    for row in graph.rows.values():
        _sort(graph, row, y)
    return count_crossings(graph)


def _copy(graph: LayeredGraph) -> dict[int, list[int]]:
    return {layer: list(row) for layer, row in graph.rows.items()}


def _initial_order(graph: LayeredGraph) -> None:
    """Sort vertices in the order in which a depth-first search finds them."""
    met: dict[int, float] = {}
    for layer in graph.rows:
        for vertex in graph.rows[layer]:
            stack = [vertex]
            while stack:
                reached = stack.pop()
                if reached not in met:
                    met[reached] = float(len(met))
                    stack += reversed(graph.right[reached])
    for row in graph.rows.values():
        _sort(graph, row, met)


def _sweep(graph: LayeredGraph, *, to_the_right: bool) -> None:
    layers = list(graph.rows) if to_the_right else list(graph.rows)[::-1]
    neighbours = graph.left if to_the_right else graph.right
    place: dict[int, float] = {}
    for layer in layers:
        row = graph.rows[layer]
        pull = {}
        for position, vertex in enumerate(row):
            near = neighbours[vertex]
            mean = (
                sum(place.get(neighbour, 0.0) for neighbour in near) / len(near) if near else None
            )
            pull[vertex] = position if mean is None else mean
        _sort(graph, row, pull)
        place.update((vertex, float(position)) for position, vertex in enumerate(row))


def _sort(graph: LayeredGraph, row: list[int], pull: Mapping[int, float]) -> None:
    """Sort a row by `pull`. The vertices of a frame stay together. Their mean decides the place."""
    sums: dict[tuple[str, ...], list[float]] = {}
    for vertex in row:
        frames = graph.frames[vertex]
        for depth in range(1, len(frames) + 1):
            sums.setdefault(frames[:depth], []).append(pull[vertex])
    means = {path: sum(found) / len(found) for path, found in sums.items()}
    place = {vertex: position for position, vertex in enumerate(row)}

    def key(vertex: int) -> tuple[object, ...]:
        frames = graph.frames[vertex]
        ways = [(means[frames[:depth]], frames[depth - 1]) for depth in range(1, len(frames) + 1)]
        own = (pull[vertex], "", place[vertex])
        return (graph.component[vertex], *ways, own)

    row.sort(key=key)


def count_crossings(graph: LayeredGraph) -> int:
    """Return the number of crossings of links between layers."""
    rows = list(graph.rows.values())
    return sum(_between(graph, upper, lower) for upper, lower in pairwise(rows))


def _between(graph: LayeredGraph, row: list[int], following: list[int]) -> int:
    place = {vertex: position for position, vertex in enumerate(following)}
    seen: list[int] = []
    total = 0
    for vertex in row:
        near = graph.right[vertex]
        if len(near) == 1:
            end = place[near[0]]
            total += len(seen) - bisect_right(seen, end)
            insort(seen, end)
            continue
        ends = sorted([place[neighbour] for neighbour in near])
        for end in ends:
            total += len(seen) - bisect_right(seen, end)
        for end in ends:
            insort(seen, end)
    return total


def _swap(graph: LayeredGraph) -> int:
    """Swap neighbours while this removes crossings. Return the number of removed crossings."""
    place: dict[int, int] = {}
    for row in graph.rows.values():
        place.update((vertex, position) for position, vertex in enumerate(row))
    saved = 0
    for _ in range(_ROUNDS_OF_SWAPS):
        gained = sum(_swap_in(graph, row, place) for row in graph.rows.values())
        if not gained:
            break
        saved += gained
    return saved


def _swap_in(graph: LayeredGraph, row: list[int], place: dict[int, int]) -> int:
    gained = 0
    for position in range(len(row) - 1):
        one, other = row[position], row[position + 1]
        groups = [(graph.component[vertex], graph.frames[vertex]) for vertex in (one, other)]
        if groups[0] != groups[1]:
            continue
        gain = 0
        for near in (graph.left, graph.right):
            mine, theirs = [place[v] for v in near[one]], [place[v] for v in near[other]]
            gain += _pairs(mine, theirs) - _pairs(theirs, mine)
        if gain > 0:
            row[position], row[position + 1] = other, one
            place[one], place[other] = position + 1, position
            gained += gain
    return gained


def _pairs(upper: Iterable[int], lower: Iterable[int]) -> int:
    lower = list(lower)
    return sum(one > other for one in upper for other in lower)
