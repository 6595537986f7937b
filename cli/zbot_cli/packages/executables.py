"""Executables that `zbot run` finds in the workspace, in zbot itself and in installed packages."""

from __future__ import annotations

import importlib.util
import os
import re
import sys
from dataclasses import dataclass, field
from functools import cache, cached_property, partial
from importlib.machinery import PathFinder
from pathlib import Path, PurePosixPath
from typing import TYPE_CHECKING

from zbot.package.bundled_nodes import BUNDLED_NODES
from zbot.package.cmake_file import read_cmake
from zbot.package.errors import SetupFileError
from zbot.package.python_finder import import_paths
from zbot.package.setup_file import data_files, declared_scripts, setup_arguments
from zbot.package.unavailable import unavailable_package
from zbot.package.workspace import package_name, packages_by_name, read_text

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping, Sequence

#: Group of the entry points with which an installed package declares its nodes.
GROUP = "zbot.nodes"
BUNDLED = "zbot_nodes"
#: Environment variable of the processes whose parent has shown the note of other programs.
NOTED_VARIABLE = "ZBOT_COPIES_NOTED"
_PROJECT = "zbot"
_COMMAND = "zbot_cli."
#: Part of each setup.py that installs files into `lib/<package>`, also by `join("lib", ...)`.
_LIB = re.compile(r"""lib/|["']lib["']""")
#: Short names of bundled nodes.
_NICKNAMES = {"turtlesim": "turtlesim_node"}


@dataclass(frozen=True, order=True)
class Executable:
    """Program of a package."""

    package: str
    name: str
    target: str  #: `module:function`, or the path of a file
    folders: tuple[str, ...] = ()  #: folders on Python's path in which the module is found
    folder: str = field(default="", compare=False)  #: folder of its package, if it is known
    #: Folders of other packages with the same name. They are not used.
    hidden: tuple[str, ...] = field(default=(), compare=False)
    #: Target of another program of the package with the same name. It is not used.
    replaced: str = field(default="", compare=False)


def is_file(target: str) -> bool:
    """Return whether a target is the path of a file rather than `module:function`."""
    return target.endswith(".py") or os.sep in target


@dataclass(frozen=True)
class Contents:
    """Programs of a package, or the reason why they are unknown."""

    executables: tuple[Executable, ...] = ()
    fault: str = ""  #: reason why its executables are unknown
    compiled: frozenset[str] = frozenset()  #: its C++ programs, which zbot cannot run


class Package:
    """Package and its executables. It may have no executables.

    The build files of a package in a workspace are read at the first use of its contents. A
    workspace may have hundreds of packages, and a caller usually wants one of them.

    Args:
        name: Its name.
        contents: Its contents, or a function that reads them.
        folder: The folder of its sources, or None for an installed package.
    """

    def __init__(
        self,
        name: str,
        contents: Contents | Callable[[], Contents],
        folder: Path | None = None,
    ) -> None:
        self.name, self.folder = name, folder
        self._given = contents

    @cached_property
    def _contents(self) -> Contents:
        return self._given if isinstance(self._given, Contents) else self._given()

    @property
    def executables(self) -> tuple[Executable, ...]:
        """Its Python programs."""
        return self._contents.executables

    @property
    def fault(self) -> str:
        """The reason why its executables are unknown, or an empty string."""
        return self._contents.fault

    @property
    def compiled(self) -> frozenset[str]:
        """Its C++ programs, which zbot cannot run."""
        return self._contents.compiled

    def has_module(self, name: str) -> bool:
        """Return whether the sources have a module of that name. setup.py need not declare it."""
        return self.folder is not None and (self.folder / self.name / f"{name}.py").is_file()


def all_packages() -> list[Package]:
    """Return all packages with their executables. The packages of the workspace come first."""
    return [*workspace_packages(), *bundled_packages(), *installed_packages()]


