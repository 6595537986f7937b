"""Where the vertices of ordered rows go: near what they are linked with, never on each other."""

from __future__ import annotations

from itertools import pairwise
from typing import TYPE_CHECKING, TypeAlias

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from zbot.graph.layout.net import Net

FRAME_PAD = 14.0  #: between a frame and what is in it
FRAME_TITLE = 22.0  #: for a frame's name, above what is in it
_ITEM_GAP = 20.0
_PASSING_GAP = 12.0  # between a link that passes and its neighbours
_COMPONENT_GAP = 16.0
_SWEEPS = 12
# How strongly a link pulls: most between two passing vertices, so that long links are straight
# (Gansner, Koutsofios, North and Vo, 1993).
_PULLS = (1.0, 2.0, 8.0)
_STAYS = 1000.0  # how much more what is on the screen resists than what is new


def gaps(net: Net, row: Sequence[int]) -> list[float]:
    """Return how far apart the middles of each two neighbours in a row have to be at least."""
    return [_gap(net, one, other) for one, other in pairwise(row)]


def _gap(net: Net, one: int, other: int) -> float:
    gap = (net.height[one] + net.height[other]) / 2
    gap += _ITEM_GAP if max(one, other) < net.size else _PASSING_GAP
    if net.component[one] != net.component[other]:
        gap += _COMPONENT_GAP
    mine, theirs = net.frames[one], net.frames[other]
    shared = 0
    while shared < min(len(mine), len(theirs)) and mine[shared] == theirs[shared]:
        shared += 1
    left, entered = len(mine) - shared, len(theirs) - shared
    return gap + left * FRAME_PAD + entered * (FRAME_PAD + FRAME_TITLE)


def settle(
    wanted: Sequence[float], weights: Sequence[float], apart: Sequence[float]
) -> list[float]:
    """Return the positions nearest to those wanted that are far enough apart.

    Nearest in the sense of weighted squares, in one pass: pool adjacent violators.

    Args:
        wanted: Positions, in the order that they must have.
        weights: How much each one matters; positive.
        apart: What has to lie between each position and the next.
    """
    offsets = [0.0]
    for gap in apart:
        offsets.append(offsets[-1] + gap)
    blocks: list[tuple[float, float, int]] = []  # mean, weight, how many
    for position, weight, offset in zip(wanted, weights, offsets, strict=False):
        mean, total, count = position - offset, weight, 1
        while blocks and blocks[-1][0] >= mean:
            other, other_weight, other_count = blocks.pop()
            mean = (mean * total + other * other_weight) / (total + other_weight)
            total, count = total + other_weight, count + other_count
        blocks.append((mean, total, count))
    means = [mean for mean, _, count in blocks for _ in range(count)]
    return [mean + offset for mean, offset in zip(means, offsets, strict=False)]


def place(net: Net, fixed: Mapping[int, float]) -> list[float]:
    """Return the y of each vertex.

    Args:
        net: What is placed, its rows in order.
        fixed: Where vertices are already; they move only if there is no room otherwise.
    """
    y = _stacked(net, fixed)
    rows = [(row, gaps(net, row)) for row in net.rows.values()]
    pulls = [_pulls(net, vertex) for vertex in range(len(net.layer))]
    for sweep in range(_SWEEPS):
        # Each side in turn, which spreads what is far away; both at last, for what is between.
        sides = (_LEFT, _RIGHT) if sweep >= _SWEEPS - 4 else (sweep % 2,)
        for row, apart in rows if sweep % 2 == _LEFT else rows[::-1]:
            targets = [_target(vertex, pulls[vertex], sides, y, fixed) for vertex in row]
            settled = settle([one for one, _ in targets], [one for _, one in targets], apart)
            for vertex, position in zip(row, settled, strict=True):
                y[vertex] = position
    return y


def _stacked(net: Net, fixed: Mapping[int, float]) -> list[float]:
    y = [0.0] * len(net.layer)
    for row in net.rows.values():
        apart = gaps(net, row)
        position = -sum(apart) / 2
        for vertex, gap in zip(row, [*apart, 0.0], strict=True):
            y[vertex] = fixed.get(vertex, position)
            position += gap
    return y


_Pulls: TypeAlias = tuple[list[tuple[int, float]], list[tuple[int, float]]]
_LEFT, _RIGHT = 0, 1


def _pulls(net: Net, vertex: int) -> _Pulls:
    """Return the neighbours of a vertex on each side, and how strongly they pull."""
    left, right = (
        [(other, _PULLS[(vertex >= net.size) + (other >= net.size)]) for other in near]
        for near in (net.left[vertex], net.right[vertex])
    )
    return left, right


def _target(
    vertex: int, pulls: _Pulls, sides: Sequence[int], y: list[float], fixed: Mapping[int, float]
) -> tuple[float, float]:
    """Return where a vertex wants to be, and how much."""
    if vertex in fixed:
        return fixed[vertex], _STAYS
    near = [one for side in sides for one in pulls[side]]
    total = sum(weight for _, weight in near)
    if not total:
        return y[vertex], 0.1
    return sum(y[other] * weight for other, weight in near) / total, total


def columns(
    net: Net, before: Mapping[int, tuple[float, float]], gap: float
) -> dict[int, tuple[float, float]]:
    """Return the left and right of each layer; those that were there move only for want of room."""
    widths = {layer: max(net.width[vertex] for vertex in row) for layer, row in net.rows.items()}
    found: dict[int, tuple[float, float]] = {}
    present = [layer for layer in widths if layer in before]
    first = present[0] if present else next(iter(widths), 0)
    right = None
    for layer in [one for one in widths if one >= first]:
        left, width = 0.0 if right is None else right + gap, widths[layer]
        if layer in before:
            left, width = max(before[layer][0], left), max(width, _span(before[layer]))
            left = before[layer][0] if right is None else left
        right = left + width
        found[layer] = (left, right)
    left = found[first][0] if found else 0.0
    for layer in sorted((one for one in widths if one < first), reverse=True):
        found[layer] = (left - gap - widths[layer], left - gap)
        left -= gap + widths[layer]
    return found


def _span(column: tuple[float, float]) -> float:
    return column[1] - column[0]
