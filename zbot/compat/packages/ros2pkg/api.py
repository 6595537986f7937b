# Written by python -m zbot.compat.generator; do not edit.
"""Packages."""

from zbot.compat.package_files import get_package_names, get_prefix_path
from zbot.package import PackageNotFoundError as PackageNotFound

__all__ = [
    "PackageNotFound",
    "get_package_names",
    "get_prefix_path",
]
