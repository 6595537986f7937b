"""Workspaces, and the packages in them.

The search has limits for the depth and the number of folders, because the current folder may have
very many subfolders, and the import of a message package waits until the search ends.
"""

from __future__ import annotations

import functools
import itertools
import os
import re
from pathlib import Path
from typing import TYPE_CHECKING, TypeAlias

from zbot.package.errors import SetupFileError
from zbot.package.setup_file import project_table

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator

#: Environment variable with the folders of the workspaces that were sourced.
VARIABLE = "ZBOT_WORKSPACE"
#: Environment variable that puts these folders before the workspace of the current folder.
FIRST_VARIABLE = "ZBOT_WORKSPACE_FIRST"
#: Files that make a folder a package: the manifest of ROS 2, and the setup files of Python.
MANIFEST = "package.xml"
SETUP_FILES = frozenset({"setup.py", "setup.cfg", "pyproject.toml"})
#: Entries of a package's folder. A folder with definitions needs no manifest.
_PACKAGE_ENTRIES = {MANIFEST, *SETUP_FILES, "msg", "srv", "action"}
_MAX_PARENTS = 12
_MAX_DEPTH = 5
_DEPTH_ELSEWHERE = 1  # for a current folder outside any workspace
_DEPTH_OF_REPOSITORY = 3  # e.g. ros2_ws/src/package
_MAX_FOLDERS = 2000
_MAX_MANIFEST = 65536
#: Names of folders that contain no sources.
SKIPPED = {"build", "install", "log", "node_modules", "site-packages", "__pycache__"}
_STOP_FILES = {"AMENT_IGNORE", "CATKIN_IGNORE", "COLCON_IGNORE", "pyvenv.cfg"}
_NAME_TAG = re.compile(r"<name>\s*([a-zA-Z0-9][a-zA-Z0-9_-]*)\s*</name>")

#: Folders to search, each with the number of levels to search below it.
Roots: TypeAlias = "tuple[tuple[Path, int], ...]"


def search_roots() -> Roots:
    """Return the folders to search. A package in an earlier folder hides its copies in later ones.

    The order is: the workspace that is nearest to the current folder, the workspaces of
    ZBOT_WORKSPACE, the other workspaces around the current folder. Without a workspace, the result
    is the current folder with one level below it, or with three if it is a repository's root.
    """
    nearest, *outer = _workspaces_here() or [()]
    parts = [part for part in os.environ.get(VARIABLE, "").split(os.pathsep) if part]
    named = [(Path(part).expanduser(), _MAX_DEPTH) for part in parts]
    here = nearest or (() if named else _folder_here())
    first = (*named, *here) if os.environ.get(FIRST_VARIABLE) else (*here, *named)
    return tuple(dict.fromkeys((*first, *(root for roots in outer for root in roots))))


def current_workspace() -> Roots:
    """Return the folders of the workspace or package nearest to the current folder, if any."""
    nearest = next(iter(_workspaces_here()), ())
    return tuple(root for root in nearest if _is_workspace(*root))


def build_roots() -> Roots:
    """Return the folders that a build searches.

    Outside of a workspace, a build searches 5 levels below the current folder. colcon searches all
    levels.
    """
    here = current_workspace() or tuple((root, _MAX_DEPTH) for root, _ in _folder_here())
    return here or search_roots()  # the home folder and `/` are not searched


def _workspaces_here() -> list[Roots]:
    folder = _current_folder()
    return [] if folder is None else _workspaces_around(folder)


def _folder_here() -> Roots:
    folder = _current_folder()
    if folder is None or not _may_search(folder):
        return ()
    is_repository = (folder / ".git").exists()
    return ((folder, _DEPTH_OF_REPOSITORY if is_repository else _DEPTH_ELSEWHERE),)


def _current_folder() -> Path | None:
    try:
        return Path.cwd()
    except FileNotFoundError:
        return None  # it was deleted


def _is_workspace(root: Path, depth: int) -> bool:
    return depth == _MAX_DEPTH or (root / MANIFEST).is_file()


