"""Search for packages with interface definitions in the workspace around the current folder."""

from __future__ import annotations

from typing import TYPE_CHECKING

from zbot.interfaces.kinds import KINDS
from zbot.package.workspace import MANIFEST, nearest_first, package_name, walk

if TYPE_CHECKING:
    from collections.abc import Iterator
    from pathlib import Path

    from zbot.package.workspace import Roots


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
