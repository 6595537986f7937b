"""Files of surfaces (STL, DAE, OBJ, GLB, PLY), read in a thread of their own."""

from __future__ import annotations

import stat
import threading
from typing import TYPE_CHECKING, Any

import numpy as np

from zbot.libraries.robot_description.mesh_address import path_of
from zbot.libraries.robot_description.xml_text import DescriptionError
from zbot.view.errors import DisplayError
from zbot.view.shape import Mesh

if TYPE_CHECKING:
    from pathlib import Path

_ENDINGS = frozenset({".stl", ".dae", ".obj", ".glb", ".ply"})
_MOST_BYTES = 100_000_000
_MOST_TRIANGLES = 500_000


class MeshFiles:
    """Store of surfaces by the address of their file. Each file is read only once."""

    def __init__(self) -> None:
        self._files: dict[str, tuple[Mesh, ...] | DisplayError | None] = {}
        self._reading = threading.Lock()

    def get(self, address: str) -> tuple[Mesh, ...] | None:
        """Return the surfaces of a file, or None as long as the file is read.

        Args:
            address: `package://PACKAGE/PATH`, `file:///PATH` or a path.

        Raises:
            DisplayError: The file does not exist or cannot be read.
        """
        if address not in self._files:
            self._files[address] = None
            threading.Thread(
                target=self._read, args=(address,), name="zbot view mesh", daemon=True
            ).start()
        found = self._files[address]
        if isinstance(found, DisplayError):
            raise found
        return found

    def _read(self, address: str) -> None:
        with self._reading:  # one file at a time: the view needs the processor, too
            try:
                self._files[address] = read_mesh_file(address)
            except DisplayError as error:
                self._files[address] = error


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
