"""Layers of vertices. Cycles are removed first, so that arcs point to later layers."""

from __future__ import annotations

from collections import deque
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Mapping

Arc = tuple[int, int, int]  #: start, end, and the least number of layers from start to end


def reversed_arcs(size: int, arcs: list[Arc], known: Mapping[int, int]) -> list[bool]:
    """Return for each arc whether it must be reversed to remove the cycles.

    Args:
        size: The number of vertices.
        arcs: The arcs. An arc from a vertex to itself is not reversed.
        known: The layers of vertices in the previous layout. An arc between such vertices keeps its
            direction, except if the arc and new arcs make a cycle.
    """
    is_reversed = []
    for start, end, _ in arcs:
        before, after = known.get(start), known.get(end)
        is_reversed.append(before is not None and after is not None and before > after)
    pairs = zip(arcs, is_reversed, strict=True)
    directed = [(b, a) if turn else (a, b) for (a, b, _), turn in pairs]
    rank = {vertex: place for place, vertex in enumerate(_sequence(size, directed))}
    return [
        turn != (rank[start] > rank[end])
        for (start, end), turn in zip(directed, is_reversed, strict=True)
    ]


def _sequence(size: int, arcs: list[tuple[int, int]]) -> list[int]:
    """Order vertices so that few arcs point back (Eades, Lin and Smyth, 1993)."""
    after: list[list[int]] = [[] for _ in range(size)]
    before: list[list[int]] = [[] for _ in range(size)]
    for start, end in arcs:
        if start != end:
            after[start].append(end)
            before[end].append(start)
    outs, ins = [len(found) for found in after], [len(found) for found in before]
    left: list[int] = []
    right: list[int] = []
    remaining = dict.fromkeys(range(size))
    ends = deque(vertex for vertex in range(size) if not (outs[vertex] and ins[vertex]))
    while remaining:
        if not ends:
            ends.append(max(remaining, key=lambda vertex: (outs[vertex] - ins[vertex], -vertex)))
        vertex = ends.popleft()
        if vertex not in remaining:
            continue
        del remaining[vertex]
        (right if ins[vertex] and not outs[vertex] else left).append(vertex)
        for other in after[vertex]:
            ins[other] -= 1
            if not ins[other]:
                ends.append(other)
        for other in before[vertex]:
            outs[other] -= 1
            if not outs[other]:
                ends.append(other)
    return left + right[::-1]


def assign_layers(size: int, arcs: list[Arc], known: Mapping[int, int]) -> list[int]:
    """Return the layer of each vertex, so that arcs are short.

    Args:
        size: The number of vertices.
        arcs: The arcs, without cycles.
        known: The layers of vertices in the previous layout. Vertices stay there if arcs allow it.
    """
    after: list[list[tuple[int, int]]] = [[] for _ in range(size)]
    before: list[list[tuple[int, int]]] = [[] for _ in range(size)]
    for start, end, span in arcs:
        after[start].append((end, span))
        before[end].append((start, span))
    order = _topological(size, after, before)
    layer = [0] * size
    for vertex in order:
        wanted = [layer[other] + span for other, span in before[vertex]]
        if vertex in known:
            wanted.append(known[vertex])
        elif not wanted:
            wanted = [min((known[o] - span for o, span in after[vertex] if o in known), default=0)]
        layer[vertex] = max(wanted)
    _tighten(layer, [vertex for vertex in order if vertex not in known], after, before)
    return layer


def _topological(
    size: int, after: list[list[tuple[int, int]]], before: list[list[tuple[int, int]]]
) -> list[int]:
    waiting = [len(found) for found in before]
    order = [vertex for vertex in range(size) if not waiting[vertex]]
    for vertex in order:  # the loop appends to `order`
        for other, _ in after[vertex]:
            waiting[other] -= 1
            if not waiting[other]:
                order.append(other)
    return order


def _tighten(
    layer: list[int],
    movable: list[int],
    after: list[list[tuple[int, int]]],
    before: list[list[tuple[int, int]]],
) -> None:
    """Move each vertex towards the later or the earlier layers, where it has more arcs.

    So the sum of the lengths of all arcs gets smaller.
    """
    for _ in range(4):
        for vertex in reversed(movable):
            if len(after[vertex]) > len(before[vertex]):
                layer[vertex] = min(layer[other] - span for other, span in after[vertex])
        for vertex in movable:
            if len(before[vertex]) > 0 and len(before[vertex]) >= len(after[vertex]):
                layer[vertex] = max(layer[other] + span for other, span in before[vertex])
