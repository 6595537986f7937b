"""Graph with vertices in layers.

A layer is a column of the drawing. A link has a dummy vertex in each layer between its two items:
a point through which the link is drawn.
"""

from __future__ import annotations

from itertools import pairwise
from math import sqrt
from typing import TYPE_CHECKING

from zbot.graph.layout.layering import Arc, assign_layers, reversed_arcs

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from zbot.graph.layout.geometry import Item, Link

LABEL_HEIGHT = 36.0  # for one line of text above the arrow, and one line below it
_ROW = 64.0  # the estimated height of an item, and the space below it
_COLUMN = 240.0
_MOST_LAYERS = 14  # with more layers, names on a projected screen become too small to read
_SHAPE = 1.7  # width divided by height of a screen


class LayeredGraph:
    """Vertices in layers. A vertex is an index: items have lower indices than dummy vertices.

    Args:
        items: The items.
        links: The links.
        known: The layers of items in the previous layout, by key.
    """

    def __init__(
        self, items: Sequence[Item], links: Sequence[Link], known: Mapping[str, int]
    ) -> None:
        self.items = items
        self.size = len(items)
        self.width = [item.width for item in items]
        self.height = [item.height for item in items]
        index = {item.key: number for number, item in enumerate(items)}
        # A link with a label spans two layers, because the label needs a layer between the items.
        arcs = [(index[ln.start], index[ln.end], 2 if ln.label_width else 1) for ln in links]
        layers = {index[key]: layer for key, layer in known.items() if key in index}
        self._set_layers(arcs, reversed_arcs(self.size, arcs, layers), layers)
        if not layers and max(self.layer) > _most_layers(self.size):
            self._set_layers(arcs, _wrapped(arcs, self.layer, _most_layers(self.size)), layers)
        self.component = _components(items, self.arcs)
        if not layers:
            _fold(self.layer, self.component)
        self.frames: list[tuple[str, ...]] = [item.frames for item in items]
        self.left: list[list[int]] = [[] for _ in items]  #: neighbours in the layer before
        self.right: list[list[int]] = [[] for _ in items]  #: neighbours in the layer after
        self.label: dict[int, int] = {}  #: the vertex of a link's label
        self.chains = [self._chain(number, link) for number, link in enumerate(links)]
        self.rows: dict[int, list[int]] = {layer: [] for layer in sorted(set(self.layer))}
        for vertex, layer in enumerate(self.layer):
            self.rows[layer].append(vertex)

    def _set_layers(self, arcs: list[Arc], turns: list[bool], known: Mapping[int, int]) -> None:
        self.is_reversed = turns
        pairs = zip(arcs, turns, strict=True)
        self.arcs = [(b, a, span) if turn else (a, b, span) for (a, b, span), turn in pairs]
        proper = [arc for arc in self.arcs if arc[0] != arc[1]]
        self.layer = assign_layers(self.size, proper, known)

    def _chain(self, number: int, link: Link) -> list[int]:
        """Return the vertices of a link from left to right."""
        start, end, _ = self.arcs[number]
        if start == end:
            if link.label_width:
                self._label_vertex(number, link, start, self.layer[start] + 1)
                self._join(start, self.label[number])
            return [start]
        frames = _common(self.frames[start], self.frames[end])
        middle = (self.layer[start] + self.layer[end]) // 2
        chain = [start]
        for layer in range(self.layer[start] + 1, self.layer[end]):
            if layer == middle and link.label_width:
                vertex = self._label_vertex(number, link, start, layer)
                self.frames[vertex] = frames
            else:
                vertex = self._vertex(layer, self.component[start], frames)
            chain.append(vertex)
        chain.append(end)
        for one, other in pairwise(chain):
            self._join(one, other)
        return chain

    def _label_vertex(self, number: int, link: Link, start: int, layer: int) -> int:
        vertex = self._vertex(layer, self.component[start], self.frames[start])
        self.width[vertex], self.height[vertex] = link.label_width, LABEL_HEIGHT
        self.label[number] = vertex
        return vertex

    def _vertex(self, layer: int, component: int, frames: tuple[str, ...]) -> int:
        self.width.append(0.0)
        self.height.append(0.0)
        self.layer.append(layer)
        self.component.append(component)
        self.frames.append(frames)
        self.left.append([])
        self.right.append([])
        return len(self.layer) - 1

    def _join(self, one: int, other: int) -> None:
        self.right[one].append(other)
        self.left[other].append(one)


