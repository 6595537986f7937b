"""Shapes of SDF links: solids, endless planes, meshes and hills, with colours."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple, cast

from zbot.libraries.robot_description.appearance import Rgba, Solid
from zbot.libraries.robot_description.xml_text import numbers
from zbot.simulation.colors import color_of
from zbot.simulation.sdf.document import FOLDER
from zbot.simulation.sdf.heightmap import Heightmap
from zbot.simulation.sdf.resources import find_resource
from zbot.simulation.sdf.values import number_of, pose_of, text_of, vector_of
from zbot.tf2.rigid import Rigid, Vector

if TYPE_CHECKING:
    from collections.abc import Iterator
    from xml.etree.ElementTree import Element

GREY: Rgba = (0.7, 0.7, 0.7, 1.0)


class Shapes(NamedTuple):
    """Shapes of a `<collision>` or a `<visual>`."""

    solids: list[Solid]
    planes: list[Rigid]  #: endless floors; their z axis is the normal
    notices: list[str]  #: what is left out
    hills: list[Heightmap]


def shapes_of(element: Element, color: Rgba | None = None) -> Shapes:
    """Return the shapes of a `<collision>` or `<visual>`, in the frame of its link.

    Raises:
        DescriptionError: A number is not valid.
    """
    shapes = Shapes([], [], [], [])
    geometry = element.find("geometry")
    shape = None if geometry is None else next(iter(geometry), None)
    if shape is None or shape.tag == "empty":
        return shapes
    origin = pose_of(element)
    if shape.tag == "plane":
        shapes.planes.append(origin @ _turned_to(vector_of(shape, "normal", (0.0, 0.0, 1.0))))
    elif shape.tag == "mesh":
        _add_mesh(shapes, shape, origin, color)
    elif shape.tag == "heightmap":
        _add_hills(shapes, shape, origin)
    elif shape.tag in {"box", "cylinder", "sphere", "capsule"}:
        shapes.solids.extend(_solids(shape, origin, color or GREY))
    else:
        shapes.notices.append(f"a <{shape.tag[:40]}>")
    return shapes


def _solids(shape: Element, origin: Rigid, color: Rgba) -> Iterator[Solid]:
    if shape.tag == "box":
        yield Solid("box", origin, vector_of(shape, "size", (1.0, 1.0, 1.0)), color)
        return
    width = 2 * number_of(shape, "radius", 0.5)
    if shape.tag == "sphere":
        yield Solid("sphere", origin, (width, width, width), color)
        return
    length = number_of(shape, "length", 1.0)
    yield Solid("cylinder", origin, (width, width, length), color)
    if shape.tag == "capsule":
        for end in (length / 2, -length / 2):
            at = origin @ Rigid((0.0, 0.0, end))
            yield Solid("sphere", at, (width, width, width), color)


def _file_of(shapes: Shapes, shape: Element) -> Path | None:
    """Return the file of a shape, or None after a notice that it is missing."""
    uri = shape.find("uri")
    address = text_of(shape, "uri") or text_of(shape, "filename")
    folder = None if uri is None else uri.get(FOLDER)
    path = find_resource(address, Path(folder) if folder else None)
    if path is None or not path.is_file():
        shapes.notices.append(f"the {shape.tag} {address[:200]}, which is not on this machine,")
        return None
    return path


def _add_hills(shapes: Shapes, shape: Element, origin: Rigid) -> None:
    path = _file_of(shapes, shape)
    if path is not None:
        size = vector_of(shape, "size", (1.0, 1.0, 1.0))
        at = Rigid(vector_of(shape, "pos", (0.0, 0.0, 0.0)))
        shapes.hills.append(Heightmap(path, size, origin @ at))


def _add_mesh(shapes: Shapes, shape: Element, origin: Rigid, color: Rgba | None) -> None:
    path = _file_of(shapes, shape)
    if path is None:
        return
    shapes.solids.append(Solid("mesh", origin, _scale(shape), color, str(path)))


def _scale(mesh: Element) -> Vector:
    """Return the scale of a mesh. One number is that of all three axes."""
    if len(text_of(mesh, "scale").split()) == 1:
        scale = number_of(mesh, "scale", 1.0)
        return (scale, scale, scale)
    return vector_of(mesh, "scale", (1.0, 1.0, 1.0))


def _turned_to(normal: tuple[float, float, float]) -> Rigid:
    """Return a rotation that turns the z axis to a normal."""
    x, y, z = normal
    length = (x * x + y * y + z * z) ** 0.5
    if not length or z / length < -0.999999:
        return Rigid()
    half = Rigid(rotation=(-y / length, x / length, 0.0, 1 + z / length)).rotation
    size = sum(part * part for part in half) ** 0.5
    qx, qy, qz, qw = (part / size for part in half)
    return Rigid(rotation=(qx, qy, qz, qw))


def visual_color(visual: Element | None) -> Rgba | None:
    """Return the colour of a `<visual>`, or None if it has none."""
    material = None if visual is None else visual.find("material")
    if material is None:
        return None
    text = text_of(material, "diffuse") or text_of(material, "ambient")
    words = text.split()
    if len(words) in {3, 4}:
        values = numbers(text, len(words), "the colour of a <material>")
        return cast("Rgba", (*values, 1.0)[:4])
    return color_of(text_of(material, "script/name"))
