"""Robot model in URDF: links, joints, and the transform of each joint."""

from __future__ import annotations

import math
from collections import Counter
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, cast

from zbot.libraries.robot_description.xml_text import DescriptionError, numbers, read_xml
from zbot.tf2.rigid import Quaternion, Rigid, Vector, multiply

if TYPE_CHECKING:
    from xml.etree.ElementTree import Element

TYPES = ("revolute", "continuous", "prismatic", "fixed", "floating", "planar")
#: Types whose transform depends on one number: an angle in rad, or a distance in metres.
MOVING = frozenset({"revolute", "continuous", "prismatic"})
_LIMITED = frozenset({"revolute", "prismatic"})
_WITHOUT_AXIS = frozenset({"fixed", "floating"})


@dataclass(frozen=True)
class Mimic:
    """Rule of a joint that follows another joint: `position = multiplier * other + offset`."""

    joint: str
    multiplier: float = 1.0
    offset: float = 0.0


@dataclass(frozen=True)
class Joint:
    """Joint between two links. Angles are in rad, distances in metres."""

    name: str
    type: str  #: one of `TYPES`
    parent: str  #: name of the parent link
    child: str  #: name of the child link
    origin: Rigid = field(default_factory=Rigid)  #: the joint's frame in the parent link
    axis: Vector = (1.0, 0.0, 0.0)  #: length 1, or 0 for a joint that never moves
    lower: float = 0.0
    upper: float = 0.0
    soft_lower: float | None = None  #: from <safety_controller>
    soft_upper: float | None = None
    mimic: Mimic | None = None
    effort: float = math.inf  #: largest torque in Nm or force in N
    damping: float = 0.0
    friction: float = 0.0

    def transform(self, position: float = 0.0) -> Rigid:
        """Return the child link's frame in the parent link."""
        if self.type == "prismatic":
            x, y, z = (position * part for part in self.axis)
            return self.origin @ Rigid((x, y, z))
        if self.type not in MOVING or not any(self.axis):
            return self.origin
        sine = math.sin(position / 2)
        x, y, z = (sine * part for part in self.axis)
        return self.origin @ Rigid(rotation=(x, y, z, math.cos(position / 2)))


@dataclass(frozen=True)
class Robot:
    """Tree of links and joints."""

    name: str
    root: str  #: the only link without a parent
    links: tuple[str, ...]
    joints: dict[str, Joint]  #: by name, in the order of the description


def read_urdf(text: str) -> Robot:
    """Return the robot that a URDF text describes.

    Raises:
        DescriptionError: The text is not XML or not URDF, or the links do not form one tree.
    """
    if not text.strip():
        raise DescriptionError("it is empty")
    root = read_xml(text)
    if root.tag != "robot":
        raise DescriptionError(f"the outermost tag is <{root.tag[:40]}>, but must be <robot>")
    for element in root.iter():
        if element.tag.startswith("xacro:"):
            raise DescriptionError(
                f"it contains <{element.tag[:40]}>: give the output of xacro to the node, "
                "e.g. Command(['xacro ', path])"
            )
    links = [_name(element, "link") for element in root.findall("link")]
    joints = [_joint(element) for element in root.findall("joint")]
    by_name = _by_name(joints)
    return Robot(_name(root, "robot"), _root(links, joints), tuple(links), by_name)


def quaternion(roll: float, pitch: float, yaw: float) -> Quaternion:
    """Return the rotation of URDF's `rpy` in rad: about the fixed axes x, y and z in this order."""
    about_x: Quaternion = (math.sin(roll / 2), 0.0, 0.0, math.cos(roll / 2))
    about_y: Quaternion = (0.0, math.sin(pitch / 2), 0.0, math.cos(pitch / 2))
    about_z: Quaternion = (0.0, 0.0, math.sin(yaw / 2), math.cos(yaw / 2))
    return multiply(about_z, multiply(about_y, about_x))


def _name(element: Element, what: str) -> str:
    name = element.get("name")  # it may be empty, as in ROS 2
    if name is None:
        raise DescriptionError(f"a <{what}> has no name")
    return name.strip()


def _joint(element: Element) -> Joint:
    name = _name(element, "joint")
    where = f"joint '{name}'"
    type_ = element.get("type", "")
    if type_ not in TYPES:
        raise DescriptionError(f"{where} has the type '{type_[:40]}', not {', '.join(TYPES)}")
    lower, upper = _limits(element, type_, where)
    safety = element.find("safety_controller")
    return Joint(
        name,
        type_,
        _link(element, "parent", where),
        _link(element, "child", where),
        read_origin(element.find("origin"), where),
        _axis(element.find("axis"), type_, where),
        lower,
        upper,
        None if safety is None else _optional(safety, "soft_lower_limit", where),
        None if safety is None else _optional(safety, "soft_upper_limit", where),
        _mimic(element.find("mimic"), where),
        *_dynamics(element, where),
    )


