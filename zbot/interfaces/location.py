"""Locations of definitions: zbot itself, the workspace, an installed ROS 2, Python packages."""

from __future__ import annotations

import functools
import os
import sys
from importlib.machinery import PathFinder
from pathlib import Path
from typing import TYPE_CHECKING

from zbot.interfaces.kinds import KINDS
from zbot.interfaces.workspace import has_definitions, packages_around
from zbot.package.workspace import Roots, search_roots

if TYPE_CHECKING:
    from collections.abc import Iterator

_SHIPPED = Path(__file__).parent / "defs"


def package_folder(package: str) -> Path | None:
    """Return the folder with a package's definitions, from the first location with such a folder.

    zbot's own folder is the first location, so the types that every program uses are found fast.
    """
    if not package.isidentifier():  # this also rejects `..` in a path
        return None
    return next(_folders(package), None)


def definition_file(package: str, kind: str, short: str) -> Path | None:
    """Return the file that defines an interface, or None if there is no file."""
    folder = package_folder(package)
    file = folder / kind / f"{short}.{kind}" if folder else None
    return file if file is not None and file.is_file() else None


def interface_files(package: str) -> list[Path]:
    """Return all definition files of a package."""
    folder = package_folder(package)
    return [file for kind in KINDS for file in folder.glob(f"{kind}/*.{kind}")] if folder else []


def shipped_packages() -> list[str]:
    """Return the packages whose definitions are part of zbot, sorted."""
    return sorted(folder.name for folder in _SHIPPED.iterdir() if has_definitions(folder))


def known_packages() -> set[str]:
    """Return all packages with definitions, from all locations."""
    names = {*shipped_packages(), *_workspace()}
    for share in _ament_shares():
        index = share / "ament_index" / "resource_index" / "rosidl_interfaces"
        names |= {entry.name for entry in index.glob("*") if has_definitions(share / entry.name)}
    return names | _installed_packages()


def _folders(package: str) -> Iterator[Path]:
    yield from filter(has_definitions, (_SHIPPED / package,))
    yield from _workspace().get(package, ())
    yield from filter(has_definitions, (share / package for share in _ament_shares()))
    yield from _python_package_folders(package)


def _workspace() -> dict[str, list[Path]]:
    return _scanned(search_roots())


@functools.lru_cache(maxsize=4)
def _scanned(roots: Roots) -> dict[str, list[Path]]:
    return packages_around(roots)


def _ament_shares() -> list[Path]:
    prefixes = os.environ.get("AMENT_PREFIX_PATH", "").split(os.pathsep)
    return [Path(prefix) / "share" for prefix in prefixes if prefix]


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
