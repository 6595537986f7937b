"""From items and links to a layout, new or around the one before."""

from __future__ import annotations

from dataclasses import replace
from statistics import median
from typing import TYPE_CHECKING

from zbot.graph.layout.frames import frames
from zbot.graph.layout.graph import Layout, Place
from zbot.graph.layout.net import Net
from zbot.graph.layout.order import order, order_around
from zbot.graph.layout.place import columns, place
from zbot.graph.layout.routes import routes

if TYPE_CHECKING:
    from collections.abc import Sequence

    from zbot.graph.layout.graph import Item, Link

_COLUMN_GAP = 96.0  # room for a rate beside an arrow
_ENOUGH_KNOWN = 0.5  # of the items: with fewer, there is no picture yet to stay true to
_BEARABLE = 4  # crossings that staying in place may cost, and twice what a new layout has


def lay_out(items: Sequence[Item], links: Sequence[Link], previous: Layout | None = None) -> Layout:
    """Return where everything goes.

    Equal arguments give equal layouts. Links point right, but for one of each circle; no item lies
    on another, nor in a frame that is not around it.

    Args:
        items: What has a place; keys are unique.
        links: What joins them, by their keys.
        previous: What was on the screen: items in it stay where they are, or move a little, unless
            most are new or the links would become a tangle.
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
    net = Net(items, links, {key: one.layer for key, one in before.items()})
    fixed = {v: before[one.key].y for v, one in enumerate(items) if one.key in before}
    crossings = order_around(net, fixed) if fixed else order(net)
    y = place(net, fixed)
    spans = columns(net, previous.columns if previous else {}, _COLUMN_GAP)
    places = {}
    for vertex, item in enumerate(items):
        left, right = spans[net.layer[vertex]]
        x = (left + right) / 2
        places[item.key] = Place(x, y[vertex], item.width, item.height, net.layer[vertex])
    found = routes(net, y, spans, [places[item.key] for item in items])
    return Layout(places, found, frames(net, y, spans), spans, crossings, crossings)


def _aligned(new: Layout, previous: Layout | None) -> Layout:
    """Move a new layout as a whole so that what was on the screen jumps less."""
    shared = [key for key in new.places if previous and key in previous.places]
    if previous is None or not shared:
        return new
    dx = median(previous.places[key].x - new.places[key].x for key in shared)
    dy = median(previous.places[key].y - new.places[key].y for key in shared)
    return new.moved(dx, dy)
