"""Limits of worlds in MJCF, whose short texts can ask for much memory."""

from __future__ import annotations

from typing import TYPE_CHECKING

from zbot.simulation.errors import SimulationError
from zbot.text.limited_file import read_limited

if TYPE_CHECKING:
    from pathlib import Path
    from xml.etree.ElementTree import Element

#: Tags that read other files, run other code, or make many bodies from one line.
_REFUSED = frozenset(
    {
        *("include", "extension", "plugin", "replicate", "composite", "flexcomp"),
        *("model", "attach"),
    }
)
#: The largest values of attributes that are counts.
_MOST = {
    **dict.fromkeys(("nrow", "ncol", "width", "height", "gridsize"), 4096),
    **dict.fromkeys(("dim", "actdim", "num", "nsample", "nkey"), 1000),
    "octree_maxdepth": 7,
}
_MOST_OF_SIZE = 10_000
_MOST_TAGS = {"geom": 20_000, "body": 2000, "key": 1000}
#: Meshes that MuJoCo makes of some numbers, and the largest of these numbers.
_MOST_MADE_MESHES, _MOST_PARAMETER = 50, 100
#: Numbers of the user for each body, solid and so on.
_MOST_USER_NUMBERS = 100
_MOST_FOLDERS = 20
_MOST_BYTES, _MOST_PIXELS = 50_000_000, 16_000_000
_PNG, _PNG_HEAD = b"\x89PNG\r\n\x1a\n", 24


def check_mjcf(root: Element, folder: Path) -> None:
    """Refuse a world that needs too much memory, or that reads what is no file.

    Args:
        root: The world.
        folder: The folder of the files that it names.

    Raises:
        SimulationError: It is too large, or has a tag that is not allowed.
    """
    counts = dict.fromkeys(_MOST_TAGS, 0)
    made = sum("builtin" in mesh.attrib for mesh in root.iter("mesh"))
    if made > _MOST_MADE_MESHES:
        raise SimulationError(f"it has more than {_MOST_MADE_MESHES} meshes with builtin")
    for element in root.iter():
        if element.tag in _REFUSED and element is not root:
            raise SimulationError(f"the tag <{element.tag}> is not supported")
        if element.tag in counts:
            counts[element.tag] += 1
        _check_counts(element)
    for tag, count in counts.items():
        if count > _MOST_TAGS[tag]:
            raise SimulationError(f"it has {count} <{tag}> tags: the limit is {_MOST_TAGS[tag]}")
    _check_files(root, folder)


def _check_counts(element: Element) -> None:
    for name, text in element.attrib.items():
        most = _MOST.get(name)
        if name.startswith("nuser_"):
            most = _MOST_USER_NUMBERS
        if name == "params" and "builtin" in element.attrib:
            most = _MOST_PARAMETER
        if (element.tag == "size" and name.startswith("n")) or (
            element.tag == "numeric" and name == "size"
        ):
            most = most or _MOST_OF_SIZE
        if most is not None and any(_number(word) > most for word in text.split()):
            raise SimulationError(f"{name}='{text[:40]}' of <{element.tag}> is above {most}")


def _number(word: str) -> float:
    try:
        return float(word)
    except ValueError:
        return 0.0


def _check_files(root: Element, folder: Path) -> None:
    """Check the sizes of all files, and the pixels of all pictures and fields of heights."""
    names = ("meshdir", "texturedir", "assetdir")
    named = (compiler.get(name, "") for compiler in root.iter("compiler") for name in names)
    folders = [folder / place for place in dict.fromkeys(("", *named))]
    if len(folders) > _MOST_FOLDERS:
        raise SimulationError(f"it names more than {_MOST_FOLDERS} folders of files")
    known: dict[str, tuple[int, int]] = {}  # a world may use a file often
    total = pixels = 0
    for element in root.iter():
        sides = (("nrow", "ncol"), ("width", "height"))
        pixels += sum(
            int(_number(element.get(a, "0")) * _number(element.get(b, "0"))) for a, b in sides
        )
        for name, value in element.attrib.items():
            if name.startswith("file"):
                if value not in known:
                    known[value] = _measured(value, folders)
                size, count = known[value]
                total, pixels = total + size, pixels + count
                if total > 4 * _MOST_BYTES:
                    raise SimulationError(f"its files have more than {4 * _MOST_BYTES // 10**6} MB")
    if pixels > _MOST_PIXELS:
        raise SimulationError(f"its pictures have more than {_MOST_PIXELS} pixels")


def _measured(name: str, folders: list[Path]) -> tuple[int, int]:
    """Return the number of bytes of a file, and of its pixels if it is a picture."""
    sizes = [(0, 0)]
    for folder in folders:
        for path in {folder / name, folder / name.replace("\\", "/").rpartition("/")[2]}:
            try:
                data = read_limited(path, _MOST_BYTES)
            except FileNotFoundError:
                continue
            except (OSError, ValueError) as error:
                raise SimulationError(f"the file {path} cannot be read: {error}") from error
            if len(data) > _MOST_BYTES:
                raise SimulationError(f"{path} has more than {_MOST_BYTES // 10**6} MB")
            sizes.append((len(data), _pixels(data)))
    return max(sizes)


def _pixels(data: bytes) -> int:
    if not data.startswith(_PNG) or len(data) < _PNG_HEAD:
        return 0
    return int.from_bytes(data[16:20], "big") * int.from_bytes(data[20:24], "big")
