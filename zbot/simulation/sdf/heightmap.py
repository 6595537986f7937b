"""Heightmap in SDF: hills, whose heights are the greys of an image."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from zbot.libraries.navigation.map_image import MapImageError, read_image
from zbot.simulation.engine import engine
from zbot.simulation.errors import SimulationError
from zbot.tf2.rigid import Rigid, Vector

if TYPE_CHECKING:
    from pathlib import Path

    from numpy.typing import NDArray

_MOST_SIDE, _FARTHEST_M = 513, 10_000.0
_BASE_M = 1.0  #: how far the ground goes down below the lowest point
_WHITE = 255


class Heightmap(NamedTuple):
    """Hills of a `<heightmap>`."""

    file: Path
    size: Vector  #: along x and y, and the height of a white pixel
    pose: Rigid  #: the middle of the ground, at the height of a black pixel


def add_heightmap(spec: Any, name: str, hills: Heightmap) -> tuple[dict[str, Any], Rigid]:
    """Add hills to a world. Return their shape and their pose.

    Raises:
        SimulationError: The image cannot be read, or the size is not usual.
    """
    x, y, z = hills.size
    if not 0 < min(x, y) <= max(x, y, z) < _FARTHEST_M or z < 0:
        raise SimulationError(f"a <heightmap> has the size {hills.size}")
    greys = _greys(hills.file)
    low, high = int(np.min(greys)), int(np.max(greys))
    # The engine stretches all values to the range from 0 to 1.
    height = max((high - low) * z / _WHITE, 1e-3)
    spec.add_hfield(
        name=name,
        nrow=len(greys),
        ncol=len(greys[0]),
        size=(x / 2, y / 2, height, _BASE_M),
        userdata=greys.ravel().astype(float),
    )
    shape = {"type": engine().mjtGeom.mjGEOM_HFIELD, "hfieldname": name}
    return shape, hills.pose @ Rigid((0.0, 0.0, low * z / _WHITE))


def _greys(path: Path) -> NDArray[np.uint8]:
    """Return the pixels of an image, the lowest row first. A large image loses rows and columns."""
    try:
        image = read_image(path)
    except MapImageError as error:
        raise SimulationError(f"a <heightmap> cannot be read: {error}") from error
    if min(image.width, image.height) < 2:
        raise SimulationError(f"a <heightmap> needs more than one row and column: {path}")
    pixels = np.frombuffer(image.pixels, np.uint8).reshape(image.height, image.width)[::-1]
    rows, columns = (
        np.linspace(0, side - 1, min(side, _MOST_SIDE)).round().astype(int)
        for side in (image.height, image.width)
    )
    found: NDArray[np.uint8] = pixels[np.ix_(rows, columns)]
    return found
