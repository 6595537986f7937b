"""Functions that take a package's name and find the prefix and share folder of the package.

A package of the workspace does not have to be built. It is used from its source folder.

During a launch, a well-known package that does not run in zbot has these folders too, but they do
not exist. See `zbot.package.absent`.
"""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from zbot.package.errors import PackageNameError, PackageNotFoundError

if TYPE_CHECKING:
    from pathlib import Path

    from zbot.package.finder import Package

__all__ = [
    "PackageNameError",
    "PackageNotFoundError",
    "package_prefix",
    "package_share",
    "packages",
]

# A package's name as in REP 127, with the exceptions that ROS 2 makes.
_NAME = re.compile(r"[a-zA-Z0-9][a-zA-Z0-9_-]+\Z", re.ASCII)


def package_share(name: str) -> Path:
    """Return the share folder of a package, which has `launch`, `config`, `urdf` and so on.

    Raises:
        PackageNotFoundError: There is no such package.
        PackageNameError: The name is not valid for a package.
    """
    from zbot.package.symlink_install import share_folder  # noqa: PLC0415 - slow to import

    return share_folder(_find(name))


def package_prefix(name: str) -> Path:
    """Return the prefix of a package, the folder that has `share/<name>` and `lib/<name>`.

    Raises:
        PackageNotFoundError: There is no such package.
        PackageNameError: The name is not valid for a package.
    """
    from zbot.package.symlink_install import prefix_folder  # noqa: PLC0415 - slow to import

    return prefix_folder(_find(name))


def packages() -> dict[str, Package]:
    """Return every package that can be found, sorted by name."""
    from zbot.package.finder import all_packages  # noqa: PLC0415 - slow to import

    return all_packages()


def _find(name: str) -> Package:
    from zbot.package.absent import absent_prefix  # noqa: PLC0415 - slow to import
    from zbot.package.finder import (  # noqa: PLC0415 - slow to import
        Origin,
        Package,
        all_packages,
        find_package,
        searched_folders,
    )

    if not _NAME.match(name):
        raise PackageNameError(name)
    package = find_package(name)
    if package is not None and package.origin is not Origin.BUNDLED:
        return package
    # zbot has the messages of some well-known packages that do not run here.
    prefix = absent_prefix(name)
    if package is not None and prefix is None:
        return package
    if prefix is None:
        raise PackageNotFoundError(name, searched_folders(), all_packages())
    return Package(name, prefix / "share" / name, Origin.INSTALLED, prefix)
