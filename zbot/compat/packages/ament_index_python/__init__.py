# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's `ament_index_python`: functions that find packages."""

from typing import TYPE_CHECKING

from zbot.lazy_imports import lazy_names
from zbot.package import PackageNotFoundError
from zbot.package.ament_index import (
    InvalidResourceNameError,
    InvalidResourceTypeNameError,
    RESOURCE_INDEX_SUBFOLDER,
    get_package_prefix,
    get_package_share_directory,
    get_package_share_path,
    get_packages_with_prefixes,
    get_resource,
    get_resource_types,
    get_resources,
    get_search_paths,
    has_resource,
)

__all__ = [
    "InvalidResourceNameError",
    "InvalidResourceTypeNameError",
    "PackageNotFoundError",
    "RESOURCE_INDEX_SUBFOLDER",
    "get_package_prefix",
    "get_package_share_directory",
    "get_package_share_path",
    "get_packages_with_prefixes",
    "get_resource",
    "get_resource_types",
    "get_resources",
    "get_search_paths",
    "has_resource",
]

if TYPE_CHECKING:
    from . import constants as constants
    from . import packages as packages
    from . import resources as resources
    from . import search_paths as search_paths
else:
    __getattr__ = lazy_names(
        __name__,
        {
        },
        submodules=(
            "constants",
            "packages",
            "resources",
            "search_paths",
        ),
    )[0]