def workspace_packages() -> list[Package]:
    """Return the packages of the current folder's workspace and of `$ZBOT_WORKSPACE`."""
    copies = packages_by_name()

    @cache
    def paths() -> tuple[str, ...]:
        folders = (places[0] for places in copies.values())
        return tuple(dict.fromkeys(path for folder in folders for path in import_paths(folder)))

    return [
        Package(name, partial(_contents, name, places, paths), places[0])
        for name, places in copies.items()
    ]


def _contents(
    name: str, places: Sequence[Path], all_paths: Callable[[], tuple[str, ...]]
) -> Contents:
    folder, hidden = places[0], tuple(map(str, places[1:]))
    try:
        programs = _programs(folder)
        compiled = frozenset(read_cmake(folder).compiled)
    except SetupFileError as error:
        return Contents(fault=str(error))
    own = import_paths(folder)
    # As in a ROS 2 workspace that is sourced, every package can import all other packages.
    folders = (*own, *(path for path in all_paths() if path not in own)) if programs else ()
    found: dict[str, Executable] = {}
    for program, target in programs:
        replaced = found[program].target if program in found else ""
        found[program] = Executable(name, program, target, folders, str(folder), hidden, replaced)
    return Contents(tuple(found.values()), "", compiled)


def _programs(folder: Path) -> list[tuple[str, str]]:
    """Return name and target of a package's programs. The last of a name is the one to use.

    The order is that of an installation of ROS 2: the scripts of setup.py, its entry points, its
    data files and the programs of CMakeLists.txt.
    """
    installed = _installed_programs(folder)
    return [
        *((name, str(path)) for name, path in _scripts(folder, installed).items()),
        # The `zbot` command itself is in zbot's own sources.
        *(
            script
            for script in declared_scripts(folder).items()
            if not script[1].startswith(_COMMAND)
        ),
        *((name, str(path)) for name, path in installed.items()),
    ]


def program_files(folder: Path) -> dict[str, Path]:
    """Return the Python programs that setup.py or CMakeLists.txt install, or that are in `scripts`.

    Raises:
        SetupFileError: The package's setup.py cannot be read.
    """
    installed = _installed_programs(folder)
    return {**_scripts(folder, installed), **installed}


def _installed_programs(folder: Path) -> dict[str, Path]:
    programs = read_cmake(folder).programs
    found = {PurePosixPath(target).name: path for target, path in programs.items()}
    found.update(_data_programs(folder))
    return {name: path for name, path in found.items() if is_python(path)}


def _scripts(folder: Path, installed: Mapping[str, Path]) -> dict[str, Path]:
    """Return the files in the folder `scripts` and the `scripts` of setup.py by name.

    A file that is installed under another name is left out.
    """
    known = {path.resolve() for path in installed.values()}
    # Every setup.py contains "console_scripts". To parse them all here would take too long.
    given = setup_arguments(folder / "setup.py", "scripts=").get("scripts")
    names = [name for name in given if isinstance(name, str)] if isinstance(given, list) else []
    # A short setup.py can repeat a name 100,000 times.
    listed = [folder / name for name in dict.fromkeys(names) if _is_present(folder / name)]
    paths = [*sorted((folder / "scripts").glob("*.py")), *listed]
    found = {path.name: path for path in paths if path.resolve() not in known}
    return {name: path for name, path in found.items() if is_python(path)}


def _data_programs(folder: Path) -> dict[str, Path]:
    """Return the files that setup.py installs into `lib/<package>`, ROS 2's folder for programs."""
    if _LIB.search(read_text(folder / "setup.py")) is None:
        return {}
    place = PurePosixPath("lib", package_name(folder))
    entries = dict.fromkeys(data_files(folder))  # each only once, as above
    files = (file for target, file in entries if PurePosixPath(target) == place)
    return {Path(file).name: folder / file for file in files if _is_present(folder / file)}


def _is_present(path: Path) -> bool:
    return os.path.isfile(path)  # noqa: PTH113 - the path may be no valid name


def is_python(path: Path) -> bool:
    """Return whether a file is a Python program, from its ending or its first line."""
    if path.suffix == ".py":
        return True
    try:
        with path.open("rb") as file:
            first = file.readline(200)
    except OSError:  # `zbot run` reports the error
        return False
    return first.startswith(b"#!") and b"python" in first


