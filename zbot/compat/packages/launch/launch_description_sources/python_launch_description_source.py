# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `PythonLaunchDescriptionSource`."""

from zbot.launch.source import PythonLaunchDescriptionSource

__all__ = [
    "PythonLaunchDescriptionSource",
]
