"""ROS 2's resource index under the names of `ament_index_python`.

Packages that nobody installed are in no index: what it would say of them follows from their files.
"""

from __future__ import annotations

import warnings
from typing import TYPE_CHECKING, Literal

from zbot.errors import ZbotError
from zbot.package import package_prefix, package_share
from zbot.package.places import all_packages, find_package, prefixes

if TYPE_CHECKING:
    from pathlib import Path

    from zbot.package.places import Package

#: Below a prefix: a folder for each kind of resource, in it a file for each name.
RESOURCE_INDEX_SUBFOLDER = "share/ament_index/resource_index"
AMENT_PREFIX_PATH_ENV_VAR = "AMENT_PREFIX_PATH"
_PACKAGES = "packages"
_INTERFACES = "rosidl_interfaces"


class InvalidResourceTypeNameError(ZbotError, ValueError):
    """The kind of a resource is no plain name."""

    def __init__(self, resource_type: str) -> None:
        self.resource_type = resource_type
        super().__init__(f"Resource type '{resource_type}' is invalid")


class InvalidResourceNameError(ZbotError, ValueError):
    """The name of a resource is no plain name."""

    def __init__(self, resource_name: str) -> None:
        self.resource_name = resource_name
        super().__init__(f"Resource name '{resource_name}' is invalid")


class ResourceNotFoundError(ZbotError, LookupError):
    """Nothing is registered under that kind and name."""

    def __init__(self, resource_type: str, resource_name: str) -> None:
        self.resource_type, self.resource_name = resource_type, resource_name
        super().__init__(f"Could not find the resource '{resource_name}' of type '{resource_type}'")


def get_package_prefix(package_name: str) -> str:
    """Return the folder that a package is installed to.

    Raises:
        PackageNotFoundError: There is no such package.
        PackageNameError: No package can have this name.
    """
    return str(package_prefix(package_name))


def get_package_share_directory(package_name: str, print_warning: bool = True) -> str:
    """Return the folder with what a package shares: its launch files, configuration and the like.

    Raises:
        PackageNotFoundError: There is no such package.
        PackageNameError: No package can have this name.
    """
    return str(get_package_share_path(package_name, print_warning))


def get_package_share_path(package_name: str, print_warning: bool = True) -> Path:
    """Return what `get_package_share_directory` returns, as a path."""
    share = package_share(package_name)
    if print_warning and not share.exists():
        text = f"Share directory for {package_name} ({share}) does not exist."
        warnings.warn(text, stacklevel=3)
    return share


def get_packages_with_prefixes() -> dict[str, str]:
    """Return the folder that each package is installed to, by its name."""
    return get_resources(_PACKAGES)


def get_search_paths() -> list[str]:
    """Return the folders that packages are installed to, as far as they exist."""
    return [str(prefix) for prefix in prefixes() if prefix.exists()]


def get_resource(resource_type: str, resource_name: str) -> tuple[str, str]:
    """Return what a resource says, and the prefix that it is in.

    Raises:
        ResourceNotFoundError: Nobody registered it.
        InvalidResourceTypeNameError: The kind has a slash.
        InvalidResourceNameError: The name has a slash.
    """
    _check(resource_type, resource_name)
    for prefix in prefixes():
        file = prefix / RESOURCE_INDEX_SUBFOLDER / resource_type / resource_name
        if file.is_file():
            return file.read_text(encoding="utf-8"), str(prefix)
    package = find_package(resource_name)
    text = _text(resource_type, package) if package else None
    if text is None:
        raise ResourceNotFoundError(resource_type, resource_name)
    return text, str(package_prefix(resource_name))


def get_resources(resource_type: str) -> dict[str, str]:
    """Return the prefix of every resource of a kind, by its name.

    Raises:
        InvalidResourceTypeNameError: The kind has a slash.
    """
    _check(resource_type)
    found: dict[str, str] = {}
    for prefix in prefixes():
        for entry in sorted((prefix / RESOURCE_INDEX_SUBFOLDER / resource_type).glob("[!.]*")):
            if entry.is_file():
                found.setdefault(entry.name, str(prefix))
    for name, package in all_packages().items():
        if name not in found and _text(resource_type, package) is not None:
            found[name] = str(package_prefix(name))
    return found


def has_resource(resource_type: str, resource_name: str) -> str | Literal[False]:
    """Return the prefix that a resource is in, or False.

    Raises:
        InvalidResourceTypeNameError: The kind has a slash.
        InvalidResourceNameError: The name has a slash.
    """
    try:
        return get_resource(resource_type, resource_name)[1]
    except ResourceNotFoundError:
        return False


def get_resource_types() -> set[str]:
    """Return every kind of resource that is registered somewhere."""
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
    """What a package would have registered, had it been installed."""
    if resource_type == _PACKAGES:
        return ""
    if resource_type == _INTERFACES:
        return _interfaces(package.folder)
    return None


def _interfaces(folder: Path) -> str | None:
    files = (file for kind in ("action", "msg", "srv") for file in folder.glob(f"{kind}/*.{kind}"))
    names = sorted(file.relative_to(folder).as_posix() for file in files)
    return "\n".join(names) or None
