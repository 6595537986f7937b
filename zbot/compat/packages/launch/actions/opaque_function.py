# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `OpaqueFunction`."""

from zbot.launch.actions import OpaqueFunction

__all__ = [
    "OpaqueFunction",
]
