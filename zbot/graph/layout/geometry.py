"""Input and result of the layout, in pixels. The y axis points down."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property
from typing import TypeAlias

Point: TypeAlias = tuple[float, float]


@dataclass(frozen=True)
class Item:
    """Box of a node or topic, which the layout places."""

    key: str
    width: float
    height: float
    frames: tuple[str, ...] = ()  #: the frames around the item, the outermost first


@dataclass(frozen=True)
class Link:
    """Arrow between two items. Two items may have several links."""

    start: str
    end: str
    label_width: float = 0.0  #: 0 if there is no label


@dataclass(frozen=True)
class Place:
    """Position, size and layer of an item."""

    x: float  #: x of the middle
    y: float  #: y of the middle
    width: float
    height: float
    layer: int

    @property
    def left(self) -> float:
        """X of the left side."""
        return self.x - self.width / 2

    @property
    def right(self) -> float:
        """X of the right side."""
        return self.x + self.width / 2

    @property
    def top(self) -> float:
        """Y of the upper side."""
        return self.y - self.height / 2

    @property
    def bottom(self) -> float:
        """Y of the lower side."""
        return self.y + self.height / 2


@dataclass(frozen=True)
class Route:
    """Path of a link. It is straight inside a layer and curved between two layers."""

    points: tuple[Point, ...]  #: from start to end; the first and the last point touch the boxes
    label: Point | None = None  #: the middle of the link's label
    is_backward: bool = False  #: whether the link points left; each cycle has such a link

    def moved(self, dx: float, dy: float) -> Route:
        """Return a moved copy."""
        label = None if self.label is None else (self.label[0] + dx, self.label[1] + dy)
        return Route(tuple((x + dx, y + dy) for x, y in self.points), label, self.is_backward)


@dataclass(frozen=True)
class Frame:
    """Part of a frame around items in one layer or in neighbouring layers."""

    name: str
    depth: int  #: 0 for an outermost frame
    slices: tuple[tuple[float, float, float, float], ...]  #: left, top, right, bottom in each layer

    def moved(self, dx: float, dy: float) -> Frame:
        """Return a moved copy."""
        slices = (
            (left + dx, top + dy, right + dx, low + dy) for left, top, right, low in self.slices
        )
        return Frame(self.name, self.depth, tuple(slices))


@dataclass(frozen=True)
class Layout:
    """Layout with the places of all items, the routes of all links, and the frames."""

    places: dict[str, Place]
    routes: tuple[Route, ...]  #: in the order of the links
    frames: tuple[Frame, ...]  #: outer frames before inner ones
    columns: dict[int, tuple[float, float]]  #: left and right of each layer
    crossings: int  #: the number of crossings of links
    best: int  #: the number of crossings in the last new layout (see `lay_out`)

    def moved(self, dx: float, dy: float) -> Layout:
        """Return a moved copy."""
        return Layout(
            {
                key: replace(place, x=place.x + dx, y=place.y + dy)
                for key, place in self.places.items()
            },
            tuple(route.moved(dx, dy) for route in self.routes),
            tuple(frame.moved(dx, dy) for frame in self.frames),
            {layer: (left + dx, right + dx) for layer, (left, right) in self.columns.items()},
            self.crossings,
            self.best,
        )

    @cached_property
    def bounds(self) -> tuple[float, float, float, float]:
        """Left, top, right and bottom of the whole layout. They are 0 if the layout is empty."""
        spots = [(x, y, x, y) for route in self.routes for x, y in route.points]
        spots += [
            (place.left, place.top, place.right, place.bottom) for place in self.places.values()
        ]
        spots += [spot for frame in self.frames for spot in frame.slices]
        if not spots:
            return (0.0, 0.0, 0.0, 0.0)
        lefts, tops, rights, bottoms = zip(*spots, strict=True)
        return (min(lefts), min(tops), max(rights), max(bottoms))
