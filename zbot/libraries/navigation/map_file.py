"""Reader and writer of maps in files: a YAML file and an image.

In a map, free cells are 0, occupied cells are 100, and unknown cells are -1.
"""

from __future__ import annotations

import math
from array import array
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from zbot.errors import ZbotError
from zbot.libraries.navigation.map_image import GreyImage, MapImageError, read_image, write_image
from zbot.text.limited_file import read_limited
from zbot.text.yaml_reader import YamlError, read_yaml

from nav_msgs.msg import OccupancyGrid

MODES = ("trinary", "scale", "raw")
FORMATS = ("pgm", "png", "bmp")
_UNKNOWN, _OCCUPIED = 255, 100  #: as bytes of an int8
_MAX_CHARACTERS = 100_000
_LARGEST = 1e9  #: a larger number in a map's YAML file is a mistake
#: Greys of a saved map of mode `trinary`, and the thresholds that separate them.
_FREE_GREY, _UNKNOWN_GREY = 254, 205
_SAVED_THRESHOLDS = (0.65, 0.196)


class MapFileError(ZbotError, ValueError):
    """A map cannot be read or written.

    Attributes:
        is_image: Whether the image is the problem, not the YAML file.
        is_missing: Whether the YAML file does not exist.
    """

    def __init__(self, reason: str, *, is_image: bool = False, is_missing: bool = False) -> None:
        self.is_image, self.is_missing = is_image, is_missing
        super().__init__(reason)


@dataclass(frozen=True)
class MapSettings:
    """Contents of a map's YAML file."""

    image: str
    resolution: float  #: metres per cell
    origin: tuple[float, float, float]  #: pose of the lower left cell: x, y in metres, yaw in rad
    occupied_thresh: float = 0.65
    free_thresh: float = 0.25
    mode: str = "trinary"
    negate: bool = False  #: whether white is occupied


def read_settings(text: str) -> MapSettings:
    """Return the settings in a YAML text.

    Raises:
        MapFileError: The text is not YAML, or a value is missing or invalid.
    """
    if len(text) > _MAX_CHARACTERS:
        raise MapFileError(f"it has more than {_MAX_CHARACTERS} characters")
    try:
        values = read_yaml(text)
    except YamlError as error:
        raise MapFileError(str(error)) from None
    if not isinstance(values, dict):
        raise MapFileError("it must have lines such as `image: map.pgm`")
    origin = values.get("origin")
    if not isinstance(origin, list) or len(origin) != 3:
        raise MapFileError("origin must be a list of three numbers: x, y and yaw")
    mode = values.get("mode", "trinary")
    if mode not in MODES:
        raise MapFileError(f"mode must be {', '.join(MODES)}, not {str(mode)[:40]!r}")
    image = values.get("image")
    if not isinstance(image, str) or not image or "\0" in image:
        raise MapFileError("image must be the path of an image")
    x, y, yaw = (_number({"origin": number}, "origin") for number in origin)
    resolution = _number(values, "resolution")
    if resolution <= 0:
        raise MapFileError("resolution must be above 0")
    return MapSettings(
        image,
        resolution,
        (x, y, yaw),
        _number(values, "occupied_thresh"),
        _number(values, "free_thresh"),
        mode,
        _flag(values, "negate"),
    )


def _flag(values: dict[Any, Any], name: str) -> bool:
    value = values.get(name)
    return value if isinstance(value, bool) else bool(_number(values, name))


def _number(values: dict[Any, Any], name: str) -> float:
    value: Any = values.get(name)
    is_number = isinstance(value, (int, float)) and not isinstance(value, bool)
    if not is_number or not math.isfinite(value) or abs(value) > _LARGEST:
        found = "missing" if value is None else repr(value)[:40]
        raise MapFileError(f"{name} must be a number: it is {found}")
    return float(value)


def read_map(path: str) -> OccupancyGrid:
    """Return the map of a YAML file. The stamps and the frame of the message are not set.

    Raises:
        MapFileError: The YAML file or the image cannot be read.
    """
    file = Path(path).expanduser()
    try:
        data = read_limited(file, _MAX_CHARACTERS)
        settings = read_settings(data.decode("utf-8", "replace"))
    except OSError as error:
        missing = isinstance(error, FileNotFoundError)
        raise MapFileError(f"cannot read '{path}': {error.strerror}", is_missing=missing) from None
    except MapFileError as error:
        raise MapFileError(f"the map '{path}' is not valid: {error}") from None
    try:
        image = read_image(file.parent / settings.image)
    except MapImageError as error:
        raise MapFileError(str(error), is_image=True) from None
    grid = OccupancyGrid()
    grid.info.width, grid.info.height = image.width, image.height
    grid.info.resolution = settings.resolution
    x, y, yaw = settings.origin
    grid.info.origin.position.x, grid.info.origin.position.y = x, y
    turn = grid.info.origin.orientation
    turn.z, turn.w = math.sin(yaw / 2), math.cos(yaw / 2)
    grid.data = array("b", cells(image, settings))
    return grid


