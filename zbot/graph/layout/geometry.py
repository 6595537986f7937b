"""What is laid out, and what comes of it. All lengths are pixels; y points down."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property
from typing import TypeAlias

Point: TypeAlias = tuple[float, float]


@dataclass(frozen=True)
class Item:
    """Something with a place of its own."""

    key: str
    width: float
    height: float
    frames: tuple[str, ...] = ()  #: the frames around it, the outermost first


@dataclass(frozen=True)
class Link:
    """An arrow between two items; several may join the same two."""

    start: str
    end: str
    label_width: float = 0.0  #: of a label that needs a place of its own, 0 for none


@dataclass(frozen=True)
class Place:
    """Where an item is."""

    x: float  #: of its middle
    y: float  #: of its middle
    width: float
    height: float
    layer: int

    @property
    def left(self) -> float:
        """X of its left side."""
        return self.x - self.width / 2

    @property
    def right(self) -> float:
        """X of its right side."""
        return self.x + self.width / 2

    @property
    def top(self) -> float:
        """Y of its upper side."""
        return self.y - self.height / 2

    @property
    def bottom(self) -> float:
        """Y of its lower side."""
        return self.y + self.height / 2


@dataclass(frozen=True)
class Route:
    """The way of a link: straight where it passes a layer, curved between two."""

    points: tuple[Point, ...]  #: from start to end; the first and the last touch the items' boxes
    label: Point | None = None  #: the middle of its label
    is_backward: bool = False  #: whether it points left, as one link of each circle has to

    def moved(self, dx: float, dy: float) -> Route:
        """Return it moved as a whole."""
        label = None if self.label is None else (self.label[0] + dx, self.label[1] + dy)
        return Route(tuple((x + dx, y + dy) for x, y in self.points), label, self.is_backward)


@dataclass(frozen=True)
class Frame:
    """A part of a frame: items of one layer, or of neighbouring layers, that belong together."""

    name: str
    depth: int  #: 0 for an outermost frame
    slices: tuple[tuple[float, float, float, float], ...]  #: left, top, right, bottom of each layer

    def moved(self, dx: float, dy: float) -> Frame:
        """Return it moved as a whole."""
        slices = (
            (left + dx, top + dy, right + dx, low + dy) for left, top, right, low in self.slices
        )
        return Frame(self.name, self.depth, tuple(slices))


@dataclass(frozen=True)
class Layout:
    """Where everything is."""

    places: dict[str, Place]
    routes: tuple[Route, ...]  #: in the order of the links
    frames: tuple[Frame, ...]  #: outer ones before those inside
    columns: dict[int, tuple[float, float]]  #: left and right of each layer
    crossings: int  #: how often links cross
    best: int  #: how often they crossed when all of it was laid out anew

    def moved(self, dx: float, dy: float) -> Layout:
        """Return it moved as a whole."""
        return Layout(
            {key: replace(one, x=one.x + dx, y=one.y + dy) for key, one in self.places.items()},
            tuple(route.moved(dx, dy) for route in self.routes),
            tuple(frame.moved(dx, dy) for frame in self.frames),
            {layer: (left + dx, right + dx) for layer, (left, right) in self.columns.items()},
            self.crossings,
            self.best,
        )

    @cached_property
    def bounds(self) -> tuple[float, float, float, float]:
        """Left, top, right and bottom of everything; all 0 if there is nothing."""
        spots = [(x, y, x, y) for route in self.routes for x, y in route.points]
        spots += [(one.left, one.top, one.right, one.bottom) for one in self.places.values()]
        spots += [one for frame in self.frames for one in frame.slices]
        if not spots:
            return (0.0, 0.0, 0.0, 0.0)
        lefts, tops, rights, bottoms = zip(*spots, strict=True)
        return (min(lefts), min(tops), max(rights), max(bottoms))