def set_workspace_variable(start: Path) -> None:
    """Set ZBOT_WORKSPACE to the workspaces of the current folder and of `start`.

    So this process and its children still find their packages after a change of the current folder.
    If ZBOT_WORKSPACE is set already, do nothing.
    """
    if os.environ.get(VARIABLE):
        return
    around = [*(_workspaces_here() or [_folder_here()]), *_workspaces_around(start.absolute())]
    found = (root for roots in around for root in roots)
    folders = dict.fromkeys(str(folder) for root in found for folder in _named_folders(*root))
    if folders:
        os.environ[VARIABLE] = os.pathsep.join(folders)


def _named_folders(root: Path, depth: int) -> Iterator[Path]:
    """Yield what ZBOT_WORKSPACE names for a root: the workspace, or else each package below it."""
    if _is_workspace(root, depth):
        yield root
    elif depth:
        found = (folder for folder, names, _ in walk(root, depth) if names & _PACKAGE_ENTRIES)
        yield from (folder for folder in found if folder != root)


def package_folders(
    bases: Iterable[Path] | None = None, roots: Roots | None = None
) -> Iterator[Path]:
    """Yield every folder of the workspace that has a package.xml or a setup file.

    If a folder has a pyproject.toml, no other such file, and packages below it, it is left out: it
    is the root of a repository and not a package.

    Args:
        bases: Folders to search instead of the workspace.
        roots: Folders to search instead of the workspace, each with the number of levels.
    """
    searched = [(base, _MAX_DEPTH) for base in bases] if bases else roots or search_roots()
    seen = set()
    for root, depth in searched:
        found: dict[Path, set[str]] = {}
        for folder, names, below in walk(root, depth):
            if folder not in seen and (MANIFEST in names or _is_python_project(folder, names)):
                seen.add(folder)
                found[folder] = names
            # A package.xml ends the search below its folder, except in the root.
            if folder != root and MANIFEST in names:
                below.clear()
        around = {parent for folder in found for parent in folder.parents}
        for folder in nearest_first(found):
            if folder not in around or found[folder] & {MANIFEST, "setup.py", "setup.cfg"}:
                yield folder


def nearest_first(folders: Iterable[Path]) -> list[Path]:
    """Sort folders by the number of parents that they share with the current folder."""
    here = _current_folder()
    parts = () if here is None else here.parts

    def distance(folder: Path) -> int:
        pairs = zip(parts, folder.parts, strict=False)
        return -len(list(itertools.takewhile(lambda pair: pair[0] == pair[1], pairs)))

    return sorted(folders, key=distance)


def packages_by_name(roots: Roots | None = None) -> dict[str, list[Path]]:
    """Return the folders of the workspace's packages by name. The first folder is the one to use.

    Args:
        roots: Folders to search instead of the workspace, each with the number of levels.
    """
    found: dict[str, list[Path]] = {}
    for folder in package_folders(roots=roots):
        found.setdefault(package_name(folder), []).append(folder)
    return found


def package_name(folder: Path) -> str:
    """Return the name in package.xml, or the folder's name if there is no name in it."""
    return name_in_manifest(read_text(folder / MANIFEST)) or folder.resolve().name


def name_in_manifest(text: str) -> str:
    """Return the name in the text of a package.xml, or an empty string if there is none."""
    match = _NAME_TAG.search(text)
    return match[1] if match else ""


def walk(root: Path, depth: int) -> Iterator[tuple[Path, set[str], list[str]]]:
    """Visit a folder and its subfolders, level by level. Each level is sorted by name.

    Symbolic links are followed. A folder that has several paths is visited only once.

    Yields:
        The folder, the names of its entries, and a list of the subfolders to visit next. The caller
        can clear this list to skip them.
    """
    level, seen = [str(root)], 0
    visited: set[tuple[int, int]] = set()
    for _ in range(depth + 1):
        following: list[str] = []
        for folder in level:
            seen += 1
            if seen > _MAX_FOLDERS:
                return
            if not _is_first_visit(folder, visited):
                continue
            names, folders = _entries(folder)
            if names & _STOP_FILES:
                continue
            yield Path(folder), names, folders
            following += folders
        level = following


