"""Drawing of the graph as SVG.

Each node, topic, edge and namespace frame is an SVG group with a `data-key`. A web page finds the
group by this key, moves the group and reacts to clicks. `data-node` and `data-topic` contain names.
"""

from __future__ import annotations

from dataclasses import dataclass
from html import escape
from itertools import pairwise
from math import sqrt
from typing import TYPE_CHECKING

from zbot.graph.layout import Item, Layout, Link, lay_out
from zbot.graph.style import FONT_SIZE, LABEL_SIZE, style, text_width
from zbot.graph.view import Mode, node_key

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping

    from zbot.graph.layout import Frame, Place, Route
    from zbot.graph.view import Edge, GraphView, TopicView

_MARGIN = 24.0
_NODE_HEIGHT = 46.0
_BOX_HEIGHT = 38.0
_LINE = 18.0  # distance of two lines of text
_LONG = 34  # in characters; longer names get two lines
_HEAD = 10.0  # length of an arrow head
_EMPTY = "no node is running"


@dataclass(frozen=True)
class Drawing:
    """View of the graph with its layout."""

    view: GraphView
    layout: Layout

    def svg(self, labels: Mapping[Edge, str] | None = None) -> str:
        """Return a complete SVG file for light and dark screens.

        Args:
            labels: Texts beside edges, such as rates. If a mapping is given, even an empty mapping,
                every edge has an element `text.rate` that a page can fill.
        """
        body = "\n".join([*self._frames(), *self._edges(labels), *self._items()])
        left, top, right, bottom = self.layout.bounds if self.layout.places else (0, 0, 220, 40)
        left, top = left - _MARGIN, top - _MARGIN
        width, height = right - left + _MARGIN, bottom - top + _MARGIN
        box = f'x="{left:.0f}" y="{top:.0f}" width="{width:.0f}" height="{height:.0f}"'
        return (
            f'<svg xmlns="http://www.w3.org/2000/svg" class="zbot-graph" role="img"'
            f' aria-label="graph of nodes and topics" width="{width:.0f}" height="{height:.0f}"'
            f' viewBox="{left:.0f} {top:.0f} {width:.0f} {height:.0f}">\n'
            f'<style>{style()}</style>\n<rect class="ground" {box}/>\n{body}\n</svg>\n'
        )

    def _frames(self) -> Iterator[str]:
        numbers: dict[str, int] = {}
        for frame in self.layout.frames:
            number = numbers[frame.name] = numbers.get(frame.name, 0) + 1
            left, top, *_ = frame.slices[0]
            yield (
                f'<g class="frame" data-key="f:{escape(frame.name)}#{number}"'
                f' data-namespace="{escape(frame.name)}">'
                f'<path d="{_outline(frame)}"/>'
                f'<text x="{left + 12:.1f}" y="{top + 18:.1f}">{escape(frame.name)}</text></g>'
            )

    def _edges(self, labels: Mapping[Edge, str] | None) -> Iterator[str]:
        for edge, route in zip(self.view.edges, self.layout.routes, strict=True):
            points = [*route.points]
            points[0] = self._touching(edge.start_key, points[0])
            points[-1] = self._touching(edge.end_key, points[-1])
            label = None if labels is None else labels.get(edge, "")
            yield _edge(edge, route, points, label)

    def _touching(self, key: str, point: tuple[float, float]) -> tuple[float, float]:
        """Return an end of an edge. An end at a node moves sideways to the node's ellipse."""
        if not key.startswith("n:"):
            return point
        place = self.layout.places[key]
        inside = 1 - sqrt(max(0.0, 1 - ((point[1] - place.y) / (place.height / 2)) ** 2))
        dx = inside * place.width / 2
        return (point[0] + (dx if point[0] < place.x else -dx), point[1])

    def _items(self) -> Iterator[str]:
        if not self.view.nodes:
            yield f'<text class="empty" x="110" y="24">{_EMPTY}</text>'
        for name in self.view.nodes:
            place = self.layout.places[node_key(name)]
            shape = f'<ellipse rx="{place.width / 2:.1f}" ry="{place.height / 2:.1f}"/>'
            facts = f'data-node="{escape(name)}"'
            key = node_key(name)
            yield _item(key, place, shape, classes="item node", facts=facts, name=name, title=name)
        for box in self.view.boxes:
            yield _box(box, self.layout.places[box.key])


