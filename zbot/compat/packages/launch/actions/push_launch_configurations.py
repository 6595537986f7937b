# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `PushLaunchConfigurations`."""

from zbot.launch.actions import PushLaunchConfigurations

__all__ = [
    "PushLaunchConfigurations",
]
