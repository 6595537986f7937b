"""Reader of COLLADA files (`.dae`): the triangles of all geometries in the scene."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from zbot.libraries.robot_description.xml_text import read_xml

if TYPE_CHECKING:
    from collections.abc import Iterator
    from xml.etree.ElementTree import Element

    from numpy.typing import NDArray

    Array = NDArray[np.float64]

_MOST_COPIES = 10_000
#: Limits of what all copies of nodes contain together. A short file can place a node often.
_MOST_PARTS, _MOST_USES, _MOST_TRIANGLES = 1_000_000, 20_000, 1_000_000
_POLYGONS = frozenset({"triangles", "polylist", "polygons"})
#: For each axis that points up: the matrix that turns this axis to z.
_UP = {
    "X_UP": [[0, -1, 0], [0, 0, -1], [1, 0, 0]],
    "Y_UP": [[1, 0, 0], [0, 0, -1], [0, 1, 0]],
    "Z_UP": [[1, 0, 0], [0, 1, 0], [0, 0, 1]],
}


def read_collada(data: bytes) -> NDArray[np.float32]:
    """Return the triangles in a file, in metres and with z upwards.

    Raises:
        ValueError: The data are not COLLADA. A `DescriptionError` is a `ValueError`, too.
    """
    root = read_xml(data.decode("utf-8-sig", "replace"))
    for element in root.iter():
        element.tag = element.tag.rpartition("}")[2].rpartition(":")[2]
    if root.tag != "COLLADA":
        raise ValueError("it is not a file in COLLADA")
    unit = root.find("asset/unit")
    scale = float((unit.get("meter") if unit is not None else None) or 1.0)
    up = np.array(_UP.get((root.findtext("asset/up_axis") or "Y_UP").strip(), _UP["Z_UP"]))
    found = list(_Scene(root).triangles())
    if not found:
        raise ValueError("it has no triangles")
    triangles: NDArray[np.float32] = (np.concatenate(found) * scale @ up.T).astype(np.float32)
    return triangles


class _Scene:
    """Geometries of a file, and the nodes that place them."""

    def __init__(self, root: Element) -> None:
        self._root = root
        self._shapes = {
            shape.get("id", ""): shape for shape in root.iterfind("library_geometries/geometry")
        }
        self._nodes = {node.get("id", ""): node for node in root.iter("node")}
        self._read: dict[str, Array] = {}
        self._matrices: dict[Element, Array] = {}
        self._copies = self._parts = self._uses = self._triangles = 0

    def triangles(self) -> Iterator[Array]:
        """Yield the triangles of each geometry, where the scene has it."""
        nodes = self._root.findall("library_visual_scenes/visual_scene/node")
        if not nodes:
            yield from (self._shape(name) for name in self._shapes)
        for node in nodes:
            yield from self._of_node(node, np.eye(4), 0)

    def _of_node(self, node: Element, outer: Array, level: int) -> Iterator[Array]:
        self._copies += 1
        self._parts += len(node)
        if self._copies > _MOST_COPIES or self._parts > _MOST_PARTS or level > 50:
            raise ValueError("its scene has too many nodes")
        if node not in self._matrices:
            self._matrices[node] = _matrix(node)
        pose = outer @ self._matrices[node]
        for use in (*node.findall("instance_geometry"), *node.findall("instance_controller")):
            found = self._shape(use.get("url", "").lstrip("#"))
            self._count(len(found))
            yield found @ pose[:3, :3].T + pose[:3, 3]
        inner = node.findall("node")
        for use in node.findall("instance_node"):
            named = self._nodes.get(use.get("url", "").lstrip("#"))
            inner += [] if named is None else [named]
        for child in inner:
            yield from self._of_node(child, pose, level + 1)

    def _count(self, triangles: int) -> None:
        self._uses += 1
        self._triangles += triangles
        if self._uses > _MOST_USES or self._triangles > _MOST_TRIANGLES:
            raise ValueError("its scene has too many triangles")

    def _shape(self, name: str) -> Array:
        if name not in self._read:
            shape = self._shapes.get(name)
            mesh = None if shape is None else shape.find("mesh")
            parts = [] if mesh is None else list(_parts(mesh))
            self._read[name] = np.concatenate(parts) if parts else np.empty((0, 3, 3))
        return self._read[name]


def _parts(mesh: Element) -> Iterator[Array]:
    sources = {source.get("id", ""): source for source in mesh.findall("source")}
    vertices = mesh.find("vertices")
    given = None if vertices is None else vertices.find("input[@semantic='POSITION']")
    source = None if given is None else sources.get(given.get("source", "").lstrip("#"))
    text = "" if source is None else source.findtext("float_array") or ""
    points = np.array(text.split(), np.float64)
    points = points[: len(points) // 3 * 3].reshape(-1, 3)
    for element in mesh:
        if element.tag in _POLYGONS:
            corners = _corners(element)
            if len(corners) and (int(np.max(corners)) >= len(points) or int(np.min(corners)) < 0):
                raise ValueError("a triangle has a point that does not exist")
            yield points[corners].reshape(-1, 3, 3)


def _corners(element: Element) -> NDArray[np.int64]:
    """Return the numbers of the points of triangles, three for each."""
    inputs = element.findall("input")
    step = 1 + max((int(entry.get("offset", "0")) for entry in inputs), default=0)
    place = next(
        (int(entry.get("offset", "0")) for entry in inputs if entry.get("semantic") == "VERTEX"), 0
    )
    rows = [_numbers(tag.text or "") for tag in element.findall("p")]
    if element.tag == "polygons":
        parts = [_fans(row[place::step], [len(row) // step]) for row in rows]
        return np.concatenate([np.empty(0, np.int64), *parts])
    found = np.concatenate([row[place::step] for row in rows] or [np.empty(0, np.int64)])
    if element.tag == "polylist":
        counts = [int(count) for count in (element.findtext("vcount") or "").split()]
        return _fans(found, counts)
    return found[: len(found) // 3 * 3]


def _numbers(text: str) -> NDArray[np.int64]:
    try:
        return np.array(text.split(), np.int64)
    except OverflowError as error:
        raise ValueError("a number of a point is too large") from error


def _fans(corners: NDArray[np.int64], counts: list[int]) -> NDArray[np.int64]:
    """Return the corners of the triangles that fill polygons with these numbers of corners."""
    if min(counts, default=3) < 0 or sum(counts) > len(corners):
        raise ValueError("a polygon has a wrong number of points")
    found, start = [], 0
    for count in counts:
        polygon = corners[start : start + count]
        start += count
        for place in range(1, count - 1):
            found += [polygon[0], polygon[place], polygon[place + 1]]
    return np.array(found, np.int64)


def _matrix(node: Element) -> Array:
    """Return the transform of a node: the product of its elements, in their order."""
    found = np.eye(4)
    for element in node:
        if element.tag not in {"matrix", "translate", "rotate", "scale"}:
            continue
        values = np.array((element.text or "").split(), np.float64)
        one = np.eye(4)
        if element.tag == "matrix":
            one = values.reshape(4, 4)
        elif element.tag == "translate":
            one[:3, 3] = values
        elif element.tag == "scale":
            one[:3, :3] = np.diag(values)
        else:
            one[:3, :3] = _rotation(values)
        found = found @ one
    return found


def _rotation(values: Array) -> Array:
    """Return the rotation about an axis by an angle in degrees, as a matrix."""
    x, y, z = values[:3] / (np.linalg.norm(values[:3]) or 1.0)
    angle = np.radians(values[3])
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    turned: Array = np.eye(3) + np.sin(angle) * cross + (1 - np.cos(angle)) * cross @ cross
    return turned
