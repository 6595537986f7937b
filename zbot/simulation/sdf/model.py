"""SDF model: its links, its joints and its plugins, with all frames resolved."""

from __future__ import annotations

import math
import re
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from zbot.libraries.robot_description.inertia import Inertia
from zbot.libraries.robot_description.xml_text import DescriptionError
from zbot.simulation.gazebo.unused import unused_notice, unused_tags
from zbot.simulation.sdf.frames import Frames
from zbot.simulation.sdf.geometry import Shapes, shapes_of, visual_color
from zbot.simulation.sdf.notices import add_notices
from zbot.simulation.sdf.values import flag_of, number_of, pose_of, text_of, vector_of
from zbot.tf2.rigid import Rigid, Vector, rotate

if TYPE_CHECKING:
    from collections.abc import Iterator
    from xml.etree.ElementTree import Element

    from zbot.libraries.robot_description.appearance import Solid

_MOMENTS = ("ixx", "iyy", "izz", "ixy", "ixz", "iyz")
#: Gazebo's inertia of a link that has no `<inertial>`.
USUAL_INERTIA = Inertia(1.0, Rigid(), (1.0, 1.0, 1.0, 0.0, 0.0, 0.0))
_TYPES = frozenset({"fixed", "revolute", "continuous", "prismatic", "ball"})
#: Limits above this mean that there is no limit.
_ENDLESS = 1e6


@dataclass
class SdfLink:
    """Link of an SDF model."""

    name: str
    pose: Rigid  #: in the model
    inertia: Inertia | None
    shapes: Shapes  #: what it collides with
    seen: list[Solid]  #: its visuals
    friction: float | None
    sensors: list[Element] = field(default_factory=list)


@dataclass
class SdfJoint:
    """Joint of an SDF model. Its frame is where the joint turns."""

    name: str
    type: str
    parent: str  #: a link, or `world`
    child: str
    pose: Rigid  #: in the model
    axis: Vector
    lower: float = 0.0
    upper: float = 0.0
    effort: float = math.inf
    damping: float = 0.0
    friction: float = 0.0


@dataclass
class SdfModel:
    """SDF model. The models in it are parts of it; their links have names such as `arm::hand`."""

    name: str
    is_static: bool
    offset: Rigid  #: from the frame whose pose is given to the model's own frame
    links: dict[str, SdfLink] = field(default_factory=dict)
    joints: dict[str, SdfJoint] = field(default_factory=dict)
    plugins: list[Element] = field(default_factory=list)
    notices: list[str] = field(default_factory=list)

    @property
    def acts(self) -> bool:
        """Whether the model has sensors or plugins, as robots have."""
        return bool(self.plugins) or any(link.sensors for link in self.links.values())


def read_model(element: Element, version: str = "") -> SdfModel:
    """Return the model in a `<model>` without includes.

    Args:
        element: The element.
        version: The version of SDF.

    Raises:
        DescriptionError: A name, a number or a frame is not valid.
    """
    frames = Frames(element)
    placed = element.get("placement_frame", "")
    offset = frames.pose(placed).inverse() if placed else Rigid()
    is_static = any(flag_of(model, "static") for model in element.iter("model"))
    model = SdfModel(element.get("name", "model"), is_static, offset)
    _Reader(model, frames, element.get("version", version)).read(element, "")
    model.notices += unused_notice(unused_tags(element))
    return model


