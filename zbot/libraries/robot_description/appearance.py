"""Appearance of a robot in URDF: the solids and files of its links, with their colours."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal, cast

from zbot.libraries.robot_description.urdf import read_origin
from zbot.libraries.robot_description.xml_text import DescriptionError, numbers, read_xml

if TYPE_CHECKING:
    from xml.etree.ElementTree import Element

    from zbot.tf2.rigid import Rigid, Vector

#: Red, green, blue and opacity, from 0 to 1.
Rgba = tuple[float, float, float, float]

_GREY: Rgba = (0.7, 0.7, 0.7, 1.0)


@dataclass(frozen=True)
class Solid:
    """One part of a link's appearance. Lengths are in metres."""

    kind: Literal["box", "cylinder", "sphere", "mesh"]
    origin: Rigid  #: the solid's frame in the link
    size: Vector  #: along x, y and z. For a mesh, these are factors.
    color: Rgba | None = None  #: None if the file of a mesh decides
    file: str = ""  #: the address of a mesh's file


def read_appearance(
    text: str, part: Literal["visual", "collision"] = "visual"
) -> dict[str, list[Solid]]:
    """Return the solids of each link that has some.

    Args:
        text: A robot description in URDF.
        part: Whether to read what is seen, or what the robot collides with.

    Raises:
        DescriptionError: The text is not XML, or a solid is not valid.
    """
    root = read_xml(text)
    materials: dict[str, Rgba] = {}
    # A material may be defined in one link and used in another.
    for element in root.iter("material"):
        color = _color(element)
        if color is not None:
            materials.setdefault(element.get("name", ""), color)
    found: dict[str, list[Solid]] = {}
    for link in root.findall("link"):
        name = link.get("name", "").strip()
        solids = [_solid(element, f"link '{name}'", materials) for element in link.findall(part)]
        if solids:
            found[name] = solids
    return found


def _solid(element: Element, where: str, materials: dict[str, Rgba]) -> Solid:
    geometry = element.find("geometry")
    shape = None if geometry is None else next(iter(geometry), None)
    if shape is None:
        raise DescriptionError(f"{where} has a <{element.tag}> without a shape in <geometry>")
    origin = read_origin(element.find("origin"), where)
    color = _material(element.find("material"), materials)
    if shape.tag == "mesh":
        file = shape.get("filename", "")
        if not file:
            raise DescriptionError(f"{where} has a <mesh> without a filename")
        return Solid("mesh", origin, _vector(shape, "scale", where, "1 1 1"), color, file)
    color = color or _GREY
    if shape.tag == "box":
        return Solid("box", origin, _vector(shape, "size", where), color)
    if shape.tag not in {"cylinder", "sphere", "capsule"}:
        raise DescriptionError(f"{where} has the unknown shape <{shape.tag[:40]}>")
    (radius,) = numbers(shape.get("radius", ""), 1, f"the radius in {where}")
    if shape.tag == "sphere":
        return Solid("sphere", origin, (2 * radius, 2 * radius, 2 * radius), color)
    (length,) = numbers(shape.get("length", ""), 1, f"the length in {where}")
    return Solid("cylinder", origin, (2 * radius, 2 * radius, length), color)


def _vector(element: Element, attribute: str, where: str, default: str = "") -> Vector:
    text = element.get(attribute, default)
    return cast("Vector", numbers(text, 3, f"the {attribute} of <{element.tag}> in {where}"))


def _material(element: Element | None, materials: dict[str, Rgba]) -> Rgba | None:
    if element is None:
        return None
    return _color(element) or materials.get(element.get("name", ""))


def _color(element: Element) -> Rgba | None:
    color = element.find("color")
    if color is None:
        return None
    name = element.get("name", "")
    return cast("Rgba", numbers(color.get("rgba", ""), 4, f"the color of material '{name}'"))
