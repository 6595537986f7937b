"""Displays Marker and MarkerArray: shapes that a program publishes."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from zbot.view import solid
from zbot.view.colors import of_message, same
from zbot.view.displays.display import Display, Setting, item
from zbot.view.errors import DisplayError
from zbot.view.points import check_number, positions_of, strip
from zbot.view.pose import pose_of
from zbot.view.shape import Arrows, Copies, Label, Lines, Mesh, Points

if TYPE_CHECKING:
    from collections.abc import Callable

    from numpy.typing import NDArray

    from zbot.view.displays.display import Value
    from zbot.view.mesh_file import MeshFiles
    from zbot.view.shape import Shape

_MOST_MARKERS = 5000
_MOST_POINTS = 100_000
_MOST_LETTERS = 2000
_ADD, _DELETE, _DELETE_ALL = 0, 2, 3
_SOLIDS = {1: solid.box, 2: solid.sphere, 3: solid.cylinder}
_SOLID_LISTS = {6: solid.box, 7: solid.sphere}


class Markers(Display):
    """Markers by namespace and id, until they are deleted or their lifetime is over.

    The setting `hidden` has the namespaces that are not shown.
    """

    settings = (Setting("hidden", ""),)
    kept = 100

    def __init__(self, topic: str, files: MeshFiles | None = None) -> None:
        super().__init__(topic, files)
        self._ends_ns: dict[str, int] = {}  # ends of lifetimes
        self._waiting: dict[str, Any] = {}  # markers whose files are being read
        self._now_ns = 0

    def tick(self, now_ns: int) -> None:
        """Remove markers whose lifetime is over, and show those whose files were read."""
        self._now_ns = now_ns
        for key in [key for key, end_ns in self._ends_ns.items() if end_ns <= now_ns]:
            self._remove(key)
        for key, marker in list(self._waiting.items()):
            del self._waiting[key]
            self._add(key, marker)

    def change(self, name: str, value: Value) -> None:
        """Hide namespaces. A namespace that is shown again is seen with its next message."""
        super().change(name, value)
        for key in [key for key in self.items if key.rpartition("/")[0] in self.words("hidden")]:
            self._remove(key)

    def _show(self, marker: Any) -> None:
        if marker.ns in self.words("hidden"):
            return
        if marker.action == _DELETE_ALL:
            start = f"{marker.ns}/" if marker.ns else ""
            for key in [key for key in self.items if key.startswith(start)]:
                self._remove(key)
            return
        key = f"{marker.ns}/{marker.id}"
        if marker.action == _DELETE:
            self._remove(key)
        elif marker.action == _ADD:
            self._add(key, marker)
        else:
            raise DisplayError(f"marker {key} has the unknown action {marker.action}")

    def _add(self, key: str, marker: Any) -> None:
        if key not in self.items and len(self.items) >= _MOST_MARKERS:
            raise DisplayError(f"only the first {_MOST_MARKERS} markers are shown")
        try:
            shapes = marker_shapes(marker, self.files)
            made = item(marker.header, shapes or ())
        except DisplayError as error:
            self._remove(key)
            raise DisplayError(f"marker {key}: {error}") from error
        if shapes is None:
            self._waiting[key] = marker
        self.items[key] = made._replace(
            pose=pose_of(marker.pose), stamp_ns=0 if marker.frame_locked else made.stamp_ns
        )
        life_ns = marker.lifetime.sec * 10**9 + marker.lifetime.nanosec
        self._ends_ns.pop(key, None)
        if life_ns > 0:
            self._ends_ns[key] = self._now_ns + life_ns

    def _remove(self, key: str) -> None:
        for known in (self.items, self._ends_ns, self._waiting):
            known.pop(key, None)


class Marker(Markers):
    """Markers that come one by one."""

    name = "Marker"
    types = ("visualization_msgs/msg/Marker",)

    def take(self, message: Any) -> None:
        """Add, change or delete a marker."""
        self.notice = ""
        self._show(message)


class MarkerArray(Markers):
    """Markers that come in arrays."""

    name = "MarkerArray"
    types = ("visualization_msgs/msg/MarkerArray",)

    def take(self, message: Any) -> None:
        """Add, change or delete each marker of an array. Others are shown if one has a mistake."""
        self.notice = ""
        mistakes = []
        for marker in message.markers:
            try:
                self._show(marker)
            except DisplayError as error:
                mistakes.append(str(error))
        if mistakes:
            raise DisplayError(mistakes[0])


def marker_shapes(marker: Any, files: MeshFiles) -> list[Shape] | None:
    """Return the shapes of a marker in the frame of its pose, or None until its file is read.

    Raises:
        DisplayError: The marker cannot be drawn.
    """
    if len(marker.points) > _MOST_POINTS:
        raise DisplayError(f"it has {len(marker.points)} points: the limit is {_MOST_POINTS}")
    if marker.type == 10:
        return _file(marker, files)
    make = _KINDS.get(marker.type)
    if make is None:
        raise DisplayError(f"it has the unknown type {marker.type}")
    return make(marker)


def _opacity(marker: Any) -> float:
    alpha = float(marker.color.a)
    if not alpha > 0:
        raise DisplayError("it cannot be seen: its color.a is 0, but must be up to 1")
    return min(alpha, 1.0)


def _scale(marker: Any, axes: str = "xyz") -> tuple[float, ...]:
    found = tuple(
        check_number(getattr(marker.scale, axis), f"scale.{axis}", low=0) for axis in axes
    )
    if not all(found):
        names = " and ".join(f"scale.{axis}" for axis in axes)
        raise DisplayError(f"it has no size: {names} must be larger than 0")
    return found


def _positions(marker: Any, least: int, multiple: int = 1) -> NDArray[np.float32]:
    count = len(marker.points)
    if count < least or count % multiple:
        needed = f"at least {least}" if multiple == 1 else f"a multiple of {multiple}"
        raise DisplayError(f"it has {count} points, but needs {needed}")
    return positions_of(marker.points, "points")


def _colors(marker: Any) -> NDArray[np.uint8]:
    """Return a colour for each point."""
    if not marker.colors:
        _opacity(marker)
        return same(of_message(marker.color), len(marker.points))
    if len(marker.colors) != len(marker.points):
        raise DisplayError(f"it has {len(marker.colors)} colors for {len(marker.points)} points")
    return np.array([of_message(color) for color in marker.colors], np.uint8)


def _arrow(marker: Any) -> list[Shape]:
    _opacity(marker)
    if marker.points:
        if len(marker.points) != 2:
            raise DisplayError(f"it has {len(marker.points)} points, but needs 0 or 2")
        ends = positions_of(marker.points, "points").reshape(1, 2, 3)
        shaft, head = _scale(marker, "xy")
        long = check_number(marker.scale.z, "scale.z", low=0)
        length = long or 0.25 * float(np.linalg.norm(ends[0, 1] - ends[0, 0]))
    else:
        x, y, _ = _scale(marker)
        ends = np.array([[(0, 0, 0), (x, 0, 0)]], np.float32)
        shaft, head, length = y * 0.5, y, 0.23 * x
    return [Arrows(ends, same(of_message(marker.color), 1), shaft / 2, head / 2, length)]


def _arrow_strip(marker: Any) -> list[Shape]:
    ends = strip(_positions(marker, 2))
    shaft, head = _scale(marker, "xy")
    length = check_number(marker.scale.z, "scale.z", low=0) or head
    colors = same(of_message(marker.color), len(ends))
    return [Arrows(ends, colors, shaft / 2, head / 2, length)]


def _solid(marker: Any) -> list[Shape]:
    vertices, faces = _SOLIDS[marker.type]()
    size = np.array(_scale(marker), np.float32)
    return [Mesh(vertices * size, faces, of_message(marker.color), _opacity(marker))]


def _solids(marker: Any) -> list[Shape]:
    vertices, faces = _SOLID_LISTS[marker.type]()
    places = _positions(marker, 1)
    sizes = np.broadcast_to(np.array(_scale(marker), np.float32), places.shape)
    opacity = 1.0 if marker.colors else _opacity(marker)
    return [Copies(vertices, faces, places, sizes, _colors(marker), opacity)]


def _line_strip(marker: Any) -> list[Shape]:
    _scale(marker, "x")
    colors = _colors(marker)
    return [Lines(strip(_positions(marker, 2)), np.stack([colors[:-1], colors[1:]], axis=1))]


def _line_list(marker: Any) -> list[Shape]:
    _scale(marker, "x")
    ends = _positions(marker, 2, 2).reshape(-1, 2, 3)
    return [Lines(ends, _colors(marker).reshape(-1, 2, 3))]


def _points(marker: Any) -> list[Shape]:
    return [Points(_positions(marker, 1), _colors(marker), max(_scale(marker, "xy")))]


def _text(marker: Any) -> list[Shape]:
    (height,) = _scale(marker, "z")
    if not marker.text:
        raise DisplayError("it has no text")
    return [Label(marker.text[:_MOST_LETTERS], (0, 0, 0), height)]


def _triangles(marker: Any) -> list[Shape]:
    """Return a surface. Each triangle has one colour: the mean of its points."""
    size = np.array(_scale(marker), np.float32)
    places = _positions(marker, 3, 3) * size
    faces = np.arange(len(places), dtype=np.uint32).reshape(-1, 3)
    both = np.concatenate([faces, faces[:, ::-1]])  # seen from both sides
    colors = _colors(marker)
    groups, which = np.unique(colors[::3], axis=0, return_inverse=True)
    opacity = 1.0 if marker.colors else _opacity(marker)
    if len(groups) > 32:
        groups, which = colors[:1], np.zeros(len(faces), int)
    which = np.tile(which.reshape(-1), 2)
    return [
        Mesh(places, both[which == number], (int(color[0]), int(color[1]), int(color[2])), opacity)
        for number, color in enumerate(groups)
    ]


def _file(marker: Any, files: MeshFiles) -> list[Shape] | None:
    found = files.get(marker.mesh_resource)
    if found is None:
        return None
    size = np.array(_scale(marker), np.float32)
    meshes = [replace(mesh, vertices=mesh.vertices * size) for mesh in found]
    if marker.mesh_use_embedded_materials:
        return list(meshes)
    color, opacity = of_message(marker.color), _opacity(marker)
    return [replace(mesh, color=color, opacity=opacity) for mesh in meshes]


_KINDS: dict[int, Callable[[Any], list[Shape]]] = {
    0: _arrow,
    1: _solid,
    2: _solid,
    3: _solid,
    4: _line_strip,
    5: _line_list,
    6: _solids,
    7: _solids,
    8: _points,
    9: _text,
    11: _triangles,
    12: _arrow_strip,
}
