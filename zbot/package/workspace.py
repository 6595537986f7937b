"""Workspace around the current folder, and the packages in it.

The search has limits for the depth and the number of folders, because the current folder may have
very many subfolders, and the import of a message package waits until the search ends.
"""

from __future__ import annotations

import os
import re
from pathlib import Path
from typing import TYPE_CHECKING, TypeAlias

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator

#: Files that make a folder a package: the manifest of ROS 2, and the setup files of Python.
MANIFEST = "package.xml"
SETUP_FILES = frozenset({"setup.py", "setup.cfg", "pyproject.toml"})
_MAX_PARENTS = 12
_MAX_DEPTH = 5
_DEPTH_ELSEWHERE = 1  # for a current folder outside any workspace
_MAX_FOLDERS = 2000
_MAX_MANIFEST = 65536
#: Names of folders that contain no sources.
SKIPPED = {"build", "install", "log", "node_modules", "site-packages", "__pycache__"}
_STOP_FILES = {"AMENT_IGNORE", "COLCON_IGNORE", "pyvenv.cfg"}
_NAME_TAG = re.compile(r"<name>\s*([a-zA-Z0-9][a-zA-Z0-9_-]*)\s*</name>")

#: Folders to search, each with the number of levels below it.
Roots: TypeAlias = "tuple[tuple[Path, int], ...]"


def search_roots() -> Roots:
    """Return the folders to search: from ZBOT_WORKSPACE, or else around the current folder."""
    named = os.environ.get("ZBOT_WORKSPACE", "")
    if named:
        parts = [part for part in named.split(os.pathsep) if part]
        return tuple((Path(part).expanduser(), _MAX_DEPTH) for part in parts)
    try:
        current = Path.cwd()
    except FileNotFoundError:  # the current folder was deleted
        return ()
    return _roots_around(current)


def set_workspace_variable(start: Path) -> None:
    """Set ZBOT_WORKSPACE to the workspaces of the current folder and of `start`.

    So this process and its children still find their packages after a change of the current folder.
    If ZBOT_WORKSPACE is set already, do nothing.
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
    """Yield every folder of the workspace that has a package.xml or a setup file.

    Args:
        bases: Folders to search instead of the workspace.
    """
    roots = [(base, _MAX_DEPTH) for base in bases] if bases else search_roots()
    seen = set()
    for root, depth in roots:
        for folder, names, below in walk(root, depth):
            if folder not in seen and (MANIFEST in names or _is_python_project(folder, names)):
                seen.add(folder)
                yield folder
            # A package.xml ends the search below its folder, except in the root.
            if folder != root and MANIFEST in names:
                below.clear()


def package_name(folder: Path) -> str:
    """Return the name in package.xml, or the folder's name if there is no name in it."""
    match = _NAME_TAG.search(read_text(folder / MANIFEST))
    return match[1] if match else folder.resolve().name


def walk(root: Path, depth: int) -> Iterator[tuple[Path, set[str], list[str]]]:
    """Visit a folder and its subfolders, level by level. Each level is sorted by name.

    Yields:
        The folder, the names of its entries, and a list of the subfolders to visit next. The caller
        can clear this list to skip them.
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
    """Return a folder's workspace: a `src` around or in the folder, or the package around it."""
    near = [folder for folder in (current, *current.parents)[:_MAX_PARENTS] if _may_search(folder)]
    for folder in near:
        # The `src` of a package contains its modules and is not a workspace.
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
    """Return whether the setup files install something and do not only configure tools."""
    if "setup.py" in names:
        return True
    marks = {"pyproject.toml": "[project", "setup.cfg": "[metadata]"}
    return any(mark in read_text(folder / name) for name, mark in marks.items() if name in names)


def read_text(path: Path) -> str:
    """Return at most 65536 characters of a file, or an empty string if it cannot be read."""
    try:
        with path.open(encoding="utf-8", errors="replace") as file:
            return file.read(_MAX_MANIFEST)
    except OSError:
        return ""


def _may_search(folder: Path) -> bool:
    """Return whether to search a folder. False for `/`, drives, the home folder and its parents."""
    home = Path(os.path.expanduser("~"))  # noqa: PTH111 - Path.home() raises if there is no home folder
    return folder != home and folder not in home.parents and folder != Path(folder.anchor)


def _entries(folder: str) -> tuple[set[str], list[str]]:
    """Return the names of a folder's entries, and the paths of its subfolders to search."""
    names: set[str] = set()
    folders: list[str] = []
    try:
        with os.scandir(folder) as entries:
            for entry in entries:
                names.add(entry.name)
                if _is_worth_searching(entry):
                    folders.append(entry.path)
    except OSError:  # missing, not a folder, or not readable
        return set(), []
    return names, sorted(folders)


def _is_worth_searching(entry: os.DirEntry[str]) -> bool:
    if entry.name.startswith(".") or entry.name in SKIPPED:
        return False
    return entry.is_dir(follow_symlinks=False)