def draw(view: GraphView, previous: Drawing | None = None) -> Drawing:
    """Return a drawing. Nodes and topics of the previous drawing keep their places if possible."""
    items = [Item(node_key(node), *_node_size(node), view.frames_of(node)) for node in view.nodes]
    items.extend(
        Item(box.key, *_box_size(box.name), view.frames_of(box.name)) for box in view.boxes
    )
    links = [Link(edge.start_key, edge.end_key, _label_width(edge)) for edge in view.edges]
    return Drawing(view, lay_out(items, links, _still_valid(view, previous)))


def _still_valid(view: GraphView, previous: Drawing | None) -> Layout | None:
    if previous is None or previous.view.namespaces != view.namespaces:
        return None
    is_other_kind = (previous.view.mode is Mode.NODES) is not (view.mode is Mode.NODES)
    return None if is_other_kind else previous.layout


def lines_of(name: str) -> list[str]:
    """Return the lines of a name. A long name is split at the `/` that is nearest to its middle."""
    if len(name) <= _LONG:
        return [name]
    breaks = [index for index, character in enumerate(name) if character == "/" and index]
    if not breaks:
        return [name]
    best = min(breaks, key=lambda index: abs(index - len(name) / 2))
    return [name[:best], name[best:]]


def _text_size(name: str) -> tuple[float, float]:
    lines = lines_of(name)
    return max(text_width(line, FONT_SIZE) for line in lines), (len(lines) - 1) * _LINE


def _node_size(name: str) -> tuple[float, float]:
    width, more = _text_size(name)
    return width * 1.12 + 40, _NODE_HEIGHT + more * 1.3


def _box_size(name: str) -> tuple[float, float]:
    width, more = _text_size(name)
    return width + 30, _BOX_HEIGHT + more


def _label_width(edge: Edge) -> float:
    return text_width(edge.label, LABEL_SIZE) + 12 if edge.label else 0.0


def _box(box: TopicView, place: Place) -> str:
    left, top = -place.width / 2, -place.height / 2
    size = f'width="{place.width:.1f}" height="{place.height:.1f}" rx="6"'
    shape = f'<rect x="{left:.1f}" y="{top:.1f}" {size}/>'
    if box.kind.value != "topic":
        # A box that replaces several topics has a double border.
        inner = f'width="{place.width - 8:.1f}" height="{place.height - 8:.1f}" rx="3"'
        shape += f'<rect class="inner" x="{left + 4:.1f}" y="{top + 4:.1f}" {inner}/>'
    classes = f"item topic {box.kind.value}" if box.kind.value != "topic" else "item topic"
    classes += " wrong" if box.problem else ""
    facts = f'data-topic="{escape(box.name)}" data-types="{escape(" ".join(box.types))}"'
    title = "\n".join(filter(None, [box.name, *box.types, *box.stands_for, box.problem]))
    return _item(box.key, place, shape, classes=classes, facts=facts, name=box.name, title=title)


def _item(
    key: str, place: Place, shape: str, *, classes: str, facts: str, name: str, title: str
) -> str:
    lines = lines_of(name)
    first = 5.0 - (len(lines) - 1) * _LINE / 2  # 5 px from the middle of a line to its baseline
    spans = "".join(
        f'<tspan x="0" y="{first + number * _LINE:.1f}">{escape(line)}</tspan>'
        for number, line in enumerate(lines)
    )
    return (
        f'<g class="{classes}" data-key="{escape(key)}" {facts} tabindex="0"'
        f' transform="translate({place.x:.1f},{place.y:.1f})">'
        f"<title>{escape(title)}</title>{shape}<text>{spans}</text></g>"
    )


def edge_key(edge: Edge) -> str:
    """Return an edge's key, unique in the drawing."""
    return f"e:{edge.start_key}>{edge.end_key}#{edge.label}"


