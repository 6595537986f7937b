"""Measure how far items of a graph move when one node comes, with zbot's layout and with graphlay.

Run: pip install graphlay
     python -m benchmarks.graph_layout
"""

from __future__ import annotations

import math
import random
import statistics
from itertools import combinations
from typing import TYPE_CHECKING, Any

import graphlay  # pyright: ignore[reportMissingImports] - not needed for other benchmarks

from zbot.graph.layout import Item, Link, lay_out

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    Places = dict[str, tuple[float, float]]
    Graph = tuple[list[Item], list[Link]]

GRAPHS = 120
MOVED = 5.0  # px: a smaller movement is not noticed


def first_graph(rng: random.Random) -> Graph:
    """Return as many nodes as topics. A topic has one publisher and up to two subscribers."""
    size = rng.choice((4, 6, 10, 15))
    items = [Item(f"n{number}", 140, 46) for number in range(size)]
    items += [Item(f"t{number}", 120, 34) for number in range(size)]
    links = [Link(f"n{rng.randrange(size)}", f"t{number}") for number in range(size)]
    for number in range(size):
        readers = rng.choice((0, 1, 1, 2))
        links += [Link(f"t{number}", f"n{rng.randrange(size)}") for _ in range(readers)]
    return items, list(dict.fromkeys(links))


def next_graph(rng: random.Random, items: list[Item], links: list[Link]) -> Graph:
    """Add a node that subscribes to an old topic, and publishes on a new topic for an old node."""
    size = len(items) // 2
    node, topic = Item(f"n{size}", 140, 46), Item(f"t{size}", 120, 34)
    arrows = [(f"t{rng.randrange(size)}", node.key), (node.key, topic.key)]
    arrows.append((topic.key, f"n{rng.randrange(size)}"))
    return [*items, node, topic], links + [Link(start, end) for start, end in arrows]


def ours(before: Graph, after: Graph) -> tuple[Places, Places, float]:
    old = lay_out(*before)
    new = lay_out(*after, old)
    places = [
        {key: (place.x, place.y) for key, place in each.places.items()} for each in (old, new)
    ]
    return places[0], places[1], new.crossings


def graphlays(**fields: Any) -> Callable[[Graph, Graph], tuple[Places, Places, float]]:
    def measure(before: Graph, after: Graph) -> tuple[Places, Places, float]:
        old = _layout(before, {}, {}).positions()
        new = _layout(after, old, fields)
        return old, new.positions(), new.metrics()["crossings"]

    return measure


def _layout(graph: Graph, known: Places, fields: dict[str, Any]) -> Any:
    request = graphlay.Graph()
    for item in graph[0]:
        extra = {}
        if fields and item.key in known:
            x, y = known[item.key]
            extra = {"position": {"x": x, "y": y}, **fields}
        request.node(item.key, width=item.width, height=item.height, **extra)
    for link in graph[1]:
        request.edge(link.start, link.end)
    return graphlay.layout(request)


def overlap(items: Sequence[Item], places: Places) -> bool:
    for one, other in combinations(items, 2):
        dx, dy = (abs(a - b) for a, b in zip(places[one.key], places[other.key], strict=True))
        if dx < (one.width + other.width) / 2 - 1 and dy < (one.height + other.height) / 2 - 1:
            return True
    return False


def main() -> None:
    rng = random.Random(4)
    graphs = []
    for _ in range(GRAPHS):
        before = first_graph(rng)
        graphs.append((before, next_graph(rng, *before)))
    for name, measure in (
        ("zbot", ours),
        ("graphlay with old positions", graphlays(pinned=False)),
        ("graphlay with old items pinned", graphlays(pinned=True)),
    ):
        moved, crossings, overlapping = [], [], 0
        for before, after in graphs:
            old, new, count = measure(before, after)
            far = [math.dist(old[key], new[key]) > MOVED for key in old]
            moved.append(sum(far) / len(far))
            crossings.append(count)
            overlapping += overlap(after[0], new)
        print(
            f"{name}: {statistics.mean(moved):.0%} of the old items moved, "
            f"{overlapping} of {GRAPHS} graphs with overlapping items, "
            f"{statistics.mean(crossings):.1f} crossings"
        )


if __name__ == "__main__":
    main()
