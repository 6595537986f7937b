"""Files with meshes: STL, OBJ and COLLADA."""

from __future__ import annotations

import itertools
from typing import TYPE_CHECKING

import numpy as np

from zbot.simulation.errors import SimulationError
from zbot.simulation.meshes.collada import read_collada
from zbot.text.limited_file import read_limited

if TYPE_CHECKING:
    from pathlib import Path

    from numpy.typing import NDArray

    Triangles = NDArray[np.float32]

ENDINGS = frozenset({".stl", ".obj", ".dae"})
_MOST_BYTES = 50_000_000
_MOST_POINTS = 1_000_000
_HEAD_BYTES, _TRIANGLE_BYTES = 84, 50
_TRIANGLE = np.dtype([("normal", "<f4", 3), ("points", "<f4", (3, 3)), ("spare", "<u2")])


def read_points(path: Path) -> NDArray[np.float32]:
    """Return the corners of the triangles in a file, without their doubles.

    Raises:
        SimulationError: The file does not exist, is too large or is damaged.
    """
    found = read_triangles(path).reshape(-1, 3)
    if len(found) > _MOST_POINTS:
        raise SimulationError(f"{path} has {len(found)} points: the limit is {_MOST_POINTS}")
    return np.unique(found, axis=0)


def read_triangles(path: Path) -> Triangles:
    """Return the triangles in a file: for each, three points.

    Raises:
        SimulationError: The file does not exist, is too large or is damaged.
    """
    try:
        data = read_limited(path, _MOST_BYTES)
    except (OSError, ValueError) as error:
        raise SimulationError(f"the file {path} cannot be read: {error}") from error
    if len(data) > _MOST_BYTES:
        raise SimulationError(f"{path} has more than {_MOST_BYTES // 10**6} MB")
    try:
        # numpy would print a warning for a number that is too large, which `check_points` refuses.
        with np.errstate(all="ignore"):
            return _triangles(path, data)
    except ValueError as error:
        raise SimulationError(f"{path} is damaged: {error}") from error


def _triangles(path: Path, data: bytes) -> Triangles:
    if path.suffix.lower() == ".dae":
        return read_collada(data)
    return _binary_stl(data) if _is_binary(data) else _text(data)


def _is_binary(data: bytes) -> bool:
    count = int.from_bytes(data[80:84], "little")
    return len(data) == _HEAD_BYTES + count * _TRIANGLE_BYTES


def _binary_stl(data: bytes) -> Triangles:
    found: Triangles = np.frombuffer(data, _TRIANGLE, offset=_HEAD_BYTES)["points"]
    return found.reshape(-1, 3, 3)


def _text(data: bytes) -> Triangles:
    """Return the triangles of the lines `vertex x y z` (STL), or `v x y z` and `f 1 2 3` (OBJ)."""
    points: list[list[float]] = []
    corners: list[int] = []
    is_obj = False
    for line in data.splitlines():
        word, *rest = line.split() or [b""]
        if word in {b"vertex", b"v"}:
            is_obj |= word == b"v"
            points.append([float(number) for number in rest[:3]])
            if len(points) > _MOST_POINTS:
                raise ValueError(f"it has more than {_MOST_POINTS} points")
        elif word == b"f" and is_obj:
            corners += _fan([_index(text, len(points)) for text in rest])
            if len(corners) > 3 * _MOST_POINTS:
                raise ValueError(f"it has more than {_MOST_POINTS} triangles")
    if not points or any(len(point) != 3 for point in points):
        raise ValueError("it has no points")
    found = np.array(points, np.float32)
    if not corners:  # an STL file, or an OBJ file with points only: each point three times
        if not is_obj and len(found) % 3 == 0:
            return found.reshape(-1, 3, 3)
        return np.repeat(found[:, None], 3, axis=1)
    if max(corners) >= len(found) or min(corners) < 0:
        raise ValueError("a face has a point that does not exist")
    triangles: Triangles = found[np.array(corners)].reshape(-1, 3, 3)
    return triangles


def _index(text: bytes, count: int) -> int:
    """Return the place of a point in an OBJ file. Numbers below 0 count from the last point."""
    number = int(text.partition(b"/")[0])
    return number - 1 if number > 0 else count + number


def _fan(corners: list[int]) -> list[int]:
    """Return the corners of the triangles that fill a polygon."""
    inner = itertools.pairwise(corners[1:])
    return [corner for second, third in inner for corner in (corners[0], second, third)]
