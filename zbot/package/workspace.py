"""The workspace around the current folder, and the packages in it.

The search is bounded in depth and number of folders: it may start anywhere, and an import waits for
it.
"""

from __future__ import annotations

import os
import re
from pathlib import Path
from typing import TYPE_CHECKING, TypeAlias

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator

#: Files that make a folder a package; the first is ROS 2's.
MANIFEST = "package.xml"
SETUP_FILES = frozenset({"setup.py", "setup.cfg", "pyproject.toml"})
_MAX_PARENTS = 12
_MAX_DEPTH = 5
_DEPTH_ELSEWHERE = 1  # in a current folder that belongs to no workspace
_MAX_FOLDERS = 2000
_MAX_MANIFEST = 65536
#: Folders that hold no sources.
SKIPPED = {"build", "install", "log", "node_modules", "site-packages", "__pycache__"}
_STOP_FILES = {"AMENT_IGNORE", "COLCON_IGNORE", "pyvenv.cfg"}
_NAME_TAG = re.compile(r"<name>\s*([a-zA-Z0-9][a-zA-Z0-9_-]*)\s*</name>")

#: Folders to search, each with the number of levels below it.
Roots: TypeAlias = "tuple[tuple[Path, int], ...]"


def search_roots() -> Roots:
    """Where to look: the folders of ZBOT_WORKSPACE, else those around the current one."""
    named = os.environ.get("ZBOT_WORKSPACE", "")
    if named:
        parts = [part for part in named.split(os.pathsep) if part]
        return tuple((Path(part).expanduser(), _MAX_DEPTH) for part in parts)
    try:
        current = Path.cwd()
    except FileNotFoundError:  # the current folder was removed under this process
        return ()
    return _roots_around(current)


def stay_in_workspace(start: Path) -> None:
    """Keep to the workspaces of the current folder and of another, wherever this process goes.

    The processes that it starts keep to them too: a program may change its folder, and its packages
    are still found. Where ZBOT_WORKSPACE is set already, nothing changes.
    """
    if os.environ.get("ZBOT_WORKSPACE"):
        return
    folders: dict[str, None] = {}
    for root, depth in (*search_roots(), *_roots_around(start.absolute())):
        if depth == _MAX_DEPTH or (root / MANIFEST).is_file():
            folders[str(root)] = None
    if folders:
        os.environ["ZBOT_WORKSPACE"] = os.pathsep.join(folders)


def package_folders(bases: Iterable[Path] | None = None) -> Iterator[Path]:
    """The folder of every package of the workspace: each has a package.xml or a setup file.

    Args:
        bases: Where to look instead.
    """
    roots = [(base, _MAX_DEPTH) for base in bases] if bases else search_roots()
    seen = set()
    for root, depth in roots:
        for folder, names, below in walk(root, depth):
            if folder not in seen and (MANIFEST in names or _is_python_project(folder, names)):
                seen.add(folder)
                yield folder
            # The root may be a package and the workspace of others too, and so may a repository.
            if folder != root and MANIFEST in names:
                below.clear()


def package_name(folder: Path) -> str:
    """The name in package.xml, else the folder's."""
    match = _NAME_TAG.search(read_text(folder / MANIFEST))
    return match[1] if match else folder.resolve().name


def walk(root: Path, depth: int) -> Iterator[tuple[Path, set[str], list[str]]]:
    """Visit a folder and those below it, level by level, each level by name.

    Yields:
        The folder, the names of all that is in it, and the paths of the folders in it that are
        visited next: clear the list to leave them out.
    """
    level, seen = [str(root)], 0
    for _ in range(depth + 1):
        following: list[str] = []
        for folder in level:
            seen += 1
            if seen > _MAX_FOLDERS:
                return
            names, folders = _entries(folder)
            if names & _STOP_FILES:
                continue
            yield Path(folder), names, folders
            following += folders
        level = following


def _roots_around(current: Path) -> Roots:
    """The workspace of a folder: a `src` that it is in or has, else the package that it is in."""
    near = [folder for folder in (current, *current.parents)[:_MAX_PARENTS] if _may_search(folder)]
    for folder in near:
        # Not the `src` of a package that keeps its modules there.
        if folder.name == "src" and not _is_package(folder.parent):
            return ((folder, _MAX_DEPTH),)
    for folder in near:
        if (folder / "src").is_dir():
            return ((folder / "src", _MAX_DEPTH), (folder, 0))
    for folder in near:
        if (folder / MANIFEST).is_file():
            return ((folder, _MAX_DEPTH),)
    return ((current, _DEPTH_ELSEWHERE),) if current in near else ()


def _is_package(folder: Path) -> bool:
    names = {name for name in (MANIFEST, *SETUP_FILES) if (folder / name).is_file()}
    return MANIFEST in names or _is_python_project(folder, names)


def _is_python_project(folder: Path, names: set[str]) -> bool:
    """Whether setup files are there to install something, and not only to configure tools."""
    if "setup.py" in names:
        return True
    marks = {"pyproject.toml": "[project", "setup.cfg": "[metadata]"}
    return any(mark in read_text(folder / name) for name, mark in marks.items() if name in names)


def read_text(path: Path) -> str:
    """The beginning of a small file; nothing if it cannot be read."""
    try:
        with path.open(encoding="utf-8", errors="replace") as file:
            return file.read(_MAX_MANIFEST)
    except OSError:
        return ""


def _may_search(folder: Path) -> bool:
    """Not the home folder, nor what is above it: those hold everything that a user has."""
    home = Path(os.path.expanduser("~"))  # noqa: PTH111 - Path.home() raises where there is none
    return folder != home and folder not in home.parents and folder != Path(folder.anchor)


def _entries(folder: str) -> tuple[set[str], list[str]]:
    """Names of everything in a folder, and paths of the folders in it worth looking into."""
    names: set[str] = set()
    folders: list[str] = []
    try:
        with os.scandir(folder) as entries:
            for entry in entries:
                names.add(entry.name)
                if _is_worth_searching(entry):
                    folders.append(entry.path)
    except OSError:  # not there, not a folder, or not ours to read
        return set(), []
    return names, sorted(folders)


def _is_worth_searching(entry: os.DirEntry[str]) -> bool:
    if entry.name.startswith(".") or entry.name in SKIPPED:
        return False
    return entry.is_dir(follow_symlinks=False)
