"""The order within each layer: few crossings, and what belongs together side by side."""

from __future__ import annotations

from bisect import bisect_right, insort
from itertools import pairwise
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping

    from zbot.graph.layout.net import Net

_SWEEPS = 12
_ROUNDS_OF_SWAPS = 4


def order(net: Net) -> int:
    """Order the rows of a net; return how many crossings are left."""
    _begin(net)
    best, best_rows = count_crossings(net), _copy(net)
    for sweep in range(_SWEEPS):
        if not best:
            break
        _sweep(net, to_the_right=sweep % 2 == 0)
        crossings = count_crossings(net)
        if crossings < best:
            best, best_rows = crossings, _copy(net)
    net.rows = best_rows
    return best - _swap(net) if best else 0


def order_around(net: Net, fixed: Mapping[int, float]) -> int:
    """Order the rows around vertices that keep their y; return how many crossings there are."""
    y = {vertex: fixed.get(vertex, 0.0) for row in net.rows.values() for vertex in row}
    placed = set(fixed)
    for _ in range(4):
        for row in net.rows.values():
            for vertex in row:
                near = [y[one] for one in net.left[vertex] + net.right[vertex] if one in placed]
                if vertex not in fixed and near:
                    y[vertex] = sum(near) / len(near)
                    placed.add(vertex)
    lowest = max(fixed.values(), default=0.0)
    for vertex in y.keys() - placed:
        y[vertex] = lowest + 1.0 + vertex  # below all others
    for row in net.rows.values():
        _sort(net, row, y)
    return count_crossings(net)


def _copy(net: Net) -> dict[int, list[int]]:
    return {layer: list(row) for layer, row in net.rows.items()}


def _begin(net: Net) -> None:
    """Order vertices as a walk along the links meets them."""
    met: dict[int, float] = {}
    for layer in net.rows:
        for vertex in net.rows[layer]:
            stack = [vertex]
            while stack:
                one = stack.pop()
                if one not in met:
                    met[one] = float(len(met))
                    stack += reversed(net.right[one])
    for row in net.rows.values():
        _sort(net, row, met)


def _sweep(net: Net, *, to_the_right: bool) -> None:
    layers = list(net.rows) if to_the_right else list(net.rows)[::-1]
    neighbours = net.left if to_the_right else net.right
    place: dict[int, float] = {}
    for layer in layers:
        row = net.rows[layer]
        pull = {}
        for position, vertex in enumerate(row):
            near = neighbours[vertex]
            mean = sum(place.get(one, 0.0) for one in near) / len(near) if near else None
            pull[vertex] = position if mean is None else mean
        _sort(net, row, pull)
        place.update((vertex, float(position)) for position, vertex in enumerate(row))


def _sort(net: Net, row: list[int], pull: Mapping[int, float]) -> None:
    """Sort a row, keeping components and frames together: each goes where its members pull."""
    sums: dict[tuple[str, ...], list[float]] = {}
    for vertex in row:
        frames = net.frames[vertex]
        for depth in range(1, len(frames) + 1):
            sums.setdefault(frames[:depth], []).append(pull[vertex])
    means = {path: sum(found) / len(found) for path, found in sums.items()}
    place = {vertex: position for position, vertex in enumerate(row)}

    def key(vertex: int) -> tuple[object, ...]:
        frames = net.frames[vertex]
        ways = [(means[frames[:depth]], frames[depth - 1]) for depth in range(1, len(frames) + 1)]
        own = (pull[vertex], "", place[vertex])
        return (net.component[vertex], *ways, own)

    row.sort(key=key)


def count_crossings(net: Net) -> int:
    """Return how often links cross between layers."""
    rows = list(net.rows.values())
    return sum(_between(net, upper, lower) for upper, lower in pairwise(rows))


def _between(net: Net, row: list[int], following: list[int]) -> int:
    place = {vertex: position for position, vertex in enumerate(following)}
    seen: list[int] = []
    total = 0
    for vertex in row:
        near = net.right[vertex]
        if len(near) == 1:
            end = place[near[0]]
            total += len(seen) - bisect_right(seen, end)
            insort(seen, end)
            continue
        ends = sorted([place[one] for one in near])
        for end in ends:
            total += len(seen) - bisect_right(seen, end)
        for end in ends:
            insort(seen, end)
    return total


def _swap(net: Net) -> int:
    """Exchange neighbours while that helps; return how many crossings that saves."""
    place: dict[int, int] = {}
    for row in net.rows.values():
        place.update((vertex, position) for position, vertex in enumerate(row))
    saved = 0
    for _ in range(_ROUNDS_OF_SWAPS):
        gained = sum(_swap_in(net, row, place) for row in net.rows.values())
        if not gained:
            break
        saved += gained
    return saved


def _swap_in(net: Net, row: list[int], place: dict[int, int]) -> int:
    gained = 0
    for position in range(len(row) - 1):
        one, other = row[position], row[position + 1]
        if net.component[one] != net.component[other] or net.frames[one] != net.frames[other]:
            continue
        gain = 0
        for near in (net.left, net.right):
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
