"""Packages by their names: where they are, and the folder with what they share.

Nothing has to be built: a package of the workspace is used as it lies in its source folder.
"""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from zbot.package.errors import PackageNameError, PackageNotFoundError

if TYPE_CHECKING:
    from pathlib import Path

    from zbot.package.places import Package

__all__ = [
    "PackageNameError",
    "PackageNotFoundError",
    "package_prefix",
    "package_share",
    "packages",
]

# REP 127, with the exemptions that ROS 2 makes.
_NAME = re.compile(r"[a-zA-Z0-9][a-zA-Z0-9_-]+\Z", re.ASCII)


def package_share(name: str) -> Path:
    """Return the folder with what a package shares: `launch`, `config`, `urdf` and the like.

    Raises:
        PackageNotFoundError: There is no such package.
        PackageNameError: No package can have this name.
    """
    from zbot.package.view import share_folder  # noqa: PLC0415 - `import zbot` does without

    return share_folder(_find(name))


def package_prefix(name: str) -> Path:
    """Return the folder that a package is installed to, with its `share/<name>` and `lib/<name>`.

    Raises:
        PackageNotFoundError: There is no such package.
        PackageNameError: No package can have this name.
    """
    from zbot.package.view import prefix_folder  # noqa: PLC0415 - as above

    return prefix_folder(_find(name))


def packages() -> dict[str, Package]:
    """Return every package that can be found, by name, sorted."""
    from zbot.package.places import all_packages  # noqa: PLC0415 - as above

    return all_packages()


def _find(name: str) -> Package:
    from zbot.package.places import (  # noqa: PLC0415 - as above
        all_packages,
        find_package,
        searched_places,
    )

    if not _NAME.match(name):
        raise PackageNameError(name)
    package = find_package(name)
    if package is None:
        raise PackageNotFoundError(name, searched_places(), all_packages())
    return package
