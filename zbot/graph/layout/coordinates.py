"""Coordinates of vertices. Vertices are near their neighbours and do not overlap.

A vertex is an item or a dummy vertex. If a link crosses a layer between its two items, the link is
drawn through a point in this layer. This point is a *dummy vertex*.
"""

from __future__ import annotations

from itertools import pairwise
from typing import TYPE_CHECKING, TypeAlias

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from zbot.graph.layout.layered_graph import LayeredGraph

FRAME_PAD = 14.0  #: between a frame and its content
FRAME_TITLE = 22.0  #: for a frame's name, above its content
_ITEM_GAP = 20.0
_PASSING_GAP = 12.0  # between a dummy vertex and its neighbours
_COMPONENT_GAP = 16.0
_SWEEPS = 12
# Weights of links: from item to item, from item to dummy vertex, from dummy vertex to dummy vertex.
# The last weight is the largest, so that long links are straight (Gansner, Koutsofios, North and
# Vo, 1993).
_PULLS = (1.0, 2.0, 8.0)
_STAYS = 1000.0  # the weight of a vertex's old position


def gaps(graph: LayeredGraph, row: Sequence[int]) -> list[float]:
    """Return the smallest allowed distances between the middles of neighbours in a row."""
    return [_gap(graph, one, other) for one, other in pairwise(row)]


def _gap(graph: LayeredGraph, one: int, other: int) -> float:
    gap = (graph.height[one] + graph.height[other]) / 2
    gap += _ITEM_GAP if max(one, other) < graph.size else _PASSING_GAP
    if graph.component[one] != graph.component[other]:
        gap += _COMPONENT_GAP
    mine, theirs = graph.frames[one], graph.frames[other]
    shared = 0
    while shared < min(len(mine), len(theirs)) and mine[shared] == theirs[shared]:
        shared += 1
    left, entered = len(mine) - shared, len(theirs) - shared
    return gap + left * FRAME_PAD + entered * (FRAME_PAD + FRAME_TITLE)


def separate(
    wanted: Sequence[float], weights: Sequence[float], apart: Sequence[float]
) -> list[float]:
    """Return positions near the wanted positions. Their distances are at least `apart`.

    The sum of weighted squared movements is minimal (pool adjacent violators algorithm).

    Args:
        wanted: The wanted positions. The result has the same order.
        weights: A positive weight for each position.
        apart: The least distance of each position to the next position.
    """
    offsets = [0.0]
    for gap in apart:
        offsets.append(offsets[-1] + gap)
    blocks: list[tuple[float, float, int]] = []  # mean, weight, number of positions
    for position, weight, offset in zip(wanted, weights, offsets, strict=False):
        mean, total, count = position - offset, weight, 1
        while blocks and blocks[-1][0] >= mean:
            other, other_weight, other_count = blocks.pop()
            mean = (mean * total + other * other_weight) / (total + other_weight)
            total, count = total + other_weight, count + other_count
        blocks.append((mean, total, count))
    means = [mean for mean, _, count in blocks for _ in range(count)]
    return [mean + offset for mean, offset in zip(means, offsets, strict=False)]


def y_coordinates(graph: LayeredGraph, fixed: Mapping[int, float]) -> list[float]:
    """Return the y of each vertex.

    Args:
        graph: The graph, with ordered rows.
        fixed: The y of the vertices that are on the screen already. These vertices move only if
            there is not enough space.
    """
    y = _stacked(graph, fixed)
    rows = [(row, gaps(graph, row)) for row in graph.rows.values()]
    pulls = [_pulls(graph, vertex) for vertex in range(len(graph.layer))]
    for sweep in range(_SWEEPS):
        # Most sweeps look at the neighbours on one side only, and go through the layers in one
        # direction. So a move in one layer has an effect on all further layers. The last 4 sweeps
        # look at the neighbours on both sides.
        sides = (_LEFT, _RIGHT) if sweep >= _SWEEPS - 4 else (sweep % 2,)
        for row, apart in rows if sweep % 2 == _LEFT else rows[::-1]:
            targets = [_target(vertex, pulls[vertex], sides, y, fixed) for vertex in row]
            settled = separate([one for one, _ in targets], [one for _, one in targets], apart)
            for vertex, position in zip(row, settled, strict=True):
                y[vertex] = position
    return y


def _stacked(graph: LayeredGraph, fixed: Mapping[int, float]) -> list[float]:
    y = [0.0] * len(graph.layer)
    for row in graph.rows.values():
        apart = gaps(graph, row)
        position = -sum(apart) / 2
        for vertex, gap in zip(row, [*apart, 0.0], strict=True):
            y[vertex] = fixed.get(vertex, position)
            position += gap
    return y


_Links: TypeAlias = tuple[list[tuple[int, float]], list[tuple[int, float]]]
_LEFT, _RIGHT = 0, 1


def _pulls(graph: LayeredGraph, vertex: int) -> _Links:
    """Return the neighbours of a vertex on each side, with the weights of their links."""
    left, right = (
        [(other, _PULLS[(vertex >= graph.size) + (other >= graph.size)]) for other in near]
        for near in (graph.left[vertex], graph.right[vertex])
    )
    return left, right


def _target(
    vertex: int, pulls: _Links, sides: Sequence[int], y: list[float], fixed: Mapping[int, float]
) -> tuple[float, float]:
    """Return the wanted y of a vertex, and the weight of this y."""
    if vertex in fixed:
        return fixed[vertex], _STAYS
    near = [pull for side in sides for pull in pulls[side]]
    total = sum(weight for _, weight in near)
    if not total:
        return y[vertex], 0.1
    return sum(y[other] * weight for other, weight in near) / total, total


def column_bounds(
    graph: LayeredGraph, before: Mapping[int, tuple[float, float]], gap: float
) -> dict[int, tuple[float, float]]:
    """Return the left and right x of each layer.

    Args:
        graph: The graph.
        before: The previous result. These layers move only if there is not enough space.
        gap: The space between two layers.
    """
    widths = {layer: max(graph.width[v] for v in row) for layer, row in graph.rows.items()}
    found: dict[int, tuple[float, float]] = {}
    present = [layer for layer in widths if layer in before]
    first = present[0] if present else next(iter(widths), 0)
    right = None
    for layer in [layer for layer in widths if layer >= first]:
        left, width = 0.0 if right is None else right + gap, widths[layer]
        if layer in before:
            left, width = max(before[layer][0], left), max(width, _span(before[layer]))
            left = before[layer][0] if right is None else left
        right = left + width
        found[layer] = (left, right)
    left = found[first][0] if found else 0.0
    for layer in sorted((layer for layer in widths if layer < first), reverse=True):
        found[layer] = (left - gap - widths[layer], left - gap)
        left -= gap + widths[layer]
    return found


def _span(column: tuple[float, float]) -> float:
    return column[1] - column[0]
