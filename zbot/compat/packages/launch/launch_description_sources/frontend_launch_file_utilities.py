# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `InvalidFrontendLaunchFileError` and `get_launch_description_from_frontend_launch_file`."""

from zbot.launch.errors import InvalidFrontendLaunchFileError
from zbot.launch.source import load_launch_file as get_launch_description_from_frontend_launch_file

__all__ = [
    "InvalidFrontendLaunchFileError",
    "get_launch_description_from_frontend_launch_file",
]
