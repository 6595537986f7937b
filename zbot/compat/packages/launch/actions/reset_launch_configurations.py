# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `ResetLaunchConfigurations`."""

from zbot.launch.actions import ResetLaunchConfigurations

__all__ = [
    "ResetLaunchConfigurations",
]
