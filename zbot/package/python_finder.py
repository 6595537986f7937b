"""Source of the Python packages in the workspace, for programs whose workspace was sourced.

`source install/setup.bash`, `zbot run`, `zbot launch` and `zbot test` set ZBOT_WORKSPACE. With this
variable, programs and their child processes can import the Python packages of the workspace from
the sources.
"""

from __future__ import annotations

import contextlib
import functools
import os
import sys
from importlib.machinery import ModuleSpec, PathFinder
from importlib.util import spec_from_file_location
from typing import TYPE_CHECKING

from zbot.package import import_finder
from zbot.package.errors import SetupFileError
from zbot.package.workspace import VARIABLE, Roots, package_folders, read_text, search_roots

if TYPE_CHECKING:
    from collections.abc import Sequence
    from pathlib import Path
    from types import ModuleType

#: Files beside a Python package that are not installed with it.
_NOT_INSTALLED = {"setup", "conftest"}


#: Whether to search the workspace of the current folder if ZBOT_WORKSPACE is not set.
_searches_always = False


def install(*, searches_always: bool = False) -> None:
    """Let Python import the packages of the workspace. A second call has no effect.

    The folder of a ROS 2 package and the Python package in it usually have the same name. If a
    program runs in the parent of this folder, Python's own finder would import the folder as a
    package without modules.

    Args:
        searches_always: Whether to search the workspace of the current folder from now on, even if
            no workspace was sourced.
    """
    global _searches_always  # noqa: PLW0603 - all programs of the process share the finder
    _searches_always |= searches_always
    import_finder.add("workspace", find_package)


def find_package(
    fullname: str, path: Sequence[str] | None = None, target: ModuleType | None = None
) -> ModuleSpec | None:
    """Return the spec of a top-level module in the workspace. Python finds its submodules."""
    if path is not None or not (_searches_always or os.environ.get(VARIABLE)):
        return None
    if fullname in _NOT_INSTALLED or fullname in sys.stdlib_module_names:
        return None
    roots = search_roots()
    spec = _declared(fullname, roots) or PathFinder.find_spec(fullname, _paths(roots), target)
    is_installed = import_finder.is_real(PathFinder.find_spec(fullname, None, target))
    return spec if import_finder.is_real(spec) and not is_installed else None


def import_paths(folder: Path) -> list[str]:
    """Return the folders in which Python finds the modules of a package."""
    inner = folder / "src"
    has_inner = inner.is_dir() and any(inner.glob("*/__init__.py"))
    return [str(inner), str(folder)] if has_inner else [str(folder)]


def _declared(name: str, roots: Roots) -> ModuleSpec | None:
    """Return the spec of a package that a CMakeLists.txt installs from a folder of its choice."""
    folder = _declared_folders(roots).get(name)
    if folder is None or not (folder / "__init__.py").is_file():
        return None
    return spec_from_file_location(
        name, folder / "__init__.py", submodule_search_locations=[str(folder)]
    )


@functools.lru_cache(maxsize=4)
def _declared_folders(roots: Roots) -> dict[str, Path]:
    found: dict[str, Path] = {}
    for folder in package_folders(roots=roots):
        if "PACKAGE_DIR" in read_text(folder / "CMakeLists.txt"):
            from zbot.package.cmake_file import read_cmake  # noqa: PLC0415 - few packages need it

            with contextlib.suppress(SetupFileError):  # `zbot build` reports it
                found = {**read_cmake(folder).python_packages, **found}
    return found


def paths_outside_workspace() -> list[str]:
    """Return Python's path without the folders of the workspace's packages."""
    inside = set(_paths(search_roots()))
    # An empty entry is the current folder.
    return [folder for folder in sys.path if os.path.abspath(folder) not in inside]  # noqa: PTH100 - as above


@functools.lru_cache(maxsize=4)
def _paths(roots: Roots) -> list[str]:
    found = (path for folder in package_folders(roots=roots) for path in import_paths(folder))
    return list(dict.fromkeys(found))