def _edge(edge: Edge, route: Route, points: list[tuple[float, float]], rate: str | None) -> str:
    way = -1 if route.is_backward else 1
    parts = [f'<path class="line" d="{_curve(points, edge)}"/>']
    parts.append(_head(points[-1], -1 if edge.start_key == edge.end_key else way))
    parts += [_head(points[0], -way)] if edge.is_both_ways else []
    if route.label is not None:
        x, y = route.label
        parts.append(f'<text x="{x:.1f}" y="{y - 6:.1f}">{escape(edge.label)}</text>')
    if rate is not None:
        x, y = (route.label[0], route.label[1] + 20) if route.label else _beside(edge, points)
        parts.append(f'<text class="rate" x="{x:.1f}" y="{y - 5:.1f}">{escape(rate)}</text>')
    return (
        f'<g class="edge{" wrong" if edge.is_wrong else ""}" data-key="{escape(edge_key(edge))}"'
        f' data-from="{escape(edge.start_key)}" data-to="{escape(edge.end_key)}"'
        f' data-topic="{escape(edge.topic)}" data-about="{escape(edge.kind.key(edge.topic))}">'
        f"{''.join(parts)}</g>"
    )


def _beside(edge: Edge, points: list[tuple[float, float]]) -> tuple[float, float]:
    """Return the position of a rate: the middle of the edge's segment next to a node."""
    (x, y), (next_x, next_y) = points[:2] if edge.is_publishing else points[-2:]
    return ((x + next_x) / 2, (y + next_y) / 2)


def _curve(points: list[tuple[float, float]], edge: Edge) -> str:
    shortened = list(points)
    inward = _HEAD - 2 if points[-2][0] <= points[-1][0] else 2 - _HEAD
    shortened[-1] = (points[-1][0] - inward, points[-1][1])
    if edge.is_both_ways:
        inward = _HEAD - 2 if points[1][0] >= points[0][0] else 2 - _HEAD
        shortened[0] = (points[0][0] + inward, points[0][1])
    (x, y), *_ = shortened
    parts = [f"M{x:.1f},{y:.1f}"]
    for (x0, y0), (x1, y1) in pairwise(shortened):
        bend = (x1 - x0) / 2
        parts.append(f"C{x0 + bend:.1f},{y0:.1f} {x1 - bend:.1f},{y1:.1f} {x1:.1f},{y1:.1f}")
    return " ".join(parts)


def _head(tip: tuple[float, float], way: int) -> str:
    x, y = tip
    back = x - way * _HEAD
    return f'<path class="head" d="M{x:.1f},{y:.1f} L{back:.1f},{y - 4.5:.1f} V{y + 4.5:.1f} Z"/>'


def _outline(frame: Frame) -> str:
    """Return the SVG path around a frame: along the tops of its slices, then along the bottoms."""
    upper = [(x, top) for left, top, right, _ in frame.slices for x in (left, right)]
    lower = [(x, low) for left, _, right, low in frame.slices[::-1] for x in (right, left)]
    corners = _without_repeats(upper + lower)
    return " ".join([*_rounded(corners), "Z"])


def _without_repeats(corners: list[tuple[float, float]]) -> list[tuple[float, float]]:
    """Return the corners without duplicates and without corners on a straight line."""
    kept = []
    for number, corner in enumerate(corners):
        before, after = corners[number - 1], corners[(number + 1) % len(corners)]
        is_straight = before[1] == corner[1] == after[1] or before[0] == corner[0] == after[0]
        if not is_straight and corner != before:
            kept.append(corner)
    return kept


def _rounded(corners: list[tuple[float, float]]) -> Iterator[str]:
    for number, corner in enumerate(corners):
        enter = _towards(corner, corners[number - 1])
        leave = _towards(corner, corners[(number + 1) % len(corners)])
        command = "L" if number else "M"
        yield f"{command}{enter[0]:.1f},{enter[1]:.1f}"
        yield f"Q{corner[0]:.1f},{corner[1]:.1f} {leave[0]:.1f},{leave[1]:.1f}"


def _towards(corner: tuple[float, float], other: tuple[float, float]) -> tuple[float, float]:
    """Return the end of a corner's rounding, on the line from this corner to another corner."""
    dx, dy = other[0] - corner[0], other[1] - corner[1]
    length = abs(dx) + abs(dy)
    part = min(10.0, length / 2) / length if length else 0.0
    return (corner[0] + dx * part, corner[1] + dy * part)
