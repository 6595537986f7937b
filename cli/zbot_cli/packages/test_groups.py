"""Groups of tests of packages. Each group needs a process of its own, as with `colcon test`."""

from __future__ import annotations

from typing import TYPE_CHECKING

from zbot.package.cmake_file import read_cmake
from zbot.package.workspace import MANIFEST, package_folders

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator
    from pathlib import Path


def groups_below(folder: Path) -> Iterator[list[Path]]:
    """Yield the groups of all packages in a folder, or the folder itself if it has no packages.

    Raises:
        SetupFileError: The CMakeLists.txt of a package is too large.
    """
    packages = sorted(package_folders([folder]))
    for package in packages:
        yield from groups_of(package)
    if not packages:
        yield [folder]


def groups_of(package: Path) -> Iterator[list[Path]]:
    """Yield the groups of a package: each test that its CMakeLists.txt adds, or its test folder.

    Raises:
        SetupFileError: The CMakeLists.txt is too large.
    """
    added = read_cmake(package).tests
    for name in _known(added):
        yield [package / name]
    # A test of a CMake loop, e.g. `ament_add_pytest_test(${name} ${path})`, has no known path.
    if not added or any("${" in name for name in added):
        yield [test_folder(package)]


def test_folder(folder: Path) -> Path:
    """Return the folder `test` of a folder, or the folder itself."""
    return folder / "test" if (folder / "test").is_dir() else folder


def _known(names: Iterable[str]) -> dict[str, None]:
    """Return the names without variables in their order, each name once."""
    return dict.fromkeys(name for name in names if "${" not in name)


def is_package(folder: Path) -> bool:
    """Return whether a folder has a package.xml."""
    return (folder / MANIFEST).is_file()