def _common(one: tuple[str, ...], other: tuple[str, ...]) -> tuple[str, ...]:
    depth = 0
    while depth < min(len(one), len(other)) and one[depth] == other[depth]:
        depth += 1
    return one[:depth]


def _components(items: Sequence[Item], arcs: list[Arc]) -> list[int]:
    """Return the component of each item.

    Items are in the same component if links or outermost frames connect them. Components are
    numbered from the largest to the smallest.
    """
    parent = list(range(len(items)))

    def root(vertex: int) -> int:
        while parent[vertex] != vertex:
            parent[vertex] = parent[parent[vertex]]
            vertex = parent[vertex]
        return vertex

    for start, end, _ in arcs:
        parent[root(start)] = root(end)
    first_in: dict[str, int] = {}
    for vertex, item in enumerate(items):
        if item.frames:
            parent[root(vertex)] = root(first_in.setdefault(item.frames[0], vertex))
    members: dict[int, list[int]] = {}
    for vertex in range(len(items)):
        members.setdefault(root(vertex), []).append(vertex)
    found = sorted(members.values(), key=lambda vertices: (-len(vertices), vertices[0]))
    component = [0] * len(items)
    for number, vertices in enumerate(found):
        for vertex in vertices:
            component[vertex] = number
    return component


def _most_layers(size: int) -> int:
    """Return how many layers fit on a screen. It is even, because nodes and topics alternate."""
    return max(_MOST_LAYERS, round(sqrt(size) / 2) * 2)


def _wrapped(arcs: list[Arc], layer: list[int], most: int) -> list[bool]:
    """Wrap the layers at the limit, like lines of text. Return for each arc if it points back."""
    rank = [
        (layer_number % most, layer_number, vertex) for vertex, layer_number in enumerate(layer)
    ]
    return [rank[start] > rank[end] for start, end, _ in arcs]


def _fold(layer: list[int], component: list[int]) -> None:
    """Shift the layers of components, so that the whole drawing has the shape of a screen."""
    blocks: dict[int, dict[int, int]] = {}
    for vertex, number in enumerate(component):
        block = blocks.setdefault(number, {})
        block[layer[vertex]] = block.get(layer[vertex], 0) + 1
    heights = [max(blocks[number].values()) for number in range(len(blocks))]
    spans = [max(blocks[number]) - min(blocks[number]) + 1 for number in range(len(blocks))]
    _, shifts = min(_bands(heights, spans, count) for count in range(1, len(heights) + 1)[:12])
    for vertex, number in enumerate(component):
        layer[vertex] += shifts[number] - min(blocks[number])


def _bands(heights: list[int], spans: list[int], count: int) -> tuple[float, list[int]]:
    """Put components into `count` bands side by side. The components of a band form a column.

    Returns:
        The factor between the shape of the whole drawing and the shape of a screen (1 if they are
        equal), and the first layer of each component.
    """
    filled = [0] * count
    band_of = []
    for height in heights:
        band = filled.index(min(filled))
        band_of.append(band)
        filled[band] += height
    widths = [
        max((span for span, band in zip(spans, band_of, strict=True) if band == number), default=0)
        for number in range(count)
    ]
    starts = [sum(widths[:number]) for number in range(count)]
    shape = (sum(widths) * _COLUMN) / (max(filled) * _ROW)
    return max(shape / _SHAPE, _SHAPE / shape), [starts[band] for band in band_of]
