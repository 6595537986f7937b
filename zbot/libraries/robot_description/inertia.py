"""Masses in URDF: the `<inertial>` of each link."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from zbot.libraries.robot_description.urdf import read_origin
from zbot.libraries.robot_description.xml_text import DescriptionError, numbers, read_xml

if TYPE_CHECKING:
    from xml.etree.ElementTree import Element

    from zbot.tf2.rigid import Rigid

_PARTS = ("ixx", "iyy", "izz", "ixy", "ixz", "iyz")


@dataclass(frozen=True)
class Inertia:
    """Mass of a link, in kg, and its moments of inertia, in kg m^2."""

    mass: float
    origin: Rigid  #: the centre of mass and the axes of the moments, in the link
    moments: tuple[float, ...]  #: xx, yy, zz, xy, xz and yz


def read_inertia(text: str) -> dict[str, Inertia]:
    """Return the inertia of each link that has an `<inertial>`.

    Args:
        text: A robot description in URDF.

    Raises:
        DescriptionError: The text is not XML, or a number is missing, infinite or below 0.
    """
    found = {}
    for link in read_xml(text).findall("link"):
        element = link.find("inertial")
        if element is not None:
            name = link.get("name", "").strip()
            found[name] = _inertia(element, f"link '{name}'")
    return found


def _inertia(element: Element, where: str) -> Inertia:
    mass = _number(element.find("mass"), "value", where)
    moments = element.find("inertia")
    values = tuple(_number(moments, part, where) for part in _PARTS)
    if mass < 0 or min(values[:3]) < 0:
        raise DescriptionError(f"the <inertial> of {where} has a mass or a moment below 0")
    return Inertia(mass, read_origin(element.find("origin"), where), values)


def _number(element: Element | None, attribute: str, where: str) -> float:
    if element is None:
        raise DescriptionError(f"the <inertial> of {where} needs <mass> and <inertia>")
    (value,) = numbers(element.get(attribute, "0"), 1, f"{attribute} in the <inertial> of {where}")
    return value
