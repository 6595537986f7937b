"""ROS 2's `ament_index_python`: where packages are."""

from zbot.package import PackageNotFoundError as PackageNotFoundError
from zbot.package.ament_index import RESOURCE_INDEX_SUBFOLDER as RESOURCE_INDEX_SUBFOLDER
from zbot.package.ament_index import InvalidResourceNameError as InvalidResourceNameError
from zbot.package.ament_index import InvalidResourceTypeNameError as InvalidResourceTypeNameError
from zbot.package.ament_index import get_package_prefix as get_package_prefix
from zbot.package.ament_index import get_package_share_directory as get_package_share_directory
from zbot.package.ament_index import get_package_share_path as get_package_share_path
from zbot.package.ament_index import get_packages_with_prefixes as get_packages_with_prefixes
from zbot.package.ament_index import get_resource as get_resource
from zbot.package.ament_index import get_resource_types as get_resource_types
from zbot.package.ament_index import get_resources as get_resources
from zbot.package.ament_index import get_search_paths as get_search_paths
from zbot.package.ament_index import has_resource as has_resource
