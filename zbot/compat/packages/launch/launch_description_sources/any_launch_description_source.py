# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `AnyLaunchDescriptionSource`."""

from zbot.launch.source import AnyLaunchDescriptionSource

__all__ = [
    "AnyLaunchDescriptionSource",
]
