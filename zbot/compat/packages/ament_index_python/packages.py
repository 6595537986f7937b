# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `PackageNotFoundError` and `get_package_prefix` and `get_package_share_directory` and `get_package_share_path` and `get_packages_with_prefixes`."""

from zbot.package import PackageNotFoundError
from zbot.package.ament_index import (
    get_package_prefix,
    get_package_share_directory,
    get_package_share_path,
    get_packages_with_prefixes,
)

__all__ = [
    "PackageNotFoundError",
    "get_package_prefix",
    "get_package_share_directory",
    "get_package_share_path",
    "get_packages_with_prefixes",
]
