# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `FrontendLaunchDescriptionSource`."""

from zbot.launch.source import FrontendLaunchDescriptionSource

__all__ = [
    "FrontendLaunchDescriptionSource",
]
