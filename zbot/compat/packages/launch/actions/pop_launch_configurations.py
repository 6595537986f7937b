# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `PopLaunchConfigurations`."""

from zbot.launch.actions import PopLaunchConfigurations

__all__ = [
    "PopLaunchConfigurations",
]
