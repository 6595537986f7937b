"""Search for packages that a workspace uses, but that this machine does not have."""

from __future__ import annotations

import importlib.util
import sys
from dataclasses import dataclass
from importlib.machinery import PathFinder
from typing import TYPE_CHECKING

from zbot.interfaces.errors import InterfaceSyntaxError, UnknownPackageError
from zbot.interfaces.location import package_folder
from zbot.interfaces.missing_import import how_to_add, repository_of
from zbot.interfaces.parser import parse
from zbot.interfaces.registry import interface_names
from zbot.interfaces.spec import MessageSpec, parts_of
from zbot.names import KINDS
from zbot.package.finder import all_packages
from zbot.package.manifest import RUNTIME_TAGS, Manifest, ManifestError, read_manifest
from zbot.package.python_finder import import_paths
from zbot.package.unavailable import unavailable_package
from zbot.package.workspace import MANIFEST, package_name
from zbot_cli.packages.check.checked_package import CheckedPackage, imports, line_of
from zbot_cli.packages.executables import bundled_packages
from zbot_cli.packages.python_sources import how_to_get, module_of_key

if TYPE_CHECKING:
    from collections.abc import Container, Iterator, Mapping, Sequence
    from pathlib import Path

    from zbot.interfaces.spec import InterfaceSpec

MESSAGES = "message"
PYTHON = "python"
OTHER = "other"
#: Ends of the names of message packages.
_ENDINGS = ("_msgs", "_srvs", "_actions", "_interfaces")
#: Beginnings of the names of packages that only a build with ROS 2 needs.
_BUILD_TOOLS = ("ament_", "rosidl_", "rmw_", "rcl", "ros_core", "ros_base", "ros2launch")
_GENERATED = "the package is here, but only a build with ROS 2 writes its Python modules"


@dataclass(frozen=True, order=True)
class MissingDependency:
    """Package or type that is used, but that this machine does not have."""

    kind: str  #: `message`, `python`, or `other` for another package that package.xml contains
    name: str
    path: Path  #: the first file that uses it
    line: int  #: counted from 1, or 0 if it is not known
    get: str  #: how the user gets it, or what does the same in zbot; empty if it is not known


def missing_dependencies(
    folders: Sequence[Path], workspace: Mapping[str, Path]
) -> list[MissingDependency]:
    """Return the packages and types that some packages use, but that this machine does not have.

    Each name is returned only once.

    Args:
        folders: The folders of the packages.
        workspace: The folders of all packages of the workspace, by name.
    """
    places = tuple(path for folder in workspace.values() for path in import_paths(folder))
    found: dict[tuple[str, str], MissingDependency] = {}
    here = {*all_packages(), *(package.name for package in bundled_packages())}
    for folder in folders:
        for dependency in (
            *_imports(folder, places, workspace),
            *_definitions(folder),
            *_depends(folder, here),
        ):
            found.setdefault((dependency.kind, dependency.name), dependency)
    known = {name for kind, name in found if kind != OTHER}
    return sorted(
        dependency
        for dependency in found.values()
        if dependency.kind != OTHER or dependency.name not in known
    )


def _imports(
    folder: Path, places: Sequence[str], names: Container[str]
) -> Iterator[MissingDependency]:
    checked = CheckedPackage(package_name(folder), folder, None)
    checked.read_sources()
    # A program may add a folder of its package to Python's path. Then it imports the modules and
    # folders in that folder by their short names.
    own = {path.stem for path in checked.modules} | {path.parent.name for path in checked.modules}
    for path, tree in checked.modules.items():
        if path.name == "setup.py":  # only a build runs it
            continue
        beside = [str(path.parent), *places]
        for name, wanted, line in imports(tree):
            top, _, inside = name.partition(".")
            kind = inside.partition(".")[0]
            is_interface = kind in KINDS or top.endswith(_ENDINGS)
            if is_interface and package_folder(top) is not None:
                yield from _types(top, kind, wanted, path, line)
            elif top in own or top in sys.stdlib_module_names or top.startswith(_BUILD_TOOLS):
                continue
            elif not _is_module(top, beside):
                how = how_to_add(top) if is_interface else how_to_get(top)
                how = _GENERATED if top in names else how
                yield MissingDependency(MESSAGES if is_interface else PYTHON, top, path, line, how)


def _types(
    package: str, kind: str, wanted: Sequence[str], path: Path, line: int
) -> Iterator[MissingDependency]:
    """Yield the types that a known package lacks. Another version of the package may have them."""
    try:
        known = interface_names(package)
    except UnknownPackageError:
        return
    for type_name in wanted if kind in KINDS else ():
        name = f"{package}/{kind}/{type_name}"
        if (
            type_name[:1].isupper()
            and f"{package}/{kind}/{type_name.partition('_')[0]}" not in known
        ):
            how = f"the version of {package} that is here does not have it"
            if repository_of(package):
                how += f": {how_to_add(package)}"
            yield MissingDependency(MESSAGES, name, path, line, how)


def _is_module(name: str, places: Sequence[str]) -> bool:
    found = PathFinder.find_spec(name, [*places])
    if found is not None and found.origin is not None:
        return True
    try:
        return importlib.util.find_spec(name) is not None
    except (ImportError, ValueError):
        return False


def _definitions(folder: Path) -> Iterator[MissingDependency]:
    for kind in KINDS:
        for path in sorted((folder / kind).glob(f"*.{kind}")):
            try:
                text = path.read_text(encoding="utf-8", errors="replace")
                spec = parse(f"{package_name(folder)}/{kind}/{path.stem}", text, str(path))
            except (InterfaceSyntaxError, OSError):
                continue  # `zbot build` reports it
            for package, line in _used_packages(spec):
                if package != package_name(folder) and package_folder(package) is None:
                    yield MissingDependency(MESSAGES, package, path, line, how_to_add(package))


def _used_packages(spec: InterfaceSpec) -> Iterator[tuple[str, int]]:
    if isinstance(spec, MessageSpec):
        for field in spec.fields:
            if field.type.is_message:
                yield field.type.base.split("/")[0], field.line
    for part in parts_of(spec):
        yield from _used_packages(part)


def _depends(folder: Path, here: set[str]) -> Iterator[MissingDependency]:
    path = folder / MANIFEST
    try:
        manifest = read_manifest(path)
    except ManifestError:
        return  # `zbot build` reports it
    for name in sorted(_wanted(manifest) - here):
        line = line_of(path, f">{name}<")
        module = module_of_key(name)
        # Drivers of ros2_control have names such as `arm_hardware_interfaces`.
        if name.endswith(_ENDINGS) and "hardware" not in name:
            if package_folder(name) is None:
                yield MissingDependency(MESSAGES, name, path, line, how_to_add(name))
        elif module:
            if not _is_module(module, ()):
                yield MissingDependency(PYTHON, module, path, line, how_to_get(module))
        elif not _is_module(name, ()) and not name.startswith("python3-"):
            kind = unavailable_package(name)
            yield MissingDependency(
                OTHER, name, path, line, f"{kind.what}; {kind.instead}" if kind else ""
            )


def _wanted(manifest: Manifest) -> set[str]:
    return {name for name in manifest.named(*RUNTIME_TAGS) if not name.startswith(_BUILD_TOOLS)}
