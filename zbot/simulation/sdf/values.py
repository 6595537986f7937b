"""Values in SDF elements: numbers, flags and poses."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, cast

from zbot.libraries.robot_description.urdf import quaternion
from zbot.libraries.robot_description.xml_text import numbers
from zbot.tf2.rigid import Rigid, Vector, normalized

if TYPE_CHECKING:
    from xml.etree.ElementTree import Element

_TRUE = frozenset({"1", "true"})


def text_of(element: Element | None, path: str, default: str = "") -> str:
    """Return the text of the first element at a path, without blanks at its ends."""
    found = None if element is None else element.find(path)
    return default if found is None else (found.text or "").strip() or default


def number_of(element: Element | None, path: str, default: float) -> float:
    """Return a number, or the default if the element is missing.

    Raises:
        DescriptionError: The text is not a finite number.
    """
    text = text_of(element, path)
    return numbers(text, 1, f"<{path}>")[0] if text else default


def vector_of(element: Element | None, path: str, default: Vector) -> Vector:
    """Return three numbers, or the default if the element is missing.

    Raises:
        DescriptionError: The text is not three finite numbers.
    """
    text = text_of(element, path)
    return cast("Vector", numbers(text, 3, f"<{path}>")) if text else default


def flag_of(element: Element | None, path: str, default: bool = False) -> bool:
    """Return a truth value, or the default if the element is missing."""
    text = text_of(element, path).lower()
    return text in _TRUE if text else default


def pose_of(element: Element) -> Rigid:
    """Return the pose in the element's `<pose>`, or no motion without it.

    Raises:
        DescriptionError: The text is not a pose.
    """
    pose = element.find("pose")
    text = "" if pose is None else (pose.text or "").strip()
    if pose is None or not text:
        return Rigid()
    if pose.get("rotation_format") == "quat_xyzw":
        x, y, z, *rotation = numbers(text, 7, "<pose>")
        qx, qy, qz, qw = rotation
        length = math.hypot(*rotation)
        return Rigid((x, y, z), normalized((qx, qy, qz, qw)) if length else (0.0, 0.0, 0.0, 1.0))
    x, y, z, *angles = numbers(text, 6, "<pose>")
    if pose.get("degrees", "").strip().lower() in _TRUE:
        angles = [math.radians(angle) for angle in angles]
    roll, pitch, yaw = angles
    return Rigid((x, y, z), quaternion(roll, pitch, yaw))


def relative_to(element: Element) -> str:
    """Return the name of the frame in which the element's `<pose>` is, or an empty text."""
    pose = element.find("pose")
    if pose is None:
        return ""
    return pose.get("relative_to") or pose.get("frame") or ""
