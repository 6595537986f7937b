# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `PushEnvironment`."""

from zbot.launch.actions import PushEnvironment

__all__ = [
    "PushEnvironment",
]
