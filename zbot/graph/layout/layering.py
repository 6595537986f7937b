"""Which layer each vertex belongs to: circles are cut, then links point to later layers."""

from __future__ import annotations

from collections import deque
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Mapping

Arc = tuple[int, int, int]  #: from, to, and how many layers it spans at least


def turned(size: int, arcs: list[Arc], known: Mapping[int, int]) -> list[bool]:
    """Return which arcs have to be turned round so that none goes in circles.

    Args:
        size: How many vertices there are.
        arcs: The arcs; those from a vertex to itself are not turned.
        known: Layers of vertices that are on the screen: arcs between them keep their direction.
    """
    is_turned = []
    for start, end, _ in arcs:
        before, after = known.get(start), known.get(end)
        is_turned.append(before is not None and after is not None and before > after)
    directed = [(b, a) if turn else (a, b) for (a, b, _), turn in zip(arcs, is_turned, strict=True)]
    rank = {vertex: place for place, vertex in enumerate(_sequence(size, directed))}
    return [
        turn != (rank[start] > rank[end])
        for (start, end), turn in zip(directed, is_turned, strict=True)
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


def assign(size: int, arcs: list[Arc], known: Mapping[int, int]) -> list[int]:
    """Return the layer of each vertex: arcs span what they must, and little more.

    Args:
        size: How many vertices there are.
        arcs: The arcs, without circles.
        known: Layers of vertices that are on the screen; they stay, unless that is impossible.
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
    for vertex in order:  # grows while it is read
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
    """Move vertices to where most of their arcs are; a source goes beside its first reader."""
    for _ in range(4):
        for vertex in reversed(movable):
            if len(after[vertex]) > len(before[vertex]):
                layer[vertex] = min(layer[other] - span for other, span in after[vertex])
        for vertex in movable:
            if len(before[vertex]) > 0 and len(before[vertex]) >= len(after[vertex]):
                layer[vertex] = max(layer[other] + span for other, span in before[vertex])
