"""World in SDF: what never moves becomes solids, and all other models become bodies."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from zbot.libraries.robot_description.file import read_description
from zbot.libraries.robot_description.xml_text import DescriptionError
from zbot.simulation.engine import engine, new_spec
from zbot.simulation.errors import SimulationError
from zbot.simulation.robots.bodies import add_bodies, placed, shape_of
from zbot.simulation.robots.equipment import Equipment
from zbot.simulation.robots.model import GazeboPlace
from zbot.simulation.sdf.document import Document
from zbot.simulation.sdf.frames import Frames
from zbot.simulation.sdf.heightmap import add_heightmap
from zbot.simulation.sdf.model import read_model, trees
from zbot.simulation.sdf.notices import add_notices
from zbot.simulation.sdf.robot import equipment_of
from zbot.simulation.sdf.static_mesh import add_static_mesh
from zbot.simulation.sdf.tree import tree_model
from zbot.simulation.sdf.values import number_of, text_of, vector_of
from zbot.simulation.worlds.plan import FLOOR, add_floor

if TYPE_CHECKING:
    from pathlib import Path
    from xml.etree.ElementTree import Element

    from zbot.libraries.robot_description.appearance import Solid
    from zbot.simulation.sdf.model import SdfLink, SdfModel
    from zbot.tf2.rigid import Rigid, Vector

_MOST_MODELS, _MOST_SOLIDS, _MOST_GRAVITY = 2000, 20_000, 1000.0
#: Of a model that moves.
_MOST_LINKS, _MOST_JOINTS = 2000, 4000
#: What a heightmap counts as.
_SOLIDS_OF_HILLS = 1000
#: Tags of a world that say how it looks or how another engine computes. They have no effect.
_SILENT = frozenset(
    {
        *("model", "light", "physics", "scene", "gui", "plugin", "gravity", "magnetic_field"),
        *("atmosphere", "spherical_coordinates", "audio", "state", "frame", "wind", "include"),
    }
)


class Entity(NamedTuple):
    """Model with sensors or plugins, as robots have."""

    name: str
    model: SdfModel
    pose: Rigid


@dataclass
class SdfWorld:
    """World that a file in SDF describes."""

    name: str
    spec: Any  #: an `MjSpec` with everything that has no sensors and no plugins
    entities: list[Entity] = field(default_factory=list)
    plugins: list[Element] = field(default_factory=list)
    notices: list[str] = field(default_factory=list)
    earth: Vector | None = None  #: latitude, longitude and altitude of its origin


def sdf_world(path: Path) -> SdfWorld:
    """Return the world in a file.

    Raises:
        SimulationError: The file is not a world in SDF, or the world is too large.
    """
    try:
        document = Document(read_description(path), path.parent)
        return read_world(document)
    except DescriptionError as error:
        raise SimulationError(f"{path} is not a world in SDF: {error.reason}") from error


def read_world(document: Document) -> SdfWorld:
    """Return the world of a document. A document with a model only is a world with this model.

    Raises:
        SimulationError: The world is too large.
        DescriptionError: A value is not valid.
    """
    root = document.root.find("world")
    if root is None:
        root = document.root
    world = SdfWorld(root.get("name", "default"), new_spec(), notices=document.notices)
    world.spec.option.gravity = _gravity(root)
    world.plugins = root.findall("plugin")
    world.earth = _earth(root)
    builder = _Builder(world, document.root.get("version", ""))
    has_gaps = bool(document.notices)
    models, frames = root.findall("model"), Frames(root)
    if len(models) > _MOST_MODELS:
        raise SimulationError(f"the world has {len(models)} models: the limit is {_MOST_MODELS}")
    for element in models:
        model = read_model(element, document.root.get("version", ""))
        builder.add(model, frames.pose(element.get("name", "")) @ model.offset)
    if has_gaps:
        builder.replace_ground()
    for tag in sorted({child.tag for child in root} - _SILENT):
        builder.note(f"<{tag[:40]}>" + (f" '{text_of(root, tag)[:40]}'" if tag == "uri" else ""))
    return world


def _check_size(model: SdfModel) -> None:
    # Each part of a model that moves is made from all of its joints.
    for count, most, what in (
        (len(model.links), _MOST_LINKS, "links"),
        (len(model.joints), _MOST_JOINTS, "joints"),
    ):
        if count > most:
            raise SimulationError(
                f"the model '{model.name[:60]}' has {count} {what}: the limit is {most}"
            )


def _earth(root: Element) -> Vector | None:
    element = root.find("spherical_coordinates")
    if element is None:
        return None
    latitude = number_of(element, "latitude_deg", 0.0)
    longitude = number_of(element, "longitude_deg", 0.0)
    if abs(latitude) >= 90 or abs(longitude) > 180:
        raise DescriptionError("<spherical_coordinates> is not a place on the Earth")
    return (latitude, longitude, number_of(element, "elevation", 0.0))


def _gravity(root: Element) -> Vector:
    found = vector_of(root, "gravity", (0.0, 0.0, -9.8))
    if max(map(abs, found)) > _MOST_GRAVITY:
        raise SimulationError(f"<gravity> is above {_MOST_GRAVITY:g} m/s^2")
    return found


class _Builder:
    """Builder of the bodies of a world."""

    def __init__(self, world: SdfWorld, version: str) -> None:
        self._world, self._version = world, version
        self._names: set[str] = set()
        self._numbers: dict[str, int] = {}  # the next number of each name that is used again
        self._solids = 0

    def note(self, *notices: str) -> None:
        """Keep what is left out, once each."""
        add_notices(self._world.notices, notices)

    def add(self, model: SdfModel, pose: Rigid) -> None:
        """Add a model at a pose."""
        model.name = self._free(model.name)
        if model.acts and self._has_use(model):
            self._world.entities.append(Entity(model.name, model, pose))
            return
        if model.is_static:
            for link in model.links.values():
                self._add_static(f"{model.name}/{link.name}", link, pose @ link.pose)
        else:
            _check_size(model)
            for number, links in enumerate(trees(model)):
                self._add_thing(model, links, pose, number)
        self.note(*model.notices)

    def replace_ground(self) -> None:
        """Add a floor if nothing is there that a robot can stand on."""
        solids = self._world.spec.worldbody.geoms
        if not any(solid.contype or solid.conaffinity for solid in solids):
            add_floor(self._world.spec)
            self.note("its ground, which a flat floor replaces,")

    def _has_use(self, model: SdfModel) -> bool:
        """Return whether the simulator has one of the sensors or plugins of a model."""
        place = GazeboPlace(model.name, self._world.name)
        found = equipment_of(model, place, next(iter(model.links), ""))
        if replace(found, notices=()) == Equipment():
            self.note(*found.notices)
            return False
        return True

    def _free(self, name: str) -> str:
        free, number = name, self._numbers.get(name, 0)
        while free in self._names:
            free = f"{name}_{number}"
            number += 1
        self._numbers[name] = number
        self._names.add(free)
        return free

    def _add_thing(self, model: SdfModel, links: list[str], pose: Rigid, number: int) -> None:
        """Add bodies that move. The first part of a model has the name of the model."""
        body, root = tree_model(model, links)
        name = f"{model.name}_part{number}" if number else model.name
        if not any(model.links[link].shapes.solids for link in links):
            return
        self._count(sum(len(solids) for solids in body.solids.values()))
        self.note(*add_bodies(self._world.spec, f"{name}/", body, pose @ root, None))

    def _add_static(self, name: str, link: SdfLink, pose: Rigid) -> None:
        spec = self._world.spec
        friction = 0.6 if link.friction is None else min(max(link.friction, 0.0), 2.0)
        usual = {"friction": (max(friction, 1e-4), 0.005, 0.0001)}
        self._count(len(link.shapes.solids) + len(link.seen) + len(link.shapes.planes))
        for number, hills in enumerate(link.shapes.hills):
            self._count(_SOLIDS_OF_HILLS)
            ground, middle = add_heightmap(spec, f"{name}#h{number}", hills)
            ground |= {"name": f"{name}#h{number}", "rgba": FLOOR, **placed(pose @ middle)}
            spec.worldbody.add_geom(**ground, **usual)
        for number, plane in enumerate(link.shapes.planes):
            kind = engine().mjtGeom.mjGEOM_PLANE
            at = placed(pose @ plane)
            floor = {"type": kind, "size": (0, 0, 1), "rgba": FLOOR}
            spec.worldbody.add_geom(name=f"{name}#p{number}", **floor, **at, **usual)
        for number, solid in enumerate(link.shapes.solids):
            self._add_solid(f"{name}#{number}", solid, pose, usual)
        for number, solid in enumerate(link.seen):
            self._add_solid(f"{name}#v{number}", solid, pose, {"contype": 0, "conaffinity": 0})

    def _add_solid(self, name: str, solid: Solid, pose: Rigid, usual: dict[str, Any]) -> None:
        spec, at = self._world.spec, placed(pose @ solid.origin)
        color = {"rgba": np.array(solid.color or FLOOR)}
        if solid.kind == "mesh":
            found = add_static_mesh(spec, solid)
            if isinstance(found, str):
                self.note(found)
                return
            self._count(len(found))
            for number, mesh in enumerate(found):
                kind = engine().mjtGeom.mjGEOM_MESH
                one = {"name": f"{name}.{number}", "type": kind, "meshname": mesh}
                spec.worldbody.add_geom(**one, **color, **at, **usual)
            return
        shape = shape_of(spec, solid)
        if isinstance(shape, str):
            self.note(shape)
        else:
            spec.worldbody.add_geom(name=name, **shape, **color, **at, **usual)

    def _count(self, more: int) -> None:
        self._solids += more
        if self._solids > _MOST_SOLIDS:
            raise SimulationError(f"the world needs more than {_MOST_SOLIDS} solids")
