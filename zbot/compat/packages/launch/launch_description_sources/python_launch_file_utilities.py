# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `InvalidPythonLaunchFileError` and `load_python_launch_file_as_module` and `get_launch_description_from_python_launch_file`."""

from zbot.launch.errors import LaunchFileError as InvalidPythonLaunchFileError
from zbot.launch.python_file import load_module as load_python_launch_file_as_module
from zbot.launch.source import (
    load_python_launch_file as get_launch_description_from_python_launch_file,
)

__all__ = [
    "InvalidPythonLaunchFileError",
    "get_launch_description_from_python_launch_file",
    "load_python_launch_file_as_module",
]