def program_file(executable: Executable) -> str:
    """Return the file of a program, or its `module:function` if the file is not found."""
    if is_file(executable.target):
        return executable.target
    module = executable.target.partition(":")[0].strip()
    return str(module_file(module, executable.folders) or executable.target)


def note_of_others(executable: Executable) -> str:
    """Return a sentence if other programs have the names of a program, or an empty string.

    The sentence is empty too in processes that a program with such a note has started.
    """
    if os.environ.get(NOTED_VARIABLE):
        return ""
    package, name = executable.package, executable.name
    if executable.replaced:
        return (
            f"package '{package}' has two programs '{name}'; as in ROS 2, {executable.target} "
            f"replaces {executable.replaced}"
        )
    if executable.hidden:
        others = ", ".join(executable.hidden)
        return f"package '{package}' is also in {others}; this is the one in {executable.folder}"
    return ""


def module_file(module: str, folders: tuple[str, ...]) -> Path | None:
    """Find a module in folders or installed packages, and return its file. Import nothing."""
    spec = PathFinder.find_spec(module.partition(".")[0], [*folders, *sys.path])
    origin = spec.origin if spec is not None else None
    for name in module.split(".")[1:]:
        spec = spec and PathFinder.find_spec(name, list(spec.submodule_search_locations or ()))
        origin = spec.origin if spec is not None else None
    return Path(origin) if origin is not None and Path(origin).is_file() else None


def is_bundled(name: str) -> bool:
    """Return whether zbot has a package of this name with nodes."""
    has_nodes = bool(BUNDLED_NODES.get(name)) and unavailable_package(name) is None
    return name in {_PROJECT, BUNDLED} or has_nodes


def bundled_packages() -> list[Package]:
    """Return the packages of the bundled nodes, under zbot's own name and under ROS 2's names."""
    spec = importlib.util.find_spec(BUNDLED)
    folders = (spec and spec.submodule_search_locations) or ()
    modules = sorted(path.stem for folder in folders for path in Path(folder).glob("[a-z]*.py"))
    names = {module: module for module in modules} | _NICKNAMES
    nodes = [Executable(BUNDLED, name, f"{BUNDLED}.{names[name]}:main") for name in sorted(names)]
    names_of_ros2 = (name for name, programs in BUNDLED_NODES.items() if programs)
    replaced = (_replacing(name) for name in names_of_ros2 if unavailable_package(name) is None)
    return [Package(BUNDLED, Contents(tuple(nodes))), *replaced]


def _replacing(package: str) -> Package:
    """Return a ROS 2 package with the bundled nodes that replace its programs."""
    modules = sorted(BUNDLED_NODES[package].items())
    nodes = (Executable(package, name, f"{BUNDLED}.{module}:main") for name, module in modules)
    return Package(package, Contents(tuple(nodes)))


def installed_packages() -> list[Package]:
    """Return the installed packages that declare nodes, except zbot itself."""
    from importlib.metadata import entry_points  # noqa: PLC0415 - 40 ms, not needed by bundled nodes

    found: dict[str, list[Executable]] = {}
    for point in entry_points(group=GROUP):
        distribution = point.dist.name if point.dist is not None else ""
        if distribution not in {"", _PROJECT}:
            name = distribution.replace("-", "_")
            found.setdefault(name, []).append(Executable(name, point.name, point.value))
    return [Package(name, Contents(tuple(nodes))) for name, nodes in sorted(found.items())]


def installed_package(name: str) -> list[Package]:
    """Return a list with the installed package of this name, or an empty list."""
    from importlib.metadata import PackageNotFoundError, distribution  # noqa: PLC0415 - takes 40 ms

    try:
        points = distribution(name).entry_points
    except (PackageNotFoundError, ValueError):
        return []
    found = {
        point.name: Executable(name, point.name, point.value)
        for point in points
        if point.group in {"console_scripts", GROUP} and not point.value.startswith(_COMMAND)
    }
    return [Package(name, Contents(tuple(found.values())))]
