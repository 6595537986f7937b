"""Locations of definitions: zbot itself, the workspace, an installed ROS 2, Python packages.

zbot's copies of ROS 2's own packages come first, because every program needs them, and this folder
is the fastest to search.
The next locations are the workspace, the packages that the user has added with `zbot interface
add`, an installed ROS 2, and Python packages. zbot's copies of message packages for robots come
last: a robot may use another version of such a package, so the user's version must win.
"""

from __future__ import annotations

import functools
import sys
from importlib.machinery import PathFinder
from pathlib import Path
from typing import TYPE_CHECKING

from zbot.names import KINDS
from zbot.package.ros_variables import ament_prefixes
from zbot.package.user_folders import definitions_folder
from zbot.package.workspace import MANIFEST, Roots, nearest_first, package_name, search_roots, walk

if TYPE_CHECKING:
    from collections.abc import Iterator

_MAX_NAME_BYTES = 200
_SHIPPED = Path(__file__).parent / "defs"
_SHIPPED_FOR_ROBOTS = Path(__file__).parent / "robot_defs"


def package_folder(package: str) -> Path | None:
    """Return the folder of a package's definitions in the first location that has one, or None."""
    if not _is_file_name(package):
        return None
    return next(_folders(package), None)


def _is_file_name(name: str) -> bool:
    # Names come from other programs too. This rejects `..` and names that no file can have.
    return name.isidentifier() and len(name.encode(errors="replace")) <= _MAX_NAME_BYTES


def definition_file(package: str, kind: str, short: str) -> Path | None:
    """Return the file that defines an interface, or None if there is no file."""
    folder = package_folder(package) if _is_file_name(short) else None
    file = folder / kind / f"{short}.{kind}" if folder else None
    return file if file is not None and file.is_file() else None


def interface_files(package: str) -> list[Path]:
    """Return all definition files of a package."""
    folder = package_folder(package)
    return [file for kind in KINDS for file in folder.glob(f"{kind}/*.{kind}")] if folder else []


def shipped_packages() -> list[str]:
    """Return the packages whose definitions are part of zbot, sorted."""
    return sorted(core_packages() + packages_in(_SHIPPED_FOR_ROBOTS))


def core_packages() -> list[str]:
    """Return ROS 2's own packages, which no other location replaces, sorted."""
    return packages_in(_SHIPPED)


def has_other_versions(package: str) -> bool:
    """Return whether a package's definitions come from zbot's folder `robot_defs`.

    A robot may have another version of such a package.
    """
    folder = package_folder(package)
    return folder is not None and folder.parent == _SHIPPED_FOR_ROBOTS


def packages_in(parent: Path) -> list[str]:
    """Return the names of the packages in a folder that contains only packages, sorted."""
    folders = parent.iterdir() if parent.is_dir() else ()
    found = (folder for folder in folders if folder.name.isidentifier())
    return sorted(folder.name for folder in found if has_definitions(folder))


def known_packages() -> set[str]:
    """Return all packages with definitions, from all locations."""
    names = {*shipped_packages(), *_workspace()}
    names.update(packages_in(definitions_folder()))
    for share in _ament_shares():
        index = share / "ament_index" / "resource_index" / "rosidl_interfaces"
        names |= {entry.name for entry in index.glob("*") if has_definitions(share / entry.name)}
    return names | _installed_packages()


def _folders(package: str) -> Iterator[Path]:
    yield from filter(has_definitions, (_SHIPPED / package,))
    yield from _workspace().get(package, ())
    others = (definitions_folder(), *_ament_shares())
    yield from filter(has_definitions, (folder / package for folder in others))
    yield from _python_package_folders(package)
    yield from filter(has_definitions, (_SHIPPED_FOR_ROBOTS / package,))


def _workspace() -> dict[str, list[Path]]:
    return _scanned(search_roots())


@functools.lru_cache(maxsize=4)
def _scanned(roots: Roots) -> dict[str, list[Path]]:
    return packages_around(roots)


def _ament_shares() -> list[Path]:
    return [prefix / "share" for prefix in ament_prefixes()]


def _python_package_folders(package: str) -> Iterator[Path]:
    """Yield the folders of an installed Python package, without importing it."""
    spec = PathFinder.find_spec(package)
    locations = (spec and spec.submodule_search_locations) or ()
    yield from filter(has_definitions, map(Path, locations))


def _installed_packages() -> set[str]:
    """Return the Python packages on `sys.path` that have definitions."""
    return {
        folder.name
        for entry in sys.path
        if entry and (path := Path(entry)).is_dir()
        for folder in path.iterdir()
        if folder.name.isidentifier() and has_definitions(folder)
    }


def packages_around(roots: Roots) -> dict[str, list[Path]]:
    """Return the folders of the packages with definitions below the roots, by package name."""
    found: dict[str, list[Path]] = {}
    for root, depth in roots:
        for folder in nearest_first(_package_folders(root, depth)):
            found.setdefault(package_name(folder), []).append(folder)
    return found


def has_definitions(folder: Path) -> bool:
    """Return whether a folder has a msg, srv or action folder with definitions."""
    return any(next(folder.glob(f"{kind}/*.{kind}"), None) is not None for kind in KINDS)


def _package_folders(root: Path, depth: int) -> Iterator[Path]:
    """Yield the folders with definitions at or below a root."""
    for folder, names, below in walk(root, depth):
        if has_definitions(folder):
            yield folder
            below.clear()
        elif MANIFEST in names and folder != root:
            below.clear()
