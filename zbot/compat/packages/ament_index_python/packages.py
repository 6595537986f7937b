"""Functions that find packages."""

from zbot.package import PackageNotFoundError
from zbot.package.ament_index import (
    get_package_prefix,
    get_package_share_directory,
    get_package_share_path,
    get_packages_with_prefixes,
)
