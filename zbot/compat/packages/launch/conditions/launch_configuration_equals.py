# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `LaunchConfigurationEquals`."""

from zbot.launch.condition import LaunchConfigurationEquals

__all__ = [
    "LaunchConfigurationEquals",
]
