"""Prefixes of the packages in the workspace, as a sourced ROS 2 has them in AMENT_PREFIX_PATH."""

from __future__ import annotations

import contextlib
import os
from typing import TYPE_CHECKING

from zbot.package.errors import SetupFileError
from zbot.package.finder import Origin, all_packages
from zbot.package.ros_variables import AMENT_PREFIX_PATH
from zbot.package.symlink_install import prefix_folder

if TYPE_CHECKING:
    from collections.abc import Iterator
    from pathlib import Path


def set_ament_prefix_path(file: Path) -> None:
    """Set AMENT_PREFIX_PATH, if it is not set, to the prefixes of the packages in the workspace.

    Args:
        file: A launch file. The prefix of its package comes first.

    Raises:
        SymlinkInstallError: The links of a prefix cannot be written.
    """
    if AMENT_PREFIX_PATH not in os.environ:
        prefixes = list(_workspace_prefixes(file.resolve()))
        if prefixes:
            os.environ[AMENT_PREFIX_PATH] = os.pathsep.join(map(str, prefixes))


def _workspace_prefixes(file: Path) -> Iterator[Path]:
    found = [one for one in all_packages().values() if one.origin is Origin.WORKSPACE]
    for package in sorted(found, key=lambda one: one.folder.resolve() not in file.parents):
        with contextlib.suppress(SetupFileError):  # only this package cannot be used
            yield prefix_folder(package)
