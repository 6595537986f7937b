"""ROS 2's `ament_index_python`: functions that find packages."""

from zbot.package import PackageNotFoundError
from zbot.package.ament_index import (
    RESOURCE_INDEX_SUBFOLDER,
    InvalidResourceNameError,
    InvalidResourceTypeNameError,
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
