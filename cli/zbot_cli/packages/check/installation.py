"""Check that a build file installs all launch files and contains no names of missing files."""

from __future__ import annotations

import os
from pathlib import Path
from typing import TYPE_CHECKING

from zbot.errors.suggestion import did_you_mean, nearest, question
from zbot.package.cmake_file import read_cmake
from zbot.package.errors import SetupFileError
from zbot.package.finder import COMPAT_PACKAGES, Origin, Package
from zbot.package.python_finder import import_paths
from zbot.package.setup_file import setup_arguments
from zbot.package.symlink_install import files_below, installed_files
from zbot.package.workspace import MANIFEST
from zbot_cli.packages.check.checked_package import Problem, line_of

if TYPE_CHECKING:
    from collections.abc import Iterator

    from zbot_cli.packages.check.checked_package import CheckedPackage

_LAUNCH_ENDINGS = {".py", ".xml", ".yaml", ".yml", ".launch"}
_BUILD_FILES = {
    "ament_python": "setup.py",
    "ament_cmake": "CMakeLists.txt",
    "cmake": "CMakeLists.txt",
}


def check_installation(checked: CheckedPackage) -> Iterator[Problem]:
    """Yield a problem for each file that a build would not find or would not install."""
    file = _BUILD_FILES.get(checked.build_type)
    if checked.build_type and (guess := nearest(checked.build_type, _BUILD_FILES)):
        text = f"there is no build type '{checked.build_type}'{question([guess], '; ')}"
        path = checked.folder / MANIFEST
        yield Problem(path, line_of(path, "build_type"), text)
    if file and not (checked.folder / file).is_file():
        text = f"the build type is {checked.build_type}, but there is no {file}"
        yield Problem(
            checked.folder / MANIFEST, line_of(checked.folder / MANIFEST, "build_type"), text
        )
        return
    setup, cmake = checked.folder / "setup.py", checked.folder / "CMakeLists.txt"
    try:
        yield from _check_setup(checked, setup)
        yield from _check_uninstalled(checked)
        installation = read_cmake(checked.folder)
    except SetupFileError as error:
        yield Problem(error.path, error.line, error.reason)
        return
    yield from _check_names_of_zbot(checked)
    for name, line in installation.missing.items():
        yield Problem(cmake, line, f"install() names {name}, which does not exist")
    for name, line in installation.compiled.items():
        text = f"{name} is not compiled: C++ needs ROS 2, zbot runs Python programs"
        yield Problem(cmake, line, text, is_error=False)


def _check_names_of_zbot(checked: CheckedPackage) -> Iterator[Problem]:
    for place in map(Path, import_paths(checked.folder)):
        for file in sorted(place.glob("*/__init__.py")):
            if (COMPAT_PACKAGES / file.parent.name).is_dir():
                text = f"programs import zbot's own {file.parent.name} and not this one"
                yield Problem(file, 0, text, is_error=False)


def _check_setup(checked: CheckedPackage, path: Path) -> Iterator[Problem]:
    arguments = setup_arguments(path)
    for text, name in _missing(checked, arguments):
        yield Problem(path, line_of(path, name) or line_of(path, Path(name).name), text)
    named = arguments.get("name")
    if isinstance(named, str) and checked.manifest and named != checked.name:
        text = f"the package is '{named}' here, but '{checked.name}' in {MANIFEST}"
        yield Problem(path, line_of(path, named), text)


def _module(checked: CheckedPackage, name: str) -> Path:
    return checked.folder / Path(*name.split("."))


def _missing(checked: CheckedPackage, arguments: dict[str, object]) -> Iterator[tuple[str, str]]:
    folders = arguments.get("packages")
    places = arguments.get("package_dir")
    for name in folders if isinstance(folders, list) and not places else ():
        if isinstance(name, str) and not os.path.isdir(_module(checked, name)):  # noqa: PTH112 - any text
            hint = _comma(checked, name.replace(".", "/")) or did_you_mean(
                name, _folders(checked), before="; "
            )
            yield f"`packages` names {name}, but there is no such folder{hint}", name
    listed = arguments.get("data_files")
    for entry in listed if isinstance(listed, list) else ():
        files = entry[1] if isinstance(entry, tuple) and len(entry) == 2 else None
        for name in files if isinstance(files, (list, tuple)) else ():
            if isinstance(name, str) and not os.path.isfile(checked.folder / name):  # noqa: PTH113 - as above
                yield f"data_files names {name}, which does not exist{_comma(checked, name)}", name


def _folders(checked: CheckedPackage) -> list[str]:
    return [path.parent.name for path in sorted(checked.folder.glob("*/*.py"))]


def _comma(checked: CheckedPackage, name: str) -> str:
    """Return a hint if a name consists of the names of two files: Python joins two strings."""
    for index in range(1, len(name)):
        parts = (name[:index], name[index:])
        if all(os.path.exists(checked.folder / part) for part in parts):  # noqa: PTH110 - any text
            return f"; a comma is missing between '{parts[0]}' and '{parts[1]}'"
    return ""


def _check_uninstalled(checked: CheckedPackage) -> Iterator[Problem]:
    if checked.build_type not in _BUILD_FILES:
        return
    installed = installed_files(Package(checked.name, checked.folder, Origin.WORKSPACE)).values()
    known = {path.resolve() for path in installed}
    file = _BUILD_FILES[checked.build_type]
    for path in sorted(files_below(checked.folder / "launch")):
        if path.resolve() not in known and path.suffix in _LAUNCH_ENDINGS:
            text = f"{file} does not install it: `ros2 launch` would not find it"
            yield Problem(path, 0, text, is_error=False)
    for folder in ("config", "params", "urdf", "rviz", "worlds", "maps", "meshes"):
        for path in sorted(files_below(checked.folder / folder)):
            if path.resolve() not in known:
                text = f"{file} does not install it: programs would not find it in ROS 2"
                yield Problem(path, 0, text, is_error=False)
