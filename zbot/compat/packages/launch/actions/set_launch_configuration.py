# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `SetLaunchConfiguration`."""

from zbot.launch.actions import SetLaunchConfiguration

__all__ = [
    "SetLaunchConfiguration",
]
