# Written by python -m zbot.compat.generator; do not edit.
"""Files of packages."""

from zbot.compat.package_files import MultipleLaunchFilesError, get_share_file_path_from_package

__all__ = [
    "MultipleLaunchFilesError",
    "get_share_file_path_from_package",
]
