"""Finder of packages in the workspace, bundled with zbot, or installed in a prefix."""

from __future__ import annotations

import site
import sys
from dataclasses import dataclass
from enum import Enum
from importlib.machinery import PathFinder
from pathlib import Path
from typing import TYPE_CHECKING

from zbot.package.bundled_nodes import BUNDLED_NODES
from zbot.package.ros_variables import ament_prefixes
from zbot.package.user_folders import definitions_folder
from zbot.package.workspace import MANIFEST, package_folders, package_name
from zbot.text.json_reader import JsonError, read_json_object

if TYPE_CHECKING:
    from collections.abc import Iterator

_ZBOT = Path(__file__).parents[1]
_DEFINITIONS = (_ZBOT / "interfaces" / "defs", _ZBOT / "interfaces" / "robot_defs")
#: Folder of the Python packages that zbot has under the import names of ROS 2.
COMPAT_PACKAGES = _ZBOT / "compat" / "packages"
_SHARE = _ZBOT / "share"
#: Package names under which zbot's own nodes and launch files can be used.
BUNDLED_NAMES = ("zbot", "zbot_nodes", "demo_nodes_py", "demo_nodes_cpp")
_OURS = ("launch",)
_INDEX = Path("share", "ament_index", "resource_index", "packages")
#: An installed Python package counts as a ROS 2 package if its folder contains one of these.
_MARKS = (MANIFEST, "launch", "msg", "srv", "action")


class Origin(Enum):
    """Origin of a package."""

    WORKSPACE = "workspace"
    BUNDLED = "bundled"
    INSTALLED = "installed"


@dataclass(frozen=True)
class Package:
    """A package that the finder has found."""

    name: str
    folder: Path  #: its sources, or its installed share folder
    origin: Origin
    prefix: Path | None = None  #: the prefix where the package is installed, or None
    only: tuple[str, ...] = ()  #: the folders in `folder` that belong to the package (empty: all)
    launch: Path | None = None  #: the folder of the launch files if it is not in `folder`


def all_packages() -> dict[str, Package]:
    """Return every package, sorted by name. Of packages with the same name, return the first."""
    found: dict[str, Package] = {}
    for place in (_workspace(), _added(), _bundled(), _in_prefixes()):
        for package in place:
            found.setdefault(package.name, package)
    return dict(sorted(found.items()))


def find_package(name: str) -> Package | None:
    """Return the package of that name, or None if there is no such package."""
    places = (
        *(_workspace(), _added(), _bundled(), _in_prefixes()),
        *(_python_package(name), _editable(name)),
    )
    for place in places:
        for package in place:
            if package.name == name:
                return package
    return None


def is_python_package(name: str) -> bool:
    """Return whether `find_package` finds a package that `all_packages` does not list."""
    return any(package for place in (_python_package(name), _editable(name)) for package in place)


def searched_folders() -> list[Path]:
    """Return the folders in which `find_package` searches, for error messages."""
    from zbot.package.workspace import search_roots  # noqa: PLC0415 - for errors only

    return [*(root for root, _ in search_roots()), *prefixes()]


def _workspace() -> Iterator[Package]:
    for folder in package_folders():
        yield Package(package_name(folder), folder, Origin.WORKSPACE)


def _added() -> Iterator[Package]:
    """Yield the packages of `zbot interface add`."""
    parent = definitions_folder()
    for folder in sorted(parent.iterdir()) if parent.is_dir() else ():
        if folder.name.isidentifier() and folder.is_dir():
            yield Package(folder.name, folder, Origin.INSTALLED)


def _bundled() -> Iterator[Package]:
    share = _SHARE if _SHARE.is_dir() else _ZBOT.parent  # a checkout has no share folder
    for name in BUNDLED_NAMES:
        own = share / "launch" / name
        has_own = own.is_dir()
        yield Package(
            name, own if has_own else share, Origin.BUNDLED, only=() if has_own else _OURS
        )
    for parent in (*_DEFINITIONS, COMPAT_PACKAGES):
        if parent.is_dir():
            folders = (entry for entry in parent.iterdir() if entry.name.isidentifier())
            yield from (_bundled_package(folder, share) for folder in folders if folder.is_dir())
    # These packages come last, because a package above may have the same name and contain messages.
    for name in BUNDLED_NODES:
        yield Package(name, share / "launch" / name, Origin.BUNDLED)


def _bundled_package(folder: Path, share: Path) -> Package:
    launch = share / "launch" / folder.name
    own = launch if launch.is_dir() else None
    return Package(folder.name, folder, Origin.BUNDLED, launch=own)


def prefixes() -> list[Path]:
    """Return pip's prefixes, then the prefixes in AMENT_PREFIX_PATH."""
    own = [sys.prefix, site.getuserbase()] if site.ENABLE_USER_SITE else [sys.prefix]
    return [*(Path(entry) for entry in own if entry), *ament_prefixes()]


def _in_prefixes() -> Iterator[Package]:
    for prefix in prefixes():
        marked = {entry.name for entry in prefix.joinpath(_INDEX).glob("[!.]*")}
        described = {entry.parent.name for entry in prefix.glob(f"share/*/{MANIFEST}")}
        for name in sorted(marked | described):
            yield Package(name, prefix / "share" / name, Origin.INSTALLED, prefix)


def _python_package(name: str) -> Iterator[Package]:
    """Yield the folder of an installed Python package, without importing it."""
    spec = PathFinder.find_spec(name) if name.isidentifier() else None
    for location in (spec and spec.submodule_search_locations) or ():
        folder = Path(location)
        if any((folder / mark).exists() for mark in _MARKS):
            yield Package(name, folder, Origin.INSTALLED)


def _editable(name: str) -> Iterator[Package]:
    """Yield the sources of a package after `pip install -e .`, which installs no shared files."""
    from importlib.metadata import PackageNotFoundError, distribution  # noqa: PLC0415 - few packages need it
    from urllib.parse import urlsplit  # noqa: PLC0415 - as above
    from urllib.request import url2pathname  # noqa: PLC0415 - as above

    try:
        text = distribution(name).read_text("direct_url.json") or "{}"
        origin = read_json_object(text)
    except (PackageNotFoundError, JsonError):
        return
    folder = origin.get("dir_info")
    if isinstance(folder, dict) and folder.get("editable"):
        yield Package(
            name, Path(url2pathname(urlsplit(str(origin.get("url"))).path)), Origin.WORKSPACE
        )
