"""Where packages are."""

from zbot.package import PackageNotFoundError as PackageNotFoundError
from zbot.package.ament_index import get_package_prefix as get_package_prefix
from zbot.package.ament_index import get_package_share_directory as get_package_share_directory
from zbot.package.ament_index import get_package_share_path as get_package_share_path
from zbot.package.ament_index import get_packages_with_prefixes as get_packages_with_prefixes
