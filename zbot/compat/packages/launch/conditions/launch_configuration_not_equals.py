# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `LaunchConfigurationNotEquals`."""

from zbot.launch.condition import LaunchConfigurationNotEquals

__all__ = [
    "LaunchConfigurationNotEquals",
]
