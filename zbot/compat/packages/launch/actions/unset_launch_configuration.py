# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `UnsetLaunchConfiguration`."""

from zbot.launch.actions import UnsetLaunchConfiguration

__all__ = [
    "UnsetLaunchConfiguration",
]
