"""Plan of a world: its walls and things, and where the first robot starts."""

from __future__ import annotations

import itertools
import math
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Literal

from zbot.simulation.engine import engine, new_spec

if TYPE_CHECKING:
    from collections.abc import Iterable

Rgba = tuple[float, float, float, float]

WALL: Rgba = (0.75, 0.72, 0.66, 1.0)
WOOD: Rgba = (0.62, 0.44, 0.26, 1.0)
FLOOR: Rgba = (0.45, 0.47, 0.5, 1.0)
WALL_HEIGHT_M, WALL_WIDTH_M = 0.6, 0.1


@dataclass(frozen=True)
class Place:
    """Place of a robot on the floor."""

    x: float = 0.0  #: metres
    y: float = 0.0  #: metres
    yaw: float = 0.0  #: radians, counter-clockwise from the x axis


@dataclass(frozen=True)
class Thing:
    """Solid that stands on the floor. Lengths are in metres, masses in kg."""

    kind: Literal["box", "cylinder"]
    place: Place
    size: tuple[float, float, float]  #: along x, y and z. A cylinder has the diameter twice.
    color: Rgba = WALL
    mass: float = 0.0  #: 0 for a thing that nothing moves
    name: str = ""


@dataclass
class Plan:
    """World that consists of things on a floor."""

    things: list[Thing] = field(default_factory=list)
    start: Place = field(default_factory=Place)
    places: dict[str, Place] = field(default_factory=dict)  #: where programs can be sent, by name

    def wall(self, *corners: tuple[float, float], height: float = WALL_HEIGHT_M) -> None:
        """Add a wall along the lines between corners."""
        for (x1, y1), (x2, y2) in itertools.pairwise(corners):
            middle = Place((x1 + x2) / 2, (y1 + y2) / 2, math.atan2(y2 - y1, x2 - x1))
            # Walls overlap in their corners, so that there is no gap.
            length = math.hypot(x2 - x1, y2 - y1) + WALL_WIDTH_M
            self.things.append(Thing("box", middle, (length, WALL_WIDTH_M, height)))

    def room(self, left: float, bottom: float, right: float, top: float) -> None:
        """Add four walls whose inner sides are at these coordinates."""
        half = WALL_WIDTH_M / 2
        low, high = (left - half, bottom - half), (right + half, top + half)
        self.wall(low, (high[0], low[1]), high, (low[0], high[1]), low)

    def box(
        self,
        x: float,
        y: float,
        size: tuple[float, float, float],
        *,
        yaw: float = 0.0,
        mass: float = 0.0,
        name: str = "",
    ) -> None:
        """Add a box of wood with its middle at (x, y). With a mass, robots can push it."""
        self.things.append(Thing("box", Place(x, y, yaw), size, WOOD, mass, name))

    def pillar(self, x: float, y: float, diameter: float, height: float = WALL_HEIGHT_M) -> None:
        """Add a round pillar."""
        self.things.append(Thing("cylinder", Place(x, y), (diameter, diameter, height)))

    def spec(self) -> Any:
        """Return the world as an `MjSpec`."""
        spec = new_spec()
        add_floor(spec)
        add_things(spec, self.things)
        return spec


def add_floor(spec: Any) -> None:
    """Add an endless floor at the height 0."""
    spec.worldbody.add_geom(
        name="floor", type=engine().mjtGeom.mjGEOM_PLANE, size=(0, 0, 1), rgba=FLOOR
    )


def add_things(spec: Any, things: Iterable[Thing]) -> None:
    """Add things to a world. Each thing that can move is a body of its own."""
    kinds = engine().mjtGeom
    for thing in things:
        x, y, z = (part / 2 for part in thing.size)
        shape = {
            "type": kinds.mjGEOM_BOX if thing.kind == "box" else kinds.mjGEOM_CYLINDER,
            "size": (x, y, z) if thing.kind == "box" else (x, z, 0),
            "rgba": thing.color,
        }
        pose = {
            "pos": (thing.place.x, thing.place.y, z),
            "quat": (math.cos(thing.place.yaw / 2), 0, 0, math.sin(thing.place.yaw / 2)),
        }
        if thing.mass:
            body = spec.worldbody.add_body(name=thing.name, **pose)
            body.add_freejoint()
            body.add_geom(mass=thing.mass, **shape)
        else:
            spec.worldbody.add_geom(**shape, **pose)
