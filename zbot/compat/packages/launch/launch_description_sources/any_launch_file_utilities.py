# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `InvalidLaunchFileError` and `get_launch_description_from_any_launch_file` and `get_launch_description_from_frontend_launch_file` and `get_launch_description_from_python_launch_file`."""

from zbot.launch.errors import InvalidLaunchFileError
from zbot.launch.source import (
    load_launch_file as get_launch_description_from_any_launch_file,
    load_launch_file as get_launch_description_from_frontend_launch_file,
    load_python_launch_file as get_launch_description_from_python_launch_file,
)

__all__ = [
    "InvalidLaunchFileError",
    "get_launch_description_from_any_launch_file",
    "get_launch_description_from_frontend_launch_file",
    "get_launch_description_from_python_launch_file",
]