class _Reader:
    """Reader of one model and the models in it."""

    def __init__(self, model: SdfModel, frames: Frames, version: str) -> None:
        self._model, self._frames = model, frames
        self._first_links: dict[str, str] = {}  # by the text before their names, e.g. `arm::`
        self._is_old = version in {"1.0", "1.2", "1.3", "1.4"}

    def read(self, element: Element, scope: str) -> None:
        """Add what a model contains. The scope is the text before its names."""
        for link in element.findall("link"):
            name = scope + _name(link)
            if name in self._model.links:
                raise DescriptionError(f"two links have the name '{name[:60]}'")
            self._model.links[name] = self._link(link, name)
            for place in re.finditer("::", name):
                self._first_links.setdefault(name[: place.end()], name)
        for inner in element.findall("model"):
            self.read(inner, f"{scope}{_name(inner)}::")
        for joint in element.findall("joint"):
            self._add_joint(joint, scope)
        self._model.plugins += element.findall("plugin")

    def _link(self, element: Element, name: str) -> SdfLink:
        color = visual_color(element.find("visual"))
        shapes = Shapes([], [], [], [])
        friction = None
        for collision in element.findall("collision"):
            part = shapes_of(collision, color)
            shapes.solids.extend(part.solids)
            shapes.planes.extend(part.planes)
            shapes.hills.extend(part.hills)
            shapes.notices.extend(part.notices)
            surface = collision.find("surface/friction")
            mu = _first_number(surface, "ode/mu", "bullet/friction", "torsional/coefficient")
            friction = mu if mu is not None else friction
        seen = []
        if not shapes.solids and not shapes.planes:
            for visual in element.findall("visual"):
                found = shapes_of(visual, visual_color(visual))
                seen += found.solids
                shapes.notices.extend(found.notices)
        self._note(*shapes.notices)
        sensors = element.findall("sensor")
        pose = self._frames.pose(name)
        # What never moves needs no mass. Files often have bad values there.
        inertia = None if self._model.is_static else _inertia(element)
        return SdfLink(name, pose, inertia, shapes, seen, friction, sensors)

    def _add_joint(self, element: Element, scope: str) -> None:
        name, type_ = scope + _name(element), element.get("type", "")
        if type_ not in _TYPES:
            self._note(f"a joint of the type '{type_[:40]}', which is fixed here,")
            type_ = "fixed"
        parent, child = (self._linked(text_of(element, tag), scope) for tag in ("parent", "child"))
        if not parent or not child or child in {"world", parent}:
            self._note(f"the joint '{name[:60]}', which does not connect two links,")
            return
        pose = self._frames.pose(name)
        axis = self._axis(element.find("axis"), pose, scope)
        joint = SdfJoint(name, type_, parent, child, pose, axis)
        _set_limits(joint, element.find("axis"))
        self._model.joints[name] = joint

    def _linked(self, name: str, scope: str) -> str:
        """Return the whole name of a link that a joint names, or an empty text."""
        if name == "world":
            return name
        known = (name_ for name_ in (scope + name, name) if name_ in self._model.links)
        found = next(known, "")
        # A joint may name a nested model: this means the model's first link.
        return found or self._first_links.get(f"{scope}{name}::", "")

    def _axis(self, axis: Element | None, pose: Rigid, scope: str) -> Vector:
        """Return the axis in the frame of the joint."""
        xyz = vector_of(axis, "xyz", (0.0, 0.0, 1.0))
        element = None if axis is None else axis.find("xyz")
        frame = "" if element is None else element.get("expressed_in", "")
        if flag_of(axis, "use_parent_model_frame", self._is_old):
            xyz = rotate(pose.inverse().rotation, xyz)
        elif frame:
            given = self._frames.pose("" if frame == "__model__" else scope + frame)
            xyz = rotate((pose.inverse() @ given).rotation, xyz)
        length = math.hypot(*xyz)
        x, y, z = (part / (length or 1.0) for part in xyz)
        return (x, y, z)

    def _note(self, *notices: str) -> None:
        add_notices(self._model.notices, notices)


def _name(element: Element) -> str:
    name = element.get("name", "").strip()
    if not name:
        raise DescriptionError(f"a <{element.tag}> has no name")
    return name


def _first_number(element: Element | None, *paths: str) -> float | None:
    for path in paths:
        if element is not None and text_of(element, path):
            return number_of(element, path, 0.0)
    return None


def _inertia(link: Element) -> Inertia | None:
    element = link.find("inertial")
    if element is None:
        return None
    mass = number_of(element, "mass", 1.0)
    moments = element.find("inertia")
    usual = (1.0, 1.0, 1.0, 0.0, 0.0, 0.0)
    values = tuple(
        number_of(moments, part, default) for part, default in zip(_MOMENTS, usual, strict=True)
    )
    if mass < 0 or min(values[:3]) < 0:
        name = link.get("name", "")
        raise DescriptionError(f"the <inertial> of '{name[:60]}' has a mass or moment below 0")
    return Inertia(mass, pose_of(element), values)


def _set_limits(joint: SdfJoint, axis: Element | None) -> None:
    limit = None if axis is None else axis.find("limit")
    lower = number_of(limit, "lower", -_ENDLESS)
    upper = number_of(limit, "upper", _ENDLESS)
    if joint.type in {"revolute", "prismatic"}:
        if lower > -_ENDLESS or upper < _ENDLESS:
            joint.lower, joint.upper = max(lower, -_ENDLESS), min(upper, _ENDLESS)
        elif joint.type == "revolute":
            joint.type = "continuous"
    effort = number_of(limit, "effort", -1.0)
    joint.effort = effort if effort > 0 else math.inf
    dynamics = None if axis is None else axis.find("dynamics")
    joint.damping = number_of(dynamics, "damping", 0.0)
    joint.friction = number_of(dynamics, "friction", 0.0)


def trees(model: SdfModel) -> Iterator[list[str]]:
    """Yield the links of each part of a model that joints connect, the largest part first."""
    beside: dict[str, set[str]] = {name: set() for name in model.links}
    for joint in model.joints.values():
        if joint.parent != "world":
            beside[joint.parent].add(joint.child)
            beside[joint.child].add(joint.parent)
    places = {name: place for place, name in enumerate(model.links)}
    found, seen = [], set[str]()
    for name in model.links:
        if name in seen:
            continue
        part, waiting = [], [name]
        seen.add(name)
        while waiting:
            part.append(waiting.pop())
            new = beside[part[-1]] - seen
            seen |= new
            waiting += sorted(new)
        found.append(sorted(part, key=places.__getitem__))
    yield from sorted(found, key=len, reverse=True)
