"""Files of surfaces (STL, DAE, OBJ, GLB, PLY), read in a thread and kept while they are used."""

from __future__ import annotations

import stat
import threading
from typing import TYPE_CHECKING, Any

import numpy as np

from zbot.libraries.robot_description.mesh_address import path_of
from zbot.libraries.robot_description.xml_text import DescriptionError
from zbot.threads.on_demand_thread import OnDemandThread
from zbot.view.errors import DisplayError
from zbot.view.shape import Mesh

if TYPE_CHECKING:
    from collections.abc import Callable
    from pathlib import Path

_ENDINGS = frozenset({".stl", ".dae", ".obj", ".glb", ".ply"})
_MOST_BYTES = 100_000_000
_MOST_TRIANGLES = 500_000
_MOST_WANTED = 100
_MOST_KEPT = 500
_MOST_KEPT_BYTES = 200_000_000


class MeshFiles:
    """Store of surfaces by the address of their file. A file that is used is read only once."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._files: dict[str, tuple[Mesh, ...] | DisplayError] = {}  # the last used one is last
        self._bytes = 0
        self._wanted: dict[str, None] = {}  # addresses in the order of their reading
        # One file at a time: the view needs the processor, too.
        self._reading = OnDemandThread(_start, self._read_next)

    def get(self, address: str) -> tuple[Mesh, ...] | None:
        """Return the surfaces of a file, or None as long as the file is read. Ask again then.

        Args:
            address: `package://PACKAGE/PATH`, `file:///PATH` or a path.

        Raises:
            DisplayError: The file does not exist or cannot be read.
        """
        with self._lock:
            found = self._files.pop(address, None)
            if found is not None:
                self._files[address] = found
            elif len(self._wanted) < _MOST_WANTED:
                self._wanted[address] = None
        if found is None:
            self._reading.wake()
        if isinstance(found, DisplayError):
            raise found
        return found

    def _read_next(self) -> float | None:
        with self._lock:
            address = next(iter(self._wanted), None)
        if address is None:
            return None
        found: tuple[Mesh, ...] | DisplayError
        try:
            found = read_mesh_file(address)
        except DisplayError as error:
            found = error
        except Exception as error:  # noqa: BLE001 - otherwise the address would wait for ever
            found = DisplayError(f"{address} cannot be read: {error}")
        with self._lock:
            del self._wanted[address]
            self._files[address] = found
            self._bytes += _size(found)
            while len(self._files) > 1 and (
                len(self._files) > _MOST_KEPT or self._bytes > _MOST_KEPT_BYTES
            ):
                self._bytes -= _size(self._files.pop(next(iter(self._files))))
        return 0.0


def _start(run: Callable[[], None]) -> None:
    threading.Thread(target=run, name="zbot view mesh", daemon=True).start()


def _size(found: tuple[Mesh, ...] | DisplayError) -> int:
    if isinstance(found, DisplayError):
        return 0
    return sum(mesh.vertices.nbytes + mesh.faces.nbytes for mesh in found)


def read_mesh_file(address: str) -> tuple[Mesh, ...]:
    """Return the surfaces of a file, in metres.

    Raises:
        DisplayError: The file does not exist, is too large or cannot be read.
    """
    try:
        path = path_of(address)
    except DescriptionError as error:
        raise DisplayError(error.reason) from error
    if path.suffix.lower() not in _ENDINGS:
        raise DisplayError(f"{address} is not one of {', '.join(sorted(_ENDINGS))}")
    try:
        facts = path.stat()
    except (OSError, ValueError) as error:
        raise DisplayError(f"{address} is not found: there is no file {path}") from error
    if not stat.S_ISREG(facts.st_mode):
        raise DisplayError(f"{address} is no file: it is a folder, a device or a pipe")
    if facts.st_size > _MOST_BYTES:
        size = facts.st_size // 10**6
        raise DisplayError(f"{address} has {size} MB: the limit is {_MOST_BYTES // 10**6}")
    try:
        return _surfaces(path)
    except DisplayError:
        raise
    except Exception as error:
        raise DisplayError(f"{address} cannot be read: {error}") from error


def _surfaces(path: Path) -> tuple[Mesh, ...]:
    import trimesh  # noqa: PLC0415 - slow to import, and many robots need no file

    scene = trimesh.load_scene(path)
    found = []
    for geometry in scene.dump():
        if not isinstance(geometry, trimesh.Trimesh):
            continue
        scale = _metres(geometry)
        vertices = np.asarray(geometry.vertices * scale, np.float32)
        red, green, blue, alpha = _color(geometry)
        faces = np.asarray(geometry.faces, np.uint32)
        color = (red, green, blue)
        found.append(Mesh(vertices, faces, color, alpha / 255, has_levels=True))
    count = sum(len(mesh.faces) for mesh in found)
    if not count:
        raise DisplayError(f"{path.name} has no triangles")
    if count > _MOST_TRIANGLES:
        raise DisplayError(f"{path.name} has {count} triangles: the limit is {_MOST_TRIANGLES}")
    return tuple(found)


def _metres(geometry: Any) -> float:
    """Return the factor from the file's unit to metres. Only DAE files have another unit."""
    word, _, unit = str(geometry.metadata.get("units", "")).partition(" * ")
    return float(word) if unit == "meters" else 1.0


def _color(geometry: Any) -> tuple[int, int, int, int]:
    # A surface with a texture has the colour of its material.
    holder = geometry.visual if hasattr(geometry.visual, "main_color") else geometry.visual.material
    red, green, blue, alpha = (int(part) for part in holder.main_color)
    return red, green, blue, alpha