def cells(image: GreyImage, settings: MapSettings) -> bytes:
    """Return the cells of a map as bytes, rows from the bottom."""
    found = image.pixels.translate(bytes(_cell(grey, settings) for grey in range(256)))
    if image.alpha is not None and settings.mode != "raw":
        pairs = zip(found, image.alpha, strict=True)
        found = bytes(cell if alpha == 255 else _UNKNOWN for cell, alpha in pairs)
    width = image.width
    rows = (found[start : start + width] for start in range(0, len(found), width))
    return b"".join(reversed(list(rows)))


def _cell(grey: int, settings: MapSettings) -> int:
    if settings.mode == "raw":
        return grey if grey <= _OCCUPIED else _UNKNOWN
    share = grey / 255 if settings.negate else 1 - grey / 255
    if share <= settings.free_thresh:
        return 0
    if share >= settings.occupied_thresh:
        return _OCCUPIED
    if settings.mode == "trinary":
        return _UNKNOWN
    between = settings.occupied_thresh - settings.free_thresh
    return round(_OCCUPIED * (share - settings.free_thresh) / between)


def write_map(
    grid: OccupancyGrid, path: str, image_format: str, mode: str, free: float, occupied: float
) -> Path:
    """Write a map as `path.yaml` and an image beside it. Return the path of the YAML file.

    Args:
        grid: The map.
        path: The path without a suffix.
        image_format: `pgm`, `png`, `bmp`, or "" for `pgm` (`png` in mode `scale`).
        mode: `trinary`, `scale`, `raw`, or "" for `trinary`.
        free: A cell whose occupancy (0 to 1) is not above this value is free. 0 means 0.25.
        occupied: A cell whose occupancy is not below this value is occupied. 0 means 0.65.

    Raises:
        MapFileError: A setting is invalid, or a file cannot be written.
    """
    mode = mode or "trinary"
    image_format = image_format.lower() or ("png" if mode == "scale" else "pgm")
    free, occupied = free or 0.25, occupied or 0.65
    if mode not in MODES:
        raise MapFileError(f"the mode must be {', '.join(MODES)}, not '{mode}'")
    if image_format not in FORMATS:
        raise MapFileError(f"the format must be {', '.join(FORMATS)}, not '{image_format}'")
    if not 0 <= free < occupied <= 1:
        found = f"{free:g} and {occupied:g}"
        raise MapFileError(f"the thresholds must be 0 <= free < occupied <= 1, not {found}")
    target = Path(path).expanduser()
    image = target.with_name(f"{target.name}.{image_format}")
    text = target.with_name(f"{target.name}.yaml")
    try:
        write_image(image, picture(grid, mode, free, occupied))
        text.write_text(_yaml(grid, image.name, mode, free, occupied), encoding="utf-8")
    except MapImageError as error:
        raise MapFileError(str(error), is_image=True) from None
    except OSError as error:
        raise MapFileError(f"cannot write '{text}': {error.strerror}") from None
    return text


def picture(grid: OccupancyGrid, mode: str, free: float, occupied: float) -> GreyImage:
    """Return the image of a map."""
    table = bytes(_grey(level, mode, free, occupied) for level in range(256))
    data = array("b", grid.data).tobytes()
    width = grid.info.width
    if width * grid.info.height != len(data) or not data:
        raise MapFileError(f"the map has {len(data)} cells, not {width} x {grid.info.height}")
    rows = [data[start : start + width] for start in range(0, len(data), width)]
    cells_from_top = b"".join(reversed(rows))
    alpha = None
    if mode == "scale":
        alpha = cells_from_top.translate(
            bytes(255 if level <= _OCCUPIED else 0 for level in range(256))
        )
    return GreyImage(width, grid.info.height, cells_from_top.translate(table), alpha)


def _grey(cell: int, mode: str, free: float, occupied: float) -> int:
    is_known = cell <= _OCCUPIED
    if mode == "raw":
        return cell if is_known else 255
    if mode == "scale":
        return round(255 * (_OCCUPIED - cell) / _OCCUPIED) if is_known else 128
    if is_known and cell <= round(free * 100):
        return _FREE_GREY
    return 0 if is_known and cell >= round(occupied * 100) else _UNKNOWN_GREY


def _yaml(grid: OccupancyGrid, image: str, mode: str, free: float, occupied: float) -> str:
    if mode == "trinary":
        occupied, free = _SAVED_THRESHOLDS
    origin = grid.info.origin
    q = origin.orientation
    yaw = math.atan2(2 * (q.w * q.z + q.x * q.y), 1 - 2 * (q.y * q.y + q.z * q.z))
    x, y = origin.position.x, origin.position.y
    return (
        f"image: {image}\nmode: {mode}\nresolution: {round(grid.info.resolution, 6)}\n"
        f"origin: [{x:.6g}, {y:.6g}, {yaw:.6g}]\nnegate: 0\n"
        f"occupied_thresh: {occupied}\nfree_thresh: {free}\n"
    )
