"""Where definitions are: shipped, in the workspace, in a ROS 2 installation, in Python packages."""

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
    """The folder with a package's definitions, in the first place that has it.

    What zbot ships comes first: then the types that every program uses are found at once.
    """
    if not package.isidentifier():  # also keeps `..` and the like out of paths
        return None
    return next(_folders(package), None)


def definition_file(package: str, kind: str, short: str) -> Path | None:
    """The file that defines an interface; None if there is none."""
    folder = package_folder(package)
    file = folder / kind / f"{short}.{kind}" if folder else None
    return file if file is not None and file.is_file() else None


def interface_files(package: str) -> list[Path]:
    """Every definition file of a package."""
    folder = package_folder(package)
    return [file for kind in KINDS for file in folder.glob(f"{kind}/*.{kind}")] if folder else []


def shipped_packages() -> list[str]:
    """The packages whose definitions come with zbot, sorted."""
    return sorted(folder.name for folder in _SHIPPED.iterdir() if has_definitions(folder))


def known_packages() -> set[str]:
    """Every package that has definitions somewhere."""
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
    """An installed Python package's own folder; nothing is imported, only paths are looked at."""
    spec = PathFinder.find_spec(package)
    locations = (spec and spec.submodule_search_locations) or ()
    yield from filter(has_definitions, map(Path, locations))


def _installed_packages() -> set[str]:
    """Python packages with definitions, on `sys.path`."""
    return {
        folder.name
        for entry in sys.path
        if entry and (path := Path(entry)).is_dir()
        for folder in path.iterdir()
        if folder.name.isidentifier() and has_definitions(folder)
    }