def _dynamics(element: Element, where: str) -> tuple[float, float, float]:
    """Return the largest effort, the damping and the friction."""
    limit, dynamics = element.find("limit"), element.find("dynamics")
    effort = None if limit is None else _optional(limit, "effort", where)
    damping, friction = (
        0.0 if dynamics is None else _optional(dynamics, name, where) or 0.0
        for name in ("damping", "friction")
    )
    return effort or math.inf, damping, friction


def _link(element: Element, tag: str, where: str) -> str:
    found = element.find(tag)
    link = "" if found is None else found.get("link", "").strip()
    if not link:
        raise DescriptionError(f"{where} has no <{tag} link='...'/>")
    return link


def read_origin(element: Element | None, where: str) -> Rigid:
    """Return the transform in an `<origin>`, or no motion without this element.

    Raises:
        DescriptionError: An attribute has no three numbers.
    """
    if element is None:
        return Rigid()
    xyz = numbers(element.get("xyz", "0 0 0"), 3, f"xyz in the origin of {where}")
    rpy = numbers(element.get("rpy", "0 0 0"), 3, f"rpy in the origin of {where}")
    return Rigid(cast("Vector", xyz), quaternion(*rpy))


def _axis(element: Element | None, type_: str, where: str) -> Vector:
    if element is None or type_ in _WITHOUT_AXIS:
        return (1.0, 0.0, 0.0)
    axis = numbers(element.get("xyz", "1 0 0"), 3, f"the axis of {where}")
    length = math.hypot(*axis)
    return cast("Vector", tuple(part / (length or 1) for part in axis))


def _limits(element: Element, type_: str, where: str) -> tuple[float, float]:
    limit = element.find("limit")
    if limit is None:
        if type_ in _LIMITED:
            raise DescriptionError(f"{where} is {type_}, but has no <limit>")
        return 0.0, 0.0
    for attribute in ("effort", "velocity"):
        if attribute not in limit.attrib:
            raise DescriptionError(f"the <limit> of {where} has no {attribute}")
        _optional(limit, attribute, where)
    return _optional(limit, "lower", where) or 0.0, _optional(limit, "upper", where) or 0.0


def _optional(element: Element, attribute: str, where: str) -> float | None:
    text = element.get(attribute)
    return None if text is None else numbers(text, 1, f"{attribute} of {where}")[0]


def _mimic(element: Element | None, where: str) -> Mimic | None:
    if element is None:
        return None
    joint = element.get("joint")
    if joint is None:
        raise DescriptionError(f"the <mimic> of {where} names no joint")
    multiplier = _optional(element, "multiplier", where)
    return Mimic(
        joint.strip(),
        1.0 if multiplier is None else multiplier,
        _optional(element, "offset", where) or 0.0,
    )


def _by_name(joints: list[Joint]) -> dict[str, Joint]:
    found: dict[str, Joint] = {}
    for joint in joints:
        if joint.name in found:
            raise DescriptionError(f"two joints have the name '{joint.name}'")
        found[joint.name] = joint
    return found


def _root(links: list[str], joints: list[Joint]) -> str:
    """Return the only link without a parent, after checks that the links are one tree."""
    if not links:
        raise DescriptionError("it has no <link>")
    double = next((link for link, count in Counter(links).items() if count > 1), None)
    if double is not None:
        raise DescriptionError(f"two links have the name '{double}'")
    children = _children(set(links), joints)
    with_parent = {link for found in children.values() for link in found}
    roots = [link for link in links if link not in with_parent]
    if len(roots) > 1:
        raise DescriptionError(
            f"'{roots[0]}' and '{roots[1]}' both have no parent: connect them by a joint"
        )
    reached, waiting = set(roots), list(roots)
    while waiting:
        found = children.get(waiting.pop(), [])
        reached.update(found)
        waiting += found
    if len(reached) < len(links):
        raise DescriptionError(f"the joints around link '{min({*links} - reached)}' form a loop")
    return roots[0]


def _children(links: set[str], joints: list[Joint]) -> dict[str, list[str]]:
    """Return the child links of each link."""
    found: dict[str, list[str]] = {}
    seen: set[str] = set()
    for joint in joints:
        for link in (joint.parent, joint.child):
            if link not in links:
                raise DescriptionError(f"joint '{joint.name}' names the unknown link '{link}'")
        if joint.child in seen:
            raise DescriptionError(f"link '{joint.child}' is the child of two joints")
        seen.add(joint.child)
        found.setdefault(joint.parent, []).append(joint.child)
    return found