def _workspaces_around(current: Path) -> list[Roots]:
    """Return the workspaces that contain a folder, the nearest first.

    The packages of a workspace are in a folder `src`, which is not the `src` of a package. Many
    people keep checkouts of all kinds in a folder `src`, which is no workspace. If there is no
    workspace, the result is the nearest package with a folder `src`, or else the nearest package
    and the packages beside it in a repository.
    """
    near = [folder for folder in (current, *current.parents)[:_MAX_PARENTS] if _may_search(folder)]
    found: list[Roots] = []
    for folder in near:
        # The `src` of a package contains its modules and is not a workspace.
        if folder.name == "src" and not _is_package(folder.parent):
            if folder != current and not _has_ros_packages(folder):
                continue
            found.append(((folder, _MAX_DEPTH),))
        elif (folder / "src").is_dir() and folder / "src" not in near and not _is_package(folder):
            found.append(((folder / "src", _MAX_DEPTH), (folder, 0)))
    if found:
        return found
    for folder in near:
        if (folder / "src").is_dir() and _is_package(folder):
            return [((folder / "src", _MAX_DEPTH), (folder, 0)), *_repository_around(folder)]
    for folder in near:
        if (folder / MANIFEST).is_file():
            return [((folder, _MAX_DEPTH),), *_repository_around(folder)]
    return []


def _repository_around(package: Path) -> list[Roots]:
    """Return the repository around a package, to search it down to the package's level."""
    for level, root in enumerate(package.parents[:_DEPTH_OF_REPOSITORY], 1):
        if (root / ".git").exists():
            return [((root, level),)] if _may_search(root) and not _is_package(root) else []
    return []


@functools.lru_cache(maxsize=16)
def _has_ros_packages(source: Path) -> bool:
    """Return whether a folder `src` has packages of ROS 2, or was built."""
    if (source.parent / "install").is_dir():
        return True
    return any(MANIFEST in names for _, names, _ in walk(source, _MAX_DEPTH))


def _is_package(folder: Path) -> bool:
    names = {name for name in (MANIFEST, *SETUP_FILES) if (folder / name).is_file()}
    return MANIFEST in names or _is_python_project(folder, names)


def _is_python_project(folder: Path, names: set[str]) -> bool:
    """Return whether the setup files install something and do not only configure tools."""
    if "setup.py" in names:
        return True
    if "setup.cfg" in names and "[metadata]" in read_text(folder / "setup.cfg"):
        return True
    return "pyproject.toml" in names and _has_project(folder / "pyproject.toml")


def _has_project(path: Path) -> bool:
    try:
        source = path.read_bytes()
        # Files without the word "project" are not parsed. Most of them only configure tools.
        return b"project" in source and bool(project_table(path, source))
    except OSError:
        return False
    except SetupFileError:  # commands that use this package report the error
        return "[project" in read_text(path)


def read_text(path: Path) -> str:
    """Return at most 65536 characters of a file, or an empty string if it cannot be read."""
    try:
        with path.open(encoding="utf-8", errors="replace") as file:
            return file.read(_MAX_MANIFEST)
    except OSError:
        return ""


def _may_search(folder: Path) -> bool:
    """Return whether to search a folder.

    The result is False for `/`, drives, the home folder and its parents.
    """
    home = Path(os.path.expanduser("~"))  # noqa: PTH111 - Path.home() raises if there is no home folder
    return folder != home and folder not in home.parents and folder != Path(folder.anchor)


def _is_first_visit(folder: str, visited: set[tuple[int, int]]) -> bool:
    try:
        status = os.stat(folder)  # noqa: PTH116 - `folder` is a text, because Path is slow
    except OSError:
        return False  # the folder was deleted, or the link points to nothing
    if not status.st_ino:  # some file systems do not number their files
        return True
    before = len(visited)
    visited.add((status.st_dev, status.st_ino))
    return len(visited) > before


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
    return entry.is_dir()
