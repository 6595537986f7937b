"""Outlines of frames around items that are side by side in neighbouring layers.

A frame may have several parts. Example: `/turtle1/cmd_vel` is on the left of turtlesim, and
`/turtle1/pose` is on the right. One box around both topics would contain turtlesim too.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from zbot.graph.layout.coordinates import FRAME_PAD, FRAME_TITLE
from zbot.graph.layout.geometry import Frame

if TYPE_CHECKING:
    from collections.abc import Mapping

    from zbot.graph.layout.layered_graph import LayeredGraph

_Slice = tuple[float, float, float, float]
_TOUCH = 24.0  # two neighbouring slices are joined if they overlap at least this much


def frame_outlines(
    graph: LayeredGraph, y: list[float], columns: Mapping[int, tuple[float, float]]
) -> tuple[Frame, ...]:
    """Return the parts of all frames, outer frames first."""
    deepest = max(map(len, graph.frames), default=0)
    slices: dict[tuple[str, ...], dict[int, _Slice]] = {}
    for depth in range(deepest, 0, -1):
        for layer, row in graph.rows.items():
            for path, inner in _blocks(graph, row, depth).items():
                nested = [
                    by_layer[layer]
                    for p, by_layer in slices.items()
                    if p[:-1] == path and layer in by_layer
                ]
                spot = _around(graph, y, columns[layer], inner, nested)
                slices.setdefault(path, {})[layer] = spot
    found = [
        Frame(path[-1], len(path) - 1, part)
        for path, by_layer in slices.items()
        for part in _parts(by_layer, columns)
    ]
    return tuple(sorted(found, key=lambda frame: (frame.depth, frame.name, frame.slices)))


def _blocks(graph: LayeredGraph, row: list[int], depth: int) -> dict[tuple[str, ...], list[int]]:
    """Return the vertices of a row, grouped by their frame at a depth."""
    found: dict[tuple[str, ...], list[int]] = {}
    for vertex in row:
        if len(graph.frames[vertex]) >= depth:
            found.setdefault(graph.frames[vertex][:depth], []).append(vertex)
    return found


def _around(
    graph: LayeredGraph,
    y: list[float],
    column: tuple[float, float],
    vertices: list[int],
    nested: list[_Slice],
) -> _Slice:
    middle = (column[0] + column[1]) / 2
    half = max(graph.width[vertex] for vertex in vertices) / 2
    lefts = [middle - half, *(spot[0] for spot in nested)]
    tops = [y[vertex] - graph.height[vertex] / 2 for vertex in vertices]
    rights = [middle + half, *(spot[2] for spot in nested)]
    bottoms = [y[vertex] + graph.height[vertex] / 2 for vertex in vertices]
    top = min(tops + [spot[1] for spot in nested])
    bottom = max(bottoms + [spot[3] for spot in nested])
    return (
        min(lefts) - FRAME_PAD,
        top - FRAME_PAD - FRAME_TITLE,
        max(rights) + FRAME_PAD,
        bottom + FRAME_PAD,
    )


def _parts(
    by_layer: Mapping[int, _Slice], columns: Mapping[int, tuple[float, float]]
) -> list[tuple[_Slice, ...]]:
    """Return the parts of a frame. Overlapping slices of neighbouring layers form one part."""
    parts: list[list[_Slice]] = []
    for layer, (left, top, right, bottom) in sorted(by_layer.items()):
        before = parts[-1][-1] if layer - 1 in by_layer else None
        if before is not None and min(bottom, before[3]) - max(top, before[1]) >= _TOUCH:
            border = (columns[layer - 1][1] + columns[layer][0]) / 2
            parts[-1][-1] = (before[0], before[1], border, before[3])
            parts[-1].append((border, top, right, bottom))
        else:
            parts.append([(left, top, right, bottom)])
    return [tuple(part) for part in parts]
