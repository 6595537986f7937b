"""Layout of items and links. It is new or based on the previous layout."""

from __future__ import annotations

from dataclasses import replace
from statistics import median
from typing import TYPE_CHECKING

from zbot.graph.layout.coordinates import column_bounds, y_coordinates
from zbot.graph.layout.frames import frame_outlines
from zbot.graph.layout.geometry import Layout, Place
from zbot.graph.layout.layered_graph import LayeredGraph
from zbot.graph.layout.ordering import order_around, reduce_crossings
from zbot.graph.layout.routing import route_links

if TYPE_CHECKING:
    from collections.abc import Sequence

    from zbot.graph.layout.geometry import Item, Link

_COLUMN_GAP = 96.0  # space for the text of a rate beside an arrow
_ENOUGH_KNOWN = 0.5  # with a smaller share of old items, the layout is new
_BEARABLE = 4  # a layout that keeps places may have up to 4 + 2n crossings if a new one has n


def lay_out(items: Sequence[Item], links: Sequence[Link], previous: Layout | None = None) -> Layout:
    """Return the layout of a graph.

    Equal arguments give equal layouts. Links point right, but each cycle has a link that points
    left.
    Items do not overlap, and a frame contains only its own items.

    Args:
        items: The boxes, which have unique keys.
        links: The arrows between items. They contain the keys of the items.
        previous: The layout on the screen. Its items stay in place or move a little, unless most
            items are new or too many links would cross.
    """
    if not items:
        return Layout({}, (), (), {}, 0, 0)
    if previous is None or not _is_known(items, previous):
        return _aligned(_laid_out(items, links, None), previous)
    kept = replace(_laid_out(items, links, previous), best=previous.best)
    if kept.crossings <= _BEARABLE + 2 * kept.best:
        return kept
    new = _laid_out(items, links, None)
    if kept.crossings <= _BEARABLE + 2 * new.crossings:
        return replace(kept, best=new.crossings)
    return _aligned(new, previous)


def _is_known(items: Sequence[Item], previous: Layout) -> bool:
    known = sum(item.key in previous.places for item in items)
    return known >= _ENOUGH_KNOWN * len(items)


def _laid_out(items: Sequence[Item], links: Sequence[Link], previous: Layout | None) -> Layout:
    before = previous.places if previous else {}
    graph = LayeredGraph(items, links, {key: one.layer for key, one in before.items()})
    fixed = {v: before[one.key].y for v, one in enumerate(items) if one.key in before}
    crossings = order_around(graph, fixed) if fixed else reduce_crossings(graph)
    y = y_coordinates(graph, fixed)
    spans = column_bounds(graph, previous.columns if previous else {}, _COLUMN_GAP)
    places = {}
    for vertex, item in enumerate(items):
        left, right = spans[graph.layer[vertex]]
        x = (left + right) / 2
        places[item.key] = Place(x, y[vertex], item.width, item.height, graph.layer[vertex])
    found = route_links(graph, y, spans, [places[item.key] for item in items])
    return Layout(places, found, frame_outlines(graph, y, spans), spans, crossings, crossings)


def _aligned(new: Layout, previous: Layout | None) -> Layout:
    """Return a new layout, moved as a whole so that old items are near their old places."""
    shared = [key for key in new.places if previous and key in previous.places]
    if previous is None or not shared:
        return new
    dx = median(previous.places[key].x - new.places[key].x for key in shared)
    dy = median(previous.places[key].y - new.places[key].y for key in shared)
    return new.moved(dx, dy)
