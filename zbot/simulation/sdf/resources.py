"""Files that SDF names by addresses such as `model://NAME/FILE`."""

from __future__ import annotations

import os
import re
import time
from functools import cache, lru_cache
from pathlib import Path
from urllib.parse import unquote, urlsplit

from zbot.errors import ZbotError
from zbot.libraries.robot_description.mesh_address import path_of
from zbot.libraries.robot_description.xml_text import DescriptionError
from zbot.package import package_share
from zbot.package.finder import Origin, all_packages, is_python_package
from zbot.package.manifest import read_tree
from zbot.package.unavailable import unavailable_package

#: Variables that name folders with models, of both generations of Gazebo.
_VARIABLES = (
    *("GZ_SIM_RESOURCE_PATH", "IGN_GAZEBO_RESOURCE_PATH", "GAZEBO_MODEL_PATH"),
    *("GAZEBO_RESOURCE_PATH", "SDF_PATH"),
)
_EXPORTS = ("gazebo_model_path", "gazebo_media_path")
_NAME = re.compile(r"[a-zA-Z0-9][a-zA-Z0-9_-]+", re.ASCII)  # of a package
_REMOTE = frozenset({"http", "https", "fuel"})


def find_resource(address: str, folder: Path | None = None) -> Path | None:
    """Return the path of a file or a folder, or None if it is not on this machine.

    Args:
        address: A path, or an address with `model://`, `file://` or `package://`.
        folder: The folder of the file that has the address.
    """
    try:
        parts = urlsplit(address.strip())
    except ValueError:
        return None
    place = unquote(f"{parts.netloc}{parts.path}")
    if parts.scheme in _REMOTE:
        return _downloaded(parts.netloc, parts.path)
    if ".." in Path(place).parts and parts.scheme:
        return None
    if parts.scheme == "model":
        return _model(place)
    if parts.scheme == "file" and not place.startswith("/"):
        return _in_folders(place)
    if parts.scheme == "package" and not _may_exist(parts.netloc):
        return None
    if parts.scheme in {"file", "package"}:
        try:
            return _existing(path_of(address))
        except DescriptionError:
            return None
    if folder is not None and (found := _existing(folder / address)):
        return found
    return _existing(Path(address)) or _in_folders(address)


def search_folders() -> list[Path]:
    """Return the folders in which models are searched."""
    named = (os.environ.get(name, "") for name in _VARIABLES)
    entries = [entry for value in named for entry in value.split(os.pathsep) if entry]
    return [*map(Path, entries), *_exported(), Path.home() / ".gazebo" / "models"]


def _model(place: str) -> Path | None:
    found = _in_folders(place)
    if found is None:
        # Gazebo turns package://NAME into model://NAME.
        name, _, rest = place.partition("/")
        try:
            found = _existing(package_share(name) / rest) if _may_exist(name) else None
        except ZbotError:
            return None
    return found


def _may_exist(package: str) -> bool:
    """Return whether there may be a package of this name, without a search for each name.

    A search takes long, and a world can name thousands of models that are not on this machine.
    """
    if not _NAME.fullmatch(package):
        return False
    return (
        package in _packages_at(int(time.monotonic()))
        or is_python_package(package)
        or unavailable_package(package) is not None
    )


@lru_cache(maxsize=1)
def _packages_at(_second: int) -> frozenset[str]:
    """Return the names of all packages. They are kept for a second."""
    return frozenset(all_packages())


def _in_folders(place: str) -> Path | None:
    found = (_existing(folder / place) for folder in search_folders())
    return next(filter(None, found), None)


def _existing(path: Path) -> Path | None:
    try:
        return path if path.exists() else None
    except (OSError, ValueError):
        return None


def _downloaded(host: str, path: str) -> Path | None:
    """Return the newest folder of a model that Gazebo has downloaded before."""
    owner, kind, name = (*path.strip("/").split("/")[1:4], "", "", "")[:3]
    for start in (".gz", ".ignition"):
        folder = Path.home() / start / "fuel" / host / owner.lower() / kind / name.lower()
        try:
            versions = [entry for entry in folder.glob("*") if entry.name.isdecimal()]
        except (OSError, ValueError):  # the name cannot be one of a folder
            return None
        if name and ".." not in path and versions:
            return max(versions, key=lambda entry: int(entry.name))
    return None


@cache
def _exported() -> tuple[Path, ...]:
    """Return the folders that packages export, and their folders of models and worlds."""
    found = []
    for package in all_packages().values():
        if package.origin is Origin.BUNDLED:
            continue
        own = (package.folder / name for name in ("models", "worlds"))
        found += [folder for folder in own if folder.is_dir()]
        found += _in_manifest(package.folder)
    return tuple(found)


def _in_manifest(folder: Path) -> list[Path]:
    try:
        exports = read_tree(folder / "package.xml").findall("export/gazebo_ros")
    except ZbotError:
        return []
    named = (tag.get(name, "") for tag in exports for name in _EXPORTS)
    entries = (entry for value in named for entry in value.split(":") if entry)
    return [Path(entry.replace("${prefix}", str(folder))) for entry in entries]
