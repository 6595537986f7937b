"""The frames around items: outlines of what lies side by side in neighbouring layers.

A frame may have several parts. `/turtle1/cmd_vel` is left of turtlesim and `/turtle1/pose` right of
it: one box around both would have to hold turtlesim too.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from zbot.graph.layout.graph import Frame
from zbot.graph.layout.place import FRAME_PAD, FRAME_TITLE

if TYPE_CHECKING:
    from collections.abc import Mapping

    from zbot.graph.layout.net import Net

_Slice = tuple[float, float, float, float]
_TOUCH = 24.0  # how much two slices must overlap to look like one


def frames(
    net: Net, y: list[float], columns: Mapping[int, tuple[float, float]]
) -> tuple[Frame, ...]:
    """Return the parts of all frames, the outer ones first."""
    deepest = max(map(len, net.frames), default=0)
    slices: dict[tuple[str, ...], dict[int, _Slice]] = {}
    for depth in range(deepest, 0, -1):
        for layer, row in net.rows.items():
            for path, inner in _blocks(net, row, depth).items():
                nested = [
                    one[layer] for p, one in slices.items() if p[:-1] == path and layer in one
                ]
                spot = _around(net, y, columns[layer], inner, nested)
                slices.setdefault(path, {})[layer] = spot
    found = [
        Frame(path[-1], len(path) - 1, part)
        for path, by_layer in slices.items()
        for part in _parts(by_layer, columns)
    ]
    return tuple(sorted(found, key=lambda one: (one.depth, one.name, one.slices)))


def _blocks(net: Net, row: list[int], depth: int) -> dict[tuple[str, ...], list[int]]:
    """Return the vertices of a row by the frame of some depth that they are in."""
    found: dict[tuple[str, ...], list[int]] = {}
    for vertex in row:
        if len(net.frames[vertex]) >= depth:
            found.setdefault(net.frames[vertex][:depth], []).append(vertex)
    return found


def _around(
    net: Net,
    y: list[float],
    column: tuple[float, float],
    vertices: list[int],
    nested: list[_Slice],
) -> _Slice:
    middle = (column[0] + column[1]) / 2
    half = max(net.width[vertex] for vertex in vertices) / 2
    lefts = [middle - half, *(one[0] for one in nested)]
    tops = [y[vertex] - net.height[vertex] / 2 for vertex in vertices]
    rights = [middle + half, *(one[2] for one in nested)]
    bottoms = [y[vertex] + net.height[vertex] / 2 for vertex in vertices]
    top = min(tops + [one[1] for one in nested])
    bottom = max(bottoms + [one[3] for one in nested])
    return (
        min(lefts) - FRAME_PAD,
        top - FRAME_PAD - FRAME_TITLE,
        max(rights) + FRAME_PAD,
        bottom + FRAME_PAD,
    )


def _parts(
    by_layer: Mapping[int, _Slice], columns: Mapping[int, tuple[float, float]]
) -> list[tuple[_Slice, ...]]:
    """Join the slices of neighbouring layers that touch; they meet between the layers."""
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
