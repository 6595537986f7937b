"""Resource index of ROS 2: the functions of `ament_index_python`.

A package that is not installed has no entries in an index. zbot makes the entries from the files of
the package.
"""

from __future__ import annotations

import contextlib
import warnings
from typing import TYPE_CHECKING, Literal

from zbot.errors import ZbotError
from zbot.package import package_prefix, package_share
from zbot.package.absent import absent_file, absent_prefix
from zbot.package.errors import SetupFileError
from zbot.package.finder import all_packages, find_package, prefixes
from zbot.package.ros_variables import AMENT_PREFIX_PATH

if TYPE_CHECKING:
    from pathlib import Path

    from zbot.package.finder import Package

#: Folder below a prefix. It has a folder for each resource type, with a file for each resource.
RESOURCE_INDEX_SUBFOLDER = "share/ament_index/resource_index"
AMENT_PREFIX_PATH_ENV_VAR = AMENT_PREFIX_PATH
_PACKAGES = "packages"
_INTERFACES = "rosidl_interfaces"


class InvalidResourceTypeNameError(ZbotError, ValueError):
    """A resource type is empty or contains a slash."""

    def __init__(self, resource_type: str) -> None:
        self.resource_type = resource_type
        super().__init__(f"Resource type '{resource_type}' is invalid")


class InvalidResourceNameError(ZbotError, ValueError):
    """A resource name contains a slash."""

    def __init__(self, resource_name: str) -> None:
        self.resource_name = resource_name
        super().__init__(f"Resource name '{resource_name}' is invalid")


class ResourceNotFoundError(ZbotError, LookupError):
    """No resource of that type and name is registered."""

    def __init__(self, resource_type: str, resource_name: str) -> None:
        self.resource_type, self.resource_name = resource_type, resource_name
        super().__init__(f"Could not find the resource '{resource_name}' of type '{resource_type}'")


def get_package_prefix(package_name: str) -> str:
    """Return the prefix of a package.

    Raises:
        PackageNotFoundError: There is no such package.
        PackageNameError: The name is not valid for a package.
    """
    return str(package_prefix(package_name))


def get_package_share_directory(package_name: str, print_warning: bool = True) -> str:
    """Return the share folder of a package, which has launch files, configuration and so on.

    Raises:
        PackageNotFoundError: There is no such package.
        PackageNameError: The name is not valid for a package.
    """
    return str(get_package_share_path(package_name, print_warning))


def get_package_share_path(package_name: str, print_warning: bool = True) -> Path:
    """Return the result of `get_package_share_directory` as a path."""
    share = package_share(package_name)
    if print_warning and not share.exists() and absent_file(share) is None:
        text = f"Share directory for {package_name} ({share}) does not exist."
        warnings.warn(text, stacklevel=3)
    return share


def get_packages_with_prefixes() -> dict[str, str]:
    """Return the prefix of each package by name."""
    return get_resources(_PACKAGES)


def get_search_paths() -> list[str]:
    """Return the prefixes that exist."""
    return [str(prefix) for prefix in prefixes() if prefix.exists()]


def get_resource(resource_type: str, resource_name: str) -> tuple[str, str]:
    """Return the content of a resource and its prefix.

    During a launch, each well-known package of ROS 2 has a resource, see `zbot.package.absent`.

    Raises:
        ResourceNotFoundError: The resource is not registered.
        InvalidResourceTypeNameError: The type is empty or contains a slash.
        InvalidResourceNameError: The name contains a slash.
    """
    found = _registered(resource_type, resource_name)
    prefix = None if found or resource_type != _PACKAGES else absent_prefix(resource_name)
    if prefix is not None:
        return "", str(prefix)
    if found is None:
        raise ResourceNotFoundError(resource_type, resource_name)
    return found


def _registered(resource_type: str, resource_name: str) -> tuple[str, str] | None:
    _check(resource_type, resource_name)
    for prefix in prefixes():
        file = prefix / RESOURCE_INDEX_SUBFOLDER / resource_type / resource_name
        if file.is_file():
            return file.read_text(encoding="utf-8"), str(prefix)
    package = find_package(resource_name)
    text = _text(resource_type, package) if package else None
    return None if text is None else (text, str(package_prefix(resource_name)))


class _Prefixes(dict[str, str]):
    """Prefixes by resource. During a launch, `[]` also finds packages that are not here."""

    def __missing__(self, name: str) -> str:
        prefix = absent_prefix(name)
        if prefix is None:
            raise KeyError(name)
        return str(prefix)


def get_resources(resource_type: str) -> dict[str, str]:
    """Return the prefix of every resource of a type, by the name of the resource.

    Raises:
        InvalidResourceTypeNameError: The type is empty or contains a slash.
    """
    from zbot.package.symlink_install import prefix_folder  # noqa: PLC0415 - slow to import

    _check(resource_type)
    found = _Prefixes() if resource_type == _PACKAGES else {}
    for prefix in prefixes():
        for entry in sorted((prefix / RESOURCE_INDEX_SUBFOLDER / resource_type).glob("[!.]*")):
            if entry.is_file():
                found.setdefault(entry.name, str(prefix))
    for name, package in all_packages().items():
        if name not in found and _text(resource_type, package) is not None:
            with contextlib.suppress(SetupFileError):  # only this package cannot be used
                found[name] = str(prefix_folder(package))
    return found


def has_resource(resource_type: str, resource_name: str) -> str | Literal[False]:
    """Return the prefix of a resource, or False if the resource is not registered.

    Raises:
        InvalidResourceTypeNameError: The type is empty or contains a slash.
        InvalidResourceNameError: The name contains a slash.
    """
    found = _registered(resource_type, resource_name)
    return found[1] if found else False


def get_resource_types() -> set[str]:
    """Return every resource type that has entries in a prefix or entries that zbot makes."""
    folders = (
        entry
        for prefix in prefixes()
        for entry in (prefix / RESOURCE_INDEX_SUBFOLDER).glob("[!.]*")
    )
    kinds = {entry.name for entry in folders if entry.is_dir()}
    return kinds | {kind for kind in (_PACKAGES, _INTERFACES) if _is_registered(kind)}


def _is_registered(kind: str) -> bool:
    return any(_text(kind, package) is not None for package in all_packages().values())


def _check(resource_type: str, resource_name: str = "") -> None:
    if not resource_type or not {"/", "\\"}.isdisjoint(resource_type):
        raise InvalidResourceTypeNameError(resource_type)
    if not {"/", "\\"}.isdisjoint(resource_name):
        raise InvalidResourceNameError(resource_name)


def _text(resource_type: str, package: Package) -> str | None:
    """Return the text of the entry that zbot makes for a package. `None` means no entry."""
    if resource_type == _PACKAGES:
        return ""
    if resource_type == _INTERFACES:
        return _interfaces(package.folder)
    return None


def _interfaces(folder: Path) -> str | None:
    files = (file for kind in ("action", "msg", "srv") for file in folder.glob(f"{kind}/*.{kind}"))
    names = sorted(file.relative_to(folder).as_posix() for file in files)
    return "\n".join(names) or None
